// SPDX-License-Identifier: MIT
#pragma once

#include "../../base/limits.h"
#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// What the direct solver of a view works on.
template <class View>
using DirectOf = DirectViewOf<View::rolls>;

/// Copies the rows of an island out of the blocks, once a batch: they do not change within it. View: SolverView, or a MaterialView.
template <class View, class Direct>
void load_rows(const View& solver, const BodyView& bodies, Direct& direct, int island_i);

/// Calls each(manifold, body, solver body) for the bodies of the island that stand for kinematic ones. They are B of their manifolds, and lie
/// behind all others.
template <class View, class Direct, class Each>
inline void for_kinematic(const View& solver, const Direct& direct, const Each& each) {
    // bound: max_island of HybridIslands: larger islands are swept
    for (int manifold_i = 0; manifold_i < direct.manifold_count; ++manifold_i) {
        const Index at = direct.manifolds[manifold_i].body[1];
        if (at >= direct.body_count) each(direct.manifolds[manifold_i], direct.bodies[at], solver.bodies[direct.bodies[at].body_i]);
    }
}

inline bool has(unsigned bits, int row) { return (bits >> row & 1u) != 0; }

/// The impulses of a manifold in its block, by the numbers of their rows, and what the sweeps to come take for their last.
template <class View, class OfIsland, class Visitor>
void for_impulses(const View& solver, const OfIsland& manifold, Visitor visit) {
    const int lane_i = manifold.position % lanes;
    ContactConstraint<View>::Given::for_rows(solver, manifold.position / lanes, [&](const SeenRow& row) {
        if (has(manifold.rows, row.number)) visit(row.number, row.j[lane_i], row.j_sweep[lane_i]);
    });
}

/// Whether two solver bodies are of limits::direct_mass_ratio; what cannot move is of none.
inline bool are_uneven(const SolverView& solver, int body_A, int body_B) {
    const scalar inv_M_A = solver.bodies[body_A].v_CM[3], inv_M_B = solver.bodies[body_B].v_CM[3];
    if (!(inv_M_A > 0) || !(inv_M_B > 0)) return false;
    return inv_M_A > limits::direct_mass_ratio * inv_M_B || inv_M_B > limits::direct_mass_ratio * inv_M_A;
}

/// Speed along a row, or displacement: k reads L where J reads dth.
template <bool displaces, class Direct>
inline wide_scalar row_motion(const Direct& island, const ManifoldOf<Direct>& manifold, const DirectRow& row) {
    const DirectBody &A = island.bodies[manifold.body[0]], &B = island.bodies[manifold.body[1]];
    const DirectVector* const lever = displaces ? row.J : row.k;
    return dot(row.d, A.linear - B.linear) + dot(lever[0], A.angular) + dot(lever[1], B.angular);
}

/// Gives an impulse along a row, or a push.
template <bool displaces, class Direct>
inline void give(const Direct& island, const ManifoldOf<Direct>& manifold, DirectRow& row, wide_scalar j) {
    DirectBody &A = island.bodies[manifold.body[0]], &B = island.bodies[manifold.body[1]];
    const DirectVector* const lever = displaces ? row.k : row.J;
    row.j += j;
    A.linear += row.d * (j * A.inv_M);
    B.linear -= row.d * (j * B.inv_M);
    A.angular += lever[0] * j;
    B.angular += lever[1] * j;
}

inline DirectVector in_double(const scalar* from) {
    return {static_cast<wide_scalar>(from[0]), static_cast<wide_scalar>(from[1]), static_cast<wide_scalar>(from[2])};
}
inline DirectVector in_double(const Vector& from) {
    return {static_cast<wide_scalar>(from.x), static_cast<wide_scalar>(from.y), static_cast<wide_scalar>(from.z)};
}
inline void put_scalars(scalar (&to)[4], const DirectVector& from) {
    to[0] = static_cast<scalar>(from.x);
    to[1] = static_cast<scalar>(from.y);
    to[2] = static_cast<scalar>(from.z);
}

} }  // namespace ingot
