// SPDX-License-Identifier: MIT
#pragma once

#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Copies the rows of an island out of the blocks, once a step: they do not change within it.
void load_rows(const SolverView& solver, const BodyView& bodies, DirectView& direct, uint16_t root);

/// Speed along a row, or displacement: k reads L where J reads dth.
template <bool displaces>
inline double row_motion(const DirectView& island, const DirectManifold& manifold, const DirectRow& row) {
    const DirectBody &A = island.bodies[manifold.body[0]], &B = island.bodies[manifold.body[1]];
    const DirectVector* const lever = displaces ? row.J : row.k;
    return dot(row.d, A.linear - B.linear) + dot(lever[0], A.angular) + dot(lever[1], B.angular);
}

/// Gives an impulse along a row, or a push.
template <bool displaces>
inline void give(const DirectView& island, const DirectManifold& manifold, DirectRow& row, double j) {
    DirectBody &A = island.bodies[manifold.body[0]], &B = island.bodies[manifold.body[1]];
    const DirectVector* const lever = displaces ? row.k : row.J;
    row.j += j;
    A.linear += row.d * (j * A.inv_M);
    B.linear -= row.d * (j * B.inv_M);
    A.angular += lever[0] * j;
    B.angular += lever[1] * j;
}

inline DirectVector in_double(const scalar* from) {
    return {static_cast<double>(from[0]), static_cast<double>(from[1]), static_cast<double>(from[2])};
}
inline DirectVector in_double(const Vector& from) {
    return {static_cast<double>(from.x), static_cast<double>(from.y), static_cast<double>(from.z)};
}
inline void put_scalars(scalar (&to)[4], const DirectVector& from) {
    to[0] = static_cast<scalar>(from.x);
    to[1] = static_cast<scalar>(from.y);
    to[2] = static_cast<scalar>(from.z);
}

} }  // namespace ingot
