# SPDX-License-Identifier: MIT
# Runs FILE, a manifest in CMake's language, with stubs of the commands that its tool has, which print what they are told. Script mode has no targets, so that
# is all of it; `building` compiles what is compiled.
foreach(command idf_component_register target_compile_options zephyr_include_directories zephyr_library zephyr_library_sources zephyr_library_compile_options
    vcpkg_check_linkage vcpkg_cmake_configure vcpkg_cmake_install vcpkg_cmake_config_fixup vcpkg_fixup_pkgconfig vcpkg_install_copyright)
  cmake_language(EVAL CODE "function(${command})\n  message(\"${command};\${ARGN}\")\nendfunction()")
endforeach()
include(${FILE})
