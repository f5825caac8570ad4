// SPDX-License-Identifier: MIT
// The rows of `lanes` manifolds, which share no body that can move.
//
// With J = r x n and k = inv_I_world J, symmetric inertia gives n.(omega x r) = L.k. The velocity sweep reads v_CM and L, and adds n j inv_M and
// J j; its mirror image, the position sweep, reads dp and dth with J, and adds n q inv_M and k q. The same numbers serve both.
#pragma once

#include "../narrow_phase/manifold.h"
#include "block_solve.h"
#include "solver_body.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where a row takes hold of the two bodies. B gets the opposite impulse: its levers carry the minus sign, J_B = -(r_BP x n).
struct Levers {
    scalar J_A[3][lanes], J_B[3][lanes];  ///< m
    scalar k_A[3][lanes], k_B[3][lanes];  ///< inv_I_world J
};

/// One normal of each lane's manifold.
struct ContactRow {
    Levers levers;
    scalar separation[lanes];  ///< m, at the begin of the step
    scalar target[lanes];      ///< m/s, that A may approach B with in the substep, at least
    scalar landing[lanes];     ///< m, of a point that bounces: its separation at the end of the substep; limits::unbounded: it does not
    scalar j[lanes];           ///< N s
    scalar j_before[lanes];    ///< of the substep before
    scalar j_sweep[lanes], direction[lanes];  ///< conjugate gradients: before the sweep, and the direction so far
};

/// Friction at the middle of the points, along t_1 and t_2: one row each, solved as a pair.
struct FrictionPair {
    Levers levers[2];
    scalar K[2][lanes];        ///< compliance: 11, 22
    scalar inv_K[3][lanes];    ///< inverse of the pair: 11, 12, 22
    scalar inv_K_max[lanes];   ///< inverse of the larger of its two principal values
    scalar j[2][lanes];        ///< N s
    scalar reference[2][lanes];  ///< slow mean of j
    scalar j_sweep[2][lanes], direction[2][lanes];
};

/// The twist about n that an area of contact resists: |j| <= mu N radius.
struct TorsionRow {
    scalar k_A[3][lanes], k_B[3][lanes];  ///< inv_I_world n, and its opposite
    scalar K[lanes], inv_K[lanes], radius[lanes];
    scalar j[lanes], j_sweep[lanes], direction[lanes];  ///< N m s
};

struct ContactBlock {
    uint16_t body_A[lanes], body_B[lanes];  ///< of SolverBody
    uint16_t manifold[lanes];               ///< no_manifold in a spare lane
    uint16_t island[lanes];                 ///< of SolverView::islands
    uint8_t sum_i[lanes];                   ///< which of the eight sums of its island its change is added to
    int rows;                               ///< 1 where no manifold of the block has more points, else block_rows
    bool central;                           ///< one row, and no normal has a lever: balls
    scalar inv_M_A[lanes], inv_M_B[lanes];  ///< kg^-1
    scalar n[3][lanes], t_1[3][lanes], t_2[3][lanes];
    scalar mu[lanes], e[lanes];             ///< friction, restitution
    scalar substeps[lanes];                 ///< the manifold has lived
    scalar change[lanes];                   ///< J, of the sweep: sum of (change of impulse)^2 times compliance
    scalar fastest[lanes];                  ///< m/s, of the sweep: the largest speed that it corrected
    FrictionPair friction;
    scalar count[lanes];                    ///< of its points
    scalar K[10][lanes];                    ///< compliance of the normals
    scalar cached_inverse[10][lanes];       ///< and its inverse without the rows that were out at the last visit; see solve_block
    ContactRow row[block_rows];             ///< what blocks of one row do not use comes last
    TorsionRow torsion;
};

inline constexpr uint16_t no_manifold = 65535;

} }  // namespace ingot
