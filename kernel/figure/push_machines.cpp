// SPDX-License-Identifier: MIT
#include "push_machines.h"

#include "machine_pushes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Units of length or rad, squared: how far a machine may be off where a row is left out, or nearly is. If what is taut was pushed straight in each
/// substep, no solve would see that it gives way, and what velocities lack would gather.
scalar allowed_of_taut(const FigureView& view, const LoopView& loops, const LoopFigure& of) {
    scalar most_sq = 0;
    for_loop_joints(loops, of, [&](const LoopJoint& loop) { most_sq = max(most_sq, length_sq(loop.arm)); });
    return most_sq * (limits::taut_gap * limits::taut_gap / (view.unit * view.unit));
}

/// How far a figure's joints may be off without a push, squared: those with loops less. The first push is given to all but what is taut.
template <unsigned width, class Kinds>
auto allowed_of(const FigureRows<width, Kinds>& rows, const LoopView& loops, bool again) {
    using T = typename AllLanes<width>::T;
    scalar allowed[width];
    rows.all.put(allowed, splat<T>(again ? limits::joint_gap * limits::joint_gap : scalar(-1)));
    for_looped(rows, loops, [&](const LoopFigure& of, int lane_i) {
        if (of.row_count == 0) return;
        if (again) allowed[lane_i] = limits::loop_gap * limits::loop_gap;
        if (of.least < limits::taut_compliance)
            allowed[lane_i] = max(allowed[lane_i], allowed_of_taut(rows.view, loops, of));
    });
    return rows.all.get(allowed);
}

/// Trees of a group that is to be pushed answer to what their joints are off by. A figure that is good is left alone, so that what it does does not
/// depend on who is beside it. Pushes of loops do not get better once they have got worse: they are ended.
template <unsigned width, class Kinds>
bool begin_push(const FigureRows<width, Kinds>& rows, const LoopView& loops, bool again) {
    using T = typename AllLanes<width>::T;
    const T most = rows.all.get(note_of(rows, noted_gap));
    const auto off = both(most > allowed_of(rows, loops, again), most < rows.all.get(note_of(rows, noted_before)));
    rows.all.put(note_of(rows, noted_turn), select(off, T{}, splat<T>(scalar(-1))));
    if (!any(off)) return false;
    rows.all.put(note_of(rows, noted_before), most);
    clear_impulses(rows);
    pass_up(rows);
    pass_down(rows);
    return true;
}

/// One push of all. False where nothing is off by more than it may be, and nothing was done.
bool push_all(const FigureView& view, const LoopView& loops, bool again) {
    for_groups(view, [](const auto& rows) { rows.all.put(note_of(rows, noted_gap), set_pushes(rows)); });
    for_looped_figures(view, loops, [&](const LoopFigure& of) { (void)share_most(view, of, noted_gap, aim_pushes(view, loops, of)); });
    bool some = false;
    for_groups(view, [&](const auto& rows) { some = begin_push(rows, loops, again) || some; });
    if (!some) return false;
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        if (share_most(view, of, noted_turn, -1) < 0) return;
        find_lacks(view, loops, of, false);
        close_loops(view, loops, of);
    });
    end_pushes(view, loops);
    return true;
}

/// Joints that no push brings together ask for what cannot be, as a chain does whose ends are drawn apart. Its places are pushed back then, while its
/// velocities would go on to gather what forces give: they are halved.
template <unsigned width, class Kinds>
void slow_what_cannot_be(const FigureRows<width, Kinds>& rows) {
    using T = typename AllLanes<width>::T;
    const auto is_apart = rows.all.get(note_of(rows, noted_gap)) > splat<T>(limits::parted_gap * limits::parted_gap);
    if (!any(is_apart)) return;
    const T share = select(is_apart, splat<T>(scalar(0.5)), splat<T>(1));
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        write(rows.all, rows[row_i].v, read(rows.all, rows[row_i].v) * share);
        write(rows.all, rows[row_i].L, read(rows.all, rows[row_i].L) * share);
    }
}

/// Trees that move together: those of a machine, or one that has no loops.
struct TreesOfMachine {
    Index first, count;  ///< of FigureView::figures
};

template <class Each>
void for_bodies_of(const FigureView& view, const TreesOfMachine& trees, const Each& each) {
    for (int i = 0; i < trees.count; ++i)  // bound: max_bodies
        at_node(view, view.figures[trees.first + i].first_node, [&](const auto& rows, const auto& at, int) {
            for (int row_i = 0; row_i < rows.count(); ++row_i) each(at, rows[row_i]);  // bound: max_bodies
        });
}

/// How trees would go on if all their joints were locked, with the momentum and the angular momentum that they have.
struct MotionAsAWhole {
    Vector r, v, omega;  ///< m, m/s, rad/s: of the centre of mass
    Vector v_at(const Vector& of_body) const { return v + cross(omega, of_body - r); }
};
MotionAsAWhole motion_as_a_whole(const FigureView& view, const TreesOfMachine& trees) {
    scalar M = 0;
    Vector Mr{}, Mv{}, L{};
    const Index root = view.figures[trees.first].first_node;
    const Vector near = at_node(view, root, [](const auto& rows, const auto& at, int) { return read(at, rows[0].r); });
    for_bodies_of(view, trees, [&](const auto& at, const auto& row) {
        M += at.get(row.M);
        Mr = Mr + (read(at, row.r) - near) * at.get(row.M);
        Mv = Mv + read(at, row.v) * at.get(row.M);
    });
    const Vector r = near + Mr * (1 / M), v = Mv * (1 / M);
    SymmetricMatrix I{};
    for_bodies_of(view, trees, [&](const auto& at, const auto& row) {
        const Vector arm = read(at, row.r) - r;
        const scalar of_body = at.get(row.M), about = of_body * length_sq(arm);
        L = L + read(at, row.L) + cross(arm, read(at, row.v) - v) * of_body;
        I = plus_square(I + rotated_diagonal(read(at, row.A), read(at, row.I_body)) + SymmetricMatrix{about, about, about, 0, 0, 0}, arm, -of_body);
    });
    return {r, v, inverse_of(I) * L};
}

/// Nothing of it is tied to the world, or to what cannot move.
bool floats(const FigureView& view, const LoopView& loops, const TreesOfMachine& trees) {
    bool is_tied = false;
    for (int i = 0; i < trees.count; ++i)  // bound: max_bodies
        is_tied = is_tied || view.nodes[view.figures[trees.first + i].first_node].joint != no_joint;
    const Index loops_i = loops.of_figure[trees.first];
    if (loops_i == no_loop) return !is_tied;
    for_loop_joints(loops, loops.figures[loops_i],
                    [&](const LoopJoint& loop) { is_tied = is_tied || (loop.other == no_node && !locks_nothing(loop)); });
    return !is_tied;
}

/// What floats goes on as a whole: nothing but itself holds it back. It is done with then, for slow_what_cannot_be.
void slow_what_floats(const FigureView& view, const LoopView& loops, const TreesOfMachine& trees) {
    const auto over_roots = [&](const auto& each) {
        for (int i = 0; i < trees.count; ++i)  // bound: max_bodies
            at_node(view, view.figures[trees.first + i].first_node, [&](const auto& rows, const auto& at, int) { each(rows, at); });
    };
    bool is_apart = false;
    over_roots([&](const auto& rows, const auto& at) {
        is_apart = is_apart || at.get(note_of(rows, noted_gap)) > limits::parted_gap * limits::parted_gap;
    });
    if (!is_apart || !floats(view, loops, trees)) return;
    const MotionAsAWhole whole = motion_as_a_whole(view, trees);
    for_bodies_of(view, trees, [&](const auto& at, auto& row) {
        const Matrix A = read(at, row.A);
        const Vector L_of_whole = A * scaled(read(at, row.I_body), transpose_times(A, whole.omega));
        write(at, row.v, (read(at, row.v) + whole.v_at(read(at, row.r))) * scalar(0.5));
        write(at, row.L, (read(at, row.L) + L_of_whole) * scalar(0.5));
    });
    over_roots([](const auto& rows, const auto& at) { at.put(note_of(rows, noted_gap), 0); });
}

/// No push has been before.
template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
void forget_pushes(const FigureRows<width, Kinds>& rows) {
    rows.all.put(note_of(rows, noted_before), splat<T>(scalar_max));
}

}  // namespace

void push_machines(const FigureView& view, const LoopView& loops, bool again) {
    for_groups(view, [](const auto& rows) { forget_pushes(rows); });
    // bound: limits::pushes_max
    for (int push_i = 0; push_i < limits::pushes_max && push_all(view, loops, again || push_i > 0); ++push_i) {}
    if (again) return;
    for_looped_figures(view, loops, [&](LoopFigure& of) {
        of.was_apart = of.was_apart || share_most(view, of, noted_gap, 0) > limits::joint_gap * limits::joint_gap;
    });
    for_looped_figures(view, loops, [&](const LoopFigure& of) { slow_what_floats(view, loops, {of.figure, of.figure_count}); });
    for (int figure_i = 0; figure_i < view.figure_count; ++figure_i)  // bound: max_joints
        if (loops.of_figure[figure_i] == no_loop && is_of_batch(view, static_cast<Index>(figure_i)))
            slow_what_floats(view, loops, {static_cast<Index>(figure_i), 1});
    for_groups(view, [](const auto& rows) { slow_what_cannot_be(rows); });
}

} }  // namespace ingot

#pragma GCC diagnostic pop
