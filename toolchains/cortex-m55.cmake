# SPDX-License-Identifier: MIT
# Cortex-M55 with double-precision unit, and with vectors of integers only: its vectors of floats flush denormals, and GCC uses
# them unasked. Emulated by QEMU's Arm MPS3 with the AN547 image.
set(INGOT_CORE_FLAGS -mcpu=cortex-m55+nomve.fp -mfloat-abi=hard)
set(INGOT_QEMU_MACHINE mps3-an547)
set(INGOT_BOARD mps3_an547 CACHE STRING "Folder of platform/boards")

include("${CMAKE_CURRENT_LIST_DIR}/arm-cortex-m.cmake")
