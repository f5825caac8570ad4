# SPDX-License-Identifier: MIT
# SH-4, of the Dreamcast. Compiled and not run: programs hang in QEMU's user mode for this core.
set(INGOT_PROCESSOR sh4)
set(INGOT_CORE_FLAGS "")
set(INGOT_TRIPLET sh4-linux-gnu)
set(INGOT_QEMU_USER "")

include("${CMAKE_CURRENT_LIST_DIR}/linux-cross.cmake")
