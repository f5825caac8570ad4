// SPDX-License-Identifier: MIT
#include "../math/sqrt.h"
#include "close_loops.h"
#include "ground.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// (m/s)^2, of the fastest body of a figure if it goes with what turns below it as if it was one with that.
scalar carried_speed_sq(const FigureView& view, const Figure& figure) {
    const Ground<scalar> at = ground_at(view, figure.ground);
    if (!(length_sq(at.w) > 0)) return length_sq(at.v);
    scalar most_sq = 0;
    for (int node_i = figure.first_node; node_i < figure.first_node + figure.node_count; ++node_i)  // bound: max_bodies
        at_node(view, static_cast<Index>(node_i), [&](const auto& rows, const auto& lane, int row_i) {
            const Vector I = read(lane, rows[row_i].I_body);
            const Vector v = at.v + cross(at.w, read(lane, rows[row_i].r) - at.r);
            most_sq = max(most_sq, length_sq(v) + length_sq(at.w) * max(I.x, max(I.y, I.z)) / lane.get(rows[row_i].M));
        });
    return most_sq;
}

}  // namespace

scalar driven_speed(const FigureView& view, const LoopView& loops, const LoopFigure& of) {
    scalar most_sq = 0;
    const auto see = [&](Index ground) {
        const Ground<scalar> at = ground_at(view, ground);
        most_sq = max(most_sq, length_sq(at.v));
    };
    for_loop_joints(loops, of, [&](const LoopJoint& loop) {
        if (loop.other == no_node) see(loop.ground);
        if (loop.kind == JointKind::gear) {
            const scalar driven = loops.gear_motions[loop.joint].driven;
            most_sq = max(most_sq, driven * driven);
        }
        if (!has_length(loop.kind)) return;
        const TieRecord& tie = loops.ties[loop.joint];
        const scalar reeled = (tie.reeled - tie.begin) / view.h;
        most_sq = max(most_sq, reeled * reeled);
    });
    for (int i = of.figure; i < of.figure + of.figure_count; ++i)  // bound: max_bodies
        most_sq = max(most_sq, carried_speed_sq(view, view.figures[i]));
    return sqrt(most_sq);
}

} }  // namespace ingot
