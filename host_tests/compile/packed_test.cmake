# SPDX-License-Identifier: MIT
# The function FUNCTION in OBJECT works on packed numbers: most of its floating-point instructions are on whole vectors, so that
# a build whose lanes the compiler takes apart is noticed.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${OBJDUMP} -d --no-show-raw-insn ${OBJECT} OUTPUT_VARIABLE listing RESULT_VARIABLE result ERROR_VARIABLE errors)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${OBJDUMP} ${OBJECT}: ${errors}")
endif()
string(REGEX MATCHALL "[0-9a-f]+:[ \t]+v?(add|sub|mul|div|sqrt|fn?m[as][a-z]+[0-9]*)p[sd]" packed "${listing}")
string(REGEX MATCHALL "[0-9a-f]+:[ \t]+v?(add|sub|mul|div|sqrt|fn?m[as][a-z]+[0-9]*)s[sd]" scalar "${listing}")
list(LENGTH packed packed_count)
list(LENGTH scalar scalar_count)
math(EXPR allowed "${packed_count} / 10")
if(packed_count LESS 100 OR scalar_count GREATER allowed)
  message(FATAL_ERROR "packed: ${packed_count} packed and ${scalar_count} scalar instructions of arithmetic in ${OBJECT}")
endif()
message("${packed_count} packed, ${scalar_count} scalar")
