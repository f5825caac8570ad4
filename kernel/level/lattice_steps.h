// SPDX-License-Identifier: MIT
// From metres to steps of a lattice, outwards.
#pragma once

#include "level_table.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where the corner of this number is, along one axis. Of a lattice of a power of two without rounding.
constexpr scalar corner_along(scalar origin, scalar step, int number) { return origin + step * static_cast<scalar>(number); }

/// The first of the numbers 0 .. 65535 whose corner is not below x; 65536 or more where none is. Judged by the sums that make corners, so nothing is
/// lost to a rounding: that of the quotient leaves one step open.
inline int first_step_from(scalar x, scalar origin, scalar step, scalar inv_step) {
    const scalar steps = (x - origin) * inv_step;
    const int whole = steps <= 0 ? 0 : steps < 65536 ? static_cast<int>(steps) : 65536;
    return corner_along(origin, step, whole) < x ? whole + 1 : whole;
}

/// The last that is not above x; -1 where none is.
inline int last_step_to(scalar x, scalar origin, scalar step, scalar inv_step) {
    const scalar steps = (x - origin) * inv_step;
    const int whole = !(steps >= 0) ? -1 : steps < 65535 ? static_cast<int>(steps) : 65535;
    return corner_along(origin, step, whole) > x ? whole - 1 : whole;
}

}}  // namespace ingot::INGOT_ABI
