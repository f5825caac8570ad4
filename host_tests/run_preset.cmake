# SPDX-License-Identifier: MIT
# What `cmake --workflow --preset PRESET` does, with as many tests at a time as there are processors, for a preset can only name a number, and with
# tables that may be exceeded by GROWTH per cent.
cmake_host_system_information(RESULT processors QUERY NUMBER_OF_LOGICAL_CORES)
foreach(step "${CMAKE_COMMAND};--preset;${PRESET};-DINGOT_BUDGET_GROWTH=${GROWTH}" "${CMAKE_COMMAND};--build;--preset;${PRESET}"
    "${CMAKE_CTEST_COMMAND};--preset;${PRESET};--parallel;${processors}")
  execute_process(COMMAND ${step} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${step} ended with ${result}")
  endif()
endforeach()
