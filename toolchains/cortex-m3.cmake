# SPDX-License-Identifier: MIT
# Cortex-M3: no floating-point unit. Emulated by QEMU's Arm MPS2 with the AN385 image, whose memory is that of AN386.
set(INGOT_CORE_FLAGS -mcpu=cortex-m3 -mfloat-abi=soft)
set(INGOT_QEMU_MACHINE mps2-an385)
set(INGOT_BOARD mps2_an386 CACHE STRING "Folder of platform/boards")

include("${CMAKE_CURRENT_LIST_DIR}/arm-cortex-m.cmake")
