# SPDX-License-Identifier: MIT
# Fails when FIRMWARE has a function of the kernel whose name matches STAGES, EXCEPT apart: two regular expressions. NM lists
# the symbols. Helpers in anonymous namespaces are not looked at: they do not come without the stage they help.
execute_process(COMMAND ${NM} -C --defined-only ${FIRMWARE} OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${NM} ended with ${result}")
endif()
string(REGEX MATCHALL "ingot::f[0-9]+x[0-9]+::[A-Za-z_0-9]+[<(]" functions "${symbols}")
if(NOT functions)
  message(FATAL_ERROR "no function of the kernel found in ${FIRMWARE}: is it a firmware with symbols?")
endif()
list(FILTER functions INCLUDE REGEX "::(${STAGES})[<(]$")
if(EXCEPT)
  list(FILTER functions EXCLUDE REGEX "::(${EXCEPT})[<(]$")
endif()
list(REMOVE_DUPLICATES functions)
if(functions)
  message(FATAL_ERROR "the scene does not name it, the firmware has it: ${functions}")
endif()
