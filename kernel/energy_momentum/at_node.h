// SPDX-License-Identifier: MIT
// A body of a figure in a step: its rows, and what follows from them.
#pragma once

#include "../math/sqrt.h"
#include "newton_pass.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

template <class T>
INGOT_INLINE Vec3<T> mean_of(const Vec3<T>& a, const Vec3<T>& b) {
    return (a + b) * splat<T>(scalar(0.5));
}
template <class T>
INGOT_INLINE T length_of(const Vec3<T>& a) {
    return sqrt(length_sq(a));
}

/// Arms and places at the begin, at the end (_1) and in the mean of the step; q: see NewtonRow.
template <unsigned width_of_rows>
struct AtNode {
    static constexpr unsigned width = width_of_rows;
    using T = typename AllLanes<width>::T;
    static constexpr AllLanes<width> all{};

    const NewtonStep<width>& step;
    int row_i;
    const FigureNode& node;
    const FigureRow<width>& row;
    NewtonRow<width>& newton;

    AtNode(const NewtonStep<width>& of_step, int of_row)
        : step(of_step), row_i(of_row), node(of_step.figures.node(of_row)), row(of_step.figures[of_row]),
          newton(newton_row(of_step.figures, of_step.rows, of_row)) {}

    bool has_parent() const { return node.parent != no_node; }
    bool has_joint() const { return node.kind != JointKind::none; }
    AtNode parent() const { return {step, node.parent}; }

    T M() const { return all.get(row.M); }
    /// From the centre of mass to q.
    Vec3<T> own_arm() const { return -read(all, row.c); }
    Vec3<T> s_1() const { return read(all, newton.s_1); }
    Vec3<T> e_1() const { return read(all, newton.e_1); }
    Vec3<T> mean_own_arm() const { return mean_of(own_arm(), s_1()); }
    Vec3<T> mean_arm_of_parent() const { return mean_of(read(all, newton.e_0), e_1()); }
    /// From the parent's q to where the joint acts on the parent: at the end, and in the mean.
    Vec3<T> end_from(const AtNode& of_parent) const { return e_1() - of_parent.s_1(); }
    Vec3<T> mean_from(const AtNode& of_parent) const { return mean_arm_of_parent() - of_parent.mean_own_arm(); }

    /// Where the parent is as the step begins, or the ground.
    Vec3<T> r_of_parent() const { return has_parent() ? read(all, step.figures[node.parent].r) : step.ground.r; }
    Mat3<T> A_of_parent() const { return has_parent() ? read(all, step.figures[node.parent].A) : step.ground.A; }

    Tangent<T> N() const { return {read(all, newton.N[0]), read(all, newton.N[1]), read(all, newton.N[2]), read(all, newton.N[3])}; }
    void set_N(const Tangent<T>& N) const {
        write(all, newton.N[0], N.A);
        write(all, newton.N[1], N.B);
        write(all, newton.N[2], N.C);
        write(all, newton.N[3], N.D);
    }
    template <class Value, class Kept>
    void add(Kept& kept, const Value& value) const {
        write(all, kept, read(all, kept) + value);
    }
    void add(scalar (&kept)[width], T value) const { all.put(kept, all.get(kept) + value); }
};

/// L at the end: R (2/h I_0 theta - L). Needs: turn.
template <unsigned width, class T = typename AllLanes<width>::T>
Vec3<T> momentum_after(const AtNode<width>& at, const Sym3<T>& I_0, const Mat3<T>& turn, T twice_rate) {
    const Vec3<T> L_back = I_0 * read(at.all, at.newton.theta) * twice_rate - read(at.all, at.row.L);
    return L_back + turn * L_back;
}

} }  // namespace ingot

#pragma GCC diagnostic pop
