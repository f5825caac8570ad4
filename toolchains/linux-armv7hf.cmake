# SPDX-License-Identifier: MIT
# 32-bit Arm with a floating-point unit of 16 double registers and without NEON: close to 3DS and Vita.
set(INGOT_PROCESSOR arm)
set(INGOT_CORE_FLAGS -mfpu=vfpv3-d16)
set(INGOT_TRIPLET arm-linux-gnueabihf)
set(INGOT_QEMU_USER qemu-arm)

include("${CMAKE_CURRENT_LIST_DIR}/linux-cross.cmake")
