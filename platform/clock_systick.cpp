// SPDX-License-Identifier: MIT
// Clock on SysTick: present on every Cortex-M in practice, M0 included. Takes the SysTick interrupt once per 2^24 cycles.
#include "clock.h"

#include "boards/board.h"
#include "systick.h"

namespace ingot::platform {

void clock_start() { systick_start(); }

uint64_t clock_ticks() { return systick_ticks(); }

uint64_t clock_frequency_hz() { return board_cpu_hz(); }

const char* clock_name() { return "SysTick"; }

bool clock_counts_instructions() { return false; }

uint64_t clock_ticks_to_instructions(uint64_t) { return 0; }

}  // namespace ingot::platform
