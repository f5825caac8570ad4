# SPDX-License-Identifier: MIT
# Cortex-M7 with double-precision unit. Emulated by QEMU's Arm MPS2 with the AN500 image.
set(INGOT_CORE_FLAGS -mcpu=cortex-m7 -mfloat-abi=hard -mfpu=fpv5-d16)
set(INGOT_QEMU_MACHINE mps2-an500)
set(INGOT_BOARD mps2_an500 CACHE STRING "Folder of platform/boards")

include("${CMAKE_CURRENT_LIST_DIR}/arm-cortex-m.cmake")
