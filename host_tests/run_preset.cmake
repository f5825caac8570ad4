# SPDX-License-Identifier: MIT
# What `cmake --workflow --preset PRESET` does, with JOBS at a time, for a preset can only name a number, in brief where the tests around it are (BRIEF:
# what few scenes call, and none of these, is compiled as it is written), and with tables that may be exceeded by GROWTH per cent.
foreach(step "${CMAKE_COMMAND};--preset;${PRESET};-DINGOT_BUDGET_GROWTH=${GROWTH};-DINGOT_TEST_BRIEF=${BRIEF};-DINGOT_KERNEL_QUICK=${BRIEF}" "${CMAKE_COMMAND};--build;--preset;${PRESET};--parallel;${JOBS}"
    "${CMAKE_CTEST_COMMAND};--preset;${PRESET};--parallel;${JOBS}")
  execute_process(COMMAND ${step} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${step} ended with ${result}")
  endif()
endforeach()
