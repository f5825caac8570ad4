// SPDX-License-Identifier: MIT
// Rows of joints beside what they lock: free directions that end. Of scenes whose joints have some.
#pragma once

#include "../joint/limit_record.h"
#include "figure_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of a joint whose free directions may end, in the step at hand: of its child against its parent, in the order in which free_directions has them.
struct JointMotion {
    scalar value[2];  ///< rad, m: where it is; an angle in -pi .. pi
    int32_t turns;    ///< of a hinge, beside value[0]
    scalar j[2];      ///< as in LimitRecord
    scalar leave[2];  ///< as in LimitRecord
    bool returns[2];  ///< it was beyond its end as the step began: it goes back slowly
};

/// A free direction that is near its end. Visited between the contacts of its figure, at the parent of its joint.
struct JointRow {
    Index node;           ///< of the child
    uint8_t direction_i;
    bool rests;           ///< it was at its end as the substep began
    Vector along;         ///< the drive of an impulse of 1 along the row: see FigureRow::drive
    scalar rate_begin;    ///< rad/s, m/s; before the forces of the substep
    scalar rate;          ///< after them
    scalar lower, upper;  ///< by which the solve may change it
    scalar K;             ///< change of the rate by an impulse of 1
    scalar j;             ///< N m s, N s
    scalar change;        ///< rad/s, m/s; of the rate, by the last visit
    scalar j_sweep, direction;  ///< of conjugate gradients
};

/// Without its capacities.
struct JointRowView {
    LimitRecord* limits;         ///< by joint
    AngleRecord* angles;         ///< by joint
    JointMotion* motions;        ///< by joint, of the step at hand
    JointRow* list;              ///< of the substep, figure by figure; room for every direction that may end
    Spatial6Rows<1>* responses;  ///< of every node, as FigureView::rows
    int count;
};

/// Calls each(rows, at, row_i) for every node of the batch that has a joint, figure by figure.
template <class Each>
INGOT_INLINE void for_joints(const FigureView& view, const Each& each) {
    for_groups(view, [&](const auto& rows) {
        for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i)  // bound: lanes
            for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
                if (rows.node(row_i, lane_i).kind == JointKind::none) continue;
                each(rows, rows.one(lane_i), row_i);
            }
    });
}

} }  // namespace ingot
