# SPDX-License-Identifier: MIT
# 64-bit Windows by GCC (MinGW-w64), its programs run by Wine. The variant with POSIX threads, which has std::thread.
#
# Overridable: -DINGOT_CROSS_PREFIX=/opt/mingw/bin/x86_64-w64-mingw32-   -DINGOT_WINE=/opt/wine/bin/wine
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)

set(INGOT_CROSS_PREFIX "x86_64-w64-mingw32-" CACHE STRING "Prefix of the cross compiler, with path if not in PATH")
set(INGOT_WINE "wine" CACHE STRING "Runs programs under ctest")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES INGOT_CROSS_PREFIX INGOT_WINE)

find_program(INGOT_MINGW_GCC NAMES ${INGOT_CROSS_PREFIX}gcc-posix ${INGOT_CROSS_PREFIX}gcc REQUIRED)
find_program(INGOT_MINGW_GXX NAMES ${INGOT_CROSS_PREFIX}g++-posix ${INGOT_CROSS_PREFIX}g++ REQUIRED)
set(CMAKE_C_COMPILER "${INGOT_MINGW_GCC}")
set(CMAKE_CXX_COMPILER "${INGOT_MINGW_GXX}")

# Static: Wine then needs none of the compiler's libraries.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

set(CMAKE_CROSSCOMPILING_EMULATOR ${INGOT_WINE})
