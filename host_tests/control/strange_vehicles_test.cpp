// SPDX-License-Identifier: MIT
// Cars as no one drives them: tiny and huge, too fast, on ice, upside down, with wheels that spin or do not turn, on a lift.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "scenes/vehicle.h"
#include "vehicle_numbers.h"

namespace {

using namespace vehicle_numbers;
using ingot::Status;
using scenes::CarDesign;

struct OnLift : scenes::OnRoad {
    static constexpr bool kinematic_bodies = true;
};

struct Ride {
    std::unique_ptr<ingot::World<OnLift>> world = std::make_unique<ingot::World<OnLift>>();
    scenes::Car car;
    scenes::Driving driving;
    double rate;

    Ride(double steps_a_second, const CarDesign& design, double speed) : rate(steps_a_second) {
        EXPECT_EQ(world->set_gravity({0, 0, number(-g)}), Status::ok);
        car.design = design;
        EXPECT_EQ(scenes::add_car(*world, {0, 0, 0}, number(speed), car), Status::ok);
    }
    Ride& on_road() {
        ingot::BodyDef ground;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        ground.friction = car.design.tyre.mu;
        EXPECT_TRUE(world->add(ground).ok());
        return *this;
    }
    void go(double seconds) {
        for (int step_i = 0; step_i < static_cast<int>(seconds * rate + 0.5); ++step_i) {
            ASSERT_EQ(scenes::drive_car(*world, car, driving, number(1 / rate)), Status::ok);
            ASSERT_EQ(ingot::step(*world, number(1 / rate)).status, Status::ok);
        }
    }
    bool stops_and_sleeps_within(double seconds) {
        driving = {};
        driving.locked = true;
        for (int step_i = 0; step_i < seconds * rate && !world->is_asleep(car.chassis); ++step_i) go(1 / rate);
        return world->is_asleep(car.chassis);
    }
    ingot::BodyState state() const { return world->state(car.chassis).value; }
    double speed() const { return std::sqrt(real(ingot::length_sq(state().v_CM))); }
};

/// Lengths of it f times as large.
CarDesign sized(bool slips, double f, double M, double hertz) {
    CarDesign design;
    design.slips = slips;
    design.wheel_M = number(M) / 50;
    design.M = number(M) - 4 * design.wheel_M;
    design.half_extents = design.half_extents * number(f);
    for (scalar* each : {&design.radius, &design.half_width, &design.base, &design.track, &design.height, &design.travel, &design.tyre.relaxation})
        *each *= number(f);
    design.hertz = number(hertz);
    design.park_speed = number(0.05 * std::sqrt(f));
    return design;
}

/// A model of 1:100 that weighs a gram, and a truck of 200 t: each straight on, and braked in its way.
TEST(StrangeVehicles, tiny_and_huge_ones_drive) {
    for (const bool slips : {false, true})
        for (const double f : {0.01, 4.0}) {
            const double v = f < 1 ? 0.3 : 15, way = v * v / (2 * 0.8 * g);
            Ride ride(60, sized(slips, f, f < 1 ? 1e-3 : 2e5, f < 1 ? 15 : 1), v);
            ride.on_road().go(3);
            EXPECT_NEAR(real(ride.state().r_CM.x), 3 * v, 1e-4 * 3 * v) << slips << ", " << f;
            EXPECT_NEAR(real(ride.state().r_CM.y), 0, 1e-3 * f) << slips << ", " << f;
            const double x = real(ride.state().r_CM.x);
            EXPECT_TRUE(ride.stops_and_sleeps_within(6)) << slips << ", " << f;
            EXPECT_NEAR(real(ride.state().r_CM.x) - x, way, 0.01 * way + v / 60 + 0.08 * f) << slips << ", " << f;
        }
}

/// 100 m/s at 240 steps a second.
TEST(StrangeVehicles, fast_ones_go_straight) {
    for (const bool slips : {false, true}) {
        CarDesign design;
        design.slips = slips;
        Ride ride(240, design, 100);
        ride.on_road().go(3);
        EXPECT_NEAR(real(ride.state().r_CM.y), 0, 1e-3) << slips;
        EXPECT_NEAR(ride.speed(), 100, 1e-2) << slips;
    }
}

/// Where nothing grips nothing brakes, or drives.
TEST(StrangeVehicles, on_ice_keep_their_speed) {
    for (const bool slips : {false, true}) {
        CarDesign design;
        design.slips = slips;
        design.tyre.mu = 0;
        Ride ride(60, design, 20);
        ride.on_road();
        ride.driving.torque = 100;
        ride.go(1);
        ride.driving = {};
        ride.driving.brake = 500;
        ride.driving.curvature = number(0.05);
        ride.go(3);
        EXPECT_NEAR(ride.speed(), 20, 1e-3) << slips;
        EXPECT_GE(real(ride.state().A.c2.z), 0.999) << slips;
    }
}

/// With five times the torque that its tyres hold its wheels spin, up to the top speed of its motors; it gets no further than friction takes it.
TEST(StrangeVehicles, with_too_much_torque_spin_their_wheels) {
    for (const bool slips : {false, true}) {
        CarDesign design;
        design.slips = slips;
        Ride ride(60, design, 0);
        ride.on_road();
        ride.driving.torque = 3000;
        ride.go(3);
        EXPECT_LE(ride.speed(), 0.8 * g * 3) << slips;
        EXPECT_GE(ride.speed(), 0.4 * g * 3) << slips;
        const double spin = std::sqrt(real(ingot::length_sq(ride.world->omega(ride.car.wheel[2]).value)));
        EXPECT_NEAR(spin, 55 / 0.3, 0.02 * 55 / 0.3) << slips;
        EXPECT_GE(real(ride.state().A.c2.z), 0.99) << slips;
    }
}

/// With a wheel that does not turn, and steered hard at 30 m/s, it slides, stays on its wheels, and stops when it is told to.
TEST(StrangeVehicles, that_slide_stay_on_their_wheels) {
    for (const bool slips : {false, true})
        for (const bool is_steered : {false, true}) {
            CarDesign design;
            design.slips = slips;
            Ride ride(60, design, 30);
            ride.on_road();
            if (is_steered) ride.driving.curvature = number(0.2);
            ride.go(0.5);
            if (!is_steered) {
                ASSERT_EQ(ride.world->set_joint_drive(ride.car.joint[0], ingot::MotorDrive{0}, ingot::WheelJoint::spin), Status::ok);
            }
            ride.go(2);
            EXPECT_LE(ride.speed(), 29) << slips << is_steered;
            EXPECT_GE(real(ride.state().A.c2.z), 0.98) << slips << is_steered;
            EXPECT_TRUE(ride.stops_and_sleeps_within(10)) << slips << is_steered;
        }
}

/// On its roof nothing drives it, and it sleeps.
TEST(StrangeVehicles, upside_down_lie_still) {
    for (const bool slips : {false, true}) {
        CarDesign design;
        design.slips = slips;
        Ride ride(60, design, 0);
        ride.on_road();
        const auto flipped = [](const ingot::Vector& v) { return ingot::Vector{v.x, -v.y, -v.z}; };
        const ingot::BodyId bodies[] = {ride.car.chassis, ride.car.wheel[0], ride.car.wheel[1], ride.car.wheel[2], ride.car.wheel[3]};
        for (const ingot::BodyId id : bodies) {
            ingot::BodyState state = ride.world->state(id).value;
            state.r_CM = flipped(state.r_CM) + ingot::Vector{0, 0, number(1.4)};
            state.A = {flipped(state.A.c0), flipped(state.A.c1), flipped(state.A.c2)};
            ASSERT_EQ(ride.world->set_state(id, state), Status::ok);
        }
        ride.driving.torque = 200;
        ride.go(3);
        EXPECT_NEAR(std::hypot(real(ride.state().r_CM.x), real(ride.state().r_CM.y)), 0, 0.05) << slips;
        EXPECT_TRUE(ride.stops_and_sleeps_within(5)) << slips;
    }
}

/// Braked on a lift it goes where the lift goes: up, down, and aside.
TEST(StrangeVehicles, stand_on_a_lift) {
    for (const bool slips : {false, true}) {
        CarDesign design;
        design.slips = slips;
        Ride ride(60, design, 0);
        ingot::BodyDef def;
        def.kinematic = true;
        def.shape = ingot::Box{{10, 10, number(0.5)}};
        def.state.r_CM = {0, 0, number(-0.5)};
        def.friction = number(0.8);
        const ingot::BodyId lift = ride.world->add(def).value;
        ride.driving.brake = 3000;
        for (int step_i = 0; step_i < 600; ++step_i) {
            const double t = step_i / 60.0, up = t < 2 ? 1 : t < 4 ? -1 : 0, aside = t < 5 ? 0 : std::min(2.0, 2 * (t - 5));
            ASSERT_EQ(ride.world->set_velocity(lift, {number(aside), 0, number(up)}, {}), Status::ok);
            ride.go(1.0 / 60);
        }
        const ingot::Vector off = ride.state().r_CM - ride.world->state(lift).value.r_CM;
        EXPECT_NEAR(std::hypot(real(off.x), real(off.y)), 0, 0.02) << slips;
        EXPECT_NEAR(real(off.z), 1.15, 1e-3) << slips;
    }
}

}  // namespace
