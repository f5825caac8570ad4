// SPDX-License-Identifier: MIT
#include "respond_figures.h"

#include "close_loops.h"
#include "reached_bodies.h"
#include "tree_passes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// The response of a body whose joint turns freely; Q: how its joint gives way to a force, at q.
template <class At, class T = typename At::T>
Spatial6<T> response_of_ball(const At& at, const FigureRow<At::width>& row, const Sym3<T>& Q) {
    const Mat3<T> G = read(at, row.inertia.B), G_Q = G * Q;
    const Mat3<T> minus = {-G_Q.c0, -G_Q.c1, -G_Q.c2};
    return {read(at, row.inertia.A) + rotated(G, Q), minus, Q};
}

/// The same of a joint with some free directions; Q: how its parent gives way, at q.
template <class At, class T = typename At::T>
Spatial6<T> response_of_axes(const At& at, const FigureRow<At::width>& row, JointKind kind, Spatial6<T> Q) {
    const auto given_by = [&](int i, T& own) {
        const T inv_D = at.get(row.inv_D[i]);
        const Spatial<T> pulled = read(at, row.pulled[i]), given = Q * pulled * -inv_D;
        own = inv_D - dot(pulled, given) * inv_D;
        return given;
    };
    T own{};
    if (kind == JointKind::hinge) {
        const Vec3<T> n = read(at, row.axis);
        const Spatial<T> given = given_by(0, own);
        return {plus_square(plus_symmetric(Q.A, n, given.w), n, own), plus_outer(Q.B, n, given.v), Q.C};
    }
    if (kind == JointKind::driven_ball) {
        const Spatial<T> z = given_by(2, own);
        Q.A = {Q.A.xx, Q.A.yy, Q.A.zz + z.w.z + z.w.z + own, Q.A.xy, Q.A.xz + z.w.x, Q.A.yz + z.w.y};
        Q.B = {{Q.B.c0.x, Q.B.c0.y, Q.B.c0.z + z.v.x}, {Q.B.c1.x, Q.B.c1.y, Q.B.c1.z + z.v.y}, {Q.B.c2.x, Q.B.c2.y, Q.B.c2.z + z.v.z}};
        const Spatial<T> y = given_by(1, own);
        Q.A = {Q.A.xx, Q.A.yy + y.w.y + y.w.y + own, Q.A.zz, Q.A.xy + y.w.x, Q.A.xz, Q.A.yz + y.w.z};
        Q.B = {{Q.B.c0.x, Q.B.c0.y + y.v.x, Q.B.c0.z}, {Q.B.c1.x, Q.B.c1.y + y.v.y, Q.B.c1.z}, {Q.B.c2.x, Q.B.c2.y + y.v.z, Q.B.c2.z}};
        const Spatial<T> x = given_by(0, own);
        Q.A = {Q.A.xx + x.w.x + x.w.x + own, Q.A.yy, Q.A.zz, Q.A.xy + x.w.y, Q.A.xz + x.w.z, Q.A.yz};
        Q.B = {{Q.B.c0.x + x.v.x, Q.B.c0.y, Q.B.c0.z}, {Q.B.c1.x + x.v.y, Q.B.c1.y, Q.B.c1.z}, {Q.B.c2.x + x.v.z, Q.B.c2.y, Q.B.c2.z}};
        return Q;
    }
    Spatial<T> s[3];
    const int free = free_directions(at, row, kind, s);
    for (int i = free - 1; i >= 0; --i) {  // bound: 3
        const T inv_D = at.get(row.inv_D[i]);
        const Spatial<T> pulled = read(at, row.pulled[i]), given = Q * pulled * inv_D;
        Q = plus_symmetric(Q, s[i], given * splat<T>(-1));
        Q = plus_square(Q, s[i], dot(pulled, given) * inv_D + inv_D);
    }
    return Q;
}

template <unsigned width>
void respond_rows(const FigureRows<width>& rows, Spatial6Rows<1>* responses) {
    using T = typename AllLanes<width>::T;
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        const FigureRow<width>& row = rows[row_i];
        const FigureNode& node = rows.node(row_i);
        if (!is_reached(rows, row_i)) continue;
        Spatial6<T> Q{};
        if (node.kind == JointKind::none) Q.C = read(rows.all, row.inertia.C);
        if (node.parent != no_node) Q = compliance_at(read(rows.all, rows.response(responses, node.parent)), read(rows.all, row.d));
        write(rows.all, rows.response(responses, row_i),
              turns_freely(node.kind) ? response_of_ball(rows.all, row, Q.C) : response_of_axes(rows.all, row, node.kind, Q));
    }
}

}  // namespace

void respond_figures(const FigureView& view, Spatial6Rows<1>* responses) {
    for_groups(view, [responses](const auto& rows) { respond_rows(rows, responses); });
}

template <class Loops>
Spatial6<scalar> response_of_centre(const FigureView& view, [[maybe_unused]] const Loops& loops, const Spatial6Rows<1>* responses, Index node_i) {
    return at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) {
        Spatial6<scalar> response = read(at, rows.response(responses, row_i));
        if constexpr (Loops::closes) response = response + response_of_loops(view, loops, node_i);
        return compliance_at(response, read(at, rows[row_i].c));
    });
}

SymmetricMatrix inertia_of_node(const FigureView& view, Index node_i) {
    return at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) {
        return rotated_diagonal(read(at, rows[row_i].A), read(at, rows[row_i].I_body));
    });
}

namespace {

/// The twist of A, at q, for an impulse on B: up to the body that both hang on, and down.
template <unsigned width>
Spatial<scalar> twist_across(const FigureRows<width>& rows, const OneLane<width>& at, const Spatial6Rows<1>* responses, int row_A, int row_B,
                             Spatial<scalar> P) {
    int node = row_B;
    const auto holds_A = [&](int row_i) {
        int of_A = row_A;
        while (of_A > row_i) of_A = rows.node(of_A).parent;  // bound: max_bodies: a parent comes before its children
        return of_A == row_i;
    };
    while (!holds_A(node)) {  // bound: max_bodies
        P = impulse_from(impulse_through(at, rows[node], rows.node(node).kind, P, Vector{}), read(at, rows[node].d));
        node = rows.node(node).parent;
    }
    Spatial<scalar> u = read(at, rows.response(responses, node)) * P;
    // bound: max_bodies
    for (int of_A = row_A; of_A != node; of_A = rows.node(of_A).parent) rows.node(rows.node(of_A).parent).towards = static_cast<Index>(of_A);
    while (node != row_A) {  // bound: max_bodies
        node = rows.node(node).towards;
        const FigureRow<width>& row = rows[node];
        u = twist_through(at, row, rows.node(node).kind, twist_at(u, read(at, row.d)), Spatial<scalar>{}, Vector{});
    }
    return u;
}

}  // namespace

Spatial<scalar> twist_across(const FigureView& view, const Spatial6Rows<1>* responses, Index node_A, Index node_B, const Spatial<scalar>& on_B) {
    if (view.nodes[node_A].figure != view.nodes[node_B].figure) return {};
    const int row_B = node_B - view.figures[view.nodes[node_B].figure].first_node;
    return at_node(view, node_A, [&](const auto& rows, const auto& at, int row_A) {
        return twist_across(rows, at, responses, row_A, row_B, on_B);
    });
}

template <class Loops>
Across response_across(const FigureView& view, [[maybe_unused]] const Loops& loops, const Spatial6Rows<1>* responses, Index node_A, Index node_B) {
    const int row_B = node_B - view.figures[view.nodes[node_B].figure].first_node;
    [[maybe_unused]] const bool is_one_tree = view.nodes[node_A].figure == view.nodes[node_B].figure;  // ties hold two trees together
    return at_node(view, node_A, [&](const auto& rows, const auto& at, int row_A) {
        Vector c_B;
        if constexpr (Loops::closes)
            c_B = at_node(view, node_B, [](const auto& rows_of_B, const auto& of_B, int row_i) { return read(of_B, rows_of_B[row_i].c); });
        else
            c_B = read(at, rows[row_B].c);
        const auto answer = [&](const Vector& F, const Vector& T) {
            const Spatial<scalar> on_B = {T + cross(c_B, F), F};
            Spatial<scalar> u{};
            if (!Loops::closes || is_one_tree) u = twist_across(rows, at, responses, row_A, row_B, on_B);
            if constexpr (Loops::closes) u = u + response_across_loops(view, loops, node_A, node_B, on_B);
            return twist_at(u, read(at, rows[row_A].c));
        };
        const Vector axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        Spatial<scalar> of_force[3], of_moment[3];
        for (int i = 0; i < 3; ++i) {
            of_force[i] = answer(axes[i], {});
            of_moment[i] = answer({}, axes[i]);
        }
        return Across{{of_force[0].v, of_force[1].v, of_force[2].v},
                      {of_moment[0].v, of_moment[1].v, of_moment[2].v},
                      {of_force[0].w, of_force[1].w, of_force[2].w},
                      {of_moment[0].w, of_moment[1].w, of_moment[2].w}};
    });
}

// The linker takes the one that the scene calls.
template Spatial6<scalar> response_of_centre(const FigureView&, const NoLoops&, const Spatial6Rows<1>*, Index);
template Spatial6<scalar> response_of_centre(const FigureView&, const LoopView&, const Spatial6Rows<1>*, Index);
template Across response_across(const FigureView&, const NoLoops&, const Spatial6Rows<1>*, Index, Index);
template Across response_across(const FigureView&, const LoopView&, const Spatial6Rows<1>*, Index, Index);

} }  // namespace ingot

#pragma GCC diagnostic pop
