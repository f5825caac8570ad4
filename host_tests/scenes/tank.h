// SPDX-License-Identifier: MIT
// A tank: a hull on eight road wheels, with a belt about those of each side. x is forwards, y to the left, z up, as it is set down.
//
// A belt bears a tank where it runs below a road wheel, so it is the surface of these wheels, balls on sliders with springs, which moves: they do not
// turn themselves. As one long capsule it would not turn the tank: friction of a contact of several points is one force at their middle and one
// torque, each bounded by itself, and the torque of a line against its turn is as large as if it did not slide along.
#pragma once

#include <ingot/ingot.h>

namespace scenes {

struct OnTracks : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 16, max_manifolds = 64, max_pairs = 300;
    static constexpr bool translates = true, sleeps = true, surface_velocities = true;
    static constexpr ingot::Effort effort = {4, 12};
    using shapes = ingot::Shapes<ingot::Box, ingot::Sphere, ingot::HalfSpace>;
    using joints = ingot::Joints<ingot::SliderJoint, ingot::WithLimits, ingot::WithDrives>;
};

/// kg, m.
struct TankDesign {
    ingot::scalar M = 20000, wheel_M = 300;     ///< of the hull, of one road wheel with its part of the belt
    ingot::scalar radius = ingot::scalar(0.4);  ///< of the road wheels, with the belts
    ingot::scalar half_length = 2;              ///< from the middle to the first and the last of them
    ingot::scalar apart = ingot::scalar(2.4);   ///< between the middles of the belts
    ingot::scalar clearance = ingot::scalar(0.4), hull_height = 1;
    ingot::scalar hertz = ingot::scalar(1.5), damping_ratio = ingot::scalar(0.5), travel = ingot::scalar(0.2);  ///< of its springs
    ingot::scalar mu = ingot::scalar(0.8);
};

struct Tank {
    static constexpr int wheels = 8;  ///< left and right in turns, from the last row to the first
    TankDesign design{};
    ingot::BodyId hull{}, wheel[wheels]{};
    ingot::JointId joint[wheels]{};
    ingot::scalar left = 0, right = 0;  ///< m/s, of its belts

    /// m, ahead of the middle.
    ingot::scalar row(int wheel_i) const { return (static_cast<ingot::scalar>(wheel_i / 2) * 4 / (wheels - 2) - 1) * design.half_length; }
};

/// Set down with its belts on z = place.z, above it, at rest. Errors: those of World::add, add_joint and set_joint_drive.
template <class S>
ingot::Status add_tank(ingot::World<S>& world, const ingot::Vector& place, Tank& tank) {
    using ingot::scalar;
    using ingot::Vector;
    const TankDesign& of = tank.design;
    ingot::Status status = ingot::Status::ok;
    const auto note = [&](ingot::Status each) { status = status == ingot::Status::ok ? each : status; };
    const auto body_of = [&](const ingot::MassDistribution& of_one, scalar M, const ingot::Shape& shape, const Vector& r) {
        const ingot::MassDistribution solid = ingot::with_mass(of_one, M);
        ingot::BodyDef def;
        def.mass = {solid.M, {solid.I.xx, solid.I.yy, solid.I.zz}, {}, ingot::identity_matrix<scalar>()};
        def.shape = shape;
        def.state.r_CM = place + r;
        def.friction = of.mu;
        return def;
    };
    const Vector half = {of.half_length, of.apart / 2 - of.radius, of.hull_height / 2};
    const ingot::Result<ingot::BodyId> hull =
        world.add(body_of(ingot::solid_box(1, half), of.M, ingot::Box{half}, {0, 0, of.clearance + of.hull_height / 2}));
    note(hull.status);
    tank.hull = hull.value;
    const scalar omega = scalar(6.2831853071795864769) * of.hertz, corner = of.M / Tank::wheels;
    const ingot::SpringDrive spring{corner * omega * omega, 2 * of.damping_ratio * corner * omega, 0, 0, -corner * scalar(9.81)};
    for (int wheel_i = 0; wheel_i < Tank::wheels; ++wheel_i) {
        const Vector r = {tank.row(wheel_i), wheel_i % 2 == 0 ? of.apart / 2 : -of.apart / 2, of.radius};
        const ingot::Result<ingot::BodyId> wheel = world.add(body_of(ingot::solid_sphere(1, of.radius), of.wheel_M, ingot::Sphere{of.radius}, r));
        ingot::JointDef def;
        def.body_A = tank.hull;
        def.body_B = wheel.value;
        def.joint = ingot::SliderJoint{-of.travel, of.travel};
        def.P = place + r;
        const ingot::Result<ingot::JointId> joint = world.add_joint(def);
        note(wheel.status);
        note(joint.status);
        note(world.set_joint_drive(joint.value, spring));
        tank.wheel[wheel_i] = wheel.value;
        tank.joint[wheel_i] = joint.value;
    }
    return status;
}

/// left, right: m/s, of each belt over the ground, as far as it does not slip. What stays as it was is not set again: each call wakes the tank.
/// Errors: those of World::set_surface_velocity.
template <class S>
ingot::Status drive_tank(ingot::World<S>& world, Tank& tank, ingot::scalar left, ingot::scalar right) {
    const auto run = [&](int side_i, ingot::scalar& now, ingot::scalar speed) {
        ingot::Status status = ingot::Status::ok;
        for (int wheel_i = side_i; wheel_i < Tank::wheels && now != speed && status == ingot::Status::ok; wheel_i += 2)
            status = world.set_surface_velocity(tank.wheel[wheel_i], {-speed, 0, 0});  // below, a belt goes backwards
        now = speed;
        return status;
    };
    const ingot::Status status = run(0, tank.left, left);
    return status == ingot::Status::ok ? run(1, tank.right, right) : status;
}

/// rad/s, at which it turns, to the left, at low speed, where all its wheels bear as much. All slip by what the belts differ from the turn, along,
/// and by the turn itself, across, and what that gives has no torque in all.
inline ingot::scalar turn_rate(const Tank& tank, ingot::scalar left, ingot::scalar right) {
    using ingot::scalar;
    const scalar w = tank.design.apart / 2, differ = (right - left) / 2;
    scalar low = 0, high = 1;  // of differ / w; the torque falls from one to the other
    for (int i = 0; i < 24; ++i) {
        const scalar share = (low + high) / 2, along = 1 - share;
        scalar torque = 0;
        for (int wheel_i = 0; wheel_i < Tank::wheels; ++wheel_i) {
            const scalar x = tank.row(wheel_i) / w, across = share * x, slip_sq = along * along + across * across;
            torque += slip_sq > 0 ? (along - across * x) / ingot::sqrt(slip_sq) : scalar(0);
        }
        (torque > 0 ? low : high) = share;
    }
    return differ / w * low;
}

}  // namespace scenes
