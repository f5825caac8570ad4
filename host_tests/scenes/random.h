// SPDX-License-Identifier: MIT
#pragma once

#include <ingot/ingot.h>

namespace scenes {

/// The same numbers on every target: a linear congruential generator whose upper bits become a fraction exactly.
/// Source: Knuth, The Art of Computer Programming 2, 3.3.4, table 1 (multiplier of line 26).
class Random {
public:
    explicit constexpr Random(uint64_t seed) : state_(seed) {}

    /// A number in [-1, 1): a multiple of 2^-23.
    constexpr ingot::scalar symmetric() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        const int32_t bits = static_cast<int32_t>(state_ >> 40) - (1 << 23);
        return static_cast<ingot::scalar>(bits) * (ingot::scalar(1) / (1 << 23));
    }

    constexpr ingot::Vector symmetric_vector() {
        const ingot::scalar x = symmetric(), y = symmetric(), z = symmetric();
        return {x, y, z};
    }

private:
    uint64_t state_;
};

}  // namespace scenes
