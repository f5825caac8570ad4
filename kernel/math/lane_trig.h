// SPDX-License-Identifier: MIT
#pragma once

#include "lanes.h"
#include "trig.h"

namespace ingot { inline namespace INGOT_ABI {

/// The whole number next to x. Valid for |x| < 2^22 (float), 2^51 (double).
INGOT_INLINE lane nearest_whole(lane x) {
    // Beyond this number the grid of the type is the whole numbers: adding it rounds, and the rounding is kept.
    const lane grid = splat<lane>(INGOT_DOUBLE ? scalar(6755399441055744.0) : scalar(12582912.0f));
    return (x + grid) - grid;
}

/// sin_cos in lanes: sine and cosine of an angle in rad, |angle| <= 1000; the methods of motion/ that turn by given angles.
///
/// Error: as sin_cos. Cost: about 65 flops, no division.
INGOT_INLINE SinCosOf<lane> lane_sin_cos(lane angle) {
    const lane q = nearest_whole(angle * splat<lane>(two_over_pi));
    const SinCosOf<lane> reduced = sin_cos_reduced(reduced_angle(angle, q));

    // The quadrant, q modulo 4, as -2 .. 2: odd ones swap sine and cosine.
    const lane quadrant = q - nearest_whole(q * splat<lane>(scalar(0.25))) * splat<lane>(4);
    const lane magnitude = abs(quadrant), one = splat<lane>(1);
    const mask odd = abs(magnitude - one) <= lane{};
    const lane s = select(odd, reduced.cos, reduced.sin), c = select(odd, reduced.sin, reduced.cos);
    const mask half_turn = magnitude > one;
    const mask quarter_back = quadrant + one <= lane{};
    const lane sine = select(half_turn, -s, select(both(odd, quarter_back), -s, s));
    const lane cosine = select(half_turn, -c, select(both(odd, quadrant > lane{}), -c, c));
    return {sine, cosine};
}

} }  // namespace ingot
