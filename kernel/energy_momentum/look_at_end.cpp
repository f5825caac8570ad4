// SPDX-License-Identifier: MIT
#include "../base/limits.h"
#include "../figure/joint_sides.h"
#include "at_node.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// What is known as the step begins, and where the body would be without its joints.
template <unsigned width, class T = typename AllLanes<width>::T>
void guess_row(const AtNode<width>& at) {
    NewtonRow<width>& newton = at.newton;
    const NewtonStep<width>& step = at.step;
    const BodyView& bodies = step.figures.view.bodies;
    const T M = at.M(), h = splat<T>(step.h), two = splat<T>(2);
    const Vector g = step.figures.view.gravity;
    const auto force = step.figures.gathered(at.row_i, [&](const FigureNode& node) {
        const Place place = place_of(node.slot);
        return lane_of(bodies.translation[place.tile].F_T, place.lane);
    });
    const auto torque = step.figures.gathered(at.row_i, [&](const FigureNode& node) {
        const Place place = place_of(node.slot);
        return lane_of(bodies.rotation[place.tile].tau_T, place.lane);
    });
    const Vec3<T> v = read(at.all, at.row.v), F = Vec3<T>{splat<T>(g.x), splat<T>(g.y), splat<T>(g.z)} * M + force;
    write(at.all, newton.I_0, rotated_diagonal(read(at.all, at.row.A), read(at.all, at.row.I_body)));
    write(at.all, newton.kick, v * (two * M) + F * h);
    write(at.all, newton.spin, read(at.all, at.row.L) + torque * h);
    write(at.all, newton.dr, v * h + F * (h * h / (two * M)));
    write(at.all, newton.theta, read(at.all, at.row.w) * h);
    if (!at.has_joint()) return;
    Vec3<T> e_0 = read(at.all, at.row.arm_of_parent);
    if (at.node.kind == JointKind::slider) e_0 = (read(at.all, at.row.r) - at.r_of_parent()) + at.own_arm();
    write(at.all, newton.e_0, e_0);
}

/// The balances of the body alone, and how that of its spin answers a turn of the end.
template <unsigned width, class T = typename AllLanes<width>::T>
void begin_body(const AtNode<width>& at) {
    NewtonRow<width>& newton = at.newton;
    const Vec3<T> theta = read(at.all, newton.theta);
    const T twice_rate = splat<T>(2 / at.step.h);
    const Mat3<T> turn = turn_of(theta);
    const Sym3<T> I_0 = read(at.all, newton.I_0);
    const Vec3<T> L_1 = momentum_after(at, I_0, turn, twice_rate);
    write(at.all, newton.turn, turn);
    write(at.all, newton.s_1, at.own_arm() + turn * at.own_arm());
    const Vec3<T> missing = read(at.all, newton.dr) * (at.M() * twice_rate) - read(at.all, newton.kick);
    write(at.all, newton.lack, Spatial<T>{L_1 - read(at.all, newton.spin), missing});
    at.all.put(newton.load, T{});
    at.all.put(newton.moment, T{});
    // d theta / d turn, and then R I_0 of it.
    const Mat3<T> C = plus_diagonal(plus_outer(tilde(theta * splat<T>(scalar(-0.5))), theta * splat<T>(scalar(0.25)), theta), splat<T>(1));
    const Mat3<T> I_C = {I_0 * C.c0, I_0 * C.c1, I_0 * C.c2};
    write(at.all, newton.N[0], (I_C + turn * I_C) * twice_rate - tilde(L_1));
}

/// A vector of a body, and by how much the step turns it.
template <class T>
struct Turned {
    Vec3<T> start, change;
    INGOT_INLINE Vec3<T> end() const { return start + change; }
};
/// The change of a x b.
template <class T>
INGOT_INLINE Vec3<T> change_of_cross(const Turned<T>& a, const Turned<T>& b) {
    return cross(a.change, b.end()) + cross(a.start, b.change);
}

/// How much further off a joint would be at the end than at the begin, where it is off by a rounding of places. It is a sum of changes alone, so it
/// has all of their digits. apart: m, by how much its sides part.
template <unsigned width, class T = typename AllLanes<width>::T>
Spatial<T> change_of_back(const AtNode<width>& at, const Vec3<T>& apart, const Mat3<T>& own_turn, const Mat3<T>& turn_of_parent) {
    const auto own = [&](const Vec3<T>& of) { return Turned<T>{of, own_turn * of}; };
    const auto of_parent = [&](const Vec3<T>& of) { return Turned<T>{of, turn_of_parent * of}; };
    const Turned<T> axis = own(read(at.all, at.row.axis)), axis_of_parent = of_parent(read(at.all, at.row.axis_of_parent));
    Spatial<T> back = {Vec3<T>{}, -apart};
    if (at.node.kind == JointKind::hinge) back.w = change_of_cross(axis, axis_of_parent);
    if (at.node.kind == JointKind::universal) {
        const Vec3<T> x = cross(axis_of_parent.end(), axis.end());
        back.w = x * ((dot(axis_of_parent.change, axis.end()) + dot(axis_of_parent.start, axis.change)) / length_sq(x));
    }
    if (locks_turns(at.node.kind)) {
        const FigureRows<width>& figures = at.step.figures;
        const auto own_side = figures.gathered(at.row_i, [&](const FigureNode& of) { return figures.own_frame(of).side; });
        const auto its_side = figures.gathered(at.row_i, [&](const FigureNode& of) { return figures.frame_of_parent(of).side; });
        const Vec3<T> side = read(at.all, at.row.A) * own_side, side_of_parent = at.A_of_parent() * its_side;
        const Turned<T> third = own(cross(axis.start, side)), third_of_parent = of_parent(cross(axis_of_parent.start, side_of_parent));
        const Vec3<T> sum = change_of_cross(axis, axis_of_parent) + change_of_cross(own(side), of_parent(side_of_parent));
        back.w = (sum + change_of_cross(third, third_of_parent)) * splat<T>(scalar(0.5));
    }
    if (at.node.kind != JointKind::slider) return back;
    const Vec3<T> along = read(at.all, at.row.arm_of_parent) - read(at.all, at.newton.e_0), n = axis_of_parent.end();
    const Vec3<T> change = apart + turn_of_parent * along;  // of the way along the axis, as the parent sees it
    back.v = n * dot(change, n) - change;
    return back;
}

/// What a joint gives enters the balances of both bodies; as its arms turn with them, it gives another moment: N.
template <unsigned width, class T = typename AllLanes<width>::T>
void give_to_sides(const AtNode<width>& at) {
    NewtonRow<width>& newton = at.newton;
    const Spatial<T> f = read(at.all, newton.f);
    const T load = length_of(f.v), moment = length_of(f.w), half = splat<T>(scalar(0.5));
    at.add(newton.load, load);
    at.add(newton.moment, moment + load * length_of(at.s_1()));
    write(at.all, newton.lack, read(at.all, newton.lack) - impulse_from(f, at.mean_own_arm()));
    write(at.all, newton.N[0], read(at.all, newton.N[0]) - tilde_tilde(f.v, at.s_1()) * half);
    if (!at.has_parent()) return;
    const AtNode<width> parent = at.parent();
    parent.add(parent.newton.load, load);
    parent.add(parent.newton.moment, moment + load * length_of(at.e_1()));
    parent.add(parent.newton.lack, impulse_from(f, at.mean_arm_of_parent()));
    parent.add(parent.newton.N[0], tilde_tilde(f.v, at.e_1()) * half);
}

/// Both sides of a joint at the end, and what it does there.
template <unsigned width, class T = typename AllLanes<width>::T>
void end_joint(const AtNode<width>& at) {
    NewtonRow<width>& newton = at.newton;
    const Vec3<T> arm = read(at.all, at.row.arm_of_parent), axis = read(at.all, at.row.axis), axis_of_parent = read(at.all, at.row.axis_of_parent);
    const Mat3<T> turn = read(at.all, newton.turn);
    Mat3<T> turn_of_parent = at.step.ground_turn;
    Vec3<T> way_of_parent = at.step.ground_way;
    if (at.has_parent()) {
        turn_of_parent = read(at.all, at.parent().newton.turn);
        way_of_parent = read(at.all, at.parent().newton.dr);
    }
    const Vec3<T> own_way = read(at.all, newton.dr) + turn * at.own_arm();
    write(at.all, newton.axis_1, axis + turn * axis);
    write(at.all, newton.axis_of_parent_1, axis_of_parent + turn_of_parent * axis_of_parent);
    const bool slides = at.node.kind == JointKind::slider;
    write(at.all, newton.e_1, slides ? read(at.all, newton.e_0) + (own_way - way_of_parent) : arm + turn_of_parent * arm);
    write(at.all, newton.back, change_of_back(at, own_way - (way_of_parent + turn_of_parent * arm), turn, turn_of_parent));
    give_to_sides(at);
}

/// The square of the largest of: what balances are off by, as a share of what is in them; gaps, as a share of the size of the body; angles, rad.
template <unsigned width, class T = typename AllLanes<width>::T>
T misfit_of(const AtNode<width>& at) {
    const NewtonRow<width>& newton = at.newton;
    const Vec3<T> I = read(at.all, at.row.I_body);
    const T M = at.M(), rate = splat<T>(1 / abs(at.step.h)), size_sq = max(I.x, max(I.y, I.z)) / M + length_sq(read(at.all, at.row.c));
    // What is in a balance is no less than what roundings of dr and theta make of a body at rest.
    const T least = M * size_sq * rate * splat<T>(epsilon);
    const T going = M * rate * length_of(read(at.all, newton.dr));
    const T momentum = at.all.get(newton.load) + length_of(read(at.all, newton.kick)) + going + least / sqrt(size_sq);
    const T turning = length_of(read(at.all, newton.I_0) * read(at.all, newton.theta)) * rate;
    const T spin = at.all.get(newton.moment) + length_of(read(at.all, newton.spin)) + turning + least;
    const Spatial<T> lack = read(at.all, newton.lack), back = read(at.all, newton.back);
    const T misfit = max(length_sq(lack.v) / (momentum * momentum), length_sq(lack.w) / (spin * spin));
    if (!at.has_joint()) return misfit;
    return max(misfit, max(length_sq(back.v) / (size_sq + length_sq(read(at.all, newton.e_0))), length_sq(back.w)));
}

}  // namespace

template <unsigned width>
void begin_passes(const NewtonStep<width>& step) {
    for (int row_i = 0; row_i < step.figures.count(); ++row_i) guess_row(AtNode<width>(step, row_i));  // bound: max_bodies
}

template <unsigned width>
void look_at_end(const NewtonStep<width>& step, scalar (&misfit)[width]) {
    using T = typename AllLanes<width>::T;
    for (int row_i = 0; row_i < step.figures.count(); ++row_i) {  // bound: max_bodies
        const AtNode<width> at(step, row_i);
        begin_body(at);
        if (at.has_joint()) end_joint(at);
    }
    T worst{};
    const T most = splat<T>(scalar_max);
    for (int row_i = 0; row_i < step.figures.count(); ++row_i) {
        const T of_row = misfit_of(AtNode<width>(step, row_i));
        worst = max(worst, select(of_row <= most, of_row, most));
    }
    AllLanes<width>().put(misfit, worst);
}

template void begin_passes(const NewtonStep<1>& step);
template void look_at_end(const NewtonStep<1>& step, scalar (&misfit)[1]);
#if INGOT_LANES > 1
template void begin_passes(const NewtonStep<lanes>& step);
template void look_at_end(const NewtonStep<lanes>& step, scalar (&misfit)[lanes]);
#endif

} }  // namespace ingot

#pragma GCC diagnostic pop
