# SPDX-License-Identifier: MIT
# The part that all Cortex-M toolchain files share: GNU Arm Embedded compiler, newlib, QEMU as the emulator of ctest.
#
# Included by a file that has set
#   INGOT_CORE_FLAGS     what selects the core and its floating-point unit
#   INGOT_QEMU_MACHINE   the machine of qemu-system-arm, with further options of it if needed (a list)
#   INGOT_BOARD          the folder of platform/boards with start-up data and linker script for that machine
#
# Overridable: -DINGOT_ARM_PREFIX=/opt/gcc-arm/bin/arm-none-eabi-   -DINGOT_QEMU=/opt/qemu/bin/qemu-system-arm
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)

set(INGOT_ARM_PREFIX "arm-none-eabi-" CACHE STRING "Prefix of the Arm bare-metal tools, with path if not in PATH")
set(INGOT_QEMU "qemu-system-arm" CACHE STRING "Emulator that runs firmware under ctest")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES INGOT_ARM_PREFIX INGOT_QEMU INGOT_BOARD)

# C++ is compiled and linked by the gcc driver: it takes .cpp for C++ all the same, and does not ask for libstdc++.a, which
# ingot does not need and which some distributions ship apart (300 MB). A program that wants it links stdc++ by name.
set(CMAKE_C_COMPILER "${INGOT_ARM_PREFIX}gcc")
set(CMAKE_CXX_COMPILER "${INGOT_ARM_PREFIX}gcc")
set(CMAKE_ASM_COMPILER "${INGOT_ARM_PREFIX}gcc")

# A test program cannot link before there is a linker script, so compiler checks stop at a library.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# Only what selects the core. How code is compiled is said by the targets (see flags.cmake).
string(JOIN " " _ingot_core_flags ${INGOT_CORE_FLAGS} -mthumb)
set(CMAKE_C_FLAGS_INIT "${_ingot_core_flags}")
set(CMAKE_CXX_FLAGS_INIT "${_ingot_core_flags}")
set(CMAKE_ASM_FLAGS_INIT "${_ingot_core_flags}")

# newlib's small variant, without its system calls: a firmware that reaches for the heap fails to link (no _sbrk).
set(CMAKE_EXE_LINKER_FLAGS_INIT "--specs=nano.specs")
# Last on every link line, after all libraries that may call it.
set(CMAKE_CXX_STANDARD_LIBRARIES_INIT "-lm")
set(CMAKE_EXECUTABLE_SUFFIX_C .elf)
set(CMAKE_EXECUTABLE_SUFFIX_CXX .elf)

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# ctest appends the ELF file to this list. -icount makes every instruction 64 ns of virtual time, so that a clock of the
# board counts instructions, to the tick the same in every run (see platform/clock_qemu.cpp). The exit status is the
# firmware's, by semihosting.
set(CMAKE_CROSSCOMPILING_EMULATOR
  ${INGOT_QEMU} -machine ${INGOT_QEMU_MACHINE}
  -nographic -monitor none -serial none
  -semihosting-config enable=on,target=native
  -icount shift=6,sleep=off
  -kernel)
