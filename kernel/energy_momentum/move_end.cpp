// SPDX-License-Identifier: MIT
#include "at_node.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// A turn phi of the end, world axes, as a change of theta: (1 - theta~/2 + theta theta^T/4) phi.
template <class T>
INGOT_INLINE Vec3<T> change_of_theta(const Vec3<T>& theta, const Vec3<T>& phi) {
    return phi - cross(theta, phi) * splat<T>(scalar(0.5)) + theta * (dot(theta, phi) * splat<T>(scalar(0.25)));
}
/// The other way: k' . phi is k . (change of theta).
template <class T>
INGOT_INLINE Vec3<T> seen_from_end(const Vec3<T>& theta, const Vec3<T>& k) {
    return k + cross(theta, k) * splat<T>(scalar(0.5)) + theta * (dot(theta, k) * splat<T>(scalar(0.25)));
}

/// Takes the balance of a body, and how it answers a change of the end, from the centre of mass to q.
template <unsigned width, class T = typename AllLanes<width>::T>
void move_to_joint(const AtNode<width>& at) {
    const T m = at.M() * splat<T>(2 / at.step.h), zero{};
    const Vec3<T> mean = at.mean_own_arm(), s_1 = at.s_1();
    const Mat3<T> A = read(at.all, at.newton.N[0]) - tilde_tilde(mean, s_1) * m;
    at.set_N({A, tilde(mean * -m), tilde(s_1 * m), {{m, zero, zero}, {zero, m, zero}, {zero, zero, m}}});
    write(at.all, at.newton.lack, impulse_from(read(at.all, at.newton.lack), -mean));
}

/// A direction in which a joint is free.
template <class T>
struct FreeDirection {
    Spatial<T> S;                 ///< of changes at the end
    Spatial<T> W;                 ///< of balances in the mean of the step: W . f = 0
    Vec3<T> by_child, by_parent;  ///< what a turn of either body adds to W . f, because W turns with it
};
/// Of a joint that is no ball. Returns how many there are.
template <unsigned width, class T = typename AllLanes<width>::T>
int free_directions_of(const AtNode<width>& at, FreeDirection<T> (&free)[2]) {
    const T half = splat<T>(scalar(0.5));
    const Vec3<T> none{}, n = read(at.all, at.newton.axis_1), n_0 = read(at.all, at.row.axis);
    const Vec3<T> n_of_parent = read(at.all, at.newton.axis_of_parent_1);
    const Spatial<T> f = read(at.all, at.newton.f);
    const auto about = [&](const Vec3<T>& end, const Vec3<T>& start) {
        return FreeDirection<T>{{end, none}, {mean_of(start, end), none}, none, none};
    };
    switch (at.node.kind) {
        case JointKind::hinge:
            free[0] = about(n, n_0);
            free[0].by_child = cross(n, f.w) * half;
            return 1;
        case JointKind::slider: {
            // W is neither the axis at an end nor their mean: along it no force does work as the body slides and turns at once.
            const Vec3<T> theta = read(at.all, at.newton.theta);
            free[0] = {{none, n}, {none, n_0 + cross(theta, n_0) * half}, seen_from_end(theta, cross(n_0, f.v)) * half, none};
            return 1;
        }
        case JointKind::universal:
            free[0] = about(n_of_parent, read(at.all, at.row.axis_of_parent));
            free[0].by_parent = cross(n_of_parent, f.w) * half;
            free[1] = about(n, n_0);
            free[1].by_child = cross(n, f.w) * half;
            return 2;
        default: return 0;
    }
}

/// The inverse of D, 1x1 or 2x2.
template <class T>
void invert(T (&D)[2][2], int count) {
    if (count == 1) {
        D[0][0] = splat<T>(1) / D[0][0];
        return;
    }
    const T s = splat<T>(1) / (D[0][0] * D[1][1] - D[0][1] * D[1][0]), d = D[0][0];
    D[0][0] = D[1][1] * s;
    D[1][1] = d * s;
    D[0][1] = -D[0][1] * s;
    D[1][0] = -D[1][0] * s;
}

/// Takes the free turns of a ball out, and those of a root that floats: what is left is between forces and shifts.
template <unsigned width, class T = typename AllLanes<width>::T>
void eliminate_ball(const AtNode<width>& at) {
    Tangent<T> N = at.N();
    Spatial<T> lack = read(at.all, at.newton.lack);
    const Factored3<T> A(N.A);
    N.B = A.solve(N.B);
    lack.w = A.solve(lack.w);
    N.D = N.D - N.C * N.B;
    lack.v = lack.v - N.C * lack.w;
    write(at.all, at.newton.N[1], N.B);
    write(at.all, at.newton.N[3], N.D);
    write(at.all, at.newton.lack, lack);
}
/// Adds what is left of a body on a ball to its parent.
template <unsigned width, class T = typename AllLanes<width>::T>
void send_of_ball(const AtNode<width>& at, const AtNode<width>& parent) {
    const Vec3<T> end = at.end_from(parent), mean = at.mean_from(parent);
    const Mat3<T> D = read(at.all, at.newton.N[3]), D_end = times_tilde(D, end);
    const Tangent<T> N = parent.N();
    parent.set_N({N.A - cross(mean, D_end), N.B + cross(mean, D), N.C - D_end, N.D + D});
    const Vec3<T> sent = read(at.all, at.newton.lack).v + D * read(at.all, at.newton.back).v;
    parent.add(parent.newton.lack, Spatial<T>{cross(mean, sent), sent});
}

/// The same of a body on another joint. free: its first direction.
template <unsigned width, class T = typename AllLanes<width>::T>
void send_of_free(const AtNode<width>& at, const AtNode<width>& parent, Tangent<T> sent, Spatial<T> lack, const FreeDirection<T>& free) {
    const Spatial<T> back = read(at.all, at.newton.back);
    if (at.node.kind == JointKind::slider) {  // its arm on the parent grows as it slides
        const Vec3<T> force = read(at.all, at.newton.f).v;
        const Vec3<T> x = cross(force, free.S.v) * splat<T>(scalar(0.5));
        const Spatial<T> rate = read(at.all, at.newton.rate[0]);
        sent.A = plus_outer(sent.A, x, rate.w);
        sent.B = plus_outer(sent.B, x, rate.v);
        lack.w = lack.w - x * at.all.get(at.newton.at[0]) - cross(force, back.v) * splat<T>(scalar(0.5));
    }
    const Vec3<T> mean = at.mean_from(parent);
    parent.set_N(parent.N() + tangent_from(sent, at.end_from(parent), mean));
    parent.add(parent.newton.lack, impulse_from(lack + sent * back, mean));
}

/// Takes the free directions of any other joint out, and adds what is left to the parent.
template <unsigned width, class T = typename AllLanes<width>::T>
void eliminate_free(const AtNode<width>& at) {
    NewtonRow<width>& newton = at.newton;
    FreeDirection<T> free[2];
    const int count = free_directions_of(at, free);
    Tangent<T> N = at.N();
    Spatial<T> lack = read(at.all, newton.lack), row[2], pulled[2];
    const Spatial<T> f = read(at.all, newton.f);
    const Vec3<T> back = read(at.all, newton.back).w;
    T D[2][2], off[2];
    for (int i = 0; i < count; ++i) {  // bound: 2
        row[i] = transpose_times(N, free[i].W) + Spatial<T>{free[i].by_child, {}};
        pulled[i] = N * free[i].S;
        off[i] = dot(free[i].W, lack + f) - dot(free[i].by_parent, back);
    }
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < count; ++k) D[i][k] = dot(row[i], free[k].S);  // bound: 2
    invert(D, count);
    for (int i = 0; i < count; ++i) row[i].w = row[i].w + free[i].by_parent;
    for (int i = 0; i < count; ++i) {
        Spatial<T> rate = row[0] * D[i][0];
        T to = -off[0] * D[i][0];
        for (int k = 1; k < count; ++k) {  // bound: 2
            rate = rate + row[k] * D[i][k];
            to = to - off[k] * D[i][k];
        }
        write(at.all, newton.rate[i], rate);
        at.all.put(newton.at[i], to);
    }
    for (int i = 0; i < count; ++i) {
        N = minus_outer(N, pulled[i], read(at.all, newton.rate[i]));
        lack = lack + pulled[i] * at.all.get(newton.at[i]);
    }
    at.set_N(N);
    write(at.all, newton.lack, lack);
    if (at.has_parent()) send_of_free(at, at.parent(), N, lack, free[0]);
}

template <unsigned width>
void eliminate_row(const AtNode<width>& at) {
    if (at.has_joint() && at.node.kind != JointKind::ball) return eliminate_free(at);
    eliminate_ball(at);
    if (at.has_parent()) send_of_ball(at, at.parent());
}

/// The change of a body, at q: it goes into `back`, for what hangs on the body, and in lanes that move into the end. of_parent: the change of its
/// parent, taken at q.
template <unsigned width, class Mask, class T = typename AllLanes<width>::T>
void move_row(const AtNode<width>& at, const Spatial<T>& of_parent, Mask moves) {
    NewtonRow<width>& newton = at.newton;
    const Spatial<T> lack = read(at.all, newton.lack), f = read(at.all, newton.f);
    const Tangent<T> N = at.N();
    Spatial<T> u = of_parent + read(at.all, newton.back), given{};
    if (!at.has_joint()) {
        u.v = -Factored3<T>(N.D).solve(lack.v);
        u.w = -(lack.w + N.B * u.v);
    } else if (at.node.kind == JointKind::ball) {
        u.w = -(lack.w + N.B * u.v);
        given.v = lack.v + N.D * u.v;
    } else {
        FreeDirection<T> free[2];
        const int count = free_directions_of(at, free);
        given = lack + N * u;
        const Spatial<T> taken = u;
        for (int i = 0; i < count; ++i)  // bound: 2
            u = u + free[i].S * (at.all.get(newton.at[i]) - dot(read(at.all, newton.rate[i]), taken));
    }
    write(at.all, newton.f, Spatial<T>{select(moves, f.w + given.w, f.w), select(moves, f.v + given.v, f.v)});
    write(at.all, newton.back, u);
    const Vec3<T> dr = read(at.all, newton.dr), theta = read(at.all, newton.theta);
    write(at.all, newton.dr, select(moves, dr + u.v + cross(at.s_1(), u.w), dr));
    write(at.all, newton.theta, select(moves, theta + change_of_theta(theta, u.w), theta));
}

auto lanes_that_are(const AllLanes<1>&, unsigned active) { return (active & 1u) != 0; }
#if INGOT_LANES > 1
auto lanes_that_are(const AllLanes<lanes>&, unsigned active) { return mask_from_bits(static_cast<uint16_t>(active)); }
#endif

}  // namespace

bool has_rows_for(JointKind kind) {
    switch (kind) {
        case JointKind::none:
        case JointKind::ball:
        case JointKind::hinge:
        case JointKind::slider:
        case JointKind::universal:
        case JointKind::fixed: return true;
        default: return false;
    }
}

template <unsigned width>
void move_end(const NewtonStep<width>& step, unsigned active) {
    const auto moves = lanes_that_are(AllLanes<width>(), active);
    const int count = step.figures.count();
    for (int row_i = 0; row_i < count; ++row_i) move_to_joint(AtNode<width>(step, row_i));  // bound: max_bodies
    for (int row_i = count - 1; row_i >= 0; --row_i) eliminate_row(AtNode<width>(step, row_i));  // bound: max_bodies
    for (int row_i = 0; row_i < count; ++row_i) {
        const AtNode<width> at(step, row_i);
        Spatial<typename AllLanes<width>::T> of_parent{};
        if (at.has_parent()) of_parent = twist_at(read(at.all, at.parent().newton.back), at.end_from(at.parent()));
        move_row(at, of_parent, moves);
    }
}

template void move_end(const NewtonStep<1>& step, unsigned active);
#if INGOT_LANES > 1
template void move_end(const NewtonStep<lanes>& step, unsigned active);
#endif

} }  // namespace ingot

#pragma GCC diagnostic pop
