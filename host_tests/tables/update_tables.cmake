# SPDX-License-Identifier: MIT
# Rewrites every table of this folder that is measured, those of this build apart (golden_scenes has rewritten its own), and prints what has changed:
#
#     cmake --preset host-gcc-float-4 && cmake --build --preset host-gcc-float-4 --target update_tables
#
# What people write, survivors.csv and exclusions.csv, stays as it is.
function(run)
  message("${ARGN}")
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${SOURCE} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${output}")
  endif()
endfunction()

function(update preset)
  run(${CMAKE_COMMAND} --preset ${preset})
  run(${CMAKE_COMMAND} --build --preset ${preset} --target ${ARGN})
endfunction()

if(SCALAR STREQUAL "double")
  update(host-gcc-float-4 update_golden update_hashes_of_pairs)
else()
  update(host-gcc-double-4 update_golden update_hashes_of_pairs)
endif()
update(cortex-m0 budgets_update report_methods_update)
update(cortex-m7 budgets_update)
update(cortex-m4f budgets_update report_methods_update)
update(cortex-m4f worst_steps_update)
update(cortex-m4f footprint)  # last: the page is made of all others
find_package(Python3 REQUIRED COMPONENTS Interpreter)
run(${Python3_EXECUTABLE} host_tests/guide/guide.py --update)  # what it shows of these tables; update_guide has the rest
execute_process(COMMAND git diff --stat -- host_tests/tables host_tests/guide README.md WORKING_DIRECTORY ${SOURCE})
