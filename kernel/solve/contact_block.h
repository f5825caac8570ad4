// SPDX-License-Identifier: MIT
// The rows of `lanes` manifolds, which share no body that can move.
//
// With J = r x n and k = inv_I_world J, symmetric inertia gives n.(omega x r) = L.k. The velocity sweep reads v_CM and L, and adds n j inv_M and
// J j; its mirror image, the position sweep, reads dp and dth with J, and adds n q inv_M and k q. The same numbers serve both.
#pragma once

#include "../collide/manifold.h"
#include "block_solve.h"
#include "solver_body.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where a row takes hold of the two bodies. B gets the opposite impulse: its levers carry the minus sign, J_B = -(r_BP x n).
struct Levers {
    scalar J_A[3][lanes], J_B[3][lanes];  ///< m
    scalar k_A[3][lanes], k_B[3][lanes];  ///< inv_I_world J
};

struct ContactBlock {
    uint16_t body_A[lanes], body_B[lanes];  ///< of SolverBody
    uint16_t manifold[lanes];               ///< no_manifold in a spare lane
    int rows;                               ///< 1 where no manifold of the block has more points, else block_rows
    scalar inv_M_A[lanes], inv_M_B[lanes];  ///< kg^-1
    scalar n[3][lanes], t_1[3][lanes], t_2[3][lanes];

    Levers normal[block_rows];
    scalar K[10][lanes], B[10][lanes];           ///< compliance of the normals, and its inverse with 1.01 of the diagonal
    scalar held[10][lanes], held_position[10][lanes];  ///< B without the rows that were out at the last visit; see solve_block
    scalar separation[block_rows][lanes];        ///< m, at the begin of the step
    scalar target[block_rows][lanes];            ///< m/s, of the substep
    scalar position[block_rows][lanes];          ///< m, of a point that bounced: where it is at the end of the substep
    scalar bounces[block_rows][lanes];           ///< 1 where a point bounces in this substep
    scalar j[block_rows][lanes];                 ///< N s
    scalar j_before[block_rows][lanes];          ///< of the substep before

    Levers friction[2];                          ///< at the middle of the points, along t_1 and t_2
    scalar K_friction[2][lanes];                 ///< of the pair: 11, 22
    scalar inv_K_friction[3][lanes];             ///< of the pair: 11, 12, 22
    scalar j_friction[2][lanes], j_reference[2][lanes];
    scalar k_twist_A[3][lanes], k_twist_B[3][lanes];  ///< inv_I_world n, and its opposite
    scalar K_twist[lanes], inv_K_twist[lanes];
    scalar j_twist[lanes];                       ///< N m s
    scalar mu[lanes], twist_radius[lanes];       ///< friction torque <= mu N radius
    scalar e[lanes];                             ///< restitution
    scalar steps[lanes];                         ///< substeps this manifold has lived, up to 16

    /// Conjugate gradients: direction, and impulses before the sweep, of the four normals, the pair and the twist.
    scalar direction[7][lanes], j_sweep[7][lanes];
    scalar change[lanes];  ///< of the sweep: sum of (change of impulse)^2 times compliance
};

inline constexpr uint16_t no_manifold = 65535;

} }  // namespace ingot
