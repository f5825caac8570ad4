// SPDX-License-Identifier: MIT
// A pole balances on a cart, and a robot on two wheels: each by four numbers and four gains, which an LQR design gives.
#pragma once

#include <ingot/ingot.h>

namespace scenes {

/// What a law of four gains sees: a place, m, a tilt, rad, and how fast they go.
struct Balance {
    ingot::scalar x, tilt, v, tilt_rate;
};
/// What it sets: gains of the four.
struct BalanceGains {
    ingot::scalar x, tilt, v, tilt_rate;
};
inline ingot::scalar answer(const BalanceGains& K, const Balance& at) {
    return -(K.x * at.x + K.tilt * at.tilt + K.v * at.v + K.tilt_rate * at.tilt_rate);
}

/// A step is cut into substeps, and each of them pushes first and moves then: so places are those of half a substep after the velocities. Taken back
/// by that, with h: s, of a substep, a law has all four of one moment, from which on the next force is held.
inline Balance of_one_moment(const Balance& at, ingot::scalar h) {
    return {at.x - at.v * (h / 2), at.tilt - at.tilt_rate * (h / 2), at.v, at.tilt_rate};
}

/// A cart of 1 kg on a rail along x, and a pole of 0.2 kg on it, whose centre of mass is half a metre above its hinge.
struct CartPole : ingot::Scene {
    static constexpr int max_bodies = 2, max_joints = 2;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::SliderJoint, ingot::HingeJoint, ingot::WithDrives>;
};
struct CartPoleIds {
    ingot::BodyId cart{}, pole{};
    ingot::JointId rail{}, hinge{};
};
namespace cart_pole {
using ingot::scalar;
inline constexpr scalar cart_M = 1, pole_M = scalar(0.2), length = scalar(0.5), pole_I = pole_M * length * length / 3, g = scalar(9.81);
}  // namespace cart_pole

inline ingot::Status set_up(ingot::World<CartPole>& world, CartPoleIds& ids, ingot::scalar tilt) {
    using namespace cart_pole;
    ingot::BodyDef cart, pole;
    cart.mass = {cart_M, {1, 1, 1}, {}, ingot::identity_matrix<scalar>()};
    pole.mass = {pole_M, {pole_I, pole_I, pole_I / 10}, {}, ingot::identity_matrix<scalar>()};
    pole.state.A = ingot::axis_angle({0, 1, 0}, tilt);
    pole.state.r_CM = pole.state.A.c2 * length;
    ingot::Status status = world.set_gravity({0, 0, -g});
    const ingot::Result<ingot::BodyId> cart_id = world.add(cart), pole_id = world.add(pole);
    ids.cart = cart_id.value;
    ids.pole = pole_id.value;
    ingot::JointDef rail, hinge;
    rail.body_B = hinge.body_A = ids.cart;
    hinge.body_B = ids.pole;
    rail.joint = ingot::SliderJoint{};
    rail.axis = {1, 0, 0};
    hinge.joint = ingot::HingeJoint{};
    hinge.axis = {0, 1, 0};
    const ingot::Result<ingot::JointId> rail_id = world.add_joint(rail), hinge_id = world.add_joint(hinge);
    ids.rail = rail_id.value;
    ids.hinge = hinge_id.value;
    const ingot::Status statuses[] = {cart_id.status, pole_id.status, rail_id.status, hinge_id.status};
    for (const ingot::Status each : statuses)
        if (status == ingot::Status::ok) status = each;
    return status;
}
/// tilt: at which it was set up.
inline Balance balance_of(const ingot::World<CartPole>& world, const CartPoleIds& ids, ingot::scalar tilt) {
    return {world.joint_travel(ids.rail).value, world.joint_angle(ids.hinge).value + tilt, world.joint_speed(ids.rail).value,
            world.joint_rate(ids.hinge).value};
}
/// Force on the cart, N, over the next step.
inline ingot::Status push_cart(ingot::World<CartPole>& world, const CartPoleIds& ids, ingot::scalar force) {
    ingot::SpringDrive drive;
    drive.feedforward = force;
    return world.set_joint_drive(ids.rail, drive);
}

/// A robot of 5 kg on two wheels of half a kg, which roll by friction: each with a motor between wheel and body.
struct TwoWheels : ingot::Scene {
    static constexpr int max_bodies = 4, max_joints = 2, max_manifolds = 6;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
    using joints = ingot::Joints<ingot::HingeJoint, ingot::WithDrives>;
};
struct TwoWheelsIds {
    ingot::BodyId body{}, wheel[2]{};
    ingot::JointId axle[2]{};
};
namespace two_wheels {
using ingot::scalar;
inline constexpr scalar body_M = 5, wheel_M = scalar(0.5), radius = scalar(0.1), length = scalar(0.3), g = scalar(9.81);
inline constexpr scalar body_I = scalar(0.15), wheel_I = wheel_M * radius * radius * scalar(0.4);  // about the axle; a ball
}  // namespace two_wheels

inline ingot::Status set_up(ingot::World<TwoWheels>& world, TwoWheelsIds& ids, ingot::scalar tilt) {
    using namespace two_wheels;
    ingot::BodyDef ground, body, wheel;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    ground.friction = 1;
    body.mass = {body_M, {body_I, body_I, body_I / 2}, {}, ingot::identity_matrix<scalar>()};
    body.state.A = ingot::axis_angle({0, 1, 0}, tilt);
    body.state.r_CM = ingot::Vector{0, 0, radius} + body.state.A.c2 * length;
    wheel.mass = {wheel_M, {wheel_I, wheel_I, wheel_I}, {}, ingot::identity_matrix<scalar>()};
    wheel.shape = ingot::Sphere{radius};
    wheel.friction = 1;
    ingot::Status status = world.set_gravity({0, 0, -g});
    const auto note = [&](ingot::Status each) { status = status == ingot::Status::ok ? each : status; };
    note(world.add(ground).status);
    const ingot::Result<ingot::BodyId> body_id = world.add(body);
    note(body_id.status);
    ids.body = body_id.value;
    for (int i = 0; i < 2; ++i) {
        wheel.state.r_CM = {0, i == 0 ? scalar(0.2) : scalar(-0.2), radius};
        const ingot::Result<ingot::BodyId> wheel_id = world.add(wheel);
        ids.wheel[i] = wheel_id.value;
        ingot::JointDef axle;
        axle.body_A = ids.body;
        axle.body_B = ids.wheel[i];
        axle.joint = ingot::HingeJoint{};
        axle.P = wheel.state.r_CM;
        axle.axis = {0, 1, 0};
        const ingot::Result<ingot::JointId> axle_id = world.add_joint(axle);
        ids.axle[i] = axle_id.value;
        note(wheel_id.status);
        note(axle_id.status);
    }
    return status;
}
/// Of the tilt its sine, which is near enough.
inline Balance balance_of(const ingot::World<TwoWheels>& world, const TwoWheelsIds& ids) {
    const ingot::BodyState body = world.state(ids.body).value, left = world.state(ids.wheel[0]).value, right = world.state(ids.wheel[1]).value;
    return {(left.r_CM.x + right.r_CM.x) / 2, body.A.c2.x, (left.v_CM.x + right.v_CM.x) / 2, world.omega(ids.body).value.y};
}
/// Torque of both motors together on the wheels, N m, over the next step.
inline ingot::Status turn_wheels(ingot::World<TwoWheels>& world, const TwoWheelsIds& ids, ingot::scalar torque) {
    ingot::SpringDrive drive;
    drive.feedforward = torque / 2;
    const ingot::Status left = world.set_joint_drive(ids.axle[0], drive);
    return left == ingot::Status::ok ? world.set_joint_drive(ids.axle[1], drive) : left;
}

}  // namespace scenes
