# SPDX-License-Identifier: MIT
# Fails when the firmwares SHAPES and ALL take more than MOST_OF_SHAPES and MOST_OF_ALL bytes of flash beyond WITHOUT, or WITHOUT has any of what
# draws. SIZE and NM read them.
execute_process(COMMAND ${NM} -C --defined-only ${WITHOUT} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
if(symbols MATCHES "line_of|WorldDrawing")
  message(FATAL_ERROR "draw: there without being called: ${CMAKE_MATCH_0}")
endif()
foreach(program WITHOUT SHAPES ALL)
  execute_process(COMMAND ${SIZE} ${${program}} OUTPUT_VARIABLE sizes COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "\n *([0-9]+)[ \t]+([0-9]+)" row "${sizes}")
  math(EXPR flash_${program} "${CMAKE_MATCH_1} + ${CMAKE_MATCH_2}")
endforeach()
foreach(program SHAPES ALL)
  math(EXPR bytes "${flash_${program}} - ${flash_WITHOUT}")
  message(STATUS "draw, ${program}: ${bytes} bytes of flash, at most ${MOST_OF_${program}}")
  if(bytes GREATER MOST_OF_${program})
    message(FATAL_ERROR "draw, ${program}: more than that")
  endif()
endforeach()
