// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

namespace ingot_reference {

/// How many of n draws a test takes: an eighth with INGOT_TEST_BRIEF, all of them by nightly; so many times as many as the environment says in
/// INGOT_TEST_TIMES: any law for as long as one likes, `INGOT_TEST_TIMES=250 fast_ground_test --gtest_filter='FastOnTriangles.stay_in_rooms*'`, or
/// all scenes in as little time as few, `INGOT_TEST_TIMES=0.125 ctest`. At least one.
inline int draws(int n) {
    const char* const times = std::getenv("INGOT_TEST_TIMES");
    const double wanted = (INGOT_TEST_BRIEF ? (n + 7) / 8 : n) * (times == nullptr ? 1 : std::atof(times));
    return wanted < 1 ? 1 : static_cast<int>(wanted);
}

}  // namespace ingot_reference
