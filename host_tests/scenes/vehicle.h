// SPDX-License-Identifier: MIT
// A car of a ton on four wheels, with springs, motors, brakes and a steering; its tyres grip by friction, as all things do, or by a slip law. x is
// forwards, y to the left, z up, as it is set down. Wheels are to turn by less than a radian in a substep: at 60 m/s on wheels of 0.3 m that is so
// from 50 steps a second on, or with twice the substeps.
#pragma once

#include <ingot/math/arctangent.h>

#include "tyre.h"

namespace scenes {

struct OnRoad : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 8, max_manifolds = 64, max_pairs = 300;
    static constexpr bool translates = true, sleeps = true;
    static constexpr ingot::Effort effort = {4, 12};  // wide wheels: what each carries across is settled by sweeps alone
    using shapes = ingot::Shapes<ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
    using joints = ingot::Joints<ingot::WheelJoint, ingot::WithLimits, ingot::WithDrives>;
};

/// kg, m.
struct CarDesign {
    ingot::scalar M = 920, wheel_M = 20;                                                         ///< of the chassis, of one wheel
    ingot::Vector half_extents = {ingot::scalar(1.8), ingot::scalar(0.8), ingot::scalar(0.25)};  ///< of the chassis
    ingot::scalar radius = ingot::scalar(0.3), half_width = ingot::scalar(0.08);                 ///< of a wheel
    ingot::scalar base = ingot::scalar(2.6), track = ingot::scalar(1.5);                         ///< between axles, between wheels of one
    ingot::scalar height = ingot::scalar(0.35);                                    ///< of the middle of the chassis above the axles, as it stands
    ingot::scalar hertz = ingot::scalar(1.5), damping_ratio = ingot::scalar(0.4);  ///< at which it bounces on its springs
    ingot::scalar travel = ingot::scalar(0.12);                                    ///< of a wheel, either way
    ingot::scalar top_speed = 55;  ///< m/s, over the ground, beyond which its motors turn its wheels no faster
    TyreLaw tyre{};
    ingot::scalar park_speed = ingot::scalar(0.05);  ///< m/s: braked and below it, tyres that slip by their law are held by friction
    bool slips = false;                              ///< by the law of its tyres; else by friction, with the mu of that law

    ingot::scalar mass() const { return M + 4 * wheel_M; }
};

/// What a driver does, for the next step.
struct Driving {
    ingot::scalar torque = 0;     ///< N m, of the motor of each rear wheel; above 0 forwards
    ingot::scalar brake = 0;      ///< N m, of each wheel, at most
    ingot::scalar curvature = 0;  ///< 1/m, of the way of the middle of the rear axle; above 0 to the left; below 1/track
    bool locked = false;          ///< no motor, and all wheels are held, whatever it takes

    bool is_braked() const { return locked || brake > 0; }
    bool operator==(const Driving& other) const {
        return torque == other.torque && brake == other.brake && curvature == other.curvature && locked == other.locked;
    }
};

/// Wheels in the order front left, front right, rear left, rear right.
struct Car {
    CarDesign design{};
    ingot::BodyId chassis{}, wheel[4]{};
    ingot::JointId joint[4]{};
    Driving driving{};    ///< as it was in the last step
    bool driven = false;  ///< there was one
    Grip grip[4]{};
    ingot::scalar yielding[2]{};  ///< 1/kg: of a slip along and across, as far as the whole car goes with it
    ingot::scalar spinning = 0;   ///< 1/kg: what the spin of a wheel adds to the first
};

namespace vehicle {
using ingot::scalar;
using ingot::Vector;
using tyre::Slip;

struct Statuses {
    ingot::Status status = ingot::Status::ok;
    void note(ingot::Status each) { status = status == ingot::Status::ok ? each : status; }
    template <class T>
    T note(const ingot::Result<T>& result) {
        note(result.status);
        return result.value;
    }
};

inline ingot::BodyDef body_of(const ingot::MassDistribution& of_one, scalar M, const ingot::Shape& shape, const Vector& r, scalar friction) {
    const ingot::MassDistribution solid = ingot::with_mass(of_one, M);
    ingot::BodyDef def;
    def.mass = {solid.M, {solid.I.xx, solid.I.yy, solid.I.zz}, {}, ingot::identity_matrix<scalar>()};
    def.shape = shape;
    def.state.r_CM = r;
    def.friction = friction;
    return def;
}
/// m, as it was set down, from the middle between the wheels' lowest points.
inline Vector hub_of(const CarDesign& of, int wheel_i) {
    return {(wheel_i < 2 ? of.base : -of.base) / 2, (wheel_i % 2 == 0 ? of.track : -of.track) / 2, of.radius};
}
/// Cylinders turn about their z; an axle is along y.
inline ingot::Matrix axle_along_y() { return {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}; }

/// Its wheels' springs carry it as it stands; friction is that of its tyres, none where they slip by their law.
template <class S>
void add_wheel(ingot::World<S>& world, Car& car, int wheel_i, const Vector& place, scalar speed, Statuses& statuses) {
    const CarDesign& of = car.design;
    constexpr scalar g = scalar(9.81), turn = scalar(6.2831853071795864769);
    ingot::BodyDef wheel = body_of(ingot::solid_cylinder(1, of.radius, of.half_width), of.wheel_M, ingot::Cylinder{of.radius, of.half_width},
                                   place + hub_of(of, wheel_i), of.slips ? 0 : of.tyre.mu);
    wheel.state.A = axle_along_y();
    wheel.state.v_CM = {speed, 0, 0};
    wheel.state.L = {0, wheel.mass.I_body.z * (speed / of.radius), 0};
    car.spinning = of.radius * of.radius / wheel.mass.I_body.z;
    car.wheel[wheel_i] = statuses.note(world.add(wheel));

    ingot::JointDef joint;
    joint.body_A = car.chassis;
    joint.body_B = car.wheel[wheel_i];
    joint.joint = ingot::WheelJoint{-of.travel, of.travel};
    joint.P = wheel.state.r_CM;
    joint.axis_B = {0, 1, 0};
    car.joint[wheel_i] = statuses.note(world.add_joint(joint));
    const scalar omega = turn * of.hertz, corner = of.mass() / 4;
    const ingot::SpringDrive spring{corner * omega * omega, 2 * of.damping_ratio * corner * omega, 0, 0, -of.M * g / 4};
    statuses.note(world.set_joint_drive(car.joint[wheel_i], spring, ingot::WheelJoint::travel));
}
}  // namespace vehicle

/// Set down so that its wheels touch z = place.z, in the middle of them, rolling forwards with `speed`, m/s. Errors: those of World::add and
/// add_joint.
template <class S>
ingot::Status add_car(ingot::World<S>& world, const ingot::Vector& place, ingot::scalar speed, Car& car) {
    using namespace vehicle;
    Statuses statuses;
    const CarDesign& of = car.design;
    ingot::BodyDef chassis =
        body_of(ingot::solid_box(1, of.half_extents), of.M, ingot::Box{of.half_extents}, place + Vector{0, 0, of.radius + of.height}, scalar(0.5));
    chassis.state.v_CM = {speed, 0, 0};
    car.chassis = statuses.note(world.add(chassis));
    for (int wheel_i = 0; wheel_i < 4; ++wheel_i) add_wheel(world, car, wheel_i, place, speed, statuses);
    // A push at a wheel's lowest point moves the chassis, tilts it and turns it; all four at once do so four times as much.
    const Vector I = chassis.mass.I_body, arm = Vector{of.base, of.track, 2 * (of.radius + of.height)} * scalar(0.5);
    car.yielding[0] = 4 * (1 / of.mass() + arm.z * arm.z / I.y + arm.y * arm.y / I.z);
    car.yielding[1] = 4 * (1 / of.mass() + arm.z * arm.z / I.x + arm.x * arm.x / I.z);
    return statuses.status;
}

namespace vehicle {
/// What motor and brake do to the slip of a wheel, as far as the tyre does not hold it: known before the step. rolls: m/s; load: N.
inline void spin_by_drive(Slip& slip, const Car& car, int wheel_i, scalar rolls, scalar load, scalar h) {
    const CarDesign& of = car.design;
    const scalar a = h * car.spinning / of.radius;  // m/s a N m
    const scalar to_stop = rolls - slip.now[0];     // m/s, by which the slip differs from that of a wheel that stands
    if (!car.driving.is_braked()) {
        slip.driven[0] = wheel_i < 2 ? 0 : -a * car.driving.torque;
    } else if (car.driving.locked || a * (car.driving.brake - of.radius * of.tyre.mu * load) >= ingot::abs(to_stop)) {
        slip.driven[0] = to_stop;
        slip.yielding[0] = car.yielding[0];
    } else {
        const scalar most = a * car.driving.brake;
        slip.driven[0] = ingot::max(-most, ingot::min(most, to_stop));
    }
}
/// What bears a wheel most, as the last step had it.
struct Ground {
    ingot::BodyId id{};
    Vector v{};  ///< m/s, of it at P
};
template <class S>
Ground ground_below(const ingot::World<S>& world, ingot::BodyId wheel, const Vector& P) {
    Ground ground;
    scalar most = 0;
    for (const ingot::ContactInfo& contact : world.contacts_of(wheel)) {
        if (!(contact.j > most)) continue;
        most = contact.j;
        ground.id = contact.A == wheel ? contact.B : contact.A;
    }
    const ingot::Result<ingot::BodyState> state = world.state(ground.id);
    const ingot::Result<Vector> omega = world.omega(ground.id);
    if (state.ok() && omega.ok()) ground.v = state.value.v_CM + ingot::cross(omega.value, P - state.value.r_CM);
    return ground;
}

/// A force on a wheel at P, and back on the ground. Of it the wheel by itself takes but the torque tau about its axle; the rest goes through its hub,
/// so the chassis gets it: a light wheel that spins fast bears no torque across its axle, which a substep would let it turn by before its joint holds
/// it.
template <class S>
ingot::Status push_wheel(ingot::World<S>& world, const Car& car, int wheel_i, ingot::BodyId ground, const Vector& F, const Vector& P,
                         const Vector& tau) {
    Statuses statuses;
    statuses.note(world.add_force(car.chassis, F, P));
    statuses.note(world.add_torque(car.chassis, -tau));
    statuses.note(world.add_torque(car.wheel[wheel_i], tau));
    const ingot::Status back = world.add_force(ground, -F, P);
    if (back != ingot::Status::immovable) statuses.note(back);
    return statuses.status;
}

/// The forces of a tyre's law on its wheel, and on what bears it, over the next step. One that stands is held by friction, so that a car can fall
/// asleep.
template <class S>
ingot::Status grip_ground(ingot::World<S>& world, Car& car, int wheel_i, scalar h) {
    const ingot::BodyId id = car.wheel[wheel_i];
    const CarDesign& of = car.design;
    Grip& grip = car.grip[wheel_i];
    const ingot::ContactSum sum = world.contact_sum(id).value;
    const ingot::BodyState wheel = world.state(id).value;
    const Vector omega = world.omega(id).value, axle = wheel.A.c2, forwards = ingot::cross(axle, sum.j);
    const scalar load = sum.j_normal / h, size_sq = ingot::length_sq(forwards);
    const bool touches = load > 0 && size_sq > 0;
    // Where it touches is a matter of form: the centre of pressure is one of the last step, and some metres behind.
    const Vector along = touches ? forwards * (1 / ingot::sqrt(size_sq)) : Vector{}, arm = ingot::cross(axle, along) * of.radius;
    const Ground ground = ground_below(world, id, wheel.r_CM + arm);
    const Vector v = wheel.v_CM - ground.v;

    const scalar quick = grip.parked ? 10 * of.park_speed : of.park_speed;
    if (car.driving.is_braked() && (touches || grip.parked) && ingot::length_sq(v) < quick * quick) {
        const bool since = grip.parked;
        grip = {};
        grip.parked = true;
        return since ? ingot::Status::ok : world.set_friction(id, of.tyre.mu);
    }
    const ingot::Status let_go = grip.parked ? world.set_friction(id, 0) : ingot::Status::ok;
    if (!touches || grip.parked || !(of.tyre.mu > 0)) {
        grip = {};
        return let_go;
    }
    const Vector across = ingot::cross(sum.j, along) * (1 / sum.j_normal), v_P = v + ingot::cross(omega, arm);
    const scalar rolls = ingot::dot(v, along), spin = ingot::dot(omega, axle);
    Slip slip = {{ingot::dot(v_P, along), ingot::dot(v_P, across)}, {}, {car.yielding[0] + car.spinning, car.yielding[1]}};
    spin_by_drive(slip, car, wheel_i, rolls, load, h);
    const scalar V = ingot::max(ingot::abs(rolls), ingot::abs(spin) * of.radius);
    const tyre::Push push = tyre::push(of.tyre, grip, load, V, slip, h);
    const Vector F = along * push.along + across * push.across;
    return push_wheel(world, car, wheel_i, ground.id, F, wheel.r_CM + arm, axle * (ingot::dot(ingot::cross(arm, F), axle)));
}
}  // namespace vehicle

namespace vehicle {
/// Steers by Ackermann's angles: all axles meet in one point. Motors and brakes are drives of the wheels' spin.
template <class S>
ingot::Status set_driving(ingot::World<S>& world, Car& car, const Driving& driving) {
    Statuses statuses;
    const CarDesign& of = car.design;
    for (int wheel_i = 0; wheel_i < 4; ++wheel_i) {
        if (wheel_i < 2) {
            const scalar angle = ingot::arctangent(of.base * driving.curvature, 1 - driving.curvature * hub_of(of, wheel_i).y);
            statuses.note(world.set_joint_target(car.joint[wheel_i], angle, 0, ingot::WheelJoint::steering));
        }
        ingot::JointDrive spin;
        if (driving.is_braked())
            spin = ingot::MotorDrive{0, driving.locked ? ingot::unlimited : driving.brake};
        else if (wheel_i >= 2 && driving.torque != 0)
            spin = ingot::MotorDrive{(driving.torque > 0 ? of.top_speed : -of.top_speed) / of.radius, ingot::abs(driving.torque)};
        statuses.note(world.set_joint_drive(car.joint[wheel_i], spin, ingot::WheelJoint::spin));
    }
    return statuses.status;
}
}  // namespace vehicle

/// For the next step, of h, s. What stays as it was is not set again: each call wakes the car.
/// Errors: those of World::set_joint_drive, set_joint_target and add_force.
template <class S>
ingot::Status drive_car(ingot::World<S>& world, Car& car, const Driving& driving, ingot::scalar h) {
    vehicle::Statuses statuses;
    if (!car.driven || !(driving == car.driving)) statuses.note(vehicle::set_driving(world, car, driving));
    car.driving = driving;
    car.driven = true;
    for (int wheel_i = 0; car.design.slips && wheel_i < 4; ++wheel_i) statuses.note(vehicle::grip_ground(world, car, wheel_i, h));
    return statuses.status;
}

}  // namespace scenes
