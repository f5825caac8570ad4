// SPDX-License-Identifier: MIT
// The rows of `lanes` manifolds, which share no body that can move.
#pragma once

#include "../narrow_phase/manifold.h"
#include "friction.h"
#include "normals.h"
#include "torsion.h"

namespace ingot { inline namespace INGOT_ABI {

struct ContactBlock {
    Index body_A[lanes], body_B[lanes];  ///< of SolverBody
    Index manifold[lanes];               ///< no_manifold in a spare lane
    Index island[lanes];                 ///< of SolverView::islands
    uint8_t sum_i[lanes];                ///< which of the eight sums of its island its change is added to
    uint8_t halvings[lanes];             ///< of the manifold
    uint16_t turning, moving;            ///< bit per lane: a body turns far; and the rows are of where it is then: see refresh_blocks.h
    uint16_t noted;                      ///< bit per lane: what has been found of it is still to be told to its island, or its bodies
    LaneRow refreshed_at;                ///< substeps from the begin of the step to the moment that the rows are of
    uint8_t rows;                        ///< 1 where no manifold of the block has more points, else block_rows
    bool central;                        ///< one row, and no normal has a lever: balls
    LaneRow inv_M_A, inv_M_B;            ///< kg^-1
    LaneRow n[3], t_1[3], t_2[3];
    LaneRow mu, e;     ///< friction, restitution
    LaneRow substeps;  ///< the manifold has lived
    LaneRow change;    ///< J, of the sweep: sum of (change of impulse)^2 times compliance
    LaneRow fastest;   ///< m/s, of the sweep: the largest speed that it corrected
    FrictionRows friction;
    LaneRow count;               ///< of its points
    LaneRow K[10];               ///< compliance of the normals
    LaneRow cached_inverse[10];  ///< and its inverse without the rows that were out at the last visit; see solve_block
    NormalRow row[block_rows];   ///< what blocks of one row do not use comes last
    TorsionRow torsion;
};

inline constexpr Index no_manifold = index_max;
/// Whether that is the manifold of a lane. A block of one lane has no spare ones.
INGOT_INLINE bool is_spare(Index manifold_i) { return lanes > 1 && manifold_i == no_manifold; }

} }  // namespace ingot
