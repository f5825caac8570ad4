// SPDX-License-Identifier: MIT
// Gears in company of contacts, asleep, saved, taken away as they go; what drives and ends of one joint are to the other; and what calls refuse.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "figures.h"
#include "reference/draws.h"
#include "reference/powers_of_two.h"

namespace {

using namespace figures;
using ingot::Status;

template <int k>
struct ShopAt : ingot::Scene {
    static constexpr int max_bodies = 40, max_joints = 40, max_loops = 12, max_manifolds = 80, max_pairs = 300;
    static constexpr bool translates = true, sleeps = true, kinematic_bodies = true;
    static constexpr scalar length_unit = ingot_reference::power_of_two(k);
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::RopeJoint, ingot::GearJoint, ingot::WithLimits,
                                 ingot::WithDrives>;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
using Shop = ShopAt<0>;
using ShopWorld = ingot::World<Shop>;
constexpr scalar frame = scalar(1) / 60;

template <class World>
ingot::BodyId add_wheel(World& world, double M, double half, const Vector& place) {
    ingot::BodyDef def;
    const Vector size = Vector{1, 1, scalar(0.5)} * static_cast<scalar>(half);
    def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, size), static_cast<scalar>(M))).value;
    def.shape = ingot::Box{size};
    def.state.r_CM = place;
    def.friction = scalar(0.5);
    return world.add(def).value;
}
template <class World>
ingot::Result<ingot::JointId> join(World& world, const ingot::Joint& kind, ingot::BodyId A, ingot::BodyId B, const Vector& P, const Vector& axis) {
    ingot::JointDef def;
    def.body_A = A;
    def.body_B = B;
    def.joint = kind;
    def.P = P;
    def.axis = axis;
    return world.add_joint(def);
}
template <class World>
std::vector<uint8_t> saved(const World& world) {
    std::vector<uint8_t> bytes(ingot::snapshot_size<typename World::scene>());
    bytes.resize(ingot::save_snapshot(world, bytes.data(), bytes.size()).value);
    return bytes;
}

/// A winch: a pinion on the world, its rack, and a box that the rack meets. Lengths by `unit`.
template <class World>
struct Winch {
    ingot::BodyId pinion, rack, box;
    ingot::JointId hinge, slider, gear;

    Winch(World& world, double x, double unit, double spin) {
        const auto at = [&](double dx, double z) { return Vector{static_cast<scalar>(unit * (x + dx)), 0, static_cast<scalar>(unit * z)}; };
        pinion = add_wheel(world, 2, 0.3 * unit, at(0, 2));
        rack = add_wheel(world, 1, 0.2 * unit, at(0.5, 1));
        box = add_wheel(world, 3, 0.15 * unit, at(0.5, 0.2));
        hinge = join(world, ingot::HingeJoint{}, {}, pinion, at(0, 2), {0, 1, 0}).value;
        slider = join(world, ingot::SliderJoint{}, {}, rack, at(0.5, 1), {0, 0, 1}).value;
        const auto added = world.add_gear(hinge, slider, static_cast<scalar>(0.3 * unit));
        EXPECT_TRUE(added.ok());
        gear = added.value;
        EXPECT_EQ(world.apply_angular_impulse(pinion, {0, static_cast<scalar>(spin * unit * unit), 0}), Status::ok);
    }
    std::vector<ingot::BodyId> bodies() const { return {pinion, rack, box}; }
};
template <class World>
void furnish(World& world, double unit) {
    ASSERT_TRUE(add_ground(world));
    ASSERT_EQ(world.set_gravity({0, 0, static_cast<scalar>(-g * unit)}), Status::ok);
}

/// A rack comes down on a box, presses on it, rests, sleeps with its pinion, and wakes with it.
TEST(GearCalls, sleep_and_wake_as_one) {
    const auto world = std::make_unique<ShopWorld>();
    furnish(*world, 1);
    const Winch<ShopWorld> winch(*world, 0, 1, 0.1);
    int step_i = 0;
    for (; step_i < 1200 && !world->is_asleep(winch.pinion); ++step_i) {
        EXPECT_EQ(ingot::step(*world, frame).joints_lost, 0);
        EXPECT_LE(world->joint_gap(winch.gear).value, scalar(1e-5)) << step_i;
    }
    ASSERT_LT(step_i, 1200);
    EXPECT_TRUE(world->is_asleep(winch.rack));
    EXPECT_NEAR(static_cast<double>(world->state(winch.rack).value.r_CM.z), 0.25, 1e-3);
    ASSERT_EQ(world->apply_angular_impulse(winch.pinion, {0, 2, 0}), Status::ok);
    EXPECT_FALSE(world->is_asleep(winch.rack));
    (void)ingot::step(*world, frame);
    EXPECT_GT(world->joint_speed(winch.slider).value, scalar(0.1));
}

/// Beside others of its kind, and by itself, it goes the same way, to the bit; also as a snapshot of it.
TEST(GearCalls, move_as_if_alone_and_from_a_snapshot) {
    RandomInput random(5);
    for (int case_i = 0; case_i < ingot_reference::draws(20); ++case_i) {
        const double spin[2] = {random.real(-2, 2), random.real(-2, 2)};
        const auto together = std::make_unique<ShopWorld>(), alone = std::make_unique<ShopWorld>(), other = std::make_unique<ShopWorld>();
        furnish(*together, 1);
        furnish(*alone, 1);
        const Winch<ShopWorld> first(*together, 8, 1, spin[0]), second(*together, 0, 1, spin[1]), by_itself(*alone, 0, 1, spin[1]);
        for (int step_i = 0; step_i < 120; ++step_i) {
            (void)ingot::step(*together, frame);
            (void)ingot::step(*alone, frame);
            ASSERT_TRUE(are_same(*together, *alone, second.bodies(), by_itself.bodies())) << case_i << ", " << step_i;
            if (step_i == 30) {
                const auto bytes = saved(*together);
                ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), bytes.size()), Status::ok);
            } else if (step_i > 30) {
                (void)ingot::step(*other, frame);
            }
        }
        EXPECT_EQ(together->state_hash(), other->state_hash());
        EXPECT_EQ(together->joint_gap(first.gear).value, other->joint_gap(first.gear).value);
    }
}

/// 512 times as large, to the bit.
TEST(GearCalls, scale_is_no_matter) {
    RandomInput random(6);
    for (int case_i = 0; case_i < ingot_reference::draws(20); ++case_i) {
        const auto plain = std::make_unique<ShopWorld>();
        const auto large = std::make_unique<ingot::World<ShopAt<9>>>();
        furnish(*plain, 1);
        furnish(*large, 512);
        const double spin = random.real(-2, 2);
        const Winch<ShopWorld> a(*plain, 0, 1, spin);
        const Winch<ingot::World<ShopAt<9>>> b(*large, 0, 512, spin);
        for (int step_i = 0; step_i < 120; ++step_i) {
            (void)ingot::step(*plain, frame);
            (void)ingot::step(*large, frame);
            for (size_t i = 0; i < 3; ++i) {
                const ingot::BodyState x = plain->state(a.bodies()[i]).value, y = large->state(b.bodies()[i]).value;
                ASSERT_TRUE(ingot_reference::equal(x.r_CM * 512, y.r_CM) && ingot_reference::equal(x.v_CM * 512, y.v_CM)) << case_i << ", " << step_i;
                ASSERT_TRUE(ingot_reference::equal(x.A.c0, y.A.c0) && ingot_reference::equal(x.A.c1, y.A.c1)) << case_i << ", " << step_i;
            }
        }
    }
}

/// What ends one joint ends the other, and a motor that is at its torque there stands still; a spring of one turns the other to where the ratio wants
/// it.
TEST(GearCalls, limits_and_drives_are_of_both) {
    for (const double r : {0.2, -1.0, 5.0}) {
        const auto world = std::make_unique<ShopWorld>();
        const ingot::BodyId A = add_wheel(*world, 2, 0.3, {0, 0, 3}), B = add_wheel(*world, 3, 0.2, {2, 0, 3});
        const ingot::JointId at_A = join(*world, ingot::HingeJoint{}, {}, A, {0, 0, 3}, {0, 0, 1}).value;
        const ingot::JointId at_B = join(*world, ingot::HingeJoint{-1, 1}, {}, B, {2, 0, 3}, {0, 0, 1}).value;
        const ingot::JointId gear = world->add_gear(at_A, at_B, static_cast<scalar>(r)).value;
        ASSERT_EQ(world->set_joint_drive(at_A, ingot::MotorDrive{3, 20}), Status::ok);
        for (int step_i = 0; step_i < 600; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, frame).clean());
            EXPECT_LE(std::abs(static_cast<double>(world->joint_angle(at_B).value)), 1 + 1e-5) << r << ", " << step_i;
            EXPECT_LE(static_cast<double>(world->joint_gap(gear).value), 2e-5 * (1 + std::abs(r))) << r << ", " << step_i;
        }
        EXPECT_NEAR(static_cast<double>(world->joint_angle(at_B).value), r > 0 ? 1 : -1, 1e-5) << r;
        EXPECT_NEAR(static_cast<double>(world->joint_angle(at_A).value), 1 / std::abs(r), 1e-5 * (1 + 1 / std::abs(r))) << r;
        EXPECT_LE(std::abs(static_cast<double>(world->joint_rate(at_A).value)), 1e-4) << r;
        ASSERT_EQ(world->set_joint_drive(at_A, ingot::SpringDrive{1000, 100, static_cast<scalar>(0.4 / r)}), Status::ok);
        for (int step_i = 0; step_i < 240; ++step_i) ASSERT_TRUE(ingot::step(*world, frame).clean());
        EXPECT_NEAR(static_cast<double>(world->joint_angle(at_B).value), 0.4, 1e-4) << r;
    }
}

/// A planet on a kinematic carrier that turns, and a sun: from rest they share what the carrier asks for by their moments.
TEST(GearCalls, a_kinematic_carrier_drives) {
    for (const double W : {0.1, 3.0}) {
        const auto world = std::make_unique<ShopWorld>();
        const ingot::BodyId carrier = add_wheel(*world, 1, 0.1, {0, 0, 2});
        ASSERT_EQ(world->set_kinematic(carrier), Status::ok);
        const ingot::BodyId sun = add_wheel(*world, 3, 0.2, {0, 0, 3}), planet = add_wheel(*world, 2, 0.3, {2, 0, 3});
        const ingot::JointId at_sun = join(*world, ingot::HingeJoint{}, {}, sun, {0, 0, 3}, {0, 0, 1}).value;
        const ingot::JointId at_planet = join(*world, ingot::HingeJoint{}, carrier, planet, {2, 0, 3}, {0, 0, 1}).value;
        const ingot::JointId gear = world->add_gear(at_sun, at_planet, -2).value;
        ASSERT_EQ(world->set_velocity(carrier, {}, {0, 0, static_cast<scalar>(W)}), Status::ok);
        // The planet turns by omega - W against its carrier, and that and twice the turn of the sun are none: j and 2 j are what they get.
        const double I_sun = 3 * 0.2 * 0.2 * 2 / 3, I_planet = 2 * 0.3 * 0.3 * 2 / 3, j = W / (1 / I_planet + 4 / I_sun);
        for (int step_i = 0; step_i < 120; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, frame).clean());
            EXPECT_NEAR(static_cast<double>(world->joint_rate(at_sun).value), 2 * j / I_sun, 1e-4 * W + 256 * eps) << step_i;
            EXPECT_NEAR(static_cast<double>(world->joint_rate(at_planet).value), -4 * j / I_sun, 2e-4 * W + 256 * eps) << step_i;
            EXPECT_LE(static_cast<double>(world->joint_gap(gear).value), 1e-4) << step_i;
        }
    }
}

/// A gear goes with either of its joints, and with their bodies; what is left turns on.
TEST(GearCalls, go_with_their_joints) {
    for (const int what : {0, 1, 2, 3, 4}) {
        const auto world = std::make_unique<ShopWorld>();
        const ingot::BodyId A = add_wheel(*world, 2, 0.3, {0, 0, 3}), B = add_wheel(*world, 3, 0.2, {2, 0, 3});
        const ingot::JointId at_A = join(*world, ingot::HingeJoint{}, {}, A, {0, 0, 3}, {0, 0, 1}).value;
        const ingot::JointId at_B = join(*world, ingot::HingeJoint{}, {}, B, {2, 0, 3}, {0, 0, 1}).value;
        const ingot::JointId gear = world->add_gear(at_A, at_B, -2).value;
        ASSERT_EQ(world->apply_angular_impulse(A, {0, 0, 1}), Status::ok);
        for (int step_i = 0; step_i < 10; ++step_i) ASSERT_TRUE(ingot::step(*world, frame).clean());
        const scalar rate = world->joint_rate(at_B).value;
        const Status removed = what == 0 ? world->remove(gear) : what == 1 ? world->remove(at_A) : what == 2 ? world->remove(at_B)
                             : what == 3 ? world->remove(A) : world->remove(B);
        ASSERT_EQ(removed, Status::ok);
        EXPECT_FALSE(world->is_alive(gear)) << what;
        EXPECT_EQ(world->joint_gap(gear).status, Status::stale_id) << what;
        for (int step_i = 0; step_i < 10; ++step_i) ASSERT_TRUE(ingot::step(*world, frame).clean());
        if (what == 0) {
            EXPECT_NEAR(static_cast<double>(world->joint_rate(at_B).value), static_cast<double>(rate), 1e-5);
        }
        EXPECT_EQ(world->joint_count(), what == 0 ? 2 : 1) << what;
    }
}

/// Gears in a ring that contradict each other hold it fast; those that agree are one more than is needed.
TEST(GearCalls, rings_turn_or_stand) {
    for (const bool agree : {true, false}) {
        const auto world = std::make_unique<ShopWorld>();
        ingot::BodyId wheels[3];
        ingot::JointId hinges[3];
        for (int i = 0; i < 3; ++i) {
            const Vector place = {static_cast<scalar>(2 * i), 0, 3};
            wheels[i] = add_wheel(*world, 1 + i, 0.3, place);
            hinges[i] = join(*world, ingot::HingeJoint{}, {}, wheels[i], place, {0, 0, 1}).value;
        }
        const scalar last = agree ? scalar(-0.5) : scalar(0.5);
        ASSERT_TRUE(world->add_gear(hinges[0], hinges[1], -2).ok() && world->add_gear(hinges[1], hinges[2], -1).ok());
        ASSERT_TRUE(world->add_gear(hinges[2], hinges[0], agree ? scalar(0.5) : last * -1).ok());
        ASSERT_EQ(world->apply_angular_impulse(wheels[0], {0, 0, 1}), Status::ok);
        for (int step_i = 0; step_i < 240; ++step_i) ASSERT_TRUE(ingot::step(*world, frame).clean());
        const double rate = static_cast<double>(world->joint_rate(hinges[0]).value);
        if (agree) {
            EXPECT_GT(rate, 0.1);
        } else {
            EXPECT_NEAR(rate, 0, 1e-6);
        }
    }
}

/// What is wrong is refused, and nothing has changed.
TEST(GearCalls, bad_gears_are_refused) {
    const auto world = std::make_unique<ShopWorld>();
    const ingot::BodyId A = add_wheel(*world, 2, 0.3, {0, 0, 3}), B = add_wheel(*world, 3, 0.2, {2, 0, 3}), C = add_wheel(*world, 1, 0.1, {4, 0, 3});
    const ingot::JointId at_A = join(*world, ingot::HingeJoint{}, {}, A, {0, 0, 3}, {0, 0, 1}).value;
    const ingot::JointId at_B = join(*world, ingot::SliderJoint{}, {}, B, {2, 0, 3}, {0, 0, 1}).value;
    const ingot::JointId ball = join(*world, ingot::BallJoint{}, {}, C, {4, 0, 3}, {0, 0, 1}).value;
    const ingot::JointId gear = world->add_gear(at_A, at_B, 2).value;
    const auto refused = [&](Status status, ingot::JointId a, ingot::JointId b, scalar ratio) {
        const auto before = saved(*world);
        EXPECT_EQ(world->add_gear(a, b, ratio).status, status);
        EXPECT_EQ(saved(*world), before);
    };
    const scalar most = ingot::limits::gear_ratio_max;
    refused(Status::not_finite, at_A, at_B, std::numeric_limits<scalar>::quiet_NaN());
    refused(Status::not_finite, at_A, at_B, std::numeric_limits<scalar>::infinity());
    refused(Status::out_of_range, at_A, at_B, 0);
    refused(Status::out_of_range, at_A, at_B, 2 * most);
    refused(Status::out_of_range, at_A, at_B, scalar(-0.5) / most);
    refused(Status::bad_joint, at_A, at_A, 1);
    refused(Status::bad_joint, at_A, ball, 1);
    refused(Status::bad_joint, gear, at_A, 1);
    refused(Status::stale_id, {}, at_A, 1);
    ingot::JointId stale = at_B;
    stale.generation += 2;
    refused(Status::stale_id, at_A, stale, 1);
    ingot::JointId foreign = at_B;
    foreign.world_tag ^= 1;
    refused(Status::foreign_id, at_A, foreign, 1);
    ingot::JointDef def;
    def.body_B = A;
    def.joint.kind = ingot::JointKind::gear;
    EXPECT_EQ(world->add_joint(def).status, Status::bad_joint);
    // What a rope has no use for is looked at all the same: a snapshot of it would be refused.
    def.body_B = B;
    def.P_B = {2, 0, 3};
    def.joint = ingot::RopeJoint{4};
    def.joint.limits.range[1].lower = std::numeric_limits<scalar>::quiet_NaN();
    EXPECT_EQ(world->add_joint(def).status, Status::not_finite);
    EXPECT_EQ(world->gear_ratio(at_A).status, Status::not_in_scene);
    EXPECT_EQ(world->gear_ratio(gear).value, scalar(2));
    EXPECT_EQ(world->set_joint_length(gear, 1), Status::not_in_scene);
    EXPECT_EQ(world->set_joint_limits(gear, {}), Status::not_in_scene);
    EXPECT_EQ(world->set_joint_drive(gear, ingot::MotorDrive{1, 1}), Status::not_in_scene);
    EXPECT_EQ(world->joint_angle(gear).status, Status::not_in_scene);
    // As many as may be, and no more.
    for (int i = 1; i < Shop::max_loops; ++i) EXPECT_TRUE(world->add_gear(at_A, at_B, 2).ok());
    refused(Status::no_room, at_A, at_B, 2);
    EXPECT_TRUE(ingot::step(*world, frame).clean());
}

/// Ratios to either end, of wheels of a gramme and of a tonne, struck hard: nothing gains, and all stays finite.
TEST(GearCalls, extremes_are_borne) {
    for (const double r : {1e6, -1e6, 1e-6, 1e3, -1e-3})
        for (const double M : {1e-3, 1.0, 1e3}) {
            const auto world = std::make_unique<ShopWorld>();
            const ingot::BodyId A = add_wheel(*world, 1, 0.3, {0, 0, 3}), B = add_wheel(*world, M, 0.2, {2, 0, 3});
            const ingot::JointId at_A = join(*world, ingot::HingeJoint{}, {}, A, {0, 0, 3}, {0, 0, 1}).value;
            const ingot::JointId at_B = join(*world, ingot::HingeJoint{}, {}, B, {2, 0, 3}, {0, 0, 1}).value;
            const ingot::JointId gear = world->add_gear(at_A, at_B, static_cast<scalar>(r)).value;
            ASSERT_EQ(world->apply_angular_impulse(A, {0, 0, 1}), Status::ok);
            ASSERT_EQ(world->apply_angular_impulse(B, {0, 0, static_cast<scalar>(M * 0.1)}), Status::ok);
            double last = static_cast<double>(world->kinetic_energy());
            for (int step_i = 0; step_i < 120; ++step_i) {
                ASSERT_TRUE(ingot::step(*world, frame).clean()) << r << ", " << M;
                const double now = static_cast<double>(world->kinetic_energy());
                EXPECT_LE(now, last * (1 + 64 * eps)) << r << ", " << M << ", " << step_i;
                last = now;
            }
            EXPECT_LE(static_cast<double>(world->joint_gap(gear).value), 64 * eps * (1 + std::abs(r))) << r << ", " << M;
        }
}

}  // namespace
