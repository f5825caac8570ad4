// SPDX-License-Identifier: MIT
// Scenes with a work_budget: it is kept in every step, what is enough changes nothing, and with the least there is things still stand and lie.
#include "capacity/crowd.h"

#include <gtest/gtest.h>

#include "reference/draws.h"

namespace {

using namespace crowd;
namespace limits = ingot::limits;

constexpr double eps = static_cast<double>(ingot::epsilon);
constexpr int rates[] = {30, 60, 120, 240, 1000};
constexpr int room = 600, plenty = ingot::no_budget - 1;

template <class Solver, int budget, bool fast = false>
struct Heap : Tight<room, 6 * room, ingot::SortedTree, Solver> {
    static constexpr int work_budget = budget;
    static constexpr bool continuous = fast;
};
template <int contacts, int budget>
struct Impacts : TightImpacts<contacts> {
    static constexpr int work_budget = budget;
};
/// A budget that is scarce: the least for a world with less room.
template <class Solver, int visits_of_contact>
struct Scarce : Tight<72, 600, ingot::AllPairs, Solver> {
    static constexpr int work_budget = visits_of_contact * Scarce::max_manifolds;
};

template <class S>
int manifolds_of(ingot::World<S>& world) {
    int count = 0;
    for ([[maybe_unused]] const ingot::ContactInfo& contact : world.contacts()) ++count;
    return count;
}

Plan plan_of(unsigned seed, int case_i) {
    RandomInput random(seed * 1000 + static_cast<unsigned>(case_i));
    const int rate = rates[case_i % 5];
    const int bodies = rate > 500 ? random.integer(6, 10) : random.integer(10, 16);
    return {seed * 1000 + static_cast<unsigned>(case_i), bodies, rate, false, rate > 500 ? 3.0 : 8.0};
}

/// No island takes more than its share, nothing comes through the floor, and what was cut short is told. A step that is cut short may leave a body as
/// fast as what falls on it: it goes on by the way of that step. In the end sweeps have lifted all again; sequential impulses may be at it still.
template <class S>
int unfinished_steps_of_crowd(const Plan& plan) {
    SCOPED_TRACE(::testing::Message() << S::solver::name << ", budget " << S::work_budget << ", " << plan.bodies << " bodies, " << plan.rate
                                      << " Hz, seed " << plan.seed);
    Crowd<S> crowd(plan);
    EXPECT_TRUE(crowd.sound());
    const double slack = 64 * eps * (floor_half + crowd.highest());
    int unfinished = 0;
    for (int step_i = 0; step_i < crowd.steps() && !::testing::Test::HasFailure(); ++step_i) {
        const StepReport report = crowd.step();
        EXPECT_EQ(report.contacts_lost, 0);
        EXPECT_EQ(report.bodies_frozen, 0);
        EXPECT_LE(report.sweeps * manifolds_of(crowd.world()), S::work_budget) << "step " << step_i;
        unfinished += report.sweeps_unfinished > 0;
        EXPECT_LE(crowd.depth(), (1 + unfinished) * crowd.way_of_step() + slack) << "step " << step_i;
        EXPECT_EQ(report.sweeps_unfinished > 0 && report.clean(), false);
    }
    if (!S::solver::is_pointwise) {
        EXPECT_LE(crowd.depth(), static_cast<double>(limits::touching_gap) + slack) << "at the end";
    }
    return unfinished;
}

template <class S>
void expect_kept_by_crowds(unsigned seed) {
    int unfinished = 0;
    for (int case_i = 0; case_i < ingot_reference::draws(20) && !::testing::Test::HasFailure(); ++case_i)
        unfinished += unfinished_steps_of_crowd<S>(plan_of(seed, case_i));
    EXPECT_GT(unfinished, 0) << "a budget that nothing meets shows nothing";
}

TEST(WorkBudget, is_kept_by_sweeps) {
    expect_kept_by_crowds<Scarce<ingot::BlockSweeps, 6>>(1);
    expect_kept_by_crowds<Scarce<ingot::BlockSweeps, 9>>(2);
}
TEST(WorkBudget, is_kept_by_sequential_impulses) { expect_kept_by_crowds<Scarce<ingot::SequentialImpulses, 6>>(3); }

/// Impacts that cause impacts, and bounces that are lowered, pay from the same share.
template <class S>
void expect_kept_by_bounces(unsigned seed) {
    int waves = 0, cut_short = 0;
    for (int case_i = 0; case_i < ingot_reference::draws(20) && !::testing::Test::HasFailure(); ++case_i) {
        Plan plan = plan_of(seed, case_i);
        plan.restitution = RandomInput(plan.seed).real(0.2, 1);
        Crowd<S> crowd(plan);
        for (int step_i = 0; step_i < crowd.steps() && !::testing::Test::HasFailure(); ++step_i) {
            const StepReport report = crowd.step();
            EXPECT_EQ(report.bodies_frozen, 0);
            EXPECT_LE(report.sweeps * manifolds_of(crowd.world()), S::work_budget) << "step " << step_i << ", seed " << plan.seed;
            waves += report.impact_waves;
            cut_short += report.impacts_deferred > 0 || report.sweeps_unfinished > 0;
        }
    }
    EXPECT_GT(waves, 0) << "impacts that cause none show nothing";
    EXPECT_GT(cut_short, 0);
}
TEST(WorkBudget, is_kept_by_bounces) {
    expect_kept_by_bounces<Scarce<ingot::BlockSweeps, 6>>(12);
    expect_kept_by_bounces<Scarce<ingot::BlockSweeps, 30>>(13);
    expect_kept_by_bounces<Scarce<ingot::HybridIslands<>, 6>>(14);
}

/// A row of balls with small gaps that bounce, which is one island: each impact that goes through it looks at all contacts for the next, so it is
/// told as a sweep at least; and there are no more than there is work for.
struct Row : ingot::Scene {
    static constexpr int max_bodies = 12, max_manifolds = 24;
    static constexpr int work_budget = 60 * max_manifolds;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere>;
};
TEST(WorkBudget, of_impacts_is_told_as_sweeps) {
    RandomInput random(21);
    int waves = 0;
    for (int case_i = 0; case_i < ingot_reference::draws(120); ++case_i) {
        const auto world = std::make_unique<ingot::World<Row>>();
        ASSERT_EQ(world->set_gravity({}), ingot::Status::ok);
        const int count = random.integer(4, 12);
        double x = 0;
        for (int i = 0; i < count; ++i) {
            ingot::BodyDef def;
            def.shape = ingot::Sphere{scalar(0.1)};
            def.mass = ingot::principal(ingot::solid_sphere(static_cast<scalar>(random.real(500, 2000)), scalar(0.1))).value;
            def.restitution = static_cast<scalar>(random.real(0.5, 1));
            def.state.r_CM = {static_cast<scalar>(x), 0, 0};
            def.state.v_CM = {i == 0 ? static_cast<scalar>(random.real(1, 4)) : scalar(0), 0, 0};
            x += 0.2 + random.real(1e-4, 2e-3);
            ASSERT_TRUE(world->add(def).ok());
        }
        int waves_of_row = 0;
        for (int step_i = 0; step_i < 6; ++step_i) {
            const StepReport report = ingot::step(*world, scalar(1) / static_cast<scalar>(rates[case_i % 4]));
            EXPECT_GE(report.sweeps, report.impact_waves) << case_i << ", step " << step_i;
            EXPECT_LE(report.sweeps * manifolds_of(*world), Row::work_budget) << case_i << ", step " << step_i;
            waves_of_row += report.impact_waves;
        }
        waves += waves_of_row > 4 ? 1 : 0;
    }
    EXPECT_GT(waves, ingot_reference::draws(120) / 2);
}

/// The same bits as without, step by step.
template <class Without, class With>
void expect_same_with_plenty(unsigned seed) {
    for (int case_i = 0; case_i < ingot_reference::draws(10) && !::testing::Test::HasFailure(); ++case_i) {
        const Plan plan = plan_of(seed, case_i);
        Crowd<Without> without(plan);
        Crowd<With> with(plan);
        for (int step_i = 0; step_i < without.steps() && !::testing::Test::HasFailure(); ++step_i) {
            (void)without.step();
            (void)with.step();
            EXPECT_EQ(with.world().state_hash(), without.world().state_hash()) << "step " << step_i << ", seed " << plan.seed;
        }
    }
}
TEST(WorkBudget, that_is_enough_changes_nothing) {
    expect_same_with_plenty<Heap<ingot::BlockSweeps, 0, true>, Heap<ingot::BlockSweeps, plenty, true>>(4);
    expect_same_with_plenty<Heap<ingot::HybridIslands<>, 0>, Heap<ingot::HybridIslands<>, plenty>>(5);
    expect_same_with_plenty<Heap<ingot::SequentialImpulses, 0>, Heap<ingot::SequentialImpulses, plenty>>(6);
    expect_same_with_plenty<Impacts<200, 0>, Impacts<200, plenty>>(7);
}

/// Without friction nothing takes overlap back, and nothing is remembered of the step before: each contact is visited once at least, and what that
/// leaves sinks by no more than gravity gives in a step.
TEST(WorkBudget, of_impacts_lets_nothing_fall) {
    using S = Impacts<120, 4 * 120>;
    int unfinished = 0;
    for (int case_i = 0; case_i < ingot_reference::draws(20) && !HasFailure(); ++case_i) {
        const Plan plan = plan_of(8, case_i);
        Crowd<S> crowd(plan);
        for (int step_i = 0; step_i < crowd.steps() && !HasFailure(); ++step_i) {
            const StepReport report = crowd.step();
            unfinished += report.sweeps_unfinished > 0 || report.impacts_deferred > 0;
            const double sunk = Crowd<S>::g / plan.rate / plan.rate * step_i;
            EXPECT_LE(crowd.depth(), crowd.way_of_step() + sunk) << "step " << step_i << " seed " << plan.seed;
        }
    }
    EXPECT_GT(unfinished, 0) << "a budget that nothing meets shows nothing";
}

/// Ten boxes on each other, pushed aside at random by up to a tenth of their edge, with six visits of each contact in a step.
template <class Solver>
struct Column : ingot::Scene {
    static constexpr int max_bodies = 11, max_manifolds = 10;
    static constexpr int work_budget = 6 * max_manifolds;
    static constexpr bool translates = true;
    using solver = Solver;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};

/// What is not carried in the first steps falls by g h^2 in one of them, and is lifted again.
template <class Solver>
void expect_columns_stand(unsigned seed) {
    using S = Column<Solver>;
    RandomInput random(seed);
    for (int case_i = 0; case_i < ingot_reference::draws(20) && !::testing::Test::HasFailure(); ++case_i) {
        const int rate = rates[case_i % 5];
        const double edge = random.real(0.2, 2), g = 9.81, fall = g / rate / rate, aside = case_i % 2 * random.real(0, 0.1) * edge;
        const auto world = std::make_unique<ingot::World<S>>();
        ASSERT_EQ(world->set_gravity({0, 0, scalar(-g)}), ingot::Status::ok);
        ingot::BodyDef ground;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        ground.immovable = true;
        ASSERT_TRUE(world->add(ground).ok());
        ingot::BodyId ids[10];
        for (int i = 0; i < 10; ++i) {
            const scalar half = static_cast<scalar>(edge / 2);
            ingot::BodyDef def;
            def.shape = ingot::Box{{half, half, half}};
            def.mass = ingot::principal(ingot::solid_box(500, {half, half, half})).value;
            def.state.r_CM = {static_cast<scalar>(random.real(-aside, aside)), static_cast<scalar>(random.real(-aside, aside)),
                              static_cast<scalar>((i + 0.5) * edge)};
            const ingot::Result<ingot::BodyId> added = world->add(def);
            ASSERT_TRUE(added.ok());
            ids[i] = added.value;
        }
        for (int step_i = 0; step_i < 10 * rate; ++step_i) {
            const StepReport report = ingot::step(*world, scalar(1) / static_cast<scalar>(rate));
            ASSERT_LE(report.sweeps, 6);
        }
        for (int i = 0; i < 10; ++i)
            EXPECT_NEAR(static_cast<double>(world->state(ids[i]).value.r_CM.z), (i + 0.5) * edge, fall + 64 * eps * 10 * edge)
                << Solver::name << ", " << rate << " Hz, edge " << edge << ", aside " << aside << ", box " << i;
    }
}
TEST(WorkBudget, of_six_visits_a_contact_lets_a_column_stand) {
    expect_columns_stand<ingot::BlockSweeps>(9);
    expect_columns_stand<ingot::SequentialImpulses>(10);
    expect_columns_stand<ingot::HybridIslands<>>(11);
}

}  // namespace
