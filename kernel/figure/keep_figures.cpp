// SPDX-License-Identifier: MIT
#include "keep_figures.h"

#include "../base/figure_limits.h"
#include "../body/kinematics.h"
#include "universal_joints.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// h j.s over the least moment of inertia: (omega h)^2 of the turning back by tension.
template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
T tension_of(const FigureRows<width, Kinds>& rows, const FigureRow<width>& row, const Vec3<T>& j, const Vec3<T>& arm, scalar h) {
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

/// What its universal joints have noted: see hold_targets.h.
template <unsigned width, class Kinds>
void ask_of_universal_joints(const FigureRows<width, Kinds>& rows, int row_i) {
    for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) {  // bound: lanes
        const uint8_t noted = rows.view.lists.joints[rows.node(row_i, lane_i).joint].doublings;
        if (noted > rows.figure(lane_i).doublings) rows.figure(lane_i).doublings = noted;
    }
}

template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
void ask_of_rows(const FigureRows<width, Kinds>& rows, scalar h, scalar scale) {
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
    for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i)  // bound: lanes
        rows.figure(lane_i).doublings = doublings_for(tensions[lane_i], rows.figure(lane_i).resolved ? 0 : turns[lane_i]);
    if constexpr (may_be_universal<Kinds>)
        for (int row_i = 0; row_i < rows.count(); ++row_i)  // bound: max_bodies
            if (rows.kind(row_i) == JointKind::universal) ask_of_universal_joints(rows, row_i);
}

/// By its pull a rod or a rope holds what hangs on it in its line, as a string does: j / m times its length. kg^-1 N s / m.
scalar tension_across(const FigureView& view, const LoopJoint& loop) {
    const auto M_of = [&](Index node_i) {
        return at_node(view, node_i, [](const auto& rows, const auto& at, int row_i) { return at.get(rows[row_i].M); });
    };
    scalar inv_M = 1 / M_of(loop.child);
    if (loop.other != no_node) inv_M += 1 / M_of(loop.other);
    return -dot(loop.given, loop.direction[0]) * inv_M / loop.length;
}

/// By how much the line of a rod or a rope turns in h seconds, rad, squared.
scalar turn_of_line(const FigureView& view, const LoopJoint& loop, scalar h) {
    const auto speed_of = [&](Index node_i, const Vector& arm) {
        return at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) {
            return read(at, rows[row_i].v) + cross(read(at, rows[row_i].w), arm);
        });
    };
    const Vector of_child = speed_of(loop.child, loop.arm);
    const Vector apart = loop.other == no_node ? of_child : of_child - speed_of(loop.other, loop.arm_of_other);
    const scalar along = dot(apart, loop.direction[0]), turn = h / loop.length;
    return (length_sq(apart) - along * along) * (turn * turn);
}

void ask_of_loops(const FigureView&, const NoLoops&, scalar, int) {}
/// All figures of a machine are cut alike. batch: doublings of this one.
void ask_of_loops(const FigureView& view, const LoopView& loops, scalar h, int batch) {
    const auto scale = static_cast<scalar>(1 << batch);
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        scalar most = 0, most_turn = 0;
        const auto see = [&](Index node_i, const Vector& j, const Vector& arm) {
            const auto moments = [](const auto& rows, const auto& at, int row_i) { return read(at, rows[row_i].I_body); };
            const Vector I = at_node(view, node_i, moments);
            most = max(most, dot(j, arm) * h / min(I.x, min(I.y, I.z)));
        };
        for_loop_joints(loops, of, [&](const LoopJoint& loop) {
            see(loop.child, loop.given * scale, loop.arm);
            if (loop.other != no_node) see(loop.other, loop.given * -scale, loop.arm_of_other);
            if (!has_length(loop.kind) || loop.is_slack) return;
            most = max(most, tension_across(view, loop) * h * scale);
            most_turn = max(most_turn, turn_of_line(view, loop, h));
        });
        uint8_t doublings = doublings_for(most, most_turn);
        if (loops.ties != nullptr && of.was_apart && batch < limits::doublings_max && doublings <= batch)
            doublings = static_cast<uint8_t>(batch + 1);
        for (int i = of.figure; i < of.figure + of.figure_count; ++i)  // bound: max_bodies
            if (view.figures[i].doublings > doublings) doublings = view.figures[i].doublings;
        for (int i = of.figure; i < of.figure + of.figure_count; ++i) view.figures[i].doublings = doublings;
    });
}

/// False for what has gone bad, too: it stays where it was, and freezes.
bool is_in_range(const Vector& r, const Matrix& A, const Vector& v, const Vector& w) {
    const scalar most = limits::speed_runaway;
    const scalar far = limits::position_max;
    if (!(abs(r.x) <= far && abs(r.y) <= far && abs(r.z) <= far)) return false;
    return is_finite(A) && abs(v.x) <= most && abs(v.y) <= most && abs(v.z) <= most && is_within_runaway(w);
}

template <unsigned width, class Kinds>
void keep_row(const FigureRows<width, Kinds>& rows, int row_i, int lane_i, scalar scale) {
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
    for_groups<typename Loops::Kinds>(view, [&](const auto& rows) { ask_of_rows(rows, h, scale); });
    ask_of_loops(view, loops, h, doublings);
}

// The linker takes the one that the scene calls.
template void ask_for_doublings(const FigureView&, const NoLoops&, scalar, int);
template void ask_for_doublings(const FigureView&, const NoLoopsOfHinges&, scalar, int);
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
