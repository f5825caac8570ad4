#!/bin/sh
# SPDX-License-Identifier: MIT
# devkitPro and its like: their CMake wrappers bring a toolchain file, and ingot is a plain target. In your project, beside a folder ingot:
#
#     add_subdirectory(ingot)
#     target_link_libraries(game PRIVATE ingot::kernel)
set -e
case "$1" in
  3ds) cmake=arm-none-eabi-cmake ;;                         # ARM11 with VFPv2
  switch) cmake=aarch64-none-elf-cmake ;;
  gamecube | wii | wiiu) cmake=powerpc-eabi-cmake ;;        # big-endian; multiply-add is fused unless the contract is kept, which comes with the target
  psp) cmake=psp-cmake ;;                                   # PSPSDK: MIPS, little-endian, with a unit for floats
  vita) cmake="cmake -DCMAKE_TOOLCHAIN_FILE=$VITASDK/share/vita.toolchain.cmake" ;;
  dreamcast) cmake="cmake -DCMAKE_TOOLCHAIN_FILE=$KOS_BASE/utils/cmake/kallistios.toolchain.cmake" ;;  # KallistiOS: not -m4-single-only
  *) echo "usage: $0 3ds|switch|gamecube|wii|wiiu|psp|vita|dreamcast" >&2; exit 2 ;;
esac
$cmake -B "build/$1" -DCMAKE_BUILD_TYPE=Release -DINGOT_PLATFORM=host -DINGOT_LANES=1
cmake --build "build/$1"
