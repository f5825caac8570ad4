# SPDX-License-Identifier: MIT
# Headers are included as <ingot/room/name.h>, in the build tree as after an install: the build tree gets one forwarding
# header for each.
function(ingot_public_headers prefix)
  foreach(header IN LISTS ARGN)
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/include/${prefix}/${header}
      CONTENT "#include \"${CMAKE_CURRENT_SOURCE_DIR}/${header}\"\n")
    if(INGOT_INSTALL)
      include(GNUInstallDirs)
      get_filename_component(room ${header} DIRECTORY)
      install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${prefix}/${room})
    endif()
  endforeach()
endfunction()
