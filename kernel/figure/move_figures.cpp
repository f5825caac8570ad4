// SPDX-License-Identifier: MIT
#include "move_figures.h"

#include "../base/figure_limits.h"
#include "../body/kinematics.h"
#include "../math/sqrt.h"
#include "close_loops.h"
#include "hold_targets.h"
#include "measure_joint.h"
#include "push_machines.h"
#include "push_rows.h"
#include "target_rows.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// omega of a row from its L, and the turn that it makes in h seconds if it is left alone: h omega + h^2/2 domega/dt.
template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
void predict_turn(const FigureRows<width, Kinds>& rows, FigureRow<width>& row, scalar h) {
    const Mat3<T> A = read(rows.all, row.A);
    const Vec3<T> I = read(rows.all, row.I_body), L_body = transpose_times(A, read(rows.all, row.L));
    const Vec3<T> w_body = unscaled(I, L_body), rate = unscaled(I, cross(L_body, w_body));
    write(rows.all, row.w, A * w_body);
    write(rows.all, row.turn, A * (w_body * splat<T>(h) + rate * splat<T>(h * h / 2)));
}

template <unsigned width, class Kinds, class M>
INGOT_INLINE void set_bias(const FigureRows<width, Kinds>& rows, int row_i, scalar h, M is_exact) {
    const JointKind kind = rows.kind(row_i);
    const auto sides = sides_ahead(rows, rows.all, row_i, h, is_exact, locks_turns(kind));
    write(rows.all, rows[row_i].bias, twist_back(kind, sides) * splat<typename AllLanes<width>::T>(1 / h));
}

/// Lanes whose figures are resolved.
template <unsigned width, class Kinds>
auto resolved_lanes(const FigureRows<width, Kinds>& rows) {
    using T = typename AllLanes<width>::T;
    scalar flags[width];
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i) flags[lane_i] = rows.figure(lane_i).resolved ? 1 : 0;  // bound: lanes
    return rows.all.get(flags) > T{};
}

/// What the joint gave to the body: what it took from the parent, with the sign turned. After the way down.
template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
void note_joint_impulse(const FigureRows<width, Kinds>& rows, int row_i) {
    FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i);
    Spatial<T> f = read(rows.all, row.sent);
    if (node.parent != no_node) {
        const Spatial<T> u = change_of_parent(rows, rows.all, row_i);
        const Spatial6<T> M = read(rows.all, row.inertia);
        f.v = f.v - (rows.kind(row_i) == JointKind::ball ? M.C * u.v : (M * u).v);
    }
    write(rows.all, row.j, -f.v);
}

template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
void end_rows(const FigureRows<width, Kinds>& rows, scalar h) {
    T most{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {
        FigureRow<width>& row = rows[row_i];
        if (rows.node(row_i).kind != JointKind::none) note_joint_impulse(rows, row_i);
        const Spatial<T> u = change_of_centre(rows.all, row);
        write(rows.all, row.v, read(rows.all, row.v) + u.v);
        write(rows.all, row.L, read(rows.all, row.L) + momentum_of_spin(rows.all, row, u.w));
        most = max(most, length_sq(u.w));
    }
    scalar changes[width];
    rows.all.put(changes, most);
    const scalar smooth = limits::resolved_turn / h;
    // bound: lanes
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i) rows.figure(lane_i).resolved = changes[lane_i] <= smooth * smooth;
}

template <unsigned width, class Kinds>
void drift_rows(const FigureRows<width, Kinds>& rows, scalar h) {
    for (int row_i = 0; row_i < rows.count(); ++row_i) {
        FigureRow<width>& row = rows[row_i];
        predict_turn(rows, row, h);
        write(rows.all, row.r, read(rows.all, row.r) + read(rows.all, row.v) * splat<typename AllLanes<width>::T>(h));
        turn_body(rows, row, read(rows.all, row.turn));
        write(rows.all, row.turned, read(rows.all, row.turned) + read(rows.all, row.turn));
    }
}

template <unsigned width, class Kinds>
void aim_joints(const FigureRows<width, Kinds>& rows, scalar h) {
    const auto is_exact = resolved_lanes(rows);
    for (int row_i = 0; row_i < rows.count(); ++row_i) predict_turn(rows, rows[row_i], h);  // bound: max_bodies
    for (int row_i = 0; row_i < rows.count(); ++row_i)
        if (rows.node(row_i).kind != JointKind::none) set_bias(rows, row_i, h, is_exact);
}

/// Where joints hardly let bodies part, a push that parts them would throw the rest of the figure: it is shortened to limits::throw_speed and
/// limits::push_turn, of all of the figure, so that joints hold as they did.
template <unsigned width, class Kinds>
void shorten_throws(const FigureRows<width, Kinds>& rows, scalar h) {
    using T = typename AllLanes<width>::T;
    const scalar way = limits::throw_speed * rows.view.unit * h;
    const T of_way = splat<T>(1 / (way * way)), of_turn = splat<T>(1 / (limits::push_turn * limits::push_turn)), one = splat<T>(1);
    T most{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        const Spatial<T> u = change_of_centre(rows.all, rows[row_i]);
        most = max(most, max(length_sq(u.v) * of_way, length_sq(u.w) * of_turn));
    }
    const auto is_thrown = most > one;
    if (!any(is_thrown)) return;
    const T share = select(is_thrown, sqrt(one / max(most, one)), one);
    for (int row_i = 0; row_i < rows.count(); ++row_i) write(rows.all, rows[row_i].change, read(rows.all, rows[row_i].change) * share);
}

}  // namespace

namespace {

template <class Kinds>
void begin_solve_of_trees(const FigureView& view, scalar h) {
    for_groups<Kinds>(view, [h](const auto& rows) {
        find_parted(rows);
        aim_joints(rows, h);
        if constexpr (may_be_universal<Kinds>)
            if (has_universal_joint(rows)) share_targets(rows, h, rows.all_lanes());
        hold_back_targets(rows, h, resolved_lanes(rows));
        clear_impulses(rows);
    });
}

}  // namespace

void begin_solve(const FigureView& view, const NoLoops&, scalar h) { begin_solve_of_trees<AnyKinds>(view, h); }

namespace {

void aim(const FigureView& view, const LoopView& loops, scalar h) {
    find_parted(view, loops);
    for_groups(view, [h](const auto& rows) { aim_joints(rows, h); });
    for_looped_figures(view, loops, [&](const LoopFigure& of) { aim_loops(view, loops, of, h); });
    share_targets(view, loops, h);
    measure_targets(view, loops, h);
}

void aim_machines(const FigureView& view, const LoopView& loops, scalar h, scalar gain) {
    aim(view, loops, h);
    if (fit_taut_machines(view, loops, h, gain)) measure_targets(view, loops, h);
    hold_back_targets(view, loops, h, gain);
    if (loops.targets != nullptr) for_looped_figures(view, loops, [&](const LoopFigure& of) { aim_targets(view, loops, of, h); });
    clear_solve(view);
}

}  // namespace

void begin_solve(const FigureView& view, const LoopView& loops, scalar h) {
    aim_machines(view, loops, h, limits::target_gain_of_machines);
}
void begin_flight_solve(const FigureView& view, const NoLoops& loops, scalar h, bool) { begin_solve(view, loops, h); }
void begin_flight_solve(const FigureView& view, const NoLoopsOfHinges&, scalar h, bool) { begin_solve_of_trees<HingesAlone>(view, h); }
void begin_flight_solve(const FigureView& view, const LoopView& loops, scalar h, bool driven) {
    aim_machines(view, loops, h, driven && loops.ties == nullptr ? limits::target_gain : limits::target_gain_of_machines);
}

void clear_solve(const FigureView& view) {
    for_groups(view, [](const auto& rows) { clear_impulses(rows); });
}

void begin_passing(const FigureView& view) {
    for_groups(view, [](const auto& rows) {
        const auto none = rows.no_twist();
        for (int row_i = 0; row_i < rows.count(); ++row_i) write(rows.all, rows[row_i].impulse, none);  // bound: max_bodies
        take_cursor(rows);
    });
}

void add_impulse(const FigureView& view, Index node_i, const Vector& F, const Vector& T) {
    at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) {
        const Spatial<scalar> f = {T + cross(read(at, rows[row_i].c), F), F};
        write(at, rows[row_i].impulse, read(at, rows[row_i].impulse) + f);
    });
}

template <class Kinds>
void pass_impulses(const FigureView& view) {
    for_groups<Kinds>(view, [](const auto& rows) {
        pass_up(rows);
        pass_down(rows);
    });
}

template <class Kinds>
void end_solve(const FigureView& view, scalar h) {
    for_groups<Kinds>(view, [h](const auto& rows) { end_rows(rows, h); });
}

template <class Kinds>
void drift_figures(const FigureView& view, scalar h) {
    for_groups<Kinds>(view, [h](const auto& rows) { drift_rows(rows, h); });
}

// The linker takes the one that the scene calls.
#define INGOT_KINDS(Kinds)                                       \
    template void pass_impulses<Kinds>(const FigureView&);       \
    template void end_solve<Kinds>(const FigureView&, scalar);   \
    template void drift_figures<Kinds>(const FigureView&, scalar)
INGOT_KINDS(AnyKinds);
INGOT_KINDS(HingesAlone);
#undef INGOT_KINDS

void begin_displacing(const FigureView& view) {
    for_groups(view, [](const auto& rows) {
        const auto none = rows.no_twist();
        for (int row_i = 0; row_i < rows.count(); ++row_i) {
            write(rows.all, rows[row_i].bias, none);
            write(rows.all, rows[row_i].sent, none);
            write(rows.all, rows[row_i].change, none);
        }
        clear_impulses(rows);
        take_cursor(rows);
    });
}

void end_displacing(const FigureView& view, scalar h) {
    for_groups(view, [h](const auto& rows) {
        shorten_throws(rows, h);
        move_by_change(rows, rows.all_lanes());
    });
}

void push_figures(const FigureView& view, const NoLoops&, bool again) {
    for_groups(view, [again](const auto& rows) { push_group(rows, again); });
}
void push_figures(const FigureView& view, const NoLoopsOfHinges&, bool again) {
    for_groups<HingesAlone>(view, [again](const auto& rows) { push_group(rows, again); });
}
void push_figures(const FigureView& view, const LoopView& loops, bool again) { push_machines(view, loops, again); }

} }  // namespace ingot

#pragma GCC diagnostic pop
