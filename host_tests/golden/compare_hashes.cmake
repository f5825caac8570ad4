# SPDX-License-Identifier: MIT
# Runs PROGRAM (through EMULATOR, a list, if there is one) and compares its hash lines with the rows of GOLDEN.
# QEMU writes what firmware prints by semihosting to its standard error.
execute_process(COMMAND ${EMULATOR} ${PROGRAM} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
string(REPLACE "\r" "" output "${output}")  # which Windows has at the ends of lines
message("${output}")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the program ended with ${result}")
endif()

set(compared 0)
file(STRINGS ${GOLDEN} rows REGEX "^[a-z0-9_]+,${SCALAR},")
foreach(row IN LISTS rows)
  string(REPLACE "," ";" fields ${row})
  list(GET fields 0 scene)
  list(GET fields 2 steps)
  list(GET fields 3 hash)
  if((SCENE AND NOT scene MATCHES "^${SCENE}$") OR (EXCEPT AND scene MATCHES "^${EXCEPT}$"))
    continue()
  endif()
  string(FIND "${output}" "${scene} ${SCALAR} steps ${steps} hash ${hash}\n" found)
  if(found EQUAL -1)
    message(FATAL_ERROR "golden: ${scene} ${SCALAR} steps ${steps} hash ${hash}: not what the program printed")
  endif()
  math(EXPR compared "${compared} + 1")
endforeach()
if(compared EQUAL 0)
  message(FATAL_ERROR "hashes.csv has no row for '${SCENE}' ${SCALAR}")
endif()
