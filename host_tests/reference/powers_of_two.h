// SPDX-License-Identifier: MIT
// Worlds that are a power of two apart: what is scaled by one keeps all its digits.
#pragma once

#include <ingot/ingot.h>

#include <cmath>
#include <limits>

namespace ingot_reference {

constexpr ingot::scalar power_of_two(int k) {
    return k == 0 ? ingot::scalar(1) : k > 0 ? 2 * power_of_two(k - 1) : power_of_two(k + 1) / 2;
}

/// Equal, or where products of what is left of a number lie below the smallest that float has with all its digits: there no power of two is exact.
inline bool equal(ingot::scalar a, ingot::scalar b) {
    const double lost = std::sqrt(static_cast<double>(std::numeric_limits<ingot::scalar>::min()));
    return a == b || (std::abs(static_cast<double>(a)) < lost && std::abs(static_cast<double>(b)) < lost);
}
inline bool equal(const ingot::Vector& a, const ingot::Vector& b) { return equal(a.x, b.x) && equal(a.y, b.y) && equal(a.z, b.z); }

}  // namespace ingot_reference
