// SPDX-License-Identifier: MIT
#include "close_loops.h"

#include "../base/figure_limits.h"
#include "../math/sqrt.h"
#include "factor_loops.h"
#include "gear_rows.h"
#include "loop_sides.h"
#include "move_figures.h"
#include "target_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// twist_back, and that of kinds that are in no tree.
Spatial<scalar> back_of(JointKind kind, const JointSides<scalar>& of) {
    return kind == JointKind::parallel ? Spatial<scalar>{twist_back(JointKind::hinge, of).w, {}} : twist_back(kind, of);
}

/// The twist, times seconds, that takes back what the sides move against each other in a substep.
Spatial<scalar> back_of_motion(JointKind kind, const LoopSides& of, bool is_exact, scalar h) {
    Vector moved;
    const JointSides<scalar> now = of.now(), after = sides_after(of, now, is_exact, h, moved);
    const Spatial<scalar> back = back_of(kind, after) - back_of(kind, now);
    return kind == JointKind::slider || is_wheel(kind) ? back : Spatial<scalar>{back.w, -moved};
}

/// By how much the ends of a rod or a rope, that are `apart`, have to go along its line until they are at its length: to where its circle is, which
/// lies beside the line. Where the line itself has turned far, to the circle on the straight way.
scalar way_to_length(const LoopJoint& loop, const Vector& apart) {
    const scalar along = dot(loop.direction[0], apart), across_sq = length_sq(apart) - along * along, l_sq = loop.length * loop.length;
    if (along > 0 && 2 * across_sq < l_sq) return sqrt(l_sq - max(across_sq, 0)) - along;
    return loop.length - sqrt(length_sq(apart));
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

const Spatial<scalar>* X_at(const LoopView& loops, const LoopFigure& of, Index node_i) {
    return loops.X_of(of, node_i - of.first_node);
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

/// j = L^-T z, by row.
void impulses_of(const LoopView& loops, const LoopFigure& of, scalar (&j)[limits::loop_rows_max]) {
    const scalar* const L = loops.L + of.first_entry;
    const uint8_t* const order = loops.order + of.first_row;
    scalar z[limits::loop_rows_max];
    for (int i = 0; i < of.rank; ++i) z[i] = loops.z[of.first_row + i];  // bound: limits::loop_rows_max
    for (int i = 0; i < of.row_count; ++i) j[i] = 0;                     // bound: limits::loop_rows_max
    for (int i = of.rank - 1; i >= 0; --i) {                             // bound: limits::loop_rows_max
        const scalar* const of_i = L + i * (i + 1) / 2;
        const scalar j_i = z[i] * of_i[i];
        for (int k = 0; k < i; ++k) z[k] -= of_i[k] * j_i;  // bound: limits::loop_rows_max
        j[order[i]] = j_i;
    }
}

void keep_lacks_of(const LoopView& loops, const LoopFigure& of) {
    scalar j[limits::loop_rows_max];
    impulses_of(loops, of, j);
    for (int i = 0; i < of.rank; ++i) loops.z[of.first_row + i] = 0;  // bound: limits::loop_rows_max
    for_loop_joints(loops, of, [&](LoopJoint& loop) {
        for (int row = 0; row < loop.row_count; ++row) loop.j[row] += j[loop.first_row + row];  // bound: rows_of_joint_max
    });
}

}  // namespace

Spatial<scalar> change_of_body(const FigureView& view, Index node_i) { return change_of(view, node_i); }

void aim_loops(const FigureView& view, const LoopView& loops, const LoopFigure& of, scalar h) {
    for_loop_joints(loops, of, [&](LoopJoint& loop) {
        if (locks_nothing(loop)) return;
        const bool exact = is_exact(view, loop);
        if (loop.kind == JointKind::gear) return aim_gear(view, loops, loop, exact, h);
        const LoopSides sides = sides_of(view, loop, h);
        if (loop.kind == JointKind::target) return set_targets(loop, {});  // see aim_targets
        if (!has_length(loop.kind)) return set_targets(loop, back_of_motion(loop.kind, sides, exact, h) * (1 / h));
        Vector moved;
        loop.length = loops.ties[loop.joint].length_at(view.elapsed + h, view.h);
        loop.target[0] = way_to_length(loop, sides_after(sides, sides.now(), exact, h, moved).gap) / h;
    });
}

void fit_loops(const FigureView& view, const LoopView& loops, const LoopFigure& of, scalar h) {
    for_loop_joints(loops, of, [&](LoopJoint& loop) {
        if (locks_nothing(loop) || loop.kind == JointKind::target) return;
        if (loop.kind == JointKind::gear) return aim_gear(view, loops, loop, false, h);
        const LoopSides sides = sides_of(view, loop, h);
        if (!has_length(loop.kind)) return set_targets(loop, back_of_motion(loop.kind, sides, false, h) * (1 / h));
        Vector moved;
        (void)sides_after(sides, sides.now(), false, h, moved);
        const scalar reeled = loop.length - loops.ties[loop.joint].length_at(view.elapsed, view.h);
        loop.target[0] = (reeled - dot(loop.direction[0], moved)) / h;
    });
}

scalar aim_pushes(const FigureView& view, const LoopView& loops, const LoopFigure& of) {
    const scalar per_unit_sq = 1 / (view.unit * view.unit);
    scalar most = 0;
    for_loop_joints(loops, of, [&](LoopJoint& loop) {
        if (locks_nothing(loop)) return;
        if (loop.kind == JointKind::target) return set_targets(loop, {});  // no push goes there
        if (loop.kind == JointKind::gear) {
            loop.target[0] = way_back_of_gear(view, loops, loop);
            most = max(most, loop.target[0] * loop.target[0]);
            return;
        }
        const JointSides<scalar> now = sides_of(view, loop, 0).now();
        if (!has_length(loop.kind)) {
            const Spatial<scalar> back = back_of(loop.kind, now);
            set_targets(loop, back);
            most = max(most, max(length_sq(back.v) * per_unit_sq, length_sq(back.w)));
            return;
        }
        loop.length = loops.ties[loop.joint].length_at(view.elapsed, view.h);
        const scalar way = way_to_length(loop, now.gap);
        loop.target[0] = loop.kind == JointKind::rope ? min(way, 0) : way;
        if (!loop.is_slack) most = max(most, loop.target[0] * loop.target[0] * per_unit_sq);
    });
    return most;
}

void leave_out_targets(const LoopView& loops, const LoopFigure& of) {
    for_loop_joints(loops, of, [](LoopJoint& loop) {
        for (scalar& target : loop.target) target = 0;
    });
}

void find_lacks(const FigureView& view, const LoopView& loops, const LoopFigure& of, bool passed) {
    const scalar* const L = loops.L + of.first_entry;
    const uint8_t* const order = loops.order + of.first_row;
    scalar* const z = loops.z + of.first_row;
    scalar lacks[limits::loop_rows_max];
    for_loop_joints(loops, of, [&](const LoopJoint& loop) {
        if (loop.kind == JointKind::gear) {
            scalar change = 0;
            for_bodies_of(loops, loop, 0, [&](Index node_i, const Spatial<scalar>& f) { change += dot(f, change_of(view, node_i)); });
            lacks[loop.first_row] = loop.target[0] - change;
            return;
        }
        const Spatial<scalar> of_child = change_of(view, loop.child);
        const Spatial<scalar> of_other = loop.other == no_node ? Spatial<scalar>{} : change_of(view, loop.other);
        for (int row = 0; row < loop.row_count; ++row)  // bound: rows_of_joint_max
            lacks[loop.first_row + row] = loop.target[row] - (dot(loop.rows[row].on_child, of_child) + dot(loop.rows[row].on_other, of_other));
        if (loop.kind != JointKind::target || !passed) return;
        for (int row = 0; row < loop.row_count; ++row) lacks[loop.first_row + row] -= give_of_target(view, loops, loop, row);
    });
    for (int i = 0; i < of.rank; ++i) {  // bound: limits::loop_rows_max
        const scalar* const of_i = L + i * (i + 1) / 2;
        scalar left = lacks[order[i]];
        for (int k = 0; k < i; ++k) left -= of_i[k] * z[k];  // bound: limits::loop_rows_max
        z[i] = left * of_i[i];
    }
}

void close_loops(const FigureView& view, const LoopView& loops, const LoopFigure& of) {
    for (int node_i = of.first_node; node_i < of.first_node + of.node_count; ++node_i) {  // bound: max_bodies
        const Spatial<scalar> more = twist_of_loops(view, loops, static_cast<Index>(node_i));
        at_node(view, static_cast<Index>(node_i), [&](const auto& rows, const auto& at, int row_i) {
            write(at, rows[row_i].change, read(at, rows[row_i].change) + more);
        });
    }
}

void keep_lacks(const FigureView& view, const LoopView& loops) {
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        if (!of.stands) keep_lacks_of(loops, of);
    });
}

namespace {

/// A servo that is not driven, say: what it adds is zero.
bool gives_nothing(const LoopJoint& loop) {
    for (int row = 0; row < loop.row_end; ++row)  // bound: rows_of_joint_max
        if (loop.j[row] != 0) return false;
    return true;
}

/// Of the rows of each joint from first(loop) on.
template <class First>
void add_impulses(const FigureView& view, const LoopView& loops, const First& first) {
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        for_loop_joints(loops, of, [&](const LoopJoint& loop) {
            if (loop.kind == JointKind::gear) {
                if (first(loop) > 0) return;  // it has no free rows
                for_bodies_of(loops, loop, 0, [&](Index node_i, const Spatial<scalar>& f) { add_to_impulse(view, node_i, f * loop.j[0]); });
                return;
            }
            if (gives_nothing(loop)) return;
            Spatial<scalar> on_child{}, on_other{};
            for (int row = first(loop); row < loop.row_end; ++row) {  // bound: rows_of_joint_max
                on_child = on_child + loop.rows[row].on_child * loop.j[row];
                on_other = on_other + loop.rows[row].on_other * loop.j[row];
            }
            add_to_impulse(view, loop.child, on_child);
            if (loop.other != no_node) add_to_impulse(view, loop.other, on_other);
        });
    });
}

}  // namespace

void add_loop_impulses(const FigureView& view, const LoopView& loops) {
    add_impulses(view, loops, [](const LoopJoint&) { return 0; });
}
void add_free_impulses(const FigureView& view, const LoopView& loops) {
    add_impulses(view, loops, [](const LoopJoint& loop) { return int{loop.row_count}; });
}

Spatial<scalar> twist_of_loops(const FigureView& view, const LoopView& loops, Index node_i) {
    Spatial<scalar> sum{};
    const LoopFigure* const of = loops.of_node(view, node_i);
    if (of == nullptr) return sum;
    const Spatial<scalar>* const X = X_at(loops, *of, node_i);
    for (int i = 0; i < of->rank; ++i) sum = sum + X[i] * loops.z[of->first_row + i];  // bound: limits::loop_rows_max
    return sum;
}

void feel_impulse(const FigureView& view, const LoopView& loops, Index node_i, const Vector& F, const Vector& T) {
    const LoopFigure* const of = loops.of_node(view, node_i);
    if (of == nullptr) return;
    const Vector c = at_node(view, node_i, [](const auto& rows, const auto& at, int row_i) { return read(at, rows[row_i].c); });
    const Spatial<scalar> f = {T + cross(c, F), F};
    const Spatial<scalar>* const X = X_at(loops, *of, node_i);
    for (int i = 0; i < of->rank; ++i) loops.z[of->first_row + i] -= dot(X[i], f);  // bound: limits::loop_rows_max
}

Spatial6<scalar> response_of_loops(const FigureView& view, const LoopView& loops, Index node_i) {
    Spatial6<scalar> sum{};
    const LoopFigure* const of = loops.of_node(view, node_i);
    if (of == nullptr) return sum;
    const Spatial<scalar>* const X = X_at(loops, *of, node_i);
    for (int i = 0; i < of->rank; ++i) sum = plus_square(sum, X[i], scalar(-1));  // bound: limits::loop_rows_max
    return sum;
}

Spatial<scalar> response_across_loops(const FigureView& view, const LoopView& loops, Index node_A, Index node_B, const Spatial<scalar>& on_B) {
    Spatial<scalar> sum{};
    const LoopFigure* const of = loops.of_node(view, node_A);
    if (of == nullptr) return sum;
    const Spatial<scalar>* const X_A = X_at(loops, *of, node_A);
    const Spatial<scalar>* const X_B = X_at(loops, *of, node_B);
    for (int i = 0; i < of->rank; ++i) sum = sum - X_A[i] * dot(X_B[i], on_B);  // bound: limits::loop_rows_max
    return sum;
}

namespace {

/// Whether a rope pushes, or would be too long: it changes then. more: what is to come to its impulse. On the child of its row those that pull are
/// negative.
bool end_changes(const FigureView& view, const LoopJoint& loop, scalar more, int round) {
    if (!loop.is_slack) return loop.j[0] + more > 0;
    if (round >= limits::rope_rounds) return false;
    const LoopRow& row = loop.rows[0];
    scalar rate = dot(row.on_child, change_of(view, loop.child));
    if (loop.other != no_node) rate += dot(row.on_other, change_of(view, loop.other));
    return rate > loop.target[0];
}

void settle_rows_of(const FigureView& view, const LoopView& loops, LoopFigure& of, int round) {
    bool some = false;
    bool changes[limits::loop_rows_max];
    scalar more[limits::loop_rows_max];
    impulses_of(loops, of, more);
    for_loop_joints(loops, of, [&](LoopJoint& loop) {
        changes[loop.first_row] = loop.kind == JointKind::rope && end_changes(view, loop, more[loop.first_row], round);
        if (loop.kind == JointKind::target)
            some = settle_target(view, loops, loop, more + loop.first_row, round < limits::rope_rounds) || some;
        some = some || changes[loop.first_row];
    });
    of.is_settled = !some;
    if (!some) return;
    for_loop_joints(loops, of, [&](LoopJoint& loop) {
        if (!changes[loop.first_row]) return;
        loop.is_slack = !loop.is_slack;
        loop.j[0] = 0;
    });
    factor_loops_of(view, loops, of);
    for (int i = 0; i < of.row_count; ++i) loops.z[of.first_row + i] = 0;  // bound: limits::loop_rows_max
}

}  // namespace

bool settle_rows(const FigureView& view, const LoopView& loops, int round) {
    bool some = false;
    for_looped_figures(view, loops, [&](LoopFigure& of) {
        if (of.is_settled) return;
        if (loops.ties == nullptr)
            of.is_settled = true;
        else
            settle_rows_of(view, loops, of, round);
        some = some || !of.is_settled;
    });
    return some;
}

void open_machines(const FigureView& view, const LoopView& loops) {
    for_looped_figures(view, loops, [](LoopFigure& of) { of.is_settled = of.stands = false; });
}

void pass_looped(const FigureView& view, const LoopView& loops) {
    const auto for_open = [&](const auto& each) {
        for_looped_figures(view, loops, [&](const LoopFigure& of) {
            if (!of.is_settled) each(of);
        });
    };
    const auto pass = [&] {
        begin_passing(view);
        add_loop_impulses(view, loops);
        pass_impulses(view);
        for_open([&](const LoopFigure& of) { find_lacks(view, loops, of, true); });
    };
    pass();
    for_open([&](const LoopFigure& of) { keep_lacks_of(loops, of); });
    pass();
}

void solve_loops(const FigureView& view, const LoopView& loops) {
    open_machines(view, loops);
    bool again = true;
    for (int round = 0; again; ++round) {  // bound: rope_rounds + max_loops: see settle_rows
        pass_looped(view, loops);
        close_all_loops(view, loops);
        again = settle_rows(view, loops, round);
    }
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
    for_looped_figures(view, loops, [&](const LoopFigure& of) { keep_lacks_of(loops, of); });
    note_loop_impulses(view, loops);
}

void keep_loops(const FigureView& view, const LoopView& loops, int doublings) {
    const auto scale = static_cast<scalar>(1 << doublings);
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        const Figure& figure = view.figures[of.figure];
        if (figure.doublings > doublings) return;
        for_loop_joints(loops, of, [&](const LoopJoint& loop) {
            JointRecord& joint = view.lists.joints[loop.joint];
            const Vector on_B = loop.given * (loop.is_A ? -scale : scale);
            joint.j = is_finite(on_B) ? on_B : Vector{};  // nothing of bodies that have gone bad
            joint.resolved = figure.resolved ? 1 : 0;
            joint.doublings = figure.doublings;
            if (loop.kind == JointKind::target) keep_target(view, loops, loop);
            if (loop.kind == JointKind::gear) keep_gear(loops, loop);
        });
    });
}

} }  // namespace ingot
