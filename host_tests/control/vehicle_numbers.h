// SPDX-License-Identifier: MIT
// Numbers that tests of vehicles share: they reckon in double.
#pragma once

#include <ingot/ingot.h>

namespace vehicle_numbers {

using ingot::scalar;

inline constexpr double g = 9.81, eps = static_cast<double>(ingot::epsilon);
inline scalar number(double x) { return static_cast<scalar>(x); }
inline double real(scalar x) { return static_cast<double>(x); }

}  // namespace vehicle_numbers
