// SPDX-License-Identifier: MIT
#include "move_figures.h"

#include "../base/limits.h"
#include "../body/kinematics.h"
#include "../math/sqrt.h"
#include "ground.h"
#include "tree_passes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// By how much a turn moves an arm: (R - 1) arm. The angle of R is that of the turn but for its fifth power / 120.
template <class T>
INGOT_INLINE Vec3<T> chord(const Vec3<T>& turn, const Vec3<T>& arm) {
    const Vec3<T> c = turn * (splat<T>(scalar(0.5)) + length_sq(turn) * splat<T>(scalar(1) / 24)), x = cross(c, arm);
    return (x + cross(c, x)) * (splat<T>(2) / (splat<T>(1) + length_sq(c)));
}

/// A body, or the ground, as it turns in the substep: arms move by their chords, or to first order.
template <class T, class M>
struct Turning {
    Vec3<T> turn, w_h;
    M is_exact;

    INGOT_INLINE Vec3<T> shift(const Vec3<T>& arm) const { return select(is_exact, chord(turn, arm), cross(w_h, arm)); }
    INGOT_INLINE Vec3<T> after(const Vec3<T>& arm) const { return arm + shift(arm); }
};

/// Both sides of a joint, in world axes.
template <class T>
struct JointSides {
    Vec3<T> gap;                        ///< m, from the parent's side to the child's
    Vec3<T> axis, axis_of_parent;
    Vec3<T> side, side_of_parent;       ///< of joints that let nothing turn
};

inline bool locks_turns(JointKind kind) { return kind == JointKind::fixed || kind == JointKind::slider; }

/// The twist, times seconds, that takes a joint back to its place. Of an angle between axes that is small.
template <class T>
INGOT_INLINE Spatial<T> twist_back(JointKind kind, const JointSides<T>& of) {
    Spatial<T> back = {Vec3<T>{}, -of.gap};
    if (kind == JointKind::hinge) back.w = cross(of.axis, of.axis_of_parent);
    if (kind == JointKind::universal) {
        const Vec3<T> x = cross(of.axis_of_parent, of.axis);
        back.w = x * (dot(of.axis_of_parent, of.axis) / length_sq(x));
    }
    if (locks_turns(kind)) {
        const Vec3<T> third = cross(of.axis, of.side), third_of_parent = cross(of.axis_of_parent, of.side_of_parent);
        const Vec3<T> sum = cross(of.axis, of.axis_of_parent) + cross(of.side, of.side_of_parent) + cross(third, third_of_parent);
        back.w = sum * splat<T>(scalar(0.5));
    }
    if (kind == JointKind::slider) back.v = of.axis_of_parent * dot(of.gap, of.axis_of_parent) - of.gap;
    return back;
}

/// omega of a row from its L, and the turn that it makes in h seconds if it is left alone: h omega + h^2/2 domega/dt.
template <unsigned width, class T = typename AllLanes<width>::T>
void predict_turn(const FigureRows<width>& rows, FigureRow<width>& row, scalar h) {
    const Mat3<T> A = read(rows.all, row.A);
    const Vec3<T> I = read(rows.all, row.I_body), L_body = transpose_times(A, read(rows.all, row.L));
    const Vec3<T> w_body = {L_body.x / I.x, L_body.y / I.y, L_body.z / I.z}, torque = cross(L_body, w_body);
    const Vec3<T> rate = {torque.x / I.x, torque.y / I.y, torque.z / I.z};
    write(rows.all, row.w, A * w_body);
    write(rows.all, row.turn, A * (w_body * splat<T>(h) + rate * splat<T>(h * h / 2)));
}

template <unsigned width, class M, class T = typename AllLanes<width>::T>
void set_bias(const FigureRows<width>& rows, int row_i, scalar h, M is_exact) {
    FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i);
    const T h_lane = splat<T>(h);
    const Turning<T, M> own = {read(rows.all, row.turn), read(rows.all, row.w) * h_lane, is_exact};
    Turning<T, M> parent;
    Vec3<T> r_parent, v_parent;
    Mat3<T> A_parent;
    if (node.parent == no_node) {
        const Ground<T> ground = ground_of(rows);
        parent = {ground.w * h_lane, ground.w * h_lane, is_exact};
        r_parent = ground.r;
        v_parent = ground.v;
        A_parent = ground.A;
    } else {
        const FigureRow<width>& of = rows[node.parent];
        parent = {read(rows.all, of.turn), read(rows.all, of.w) * h_lane, is_exact};
        r_parent = read(rows.all, of.r);
        v_parent = read(rows.all, of.v);
        A_parent = read(rows.all, of.A);
    }
    const Vec3<T> arm = -read(rows.all, row.c), arm_of_parent = read(rows.all, row.arm_of_parent);
    JointSides<T> sides = {(read(rows.all, row.r) - r_parent) + (arm - arm_of_parent) + (read(rows.all, row.v) - v_parent) * h_lane +
                               (own.shift(arm) - parent.shift(arm_of_parent)),
                           own.after(read(rows.all, row.axis)), parent.after(read(rows.all, row.axis_of_parent)), {}, {}};
    if (locks_turns(node.kind)) {
        sides.side = own.after(read(rows.all, row.A) * rows.gathered(row_i, [&](const FigureNode& of) { return rows.own_frame(of).side; }));
        sides.side_of_parent = parent.after(A_parent * rows.gathered(row_i, [&](const FigureNode& of) { return rows.frame_of_parent(of).side; }));
    }
    write(rows.all, row.bias, twist_back(node.kind, sides) * splat<T>(1 / h));
}

/// Lanes whose figures are resolved.
template <unsigned width>
auto resolved_lanes(const FigureRows<width>& rows) {
    using T = typename AllLanes<width>::T;
    scalar flags[width];
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i) flags[lane_i] = rows.figure(lane_i).resolved ? 1 : 0;  // bound: lanes
    return rows.all.get(flags) > T{};
}

/// The same for where bodies are, without going on: of a push. Returns the square of the largest, m or rad, of each lane.
template <unsigned width, class T = typename AllLanes<width>::T>
T set_push(const FigureRows<width>& rows, int row_i) {
    FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i);
    Vec3<T> r_parent;
    Mat3<T> A_parent;
    if (node.parent == no_node) {
        const Ground<T> ground = ground_of(rows);
        r_parent = ground.r;
        A_parent = ground.A;
    } else {
        r_parent = read(rows.all, rows[node.parent].r);
        A_parent = read(rows.all, rows[node.parent].A);
    }
    const Mat3<T> A = read(rows.all, row.A);
    const auto own = [&](auto part) { return A * rows.gathered(row_i, [&](const FigureNode& of) { return rows.own_frame(of).*part; }); };
    const auto of_parent = [&](auto part) {
        return A_parent * rows.gathered(row_i, [&](const FigureNode& of) { return rows.frame_of_parent(of).*part; });
    };
    JointSides<T> sides = {(read(rows.all, row.r) - r_parent) + (own(&JointFrame::anchor) - of_parent(&JointFrame::anchor)), {}, {}, {}, {}};
    if (node.kind != JointKind::ball) {
        sides.axis = own(&JointFrame::axis);
        sides.axis_of_parent = of_parent(&JointFrame::axis);
    }
    if (locks_turns(node.kind)) {
        sides.side = own(&JointFrame::side);
        sides.side_of_parent = of_parent(&JointFrame::side);
    }
    const Spatial<T> back = twist_back(node.kind, sides);
    write(rows.all, row.bias, back);
    return max(length_sq(back.v), length_sq(back.w));
}

template <unsigned width>
void turn_body(const FigureRows<width>& rows, FigureRow<width>& row, const Vec3<typename AllLanes<width>::T>& turn) {
    auto A = read(rows.all, row.A);
    A = {A.c0 + chord(turn, A.c0), A.c1 + chord(turn, A.c1), A.c2 + chord(turn, A.c2)};
    write(rows.all, row.A, A + polar_correction(A));
}

template <unsigned width>
void clear_impulses(const FigureRows<width>& rows) {
    const Spatial<typename AllLanes<width>::T> none{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        write(rows.all, rows[row_i].impulse, none);
        write(rows.all, rows[row_i].drive, none.v);
    }
}

template <unsigned width>
void take_cursor(const FigureRows<width>& rows) {
    for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) rows.figure(lane_i).cursor = no_node;  // bound: lanes
}

/// The change at the centre of mass.
template <unsigned width>
Spatial<typename AllLanes<width>::T> change_of_centre(const FigureRows<width>& rows, const FigureRow<width>& row) {
    return twist_at(read(rows.all, row.change), read(rows.all, row.c));
}

/// What the joint gave to the body: what it took from the parent, with the sign turned. After the way down.
template <unsigned width, class T = typename AllLanes<width>::T>
void note_joint_impulse(const FigureRows<width>& rows, int row_i) {
    FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i);
    Spatial<T> f = read(rows.all, row.sent);
    if (node.parent != no_node) {
        const Spatial<T> u = twist_at(read(rows.all, rows[node.parent].change), read(rows.all, row.d));
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
        const Spatial<T> u = change_of_centre(rows, row);
        const Mat3<T> A = read(rows.all, row.A);
        write(rows.all, row.v, read(rows.all, row.v) + u.v);
        write(rows.all, row.L, read(rows.all, row.L) + A * scaled(read(rows.all, row.I_body), transpose_times(A, u.w)));
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

/// Displaces the lanes that are `off` by `change`.
template <unsigned width, class M, class T = typename AllLanes<width>::T>
void move_by_change(const FigureRows<width>& rows, M off) {
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        FigureRow<width>& row = rows[row_i];
        const Spatial<T> u = change_of_centre(rows, row), none{};
        const Mat3<T> A = read(rows.all, row.A);
        write(rows.all, row.r, read(rows.all, row.r) + select(off, u.v, none.v));
        write(rows.all, row.turned, read(rows.all, row.turned) + select(off, u.w, none.w));
        turn_body(rows, row, u.w);
        write(rows.all, row.A, select(off, read(rows.all, row.A), A));
    }
}

/// One push of all rows. False where nothing is off by more than limits::joint_gap, and nothing was done.
template <unsigned width>
bool push_rows(const FigureRows<width>& rows, bool again) {
    using T = typename AllLanes<width>::T;
    T most{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {
        const Spatial<T> none{};
        write(rows.all, rows[row_i].bias, none);
        if (rows.node(row_i).kind != JointKind::none) most = max(most, set_push(rows, row_i));
    }
    // Lanes that are good are left alone, so that what a figure does does not depend on who is beside it.
    const auto off = most > splat<T>(again ? limits::joint_gap * limits::joint_gap : scalar(-1));
    if (!any(off)) return false;
    clear_impulses(rows);
    pass_up(rows);
    pass_down(rows);
    move_by_change(rows, off);
    return true;
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
        const Spatial<T> u = change_of_centre(rows, row);
        const Vec3<T> w_after = w + transpose_times(A, u.w);
        const T M = rows.all.get(row.M), half = splat<T>(scalar(0.5));
        sum.before = sum.before + (M * length_sq(v) + dot(scaled(I, w), w)) * half;
        sum.after = sum.after + (M * length_sq(v + u.v) + dot(scaled(I, w_after), w_after)) * half;
    }
    return sum;
}

/// Targets of what is not resolved may ask for what cannot be, where joints come near to where they lock: light bodies would get any speed. Where a
/// figure would have more than limits::target_gain times its energy they are left out: velocities then fit the joints, which takes energy, and
/// pushes take back the gaps.
template <unsigned width, class M, class T = typename AllLanes<width>::T>
void hold_back_targets(const FigureRows<width>& rows, scalar h, M is_exact) {
    if (!any(opposite(is_exact))) return;
    clear_impulses(rows);
    pass_up(rows);
    pass_down(rows);
    const FigureEnergies<T> energies = figure_energies_of(rows);
    T M_all{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) M_all = M_all + rows.all.get(rows[row_i].M);
    const scalar gap_speed = limits::joint_gap / h;
    const T allowed = energies.before * splat<T>(limits::target_gain) + M_all * splat<T>(gap_speed * gap_speed);
    const auto gains = both(opposite(is_exact), energies.after > allowed);
    if (!any(gains)) return;
    const Spatial<T> none{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {
        const Spatial<T> bias = read(rows.all, rows[row_i].bias);
        write(rows.all, rows[row_i].bias, Spatial<T>{select(gains, none.w, bias.w), select(gains, none.v, bias.v)});
    }
}

}  // namespace

void begin_solve(const FigureView& view, scalar h) {
    for_groups(view, [h](const auto& rows) {
        const auto is_exact = resolved_lanes(rows);
        for (int row_i = 0; row_i < rows.count(); ++row_i) predict_turn(rows, rows[row_i], h);  // bound: max_bodies
        for (int row_i = 0; row_i < rows.count(); ++row_i)
            if (rows.node(row_i).kind != JointKind::none) set_bias(rows, row_i, h, is_exact);
        hold_back_targets(rows, h, is_exact);
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

void end_displacing(const FigureView& view) {
    for_groups(view, [](const auto& rows) {
        move_by_change(rows, rows.all_lanes());
    });
}

void push_figures(const FigureView& view, bool again) {
    for_groups(view, [again](const auto& rows) {
        // bound: limits::pushes_max
        for (int push_i = 0; push_i < limits::pushes_max && push_rows(rows, again || push_i > 0); ++push_i) {}
    });
}

} }  // namespace ingot

#pragma GCC diagnostic pop
