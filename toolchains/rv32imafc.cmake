# SPDX-License-Identifier: MIT
# 32-bit RISC-V with single-precision unit. Doubles are computed by libgcc. Emulated by QEMU's machine virt.
set(INGOT_CORE_FLAGS -march=rv32imafc -mabi=ilp32f)

include("${CMAKE_CURRENT_LIST_DIR}/riscv32.cmake")
