# SPDX-License-Identifier: MIT
# 32-bit x86 with SSE2. The contract adds -msse2 -mfpmath=sse: x87 registers would round twice.
set(INGOT_PROCESSOR i686)
set(INGOT_CORE_FLAGS )
set(INGOT_TRIPLET i686-linux-gnu)
set(INGOT_QEMU_USER qemu-i386)

include("${CMAKE_CURRENT_LIST_DIR}/linux-cross.cmake")
