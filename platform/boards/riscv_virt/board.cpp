// SPDX-License-Identifier: MIT
// QEMU's machine virt with a 32-bit core. The counter is the core's own, so there is nothing of the board to tell.
#include <ingot/platform/boards/board.h>

namespace ingot::platform {

/// Of virtual time: one instruction a nanosecond, under -icount shift=0.
uint32_t board_cpu_hz() { return 1'000'000'000; }

}  // namespace ingot::platform
