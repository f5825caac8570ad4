// SPDX-License-Identifier: MIT
// What a servo does with a step of its target: numbers that the report has of it, at any rate.
#pragma once

#include <ingot/ingot.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace scenes {

struct Turning : ingot::Scene {
    static constexpr int max_bodies = 2, max_joints = 1;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::HingeJoint, ingot::BallJoint, ingot::WithDrives>;
};
inline constexpr double servo_inertia = 1e-3, servo_stiffness = 1e6;  ///< kg m^2, N m/rad

/// A body of servo_inertia about z, free to turn about its centre of mass against the world.
struct Turner {
    std::unique_ptr<ingot::World<Turning>> world = std::make_unique<ingot::World<Turning>>();
    ingot::BodyId body{};
    ingot::JointId joint{};
    double rate;

    Turner(double steps_a_second, const ingot::Joint& kind, const ingot::Vector& moments) : rate(steps_a_second) {
        ingot::BodyDef def;
        def.mass = {1, moments, {}, ingot::identity_matrix<ingot::scalar>()};
        body = world->add(def).value;
        ingot::JointDef of;
        of.body_B = body;
        of.joint = kind;
        joint = world->add_joint(of).value;
    }
    void step() { (void)ingot::step(*world, static_cast<ingot::scalar>(1 / rate)); }
    double angle() const { return static_cast<double>(world->joint_angle(joint).value); }
};
inline Turner hinge_turner(double rate) {
    const auto J = static_cast<ingot::scalar>(servo_inertia);
    return {rate, ingot::HingeJoint{}, {J, J, J}};
}
/// N m s/rad, that damp it by half of its stiffness in a substep.
inline double servo_damping(double rate) { return servo_stiffness / (2 * rate * Turning::effort.substeps); }
inline ingot::SpringDrive stiff_servo(double rate, double target, double most = static_cast<double>(ingot::unlimited)) {
    using ingot::scalar;
    const auto number = [](double x) { return static_cast<scalar>(x); };
    return {number(servo_stiffness), number(servo_damping(rate)), number(target), 0, 0, number(most)};
}

/// rad, after four steps, of a target 1 rad away.
inline double off_after_four_steps(double rate) {
    Turner turner = hinge_turner(rate);
    (void)turner.world->set_joint_drive(turner.joint, stiff_servo(rate, 1));
    for (int i = 0; i < 4; ++i) turner.step();
    return std::abs(turner.angle() - 1);
}
/// The same of a ball joint, 2.5 rad away.
inline double ball_off_after_four_steps(double rate) {
    using ingot::scalar;
    Turner turner(rate, ingot::BallJoint{}, {scalar(1e-3), scalar(2e-3), scalar(2.5e-3)});
    const ingot::Vector target = {scalar(1.5), scalar(-1.2), scalar(1.6)};  // 2.5 rad
    (void)turner.world->set_ball_drive(turner.joint, stiff_servo(rate, 0), target);
    for (int i = 0; i < 4; ++i) turner.step();
    const ingot::Vector off = turner.world->ball_turn(turner.joint).value - target;
    return static_cast<double>(ingot::sqrt(ingot::length_sq(off)));
}

/// s, until what is off by e(step) stays within 0.01 rad.
template <class Off>
double settling_time(double seconds, double rate, const Off& off) {
    double settled = 0;
    for (int i = 1; i <= static_cast<int>(seconds * rate); ++i)
        if (std::abs(off()) > 0.01) settled = i / rate;
    return settled;
}
/// The same of the law itself, with a torque of `most` at most, in steps of 1e-5 s.
inline double exact_settling_time(double damping, double most) {
    constexpr double dt = 1e-5;
    double e = -1, w = 0;
    return settling_time(3, 1 / dt, [&] {
        const double resist = dt * (damping + dt * servo_stiffness) / servo_inertia;
        const double asked = (w - dt / servo_inertia * servo_stiffness * e) / (1 + resist);
        const double torque = std::max(-most, std::min(most, (asked - w) * servo_inertia / dt));
        w += torque / servo_inertia * dt;
        return e += w * dt;
    });
}
/// How long a servo with a largest torque takes to settle, as a multiple of what the law takes.
inline double settling_ratio(double rate, double most) {
    Turner turner = hinge_turner(rate);
    (void)turner.world->set_joint_drive(turner.joint, stiff_servo(rate, 1, most));
    const double settled = settling_time(3, rate, [&] {
        turner.step();
        return turner.angle() - 1;
    });
    return settled / (exact_settling_time(servo_damping(rate), most) + 1 / rate);  // it is looked at once a step
}

/// rad per rad, at most in a second: what is tuned, against the exact solution. is_of_one_moment: places are taken back by half a substep, to where
/// velocities are, as a controller does it; else as they are read.
inline double tuned_off(double rate, double hertz, double ratio, bool is_of_one_moment) {
    using ingot::scalar;
    Turner turner = hinge_turner(rate);
    (void)turner.world->set_joint_drive(turner.joint, ingot::TunedDrive{static_cast<scalar>(hertz), static_cast<scalar>(ratio), 1});
    const double w = 2 * 3.14159265358979323846 * hertz;
    double most = 0;
    for (int i = 1; i <= static_cast<int>(rate); ++i) {
        turner.step();
        const double t = i / rate, decay = std::exp(-ratio * w * t);
        double e = -decay * (1 + w * t);
        if (ratio < 1) {
            const double v = w * std::sqrt(1 - ratio * ratio);
            e = -decay * (std::cos(v * t) + ratio * w / v * std::sin(v * t));
        } else if (ratio > 1) {
            const double v = w * std::sqrt(ratio * ratio - 1);
            e = -decay * (std::cosh(v * t) + ratio * w / v * std::sinh(v * t));
        }
        const double ahead = static_cast<double>(turner.world->joint_rate(turner.joint).value) / (2 * rate * Turning::effort.substeps);
        most = std::max(most, std::abs(turner.angle() - (is_of_one_moment ? ahead : 0) - 1 - e));
    }
    return most;
}

/// A share: how far a motor of 20 rad/s is off its rate, once there.
inline double motor_off(double rate) {
    Turner turner = hinge_turner(rate);
    (void)turner.world->set_joint_drive(turner.joint, ingot::MotorDrive{20});
    double most = 0;
    for (int i = 0; i < 60; ++i) {
        turner.step();
        if (i >= 4) most = std::max(most, std::abs(static_cast<double>(turner.world->joint_rate(turner.joint).value) / 20 - 1));
    }
    return most;
}
/// A share: how far it is from torque over stiffness, held against gravity at the end of an arm of half a metre.
inline double load_off(double rate) {
    using ingot::scalar;
    ingot::World<Turning> world;
    (void)world.set_gravity({0, 0, scalar(-9.81)});
    ingot::BodyDef def;
    def.mass = {1, {scalar(0.01), scalar(0.01), scalar(0.01)}, {}, ingot::identity_matrix<scalar>()};
    def.state.r_CM = {scalar(0.5), 0, 0};
    const ingot::BodyId body = world.add(def).value;
    ingot::JointDef of;
    of.body_B = body;
    of.joint = ingot::HingeJoint{};
    of.axis = {0, -1, 0};
    const ingot::JointId joint = world.add_joint(of).value;
    constexpr double stiffness = 1e3;
    (void)world.set_joint_drive(joint, ingot::SpringDrive{scalar(stiffness), scalar(stiffness / 20)});
    for (int i = 0; i < static_cast<int>(4 * rate); ++i) (void)ingot::step(world, static_cast<scalar>(1 / rate));
    const double angle = static_cast<double>(world.joint_angle(joint).value);
    return std::abs(-angle * stiffness / (9.81 / 2 * std::cos(angle)) - 1);
}

/// A share of what turns: the angular momentum of two bodies that float, joined by a ball joint whose servo swings them by 2 rad. arm: m, of it
/// from their centres: with 0 the servo is all there is.
inline double momentum_off(double rate, double arm) {
    using ingot::scalar;
    ingot::World<Turning> world;
    ingot::BodyDef def;
    def.mass = {1, {scalar(1e-3), scalar(2e-3), scalar(2.5e-3)}, {}, ingot::identity_matrix<scalar>()};
    const ingot::BodyId A = world.add(def).value;
    const ingot::Vector half = ingot::Vector{1, scalar(0.2), 0} * static_cast<scalar>(arm);
    def.state.r_CM = half + half;
    const ingot::BodyId B = world.add(def).value;
    ingot::JointDef of;
    of.body_A = A;
    of.body_B = B;
    of.joint = ingot::BallJoint{};
    of.P = half;
    const ingot::JointId joint = world.add_joint(of).value;
    (void)world.set_ball_drive(joint, ingot::TunedDrive{3, scalar(0.5)}, {1, -1, scalar(1.4)});
    double most = 0, scale = 0;
    for (int i = 0; i < static_cast<int>(2 * rate); ++i) {
        (void)ingot::step(world, static_cast<scalar>(1 / rate));
        most = std::max(most, static_cast<double>(ingot::sqrt(ingot::length_sq(world.figure(A).value.L))));
        scale = std::max(scale, static_cast<double>(ingot::sqrt(ingot::length_sq(world.state(A).value.L))));
    }
    return most / scale;
}

}  // namespace scenes
