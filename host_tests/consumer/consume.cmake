# SPDX-License-Identifier: MIT
# Installs ingot from BUILD where HOW asks for it, then configures, builds and runs the consumer in SCRATCH.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${result}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
set(how -DHOW=${HOW})
if(HOW STREQUAL "find_package")
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix)
  list(APPEND how -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix)
  file(GLOB_RECURSE installed RELATIVE ${SCRATCH}/prefix ${SCRATCH}/prefix/*)
  foreach(path IN LISTS installed)
    if(NOT path MATCHES "^(include/ingot/|lib[^/]*/(.*/)?(libingot_(kernel|platform)\\.a|cmake/ingot/))")
      message(FATAL_ERROR "the install holds ${path}")
    endif()
  endforeach()
else()
  list(APPEND how -DINGOT_SOURCE=${SOURCE} -DINGOT_SCALAR=${SCALAR} -DINGOT_LANES=${LANES} -DINGOT_KERNEL_LEVEL=O1)
endif()

# The user is careless: the whole project is compiled with -ffast-math, which ingot must undo for itself and for who links it.
if(DOUBLE)
  set(other_double 0)
else()
  set(other_double 1)
endif()
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${PROJECT} -B ${SCRATCH}/build -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_CXX_FLAGS=-ffast-math -DOTHER_DOUBLE=${other_double} ${how})
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/consumer)
message("${output}")

foreach(mismatch ingot_lanes ingot_double)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${SCRATCH}/build --target mismatch_${mismatch}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result EQUAL 0 OR NOT output MATCHES "undefined reference to .*ingot::f(32|64)x")
    message(FATAL_ERROR "a program with another ${mismatch} than the library's linked with it:\n${output}")
  endif()
endforeach()

# Contraction is off in the user's unit, and would be on without ingot.
execute_process(COMMAND ${CMAKE_COMMAND} --build ${SCRATCH}/build --target sums_with_ingot sums_without_ingot
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(result EQUAL 0)
  foreach(user with without)
    run(${OBJDUMP} -d ${SCRATCH}/build/libsums_${user}_ingot.a)
    string(REGEX MATCH "fn?madd[0-9a-z]*" contracted_${user} "${output}")
  endforeach()
  if(contracted_with OR NOT contracted_without)
    message(FATAL_ERROR "contraction: '${contracted_with}' with ingot, '${contracted_without}' without")
  endif()
elseif(NOT output MATCHES "unknown target|No rule")
  message(FATAL_ERROR "${output}")
endif()
