// SPDX-License-Identifier: MIT
// Turns of an orientation, which every rotation method is made of.
#pragma once

#include "../base/limits.h"
#include "../body/body_tiles.h"
#include "../body/kinematics.h"
#include "flight_clock.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// a + b = sum + error exactly. Source: Knuth, The Art of Computer Programming 2, 4.2.2, theorem B.
template <class T>
INGOT_INLINE void add_exactly(T a, T b, T& sum, T& error) {
    sum = a + b;
    const T b_seen = sum - a;
    error = (a - (sum - b_seen)) + (b - b_seen);
}

/// A + A_low += increment, rounded to A, the rest in A_low. Cost: 63 flops.
template <class T>
INGOT_INLINE void add_compensated(Mat3<T>& A, Mat3<T>& A_low, const Mat3<T>& increment) {
    const Mat3<T> due = increment + A_low;
    Vec3<T>* const columns[3] = {&A.c0, &A.c1, &A.c2};
    Vec3<T>* const low_columns[3] = {&A_low.c0, &A_low.c1, &A_low.c2};
    const Vec3<T> due_columns[3] = {due.c0, due.c1, due.c2};
    for (int column_i = 0; column_i < 3; ++column_i) {
        Vec3<T>& a = *columns[column_i];
        Vec3<T>& low = *low_columns[column_i];
        const Vec3<T>& d = due_columns[column_i];
        add_exactly(a.x, d.x, a.x, low.x);
        add_exactly(a.y, d.y, a.y, low.y);
        add_exactly(a.z, d.z, a.z, low.z);
    }
}

/// A += A (R(c) - 1) where good, for the turn with Rodrigues vector c = tan(angle/2) axis in body axes: per row a of A, u = a x c
/// gives 2/(1 + c.c) (u + u x c). With A_low the sum is compensated: A + A_low += the same, rounded to A, the rest in A_low.
/// Cost: 87 flops, 1 division; compensated 54 more.
template <bool compensate>
INGOT_INLINE void turn_body(scalar (&A)[9][lanes], [[maybe_unused]] scalar (*A_low)[lanes], const Vec3<lane>& c, mask good) {
    const lane f = splat<lane>(2) / (splat<lane>(1) + dot(c, c));
    for (int row_i = 0; row_i < 3; ++row_i) {
        const lane a[3] = {load(A[row_i]), load(A[3 + row_i]), load(A[6 + row_i])};
        const Vec3<lane> u = cross(Vec3<lane>{a[0], a[1], a[2]}, c), turn = (u + cross(u, c)) * f;
        const lane increments[3] = {turn.x, turn.y, turn.z};
        for (int column_i = 0; column_i < 3; ++column_i) {
            const int entry_i = 3 * column_i + row_i;
            lane sum;
            if constexpr (compensate) {
                lane rest;
                add_exactly(a[column_i], increments[column_i] + load(A_low[entry_i]), sum, rest);
                store(A_low[entry_i], rest);
            } else {
                sum = a[column_i] + increments[column_i];
            }
            store(A[entry_i], select(good, sum, a[column_i]));
        }
    }
}

/// (R(c) - 1) A for a turn about an axis of the world: per column a of A, u = c x a gives 2/(1 + c.c) (u + c x u).
INGOT_INLINE Mat3<lane> world_turn(const Mat3<lane>& A, const Vec3<lane>& c) {
    const lane f = splat<lane>(2) / (splat<lane>(1) + dot(c, c));
    const Vec3<lane> u0 = cross(c, A.c0), u1 = cross(c, A.c1), u2 = cross(c, A.c2);
    return {(u0 + cross(c, u0)) * f, (u1 + cross(c, u1)) * f, (u2 + cross(c, u2)) * f};
}

/// The Rodrigues vector of the turn by |u| about u: tan(|u|/2) u/|u|, without root or trigonometry.
///
/// Valid for: |u| <= 2 rad to rounding (float) and 1e-15 (double), from Lambert's continued fraction of the tangent,
///            tan x / x = 1/(1 - x^2/(3 - x^2/(5 - ...))); it stays smooth up to pi.
/// Cost:      6 flops and 7 divisions.
INGOT_INLINE Vec3<lane> rodrigues(const Vec3<lane>& u) {
    const lane x_sq = length_sq(u) * splat<lane>(scalar(0.25));
    lane tail = splat<lane>(15);
    for (int odd = 13; odd >= 1; odd -= 2) tail = splat<lane>(static_cast<scalar>(odd)) - x_sq / tail;
    return u * (splat<lane>(scalar(0.5)) / tail);
}

INGOT_INLINE int count_bits(uint16_t b) {
    int count = 0;
    // bound: 16: a bit falls out each turn
    for (; b != 0; b = static_cast<uint16_t>(b & (b - 1u))) ++count;
    return count;
}

/// The frame of the methods that keep nothing but A: turned(A, inv_I_body, L of mid-step) gives the new A of a tile.
template <class Turned>
INGOT_INLINE void integrate_tiles(const BodyView& bodies, const FlightClock& clock, const Turned& turned) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        RotationTile& tile = bodies.rotation[tile_i];
        const mask movable = load(tile.inv_I_scale) > lane{};  // an immovable body keeps its A to the bit
        tile.kicked = 0;
        if (!any(movable)) continue;
        const Mat3<lane> A = load(tile.A);
        const Vec3<lane> inv_I_body = load(tile.inv_I_ratio) * load(tile.inv_I_scale);
        const Vec3<lane> L = load(tile.L) - load(tile.tau_T) * splat<lane>(clock.kick_ahead);
        const Mat3<lane> A_next = turned(A, inv_I_body, L);
        const mask good = both(is_finite(A_next), is_within_runaway(spin_of(A, inv_I_body, L)));
        store(tile.A, select(both(good, movable), A_next, A));
        mark_bad(tile.bad, good);
    }
}

} }  // namespace ingot

#pragma GCC diagnostic pop
