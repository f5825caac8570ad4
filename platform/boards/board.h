// SPDX-License-Identifier: MIT
// What a board tells the clock back-ends. Defined by boards/<board>/board.cpp, or by the firmware for a board of its own:
// systick and dwt need board_cpu_hz(), qemu needs the three of the counter.
#pragma once

#include <stdint.h>

namespace ingot::platform {

/// Processor clock. Units: Hz.
uint32_t board_cpu_hz();

/// Switches the board's free-running counter on. It counts up, has 32 bits, wraps on its own and needs no interrupt.
void board_counter_start();

/// The counter now. Called with interrupts held off.
uint32_t board_counter();

/// Units: Hz.
uint32_t board_counter_hz();

}  // namespace ingot::platform
