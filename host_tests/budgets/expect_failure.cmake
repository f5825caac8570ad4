# SPDX-License-Identifier: MIT
# Runs COMMAND (a list), which must fail and say what matches SAYING: a check that fails for another reason proves nothing.
execute_process(COMMAND ${COMMAND} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
message("${output}")
if(result EQUAL 0)
  message(FATAL_ERROR "this should have failed")
endif()
string(REGEX REPLACE "[ \n]+" " " output "${output}")  # CMake wraps its messages
if(NOT output MATCHES "${SAYING}")
  message(FATAL_ERROR "this failed without saying '${SAYING}'")
endif()
