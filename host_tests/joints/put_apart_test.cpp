// SPDX-License-Identifier: MIT
// Bodies of figures that are put elsewhere, away from their joints: what hangs together comes together again, by ways that no velocity sees. No
// energy is made of it, nothing freezes, and who stands beside it does not notice.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "joints/figures.h"
#include "reference/draws.h"
#include "reference/powers_of_two.h"

namespace {

using namespace figures;
using Eigen::Vector3d;
using ingot::BodyId;
using ingot::Status;
using ingot_reference::to_eigen;

struct Swinging : ingot::Scene {
    static constexpr int max_bodies = 16, max_joints = 18;
    static constexpr bool translates = true;
    using joints = AllJoints;
};
struct SwingingSmoothly : Swinging {
    using figure_motion = ingot::EnergyMomentum<>;
};
struct Driven : Swinging {
    using joints = AllJointsWith<ingot::WithLimits, ingot::WithDrives>;
};
struct Tied : Swinging {
    static constexpr int max_loops = 4;
    using joints = AllJointsWith<ingot::RodJoint, ingot::RopeJoint>;
};
/// Everything 2^k times as large, its gaps too.
template <class S, int k>
struct OfSize : S {
    static constexpr scalar length_unit = ingot_reference::power_of_two(k);
};
/// Ragdolls on the ground.
template <class S>
struct Lying : S {
    static constexpr int max_bodies = 32, max_joints = 32, max_manifolds = 200, max_pairs = 600;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::HalfSpace>;
};

/// A figure, and another far from it.
template <class S>
struct Scenery {
    std::unique_ptr<ingot::World<S>> world = std::make_unique<ingot::World<S>>();
    Built figure, bystander;
    bool sound = true;

    Scenery(RandomInput random, double size, bool tied) {
        const int count = random.integer(2, 8);
        add_figure(*world, random, {count, size, 20, random.real(0, 2), tied}, {0, 0, 0}, figure);
        add_figure(*world, random, {3, size, 20, 2, true}, Vector3d(200, 0, 0) * size, bystander);
        sound = figure.sound && bystander.sound;
        if constexpr (S::joints::has_ties) tie(random, size);
    }
    ingot::BodyId any_of_figure(RandomInput& random) const {
        return figure.bodies[static_cast<std::size_t>(random.integer(0, static_cast<int>(figure.bodies.size()) - 1))];
    }

private:
    void tie(RandomInput& random, double size) {
        for (int i = 0; i < 2; ++i) {
            ingot::JointDef def;
            def.body_A = any_of_figure(random);
            def.body_B = any_of_figure(random);
            if (def.body_A == def.body_B) continue;
            const Vector3d A = to_eigen(world->state(def.body_A).value.r_CM), B = to_eigen(world->state(def.body_B).value.r_CM);
            if ((A - B).norm() < 0.3 * size) continue;
            def.joint = i == 0 ? ingot::Joint(ingot::RodJoint{}) : ingot::Joint(ingot::RopeJoint{});
            def.P = to_vector(A);
            def.P_B = to_vector(B);
            const auto added = world->add_joint(def);
            sound = sound && added.ok();
            figure.joints.push_back(added.value);
        }
    }
};

/// To a place so far away, and turned.
template <class World>
void put_elsewhere(World& world, BodyId id, RandomInput& random, double way, bool turns) {
    ingot::BodyState state = world.state(id).value;
    state.r_CM = to_vector(to_eigen(state.r_CM) + random.direction() * way);
    if (turns) state.A = ingot_reference::to_matrix(random.rotation());
    ASSERT_EQ(world.set_state(id, state), Status::ok);
}

template <class S>
class PutApart : public ::testing::Test {};
using Scenes =
    ::testing::Types<Swinging, SwingingSmoothly, Driven, Tied, OfSize<Driven, -5>, OfSize<Driven, 5>, OfSize<Tied, -5>, OfSize<SwingingSmoothly, 5>>;
TYPED_TEST_SUITE(PutApart, Scenes);

/// Of the moments of a box of add_figure, the largest over the least, whose half extents are 0.2 to 1 of its size: so much more energy a spin has
/// where a push has turned the body.
constexpr double ratio_of_moments = (1.0 + 1.0) / (0.2 * 0.2 + 0.2 * 0.2);

TYPED_TEST(PutApart, figures_come_together_and_gain_nothing) {
    RandomInput random(1);
    for (int run_i = 0; run_i < ingot_reference::draws(120); ++run_i) {
        constexpr auto unit = static_cast<double>(TypeParam::length_unit);
        const double size = unit * std::exp(random.real(std::log(0.05), std::log(1.0)));
        const bool tied = random.integer(0, 1) == 1;
        const double rate = rates[random.integer(0, 4)], way = size * std::exp(random.real(std::log(0.01), std::log(20.0)));
        const auto h = static_cast<scalar>(1 / rate);
        SCOPED_TRACE(::testing::Message() << "run " << run_i << ", " << rate << " Hz, size " << size << ", put by " << way << (tied ? ", tied" : ""));
        const RandomInput drawn(random.bits());
        Scenery<TypeParam> scenery(drawn, size, tied), calm(drawn, size, tied);
        ASSERT_TRUE(scenery.sound && calm.sound);
        const auto step = [&](int count) {
            for (int i = 0; i < count; ++i) {
                ASSERT_EQ(ingot::step(*scenery.world, h).bodies_frozen, 0);
                (void)ingot::step(*calm.world, h);
            }
        };
        ASSERT_NO_FATAL_FAILURE(step(random.integer(0, 20)));
        ASSERT_NO_FATAL_FAILURE(put_elsewhere(*scenery.world, scenery.any_of_figure(random), random, way, random.integer(0, 1) == 1));
        const double before = kinetic_energy_of(*scenery.world, scenery.figure.bodies);
        for (int i = 0; i < 40; ++i) {
            ASSERT_NO_FATAL_FAILURE(step(1));
            ASSERT_LE(kinetic_energy_of(*scenery.world, scenery.figure.bodies), before * ratio_of_moments);
        }
        EXPECT_LE(worst_gap(*scenery.world, scenery.figure), held * std::max(unit, 1.0));  // of turns too, rad
        EXPECT_TRUE(are_same(*scenery.world, *calm.world, scenery.bystander.bodies, calm.bystander.bodies));
    }
}

template <class S>
class PutApartOnTheGround : public ::testing::Test {};
using ScenesOfGround = ::testing::Types<Lying<Swinging>, Lying<Tied>>;
TYPED_TEST_SUITE(PutApartOnTheGround, ScenesOfGround);

/// A ragdoll, and another far from it.
template <class S>
struct Dolls {
    std::unique_ptr<ingot::World<S>> world = std::make_unique<ingot::World<S>>();
    Built figure, bystander;
    bool sound = true;

    explicit Dolls(const ingot::Matrix& A) {
        sound = weigh(*world) && add_ground(*world);
        add_ragdoll(*world, {0, 0, scalar(1.2)}, A, figure);
        add_ragdoll(*world, {30, 0, scalar(1.2)}, A, bystander);
        sound = sound && figure.sound && bystander.sound;
    }
    double energy() const {
        double sum = kinetic_energy_of(*world, figure.bodies);
        for (const BodyId id : figure.bodies)
            sum += g * static_cast<double>(world->mass(id).value) * static_cast<double>(world->state(id).value.r_CM.z);
        return sum;
    }
};

/// Pushes may lift all of it by as much as a part of it was put away, to that part or out of the ground; that alone is more than there was.
TYPED_TEST(PutApartOnTheGround, ragdolls_come_together_and_gain_nothing) {
    constexpr double weight = 66 * g;
    RandomInput random(2);
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        const double rate = rates[random.integer(0, 4)], way = std::exp(random.real(std::log(0.01), std::log(5.0)));
        const auto h = static_cast<scalar>(1 / rate);
        SCOPED_TRACE(::testing::Message() << "run " << run_i << ", " << rate << " Hz, put by " << way);
        const ingot::Matrix A = ingot_reference::to_matrix(random.rotation());
        Dolls<TypeParam> dolls(A), calm(A);
        ASSERT_TRUE(dolls.sound && calm.sound);
        const auto step = [&](int count) {
            for (int i = 0; i < count; ++i) {
                ASSERT_EQ(ingot::step(*dolls.world, h).bodies_frozen, 0);
                (void)ingot::step(*calm.world, h);
            }
        };
        ASSERT_NO_FATAL_FAILURE(step(std::min(static_cast<int>(rate * random.real(0, 1)), 250)));
        const BodyId put = dolls.figure.bodies[static_cast<std::size_t>(random.integer(0, parts_of_ragdoll - 1))];
        ASSERT_NO_FATAL_FAILURE(put_elsewhere(*dolls.world, put, random, way, random.integer(0, 1) == 1));
        const double before = dolls.energy();
        for (int i = 0; i < 60; ++i) {
            ASSERT_NO_FATAL_FAILURE(step(1));
            EXPECT_LE(dolls.energy(), before + weight * way + 1);
        }
        EXPECT_LE(worst_gap(*dolls.world, dolls.figure), held);
        EXPECT_TRUE(are_same(*dolls.world, *calm.world, dolls.bystander.bodies, calm.bystander.bodies));
    }
}

}  // namespace
