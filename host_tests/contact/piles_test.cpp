// SPDX-License-Identifier: MIT
// Many bodies dropped: overlap at rest, energy of every step, nothing escapes.
#include <gtest/gtest.h>

#include <memory>

#include "contact/play.h"
#include "reference/draws.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_contact;
using namespace scenes;

/// Bodies whose centre has left the pit by more than the tolerance, m.
template <class S>
int escaped(const Play<S>& scene, double side) {
    int count = 0;
    for (int i = 0; i < scene.body_count(); ++i) {
        if (!scene.moves(i)) continue;
        const Vector3d r = scene.r(i);
        if (!(std::abs(r.x()) <= side / 2 && std::abs(r.y()) <= side / 2 && r.z() >= 0)) ++count;
    }
    return count;
}

/// 512 balls, figures over the last 5 of 10 s: mean overlap <= 0.01 mm at rest; nothing escapes.
template <int n, class BroadPhase>
void expect_pile_rests(double mean_mm) {
    auto scene = play<SpherePile<n>, BroadPhase>();
    ASSERT_TRUE(scene.sound());
    double mean_sum = 0, deepest = 0, deepest_falling = 0;
    int samples = 0;
    scene.run(OnEarth::h, SpherePile<n>::seconds, [&](int step_i) {
        if (step_i % 30 != 0) return;
        const std::vector<double> overlaps = scene.overlaps();
        double sum = 0, most = 0;
        for (const double deep : overlaps) sum += deep, most = std::max(most, deep);
        if (step_i <= 300) {
            deepest_falling = std::max(deepest_falling, most);
            return;
        }
        if (!overlaps.empty()) mean_sum += sum / static_cast<double>(overlaps.size());
        deepest = std::max(deepest, most);
        ++samples;
    });
    figure("mean overlap, mm", 1e3 * mean_sum / samples);
    figure("deepest overlap at rest, mm", 1e3 * deepest);
    figure("deepest overlap on the way, mm", 1e3 * deepest_falling);
    figure("fastest at the end, m/s", scene.fastest());
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(1e3 * mean_sum / samples, mean_mm);
    EXPECT_EQ(escaped(scene, static_cast<double>(SpherePile<n>::side)), 0);
}
TEST(SpherePile, of_64_rests_without_overlap) { expect_pile_rests<4, ingot::AllPairs>(0.01); }
TEST(SpherePile, of_512_rests_without_overlap) { expect_pile_rests<8, ingot::AllPairs>(0.01); }

/// A choice of broad phase is one of time alone: the same bits.
TEST(SpherePile, does_not_depend_on_the_broad_phase) {
    auto by_all = play<SpherePile<4>, ingot::AllPairs>();
    auto by_tree = play<SpherePile<4>, ingot::SortedTree>();
    for (int step_i = 0; step_i < 240; ++step_i) {
        (void)by_all.step(OnEarth::h);
        (void)by_tree.step(OnEarth::h);
        ASSERT_EQ(by_all.world().state_hash(), by_tree.world().state_hash()) << step_i;
    }
}

struct HighHeap : ingot::Scene {
    static constexpr int max_bodies = 505, max_manifolds = 4000, max_pairs = 12000;
    static constexpr bool translates = true, bounces = false;
    using broad_phase = ingot::SortedTree;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
};
/// m, how far the deepest of 500 balls comes into the floor of a narrow pit, in which they fall on each other. One of them, anywhere, is lighter.
double depth_of_high_heap(int rate, int light_i, double light) {
    constexpr double radius = 0.25, room = 0.55, half = 5 * room / 2;
    const auto world = std::make_unique<ingot::World<HighHeap>>();
    EXPECT_EQ(world->set_gravity({0, 0, scalar(-9.81)}), ingot::Status::ok);
    const auto wall = [&](const ingot::Vector& n, double distance) {
        ingot::BodyDef def;
        def.immovable = true;
        def.shape = ingot::HalfSpace{n, 0};
        def.state.r_CM = n * static_cast<scalar>(-distance);
        EXPECT_TRUE(world->add(def).ok());
    };
    wall({0, 0, 1}, 0);
    for (const scalar side : {scalar(-1), scalar(1)}) wall({side, 0, 0}, half), wall({0, side, 0}, half);
    std::vector<ingot::BodyId> ids;
    for (int i = 0; i < 500; ++i) {
        ingot::BodyDef def;
        def.shape = ingot::Sphere{scalar(radius)};
        def.mass = ingot::principal(ingot::solid_sphere(static_cast<scalar>(i == light_i ? 500 * light : 500), scalar(radius))).value;
        const auto at = [&](int k, int aside) { return static_cast<scalar>(-half + (k + 0.5) * room + 0.02 * (aside % 5 - 2)); };
        def.state.r_CM = {at(i % 5, 7 * i), at(i / 5 % 5, 3 * i), static_cast<scalar>(radius + 0.8 * (i / 25))};
        const auto added = world->add(def);
        EXPECT_TRUE(added.ok());
        ids.push_back(added.value);
    }
    double depth = 0;
    for (int step_i = 0; step_i < 5 * rate; ++step_i) {
        (void)ingot::step(*world, scalar(1) / static_cast<scalar>(rate));
        for (const ingot::BodyId id : ids) depth = std::max(depth, radius - static_cast<double>(world->state(id).value.r_CM.z));
    }
    return depth;
}
/// Fifty times lighter is no load that sweeps cannot carry, however much the heap weighs in all.
TEST(HighHeap, of_balls_bears_one_that_is_light) {
    ingot_reference::RandomInput random(77);
    for (const int rate : {30, 60}) {
        const double alike = depth_of_high_heap(rate, 0, 1);
        for (int case_i = 0; case_i < ingot_reference::draws(4); ++case_i) {
            const int light_i = random.integer(100, 400);
            EXPECT_LE(depth_of_high_heap(rate, light_i, 0.02), 1.5 * alike) << rate << " Hz, ball " << light_i;
        }
    }
}

/// No step gains more than 1e-4 of the energy there was at its start, from the floor; at rest after 10 s.
template <class Scene>
Play<Room<Scene::body_count>> expect_no_step_gains(double side) {
    auto scene = play<Scene>();
    EXPECT_TRUE(scene.sound());
    double before = scene.energy(), largest_gain = 0, gain_share = 0;
    int worst_step = 0;
    scene.run(OnEarth::h, Scene::seconds, [&](int step_i) {
        const double now = scene.energy();
        if ((now - before) / before > gain_share) {
            gain_share = (now - before) / before;
            worst_step = step_i;
        }
        largest_gain = std::max(largest_gain, now - before);
        before = now;
    });
    const double deepest = scene.deepest_overlap();
    figure("largest gain of a step, J", largest_gain);
    figure("largest gain of a step, share of the energy", gain_share);
    figure("in step", worst_step);
    figure("fastest at the end, m/s", scene.fastest());
    figure("overlap at the end, mm", 1e3 * deepest);
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(gain_share, 1e-4);
    EXPECT_LE(scene.fastest(), 0.01);
    EXPECT_LE(1e3 * deepest, 1);
    EXPECT_EQ(escaped(scene, side), 0);
    return scene;
}
TEST(PitOfBoxes, no_step_gains_energy) { expect_no_step_gains<PitOfBoxes>(static_cast<double>(PitOfBoxes::side)); }
TEST(FallingPlanks, no_step_gains_energy) { expect_no_step_gains<FallingPlanks>(1e9); }

/// With room for all pairs the slab lands and rests on the tiles: 1000 immovable tiles, hundreds of contacts of one body.
TEST(SlabOnTiles, lands_and_rests) {
    Play<Room<SlabOnTiles::body_count, ingot::SortedTree, true, 1100, 1200>> scene(bodies_of<SlabOnTiles>(), SlabOnTiles::gravity);
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 3);
    const int slab = SlabOnTiles::body_count - 1;
    figure("sink, mm", 1e3 * (0.25 - scene.r(slab).z()));
    figure("speed, m/s", scene.v(slab).norm());
    figure("contacts, most", scene.reports().most_contacts);
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_NEAR(scene.r(slab).z(), 0.25, 1e-4);
    EXPECT_LE(scene.v(slab).norm(), 1e-3);
    EXPECT_GE(scene.reports().most_contacts, 900);
}

}  // namespace
