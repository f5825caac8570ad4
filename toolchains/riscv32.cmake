# SPDX-License-Identifier: MIT
# The part that both RISC-V toolchain files share: GNU compiler, picolibc, QEMU as the emulator of ctest.
#
# Included by a file that has set
#   INGOT_CORE_FLAGS     what selects the core and its floating-point unit
#
# Overridable: -DINGOT_RISCV_PREFIX=/opt/riscv/bin/riscv32-unknown-elf-   -DINGOT_QEMU=/opt/qemu/bin/qemu-system-riscv32
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv32)

set(INGOT_RISCV_PREFIX "riscv64-unknown-elf-" CACHE STRING "Prefix of the RISC-V bare-metal tools, with path if not in PATH")
set(INGOT_QEMU "qemu-system-riscv32" CACHE STRING "Emulator that runs firmware under ctest")
set(INGOT_BOARD riscv_virt CACHE STRING "Folder of platform/boards")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES INGOT_RISCV_PREFIX INGOT_QEMU INGOT_BOARD)

# The gcc driver, because the distribution ships no C++ library for RISC-V, and ingot needs none.
set(CMAKE_C_COMPILER "${INGOT_RISCV_PREFIX}gcc")
set(CMAKE_CXX_COMPILER "${INGOT_RISCV_PREFIX}gcc")
set(CMAKE_ASM_COMPILER "${INGOT_RISCV_PREFIX}gcc")

# A test program cannot link before there is a linker script, so compiler checks stop at a library.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# Only what selects the core and its C library. How code is compiled is said by the targets (see flags.cmake).
string(JOIN " " _ingot_core_flags ${INGOT_CORE_FLAGS} -mcmodel=medany --specs=picolibc.specs)
set(CMAKE_C_FLAGS_INIT "${_ingot_core_flags}")
set(CMAKE_CXX_FLAGS_INIT "${_ingot_core_flags}")
set(CMAKE_ASM_FLAGS_INIT "${_ingot_core_flags}")
set(CMAKE_EXECUTABLE_SUFFIX_C .elf)
set(CMAKE_EXECUTABLE_SUFFIX_CXX .elf)

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# ctest appends the ELF file to this list. -icount makes every instruction one nanosecond of virtual time (see
# platform/clock_minstret.cpp). The exit status is the firmware's, by semihosting.
set(CMAKE_CROSSCOMPILING_EMULATOR
  ${INGOT_QEMU} -machine virt -bios none
  -nographic -monitor none -serial none
  -semihosting-config enable=on,target=native
  -icount shift=0,sleep=off
  -kernel)
