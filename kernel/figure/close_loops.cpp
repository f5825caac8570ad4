// SPDX-License-Identifier: MIT
#include "close_loops.h"

#include "../base/limits.h"
#include "ground.h"
#include "joint_sides.h"
#include "move_figures.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Both bodies of a joint, and how they move in a substep of h seconds.
struct LoopSides {
    SideMotion<scalar> child, other;
    const JointFrame &of_child, &of_other;

    JointSides<scalar> now() const { return sides_at(child, of_child, other, of_other); }
};
LoopSides sides_of(const FigureView& view, const LoopJoint& loop, scalar h) {
    const JointRecord& record = view.lists.joints[loop.joint];
    const auto motion_of = [&](Index node_i) {
        return at_node(view, node_i, [](const auto& rows, const auto& at, int row_i) { return motion_of_row(at, rows[row_i]); });
    };
    return {motion_of(loop.child), loop.other == no_node ? motion_of_ground(ground_at(view, loop.ground), h) : motion_of(loop.other),
            loop.is_A ? record.frame_A : record.frame_B, loop.is_A ? record.frame_B : record.frame_A};
}

/// The twist, times seconds, that takes back what the sides move against each other in a substep.
Spatial<scalar> back_of_motion(JointKind kind, const LoopSides& of, bool is_exact, scalar h) {
    const JointSides<scalar> now = of.now();
    const Turning<scalar, bool> child = {of.child.turn, of.child.w * h, is_exact}, other = {of.other.turn, of.other.w * h, is_exact};
    const Vector turned = child.shift(of.child.A * of.of_child.anchor) - other.shift(of.other.A * of.of_other.anchor);
    const Vector moved = (of.child.v - of.other.v) * h + turned;
    const JointSides<scalar> after = {now.gap + moved, child.after(now.axis), other.after(now.axis_of_parent), child.after(now.side),
                                      other.after(now.side_of_parent)};
    const Spatial<scalar> back = twist_back(kind, after) - twist_back(kind, now);
    return kind == JointKind::slider ? back : Spatial<scalar>{back.w, -moved};
}

void set_targets(LoopJoint& loop, const Spatial<scalar>& back) {
    for (int row = 0; row < loop.row_count; ++row)  // bound: rows_of_joint_max
        loop.target[row] = dot(loop.direction[row], loop.is_turn[row] ? back.w : back.v);
}

Spatial<scalar> change_of(const FigureView& view, Index node_i) {
    return at_node(view, node_i, [](const auto& rows, const auto& at, int row_i) { return read(at, rows[row_i].change); });
}
void add_to_impulse(const FigureView& view, Index node_i, const Spatial<scalar>& f) {
    at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) {
        write(at, rows[row_i].impulse, read(at, rows[row_i].impulse) + f);
    });
}

const Spatial<scalar>* X_at(const FigureView& view, const LoopView& loops, const LoopFigure& of, Index node_i) {
    return loops.X_of(of, node_i - view.figures[of.figure].first_node);
}

/// Pulls on their bodies are kept, for the tension of the next substep and for the joints at the end of the step.
void note_loop_impulses(const FigureView& view, const LoopView& loops) {
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        for_loop_joints(loops, of, [](LoopJoint& loop) {
            loop.given = {};
            for (int row = 0; row < loop.row_count; ++row)  // bound: rows_of_joint_max
                if (!loop.is_turn[row]) loop.given = loop.given + loop.direction[row] * loop.j[row];
        });
    });
}

}  // namespace

void aim_loops(const FigureView& view, const LoopView& loops, const LoopFigure& of, scalar h) {
    const bool is_exact = view.figures[of.figure].resolved;
    for_loop_joints(loops, of, [&](LoopJoint& loop) {
        set_targets(loop, back_of_motion(loop.kind, sides_of(view, loop, h), is_exact, h) * (1 / h));
    });
}

scalar aim_pushes(const FigureView& view, const LoopView& loops, const LoopFigure& of) {
    scalar most = 0;
    for_loop_joints(loops, of, [&](LoopJoint& loop) {
        const Spatial<scalar> back = twist_back(loop.kind, sides_of(view, loop, 0).now());
        set_targets(loop, back);
        most = max(most, max(length_sq(back.v) * (1 / (view.unit * view.unit)), length_sq(back.w)));
    });
    return most;
}

void find_lacks(const FigureView& view, const LoopView& loops, const LoopFigure& of) {
    const scalar* const L = loops.L + of.first_entry;
    const uint8_t* const order = loops.order + of.first_row;
    scalar* const z = loops.z + of.first_row;
    scalar lacks[limits::loop_rows_max];
    for_loop_joints(loops, of, [&](const LoopJoint& loop) {
        const Spatial<scalar> of_child = change_of(view, loop.child);
        const Spatial<scalar> of_other = loop.other == no_node ? Spatial<scalar>{} : change_of(view, loop.other);
        for (int row = 0; row < loop.row_count; ++row)  // bound: rows_of_joint_max
            lacks[loop.first_row + row] = loop.target[row] - (dot(loop.rows[row].on_child, of_child) + dot(loop.rows[row].on_other, of_other));
    });
    for (int i = 0; i < of.rank; ++i) {  // bound: limits::loop_rows_max
        const scalar* const of_i = L + i * (i + 1) / 2;
        scalar left = lacks[order[i]];
        for (int k = 0; k < i; ++k) left -= of_i[k] * z[k];  // bound: limits::loop_rows_max
        z[i] = left * of_i[i];
    }
}

void close_loops(const FigureView& view, const LoopView& loops, const LoopFigure& of) {
    const Figure& figure = view.figures[of.figure];
    for (int node_i = figure.first_node; node_i < figure.first_node + figure.node_count; ++node_i) {  // bound: max_bodies
        const Spatial<scalar> more = twist_of_loops(view, loops, static_cast<Index>(node_i));
        at_node(view, static_cast<Index>(node_i), [&](const auto& rows, const auto& at, int row_i) {
            write(at, rows[row_i].change, read(at, rows[row_i].change) + more);
        });
    }
}

void keep_lacks(const FigureView& view, const LoopView& loops) {
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        const scalar* const L = loops.L + of.first_entry;
        const uint8_t* const order = loops.order + of.first_row;
        scalar* const z = loops.z + of.first_row;
        scalar j[limits::loop_rows_max] = {};
        for (int i = of.rank - 1; i >= 0; --i) {  // bound: limits::loop_rows_max
            const scalar* const of_i = L + i * (i + 1) / 2;
            const scalar j_i = z[i] * of_i[i];
            for (int k = 0; k < i; ++k) z[k] -= of_i[k] * j_i;  // bound: limits::loop_rows_max
            j[order[i]] = j_i;
            z[i] = 0;
        }
        for_loop_joints(loops, of, [&](LoopJoint& loop) {
            for (int row = 0; row < loop.row_count; ++row) loop.j[row] += j[loop.first_row + row];  // bound: rows_of_joint_max
        });
    });
}

void add_loop_impulses(const FigureView& view, const LoopView& loops) {
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        for_loop_joints(loops, of, [&](const LoopJoint& loop) {
            Spatial<scalar> on_child{}, on_other{};
            for (int row = 0; row < loop.row_count; ++row) {  // bound: rows_of_joint_max
                on_child = on_child + loop.rows[row].on_child * loop.j[row];
                on_other = on_other + loop.rows[row].on_other * loop.j[row];
            }
            add_to_impulse(view, loop.child, on_child);
            if (loop.other != no_node) add_to_impulse(view, loop.other, on_other);
        });
    });
}

Spatial<scalar> twist_of_loops(const FigureView& view, const LoopView& loops, Index node_i) {
    Spatial<scalar> sum{};
    const LoopFigure* const of = loops.of_node(view, node_i);
    if (of == nullptr) return sum;
    const Spatial<scalar>* const X = X_at(view, loops, *of, node_i);
    for (int i = 0; i < of->rank; ++i) sum = sum + X[i] * loops.z[of->first_row + i];  // bound: limits::loop_rows_max
    return sum;
}

void feel_impulse(const FigureView& view, const LoopView& loops, Index node_i, const Vector& F, const Vector& T) {
    const LoopFigure* const of = loops.of_node(view, node_i);
    if (of == nullptr) return;
    const Vector c = at_node(view, node_i, [](const auto& rows, const auto& at, int row_i) { return read(at, rows[row_i].c); });
    const Spatial<scalar> f = {T + cross(c, F), F};
    const Spatial<scalar>* const X = X_at(view, loops, *of, node_i);
    for (int i = 0; i < of->rank; ++i) loops.z[of->first_row + i] -= dot(X[i], f);  // bound: limits::loop_rows_max
}

Spatial6<scalar> response_of_loops(const FigureView& view, const LoopView& loops, Index node_i) {
    Spatial6<scalar> sum{};
    const LoopFigure* const of = loops.of_node(view, node_i);
    if (of == nullptr) return sum;
    const Spatial<scalar>* const X = X_at(view, loops, *of, node_i);
    for (int i = 0; i < of->rank; ++i) sum = plus_square(sum, X[i], scalar(-1));  // bound: limits::loop_rows_max
    return sum;
}

Spatial<scalar> response_across_loops(const FigureView& view, const LoopView& loops, Index node_A, Index node_B, const Spatial<scalar>& on_B) {
    Spatial<scalar> sum{};
    const LoopFigure* const of = loops.of_node(view, node_A);
    if (of == nullptr) return sum;
    const Spatial<scalar>* const X_A = X_at(view, loops, *of, node_A);
    const Spatial<scalar>* const X_B = X_at(view, loops, *of, node_B);
    for (int i = 0; i < of->rank; ++i) sum = sum - X_A[i] * dot(X_B[i], on_B);  // bound: limits::loop_rows_max
    return sum;
}

void solve_loops(const FigureView& view, const LoopView& loops) {
    const auto pass = [&] {
        begin_passing(view);
        add_loop_impulses(view, loops);
        pass_impulses(view);
        for_looped_figures(view, loops, [&](const LoopFigure& of) { find_lacks(view, loops, of); });
    };
    pass();
    keep_lacks(view, loops);
    pass();
    end_loops(view, loops);
}

void forget_lacks(const FigureView& view, const LoopView& loops) {
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        for (int i = 0; i < of.rank; ++i) loops.z[of.first_row + i] = 0;  // bound: limits::loop_rows_max
    });
}

void close_all_loops(const FigureView& view, const LoopView& loops) {
    for_looped_figures(view, loops, [&](const LoopFigure& of) { close_loops(view, loops, of); });
}

void end_loops(const FigureView& view, const LoopView& loops) {
    close_all_loops(view, loops);
    keep_lacks(view, loops);
    note_loop_impulses(view, loops);
}

void keep_loops(const FigureView& view, const LoopView& loops, int doublings) {
    const auto scale = static_cast<scalar>(1 << doublings);
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        const Figure& figure = view.figures[of.figure];
        if (figure.doublings > doublings) return;
        for_loop_joints(loops, of, [&](const LoopJoint& loop) {
            JointRecord& joint = view.lists.joints[loop.joint];
            joint.j = loop.given * (loop.is_A ? -scale : scale);
            joint.resolved = figure.resolved ? 1 : 0;
            joint.doublings = figure.doublings;
        });
    });
}

} }  // namespace ingot
