// SPDX-License-Identifier: MIT
// Clock of a machine with an operating system and a C++ library: PC, phone, current console.
#include "clock.h"

#include <chrono>

namespace ingot::platform {

using Clock = std::chrono::steady_clock;

// Were the period no whole fraction of a second, a frequency in Hz could not say it.
static_assert(Clock::period::num == 1, "steady_clock has no whole frequency on this system: write another back-end");

void clock_start() {}

uint64_t clock_ticks() { return static_cast<uint64_t>(Clock::now().time_since_epoch().count()); }

uint64_t clock_frequency_hz() { return static_cast<uint64_t>(Clock::period::den); }

const char* clock_name() { return "steady_clock"; }

bool clock_counts_instructions() { return false; }

uint64_t clock_ticks_to_instructions(uint64_t) { return 0; }

}  // namespace ingot::platform
