// SPDX-License-Identifier: MIT
// Rows of joints beside what they lock: free directions that end. Of scenes whose joints have some.
#pragma once

#include "../joint/drives.h"
#include "../joint/limit_record.h"
#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of a joint whose free directions may end, in the step at hand: of its child against its parent, in the order in which free_directions has them.
struct JointMotion {
    scalar value[2];  ///< rad, m: where it is; an angle in -pi .. pi
    int32_t turns;    ///< of a hinge, beside value[0]
    scalar j[2];      ///< as in LimitRecord
    scalar leave[2];  ///< as in LimitRecord
    bool returns[2];  ///< it was beyond its end as the step began: it goes back slowly
};

/// Of a driven direction, in the step at hand: of the child against its parent; of a ball joint in world axes.
struct DriveMotion {
    scalar inertia;   ///< kg m^2, kg: what it moves, with all of the figure, without drives
    scalar resist;    ///< N m s: by how much less an impulse it gives for each rad/s that it is faster
    scalar spring;    ///< N m s: the same for each rad that it is further
    scalar pull;      ///< N m s: what it gives if its rate does not change
    scalar j;         ///< N m s, in the last substep
    scalar sum;       ///< N m s, of the step
    bool saturated;   ///< it has turned out to be at its largest torque in this substep
};

/// A free direction that is near its end; or one that is driven. Visited between the contacts of its figure, at the parent of its joint.
struct JointRow {
    Index node;           ///< of the child; of a joint that closes a loop: which of LoopView::joints
    uint8_t direction_i;
    bool closes;          ///< its joint closes a loop
    bool rests;           ///< it was at its end as the substep began
    bool is_drive;        ///< K is 0 then, and j what the drive gives beside what it resists, unless it is saturated
    bool gave_way;        ///< the last saturate_drives has found it beyond its largest torque
    bool stands;          ///< other islands are solved again, and its own is not
    Vector along;         ///< the drive of an impulse of 1 along the row: see FigureRow::drive
    /// rad/s, m/s; before the forces of the substep. Of the three rows of a ball joint's drive that is at its largest torque: what an impulse of 1 on
    /// this one changes of the rate of the next
    scalar rate_begin;
    scalar rate;          ///< after them; and of the one after the next
    scalar lower, upper;  ///< by which the solve may change it
    scalar K;             ///< change of the rate by an impulse of 1; 0: it is not visited
    scalar gamma;         ///< of a drive: by how much the bounds of the change give way to an impulse of 1
    scalar most;          ///< N m s, N s: the largest impulse
    scalar j;             ///< N m s, N s
    scalar change;        ///< rad/s, m/s; of the rate, by the last visit
    scalar j_sweep, direction;  ///< of conjugate gradients
};

/// Without its capacities.
struct JointRowView {
    static constexpr bool has_drives = false, closes = false;

    LimitRecord* limits;         ///< by joint; null: there are none
    AngleRecord* angles;         ///< by joint
    JointMotion* motions;        ///< by joint, of the step at hand
    JointRow* list;              ///< of the substep, figure by figure; room for every direction that may end, and for every drive
    Spatial6Rows<1>* responses;  ///< of every node, as FigureView::rows
    int count;                   ///< of the list
};
/// Of joints that may have drives.
struct DrivenRowView : JointRowView {
    static constexpr bool has_drives = true;

    DriveRecord* drives;         ///< by joint, drives_of_joint each
    DriveMotion* drive_motions;  ///< beside them
    int drives_of_joint;
};

/// Of scenes in which loops are closed, too. One for all: without drives drives_of_joint is 0.
struct LoopedRowView : DrivenRowView {
    static constexpr bool closes = true;

    LoopView* loops;
};

/// How many directions of a joint may end.
INGOT_INLINE int limits_of(const FigureNode& node, const JointRowView& all) {
    return all.limits == nullptr ? 0 : limited_directions(node.kind);
}

/// The drives of a joint, and what they do in the step: as many as it can have at most.
INGOT_INLINE DriveRecord* drives_of(const FigureNode& node, const DrivenRowView& all) { return all.drives + node.joint * all.drives_of_joint; }
INGOT_INLINE DriveMotion& drive_motion(const FigureNode& node, const DrivenRowView& all, int direction_i) {
    return all.drive_motions[node.joint * all.drives_of_joint + direction_i];
}

/// How many directions of a joint may be driven.
INGOT_INLINE int drives_in(JointKind kind, const DrivenRowView&) { return driven_directions(kind); }
INGOT_INLINE int drives_in(JointKind kind, const LoopedRowView& all) { return all.drives_of_joint == 0 ? 0 : driven_directions(kind); }

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
