# SPDX-License-Identifier: MIT
# Fails when FIRMWARE has a function of the kernel whose name matches STAGES, a regular expression. NM lists the symbols.
# Helpers in the files of stages (anonymous namespace) are not looked at: they do not come without their stage.
execute_process(COMMAND ${NM} -C --defined-only ${FIRMWARE} OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${NM} ended with ${result}")
endif()
string(REGEX MATCHALL "ingot::f[0-9]+x[0-9]+::[A-Za-z_0-9]+[<(]" functions "${symbols}")
list(LENGTH functions count)
if(count EQUAL 0)
  message(FATAL_ERROR "no function of the kernel found in ${FIRMWARE}: is it a firmware with symbols?")
endif()
list(FILTER functions INCLUDE REGEX "::(${STAGES})[<(]$")
list(REMOVE_DUPLICATES functions)
if(functions)
  message(FATAL_ERROR "the scene does not name it, the firmware has it: ${functions}")
endif()
