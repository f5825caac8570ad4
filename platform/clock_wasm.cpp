// SPDX-License-Identifier: MIT
// Clock of a WebAssembly module: a function that its host provides (boards/wasm/run.mjs under node).
#include "clock.h"

extern "C" __attribute__((import_module("ingot"), import_name("now_ns"))) uint64_t ingot_host_now_ns();

namespace ingot::platform {

void clock_start() {}

uint64_t clock_ticks() { return ingot_host_now_ns(); }

uint64_t clock_frequency_hz() { return 1'000'000'000; }

const char* clock_name() { return "clock of the module's host"; }

bool clock_counts_instructions() { return false; }

uint64_t clock_ticks_to_instructions(uint64_t) { return 0; }

}  // namespace ingot::platform
