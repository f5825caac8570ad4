# SPDX-License-Identifier: MIT
# The machine at hand, compiled by GCC. Another GCC: -DINGOT_HOST_GXX=g++-13.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES INGOT_HOST_GXX)

find_program(INGOT_HOST_GXX NAMES g++ DOC "GCC for the host" REQUIRED)
set(CMAKE_CXX_COMPILER "${INGOT_HOST_GXX}")
