// SPDX-License-Identifier: MIT
#include "move_figures.h"

#include "../base/figure_limits.h"
#include "../body/kinematics.h"
#include "../math/sqrt.h"
#include "close_loops.h"
#include "measure_joint.h"
#include "push_machines.h"
#include "push_rows.h"
#include "target_rows.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

template <unsigned width>
using T_of_width = typename AllLanes<width>::T;

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

/// J; of the bodies of a figure, with what `change` would make of it.
template <class T>
struct FigureEnergies {
    T before, after;
};
template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
FigureEnergies<T> figure_energies_of(const FigureRows<width, Kinds>& rows) {
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

template <unsigned width, class Kinds>
T_of_width<width> mass_of(const FigureRows<width, Kinds>& rows) {
    T_of_width<width> M{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) M = M + rows.all.get(rows[row_i].M);  // bound: max_bodies
    return M;
}

/// What a figure would have with its targets, and what it may have.
template <unsigned width, class Kinds, class T = T_of_width<width>>
auto gaining_lanes(const FigureRows<width, Kinds>& rows, const FigureEnergies<T>& energies, T M, scalar h, scalar gain = limits::target_gain) {
    const scalar gap_speed = limits::joint_gap * rows.view.unit / h;
    return energies.after > energies.before * splat<T>(gain) + M * splat<T>(gap_speed * gap_speed);
}

/// They are left as they move; where that is far, they get velocities that fit their joints as they are: on what does not, any impulse would work.
template <unsigned width, class Kinds, class M, class T = T_of_width<width>>
void leave_out_biases(const FigureRows<width, Kinds>& rows, M gains, M is_far) {
    const Vec3<T> none{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        FigureRow<width>& row = rows[row_i];
        const JointKind kind = rows.kind(row_i);
        if (kind == JointKind::none) continue;
        const Spatial<T> bias = read(rows.all, row.bias);
        Spatial<T> off{};
        if (any(is_far)) off = locked_part(rows.all, row, kind, twist_of_joint(rows, rows.all, row_i));
        write(rows.all, row.bias,
              Spatial<T>{select(gains, select(is_far, -off.w, none), bias.w), select(gains, select(is_far, -off.v, none), bias.v)});
    }
}

template <unsigned width, class Kinds>
void pass_alone(const FigureRows<width, Kinds>& rows) {
    clear_impulses(rows);
    pass_up(rows);
    pass_down(rows);
}

/// Lanes whose figures turn by more than limits::far_turn in the substep, or whose joints would be off by more than limits::far_off: arms go on
/// chords, and targets of second order ask for what is no motion any more, whatever the substep before was like.
template <unsigned width, class Kinds>
auto far_lanes(const FigureRows<width, Kinds>& rows, scalar h) {
    using T = T_of_width<width>;
    const T of_turn = splat<T>(1 / (limits::far_turn * limits::far_turn)), of_off = splat<T>(h * h / (limits::far_off * limits::far_off));
    T most{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        most = max(most, length_sq(read(rows.all, rows[row_i].turn)) * of_turn);
        if (rows.node(row_i).kind != JointKind::none) most = max(most, length_sq(read(rows.all, rows[row_i].bias).w) * of_off);
    }
    return most > splat<T>(1);
}

/// Targets of what is not resolved may ask for what cannot be, where joints come near to where they lock: light bodies would get any speed. Where a
/// figure would have more than limits::target_gain times its energy they are left out: velocities then fit the joints, which takes energy, and
/// pushes take back the gaps.
template <unsigned width, class Kinds, class M>
void hold_back_targets(const FigureRows<width, Kinds>& rows, scalar h, M is_exact) {
    const auto is_far = far_lanes(rows, h);
    const auto doubtful = either(opposite(is_exact), is_far);
    if (!any(doubtful)) return;
    pass_alone(rows);
    const auto gains = both(doubtful, gaining_lanes(rows, figure_energies_of(rows), mass_of(rows), h));
    if (any(gains)) leave_out_biases(rows, gains, is_far);
}

/// Lanes whose targets are doubtful where some have loops: these are, as their rows may come near to saying the same.
template <unsigned width, class Kinds>
auto doubtful_lanes(const FigureRows<width, Kinds>& rows, const LoopView& loops, scalar h) {
    using T = T_of_width<width>;
    scalar flags[width];
    for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) flags[lane_i] = rows.figure(lane_i).resolved ? 0 : 1;  // bound: lanes
    for_looped(rows, loops, [&](const LoopFigure& of, int lane_i) { flags[lane_i] = of.row_count > 0 ? 1 : flags[lane_i]; });
    return either(rows.all.get(flags) > T{}, far_lanes(rows, h));
}

/// The energies of a figure, and its mass, stand in FigureRow::drive of its root until the solve begins: a machine gains or not as a whole.
template <unsigned width, class Kinds>
void note_energies(const FigureRows<width, Kinds>& rows) {
    const FigureEnergies<T_of_width<width>> energies = figure_energies_of(rows);
    write(rows.all, rows[0].drive, Vec3<T_of_width<width>>{energies.before, energies.after, mass_of(rows)});
}
void share_energies(const FigureView& view, const LoopFigure& of) {
    if (of.figure_count == 1) return;
    Vector sum{};
    for_figures_of(view, of, [&](const auto& rows, const auto& at) { sum = sum + read(at, rows[0].drive); });
    for_figures_of(view, of, [&](const auto& rows, const auto& at) { write(at, rows[0].drive, sum); });
}

/// What drives a machine from outside, that moves or is reeled, may give it its speed: this adds to what it has.
void allow_driven_speed(const FigureView& view, const LoopFigure& of, scalar speed) {
    for_figures_of(view, of, [&](const auto& rows, const auto& at) {
        const Vector energies = read(at, rows[0].drive);
        write(at, rows[0].drive, Vector{energies.x + energies.z * (speed * speed), energies.y, energies.z});
    });
}

/// The same of scenes with loops.
void hold_back_targets(const FigureView& view, const LoopView& loops, scalar h, scalar gain) {
    for_groups(view, [&](const auto& rows) {
        if (any(doubtful_lanes(rows, loops, h))) pass_alone(rows);
    });
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        find_lacks(view, loops, of, false);
        close_loops(view, loops, of);
    });
    for_groups(view, [&](const auto& rows) {
        if (any(doubtful_lanes(rows, loops, h))) note_energies(rows);
    });
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        if (of.row_count == 0) return;  // servos alone: its figures are by themselves
        share_energies(view, of);
        if (loops.ties != nullptr) allow_driven_speed(view, of, driven_speed(view, loops, of));
    });
    for_groups(view, [&](const auto& rows) {
        const auto doubtful = doubtful_lanes(rows, loops, h);
        if (!any(doubtful)) return;
        const auto of = read(rows.all, rows[0].drive);
        const auto gains = both(doubtful, gaining_lanes(rows, {of.x, of.y}, of.z, h, gain));
        if (!any(gains)) return;
        leave_out_biases(rows, gains, far_lanes(rows, h));
        for_looped(rows, loops, [&](const LoopFigure& of_loops, int lane_i) {
            if ((bits(gains) >> lane_i & 1u) != 0) leave_out_targets(loops, of_loops);
        });
    });
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
        aim_joints(rows, h);
        hold_back_targets(rows, h, resolved_lanes(rows));
        clear_impulses(rows);
    });
}

}  // namespace

void begin_solve(const FigureView& view, const NoLoops&, scalar h) { begin_solve_of_trees<AnyKinds>(view, h); }

namespace {

void aim_machines(const FigureView& view, const LoopView& loops, scalar h, scalar gain) {
    for_groups(view, [h](const auto& rows) { aim_joints(rows, h); });
    for_looped_figures(view, loops, [&](const LoopFigure& of) { aim_loops(view, loops, of, h); });
    hold_back_targets(view, loops, h, gain);
    if (loops.targets != nullptr) for_looped_figures(view, loops, [&](const LoopFigure& of) { aim_targets(view, loops, of, h); });
    clear_solve(view);
}

}  // namespace

void begin_solve(const FigureView& view, const LoopView& loops, scalar h) {
    aim_machines(view, loops, h, loops.ties == nullptr ? limits::target_gain : limits::target_gain_of_machines);
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
