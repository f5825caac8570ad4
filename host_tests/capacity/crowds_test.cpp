// SPDX-License-Identifier: MIT
// Arrays of contacts that are too small for what touches: nothing falls, nothing is pushed into the floor, no energy comes of it, and what is told of
// the room that was needed is right.
#include "capacity/crowd.h"
#include "capacity/yard.h"

#include <gtest/gtest.h>

namespace {

using namespace crowd;
using Tree = ingot::SortedTree;
using All = ingot::AllPairs;
namespace limits = ingot::limits;

constexpr double eps = static_cast<double>(ingot::epsilon);
constexpr double gap = static_cast<double>(limits::touching_gap);

/// What a crowd did.
struct Told {
    RoomNeeded most;
    int steps_that_lost = 0;
    uint64_t hash = 0;
    double depth = 0;  ///< m, at the end
};

/// Runs a crowd, and looks at each step. Where friction is, a step that lost contacts ends with nobody deeper in the floor than touching_gap, and so
/// does the last. On tiles a body may come over one in the step of which it knew nothing at the begin: by the way of that step. Energy: what is taken
/// back of overlaps was lost before, so it never comes to more than there was at the begin; once all lies, it is no more at the end than half-way.
template <class S>
Told run(const Plan& plan) {
    Crowd<S> crowd(plan);
    EXPECT_TRUE(crowd.sound());
    Told told;
    const double energy = crowd.energy(), size = floor_half + crowd.highest();
    double half_way = energy;
    // Rounding of a place, and of the lowest point that the test finds by another way.
    const double slack = 64 * eps * size, of_tiles = plan.on_tiles ? crowd.way_of_step() : 0;
    for (int step_i = 0; step_i < crowd.steps(); ++step_i) {
        const StepReport report = crowd.step();
        told.steps_that_lost += report.contacts_lost > 0;
        told.most.raise(crowd.world().room_needed(report));
        EXPECT_EQ(report.bodies_frozen, 0);
        if (S::max_manifolds > 0 && !plan.on_tiles && report.contacts_lost > report.pairs_lost) {
            EXPECT_EQ(report.contacts, S::max_manifolds) << "nothing is refused while there is room";
        }
        const bool last = step_i + 1 == crowd.steps();
        if (S::max_manifolds > 0 && (report.contacts_lost > 0 || last)) {
            EXPECT_LE(crowd.depth(), gap + slack + of_tiles) << "step " << step_i;
        }
        const double now = crowd.energy();
        EXPECT_LE(now, energy * (1 + 1e-5)) << "step " << step_i;
        if (step_i == crowd.steps() / 2) half_way = now;
        if (last && !plan.on_tiles) {  // who rolls off the last tile falls for ever, and its energy is rounded
            EXPECT_LE(now, half_way + crowd.weight() * gap);
        }
        if (::testing::Test::HasFailure()) break;
    }
    told.depth = crowd.depth();
    told.hash = crowd.world().state_hash();
    return told;
}

/// 50 to 99 % of what it takes, or more: a scene with so many manifolds, if that is what is asked for; the least by nightly.
template <int manifolds, class BroadPhase, class Solver, bool asleep>
bool run_if_tight(const Plan& plan, int needed) {
    if (2 * manifolds < needed || manifolds >= needed) return false;
    if constexpr (INGOT_TEST_BRIEF && manifolds < 13) {
        return false;
    } else {
        SCOPED_TRACE(::testing::Message() << "room for " << manifolds << " of " << needed << ", " << plan.bodies << " bodies, " << plan.rate
                                          << " Hz, seed " << plan.seed << (plan.on_tiles ? ", tiles" : ", half space"));
        const Told told = run<Tight<manifolds, 6 * manifolds, BroadPhase, Solver, asleep>>(plan);
        EXPECT_GT(told.steps_that_lost, 0);
        EXPECT_GT(told.most.max_manifolds, manifolds);
        return true;
    }
}

/// Bodies, rates and floors at random.
template <class BroadPhase, class Solver, bool asleep = false>
void expect_crowds_lie(unsigned seed, int cases) {
    constexpr int rates[] = {30, 60, 120, 240, 1000};
    RandomInput random(seed);
    if (INGOT_TEST_BRIEF) cases = 3;  // steps are as many as the rate: the two last rates are most of the work
    int tight = 0;
    for (int case_i = 0; case_i < cases && !::testing::Test::HasFailure(); ++case_i) {
        const int rate = rates[case_i % 5];
        const Plan plan = {seed * 100 + static_cast<unsigned>(case_i), rate > 500 ? random.integer(10, 14) : random.integer(16, 40), rate,
                           random.integer(0, 1) == 1};
        const Told roomy = run<Tight<600, 3000, BroadPhase, Solver, asleep>>(plan);
        EXPECT_EQ(roomy.steps_that_lost, 0);
        const int needed = roomy.most.max_manifolds;
        tight += run_if_tight<9, BroadPhase, Solver, asleep>(plan, needed) || run_if_tight<13, BroadPhase, Solver, asleep>(plan, needed) ||
                 run_if_tight<24, BroadPhase, Solver, asleep>(plan, needed) || run_if_tight<44, BroadPhase, Solver, asleep>(plan, needed);
    }
    EXPECT_GE(2 * tight, cases);
}
TEST(CrowdedManifolds, hold_what_falls_on_a_floor) { expect_crowds_lie<All, ingot::BlockSweeps>(1, 5); }
TEST(CrowdedManifolds, hold_it_by_the_tree_and_asleep) { expect_crowds_lie<Tree, ingot::BlockSweeps, true>(2, 5); }
TEST(CrowdedManifolds, hold_it_in_islands) { expect_crowds_lie<Tree, ingot::HybridIslands<>>(3, 5); }
TEST(CrowdedManifolds, hold_it_point_by_point) { expect_crowds_lie<All, ingot::SequentialImpulses>(4, 5); }

/// Pairs are lost, and contacts with them; what is kept is the same by both searches.
TEST(CrowdedPairs, hold_what_falls_on_a_floor) {
    RandomInput random(5);
    for (const int rate : {30, 120}) {
        const Plan plan = {static_cast<unsigned>(rate), random.integer(32, 48), rate, random.integer(0, 1) == 1, 6};
        SCOPED_TRACE(::testing::Message() << rate << " Hz");
        const Told all = run<Tight<16, 20, All>>(plan), tree = run<Tight<16, 20, Tree>>(plan);
        EXPECT_GT(all.steps_that_lost, 0);
        EXPECT_GT(all.most.max_pairs, 20);
        EXPECT_EQ(all.hash, tree.hash);
        const Told asleep = run<Tight<16, 20, All, ingot::BlockSweeps, true>>(plan);
        const Told by_tree = run<Tight<16, 20, Tree, ingot::BlockSweeps, true>>(plan);
        EXPECT_EQ(asleep.hash, by_tree.hash);
    }
}

/// Bodies get no deeper than with room for all, by more than what they come in one step at the speed at which they land.
TEST(CrowdedContacts, without_friction_hold_what_falls_on_a_floor) {
    for (const int rate : {30, 60, 240, 1000})
        for (unsigned seed = 1; seed <= 2; ++seed) {
            if (INGOT_TEST_BRIEF && (rate == 1000 || seed == 2)) continue;
            const Plan plan = {seed, rate > 500 ? 16 : 32, rate, false};
            SCOPED_TRACE(::testing::Message() << rate << " Hz, seed " << seed);
            const Told told = run<TightImpacts<48>>(plan), of_roomy = run<TightImpacts<400>>(plan);
            EXPECT_EQ(of_roomy.steps_that_lost, 0);
            EXPECT_GT(told.steps_that_lost + (rate > 500), 0);
            EXPECT_LE(told.depth, of_roomy.depth + Crowd<TightImpacts<48>>(plan).way_of_step());
        }
}

/// Bodies each of which may meet each other, in one place.
template <int manifolds, class BroadPhase, class Solver, bool asleep>
struct Knot : ingot::Scene {
    static constexpr int max_bodies = 7;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = manifolds;
    static constexpr int max_pairs = manifolds;
    static constexpr bool sleeps = asleep;
    using broad_phase = BroadPhase;
    using solver = Solver;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::Capsule, ingot::HalfSpace>;
};
constexpr int knot_pairs = 7 * 6 / 2;

ingot::BodyDef body_of_knot(RandomInput& random) {
    const auto size = [&] { return static_cast<scalar>(random.real(0.3, 0.6)); };
    const auto place = [&] { return static_cast<scalar>(random.real(-0.4, 0.4)); };
    const Shape shapes[] = {ingot::Sphere{size()}, ingot::Box{{size(), size(), size()}}, ingot::Capsule{size(), size()}};
    return yard::plain_body({place(), place(), scalar(0.3) + place()}, shapes[random.integer(0, 2)]);
}

/// Bodies come, go and are put elsewhere; all that is told is what a scene with more room tells.
template <class BroadPhase, class Solver, bool asleep>
void expect_room_for_all(unsigned seed) {
    using Exact = Knot<knot_pairs, BroadPhase, Solver, asleep>;
    using Roomy = Knot<3 * knot_pairs, BroadPhase, Solver, asleep>;
    using Tight = Knot<knot_pairs - 1, BroadPhase, Solver, asleep>;
    static_assert(!ingot::can_be_crowded<Exact> && !ingot::can_be_crowded<Roomy> && ingot::can_be_crowded<Tight>);
    static ingot::World<Exact> exact;
    static ingot::World<Roomy> roomy;
    RandomInput random(seed);
    int most = 0;
    for (int case_i = 0; case_i < (INGOT_TEST_BRIEF ? 4 : 40) && !::testing::Test::HasFailure(); ++case_i) {
        SCOPED_TRACE(::testing::Message() << "case " << case_i << ", seed " << seed);
        const auto both = [&](auto edit) {
            edit(exact);
            edit(roomy);
        };
        both([&](auto& world) {
            yard::clear(world);
            ASSERT_EQ(world.set_gravity({0, 0, scalar(-9.81)}), ingot::Status::ok);
            ASSERT_TRUE(world.add(yard::ground()).ok());
        });
        const scalar h = 1 / static_cast<scalar>(random.integer(30, 1000));
        for (int step_i = 0; step_i < 90; ++step_i) {
            const int slot = random.integer(1, 6), what = step_i < 6 ? 0 : random.integer(0, 9);
            const ingot::BodyDef def = body_of_knot(random);
            both([&](auto& world) {
                if (what == 0) (void)world.add(def);
                if (what == 1) (void)world.remove(world.body_at(slot));
                if (what == 2) (void)world.set_state(world.body_at(slot), def.state);
            });
            const StepReport report = ingot::step(exact, h), of_roomy = ingot::step(roomy, h);
            ASSERT_EQ(report.contacts_lost, 0);
            ASSERT_EQ(report.contacts, of_roomy.contacts);
            ASSERT_EQ(exact.state_hash(), roomy.state_hash()) << "step " << step_i;
            most = std::max(most, static_cast<int>(report.contacts));
        }
    }
    EXPECT_GE(most, knot_pairs - 3) << "they hardly met";
}
TEST(RoomForEachWithEach, is_never_full) { expect_room_for_all<All, ingot::BlockSweeps, false>(31); }
TEST(RoomForEachWithEach, is_never_full_by_the_tree_and_asleep) { expect_room_for_all<Tree, ingot::BlockSweeps, true>(32); }
TEST(RoomForEachWithEach, is_never_full_point_by_point) { expect_room_for_all<All, ingot::SequentialImpulses, true>(33); }

// F13 itself: ten boxes, room for eight.

template <int manifolds, class Solver = ingot::BlockSweeps>
struct TenBoxes : ingot::Scene {
    static constexpr int max_bodies = 11;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = manifolds;
    using solver = Solver;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};

constexpr scalar half = scalar(0.5);

/// Side by side, from no height: all that touches is the ground.
template <class S>
void put_boxes(ingot::World<S>& world, const Vector& from, const Vector& step) {
    yard::clear(world);
    ASSERT_EQ(world.set_gravity({0, 0, scalar(-9.81)}), ingot::Status::ok);
    ASSERT_TRUE(world.add(yard::ground()).ok());
    for (int i = 0; i < 10; ++i) {
        ingot::BodyDef def = yard::plain_body(from + step * static_cast<scalar>(i), ingot::Box{{half, half, half}});
        def.friction = scalar(0.6);
        ASSERT_TRUE(world.add(def).ok());
    }
}

template <class S>
void expect_boxes_lie(int needed) {
    static ingot::World<S> world;
    for (const int rate : {30, 60, 240, 1000}) {
        put_boxes(world, {0, 0, half}, {2, 0, 0});
        RoomNeeded most;
        int lost = 0;
        for (int step_i = 0; step_i < 20 * rate; ++step_i) {
            const StepReport report = ingot::step(world, scalar(1) / static_cast<scalar>(rate));
            most.raise(world.room_needed(report));
            lost += report.contacts_lost;
            for (int slot = 1; slot <= 10; ++slot) {
                const ingot::BodyState state = world.state(world.body_at(slot)).value;
                ASSERT_NEAR(state.r_CM.z, half, limits::settled_gap + 8 * ingot::epsilon) << "box " << slot << ", step " << step_i << ", " << rate;
                ASSERT_NEAR(state.r_CM.x, 2 * (slot - 1), 8 * ingot::epsilon);
            }
        }
        EXPECT_EQ(most.max_manifolds, needed) << "what is needed does not depend on what there is";
        EXPECT_EQ(lost > 0, S::max_manifolds < needed);
    }
}
TEST(TenBoxesInRoomForEight, lie_where_they_were_put) { expect_boxes_lie<TenBoxes<8>>(10); }
TEST(TenBoxesInRoomForEight, lie_in_islands) { expect_boxes_lie<TenBoxes<8, ingot::HybridIslands<>>>(10); }
TEST(TenBoxesInRoomForEight, lie_point_by_point) { expect_boxes_lie<TenBoxes<8, ingot::SequentialImpulses>>(10); }
TEST(TenBoxesInRoomForEight, lie_with_room_for_one) { expect_boxes_lie<TenBoxes<1>>(10); }
TEST(TenBoxesInRoomForEight, have_enough_with_what_is_named) { expect_boxes_lie<TenBoxes<10>>(10); }

/// What slides goes as far as friction lets it, with room or without: a floor bears its weight on the whole, and rubs by mu of that. A force is of a
/// whole step, so it may go a step further or less far.
template <class S>
void expect_slides_end(unsigned seed) {
    static ingot::World<S> world;
    RandomInput random(seed);
    constexpr double g = 9.81;
    for (const int rate : {30, 60, 240, 1000}) {
        yard::clear(world);
        ASSERT_EQ(world.set_gravity({0, 0, scalar(-g)}), ingot::Status::ok);
        ingot::BodyDef floor = yard::ground();
        floor.friction = scalar(random.real(0.2, 0.6));
        ASSERT_TRUE(world.add(floor).ok());
        double way[10], slack[10];
        const double h = 1.0 / rate;
        for (int i = 0; i < 10; ++i) {
            const double size = random.real(0.2, 1), speed = random.real(0.5, 3), heading = random.real(0, 6.28);
            const scalar a = scalar(size), c = scalar(size / 4);
            ingot::BodyDef def = yard::plain_body({scalar(8 * i), 0, c}, ingot::Box{{a, a, c}});
            def.friction = scalar(random.real(0.2, 0.6));
            def.state.v_CM = {scalar(speed * std::cos(heading)), scalar(speed * std::sin(heading)), 0};
            ASSERT_TRUE(world.add(def).ok());
            const double mu = std::sqrt(static_cast<double>(def.friction) * static_cast<double>(floor.friction));
            way[i] = speed * speed / (2 * mu * g);
            slack[i] = speed * h;
        }
        for (int step_i = 0; step_i < 3 * rate; ++step_i) (void)ingot::step(world, scalar(h));
        for (int i = 0; i < 10; ++i) {
            const ingot::BodyState state = world.state(world.body_at(i + 1)).value;
            const double went = std::hypot(static_cast<double>(state.r_CM.x) - 8 * i, static_cast<double>(state.r_CM.y));
            EXPECT_NEAR(went, way[i], slack[i]) << "box " << i << ", " << rate << " Hz";
            EXPECT_LE(ingot::length_sq(state.v_CM), scalar(1e-6)) << "box " << i << ", " << rate << " Hz";
        }
    }
}
TEST(TenBoxesInRoomForEight, slide_as_far_as_friction_lets_them) { expect_slides_end<TenBoxes<8>>(21); }
TEST(TenBoxesInRoomForEight, slide_as_far_point_by_point) { expect_slides_end<TenBoxes<8, ingot::SequentialImpulses>>(22); }
TEST(TenBoxesInRoomForEight, slide_as_far_with_room_for_one) { expect_slides_end<TenBoxes<1>>(23); }
TEST(TenBoxesInRoomForEight, slide_as_far_with_room_for_all) { expect_slides_end<TenBoxes<10>>(24); }

/// Two columns of five: two contacts between boxes are missing, and the ground never. At 240 Hz the columns stand.
TEST(TenBoxesInRoomForEight, stand_in_columns) {
    static ingot::World<TenBoxes<8>> world;
    yard::clear(world);
    ASSERT_EQ(world.set_gravity({0, 0, scalar(-9.81)}), ingot::Status::ok);
    ASSERT_TRUE(world.add(yard::ground()).ok());
    for (int i = 0; i < 10; ++i) {
        const Vector place = {static_cast<scalar>(2 * (i % 2)), 0, half + static_cast<scalar>(i / 2)};
        ingot::BodyDef def = yard::plain_body(place, ingot::Box{{half, half, half}});
        def.friction = scalar(0.6);
        ASSERT_TRUE(world.add(def).ok());
    }
    const scalar h = scalar(1) / 240, fall = scalar(9.81) * h * h;
    for (int step_i = 0; step_i < 20 * 240; ++step_i) (void)ingot::step(world, h);
    // A contact without room gives way by what bodies fall in a step, over the share that is taken back.
    for (int slot = 9; slot <= 10; ++slot) {
        const scalar z = world.state(world.body_at(slot)).value.r_CM.z;
        EXPECT_NEAR(z, scalar(4.5), 2 * 5 * fall / limits::position_share) << slot;
    }
}

/// It wakes what it lands on, and keeps awake what has no room: a floating body would be asleep in the air.
TEST(CrowdedSleepers, do_not_float_when_what_they_lie_on_leaves) {
    using S = Tight<1, 40, All, ingot::BlockSweeps, true>;
    static ingot::World<S> world;
    yard::clear(world);
    ASSERT_EQ(world.set_gravity({0, 0, scalar(-9.81)}), ingot::Status::ok);
    ASSERT_TRUE(world.add(yard::ground()).ok());
    const auto box = [](scalar x, scalar z) { return yard::plain_body({x, 0, z}, ingot::Box{{half, half, half}}); };
    const ingot::BodyId below = world.add(box(0, half)).value, above = world.add(box(0, 3 * half)).value;
    const scalar h = scalar(1) / 240;
    for (int step_i = 0; step_i < 5 * 240; ++step_i) (void)ingot::step(world, h);
    EXPECT_FALSE(world.is_asleep(above));
    ASSERT_EQ(world.remove(below), ingot::Status::ok);
    for (int step_i = 0; step_i < 5 * 240; ++step_i) (void)ingot::step(world, h);
    EXPECT_NEAR(world.state(above).value.r_CM.z, half, limits::touching_gap);
}

}  // namespace
