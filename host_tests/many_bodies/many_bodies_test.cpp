// SPDX-License-Identifier: MIT
// With INGOT_INDEX_BITS = 32: 65,536 balls in a pile, and worlds of 70,000 bodies in which numbers beyond 65535 name bodies, pairs and manifolds.
#include <gtest/gtest.h>

#include <ingot/ingot.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "reference/draws.h"

namespace {

using ingot::BodyDef;
using ingot::BodyId;
using ingot::scalar;
using ingot::StepReport;
using ingot::Vector;

template <int bodies>
struct Pit : ingot::Scene {
    static constexpr int max_bodies = bodies + 5;
    static constexpr bool translates = true, bounces = false;
    static constexpr int max_manifolds = 5 * bodies, max_pairs = 24 * bodies;
    using broad_phase = ingot::SortedTree;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
};

constexpr double g = 9.81, radius = 0.25;

/// Balls above each other in a pit of `along` by `along`, a little off a grid.
template <class S>
class Balls {
public:
    Balls(int balls, int along) : world(new ingot::World<S>{}) {
        EXPECT_EQ(world->set_gravity({0, 0, scalar(-g)}), ingot::Status::ok);
        const double half = along * (2 * radius + 0.01) / 2;
        wall({0, 0, 1}, 0);
        for (const scalar side : {scalar(-1), scalar(1)}) {
            wall({side, 0, 0}, half);
            wall({0, side, 0}, half);
        }
        for (int i = 0; i < balls; ++i) {
            BodyDef def;
            def.shape = ingot::Sphere{scalar(radius)};
            def.mass = ingot::principal(ingot::solid_sphere(500, scalar(radius))).value;
            const int layer = i / (along * along), k = i % (along * along);
            const auto at = [&](int n) { return -half + (n + 0.5) * (2 * radius + 0.01) + 0.004 * ((7 * i + 3 * layer) % 3 - 1); };
            const double z = radius * (1 + 2.02 * layer);
            def.state.r_CM = {static_cast<scalar>(at(k % along)), static_cast<scalar>(at(k / along)), static_cast<scalar>(z)};
            const ingot::Result<BodyId> added = world->add(def);
            EXPECT_TRUE(added.ok());
            ids.push_back(added.value);
        }
    }
    void wall(const Vector& n, double distance) {
        BodyDef def;
        def.immovable = true;
        def.shape = ingot::HalfSpace{n, 0};
        def.state.r_CM = n * static_cast<scalar>(-distance);
        EXPECT_TRUE(world->add(def).ok());
    }
    double mean_height() const {
        double sum = 0;
        for (const BodyId id : ids) sum += static_cast<double>(world->state(id).value.r_CM.z);
        return sum / static_cast<double>(ids.size());
    }
    double lowest() const {
        double low = 1e9;
        for (const BodyId id : ids) low = std::min(low, static_cast<double>(world->state(id).value.r_CM.z));
        return low;
    }

    std::unique_ptr<ingot::World<S>> world;
    std::vector<BodyId> ids;
};

/// What a pile did in a second or two: m.
struct Lain {
    int contacts = 0;
    double depth = 0, sunk = 0;
};
template <int balls>
Lain lie(int along, int steps) {
    Balls<Pit<balls>> pile(balls, along);
    const double height = pile.mean_height();
    Lain lain;
    for (int step_i = 0; step_i < steps; ++step_i) {
        const StepReport report = ingot::step(*pile.world, scalar(1) / 60);
        EXPECT_EQ(report.contacts_lost, 0) << "step " << step_i;
        EXPECT_EQ(report.bodies_frozen, 0);
        lain.contacts = std::max<int>(lain.contacts, report.contacts);
        lain.depth = std::max(lain.depth, radius - pile.lowest());
    }
    lain.sunk = height - pile.mean_height();
    return lain;
}
/// Not much deeper than a pile of as many layers on a sixteenth of the ground, whose numbers 16 bits hold.
TEST(ManyBodies, lie_in_a_pile_of_65536_balls) {
    const int steps = INGOT_TEST_BRIEF ? 4 : 80;
    const Lain many = lie<65536>(64, steps), few = lie<4096>(16, steps);
    EXPECT_GT(many.contacts, 65535) << "more than 16 bits count";
    EXPECT_LE(many.depth, 2 * few.depth + static_cast<double>(ingot::limits::touching_gap));
    EXPECT_LE(many.sunk, 2 * few.sunk) << "walls that are near hold more of it";
}

/// What the last bodies do is what they do alone: beyond 65535 nothing is cut off.
TEST(ManyBodies, beyond_65535_do_what_they_do_alone) {
    constexpr int all = 70000;
    using Few = Pit<8>;
    using Many = Pit<all>;
    const auto many = std::make_unique<ingot::World<Many>>();
    const auto few = std::make_unique<ingot::World<Few>>();
    const auto set_up = [](auto& world, int bystanders) {
        std::vector<BodyId> ids;
        EXPECT_EQ(world.set_gravity({0, 0, scalar(-g)}), ingot::Status::ok);
        BodyDef ground;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        EXPECT_TRUE(world.add(ground).ok());
        for (int i = 0; i < bystanders + 4; ++i) {
            BodyDef def;
            def.shape = ingot::Sphere{scalar(radius)};
            def.mass = ingot::principal(ingot::solid_sphere(500, scalar(radius))).value;
            const int tower = i - bystanders;
            def.state.r_CM = tower < 0 ? Vector{static_cast<scalar>(i % 256), static_cast<scalar>(10 + i / 256), scalar(radius)}
                                       : Vector{0, scalar(0.01) * static_cast<scalar>(tower), scalar(radius) * static_cast<scalar>(1 + 2 * tower)};
            const ingot::Result<BodyId> added = world.add(def);
            EXPECT_TRUE(added.ok());
            if (tower >= 0) ids.push_back(added.value);
        }
        return ids;
    };
    const std::vector<BodyId> of_many = set_up(*many, all - 4), of_few = set_up(*few, 0);
    EXPECT_GT(of_many[0].slot, 65535);
    for (int step_i = 0; step_i < ingot_reference::draws(60); ++step_i) {
        ASSERT_EQ(ingot::step(*many, scalar(1) / 60).contacts_lost, 0);
        ASSERT_EQ(ingot::step(*few, scalar(1) / 60).contacts_lost, 0);
        for (std::size_t i = 0; i < of_few.size(); ++i) {
            const ingot::BodyState a = many->state(of_many[i]).value, b = few->state(of_few[i]).value;
            for (const auto& [of_a, of_b] : {std::pair(a.r_CM, b.r_CM), std::pair(a.v_CM, b.v_CM), std::pair(a.L, b.L)}) {
                EXPECT_EQ(of_a.x, of_b.x) << step_i;
                EXPECT_EQ(of_a.y, of_b.y) << step_i;
                EXPECT_EQ(of_a.z, of_b.z) << step_i;
            }
        }
    }
    int met = 0;
    for ([[maybe_unused]] const ingot::ContactInfo& contact : many->contacts_of(of_many[3])) ++met;
    EXPECT_GE(met, 1) << "contacts name them";
    EXPECT_EQ(many->remove(of_many[3]), ingot::Status::ok);
    EXPECT_FALSE(many->state(of_many[3]).ok());
}

/// A snapshot of them goes on to the bit.
TEST(ManyBodies, are_saved_and_go_on) {
    using S = Pit<70000>;
    Balls<S> pile(70000, 100);
    for (int i = 0; i < (INGOT_TEST_BRIEF ? 1 : 3); ++i) (void)ingot::step(*pile.world, scalar(1) / 60);
    std::vector<std::uint8_t> bytes(ingot::snapshot_size<S>());
    const ingot::Result<std::size_t> size = ingot::save_snapshot(*pile.world, bytes.data(), bytes.size());
    ASSERT_TRUE(size.ok());
    const auto again = std::make_unique<ingot::World<S>>();
    ASSERT_EQ(ingot::load_snapshot(*again, bytes.data(), size.value), ingot::Status::ok);
    for (int i = 0; i < (INGOT_TEST_BRIEF ? 1 : 2); ++i) {
        (void)ingot::step(*pile.world, scalar(1) / 60);
        (void)ingot::step(*again, scalar(1) / 60);
        EXPECT_EQ(again->state_hash(), pile.world->state_hash());
    }
}

}  // namespace
