// SPDX-License-Identifier: MIT
// A tank on its belts: straight on, about itself and round; and cars and tanks over hills of triangles.
#include "scenes/tank.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "reference/draws.h"
#include "reference/random_input.h"
#include "scenes/vehicle.h"
#include "vehicle_numbers.h"

namespace {

using namespace vehicle_numbers;
using ingot::Status;
using ingot_reference::draws;
using ingot_reference::RandomInput;
using scenes::Tank;

struct Drive {
    std::unique_ptr<ingot::World<scenes::OnTracks>> world = std::make_unique<ingot::World<scenes::OnTracks>>();
    double rate;
    Tank tank;

    Drive(double steps_a_second, const scenes::TankDesign& design) : rate(steps_a_second) {
        ingot::BodyDef ground;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        ground.friction = design.mu;
        EXPECT_EQ(world->set_gravity({0, 0, number(-g)}), Status::ok);
        EXPECT_TRUE(world->add(ground).ok());
        tank.design = design;
        EXPECT_EQ(scenes::add_tank(*world, {0, 0, 0}, tank), Status::ok);
    }
    void go(double seconds, double left, double right) {
        for (int step_i = 0; step_i < static_cast<int>(seconds * rate + 0.5); ++step_i) {
            ASSERT_EQ(scenes::drive_tank(*world, tank, number(left), number(right)), Status::ok);
            (void)ingot::step(*world, number(1 / rate));
        }
    }
    bool stops_and_sleeps_within(double seconds) {
        for (int step_i = 0; step_i < seconds * rate && !world->is_asleep(tank.hull); ++step_i) go(1 / rate, 0, 0);
        return world->is_asleep(tank.hull);
    }
    ingot::BodyState state() const { return world->state(tank.hull).value; }
};

/// As fast as its belts, and straight: they do not slip.
TEST(Tank, goes_as_fast_as_its_belts) {
    for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
        Drive drive(rate, {});
        drive.go(4, 3, 3);
        EXPECT_NEAR(real(drive.state().v_CM.x), 3, 3e-3) << rate << " Hz";
        EXPECT_NEAR(real(drive.state().r_CM.y), 0, 1e-3) << rate << " Hz";
        EXPECT_TRUE(drive.stops_and_sleeps_within(5)) << rate << " Hz";
    }
}

/// Of all sizes: it turns about itself, and round, as fast as friction of sliding belts has no torque, within 1 %; its middle as fast as both belts
/// in the mean. Slowly, so that its turn asks for a hundredth of what friction can give.
TEST(Tank, turns_as_its_belts_slide) {
    RandomInput random(1);
    for (int case_i = 0; case_i < draws(24); ++case_i) {
        scenes::TankDesign design;
        design.M = number(std::pow(10, random.real(2, 4.7)));
        design.wheel_M = design.M * number(random.real(0.005, 0.02));
        design.half_length = number(random.real(1.2, 3));
        design.apart = number(random.real(1.6, 3));
        design.mu = number(random.real(0.3, 1));
        design.hertz = number(random.real(1, 2.5));
        const double rate = std::pow(2, random.integer(0, 3)) * 30, quick = 0.1;
        const double right = random.real(0.5, 1) * quick, left = random.real(-1, 0.4) * quick;
        Drive drive(rate, design);
        drive.go(2, left, right);
        const ingot::BodyState a = drive.state();
        drive.go(1, left, right);
        const ingot::BodyState b = drive.state();
        const double turn = std::atan2(real(a.A.c0.x * b.A.c0.y - a.A.c0.y * b.A.c0.x), real(a.A.c0.x * b.A.c0.x + a.A.c0.y * b.A.c0.y));
        const double wanted = real(scenes::turn_rate(drive.tank, number(left), number(right)));
        EXPECT_NEAR(turn, wanted, 0.01 * wanted) << "case " << case_i << ", " << rate << " Hz";
        EXPECT_NEAR(std::hypot(real(b.r_CM.x - a.r_CM.x), real(b.r_CM.y - a.r_CM.y)), std::abs(left + right) / 2, 0.01 * quick)
            << "case " << case_i << ", " << rate << " Hz";
        EXPECT_TRUE(drive.stops_and_sleeps_within(5)) << "case " << case_i << ", " << rate << " Hz";
    }
}

// Hills

constexpr int columns = 65, rows = 17;
uint16_t heights[columns * rows];  // in steps of 1/256 m

struct Hills : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 16, max_manifolds = 128, max_pairs = 400;
    static constexpr bool translates = true, sleeps = true, surface_velocities = true;
    static constexpr ingot::Effort effort = {4, 12};
    using shapes = ingot::Shapes<ingot::Box, ingot::Cylinder, ingot::Sphere, ingot::Level>;
    using joints = ingot::Joints<ingot::WheelJoint, ingot::SliderJoint, ingot::WithLimits, ingot::WithDrives>;
    static inline ingot::LevelTable levels[1] = {};
};

/// Cells of a metre, and waves of up to 15 cm, 5 m and more long, whose crests are askew.
void add_hills(ingot::World<Hills>& world) {
    for (int row_i = 0; row_i < rows; ++row_i)
        for (int column_i = 0; column_i < columns; ++column_i) {
            const double wave = std::sin(column_i * 0.7 + row_i * 0.3) + std::sin(column_i * 1.1 - row_i * 0.5),
                         begin = std::min(1.0, column_i / 12.0);
            heights[row_i * columns + column_i] = static_cast<uint16_t>(std::lround(256 * (0.2 + 0.075 * begin * wave)));
        }
    static const auto field = ingot::height_field_of<columns, rows>(heights, 1, 1, scalar(1) / 256, {nullptr, false, {-4, -8, 0}});
    ASSERT_TRUE(field.ok());
    Hills::levels[0] = field.value.view();
    ASSERT_EQ(world.set_gravity({0, 0, number(-g)}), Status::ok);
    ingot::LevelDef ground;
    ground.friction = number(0.8);
    ASSERT_TRUE(world.add_level(ground).ok());
}

/// Cars with either tyres and a tank go 40 m over hills, stay upright, and sleep where they are stopped.
TEST(Hills, are_driven_over) {
    for (const double rate : {30.0, 60.0, 120.0, 240.0})
        for (int which = 0; which < 3; ++which) {
            const auto world = std::make_unique<ingot::World<Hills>>();
            add_hills(*world);
            scenes::Car car;
            Tank tank;
            car.design.slips = which == 1;
            const ingot::Vector place = {0, 0, number(0.21)};
            ASSERT_EQ(which < 2 ? scenes::add_car(*world, place, 4, car) : scenes::add_tank(*world, place, tank), Status::ok);
            const ingot::BodyId body = which < 2 ? car.chassis : tank.hull;
            double least_up = 1;
            bool arrived = false;
            int asleep_after = -1;
            for (int step_i = 0; step_i < 40 * rate && asleep_after < 0; ++step_i) {
                const ingot::BodyState now = world->state(body).value;
                arrived = arrived || now.r_CM.x > 40;
                scenes::Driving driving;
                driving.brake = arrived ? 3000 : 0;
                // Back to the middle, by where it is and where it looks; and at 4 m/s.
                driving.curvature =
                    arrived ? 0 : ingot::max(number(-0.1), ingot::min(number(0.1), -now.r_CM.y * number(0.02) - now.A.c0.y * number(0.3)));
                driving.torque = arrived ? 0 : (4 - now.v_CM.x) * 500;
                const scalar speed = arrived ? 0 : 3, turn = arrived ? 0 : -now.r_CM.y * number(0.2) - now.A.c0.y * 2;
                ASSERT_EQ(which < 2 ? scenes::drive_car(*world, car, driving, number(1 / rate))
                                    : scenes::drive_tank(*world, tank, speed - turn, speed + turn),
                          Status::ok);
                (void)ingot::step(*world, number(1 / rate));
                least_up = std::min(least_up, real(now.A.c2.z));
                if (world->is_asleep(body)) asleep_after = step_i;
            }
            EXPECT_TRUE(arrived) << which << ", " << rate << " Hz";
            // 40 m from the origin the grain of a place over a substep may keep it awake, at any rate.
            const double grain = 4 * rate * eps * 40, speed = std::sqrt(real(ingot::length_sq(world->state(body).value.v_CM)));
            EXPECT_TRUE(asleep_after >= 0 || speed <= grain) << which << ", " << rate << " Hz";
            EXPECT_GE(least_up, 0.95) << which << ", " << rate << " Hz";
        }
}

}  // namespace
