# SPDX-License-Identifier: MIT
# 32-bit MIPS, big-endian: close to the N64.
set(INGOT_PROCESSOR mips)
set(INGOT_CORE_FLAGS )
set(INGOT_TRIPLET mips-linux-gnu)
set(INGOT_QEMU_USER qemu-mips)

include("${CMAKE_CURRENT_LIST_DIR}/linux-cross.cmake")
