// SPDX-License-Identifier: MIT
#include "factor_loops.h"

#include "../base/figure_limits.h"
#include "../math/sqrt.h"
#include "gear_rows.h"
#include "loop_sides.h"
#include "target_rows.h"
#include "tree_passes.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// A side of a joint in the world.
struct PlacedFrame {
    Vector arm, axis, side, third;
};
PlacedFrame placed(const Matrix& A, const JointFrame& frame) {
    const Vector axis = A * frame.axis, side = A * frame.side;
    return {A * frame.anchor, axis, side, cross(axis, side)};
}

/// From q of a body to a point at `arm` of its centre of mass.
Vector from_q(const FigureView& view, Index node_i, const Vector& arm) {
    return at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) { return read(at, rows[row_i].c) + arm; });
}
Matrix rotation_of(const FigureView& view, Index node_i) {
    return at_node(view, node_i, [](const auto& rows, const auto& at, int row_i) { return read(at, rows[row_i].A); });
}
Vector place_of_body(const FigureView& view, Index node_i) {
    return at_node(view, node_i, [](const auto& rows, const auto& at, int row_i) { return read(at, rows[row_i].r); });
}

/// Directions that a joint locks, linear ones first: all three, or those across an axis.
void set_directions(LoopJoint& loop, const PlacedFrame& child, const PlacedFrame& other) {
    constexpr Vector axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    int count = 0;
    const auto add = [&](bool is_turn, const Vector& direction) {
        loop.is_turn[count] = is_turn;
        loop.direction[count++] = direction;
    };
    const auto add_all = [&](bool is_turn) {
        for (const Vector& axis : axes) add(is_turn, axis);
    };
    const auto add_across = [&](bool is_turn, const PlacedFrame& frame) {
        add(is_turn, frame.side);
        add(is_turn, frame.third);
    };
    if (loop.kind == JointKind::slider || loop.kind == JointKind::wheel)
        add_across(false, other);
    else if (loop.kind == JointKind::carriage)
        add_across(false, child);
    else if (has_length(loop.kind))
        add(false, loop.direction[0]);
    else if (loop.kind != JointKind::parallel)
        add_all(false);
    if (loop.kind == JointKind::hinge || loop.kind == JointKind::parallel) add_across(true, child);
    if (loop.kind == JointKind::fixed || loop.kind == JointKind::slider || loop.kind == JointKind::target) add_all(true);
    if (loop.kind == JointKind::universal || is_wheel(loop.kind)) {
        const Vector x = cross(other.axis, child.axis);
        add(true, x * (1 / sqrt(length_sq(x))));
    }
}

/// The line of a rod or a rope, whose ends are `apart`. Without any length it has none: then a rope is slack. One that has got too long in the
/// substep is taut: it is pushed back.
void set_line(const Vector& apart, scalar most, LoopJoint& loop) {
    const scalar length = sqrt(length_sq(apart));
    loop.is_slack = loop.is_slack && !(length > most);
    loop.direction[0] = length > 0 ? apart * (1 / length) : Vector{1, 0, 0};
}

/// A unit impulse on both bodies, and against it.
LoopRow row_of(const Spatial<scalar>& unit, const Vector& at_child, const Vector& at_other, bool is_tied) {
    return {impulse_from(unit, at_child), is_tied ? Spatial<scalar>{} : impulse_from(unit, at_other) * scalar(-1)};
}

void place_loop(const FigureView& view, const LoopView& loops, LoopJoint& loop) {
    if (locks_nothing(loop)) return;
    const JointRecord& record = view.lists.joints[loop.joint];
    const bool is_tied = loop.other == no_node;
    const Ground<scalar> ground = is_tied ? ground_at(view, loop.ground) : Ground<scalar>{};
    const PlacedFrame child = placed(rotation_of(view, loop.child), loop.is_A ? record.frame_A : record.frame_B);
    const PlacedFrame other = placed(is_tied ? ground.A : rotation_of(view, loop.other), loop.is_A ? record.frame_B : record.frame_A);
    loop.arm = child.arm;
    loop.arm_of_other = other.arm;
    const Vector between = place_of_body(view, loop.child) - (is_tied ? ground.r : place_of_body(view, loop.other));
    if (has_length(loop.kind)) {
        const scalar most = loops.ties[loop.joint].length_at(view.elapsed, view.h);
        set_line((between + child.arm) - other.arm, most, loop);
    }
    set_directions(loop, child, other);
    // Both sides act at the child's, so that they turn nothing between them; or at a wheel's.
    const Vector arm = loop.kind == JointKind::carriage ? other.arm - between : child.arm;
    const Vector at_child = from_q(view, loop.child, arm);
    Vector at_other{};
    if (!is_tied) at_other = from_q(view, loop.other, between + arm);
    for (int row = 0; row < loop.row_count; ++row) {  // bound: rows_of_joint_max
        const Vector d = loop.direction[row], none{};
        loop.rows[row] = row_of(loop.is_turn[row] ? Spatial<scalar>{d, none} : Spatial<scalar>{none, d}, at_child, at_other, is_tied);
    }
}

/// The same of the directions that it leaves free.
void place_free(const FigureView& view, LoopJoint& loop) {
    const LoopSides sides = sides_of(view, loop, 0);
    const bool is_tied = loop.other == no_node;
    const Vector at_child = from_q(view, loop.child, sides.arm_of_child(loop.kind));
    Vector at_other{};
    if (!is_tied) at_other = from_q(view, loop.other, sides.arm_of_other(loop.kind));
    Spatial<scalar> s[3];
    const int free = free_directions(loop.kind, loop_sides_now(loop, sides), s);
    for (int i = 0; i < free; ++i) loop.rows[loop.row_count + i] = row_of(s[i], at_child, at_other, is_tied);  // bound: 3
    loop.row_end = static_cast<uint8_t>(loop.row_count + free);
}

template <class At>
void add_to_impulse(const At& at, FigureRow<At::width>& row, const Spatial<scalar>& f) {
    write(at, row.impulse, read(at, row.impulse) + f);
}

/// Of a column of U, that of one figure: what its bodies answer to a row.
template <unsigned width>
void answer_row(const FigureRows<width>& rows, const OneLane<width>& at, const LoopView& loops, const LoopFigure& of, const LoopJoint& loop,
                int row) {
    const Spatial<scalar> none{};
    const int count = rows.count(), first = rows.figure(at.lane_i).first_node;
    for (int row_i = 0; row_i < count; ++row_i) write(at, rows[row_i].impulse, none);  // bound: max_bodies
    const auto give = [&](Index node_i, const Spatial<scalar>& f) {
        if (node_i >= first && node_i < first + count) add_to_impulse(at, rows[node_i - first], f);
    };
    for_bodies_of(loops, loop, row, give);
    for (int row_i = count - 1; row_i > 0; --row_i) {  // bound: max_bodies
        const FigureNode& node = rows.node(row_i);
        const Spatial<scalar> sent = impulse_through(at, rows[row_i], node.kind, read(at, rows[row_i].impulse), none.v);
        add_to_impulse(at, rows[node.parent], impulse_from(sent, read(at, rows[row_i].d)));
    }
    Spatial<scalar>* const column = loops.X_of(of, first - of.first_node) + loop.first_row + row;
    for (int row_i = 0; row_i < count; ++row_i) {
        const FigureNode& node = rows.node(row_i);
        Spatial<scalar> u{};
        if (node.kind == JointKind::none)
            u = twist_of_floating(at, rows[row_i]);
        else {
            if (node.parent != no_node) u = twist_at(column[node.parent * of.row_count], read(at, rows[row_i].d));
            u = twist_through(at, rows[row_i], node.kind, u, read(at, rows[row_i].impulse), none.v);
        }
        column[row_i * of.row_count] = u;
    }
}

/// U: of a row there is something in the figures of its two bodies alone.
void answer_rows(const FigureView& view, const LoopView& loops, const LoopFigure& of) {
    if (of.figure_count > 1)
        for (int i = 0; i < of.row_count * of.node_count; ++i) loops.X[of.first_column + i] = {};  // bound: limits::loop_rows_max max_bodies
    for_loop_joints(loops, of, [&](const LoopJoint& loop) {
        for (int row = 0; row < loop.row_count; ++row) {  // bound: rows_of_joint_max
            const auto answer = [&](Index node_i) {
                at_node(view, node_i, [&](const auto& rows, const auto& at, int) { answer_row(rows, at, loops, of, loop, row); });
            };
            answer(loop.child);
            if (loop.other != no_node && view.nodes[loop.other].figure != view.nodes[loop.child].figure) answer(loop.other);
        }
    });
}

/// What a row would give way if its bodies had no joints.
scalar free_compliance(const FigureView& view, Index node_i, const Spatial<scalar>& f) {
    return at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) {
        const auto& row = rows[row_i];
        const Matrix A = read(at, row.A);
        const Vector T = transpose_times(A, f.w - cross(read(at, row.c), f.v)), I = read(at, row.I_body);
        return length_sq(f.v) / at.get(row.M) + (T.x * T.x / I.x + T.y * T.y / I.y + T.z * T.z / I.z);
    });
}

/// The row of a gear in C.
void couple_gear(const FigureView& view, const LoopView& loops, const LoopFigure& of, const LoopJoint& loop, scalar* L, scalar* free) {
    const int i = loop.first_row;
    scalar* const entries = L + i * (i + 1) / 2;
    for (int k = 0; k <= i; ++k) entries[k] = 0;  // bound: limits::loop_rows_max
    free[i] = 0;
    for_bodies_of(loops, loop, 0, [&](Index node_i, const Spatial<scalar>& f) {
        const Spatial<scalar>* const X = loops.X_of(of, node_i - of.first_node);
        for (int k = 0; k <= i; ++k) entries[k] += dot(f, X[k]);  // bound: limits::loop_rows_max
        free[i] += free_compliance(view, node_i, f);
    });
}

/// C in the place of L. free: of each row, what it would give way without joints.
void couple_rows(const FigureView& view, const LoopView& loops, const LoopFigure& of, scalar* L, scalar* free) {
    const Index first = of.first_node;
    for_loop_joints(loops, of, [&](const LoopJoint& loop) {
        if (loop.kind == JointKind::gear) return couple_gear(view, loops, of, loop, L, free);
        const Spatial<scalar>* const of_child = loops.X_of(of, loop.child - first);
        const Spatial<scalar>* const of_other = loop.other == no_node ? nullptr : loops.X_of(of, loop.other - first);
        for (int row = 0; row < loop.row_count; ++row) {  // bound: rows_of_joint_max
            const int i = loop.first_row + row;
            scalar* const entries = L + i * (i + 1) / 2;
            for (int k = 0; k <= i; ++k) {  // bound: limits::loop_rows_max
                entries[k] = dot(loop.rows[row].on_child, of_child[k]);
                if (of_other != nullptr) entries[k] += dot(loop.rows[row].on_other, of_other[k]);
            }
            if (loop.kind == JointKind::target)
                for (int k = 0; k <= row; ++k) entries[loop.first_row + k] += give_between(view, loops, loop, row, k);  // bound: rows_of_joint_max
            if (is_left_out(loops, loop, row)) entries[i] = 0;
            free[i] = free_compliance(view, loop.child, loop.rows[row].on_child);
            if (loop.other != no_node) free[i] += free_compliance(view, loop.other, loop.rows[row].on_other);
        }
    });
}

/// A symmetric matrix by its lower triangle, some of whose rows are eliminated already.
struct Triangle {
    scalar* entries;
    int count;

    scalar& at(int i, int k) const { return entries[i * (i + 1) / 2 + k]; }  // k <= i
    static void swap(scalar& a, scalar& b) {
        const scalar c = a;
        a = b;
        b = c;
    }
    /// Rows and columns a < b change places.
    void exchange(int a, int b) const {
        for (int k = 0; k < a; ++k) swap(at(a, k), at(b, k));              // bound: limits::loop_rows_max
        for (int k = a + 1; k < b; ++k) swap(at(k, a), at(b, k));          // bound: limits::loop_rows_max
        for (int k = b + 1; k < count; ++k) swap(at(k, a), at(k, b));      // bound: limits::loop_rows_max
        swap(at(a, a), at(b, b));
    }
    /// Column i of L; the inverse of the diagonal in its place.
    void eliminate(int i) const {
        const scalar inverse = 1 / sqrt(at(i, i));
        at(i, i) = inverse;
        for (int k = i + 1; k < count; ++k) {  // bound: limits::loop_rows_max
            at(k, i) = at(k, i) * inverse;
            for (int m = i + 1; m <= k; ++m) at(k, m) -= at(k, i) * at(m, i);  // bound: limits::loop_rows_max
        }
    }
};

/// L of C = L L^T, the row first that gives way most by what the others have left it. Returns how many there are until none gives way any more.
/// least: see LoopFigure.
int factor_triangle(const Triangle& C, scalar* free, uint8_t* order, scalar& least) {
    for (int i = 0; i < C.count; ++i) order[i] = static_cast<uint8_t>(i);  // bound: limits::loop_rows_max
    for (int i = 0; i < C.count; ++i) {
        int best = i;
        for (int k = i + 1; k < C.count; ++k)  // bound: limits::loop_rows_max
            if (C.at(k, k) * free[best] > C.at(best, best) * free[k]) best = k;
        if (!(C.at(best, best) > limits::loop_compliance * free[best])) return i;
        least = min(least, C.at(best, best) / free[best]);
        if (best != i) {
            C.exchange(i, best);
            Triangle::swap(free[i], free[best]);
            const uint8_t row = order[i];
            order[i] = order[best];
            order[best] = row;
        }
        C.eliminate(i);
    }
    return C.count;
}

/// X = L^-1 U in the place of U, of one body.
void solve_triangle(const scalar* L, const LoopFigure& of, const uint8_t* order, Spatial<scalar>* X) {
    Spatial<scalar> U[limits::loop_rows_max];
    for (int i = 0; i < of.row_count; ++i) U[i] = X[i];  // bound: limits::loop_rows_max
    for (int i = 0; i < of.rank; ++i) {  // bound: limits::loop_rows_max
        const scalar* const of_i = L + i * (i + 1) / 2;
        Spatial<scalar> sum = U[order[i]];
        for (int k = 0; k < i; ++k) sum = sum - X[k] * of_i[k];  // bound: limits::loop_rows_max
        X[i] = sum * of_i[i];
    }
}

/// Rows that are left out give nothing.
void drop_impulses(const LoopView& loops, const LoopFigure& of, const uint8_t* order) {
    for (int i = of.rank; i < of.row_count; ++i)  // bound: limits::loop_rows_max
        for_loop_joints(loops, of, [&](LoopJoint& loop) {
            const int row = order[i] - loop.first_row;
            if (row >= 0 && row < loop.row_count && !is_given(loops, loop, row)) loop.j[row] = 0;
        });
}

}  // namespace

void place_loops(const FigureView& view, const LoopView& loops) {
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        for_loop_joints(loops, of, [&](LoopJoint& loop) {
            if (loop.kind == JointKind::gear) return place_gear(view, loops, of, loop);
            place_loop(view, loops, loop);
        });
    });
}

void place_free_rows(const FigureView& view, const LoopView& loops) {
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        for_loop_joints(loops, of, [&](LoopJoint& loop) {
            if (!is_tie(loop.kind)) place_free(view, loop);
        });
    });
}

void factor_loops_of(const FigureView& view, const LoopView& loops, LoopFigure& of) {
    scalar* const L = loops.L + of.first_entry;
    scalar* const free = loops.z + of.first_row;  // z is not asked for yet
    uint8_t* const order = loops.order + of.first_row;
    answer_rows(view, loops, of);
    couple_rows(view, loops, of, L, free);
    of.least = 1;
    of.rank = static_cast<Index>(factor_triangle({L, of.row_count}, free, order, of.least));
    drop_impulses(loops, of, order);
    for (int node_i = 0; node_i < of.node_count; ++node_i) solve_triangle(L, of, order, loops.X_of(of, node_i));  // bound: max_bodies
}

void factor_loops(const FigureView& view, const LoopView& loops) {
    for_looped_figures(view, loops, [&](LoopFigure& of) { factor_loops_of(view, loops, of); });
}

void factor_open_loops(const FigureView& view, const LoopView& loops) {
    for_looped_figures(view, loops, [&](LoopFigure& of) {
        if (of.is_settled) return;
        factor_loops_of(view, loops, of);
        for (int i = 0; i < of.row_count; ++i) loops.z[of.first_row + i] = 0;  // bound: limits::loop_rows_max
    });
}

} }  // namespace ingot
