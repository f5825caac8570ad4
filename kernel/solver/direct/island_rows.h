// SPDX-License-Identifier: MIT
#pragma once

#include "../../base/limits.h"
#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Copies the rows of an island out of the blocks, once a batch: they do not change within it.
void load_rows(const SolverView& solver, const BodyView& bodies, DirectView& direct, int island_i);

inline bool has(uint8_t bits, int row) { return (bits >> row & 1u) != 0; }

/// The impulses of a manifold in its block, and what the sweeps to come take for their last.
template <class Visitor>
void for_impulses(const SolverView& solver, const DirectManifold& manifold, Visitor visit) {
    ContactBlock& block = solver.blocks[manifold.position / lanes];
    const int lane_i = manifold.position % lanes;
    for (int row = 0; row < manifold.points; ++row)  // bound: 4: block_rows
        if (has(manifold.rows, row)) visit(row, block.row[row].j[lane_i], block.row[row].j_sweep[lane_i]);
    for (int axis = 0; axis < 2; ++axis)
        if (has(manifold.rows, friction_row + axis)) visit(friction_row + axis, block.friction.j[axis][lane_i], block.friction.j_sweep[axis][lane_i]);
    if (has(manifold.rows, torsion_row)) visit(torsion_row, block.torsion.j[lane_i], block.torsion.j_sweep[lane_i]);
}

/// Whether two solver bodies are of limits::direct_mass_ratio; what cannot move is of none.
inline bool are_uneven(const SolverView& solver, int body_A, int body_B) {
    const scalar inv_M_A = solver.bodies[body_A].v_CM[3], inv_M_B = solver.bodies[body_B].v_CM[3];
    if (!(inv_M_A > 0) || !(inv_M_B > 0)) return false;
    return inv_M_A > limits::direct_mass_ratio * inv_M_B || inv_M_B > limits::direct_mass_ratio * inv_M_A;
}

/// Speed along a row, or displacement: k reads L where J reads dth.
template <bool displaces>
inline wide_scalar row_motion(const DirectView& island, const DirectManifold& manifold, const DirectRow& row) {
    const DirectBody &A = island.bodies[manifold.body[0]], &B = island.bodies[manifold.body[1]];
    const DirectVector* const lever = displaces ? row.J : row.k;
    return dot(row.d, A.linear - B.linear) + dot(lever[0], A.angular) + dot(lever[1], B.angular);
}

/// Gives an impulse along a row, or a push.
template <bool displaces>
inline void give(const DirectView& island, const DirectManifold& manifold, DirectRow& row, wide_scalar j) {
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
