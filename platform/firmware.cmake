# SPDX-License-Identifier: MIT
# ingot_add_firmware(<target> [STACK_BYTES <n>] <source>...): a program for the board of the current toolchain.
#
# On a board: an ELF file with start-up code, vector table and linker script of the board, no libc start-up, unused sections
# dropped, and a map file beside it. With an operating system: an ordinary program from the same sources, so that a scene's
# firmware also runs on the host. As WebAssembly: a module that imports text output, the end and a clock (boards/wasm/run.mjs). All link ingot::platform and start at `int main()`.
#
# Under the toolchain files of ingot the target runs in the emulator: add_test(NAME x COMMAND <target>).
#
#   STACK_BYTES    size of the stack; the default is in the board's board.ld
include_guard(GLOBAL)

function(ingot_add_firmware target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "STACK_BYTES" "")
  add_executable(${target} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${target} PRIVATE ingot::platform)
  if(NOT CMAKE_SYSTEM_NAME STREQUAL "Generic")
    return()
  endif()

  if(CMAKE_SYSTEM_PROCESSOR STREQUAL "wasm32")
    # The stack lies below the data: an overflow leaves memory and traps.
    target_link_options(${target} PRIVATE -Wl,--no-entry -Wl,--export=__main_void -Wl,--stack-first)
    if(arg_STACK_BYTES)
      target_link_options(${target} PRIVATE "-Wl,-z,stack-size=${arg_STACK_BYTES}")
    endif()
    return()
  endif()

  set(boards_dir "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/boards")
  if(INGOT_BOARD_DIR)
    set(board_dir "${INGOT_BOARD_DIR}")
  elseif(INGOT_BOARD)
    set(board_dir "${boards_dir}/${INGOT_BOARD}")
  else()
    message(FATAL_ERROR "ingot_add_firmware(${target}): set INGOT_BOARD or INGOT_BOARD_DIR, or use a toolchain file of ingot")
  endif()

  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^riscv")
    set(startup startup_riscv.cpp)
  else()
    set(startup startup_cortex_m.cpp)
  endif()
  target_sources(${target} PRIVATE "${boards_dir}/${startup}" "${board_dir}/board.cpp")
  target_compile_options(${target} PRIVATE
    "$<$<COMPILE_LANGUAGE:CXX>:-fno-exceptions;-fno-rtti;-fno-threadsafe-statics;-fno-use-cxa-atexit>"
    -ffunction-sections
    -fdata-sections)

  set(linker_script "${board_dir}/board.ld")
  set(common_linker_script "${boards_dir}/sections.ld")
  target_link_options(${target} PRIVATE
    -nostartfiles
    "-L${boards_dir}"  # where board.ld finds sections.ld
    "-T${linker_script}"
    -Wl,--gc-sections
    -Wl,--fatal-warnings
    "-Wl,-Map=$<TARGET_FILE:${target}>.map")
  if(arg_STACK_BYTES)
    target_link_options(${target} PRIVATE "-Wl,--defsym=ingot_stack_size=${arg_STACK_BYTES}")
  endif()
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${linker_script}" "${common_linker_script}")
endfunction()
