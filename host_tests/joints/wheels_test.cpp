// SPDX-License-Identifier: MIT
// Wheels: what they lock and leave free, whichever way a figure has them; and cars that stand, drive, turn, brake and go over bumps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>

#include "cars.h"
#include "reference/draws.h"

namespace {

using namespace cars;
using figures::RandomInput;
using figures::rates;
using ingot::Status;
using ingot::WheelJoint;
using ingot_reference::to_eigen;
using ingot_reference::to_vector;

const double pi = std::acos(-1.0);
scalar number(double x) { return static_cast<scalar>(x); }

/// Nothing touches.
struct InFlight : ingot::Scene {
    static constexpr int max_bodies = 8, max_joints = 8;
    static constexpr bool translates = true;
    using joints = ingot::Joints<WheelJoint, ingot::SliderJoint, ingot::WithLimits, ingot::WithDrives>;
};
using Flight = ingot::World<InFlight>;

struct OnRoad : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 8, max_manifolds = 64, max_pairs = 300;
    static constexpr bool translates = true, sleeps = true;
    using joints = ingot::Joints<WheelJoint, ingot::SliderJoint, ingot::WithLimits, ingot::WithDrives>;
    using shapes = ingot::Shapes<ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
};
using Road = ingot::World<OnRoad>;

/// A road, and a car on it.
struct Ride {
    std::unique_ptr<Road> world = std::make_unique<Road>();
    double rate;
    Car car;
    double gap = 0, least_up = 1;  ///< m, of any step so far; cosine of the lean

    Ride(double steps_a_second, const CarSize& size, double speed = 0, double above = 0) : rate(steps_a_second) {
        ingot::BodyDef ground;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        ground.friction = number(size.friction);
        EXPECT_TRUE(world->add(ground).ok());
        EXPECT_TRUE(figures::weigh(*world));
        car = add_car(*world, size, speed, above);
        EXPECT_TRUE(car.sound);
    }
    void go(double seconds) {
        for (int step_i = 0; step_i < seconds * rate; ++step_i) step();
    }
    void step() {
        (void)ingot::step(*world, number(1 / rate));
        for (const ingot::JointId joint : car.joints) gap = std::max(gap, static_cast<double>(world->joint_gap(joint).value));
        least_up = std::min(least_up, to_eigen(chassis().A).col(2).z());
    }
    ingot::BodyState chassis() const { return world->state(car.chassis).value; }
    Eigen::Vector3d rear() const { return to_eigen(chassis().r_CM) - to_eigen(chassis().A).col(0) * car.size.base / 2; }
    double speed() const { return to_eigen(chassis().v_CM).norm(); }
};

// Alone

/// Of all bodies of a world without gravity: momentum, and angular momentum about the origin.
struct Momenta {
    Eigen::Vector3d p = Eigen::Vector3d::Zero(), L = Eigen::Vector3d::Zero();
    double size_of_p = 0, size_of_L = 0;  ///< of what is summed
};
Momenta momenta_of(const Flight& world, const std::vector<ingot::BodyId>& bodies, const std::vector<double>& masses) {
    Momenta sum;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const ingot::BodyState state = world.state(bodies[i]).value;
        const Eigen::Vector3d p = masses[i] * to_eigen(state.v_CM), L = to_eigen(state.L) + to_eigen(state.r_CM).cross(p);
        sum.p += p;
        sum.L += L;
        sum.size_of_p += p.norm();
        sum.size_of_L += L.norm();
    }
    return sum;
}

/// A wheel and what it carries tumble in space, the heavier of the two being the root of their figure. Momentum stays, and angular momentum
/// to a thousandth; the gap stays closed, the axle stays at right angles to the suspension, and what is read agrees with the poses.
TEST(Wheels, leave_a_travel_a_spin_and_a_steering_and_nothing_else) {
    RandomInput random(1);
    for (int case_i = 0; case_i < ingot_reference::draws(40); ++case_i) {
        const double rate = rates[random.integer(0, 4)], heavy = random.real(1, 100);
        const std::vector<double> masses = {case_i % 2 == 0 ? heavy : 1, case_i % 2 == 0 ? 1 : heavy};
        const auto world = std::make_unique<Flight>();
        std::vector<ingot::BodyId> bodies;
        const Eigen::Vector3d P = random.vector(1);
        for (const double M : masses) {
            ingot::BodyDef def =
                body_of(ingot::solid_box(1, to_vector(Eigen::Vector3d(random.real(0.2, 0.4), random.real(0.2, 0.4), random.real(0.2, 0.4)))), M, {},
                        to_vector((P + random.vector(0.5)).eval()), 0);
            def.state.v_CM = to_vector(random.vector(0.3));
            def.state.L = to_vector((random.vector(0.05) * M).eval());
            bodies.push_back(world->add(def).value);
        }
        const Eigen::Vector3d along = random.direction(), axle = along.unitOrthogonal();
        ingot::JointDef def;
        def.body_A = bodies[0];
        def.body_B = bodies[1];
        def.joint = WheelJoint{number(-0.2), number(0.2)};
        def.P = to_vector(P);
        def.axis = to_vector(along);
        def.axis_B = to_vector(axle);
        const ingot::JointId joint = world->add_joint(def).value;
        ASSERT_EQ(world->set_joint_drive(joint, ingot::SpringDrive{number(random.real(0, 100)), number(random.real(0, 2))}, WheelJoint::travel),
                  Status::ok);
        ASSERT_EQ(world->set_joint_target(joint, 0, number(random.real(-0.3, 0.3)), WheelJoint::steering), Status::ok);
        for (int step_i = 0; step_i < 4; ++step_i) (void)ingot::step(*world, number(1 / rate));  // until all turns as it is told
        const Momenta before = momenta_of(*world, bodies, masses);
        const int steps = std::min(400, static_cast<int>(4 * rate));
        for (int step_i = 0; step_i < steps; ++step_i) {
            (void)ingot::step(*world, number(1 / rate));
            ASSERT_LE(world->joint_gap(joint).value, figures::held) << "case " << case_i << ", " << rate << " Hz, step " << step_i;
        }
        const Momenta after = momenta_of(*world, bodies, masses);
        const double roundings = 64 * figures::eps * steps;
        EXPECT_LE((after.p - before.p).norm(), roundings * before.size_of_p) << "case " << case_i;
        EXPECT_LE((after.L - before.L).norm(), (roundings + 1e-3) * before.size_of_L) << "case " << case_i << ", " << rate << " Hz";
        const auto A = world->state(bodies[0]).value, B = world->state(bodies[1]).value;
        const Eigen::Vector3d e = to_eigen(A.A) * along, a = to_eigen(B.A) * axle, straight = to_eigen(A.A) * axle;
        EXPECT_NEAR(e.dot(a), 0, figures::held) << "case " << case_i;
        const double steered = std::atan2(e.dot(straight.cross(a)), straight.dot(a));
        EXPECT_NEAR(world->joint_angle(joint, WheelJoint::steering).value, steered, 64 * figures::eps) << "case " << case_i;
        EXPECT_LE(std::abs(world->joint_travel(joint).value), 0.2 + figures::held) << "case " << case_i;
    }
}

/// A wheel that is driven at a rate spins at it, over many turns, and its angle goes on.
TEST(Wheels, spin_over_whole_turns) {
    for (const double rate : rates)
        for (const bool wheel_is_root : {false, true}) {
            const auto world = std::make_unique<Flight>();
            const double heavy = 1000;
            ingot::BodyDef chassis = body_of(ingot::solid_box(1, {1, 1, 1}), wheel_is_root ? 1 : heavy, {}, {}, 0);
            ingot::BodyDef wheel = body_of(ingot::solid_box(1, {1, 1, 1}), wheel_is_root ? heavy : 1, {}, {}, 0);
            ingot::JointDef def;
            def.body_A = world->add(chassis).value;
            def.body_B = world->add(wheel).value;
            def.joint = WheelJoint{};
            def.axis_B = {0, 1, 0};
            const ingot::JointId joint = world->add_joint(def).value;
            ASSERT_EQ(world->set_joint_drive(joint, ingot::SpringDrive{100, 10}, WheelJoint::travel), Status::ok);
            ASSERT_EQ(world->set_joint_drive(joint, ingot::MotorDrive{-7}, WheelJoint::spin), Status::ok);
            for (int step_i = 0; step_i < 10 * rate; ++step_i) (void)ingot::step(*world, number(1 / rate));
            EXPECT_NEAR(world->joint_rate(joint).value, -7, 1e-3) << rate << " Hz";
            EXPECT_NEAR(world->joint_angle(joint).value, -70, 7 / rate + 0.01) << rate << " Hz, the first step apart";
            EXPECT_NEAR(world->joint_angle(joint, WheelJoint::steering).value, 0, 1e-5) << rate << " Hz";
        }
}

/// A mass on a slider, carried by a wheel that cannot move: it swings by the hertz and the damping ratio that its spring was tuned to.
TEST(Wheels, springs_swing_as_they_were_tuned) {
    RandomInput random(3);
    for (int case_i = 0; case_i < ingot_reference::draws(40); ++case_i) {
        const double rate = rates[random.integer(0, 4)], hertz = random.real(0.5, 3), ratio = random.real(0.05, 0.9);
        const bool on_road = case_i % 2 == 0;  // the wheel stands on a road; or it is immovable, and the mass hangs on it
        const auto world = std::make_unique<Road>();
        const double M = random.real(10, 1000), radius = 0.3;
        ingot::BodyDef wheel = body_of(ingot::solid_cylinder(1, number(radius), number(0.1)), M / 10, ingot::Cylinder{number(radius), number(0.1)},
                                       {0, 0, number(radius)}, 0.8);
        wheel.state.A = axle_along_y();
        wheel.immovable = !on_road;
        ingot::BodyDef mass = body_of(ingot::solid_box(1, {1, 1, 1}), M, {}, {0, 0, 1}, 0);
        ingot::JointDef def;
        def.body_A = world->add(mass).value;
        if (on_road) {
            ingot::BodyDef ground;
            ground.immovable = true;
            ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
            ASSERT_TRUE(world->add(ground).ok() && figures::weigh(*world));
            ingot::JointDef rail;
            rail.body_B = def.body_A;
            rail.joint = ingot::SliderJoint{};
            ASSERT_TRUE(world->add_joint(rail).ok());
        }
        def.body_B = world->add(wheel).value;
        def.joint = WheelJoint{};
        def.P = {0, 0, number(radius)};
        def.axis_B = {0, 1, 0};
        const ingot::JointId joint = world->add_joint(def).value;
        const ingot::JointDrive spin = on_road ? ingot::JointDrive{} : ingot::SpringDrive{ingot::limits::drive_gain_max};
        ASSERT_EQ(world->set_joint_drive(joint, spin), Status::ok);
        const double omega = 2 * pi * hertz;
        // It begins apart from where it rests, by so much that the wheel keeps its load.
        const double sag = on_road ? g / (omega * omega) : 0, apart = on_road ? sag / 4 : 0.1;
        ASSERT_EQ(world->set_joint_drive(joint, ingot::TunedDrive{number(hertz), number(ratio), number(-sag - apart)}, WheelJoint::travel),
                  Status::ok);
        // x of three steps that follow each other: x'' = s x' - p x + c, where s and p are the sum and the product of the poles.
        std::vector<double> x;
        for (int step_i = 0; step_i < 2 * rate / hertz; ++step_i) {
            (void)ingot::step(*world, number(1 / rate));
            x.push_back(-static_cast<double>(world->joint_travel(joint).value));
        }
        // Over a tenth of a turn: between neighbours float has too few digits.
        const auto apart_by = static_cast<std::size_t>(std::max(1.0, std::round(0.1 * rate / hertz)));
        const auto rows = static_cast<Eigen::Index>(x.size() - 2 * apart_by);
        Eigen::MatrixXd A(rows, 3);
        Eigen::VectorXd b(rows);
        for (Eigen::Index i = 0; i < rows; ++i) {
            const auto at = static_cast<std::size_t>(i);
            A.row(i) << x[at + apart_by], -x[at], 1;
            b(i) = x[at + 2 * apart_by];
        }
        const Eigen::Vector3d fit = A.colPivHouseholderQr().solve(b);
        const double span = static_cast<double>(apart_by) / rate, decay = -std::log(fit(1)) / (2 * span);
        const double turn = std::acos(fit(0) / (2 * std::sqrt(fit(1)))) / span;
        const double found = std::hypot(decay, turn);
        EXPECT_NEAR(found, omega, 0.01 * omega) << "case " << case_i << ", " << rate << " Hz, ratio " << ratio << ", " << hertz << " Hz";
        EXPECT_NEAR(decay / found, ratio, 0.01 * ratio + 1e-3) << "case " << case_i << ", " << rate << " Hz, " << hertz << " Hz";
    }
}

struct TellsLoads : InFlight {
    using joints = ingot::Joints<WheelJoint, ingot::WithDrives, ingot::WithReactions>;
};

/// Hung up aside from its centre, by what is carried or by the wheel, it bears the weight across its suspension; the weight along that, and the
/// moments about its axle and its suspension, are its drives'.
TEST(Wheels, tell_what_they_bear) {
    RandomInput random(4);
    for (int case_i = 0; case_i < ingot_reference::draws(40); ++case_i) {
        const bool wheel_hangs = case_i % 2 == 0;
        const auto world = std::make_unique<ingot::World<TellsLoads>>();
        const double M = random.real(1, 100), rate = rates[random.integer(0, 4)];
        const Eigen::Vector3d weight = M * g * random.direction(), arm = random.vector(0.2);
        const Eigen::Vector3d along = random.direction(), axle = along.unitOrthogonal();
        ASSERT_EQ(world->set_gravity(to_vector((weight / M).eval())), Status::ok);
        ingot::BodyDef hangs = body_of(ingot::solid_box(1, {1, 1, 1}), M, {}, to_vector(arm), 0), holds = hangs;
        holds.immovable = true;
        ingot::JointDef def;
        def.body_A = world->add(wheel_hangs ? holds : hangs).value;
        def.body_B = world->add(wheel_hangs ? hangs : holds).value;
        def.joint = WheelJoint{};
        def.axis = to_vector(along);
        def.axis_B = to_vector(axle);
        const ingot::JointId joint = world->add_joint(def).value;
        for (const int which : {WheelJoint::spin, WheelJoint::travel, WheelJoint::steering})
            ASSERT_EQ(world->set_joint_drive(joint, ingot::SpringDrive{number(1e5 * M), number(2e3 * M)}, which), Status::ok);
        for (int step_i = 0; step_i < 2 * rate; ++step_i) (void)ingot::step(*world, number(1 / rate));
        // On B; what hangs gives its weight and its moment to the other.
        const double sign = wheel_hangs ? -1 : 1;
        const Eigen::Vector3d r = to_eigen(world->state(wheel_hangs ? def.body_B : def.body_A).value.r_CM), moment = r.cross(weight);
        const Eigen::Vector3d third = along.cross(axle);
        const ingot::JointReaction reaction = world->joint_reaction(joint).value;
        const double off = M * (1e-3 * g + 16 * figures::eps * rate * rate);  // a grain of place, taken back in a substep, is a force
        EXPECT_LE((to_eigen(reaction.force) - sign * (weight - along * along.dot(weight))).norm(), off) << "case " << case_i << ", " << rate << " Hz";
        EXPECT_LE((to_eigen(reaction.torque) - sign * third * third.dot(moment)).norm(), off) << "case " << case_i << ", " << rate << " Hz";
        EXPECT_NEAR(world->drive_torque(joint, WheelJoint::travel).value, sign * along.dot(weight), off) << "case " << case_i;
        EXPECT_NEAR(world->drive_torque(joint, WheelJoint::spin).value, sign * axle.dot(moment), off) << "case " << case_i;
        EXPECT_NEAR(world->drive_torque(joint, WheelJoint::steering).value, sign * along.dot(moment), off) << "case " << case_i;
    }
}

/// What is refused changes no bit.
TEST(Wheels, are_refused_where_they_do_not_fit) {
    const auto world = std::make_unique<Flight>();
    ingot::BodyDef body = body_of(ingot::solid_box(1, {1, 1, 1}), 1, {}, {}, 0);
    ingot::JointDef good;
    good.body_A = world->add(body).value;
    body.state.r_CM = {2, 0, 0};
    good.body_B = world->add(body).value;
    good.joint = WheelJoint{-1, 1};
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    const auto unchanged = [&](const auto& call, Status status) {
        std::vector<unsigned char> before(sizeof *world);
        std::memcpy(before.data(), world.get(), sizeof *world);
        EXPECT_EQ(call(), status);
        EXPECT_EQ(std::memcmp(before.data(), world.get(), sizeof *world), 0) << ingot::name(status);
    };
    const auto refused = [&](Status status, const auto& change) {
        ingot::JointDef def = good;
        change(def);
        unchanged([&] { return world->add_joint(def).status; }, status);
    };
    refused(Status::bad_direction, [](ingot::JointDef& def) { def.axis = {0, 0, 0}; });
    refused(Status::bad_direction, [](ingot::JointDef& def) { def.axis_B = {0, 2, 0}; });
    refused(Status::not_finite, [&](ingot::JointDef& def) { def.axis_B = {nan, 0, 0}; });
    refused(Status::bad_joint, [](ingot::JointDef& def) { def.axis_B = def.axis; });
    refused(Status::not_finite, [&](ingot::JointDef& def) { def.P.x = nan; });
    refused(Status::bad_joint, [](ingot::JointDef& def) { def.joint = WheelJoint{1, -1}; });
    refused(Status::out_of_range, [](ingot::JointDef& def) { def.joint = WheelJoint{-2 * ingot::limits::position_max, 0}; });
    refused(Status::bad_restitution, [](ingot::JointDef& def) { def.joint = WheelJoint{-1, 1, 2}; });
    refused(Status::bad_joint, [](ingot::JointDef& def) { def.body_B = def.body_A; });
    const ingot::JointId wheel = world->add_joint(good).value;
    for (const int which : {-1, 3}) {
        unchanged([&] { return world->set_joint_drive(wheel, ingot::MotorDrive{1}, which); }, Status::not_in_scene);
        unchanged([&] { return world->set_joint_target(wheel, 1, 0, which); }, Status::not_in_scene);
        EXPECT_EQ(world->joint_angle(wheel, which).status, Status::not_in_scene);
        EXPECT_EQ(world->joint_rate(wheel, which).status, Status::not_in_scene);
    }
    unchanged([&] { return world->set_joint_target(wheel, nan, 0, WheelJoint::steering); }, Status::not_finite);
    unchanged([&] { return world->set_joint_drive(wheel, ingot::MotorDrive{0, -1}, WheelJoint::spin); }, Status::out_of_range);
    EXPECT_EQ(world->joint_angle(wheel, WheelJoint::travel).status, Status::not_in_scene);
    EXPECT_EQ(world->joint_travel(wheel).value, 0);
    EXPECT_EQ(world->joint_angle(wheel, WheelJoint::steering).value, 0);
    EXPECT_EQ(world->remove(wheel), Status::ok);
    unchanged([&] { return world->set_joint_target(wheel, 0, 0, WheelJoint::steering); }, Status::stale_id);
}

// Cars

/// Thousands of steps of a second are nightly's.
std::vector<double> rates_of_cars() {
    std::vector<double> some = {30, 60, 120, 240};
    if (!INGOT_TEST_BRIEF) some.push_back(1000);
    return some;
}

/// One that turns and is saved goes on to the same bits.
TEST(Cars, go_on_from_a_snapshot) {
    Ride ride(60, {}, 5);
    ASSERT_TRUE(drive_wheels(*ride.world, ride.car, ingot::MotorDrive{20, 300}, 2) && steer_car(*ride.world, ride.car, 10));
    ride.go(2);
    std::vector<uint8_t> bytes(ingot::snapshot_size<OnRoad>());
    const auto size = ingot::save_snapshot(*ride.world, bytes.data(), bytes.size());
    ASSERT_TRUE(size.ok());
    const auto other = std::make_unique<Road>();
    ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), size.value), Status::ok);
    for (int step_i = 0; step_i < 60; ++step_i) {
        (void)ingot::step(*ride.world, number(1.0 / 60));
        (void)ingot::step(*other, number(1.0 / 60));
        ASSERT_EQ(ride.world->state_hash(), other->state_hash()) << step_i;
    }
    EXPECT_EQ(ride.world->joint_angle(ride.car.joints[0]).value, other->joint_angle(ride.car.joints[0]).value);
}

/// A car of a ton sinks by m g / k, stays where it is, and falls asleep.
TEST(Cars, rest_on_their_springs) {
    for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
        Ride ride(rate, {});
        const double sag = ride.car.size.M * g / 4 / 25000;
        for (int step_i = 0; step_i < 6 * rate && !ride.world->is_asleep(ride.car.chassis); ++step_i) ride.step();
        EXPECT_TRUE(ride.world->is_asleep(ride.car.chassis)) << rate << " Hz";
        const Eigen::Vector3d r = to_eigen(ride.chassis().r_CM);
        EXPECT_NEAR(r.z(), 0.65 - sag, 1e-5) << rate << " Hz";
        EXPECT_NEAR(std::hypot(r.x(), r.y()), 0, 1e-4) << rate << " Hz";
        EXPECT_LE(ride.gap, figures::held) << rate << " Hz";
    }
}

/// Ten seconds straight on: within a millimetre of its line.
TEST(Cars, go_straight) {
    for (const double rate : rates_of_cars())
        for (const double speed : {2.0, 20.0}) {
            Ride ride(rate, {}, speed);
            ASSERT_TRUE(drive_wheels(*ride.world, ride.car, ingot::MotorDrive{number(speed / ride.car.size.radius), 500}, 2));
            double aside = 0;
            for (int step_i = 0; step_i < 10 * rate; ++step_i) {
                ride.step();
                aside = std::max(aside, std::abs(static_cast<double>(ride.chassis().r_CM.y)));
            }
            EXPECT_LE(aside, 1e-3) << rate << " Hz, " << speed << " m/s";
            EXPECT_NEAR(ride.chassis().r_CM.x, 10 * speed, 1e-3 * 10 * speed) << rate << " Hz, " << speed << " m/s";
            EXPECT_LE(ride.gap, figures::held) << rate << " Hz";
        }
}

/// With its front wheels turned, and slowly, it goes on the circle on which all wheels roll.
TEST(Cars, turn_as_their_wheels_are_steered) {
    for (const double rate : rates_of_cars())
        for (const double radius : {6.0, 15.0}) {
            Ride ride(rate, {}, 1);
            ride.go(1);
            for (int step_i = 1; step_i <= rate; ++step_i) {
                ASSERT_TRUE(steer_car(*ride.world, ride.car, radius * rate / step_i));
                ride.step();
            }
            ride.go(1);
            double way = 0, turn = 0;
            for (int step_i = 0; step_i < 3 * rate; ++step_i) {
                const Eigen::Vector3d r = ride.rear(), a = to_eigen(ride.chassis().A).col(0);
                ride.step();
                const Eigen::Vector3d b = to_eigen(ride.chassis().A).col(0);
                way += (ride.rear() - r).norm();
                turn += std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
            }
            EXPECT_NEAR(way / turn, radius, 0.01 * radius) << rate << " Hz";
            EXPECT_LE(ride.gap, figures::held) << rate << " Hz";
        }
}

/// With its wheels locked it slides v^2 / (2 mu g), but for what it goes in half a substep: a steady island has two of a step. Then it stands, but
/// for the grain of its place over a substep.
TEST(Cars, brake_in_the_way_that_friction_allows) {
    for (const double rate : rates_of_cars())
        for (const double speed : {10.0, 20.0}) {
            Ride ride(rate, {}, speed);
            ride.go(2);
            const double x = ride.chassis().r_CM.x, v = ride.speed(), way = v * v / (2 * ride.car.size.friction * g);
            ASSERT_TRUE(drive_wheels(*ride.world, ride.car, ingot::MotorDrive{0, 20000}));
            ride.go(5);
            EXPECT_NEAR(ride.chassis().r_CM.x - x, way, 0.005 * way + v / rate / 4) << rate << " Hz, " << speed << " m/s";
            EXPECT_LE(ride.speed(), 1e-3 + 4 * rate * figures::eps * ride.chassis().r_CM.x) << rate << " Hz, " << speed << " m/s";
            EXPECT_LE(ride.gap, figures::held) << rate << " Hz";
        }
}

/// Over bumps of 40 mm, some on one side alone, it stays on its wheels; braked after that it comes to rest.
TEST(Cars, stay_on_their_wheels_over_bumps) {
    for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
        Ride ride(rate, {}, 3);
        for (int i = 0; i < 12; ++i) {
            ingot::BodyDef bump;
            bump.immovable = true;
            bump.shape = ingot::Box{{number(0.15), number(i % 3 == 0 ? 0.6 : 3), number(0.04)}};
            bump.state.r_CM = {number(6 + 2 * i), number(i % 3 == 0 ? 0.8 : 0), 0};
            bump.friction = number(0.8);
            ASSERT_TRUE(ride.world->add(bump).ok());
        }
        ASSERT_TRUE(drive_wheels(*ride.world, ride.car, ingot::MotorDrive{10, 800}));
        ride.go(15);
        EXPECT_GE(ride.chassis().r_CM.x, 40) << rate << " Hz";
        ASSERT_TRUE(drive_wheels(*ride.world, ride.car, ingot::MotorDrive{0, 3000}));
        for (int step_i = 0; step_i < 6 * rate && !ride.world->is_asleep(ride.car.chassis); ++step_i) ride.step();
        // 45 m from the origin the grain of its place over a substep, which friction holds no better, may keep it awake.
        const double grain = 4 * rate * figures::eps * ride.chassis().r_CM.x;
        EXPECT_TRUE(ride.world->is_asleep(ride.car.chassis) || (rate > 120 && ride.speed() <= grain)) << rate << " Hz";
        EXPECT_GE(ride.least_up, 0.99) << rate << " Hz";
        EXPECT_LE(ride.gap, figures::held) << rate << " Hz";
    }
}

/// J; of springs too.
double energy_of(const Ride& ride) {
    const auto of_body = [&](ingot::BodyId id, double M) {
        const ingot::BodyState state = ride.world->state(id).value;
        const Eigen::Vector3d v = to_eigen(state.v_CM);
        return M * v.squaredNorm() / 2 + M * g * static_cast<double>(state.r_CM.z) + to_eigen(state.L).dot(to_eigen(ride.world->omega(id).value)) / 2;
    };
    double E = of_body(ride.car.chassis, ride.car.size.M);
    for (std::size_t i = 0; i < 4; ++i) {
        const double travel = ride.world->joint_travel(ride.car.joints[i]).value;
        E += of_body(ride.car.wheels[i], ride.car.size.wheel_M) + static_cast<double>(ride.car.size.spring.stiffness) * travel * travel / 2;
    }
    return E;
}

/// Cars of all sizes, with wheels a hundredth to a fourth of them, that fall on a road and roll: gaps are held, and no step gives them energy but for
/// a hundredth of what they have when they fall a metre, as of other figures (JointEnergy).
TEST(Cars, of_all_sizes_hold_together_and_get_no_energy) {
    RandomInput random(5);
    for (int case_i = 0; case_i < ingot_reference::draws(60); ++case_i) {
        const double rate = rates[random.integer(0, 4)];
        CarSize size;
        size.M = std::pow(10.0, random.real(0, 3.5));
        size.wheel_M = size.M * std::pow(10.0, random.real(-2, -0.6));
        size.radius = random.real(0.2, 0.5);
        size.half_width = random.real(0.02, 0.15);
        size.base = random.real(2, 3);
        size.track = random.real(1.2, 2);
        size.height = random.real(0.3, 0.6);
        size.travel = random.real(0.05, 0.2);
        size.friction = random.real(0, 1);
        const double omega = 2 * pi * random.real(1, 5), ratio = random.real(0, 1);
        size.spring = ingot::SpringDrive{number(size.M / 4 * omega * omega), number(size.M / 4 * 2 * ratio * omega)};
        Ride ride(rate, size, random.real(-10, 10), random.real(0, 1));
        for (std::size_t i = 0; i < 4; ++i)
            ASSERT_EQ(ride.world->set_joint_target(ride.car.joints[i], number(random.real(-0.5, 0.5)), 0, WheelJoint::steering), Status::ok);
        ride.step();
        const int steps = std::min(300, static_cast<int>(3 * rate));
        double last = energy_of(ride), before = last;
        for (int step_i = 0; step_i < steps; ++step_i) {
            ride.step();
            const double now = energy_of(ride);
            ASSERT_LE(now, std::max(last, before) + 0.01 * (size.mass() * g + std::abs(last)))
                << "case " << case_i << ", " << rate << " Hz, step " << step_i;
            before = last;
            last = now;
        }
        EXPECT_LE(ride.gap, figures::held) << "case " << case_i << ", " << rate << " Hz";
    }
}

}  // namespace
