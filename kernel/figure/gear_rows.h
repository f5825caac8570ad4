// SPDX-License-Identifier: MIT
// Gears: one row that couples the ways of two joints, q_A and q_B, of hinges, wheels and sliders.
//
//     C = (q_B - b_B) - ratio (q_A - b_A) = 0,      b: where they were as they were coupled
//
// The row is of up to four bodies, the sides of both joints, and stands among those of loops: U, C = J U and z of a machine are as of any other
// (loop_view.h). It is scaled so that the larger of its two parts is 1. A hinge's way is kept as an angle in half a turn either way and whole
// turns, and turns are subtracted by themselves, in double, where products of a ratio in float are exact: so C has the rounding of an angle however
// far both have gone.
#pragma once

#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// A batch begins: the ways that the joints have gone are those of the last step.
void begin_gear(const LoopView& loops, const LoopJoint& loop);
/// Its row as the bodies are now, and how far the joints have gone. Needs: place_joints, FigureRow::w.
void place_gear(const FigureView& view, const LoopView& loops, const LoopFigure& of, LoopJoint& loop);
/// By how much C would change in a substep of h seconds, if nothing acted; with the sign turned, over h.
void aim_gear(const FigureView& view, const LoopView& loops, LoopJoint& loop, bool is_exact, scalar h);
/// C now, with the sign turned.
scalar way_back_of_gear(const FigureView& view, const LoopView& loops, const LoopJoint& loop);
/// The step has ended: it remembers where its joints are.
void keep_gear(const LoopView& loops, const LoopJoint& loop);

/// As its joints are, they are coupled: whole turns are counted from now on.
void couple(const BodyView& bodies, const JointRecord* joints, GearRecord& gear);
/// A body of each of its joints that can move, as its own.
void name_bodies(const BodyView& bodies, const JointLists& lists, const GearRecord& gear, JointRecord& record);
/// rad, m: how far B is from where A and the ratio want it.
scalar gap_of(const BodyView& bodies, const JointRecord* joints, const GearRecord& gear);

/// A step begins: gears whose joints do nothing are slack, and are coupled anew; the others hang by bodies that can move.
/// Cost: a look at all joints; about 200 flops a gear that is slack.
void look_at_gears(const BodyView& bodies, const JointLists& lists, GearRecord* gears, TieRecord* ties, int joint_slots);

/// Calls each(node_i, f) for the bodies that a row acts on, with what a unit impulse along it is on them.
template <class Each>
INGOT_INLINE void for_bodies_of(const LoopView& loops, const LoopJoint& loop, int row, const Each& each) {
    if (loop.kind == JointKind::gear) {
        const GearMotion& motion = loops.gear_motions[loop.joint];
        for (int i = 0; i < motion.count; ++i) each(motion.node[i], motion.on[i]);  // bound: 4
        return;
    }
    each(loop.child, loop.rows[row].on_child);
    if (loop.other != no_node) each(loop.other, loop.rows[row].on_other);
}

} }  // namespace ingot
