// SPDX-License-Identifier: MIT
// Cars on four wheels. x is forwards, z up; they stand on z = 0 with their springs unloaded.
#pragma once

#include <ingot/ingot.h>

#include <array>
#include <cmath>

#include "figures.h"

namespace cars {

using figures::scalar;
using figures::Vector;

inline constexpr double g = figures::g;

/// Cylinders turn about their z; the axle of a wheel is along y.
inline ingot::Matrix axle_along_y() { return {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}; }

struct CarSize {
    double M = 920, wheel_M = 20;            ///< kg; of the chassis, of one wheel
    double radius = 0.3, half_width = 0.03;  ///< m, of a wheel
    double base = 2.6, track = 1.5;          ///< m, between axles, between wheels of one
    double height = 0.35;                    ///< m, of the centre of the chassis above the axles
    ingot::JointDrive spring = ingot::SpringDrive{25000, 3000};
    double travel = 0.15;  ///< m, either way; 0: without limits
    double friction = 0.8;

    double mass() const { return M + 4 * wheel_M; }
    Vector half_extents() const { return {static_cast<scalar>(0.7 * base), static_cast<scalar>(0.55 * track), scalar(0.25)}; }
};

/// Wheels in the order front left, front right, rear left, rear right.
struct Car {
    CarSize size;
    ingot::BodyId chassis{};
    std::array<ingot::BodyId, 4> wheels{};
    std::array<ingot::JointId, 4> joints{};
    bool sound = true;  ///< no call was refused

    Vector hub(int wheel_i) const {
        const double x = wheel_i < 2 ? size.base / 2 : -size.base / 2, y = wheel_i % 2 == 0 ? size.track / 2 : -size.track / 2;
        return {static_cast<scalar>(x), static_cast<scalar>(y), static_cast<scalar>(size.radius)};
    }
};

inline ingot::BodyDef body_of(const ingot::MassDistribution& solid, double M, const ingot::Shape& shape, const Vector& r, double friction) {
    const ingot::MassDistribution of = ingot::with_mass(solid, static_cast<scalar>(M));
    ingot::BodyDef def;
    def.mass = {of.M, {of.I.xx, of.I.yy, of.I.zz}, {}, ingot::identity_matrix<scalar>()};
    def.shape = shape;
    def.state.r_CM = r;
    def.friction = static_cast<scalar>(friction);
    return def;
}

/// speed: m/s, with which it rolls forwards. above: m, over the ground; aside: m, along y.
template <class World>
Car add_car(World& world, const CarSize& size, double speed = 0, double above = 0, double aside = 0) {
    Car car;
    car.size = size;
    const Vector half = size.half_extents(), off = {0, static_cast<scalar>(aside), static_cast<scalar>(above)};
    const auto radius = static_cast<scalar>(size.radius), half_width = static_cast<scalar>(size.half_width);
    const Vector centre = Vector{0, 0, static_cast<scalar>(size.radius + size.height)} + off, v = {static_cast<scalar>(speed), 0, 0};
    ingot::BodyDef body = body_of(ingot::solid_box(1, half), size.M, ingot::Box{half}, centre, size.friction);
    body.state.v_CM = v;
    const auto chassis = world.add(body);
    car.sound = chassis.ok();
    car.chassis = chassis.value;
    for (int i = 0; i < 4; ++i) {
        const auto at = static_cast<std::size_t>(i);
        ingot::BodyDef wheel =
            body_of(ingot::solid_cylinder(1, radius, half_width), size.wheel_M, ingot::Cylinder{radius, half_width}, car.hub(i) + off, size.friction);
        wheel.state.A = axle_along_y();
        wheel.state.v_CM = v;
        wheel.state.L = {0, wheel.mass.I_body.z * static_cast<scalar>(speed / size.radius), 0};
        const auto added = world.add(wheel);
        ingot::JointDef def;
        def.body_A = car.chassis;
        def.body_B = added.value;
        const auto most = static_cast<scalar>(size.travel);
        def.joint = size.travel > 0 ? ingot::WheelJoint{-most, most} : ingot::WheelJoint{};
        def.P = car.hub(i) + off;
        def.axis_B = {0, 1, 0};
        const auto joint = world.add_joint(def);
        car.sound = car.sound && added.ok() && joint.ok();
        car.wheels[at] = added.value;
        car.joints[at] = joint.value;
        car.sound = car.sound && world.set_joint_drive(joint.value, size.spring, ingot::WheelJoint::travel) == ingot::Status::ok;
    }
    return car;
}

/// Drives or brakes wheels from one to another.
template <class World>
[[nodiscard]] bool drive_wheels(World& world, const Car& car, const ingot::JointDrive& drive, std::size_t begin = 0, std::size_t end = 4) {
    bool sound = true;
    for (std::size_t i = begin; i < end; ++i)
        sound = sound && world.set_joint_drive(car.joints[i], drive, ingot::WheelJoint::spin) == ingot::Status::ok;
    return sound;
}

/// Its front wheels are turned so that all axles meet in one point, the middle of the rear axle on a circle of that radius, m, to the left.
template <class World>
[[nodiscard]] bool steer_car(World& world, const Car& car, double radius) {
    bool sound = true;
    for (std::size_t i = 0; i < 2; ++i) {
        const double aside = i == 0 ? -car.size.track / 2 : car.size.track / 2;
        const auto angle = static_cast<scalar>(std::atan(car.size.base / (radius + aside)));
        sound = sound && world.set_joint_target(car.joints[i], angle, 0, ingot::WheelJoint::steering) == ingot::Status::ok;
    }
    return sound;
}

}  // namespace cars
