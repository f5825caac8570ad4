# SPDX-License-Identifier: MIT
# Cortex-M0: no floating-point unit, no hardware division. Emulated by QEMU's BBC micro:bit.
set(INGOT_CORE_FLAGS -mcpu=cortex-m0 -mfloat-abi=soft)

# QEMU gives its nRF51822 16 KiB of RAM. The variant with 32 KiB (xxAC) differs in nothing else.
set(INGOT_QEMU_MACHINE microbit -global nrf51-soc.sram-size=32768)
set(INGOT_BOARD microbit CACHE STRING "Folder of platform/boards")

include("${CMAKE_CURRENT_LIST_DIR}/arm-cortex-m.cmake")
