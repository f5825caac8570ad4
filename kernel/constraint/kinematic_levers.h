// SPDX-License-Identifier: MIT
// What the rows of a contact read of a kinematic body: its spin, by the levers of its partner.
#pragma once

#include "contact.h"

namespace ingot { inline namespace INGOT_ABI {

INGOT_INLINE void set_opposite(LaneRow (&to)[3], int lane_i, const Vector& of) { set_lane(to, lane_i, -of); }

/// k = -J of the partner.
INGOT_INLINE void see_levers(Levers& levers, int lane_i, bool is_A) {
    set_opposite(is_A ? levers.k_A : levers.k_B, lane_i, lane_of(is_A ? levers.J_B : levers.J_A, lane_i));
}

/// The rows of one manifold. is_A: so is the kinematic body. J of a partner along an axis is the axis for A, its opposite for B.
template <class View>
void see_kinematic_rows(const View& solver, int block_i, int lane_i, bool is_A) {
    ContactBlock& block = solver.blocks[block_i];
    for (int row = 0; row < block_rows && row < block.rows; ++row) see_levers(block.row[row].levers, lane_i, is_A);  // bound: 4: block_rows
    for (Levers& levers : block.friction.levers) see_levers(levers, lane_i, is_A);
    const scalar sign = is_A ? scalar(-1) : scalar(1);
    if (block.rows > 1) set_opposite(is_A ? block.torsion.k_A : block.torsion.k_B, lane_i, lane_of(block.n, lane_i) * sign);
    if constexpr (View::rolls) {
        RollingRows& rolling = solver.rolling[block_i];
        set_opposite(is_A ? rolling.k_A[0] : rolling.k_B[0], lane_i, lane_of(block.t_1, lane_i) * sign);
        set_opposite(is_A ? rolling.k_A[1] : rolling.k_B[1], lane_i, lane_of(block.t_2, lane_i) * sign);
    }
}

} }  // namespace ingot
