// SPDX-License-Identifier: MIT
#pragma once

namespace ingot_reference {

/// How many of n draws a test takes: an eighth with INGOT_TEST_BRIEF, all of them by nightly.
constexpr int draws(int n) { return INGOT_TEST_BRIEF ? (n + 7) / 8 : n; }

}  // namespace ingot_reference
