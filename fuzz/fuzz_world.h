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

/// The step of a world that the promises are asked for, not of its copies: worlds play it for its instructions too, see
/// host_tests/budgets/worst_steps.
#ifndef INGOT_FUZZ_STEP
#define INGOT_FUZZ_STEP ingot::step
#endif
