# SPDX-License-Identifier: MIT
# 32-bit PowerPC, big-endian: the core of GameCube and Wii. It has no square root instruction.
set(INGOT_PROCESSOR ppc)
set(INGOT_CORE_FLAGS -mcpu=750)
set(INGOT_TRIPLET powerpc-linux-gnu)
set(INGOT_QEMU_USER qemu-ppc -cpu 750cl)

include("${CMAKE_CURRENT_LIST_DIR}/linux-cross.cmake")
