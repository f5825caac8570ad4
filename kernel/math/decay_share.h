// SPDX-License-Identifier: MIT
#pragma once

#include "../base/config.h"

namespace ingot { inline namespace INGOT_ABI {

/// 1 - exp(-x) for x >= 0, to 24 roundings: a Taylor series up to x = 1/4, and 1 - exp(-2x) = p (2 - p) beyond.
/// Cost: 17 flops in float, 29 in double, and 3 for each doubling.
constexpr scalar decay_share(scalar x) {
    constexpr scalar whole = 64;  // exp(-64) is nothing beside 1
    scalar y = x < whole ? x : whole;
    int doublings = 0;
    for (; y > scalar(0.25); y *= scalar(0.5)) ++doublings;  // bound: 8: from 64 to 1/4
    constexpr int terms = INGOT_DOUBLE ? 14 : 8;             // the next is below 4^-14 / 15! and 4^-8 / 9!
    scalar tail = 1;
    for (int n = terms; n >= 2; --n) tail = 1 - y / static_cast<scalar>(n) * tail;
    scalar share = y * tail;
    for (int i = 0; i < doublings; ++i) share = share * (2 - share);  // bound: 8
    return share;
}

} }  // namespace ingot
