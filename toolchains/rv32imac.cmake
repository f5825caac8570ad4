# SPDX-License-Identifier: MIT
# 32-bit RISC-V without floating-point unit, as in many ESP32-C and GD32V parts. Emulated by QEMU's machine virt.
set(INGOT_CORE_FLAGS -march=rv32imac -mabi=ilp32)

include("${CMAKE_CURRENT_LIST_DIR}/riscv32.cmake")
