// SPDX-License-Identifier: MIT
#include "keep_figures.h"

#include "../base/limits.h"
#include "../body/kinematics.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// h j.s over the least moment of inertia: (omega h)^2 of the turning back by tension.
template <unsigned width, class T = typename AllLanes<width>::T>
T tension_of(const FigureRows<width>& rows, const FigureRow<width>& row, const Vec3<T>& j, const Vec3<T>& arm, scalar h) {
    const Vec3<T> I = read(rows.all, row.I_body);
    return dot(j, arm) * splat<T>(h) / min(I.x, min(I.y, I.z));
}

uint8_t doublings_for(scalar tension, scalar turn_sq) {
    uint8_t doublings = 0;
    for (int i = 0; i < limits::doublings_max; ++i) {
        const scalar turn = limits::turn_of_doublings[i];
        if (tension > limits::tension_of_doublings[i] || turn_sq > turn * turn) doublings = static_cast<uint8_t>(i + 1);
    }
    return doublings;
}

template <unsigned width>
void see_tension_of_loops(const FigureRows<width>&, const NoLoops&, scalar (&)[width], scalar, scalar) {}
template <unsigned width>
void see_tension_of_loops(const FigureRows<width>& rows, const LoopView& loops, scalar (&tensions)[width], scalar h, scalar scale) {
    for_looped(rows, loops, [&](const LoopFigure& of, int lane_i) {
        const auto see = [&](Index node_i, const Vector& j, const Vector& arm) {
            const auto moments = [](const auto& of_node, const auto& at, int row_i) { return read(at, of_node[row_i].I_body); };
            const Vector I = at_node(rows.view, node_i, moments);
            tensions[lane_i] = max(tensions[lane_i], dot(j, arm) * h / min(I.x, min(I.y, I.z)));
        };
        for_loop_joints(loops, of, [&](const LoopJoint& loop) {
            see(loop.child, loop.given * scale, loop.arm);
            if (loop.other != no_node) see(loop.other, loop.given * -scale, loop.arm_of_other);
        });
    });
}

template <unsigned width, class Loops, class T = typename AllLanes<width>::T>
void ask_of_rows(const FigureRows<width>& rows, const Loops& loops, scalar h, scalar scale) {
    T most{}, most_turn{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        const FigureNode& node = rows.node(row_i);
        const FigureRow<width>& row = rows[row_i];
        most_turn = max(most_turn, length_sq(read(rows.all, row.w)) * splat<T>(h * h));
        if (node.kind == JointKind::none) continue;
        const Vec3<T> j = read(rows.all, row.j) * splat<T>(scale);
        most = max(most, tension_of(rows, row, j, -read(rows.all, row.c), h));
        if (node.parent != no_node) most = max(most, tension_of(rows, rows[node.parent], -j, read(rows.all, row.arm_of_parent), h));
    }
    scalar tensions[width], turns[width];
    rows.all.put(tensions, most);
    rows.all.put(turns, most_turn);
    see_tension_of_loops(rows, loops, tensions, h, scale);
    for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i)  // bound: lanes
        rows.figure(lane_i).doublings = doublings_for(tensions[lane_i], rows.figure(lane_i).resolved ? 0 : turns[lane_i]);
}

/// False for what has gone bad, too: it stays where it was, and freezes.
bool is_in_range(const Vector& r, const Matrix& A, const Vector& v, const Vector& w) {
    const scalar most = limits::speed_runaway;
    return is_finite(r) && is_finite(A) && abs(v.x) <= most && abs(v.y) <= most && abs(v.z) <= most && is_within_runaway(w);
}

template <unsigned width>
void keep_row(const FigureRows<width>& rows, int row_i, int lane_i, scalar scale) {
    const OneLane<width> at{lane_i};
    const BodyView& bodies = rows.view.bodies;
    const FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i, lane_i);
    const Place place = place_of(node.slot);
    RotationTile& rotation = bodies.rotation[place.tile];
    TranslationTile& translation = bodies.translation[place.tile];
    if (!is_in_range(read(at, row.r), read(at, row.A), read(at, row.v), read(at, row.w))) return mark_lane_bad(rotation.bad, place.lane);
    set_lane(translation.r_CM, place.lane, read(at, row.r));
    const Vector change = read(at, row.v) - lane_of(translation.v_CM, place.lane);
    set_lane(translation.F_T, place.lane, (change * (1 / rows.view.h) - rows.view.gravity) * at.get(row.M));  // the mean of the step: for sleep
    set_lane(translation.v_CM, place.lane, read(at, row.v));
    set_lane(rotation.A, place.lane, read(at, row.A));
    set_lane(rotation.L, place.lane, read(at, row.L));
    if (bodies.compensation != nullptr) set_lane(bodies.compensation[place.tile].A_low, place.lane, Matrix{});
    if (bodies.energy != nullptr) bodies.energy[place.tile].E_0[place.lane] = 0;
    if (node.kind == JointKind::none) return;
    JointRecord& joint = rows.view.lists.joints[node.joint];
    joint.j = read(at, row.j) * (node.is_A ? -scale : scale);
    joint.resolved = rows.figure(lane_i).resolved ? 1 : 0;
    joint.doublings = rows.figure(lane_i).doublings;
}

}  // namespace

template <class Loops>
void ask_for_doublings(const FigureView& view, const Loops& loops, scalar h, int doublings) {
    const auto scale = static_cast<scalar>(1 << doublings);
    for_groups(view, [&](const auto& rows) { ask_of_rows(rows, loops, h, scale); });
}

// The linker takes the one that the scene calls.
template void ask_for_doublings(const FigureView&, const NoLoops&, scalar, int);
template void ask_for_doublings(const FigureView&, const LoopView&, scalar, int);

void keep_figures(const FigureView& view, int doublings) {
    const auto scale = static_cast<scalar>(1 << doublings);
    for_groups(view, [&](const auto& rows) {
        for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) {  // bound: lanes
            if (rows.figure(lane_i).doublings > doublings) continue;
            for (int row_i = 0; row_i < rows.count(); ++row_i) keep_row(rows, row_i, lane_i, scale);  // bound: max_bodies
        }
    });
}

} }  // namespace ingot

#pragma GCC diagnostic pop
