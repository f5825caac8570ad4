# SPDX-License-Identifier: MIT
# As much of the Pico SDK as the example calls, for this machine.
macro(pico_sdk_init)
  add_library(pico_stdlib INTERFACE)
  target_include_directories(pico_stdlib INTERFACE ${CMAKE_CURRENT_SOURCE_DIR})
endmacro()
function(pico_enable_stdio_usb)
endfunction()
function(pico_add_extra_outputs)
endfunction()
