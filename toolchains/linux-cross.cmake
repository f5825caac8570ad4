# SPDX-License-Identifier: MIT
# The part that all toolchain files of the linux-* family share: a cross compiler of the distribution, qemu-user as the emulator
# of ctest. They stand for the processors of consoles whose own tools no distribution has.
#
# Included by a file that has set
#   INGOT_PROCESSOR    CMAKE_SYSTEM_PROCESSOR
#   INGOT_CORE_FLAGS   what selects the core and its floating-point unit; may be empty
#   INGOT_TRIPLET      the prefix of the compiler
#   INGOT_QEMU_USER    the emulator, with the core if its default is another (a list); empty: nothing runs
#
# Overridable: -DINGOT_CROSS_PREFIX=/opt/cross/bin/aarch64-linux-gnu-   -DINGOT_QEMU=/opt/qemu/bin/qemu-aarch64
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR ${INGOT_PROCESSOR})

set(INGOT_CROSS_PREFIX "${INGOT_TRIPLET}-" CACHE STRING "Prefix of the cross compiler, with path if not in PATH")
set(INGOT_QEMU "${INGOT_QEMU_USER}" CACHE STRING "Emulator that runs programs under ctest")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES INGOT_CROSS_PREFIX INGOT_QEMU)

set(CMAKE_C_COMPILER "${INGOT_CROSS_PREFIX}gcc")
set(CMAKE_CXX_COMPILER "${INGOT_CROSS_PREFIX}g++")

# Only what selects the core. How code is compiled is said by the targets (see flags.cmake).
string(JOIN " " _ingot_core_flags ${INGOT_CORE_FLAGS})
set(CMAKE_C_FLAGS_INIT "${_ingot_core_flags}")
set(CMAKE_CXX_FLAGS_INIT "${_ingot_core_flags}")

# Static: the emulator then needs no file system of the target.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

set(CMAKE_CROSSCOMPILING_EMULATOR ${INGOT_QEMU})
