// SPDX-License-Identifier: MIT
#include "move_figures.h"

#include "../base/limits.h"
#include "../body/kinematics.h"
#include "../math/sqrt.h"
#include "push_rows.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// omega of a row from its L, and the turn that it makes in h seconds if it is left alone: h omega + h^2/2 domega/dt.
template <unsigned width, class T = typename AllLanes<width>::T>
void predict_turn(const FigureRows<width>& rows, FigureRow<width>& row, scalar h) {
    const Mat3<T> A = read(rows.all, row.A);
    const Vec3<T> I = read(rows.all, row.I_body), L_body = transpose_times(A, read(rows.all, row.L));
    const Vec3<T> w_body = unscaled(I, L_body), rate = unscaled(I, cross(L_body, w_body));
    write(rows.all, row.w, A * w_body);
    write(rows.all, row.turn, A * (w_body * splat<T>(h) + rate * splat<T>(h * h / 2)));
}

template <unsigned width, class M>
INGOT_INLINE void set_bias(const FigureRows<width>& rows, int row_i, scalar h, M is_exact) {
    const JointKind kind = rows.node(row_i).kind;
    const auto sides = sides_ahead(rows, rows.all, row_i, h, is_exact, locks_turns(kind));
    write(rows.all, rows[row_i].bias, twist_back(kind, sides) * splat<typename AllLanes<width>::T>(1 / h));
}

/// Lanes whose figures are resolved.
template <unsigned width>
auto resolved_lanes(const FigureRows<width>& rows) {
    using T = typename AllLanes<width>::T;
    scalar flags[width];
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i) flags[lane_i] = rows.figure(lane_i).resolved ? 1 : 0;  // bound: lanes
    return rows.all.get(flags) > T{};
}

/// What the joint gave to the body: what it took from the parent, with the sign turned. After the way down.
template <unsigned width, class T = typename AllLanes<width>::T>
void note_joint_impulse(const FigureRows<width>& rows, int row_i) {
    FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i);
    Spatial<T> f = read(rows.all, row.sent);
    if (node.parent != no_node) {
        const Spatial<T> u = change_of_parent(rows, rows.all, row_i);
        const Spatial6<T> M = read(rows.all, row.inertia);
        f.v = f.v - (node.kind == JointKind::ball ? M.C * u.v : (M * u).v);
    }
    write(rows.all, row.j, -f.v);
}

template <unsigned width, class T = typename AllLanes<width>::T>
void end_rows(const FigureRows<width>& rows, scalar h) {
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

template <unsigned width>
void drift_rows(const FigureRows<width>& rows, scalar h) {
    for (int row_i = 0; row_i < rows.count(); ++row_i) {
        FigureRow<width>& row = rows[row_i];
        predict_turn(rows, row, h);
        write(rows.all, row.r, read(rows.all, row.r) + read(rows.all, row.v) * splat<typename AllLanes<width>::T>(h));
        turn_body(rows, row, read(rows.all, row.turn));
        write(rows.all, row.turned, read(rows.all, row.turned) + read(rows.all, row.turn));
    }
}

/// J; of the bodies of a figure, with what `change` would make of it.
template <class T>
struct FigureEnergies {
    T before, after;
};
template <unsigned width, class T = typename AllLanes<width>::T>
FigureEnergies<T> figure_energies_of(const FigureRows<width>& rows) {
    FigureEnergies<T> sum{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        const FigureRow<width>& row = rows[row_i];
        const Mat3<T> A = read(rows.all, row.A);
        const Vec3<T> I = read(rows.all, row.I_body), v = read(rows.all, row.v), w = transpose_times(A, read(rows.all, row.w));
        const Spatial<T> u = change_of_centre(rows.all, row);
        const Vec3<T> w_after = w + transpose_times(A, u.w);
        const T M = rows.all.get(row.M), half = splat<T>(scalar(0.5));
        sum.before = sum.before + (M * length_sq(v) + dot(scaled(I, w), w)) * half;
        sum.after = sum.after + (M * length_sq(v + u.v) + dot(scaled(I, w_after), w_after)) * half;
    }
    return sum;
}

template <unsigned width>
void leave_out_targets(const FigureRows<width>&, const NoLoops&, unsigned) {}
template <unsigned width>
void leave_out_targets(const FigureRows<width>& rows, const LoopView& loops, unsigned gains) {
    for_looped(rows, loops, [&](const LoopFigure& of, int lane_i) {
        if ((gains >> lane_i & 1u) == 0) return;
        for_loop_joints(loops, of, [](LoopJoint& loop) {
            for (scalar& target : loop.target) target = 0;
        });
    });
}

template <unsigned width>
void aim_rows(const FigureRows<width>&, const NoLoops&, scalar) {}
template <unsigned width>
void aim_rows(const FigureRows<width>& rows, const LoopView& loops, scalar h) {
    for_looped(rows, loops, [&](const LoopFigure& of, int) { aim_loops(rows.view, loops, of, h); });
}

/// Lanes whose targets may be more than they are good for: what is not resolved; and loops, whose rows may come near to saying the same.
template <unsigned width, class M>
auto doubtful_lanes(const FigureRows<width>&, const NoLoops&, M is_exact) {
    return opposite(is_exact);
}
template <unsigned width, class M>
auto doubtful_lanes(const FigureRows<width>& rows, const LoopView& loops, M) {
    using T = typename AllLanes<width>::T;
    scalar flags[width];
    for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) flags[lane_i] = rows.figure(lane_i).resolved ? 0 : 1;  // bound: lanes
    for_looped(rows, loops, [&](const LoopFigure&, int lane_i) { flags[lane_i] = 1; });
    return rows.all.get(flags) > T{};
}

/// Targets of what is not resolved may ask for what cannot be, where joints come near to where they lock: light bodies would get any speed. Where a
/// figure would have more than limits::target_gain times its energy they are left out: velocities then fit the joints, which takes energy, and
/// pushes take back the gaps.
template <unsigned width, class Loops, class M, class T = typename AllLanes<width>::T>
void hold_back_targets(const FigureRows<width>& rows, const Loops& loops, scalar h, M is_exact) {
    const auto doubtful = doubtful_lanes(rows, loops, is_exact);
    if (!any(doubtful)) return;
    clear_impulses(rows);
    pass_up(rows);
    pass_down(rows);
    close_rows(rows, loops);
    const FigureEnergies<T> energies = figure_energies_of(rows);
    T M_all{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) M_all = M_all + rows.all.get(rows[row_i].M);
    const scalar gap_speed = limits::joint_gap * rows.view.unit / h;
    const T allowed = energies.before * splat<T>(limits::target_gain) + M_all * splat<T>(gap_speed * gap_speed);
    const auto gains = both(doubtful, energies.after > allowed);
    if (!any(gains)) return;
    const Spatial<T> none{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {
        const Spatial<T> bias = read(rows.all, rows[row_i].bias);
        write(rows.all, rows[row_i].bias, Spatial<T>{select(gains, none.w, bias.w), select(gains, none.v, bias.v)});
    }
    leave_out_targets(rows, loops, bits(gains));
}

/// Where joints hardly let bodies part, a push that parts them would throw the rest of the figure: it is shortened to limits::throw_speed and
/// limits::push_turn, of all of the figure, so that joints hold as they did.
template <unsigned width>
void shorten_throws(const FigureRows<width>& rows, scalar h) {
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

template <class Loops>
void begin_solve(const FigureView& view, const Loops& loops, scalar h) {
    for_groups(view, [&loops, h](const auto& rows) {
        const auto is_exact = resolved_lanes(rows);
        for (int row_i = 0; row_i < rows.count(); ++row_i) predict_turn(rows, rows[row_i], h);  // bound: max_bodies
        for (int row_i = 0; row_i < rows.count(); ++row_i)
            if (rows.node(row_i).kind != JointKind::none) set_bias(rows, row_i, h, is_exact);
        aim_rows(rows, loops, h);
        hold_back_targets(rows, loops, h, is_exact);
        clear_impulses(rows);
    });
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

void pass_impulses(const FigureView& view) {
    for_groups(view, [](const auto& rows) {
        pass_up(rows);
        pass_down(rows);
    });
}

void end_solve(const FigureView& view, scalar h) {
    for_groups(view, [h](const auto& rows) { end_rows(rows, h); });
}

void drift_figures(const FigureView& view, scalar h) {
    for_groups(view, [h](const auto& rows) { drift_rows(rows, h); });
}

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

template <class Loops>
void push_figures(const FigureView& view, const Loops& loops, bool again) {
    for_groups(view, [&loops, again](const auto& rows) { push_group(rows, loops, again); });
}

// The linker takes the one that the scene calls.
template void begin_solve(const FigureView&, const NoLoops&, scalar);
template void begin_solve(const FigureView&, const LoopView&, scalar);
template void push_figures(const FigureView&, const NoLoops&, bool);
template void push_figures(const FigureView&, const LoopView&, bool);

} }  // namespace ingot

#pragma GCC diagnostic pop
