// SPDX-License-Identifier: MIT
#include "fit_to_joints.h"

#include "../base/figure_limits.h"
#include "../figure/factor_figures.h"
#include "../figure/displace_rows.h"
#include "../figure/joint_sides.h"
#include "../figure/move_figures.h"
#include "../figure/row_motion.h"
#include "../math/sqrt.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

template <unsigned width, class T = typename AllLanes<width>::T>
Spatial<T> velocity_at_joint(const FigureRows<width>& figures, const FigureRow<width>& row) {
    return twist_at(Spatial<T>{read(figures.all, row.w), read(figures.all, row.v)}, -read(figures.all, row.c));
}

/// Finds what has to change for joints to allow the velocities. Needs: place_joints, factors.
template <unsigned width, class T = typename AllLanes<width>::T>
void find_change(const FigureView& view, const FigureRows<width>& figures) {
    begin_displacing(view);
    const Ground<T> ground = ground_of(figures, figures.all);
    for (int row_i = 0; row_i < figures.count(); ++row_i) {  // bound: max_bodies
        const FigureNode& node = figures.node(row_i);
        if (node.kind == JointKind::none) continue;
        FigureRow<width>& row = figures[row_i];
        Spatial<T> of_parent = twist_at(Spatial<T>{ground.w, ground.v}, (read(figures.all, row.r) - ground.r) - read(figures.all, row.c));
        if (node.parent != no_node) of_parent = twist_at(velocity_at_joint(figures, figures[node.parent]), read(figures.all, row.d));
        write(figures.all, row.bias, of_parent - velocity_at_joint(figures, row));
    }
    pass_impulses(view);
}

template <unsigned width, class Mask, class T = typename AllLanes<width>::T>
void take_change(const FigureRows<width>& figures, Mask takes) {
    for (int row_i = 0; row_i < figures.count(); ++row_i) {  // bound: max_bodies
        FigureRow<width>& row = figures[row_i];
        const Spatial<T> u = change_of_centre(figures.all, row);
        const Vec3<T> v = read(figures.all, row.v), L = read(figures.all, row.L);
        write(figures.all, row.v, select(takes, v + u.v, v));
        write(figures.all, row.L, select(takes, L + momentum_of_spin(figures.all, row, u.w), L));
    }
}

/// The motion of a figure as one rigid body; none of one that is tied.
template <class T>
struct WholeMotion {
    Vec3<T> r, v, w;  ///< of its centre of mass
    T energy;         ///< J, of the spin alone
};
template <unsigned width, class T = typename AllLanes<width>::T>
WholeMotion<T> motion_of_whole(const FigureRows<width>& figures) {
    WholeMotion<T> whole{};
    if (figures.node(0).kind != JointKind::none) return whole;
    T M{};
    Vec3<T> Mr{}, Mv{}, L{};
    const Vec3<T> origin = read(figures.all, figures[0].r);  // far from the world's, differences keep their digits
    for (int row_i = 0; row_i < figures.count(); ++row_i) {  // bound: max_bodies
        const FigureRow<width>& row = figures[row_i];
        const T M_of_row = figures.all.get(row.M);
        M = M + M_of_row;
        Mr = Mr + (read(figures.all, row.r) - origin) * M_of_row;
        Mv = Mv + read(figures.all, row.v) * M_of_row;
    }
    whole.v = Mv * (splat<T>(1) / M);
    const Vec3<T> centre = Mr * (splat<T>(1) / M);
    whole.r = origin + centre;
    Sym3<T> I{};
    for (int row_i = 0; row_i < figures.count(); ++row_i) {
        const FigureRow<width>& row = figures[row_i];
        const T M_of_row = figures.all.get(row.M), zero{};
        const Vec3<T> d = (read(figures.all, row.r) - origin) - centre;
        const T dd = length_sq(d) * M_of_row;
        L = L + read(figures.all, row.L) + cross(d, (read(figures.all, row.v) - whole.v) * M_of_row);
        const Sym3<T> own = rotated_diagonal(read(figures.all, row.A), read(figures.all, row.I_body));
        I = plus_square(I + own + Sym3<T>{dd, dd, dd, zero, zero, zero}, d, -M_of_row);
    }
    whole.w = inverse_of(I) * L;
    whole.energy = dot(whole.w, L) * splat<T>(scalar(0.5));
    return whole;
}

/// J, without the motion of the centre of mass of what floats.
template <class T>
struct KineticShares {
    T kinetic;  ///< by the velocities of rows
    T taken;    ///< of that, by the change that was found: what is left is at right angles to it
};
template <unsigned width, class T = typename AllLanes<width>::T>
KineticShares<T> kinetic_shares_of(const FigureRows<width>& figures, const Vec3<T>& v_of_centre) {
    T kinetic{}, taken{};
    for (int row_i = 0; row_i < figures.count(); ++row_i) {  // bound: max_bodies
        const FigureRow<width>& row = figures[row_i];
        const Spatial<T> u = change_of_centre(figures.all, row);
        const T M = figures.all.get(row.M);
        kinetic = kinetic + M * length_sq(read(figures.all, row.v) - v_of_centre) + dot(read(figures.all, row.w), read(figures.all, row.L));
        taken = taken + M * length_sq(u.v) + dot(u.w, momentum_of_spin(figures.all, row, u.w));  // at right angles to what is left
    }
    return {kinetic * splat<T>(scalar(0.5)), taken * splat<T>(scalar(0.5))};
}

/// What joints take is a part of what there is, but for what ground gives that moves. More is made of roundings, as where the axes of a universal
/// joint lie on each other.
template <class T, class Mask>
auto is_a_part(const KineticShares<T>& energy, Mask is_at_rest) {
    return either(opposite(is_at_rest), energy.taken <= energy.kinetic * splat<T>(2));
}
template <unsigned width>
auto lanes_of_ground_at_rest(const FigureRows<width>& figures) {
    const auto ground = ground_of(figures, figures.all);
    return opposite(length_sq(ground.v) + length_sq(ground.w) > typename AllLanes<width>::T{});
}

/// What bodies do beside the motion of the whole becomes s times as fast.
template <unsigned width, class Mask, class T = typename AllLanes<width>::T>
void scale_motion(const FigureRows<width>& figures, const WholeMotion<T>& whole, Mask scales, T s) {
    for (int row_i = 0; row_i < figures.count(); ++row_i) {  // bound: max_bodies
        FigureRow<width>& row = figures[row_i];
        const Vec3<T> v = read(figures.all, row.v), L = read(figures.all, row.L), L_whole = momentum_of_spin(figures.all, row, whole.w);
        const Vec3<T> v_whole = whole.v + cross(whole.w, read(figures.all, row.r) - whole.r);
        write(figures.all, row.v, select(scales, v_whole + (v - v_whole) * s, v));
        write(figures.all, row.L, select(scales, L_whole + (L - L_whole) * s, L));
    }
}

/// By a turn that is a rounding: so is its square. That of a body with 10^6 rad/s is none.
template <class T>
Mat3<T> turned_back(const Mat3<T>& A, const Vec3<T>& turn) {
    const Mat3<T> turned = A + cross(turn, A);
    const auto is_far = length_sq(turn) > splat<T>(epsilon);
    if (!any(is_far)) return turned;
    return select(is_far, Mat3<T>{A.c0 + chord(turn, A.c0), A.c1 + chord(turn, A.c1), A.c2 + chord(turn, A.c2)}, turned);
}

}  // namespace

template <unsigned width>
void take_up_roundings(const FigureRows<width>& figures) {
    for (int row_i = 0; row_i < figures.count(); ++row_i) {  // bound: max_bodies
        const JointKind kind = figures.node(row_i).kind;
        if (kind == JointKind::none) continue;
        FigureRow<width>& row = figures[row_i];
        auto sides = sides_now(figures, figures.all, row_i, locks_turns(kind));
        if (kind != JointKind::ball) {
            const auto A = read(figures.all, row.A), turned = turned_back(A, twist_back(kind, sides).w);
            write(figures.all, row.A, turned + polar_correction(turned));
            sides.gap = sides_now(figures, figures.all, row_i, false).gap;
        }
        write(figures.all, row.r, read(figures.all, row.r) + twist_back(kind, sides).v);
    }
}

template <unsigned width>
unsigned fit_to_joints(const FigureView& view, const FigureRows<width>& figures) {
    place_joints(view);
    factor_figures(view, NoLoops{}, 0);
    push_figures(view, NoLoops{}, false);
    const auto is_together = opposite(apart_lanes(figures));
    set_spins(figures);
    place_joints(view);
    factor_figures(view, NoLoops{}, 0);
    find_change(view, figures);
    const auto is_part = is_a_part(kinetic_shares_of(figures, motion_of_whole(figures).v), lanes_of_ground_at_rest(figures));
    take_change(figures, is_part);
    set_spins(figures);
    return bits(both(is_together, is_part));
}

template <unsigned width>
void take_hidden_energy(const FigureView& view, const FigureRows<width>& figures, Snap snap) {
    using T = typename AllLanes<width>::T;
    place_joints(view);
    factor_figures(view, NoLoops{}, 0);
    find_change(view, figures);
    const WholeMotion<T> whole = motion_of_whole(figures);
    const KineticShares<T> energy = kinetic_shares_of(figures, whole.v);
    const auto is_at_rest = lanes_of_ground_at_rest(figures);
    const auto takes = both(is_a_part(energy, is_at_rest), energy.taken > splat<T>(limits::hidden_share) * energy.kinetic);
    if (!any(takes)) return;
    take_change(figures, takes);
    const T left = (energy.kinetic - energy.taken) - whole.energy, none{};
    const auto scales = both(takes, both(is_at_rest, left > none));
    if (snap == Snap::keep && any(scales)) {
        const T gain = min(splat<T>(1) + energy.taken / select(scales, left, splat<T>(1)), splat<T>(limits::snap_gain_max));
        scale_motion(figures, whole, scales, sqrt(select(scales, gain, splat<T>(1))));
    }
    set_spins(figures);
}

template unsigned fit_to_joints(const FigureView& view, const FigureRows<1>& figures);
template void take_hidden_energy(const FigureView& view, const FigureRows<1>& figures, Snap snap);
template void take_up_roundings(const FigureRows<1>& figures);
#if INGOT_LANES > 1
template unsigned fit_to_joints(const FigureView& view, const FigureRows<lanes>& figures);
template void take_hidden_energy(const FigureView& view, const FigureRows<lanes>& figures, Snap snap);
template void take_up_roundings(const FigureRows<lanes>& figures);
#endif

} }  // namespace ingot

#pragma GCC diagnostic pop
