// SPDX-License-Identifier: MIT
// A contact that begins has no impulses yet, whichever contact had its record before: also none of its rolling resistance.
#include <gtest/gtest.h>

#include <ingot/ingot.h>

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

template <class Solver>
struct Bowling : ingot::Scene {
    static constexpr int max_bodies = 40, max_manifolds = 200;
    static constexpr bool translates = true, rolling_resistance = true;
    using solver = Solver;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::HalfSpace>;
};

/// A ball or a capsule that rolls, hops, or lies.
BodyDef thrown(RandomInput& random, const Vector3d& about) {
    BodyDef def;
    const auto R = static_cast<scalar>(random.real(0.1, 0.3));
    if (random.integer(0, 1) == 0) {
        def.shape = ingot::Sphere{R};
        def.mass = ingot::principal(ingot::solid_sphere(1000, R)).value;
    } else {
        def.shape = ingot::Capsule{R, R};
        def.mass = ingot::principal(ingot::solid_capsule(1000, R, R)).value;
    }
    def.friction = static_cast<scalar>(random.real(0.2, 1));
    def.restitution = static_cast<scalar>(random.real(0, 0.7));
    def.state.A = ingot_reference::to_matrix(random.rotation());
    def.state.r_CM = ingot_reference::to_vector(Vector3d(about + random.vector(0.8) + Vector3d(0, 0, 1.3)));
    def.state.v_CM = ingot_reference::to_vector(random.vector(2));
    def.state.L = ingot::scaled(def.mass.I_body, ingot_reference::to_vector(random.vector(8)));
    return def;
}

template <class S>
void add(ingot::World<S>& world, const BodyDef& def, double lever, std::vector<BodyId>& ids) {
    ids.push_back(world.add(def).value);
    ASSERT_EQ(world.set_rolling_resistance(ids.back(), static_cast<scalar>(lever)), Status::ok);
}

template <class S>
class UsedRecords : public ::testing::Test {};
using Solvers = ::testing::Types<Bowling<ingot::BlockSweeps>, Bowling<ingot::SequentialImpulses>>;
TYPED_TEST_SUITE(UsedRecords, Solvers);

/// Bodies that meet the ground and part again and again, alone and beside others that do the same elsewhere, and that took records before: the same
/// way, to the bit. So no contact has anything of who had its record.
TYPED_TEST(UsedRecords, leave_nothing_to_who_has_them_next) {
    int parted = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(64); ++run_i) {
        RandomInput random(static_cast<std::uint64_t>(100 + run_i));
        const auto alone = std::make_unique<ingot::World<TypeParam>>(), beside = std::make_unique<ingot::World<TypeParam>>();
        std::vector<BodyId> of_alone, of_beside, others;
        BodyDef ground;
        ground.immovable = true;
        ground.friction = 1;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        for (auto* const world : {alone.get(), beside.get()}) {
            ASSERT_EQ(world->set_gravity({0, 0, scalar(-9.81)}), Status::ok);
            ASSERT_TRUE(world->add(ground).ok());
        }
        for (int i = 0; i < 8; ++i) add(*beside, thrown(random, {40, 0, 0}), random.real(0, 0.1), others);
        for (int i = 0; i < 6; ++i) {
            const BodyDef def = thrown(random, {0, 0, 0});
            const double lever = random.real(0.005, 0.1);
            add(*alone, def, lever, of_alone);
            add(*beside, def, lever, of_beside);
        }
        for (int i = 0; i < 8; ++i) add(*beside, thrown(random, {-40, 0, 0}), random.real(0, 0.1), others);
        const double rates[] = {60, 120, 240};
        const auto h = static_cast<scalar>(1 / rates[run_i % 3]);
        int contacts = 0;
        for (int step_i = 0; step_i < 90; ++step_i) {
            const int now = ingot::step(*alone, h).contacts;
            parted += now < contacts ? 1 : 0;
            contacts = now;
            (void)ingot::step(*beside, h);
            for (size_t i = 0; i < of_alone.size(); ++i) {
                const ingot::BodyState a = alone->state(of_alone[i]).value, b = beside->state(of_beside[i]).value;
                ASSERT_TRUE(a.r_CM.x == b.r_CM.x && a.r_CM.y == b.r_CM.y && a.r_CM.z == b.r_CM.z) << run_i << ", step " << step_i << ", body " << i;
                ASSERT_TRUE(a.L.x == b.L.x && a.L.y == b.L.y && a.L.z == b.L.z) << run_i << ", step " << step_i << ", body " << i;
            }
        }
    }
    EXPECT_GT(parted, 20);
}

}  // namespace
