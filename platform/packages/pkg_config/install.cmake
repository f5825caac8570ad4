# SPDX-License-Identifier: MIT
# ingot.pc, for make, Meson and all who ask pkg-config: the flags are those that ingot::kernel has for whoever links it. Found by its own place, so that
# an installed folder may be moved.
set(INGOT_PC_LIBS "")
if(INGOT_PLATFORM STREQUAL "host")
  set(INGOT_PC_LIBS -pthread)  # platform/host_threads.h
endif()
foreach(folder LIBDIR INCLUDEDIR)
  set(INGOT_PC_${folder} "\${prefix}/${CMAKE_INSTALL_${folder}}")
  if(IS_ABSOLUTE "${CMAKE_INSTALL_${folder}}")
    set(INGOT_PC_${folder} "${CMAKE_INSTALL_${folder}}")
  endif()
endforeach()
file(RELATIVE_PATH INGOT_PREFIX_FROM_PC "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/ingot.pc.in ${PROJECT_BINARY_DIR}/ingot.pc.with_expressions @ONLY)
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/ingot.pc INPUT ${PROJECT_BINARY_DIR}/ingot.pc.with_expressions CONDITION $<COMPILE_LANGUAGE:CXX>)
install(FILES ${PROJECT_BINARY_DIR}/ingot.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
