# SPDX-License-Identifier: MIT
# 64-bit Arm, of the Switch and of phones: NEON with denormals, fused multiply-add unless it is forbidden.
set(INGOT_PROCESSOR aarch64)
set(INGOT_CORE_FLAGS )
set(INGOT_TRIPLET aarch64-linux-gnu)
set(INGOT_QEMU_USER qemu-aarch64)

include("${CMAKE_CURRENT_LIST_DIR}/linux-cross.cmake")
