# SPDX-License-Identifier: MIT
# WebAssembly without a C library: clang, lld, and node as the emulator of ctest.
#
# Overridable: -DINGOT_WASM_CLANGXX=clang++-18   -DINGOT_NODE=/opt/node/bin/node
#              -DINGOT_WASM_SIMD=OFF   for engines without the 128-bit vectors: then the kernel has one lane
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)

option(INGOT_WASM_SIMD "Build for 128-bit vectors" ON)
set(INGOT_NODE node CACHE STRING "Runs modules under ctest")
find_program(INGOT_WASM_CLANGXX
  NAMES clang++ clang++-20 clang++-19 clang++-18 clang++-17 clang++-16 clang++-15 clang++-14
  DOC "clang for WebAssembly" REQUIRED)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES INGOT_WASM_SIMD INGOT_WASM_CLANGXX)

set(CMAKE_CXX_COMPILER "${INGOT_WASM_CLANGXX}")
set(CMAKE_CXX_COMPILER_TARGET wasm32-unknown-unknown)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
if(INGOT_WASM_SIMD)
  set(CMAKE_CXX_FLAGS_INIT -msimd128)
endif()
# -O0 is of the link alone: with any other level clang has a wasm-opt that it finds change the module, and one without bulk memory refuses it.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -O0")
set(CMAKE_EXECUTABLE_SUFFIX_CXX .wasm)

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

set(CMAKE_CROSSCOMPILING_EMULATOR ${INGOT_NODE} ${CMAKE_CURRENT_LIST_DIR}/../platform/boards/wasm/run.mjs)
