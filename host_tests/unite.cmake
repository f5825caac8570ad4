# SPDX-License-Identifier: MIT
# Writes a unit that holds several tests: what they include, once, and then each in a namespace of its own, so that names of one are not seen by another.
#
# -DSOURCES=<paths, apart by commas> -DUNIT=<path>
string(REPLACE "," ";" sources "${SOURCES}")
set(includes "")
set(tests "")
foreach(source IN LISTS sources)
  file(STRINGS ${source} lines REGEX "^#include ")
  list(APPEND includes ${lines})
  get_filename_component(name ${source} NAME_WE)
  string(APPEND tests "namespace ${name} {\n#include \"${source}\"\n}\n")
endforeach()
list(REMOVE_DUPLICATES includes)
list(JOIN includes "\n" includes)
file(WRITE ${UNIT} "${includes}\n${tests}")
