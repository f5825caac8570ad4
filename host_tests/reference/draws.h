// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

namespace ingot_reference {

/// How many of n draws a test takes: an eighth with INGOT_TEST_BRIEF, all of them by nightly; so many times more as the environment says in
/// INGOT_TEST_TIMES: any law for as long as one likes, `INGOT_TEST_TIMES=250 fast_ground_test --gtest_filter='FastOnTriangles.stay_in_rooms*'`.
inline int draws(int n) {
    const char* const times = std::getenv("INGOT_TEST_TIMES");
    return (INGOT_TEST_BRIEF ? (n + 7) / 8 : n) * (times == nullptr ? 1 : std::atoi(times));
}

}  // namespace ingot_reference
