// SPDX-License-Identifier: MIT
#pragma once

namespace ingot_reference {

/// How many of n draws a test takes: a quarter with INGOT_TEST_BRIEF, all of them by nightly.
constexpr int draws(int n) { return INGOT_TEST_BRIEF ? (n + 3) / 4 : n; }

}  // namespace ingot_reference
