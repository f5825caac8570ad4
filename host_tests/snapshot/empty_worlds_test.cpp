// SPDX-License-Identifier: MIT
// What is loaded into a world has all of the one that was saved: where nothing of it was there before, in scenes whose bodies and joints have more
// than plain ones have. And what a scene does not name takes no byte.
#include <gtest/gtest.h>

#include <ingot/ingot.h>

#include <cstring>
#include <memory>
#include <vector>

#include "reference/draws.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace {

using Eigen::Vector3d;
using ingot::BodyDef;
using ingot::BodyId;
using ingot::scalar;
using ingot::Status;
using ingot_reference::RandomInput;
using ingot_reference::to_vector;

struct Flyers : ingot::Scene {
    static constexpr int max_bodies = 9;
    static constexpr bool translates = true;
};
struct PrintedFlyers : Flyers {
    using rotation = ingot::Listing1Euler;
};
struct ExactFlyers : Flyers {
    static constexpr bool compensated_sums = true;
};
/// A joint of it has one drive, the last of the last slot is the last there is.
struct Hinges : Flyers {
    static constexpr int max_joints = 6;
    using joints = ingot::Joints<ingot::HingeJoint, ingot::SliderJoint, ingot::WithDrives>;
};
/// And three.
struct Balls : Flyers {
    static constexpr int max_joints = 6;
    using joints = ingot::Joints<ingot::BallJoint, ingot::UniversalJoint, ingot::HingeJoint, ingot::WithDrives, ingot::WithLimits>;
};
struct HingesOnGround : Hinges {
    static constexpr int max_manifolds = 30, max_pairs = 60;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
};

template <class S>
std::vector<std::uint8_t> saved(const ingot::World<S>& world) {
    std::vector<std::uint8_t> bytes(ingot::snapshot_size<S>());
    const auto size = ingot::save_snapshot(world, bytes.data(), bytes.size());
    EXPECT_TRUE(size.ok());
    bytes.resize(size.value);
    return bytes;
}

template <class S>
BodyId add_body(ingot::World<S>& world, RandomInput& random, int i) {
    BodyDef def;
    const auto M = static_cast<scalar>(random.real(1, 5));
    def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, {scalar(0.3), scalar(0.2), scalar(0.1)}), M)).value;
    if constexpr (S::max_manifolds > 0) def.shape = ingot::Sphere{scalar(0.2)};
    def.state.r_CM = to_vector(Vector3d(2.0 * i, 0, 1) + random.vector(0.2));
    def.state.A = ingot_reference::to_matrix(random.rotation());
    def.state.v_CM = to_vector(random.vector(1));
    def.state.L = to_vector(random.vector(1));
    return world.add(def).value;
}

/// Every joint driven, each direction by a drive of its own; slots that are full.
template <class S>
void add_joints(ingot::World<S>& world, RandomInput& random, const std::vector<BodyId>& bodies) {
    for (int i = 0; i < S::max_joints; ++i) {
        ingot::JointDef def;
        def.body_B = bodies[static_cast<size_t>(i)];
        if (i % 2 == 1) def.body_A = bodies[static_cast<size_t>(i - 1)];
        if constexpr (S::joints::drives_of_joint() == 3) {
            if (i % 3 == 0) def.joint = ingot::BallJoint{};
            else if (i % 3 == 1) def.joint = ingot::UniversalJoint{};
            else def.joint = ingot::HingeJoint{};
        } else {
            def.joint = i % 3 == 2 ? ingot::Joint(ingot::SliderJoint{}) : ingot::Joint(ingot::HingeJoint{});
        }
        def.P = world.state(def.body_B).value.r_CM;
        const Vector3d axis = random.direction();
        def.axis = to_vector(axis);
        def.axis_B = to_vector(Vector3d(axis.cross(random.direction()).normalized()));
        const auto id = world.add_joint(def);
        ASSERT_TRUE(id.ok());
        const auto motor = [&random] { return ingot::MotorDrive{static_cast<scalar>(random.real(-5, 5)), static_cast<scalar>(random.real(1, 20))}; };
        if (S::joints::drives_of_joint() < 3 || i % 3 == 2) {
            ASSERT_EQ(world.set_joint_drive(id.value, motor()), Status::ok);
        } else if constexpr (S::joints::drives_of_joint() == 3) {
            if (i % 3 == 1)
                for (const int direction : {0, 1}) ASSERT_EQ(world.set_joint_drive(id.value, motor(), direction), Status::ok);
            else
                ASSERT_EQ(world.set_ball_drive(id.value, ingot::TunedDrive{2, 1, 50}), Status::ok);
        }
    }
}

template <class S>
class EmptyWorlds : public ::testing::Test {};
using Scenes = ::testing::Types<Flyers, PrintedFlyers, ExactFlyers, Hinges, HingesOnGround, Balls>;
TYPED_TEST_SUITE(EmptyWorlds, Scenes);

TYPED_TEST(EmptyWorlds, go_on_as_the_one_that_was_saved) {
    using S = TypeParam;
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        RandomInput random(static_cast<std::uint64_t>(run_i));
        const auto world = std::make_unique<ingot::World<S>>(), other = std::make_unique<ingot::World<S>>();
        const auto full = std::make_unique<ingot::World<S>>();
        std::vector<BodyId> bodies;
        for (int i = 0; i < 8; ++i) bodies.push_back(add_body(*world, random, i));
        for (int i = 0; i < 5; ++i) (void)add_body(*full, random, i);
        if constexpr (S::max_joints > 0) add_joints(*world, random, bodies);
        const double rates[] = {30, 60, 240, 1000};
        const auto h = static_cast<scalar>(1 / rates[run_i % 4]);
        for (int step_i = 0; step_i < 20; ++step_i) (void)ingot::step(*world, h);
        const auto bytes = saved(*world);
        std::memset(static_cast<void*>(other.get()), run_i % 2 == 0 ? 0 : 0xa5, sizeof *other);  // and one that had others
        ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), bytes.size()), Status::ok);
        ASSERT_EQ(ingot::load_snapshot(*full, bytes.data(), bytes.size()), Status::ok);
        for (int step_i = 0; step_i < 20; ++step_i) {
            for (auto* const each : {world.get(), other.get(), full.get()}) (void)ingot::step(*each, h);
            ASSERT_EQ(world->state_hash(), other->state_hash()) << run_i << ", step " << step_i;
            ASSERT_EQ(world->state_hash(), full->state_hash()) << run_i << ", step " << step_i;
        }
        ASSERT_EQ(saved(*world), saved(*other)) << run_i;
    }
}

/// A body of a scene that turns as it was printed, without a part of the rotation that roundings took off, has nothing of that.
TEST(EmptyWorlds, have_no_bytes_for_what_is_not_named) {
    const auto size_of = [](auto& world, int bodies) {
        RandomInput random(1);
        for (int i = 0; i < bodies; ++i) (void)add_body(world, random, i);
        return saved(world).size();
    };
    const auto bytes_of_body = [&](auto of) {
        using World = decltype(of);
        const auto few = std::make_unique<World>(), more = std::make_unique<World>();
        return (size_of(*more, 7) - size_of(*few, 2)) / 5;
    };
    const size_t printed = bytes_of_body(ingot::World<PrintedFlyers>{}), kept = bytes_of_body(ingot::World<Flyers>{});
    // Its numbers: of A, L, tau_T, the inertia in 4, r_CM, v_CM, F_T and mass; with them go a few bytes of who it is.
    EXPECT_LE(printed, 29 * sizeof(scalar) + 8);
    EXPECT_GE(kept, printed + 9 * sizeof(scalar));
}

struct Jointed : Flyers {
    static constexpr int max_joints = 8;
    using joints = ingot::Joints<ingot::BallJoint>;
};
struct Geared : Flyers {
    static constexpr int max_joints = 8, max_loops = 4;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::GearJoint>;
};

/// Nor has a joint of a scene without gears the numbers of one.
TEST(EmptyWorlds, have_no_bytes_for_gears_that_are_not_named) {
    const auto size_of = [](auto& world, int joints) {
        RandomInput random(1);
        for (int i = 0; i < 8; ++i) {
            ingot::JointDef def;
            def.body_B = add_body(world, random, i);
            def.joint = ingot::BallJoint{};
            def.P = world.state(def.body_B).value.r_CM;
            if (i < joints) {
                EXPECT_TRUE(world.add_joint(def).ok());
            }
        }
        return saved(world).size();
    };
    const auto bytes_of_joint = [&](auto of) {
        using World = decltype(of);
        const auto few = std::make_unique<World>(), more = std::make_unique<World>();
        return (size_of(*more, 7) - size_of(*few, 2)) / 5;
    };
    const size_t plain = bytes_of_joint(ingot::World<Jointed>{}), geared = bytes_of_joint(ingot::World<Geared>{});
    // Two frames of three vectors, an impulse, and who it is; a gear has a ratio, and a place and a way of both of its joints beside.
    EXPECT_LE(plain, 21 * sizeof(scalar) + 24);
    EXPECT_GE(geared, plain + 5 * sizeof(scalar));
}

}  // namespace
