# SPDX-License-Identifier: MIT
# Cortex-M33 with single-precision unit. Emulated by QEMU's Arm MPS2 with the AN505 image.
set(INGOT_CORE_FLAGS -mcpu=cortex-m33 -mfloat-abi=hard -mfpu=fpv5-sp-d16)
set(INGOT_QEMU_MACHINE mps2-an505)
set(INGOT_BOARD mps2_an505 CACHE STRING "Folder of platform/boards")

include("${CMAKE_CURRENT_LIST_DIR}/arm-cortex-m.cmake")
