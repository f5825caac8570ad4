// SPDX-License-Identifier: MIT
// Cars whose tyres grip by friction, and by a slip law: straight on, round, faster, braked, over bumps, at rest; all sizes, in company, saved.
#include "scenes/vehicle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "reference/random_input.h"
#include "vehicle_numbers.h"

namespace {

using namespace vehicle_numbers;
using ingot::Status;
using ingot_reference::RandomInput;
using scenes::Car;
using scenes::CarDesign;
using scenes::Driving;
using scenes::OnRoad;

template <class S>
void add_road(ingot::World<S>& world, scalar mu, double slope = 0) {
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    ground.friction = mu;
    ASSERT_EQ(world.set_gravity({number(-g * std::sin(slope)), 0, number(-g * std::cos(slope))}), Status::ok);
    ASSERT_TRUE(world.add(ground).ok());
}

/// A car on a road, and what was seen on the way.
struct Ride {
    std::unique_ptr<ingot::World<OnRoad>> world = std::make_unique<ingot::World<OnRoad>>();
    double rate;
    Car car;
    Driving driving;
    double gap = 0, least_up = 1, aside = 0;  ///< m, cosine of the lean, m

    Ride(double steps_a_second, const CarDesign& design, double speed, double slope = 0) : rate(steps_a_second) {
        add_road(*world, design.tyre.mu, slope);
        car.design = design;
        EXPECT_EQ(scenes::add_car(*world, {0, 0, 0}, number(speed), car), Status::ok);
    }
    void step() {
        ASSERT_EQ(scenes::drive_car(*world, car, driving, number(1 / rate)), Status::ok);
        (void)ingot::step(*world, number(1 / rate));
        const ingot::BodyState now = state();
        least_up = std::min(least_up, real(now.A.c2.z));
        aside = std::max(aside, std::abs(real(now.r_CM.y)));
        for (const ingot::JointId joint : car.joint) gap = std::max(gap, real(world->joint_gap(joint).value));
    }
    void go(double seconds) {
        for (int step_i = 0; step_i < static_cast<int>(seconds * rate + 0.5); ++step_i) step();
    }
    bool falls_asleep_within(double seconds) {
        for (int step_i = 0; step_i < seconds * rate && !world->is_asleep(car.chassis); ++step_i) step();
        return world->is_asleep(car.chassis);
    }
    ingot::BodyState state() const { return world->state(car.chassis).value; }
    double x() const { return real(state().r_CM.x); }
    double speed() const { return std::sqrt(real(ingot::length_sq(state().v_CM))); }
    double mass() const { return real(car.design.mass()); }
    /// kg, with what turns along.
    double rolling_mass() const {
        return mass() + 4 * real(car.design.radius * car.design.radius / car.spinning) / real(car.design.radius * car.design.radius);
    }
    /// m, of the way of the middle of the rear axle over the next seconds, over the turn.
    double radius_of_way(double seconds) {
        double way = 0, turn = 0;
        for (int step_i = 0; step_i < seconds * rate; ++step_i) {
            const ingot::BodyState a = state();
            step();
            const ingot::BodyState b = state();
            const ingot::Vector r = (b.r_CM - b.A.c0 * (car.design.base / 2)) - (a.r_CM - a.A.c0 * (car.design.base / 2));
            way += std::hypot(real(r.x), real(r.y));
            turn += std::atan2(real(a.A.c0.x * b.A.c0.y - a.A.c0.y * b.A.c0.x), real(a.A.c0.x * b.A.c0.x + a.A.c0.y * b.A.c0.y));
        }
        return way / turn;
    }
};

CarDesign car_that(bool slips) {
    CarDesign design;
    design.slips = slips;
    return design;
}
std::vector<double> rates() {
    if (INGOT_TEST_BRIEF) return {60};
    return {30, 60, 120, 240};
}
/// Whether wheels turn by less than a radian in a substep.
bool is_followed(double speed, const CarDesign& design, double rate) { return speed <= 0.8 * real(design.radius) * OnRoad::effort.substeps * rate; }
/// m, by which a place may be off that is rounded in every step, the same way each time, since each step is as long.
double grain(double x, double rate, double seconds) { return eps * x * rate * seconds / 2; }

/// Within a millimetre of its line in ten seconds, and as far as it was thrown. Far from the origin what float knows of the places of two axles is a
/// heading that is off by a grain over the wheelbase, at worst: of speeds from 4 to 60 m/s one in forty leaves the millimetre in float, by up to
/// 5 mm, and none in double, by 0.3 mm at most.
TEST(Vehicle, goes_straight_on) {
    for (const bool slips : {false, true})
        for (const double rate : rates())
            for (const double speed : {2.0, 20.0, 34.0, 46.0, 60.0}) {
                if (!is_followed(speed, car_that(slips), rate) || (INGOT_TEST_BRIEF && speed > 30)) continue;
                Ride ride(rate, car_that(slips), speed);
                ride.go(10);
                const double way = 10 * speed, far = eps * way * way / real(ride.car.design.base);
                EXPECT_LE(ride.aside, 1e-3 + far) << slips << ", " << rate << " Hz, " << speed << " m/s";
                EXPECT_NEAR(ride.x(), way, 1e-5 * way + grain(way, rate, 10))
                    << slips << ", " << rate << " Hz, " << speed << " m/s";
                EXPECT_GE(ride.least_up, 1 - 1e-5) << slips << ", " << rate << " Hz";
            }
}

/// Slowly, on the circle on which all wheels roll: within 1 %.
TEST(Vehicle, turns_on_the_circle_of_its_wheels) {
    for (const bool slips : {false, true})
        for (const double rate : rates())
            for (const double radius : {6.0, 15.0}) {
                Ride ride(rate, car_that(slips), 1);
                for (int step_i = 1; step_i <= rate; ++step_i) {
                    ride.driving.curvature = number(step_i / rate / radius);
                    ride.step();
                }
                ride.go(1);
                EXPECT_NEAR(ride.radius_of_way(3), radius, 0.01 * radius) << slips << ", " << rate << " Hz";
            }
}

/// m, that it goes until it stands, its wheels locked, beyond v^2 / (2 mu g).
double beyond_way(Ride& ride) {
    const double x = ride.x(), v = ride.speed(), mu = real(ride.car.design.tyre.mu);
    ride.driving = {};
    ride.driving.locked = true;
    ride.go(v / mu / g + 1.5);
    return ride.x() - x - v * v / (2 * mu * g);
}
/// m, by which it may be short of that. Braked it bows by mu M g height / (k base^2), and as it stands it rises, its wheels locked; bristles of its
/// tyres straighten too. Beside that: what it goes in half a substep, since places lead velocities, and the step in which it stops.
double short_at_most(const Ride& ride, double v) {
    const CarDesign& of = ride.car.design;
    const double mu = real(of.tyre.mu), height = real(of.radius + of.height), swing = 2 * 3.14159265 * real(of.hertz);
    const double bow = std::min(4 * mu * g * height / (swing * swing * real(of.base * of.base)), 2 * real(of.travel / of.base)) * height;
    const double bend = of.slips ? 3 * mu * real(of.tyre.relaxation / of.tyre.along) : 0;
    return bow + bend + v / ride.rate / (2 * OnRoad::effort.substeps) + mu * g / ride.rate / ride.rate;
}

/// In v^2 / (2 mu g), within 1 % from 20 m/s on; then it stands, and sleeps.
TEST(Vehicle, brakes_in_the_way_that_friction_allows) {
    for (const bool slips : {false, true})
        for (const double rate : rates())
            for (const double speed : {10.0, 20.0, 60.0}) {
                if (!is_followed(speed, car_that(slips), rate)) continue;
                Ride ride(rate, car_that(slips), speed);
                ride.go(1);
                const double v = ride.speed(), way = v * v / (2 * real(ride.car.design.tyre.mu) * g), beyond = beyond_way(ride);
                EXPECT_LE(beyond, 0.001 * way) << slips << ", " << rate << " Hz, " << speed << " m/s";
                EXPECT_GE(beyond, -0.001 * way - short_at_most(ride, v)) << slips << ", " << rate << " Hz, " << speed << " m/s";
                if (speed < 20) continue;
                EXPECT_LE(std::abs(beyond), 0.01 * way) << slips << ", " << rate << " Hz, " << speed << " m/s";
                EXPECT_LE(ride.speed(), 1e-3 + 4 * rate * eps * ride.x()) << slips << ", " << rate << " Hz, " << speed << " m/s";
            }
}

/// Motors and brakes that its tyres hold do what Newton says: torque over radius, over what has to be moved and turned.
TEST(Vehicle, goes_faster_and_slower_as_its_wheels_are_turned) {
    for (const bool slips : {false, true})
        for (const double rate : rates()) {
            Ride ride(rate, car_that(slips), 0);
            ride.go(0.2);
            ride.driving.torque = 300;
            ride.go(3);
            const double a = 2 * 300 / real(ride.car.design.radius) / ride.rolling_mass(), v = ride.speed();
            EXPECT_NEAR(v, 3 * a, 0.01 * 3 * a) << slips << ", " << rate << " Hz";
            ride.driving = {};
            ride.driving.brake = 200;
            ride.go(1);
            const double b = 4 * 200 / real(ride.car.design.radius) / ride.rolling_mass();
            EXPECT_NEAR(ride.speed(), v - b, 0.01 * v) << slips << ", " << rate << " Hz";
            EXPECT_LE(ride.aside, 1e-3) << slips << ", " << rate << " Hz";
        }
}

/// In a steady turn, with a third of what grips, bristles are bent as the law has it, whatever the step is: what others do to a tyre is foretold
/// right.
TEST(Vehicle, slips_in_a_turn_as_the_law_says) {
    for (const double rate : rates()) {
        Ride ride(rate, car_that(true), 12);
        for (int step_i = 1; step_i <= 2 * rate; ++step_i) {
            ride.driving.curvature = number(step_i / rate / 2 / 50);
            ride.step();
        }
        ride.go(3);
        for (int wheel_i = 0; wheel_i < 4; ++wheel_i) {
            const scenes::Grip& grip = ride.car.grip[wheel_i];
            const double wanted = real(grip.slip[1] * ride.car.design.tyre.relaxation) / ride.speed();
            EXPECT_NEAR(real(grip.bent[1]), wanted, 0.02 * std::abs(wanted)) << rate << " Hz, wheel " << wheel_i;
            EXPECT_GE(std::abs(wanted), 1e-3);
        }
    }
}

/// On the flat and on a slope of 10 degrees, its brakes on, it comes to rest, sleeps, and stays where it is.
TEST(Vehicle, rests_and_sleeps) {
    for (const bool slips : {false, true})
        for (const double rate : rates())
            for (const double slope : {0.0, 0.17}) {
                Ride ride(rate, car_that(slips), 0, slope);
                ride.driving.brake = 3000;
                EXPECT_TRUE(ride.falls_asleep_within(6)) << slips << ", " << rate << " Hz, " << slope;
                EXPECT_NEAR(real(ride.state().r_CM.z), 0.65, slope > 0 ? 2e-2 : 1e-4) << slips << ", " << rate << " Hz";
                EXPECT_LE(std::hypot(ride.x(), real(ride.state().r_CM.y)), slope > 0 ? 0.1 : 1e-4) << slips << ", " << rate << " Hz";
            }
}

/// Over bumps of 40 mm, some under one side alone, it stays on its wheels; braked after that it sleeps.
TEST(Vehicle, stays_on_its_wheels_over_bumps) {
    for (const bool slips : {false, true})
        for (const double rate : rates()) {
            Ride ride(rate, car_that(slips), 5);
            for (int i = 0; i < 12; ++i) {
                ingot::BodyDef bump;
                bump.immovable = true;
                bump.shape = ingot::Box{{number(0.15), number(i % 3 == 0 ? 0.6 : 3), number(0.04)}};
                bump.state.r_CM = {number(6 + 2 * i), number(i % 3 == 0 ? 0.8 : 0), 0};
                bump.friction = number(0.8);
                ASSERT_TRUE(ride.world->add(bump).ok());
            }
            ride.driving.torque = 250;
            ride.go(6);
            EXPECT_GE(ride.x(), 29) << slips << ", " << rate << " Hz";
            ride.driving = {};
            ride.driving.brake = 3000;
            EXPECT_TRUE(ride.falls_asleep_within(8) || (rate > 120 && ride.speed() <= 4 * rate * eps * ride.x())) << slips << ", " << rate << " Hz";
            EXPECT_GE(ride.least_up, 0.99) << slips << ", " << rate << " Hz";
            EXPECT_LE(ride.gap, 5e-5 * (1 + eps / 1e-7)) << slips << ", " << rate << " Hz";
        }
}

constexpr int cars_drawn = INGOT_TEST_BRIEF ? 3 : 60;

CarDesign random_car(RandomInput& random) {
    CarDesign design;
    design.slips = random.integer(0, 1) == 1;
    design.M = number(std::pow(10, random.real(2, 4)));
    design.wheel_M = design.M * number(random.real(0.005, 0.015));  // heavier ones, locked at 50 m/s, throw it onto its nose
    design.radius = number(random.real(0.25, 0.6));
    design.half_width = design.radius * number(random.real(0.05, 0.4));
    design.base = number(random.real(1.8, 4));
    design.track = number(random.real(1.2, 2.2));
    design.height = number(random.real(0.05, 0.5));
    design.half_extents = {design.base * number(0.7), design.track * number(0.55), number(0.25)};
    design.hertz = number(random.real(1, 3));
    design.damping_ratio = number(random.real(0.2, 1));
    design.tyre.mu = number(random.real(0.3, 1));
    design.tyre.along = number(random.real(8, 20));
    design.tyre.across = number(random.real(6, 15));
    design.tyre.relaxation = design.radius * number(random.real(0.5, 1.5));
    return design;
}

/// Of all sizes, at up to 60 m/s: they go straight, brake in their way, and sleep. All within the bars of the one of a ton.
TEST(Vehicle, of_all_sizes_go_straight_and_brake) {
    RandomInput random(1);
    for (int case_i = 0; case_i < cars_drawn; ++case_i) {
        const CarDesign design = random_car(random);
        const double rate = std::pow(2, random.integer(0, 3)) * 30;
        const double speed = std::min(random.real(5, 60), 0.8 * real(design.radius) * OnRoad::effort.substeps * rate);
        Ride ride(rate, design, speed);
        ride.go(3);
        EXPECT_LE(ride.aside, 1e-3) << "case " << case_i << ", " << design.slips << ", " << rate << " Hz, " << speed << " m/s";
        const double v = ride.speed(), way = v * v / (2 * real(design.tyre.mu) * g), beyond = beyond_way(ride);
        EXPECT_NEAR(v, speed, 1e-4 * speed) << "case " << case_i;
        EXPECT_LE(beyond, 0.005 * way) << "case " << case_i << ", " << design.slips << ", " << rate << " Hz, " << speed << " m/s";
        EXPECT_GE(beyond, -0.005 * way - short_at_most(ride, v))
            << "case " << case_i << ", " << design.slips << ", " << rate << " Hz, " << speed << " m/s";
        EXPECT_TRUE(ride.falls_asleep_within(5) || ride.speed() <= 1e-3 + 4 * rate * eps * ride.x()) << "case " << case_i;
        EXPECT_LE(ride.gap, 5e-5 * (1 + eps / 1e-7)) << "case " << case_i;
    }
}

/// And they turn on the circle of their wheels.
TEST(Vehicle, of_all_sizes_turn) {
    RandomInput random(2);
    for (int case_i = 0; case_i < cars_drawn; ++case_i) {
        CarDesign design = random_car(random);
        const double rate = std::pow(2, random.integer(0, 3)) * 30, radius = random.real(2.5, 8) * real(design.base);
        Ride ride(rate, design, 1);
        ride.driving.torque = number(1e-3 * g) * design.mass() * design.radius;
        for (int step_i = 1; step_i <= rate; ++step_i) {
            ride.driving.curvature = number(step_i / rate / radius);
            ride.step();
        }
        ride.go(1);
        const double way = ride.radius_of_way(2);
        EXPECT_NEAR(way, radius, 0.01 * radius) << "case " << case_i << ", " << design.slips << ", " << rate << " Hz";
    }
}

/// Beside another and a heap that falls it drives as it does alone, to the bit; and what is saved in motion goes on to the same bits.
TEST(Vehicle, is_the_same_in_company_and_from_a_snapshot) {
    for (const bool slips : {false, true}) {
        Ride alone(60, car_that(slips), 8);
        const auto world = std::make_unique<ingot::World<OnRoad>>();
        add_road(*world, alone.car.design.tyre.mu);
        ingot::BodyDef stone;
        stone.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, {number(0.2), number(0.2), number(0.2)}), 20)).value;
        stone.shape = ingot::Box{{number(0.2), number(0.2), number(0.2)}};
        for (int i = 0; i < 6; ++i) {
            stone.state.r_CM = {number(i % 2 * 0.1), -6, number(0.25 + i * 0.45)};
            ASSERT_TRUE(world->add(stone).ok());
        }
        Car first, second;
        first.design = second.design = alone.car.design;
        second.design.M = 2000;
        ASSERT_EQ(scenes::add_car(*world, {0, 8, 0}, 5, second), Status::ok);
        ASSERT_EQ(scenes::add_car(*world, {0, 0, 0}, 8, first), Status::ok);
        const auto restored = std::make_unique<ingot::World<OnRoad>>();
        Car saved;
        for (int step_i = 0; step_i < 240; ++step_i) {
            alone.driving.torque = step_i < 60 ? 400 : 0;
            alone.driving.curvature = step_i < 120 ? number(step_i * 2e-4) : 0;
            alone.driving.brake = step_i > 150 ? 500 : 0;
            if (step_i == 100) {
                std::vector<uint8_t> bytes(ingot::snapshot_size<OnRoad>());
                const auto size = ingot::save_snapshot(*world, bytes.data(), bytes.size());
                ASSERT_TRUE(size.ok());
                ASSERT_EQ(ingot::load_snapshot(*restored, bytes.data(), size.value), Status::ok);
                saved = first;
            }
            alone.step();
            Driving other;
            other.torque = 100;
            ASSERT_EQ(scenes::drive_car(*world, first, alone.driving, number(1.0 / 60)), Status::ok);
            ASSERT_EQ(scenes::drive_car(*world, second, other, number(1.0 / 60)), Status::ok);
            (void)ingot::step(*world, number(1.0 / 60));
            const ingot::BodyState a = alone.state(), b = world->state(first.chassis).value;
            ASSERT_TRUE(std::memcmp(&a, &b, sizeof a) == 0) << slips << ", step " << step_i;
            if (step_i < 100) continue;
            ASSERT_EQ(scenes::drive_car(*restored, saved, alone.driving, number(1.0 / 60)), Status::ok);
            (void)ingot::step(*restored, number(1.0 / 60));
            const ingot::BodyState c = restored->state(saved.chassis).value;
            ASSERT_TRUE(std::memcmp(&b, &c, sizeof b) == 0) << slips << ", step " << step_i;
        }
    }
}

}  // namespace
