# SPDX-License-Identifier: MIT
# Cortex-M4 with single-precision unit. Emulated by QEMU's Arm MPS2 with the AN386 image.
set(INGOT_CORE_FLAGS -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16)
set(INGOT_QEMU_MACHINE mps2-an386)
set(INGOT_BOARD mps2_an386 CACHE STRING "Folder of platform/boards")

include("${CMAKE_CURRENT_LIST_DIR}/arm-cortex-m.cmake")
