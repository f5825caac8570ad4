# SPDX-License-Identifier: MIT
# An overlay port that is complete: its sources lie beside it. `vcpkg install ingot --overlay-ports=<folder above this one>`
vcpkg_check_linkage(ONLY_STATIC_LIBRARY)
vcpkg_cmake_configure(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/source" OPTIONS -DINGOT_BUILD_TESTS=OFF -DINGOT_BUILD_DEMO=OFF -DINGOT_INSTALL=ON)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/ingot)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${CMAKE_CURRENT_LIST_DIR}/source/LICENSE")
