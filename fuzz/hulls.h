// SPDX-License-Identifier: MIT
// Hulls of the fuzzers' scenes, whose origin is their centre; the body may have any mass.
#pragma once

#include <ingot/ingot.h>

namespace fuzz { inline namespace INGOT_ABI {

using ingot::scalar;
using ingot::Vector;

constexpr Vector octahedron_points[6] = {{scalar(0.5), 0, 0},  {scalar(-0.5), 0, 0}, {0, scalar(0.5), 0},
                                         {0, scalar(-0.5), 0}, {0, 0, scalar(0.5)},  {0, 0, scalar(-0.5)}};
constexpr Vector sliver_points[5] = {
    {0, 0, scalar(0.03)}, {scalar(0.75), 0, 0}, {scalar(-0.5), scalar(0.25), 0}, {scalar(-0.5), scalar(-0.25), 0}, {0, 0, scalar(-0.03)}};
constexpr auto octahedron = ingot::convex_hull(octahedron_points);
constexpr auto sliver = ingot::convex_hull(sliver_points);
static_assert(octahedron.ok() && sliver.ok());

} }  // namespace fuzz
