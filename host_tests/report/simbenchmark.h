// SPDX-License-Identifier: MIT
// What the suite and the table of SimBenchmark's tests share.
#pragma once

#include <vector>

namespace report {

struct SimBenchmarkTest {
    const char *name, *title, *unit;
    const char *best_at_1_ms, *best_at_10_ms;  ///< on record, with the CPU time of an i7-class desktop of 2018
};
const std::vector<SimBenchmarkTest>& simbenchmark_tests();

/// Steps a second: 1, 2, 4, 8 and 10 ms.
const std::vector<int>& simbenchmark_rates();

}  // namespace report
