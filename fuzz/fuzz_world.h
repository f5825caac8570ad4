// SPDX-License-Identifier: MIT
#pragma once

#include <stddef.h>
#include <stdint.h>

// The same calls on worlds of 1, of 4 and of 8 lanes. Ends the program at a broken promise.
// Returns: a hash of every answer, report, state and contact on the way; it does not depend on the lane count.
uint64_t run_with_1_lane(const uint8_t* data, size_t size);
uint64_t run_with_4_lanes(const uint8_t* data, size_t size);
uint64_t run_with_8_lanes(const uint8_t* data, size_t size);

/// Which promise the run breaks on purpose, so that a test sees that the oracle notices; 0: none. From INGOT_FUZZ_FAULT, see fuzz_main.cpp.
extern int fuzz_fault;

/// Ends the program, which stands beside the entry: see fuzz_main.cpp.
[[noreturn]] void broken_promise(const char* text);

/// The step of the world that is asked for its promises; copies of it take ingot::step. Who measures steps defines another in a header that comes
/// before: slow_steps.h, host_tests/budgets/worst_steps/counted_step.h.
#ifndef INGOT_FUZZ_STEP
#define INGOT_FUZZ_STEP ingot::step
#endif
