# SPDX-License-Identifier: MIT
# 32-bit MIPS, little-endian: close to PSP and PS2.
set(INGOT_PROCESSOR mipsel)
set(INGOT_CORE_FLAGS )
set(INGOT_TRIPLET mipsel-linux-gnu)
set(INGOT_QEMU_USER qemu-mipsel)

include("${CMAKE_CURRENT_LIST_DIR}/linux-cross.cmake")
