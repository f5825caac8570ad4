// SPDX-License-Identifier: MIT
// What joints bear in the parts of an energy-momentum step, which knows it by itself.
#pragma once

#include "../figure/note_reactions.h"
#include "at_node.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// From the parent's side of a slider to q, half-way through the part. Of the last move, which passes have not looked at.
template <unsigned width, class T = typename AllLanes<width>::T>
Vec3<T> mean_travel(const AtNode<width>& at) {
    Mat3<T> turn_of_parent = at.step.ground_turn;
    Vec3<T> way = read(at.all, at.newton.dr) + turn_of(read(at.all, at.newton.theta)) * at.own_arm() - at.step.ground_way;
    if (at.has_parent()) {
        turn_of_parent = turn_of(read(at.all, at.parent().newton.theta));
        way = way + at.step.ground_way - read(at.all, at.parent().newton.dr);
    }
    const Vec3<T> arm = read(at.all, at.row.arm_of_parent);
    return read(at.all, at.newton.e_0) - arm + (way - turn_of_parent * arm) * splat<T>(scalar(0.5));
}

/// Once passes have found the end of a part, and before bodies are there.
template <unsigned width>
INGOT_INLINE void note_part(const NewtonStep<width>&, NoReactions) {}
template <unsigned width>
void note_part(const NewtonStep<width>& step, ReactionView all) {
    for (int row_i = 0; row_i < step.figures.count(); ++row_i) {  // bound: max_bodies
        const AtNode<width> at(step, row_i);
        if (!at.has_joint()) continue;
        const bool slides = at.node.kind == JointKind::slider;
        add_reactions(step.figures, row_i, read(at.all, at.newton.f), slides ? mean_travel(at) : Vec3<typename AllLanes<width>::T>{}, all);
    }
}

} }  // namespace ingot

#pragma GCC diagnostic pop
