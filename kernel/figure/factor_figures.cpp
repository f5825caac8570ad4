// SPDX-License-Identifier: MIT
#include "factor_figures.h"

#include "../base/figure_limits.h"
#include "ground.h"
#include "tree_passes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
INGOT_INLINE void place_joint(const FigureRows<width, Kinds>& rows, int row_i) {
    FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i);
    const Mat3<T> A = read(rows.all, row.A);
    if (node.kind == JointKind::none) return write(rows.all, row.c, Vec3<T>{});
    const Vec3<T> own = A * rows.own_anchor(row_i);
    const Mat3<T> A_parent = node.parent == no_node ? ground_of(rows, rows.all).A : read(rows.all, rows[node.parent].A);
    write(rows.all, row.c, -own);
    write(rows.all, row.arm_of_parent, A_parent * rows.anchor_of_parent(row_i));
    write(rows.all, row.axis, A * rows.gathered(row_i, [&](const FigureNode& of) { return rows.own_frame(of).axis; }));
    write(rows.all, row.axis_of_parent, A_parent * rows.gathered(row_i, [&](const FigureNode& of) { return rows.frame_of_parent(of).axis; }));
    if (node.parent == no_node) return;
    const FigureRow<width>& parent = rows[node.parent];
    write(rows.all, row.d, (read(rows.all, row.r) - read(rows.all, parent.r)) + own + read(rows.all, parent.c));
}

/// The inertia of a body about q.
template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
void begin_inertia(const FigureRows<width, Kinds>& rows, FigureRow<width>& row) {
    const T M = rows.all.get(row.M), zero{};
    const Vec3<T> c = read(rows.all, row.c), mc = c * M;
    const T mcc = dot(c, mc);
    const Sym3<T> I = rotated_diagonal(read(rows.all, row.A), read(rows.all, row.I_body));
    const Sym3<T> about_q = plus_square(I + Sym3<T>{mcc, mcc, mcc, zero, zero, zero}, c, -M);
    write(rows.all, row.inertia, Spatial6<T>{about_q, tilde(mc), {M, M, M, zero, zero, zero}});
}

template <unsigned width, class Kinds, class M>
void mark_stiff(const FigureRows<width, Kinds>& rows, const AllLanes<width, Kinds>&, M is_stiff) {
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i)  // bound: lanes
        if ((bits(is_stiff) >> lane_i & 1u) != 0) rows.figure(lane_i).resolved = false;
}
template <unsigned width, class Kinds>
void mark_stiff(const FigureRows<width, Kinds>& rows, const OneLane<width>& at, bool is_stiff) {
    if (is_stiff) rows.figure(at.lane_i).resolved = false;
}

/// Adds what tension does at an arm; j: what the joint gave to the body.
template <unsigned width, class Kinds, class At, class T = typename At::T>
void stiffen(const FigureRows<width, Kinds>& rows, const At& at, FigureRow<width>& row, const Vec3<T>& j, const Vec3<T>& arm, scalar h) {
    const Vec3<T> I = read(at, row.I_body);
    const T least = min(I.x, min(I.y, I.z)), tension = dot(j, arm) * splat<T>(h), zero{};
    const auto is_stiff = tension > least * splat<T>(limits::stiff_tension);
    if (!any(is_stiff)) return;
    const T half = select(is_stiff, tension * splat<T>(scalar(0.5)), zero);
    const Sym3<T> A = read(at, row.inertia.A) + Sym3<T>{half, half, half, zero, zero, zero};
    write(at, row.inertia.A, plus_square(A, arm, -half / select(is_stiff, length_sq(arm), splat<T>(1))));
    mark_stiff(rows, at, is_stiff);
}

void stiffen_loops(const FigureView& view, const LoopView& loops, scalar h) {
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        const auto stiffen_node = [&](Index node_i, const Vector& j, const Vector& arm) {
            at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) { stiffen(rows, at, rows[row_i], j, arm, h); });
        };
        for_loop_joints(loops, of, [&](const LoopJoint& loop) {
            stiffen_node(loop.child, loop.given, loop.arm);
            if (loop.other != no_node) stiffen_node(loop.other, -loop.given, loop.arm_of_other);
        });
    });
}

/// Joints without drives.
struct NoDrives {
    template <unsigned width, class Kinds, class T>
    static T resisted(const FigureRows<width, Kinds>&, int, int, T D) {
        return D;
    }
};
struct Drives {
    const DrivenRowView& all;

    template <unsigned width, class Kinds, class T>
    T resisted(const FigureRows<width, Kinds>& rows, int row_i, int direction_i, T D) const {
        scalar resist[width];
        for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i) {  // bound: lanes
            const DriveMotion& motion = drive_motion(rows.node(row_i, lane_i), all, direction_i);
            resist[lane_i] = motion.saturated ? 0 : motion.resist;
        }
        return D + rows.all.get(resist);
    }
};

template <unsigned width, class Kinds, class Resist, class T = typename AllLanes<width>::T>
INGOT_INLINE void factor_row(const FigureRows<width, Kinds>& rows, int row_i, const Resist& drives) {
    FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i);
    const JointKind kind = rows.kind(row_i);
    Spatial6<T> M = read(rows.all, row.inertia), left;
    if (turns_freely(kind)) {
        M.A = inverse_of(M.A);
        const Mat3<T> B = M.B;
        M.B = {M.A * B.c0, M.A * B.c1, M.A * B.c2};
        M.C = M.C - Sym3<T>{dot(B.c0, M.B.c0), dot(B.c1, M.B.c1), dot(B.c2, M.B.c2), dot(B.c0, M.B.c1), dot(B.c0, M.B.c2), dot(B.c1, M.B.c2)};
        left = Spatial6<T>{Sym3<T>{}, Mat3<T>{}, M.C};
        if (kind == JointKind::none) M.C = inverse_of(M.C);
    } else {
        const auto eliminate = [&](int i, const Spatial<T>& pulled, T own) {
            const T inv_D = splat<T>(1) / drives.resisted(rows, row_i, i, own);
            write(rows.all, row.pulled[i], pulled);
            rows.all.put(row.inv_D[i], inv_D);
            M = plus_square(M, pulled, -inv_D);
        };
        if (kind == JointKind::hinge) {
            const Vec3<T> n = read(rows.all, row.axis), pulled = M.A * n;
            eliminate(0, {pulled, transpose_times(M.B, n)}, dot(n, pulled));
        } else if (kind == JointKind::driven_ball) {
            eliminate(0, {{M.A.xx, M.A.xy, M.A.xz}, {M.B.c0.x, M.B.c1.x, M.B.c2.x}}, M.A.xx);
            eliminate(1, {{M.A.xy, M.A.yy, M.A.yz}, {M.B.c0.y, M.B.c1.y, M.B.c2.y}}, M.A.yy);
            eliminate(2, {{M.A.xz, M.A.yz, M.A.zz}, {M.B.c0.z, M.B.c1.z, M.B.c2.z}}, M.A.zz);
        } else {
            Spatial<T> s[3];
            const int free = free_directions(rows.all, row, kind, s);
            for (int i = 0; i < free; ++i) {  // bound: 3
                const Spatial<T> pulled = M * s[i];
                eliminate(i, pulled, dot(s[i], pulled));
            }
        }
        left = M;
    }
    write(rows.all, row.inertia, M);
    if (node.parent == no_node) return;
    FigureRow<width>& parent = rows[node.parent];
    write(rows.all, parent.inertia, read(rows.all, parent.inertia) + inertia_from(left, read(rows.all, row.d)));
}

template <unsigned width, class Kinds>
INGOT_INLINE void begin_rows(const FigureRows<width, Kinds>& rows, scalar h) {
    for (int row_i = 0; row_i < rows.count(); ++row_i) begin_inertia(rows, rows[row_i]);  // bound: max_bodies
    for (int row_i = 0; row_i < rows.count(); ++row_i) {
        const FigureNode& node = rows.node(row_i);
        if (node.kind == JointKind::none) continue;
        FigureRow<width>& row = rows[row_i];
        const auto j = read(rows.all, row.j);
        stiffen(rows, rows.all, row, j, -read(rows.all, row.c), h);
        if (node.parent != no_node) stiffen(rows, rows.all, rows[node.parent], -j, read(rows.all, row.arm_of_parent), h);
    }
}

template <class Loops, class Resist>
void factor_all(const FigureView& view, [[maybe_unused]] const Loops& loops, const Resist& drives, scalar h) {
    if constexpr (Loops::closes) {
        for_groups(view, [&](const auto& rows) { begin_rows(rows, h); });
        stiffen_loops(view, loops, h);
    }
    for_groups<typename Loops::Kinds>(view, [&](const auto& rows) {
        if constexpr (!Loops::closes) begin_rows(rows, h);
        for (int row_i = rows.count() - 1; row_i >= 0; --row_i) factor_row(rows, row_i, drives);  // bound: max_bodies
    });
}

}  // namespace

template <class Kinds>
void place_joints(const FigureView& view) {
    for_groups<Kinds>(view, [](const auto& rows) {
        for (int row_i = 0; row_i < rows.count(); ++row_i) place_joint(rows, row_i);  // bound: max_bodies
    });
}

template <class Loops>
void factor_figures(const FigureView& view, const Loops& loops, scalar h) {
    factor_all(view, loops, NoDrives{}, h);
}

void factor_figures(const FigureView& view, const DrivenRowView& all, scalar h) { factor_all(view, NoLoops{}, Drives{all}, h); }
void factor_figures(const FigureView& view, const LoopedRowView& all, scalar h) {
    if (all.drives_of_joint > 0)
        factor_all(view, *all.loops, Drives{all}, h);
    else
        factor_all(view, *all.loops, NoDrives{}, h);
}

// The linker takes the one that the scene calls.
template void place_joints<AnyKinds>(const FigureView&);
template void place_joints<HingesAlone>(const FigureView&);
template void factor_figures(const FigureView&, const NoLoops&, scalar);
template void factor_figures(const FigureView&, const NoLoopsOfHinges&, scalar);
template void factor_figures(const FigureView&, const LoopView&, scalar);

} }  // namespace ingot

#pragma GCC diagnostic pop
