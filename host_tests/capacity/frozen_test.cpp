// SPDX-License-Identifier: MIT
// A body that legal input drives out of what numbers can say stands still and is reported. Nobody else notices.
#include "capacity/yard.h"
#include "reference/brief_types.h"
#include "reference/draws.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace yard;

constexpr int crowd = 2 * ingot::lanes + 3;

template <class Rotation>
struct Crowd : ingot::Scene {
    static constexpr int max_bodies = crowd;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 8 * crowd;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using rotation = Rotation;
};

/// A legal way out of the range.
struct WayOut {
    const char* name;
    BodyDef body;
    Vector F, tau;  ///< added before every step
};

std::vector<WayOut> ways_out() {
    const Vector none{};
    BodyDef flies = plain_body({0, 0, limits::position_max});
    flies.state.v_CM = {0, 0, limits::speed_max};
    BodyDef light = plain_body({0, 0, 1000});
    light.mass.M = limits::mass_min;
    std::vector<WayOut> ways = {{"flies beyond position_max", flies, none, none},
                                {"a feather pushed by force_max", light, Vector{limits::force_max, 0, 0}, none}};
#if !INGOT_DOUBLE
    // The square of its angle leaves the range of float; that of double has room for it, and the turn is clamped.
    BodyDef speck = plain_body({0, 0, 1000});
    speck.mass.I_body = Vector{1, 1, 1} * (2 * limits::inertia_min);
    ways.push_back({"a speck turned by torque_max", speck, none, Vector{0, limits::torque_max, 0}});
#endif
    return ways;
}

/// The other bodies: on the ground, in the air, spinning, falling on each other.
BodyDef neighbour(int body_i) {
    if (body_i == 0) return ground();
    const scalar x = static_cast<scalar>(4 * body_i);
    if (body_i % 3 == 0) return plain_body({x, 0, 1}, ingot::Box{{1, 1, 1}});
    BodyDef def = plain_body({x, 0, scalar(1.5)}, ingot::Sphere{1});
    def.restitution = scalar(0.5);
    def.state.L = {static_cast<scalar>(body_i), 2, 3};
    if (body_i % 3 == 2) def = plain_body({x - 4, 0, 4}, ingot::Sphere{1});
    return def;
}

/// A crowd with a guest in one slot.
template <class Rotation>
struct Run {
    World<Crowd<Rotation>>& world;
    BodyId ids[crowd];

    Run(World<Crowd<Rotation>>& empty, int guest_i, const BodyDef& guest) : world(empty) {
        clear(world);
        (void)world.set_gravity({0, 0, scalar(-9.8125)});
        for (int body_i = 0; body_i < crowd; ++body_i) ids[body_i] = world.add(body_i == guest_i ? guest : neighbour(body_i)).value;
    }
};

/// Calls test(guest's slot, way out) for guests in the first, a middle and the last lane of tiles, and in the last slot.
void for_all_guests(const std::function<void(int, const WayOut&)>& test) {
    for (const WayOut& way : ways_out()) {
        for (const int guest_i : {1, ingot::lanes - 1, ingot::lanes, ingot::lanes + ingot::lanes / 2, crowd - 1}) {
            if (guest_i == 0) continue;
            SCOPED_TRACE(std::string(way.name) + ", slot " + std::to_string(guest_i));
            test(guest_i, way);
        }
    }
}

template <class Rotation>
class Frozen : public ::testing::Test {};
// Of all, what a test that is brief has: see CMakeLists.txt here.
using Rotations =
    ingot_reference::BriefTypes<INGOT_FROZEN_ROTATIONS, ingot::MoserVeselov, ingot::Listing1Euler, ingot::DiscreteMoserVeselov<4, false, false, 2>,
                                ingot::LieMidpoint, ingot::Rk4Polar, ingot::SymmetricTop, ingot::SymmetricTopSplitting<6>, ingot::ExactElliptic>;
TYPED_TEST_SUITE(Frozen, Rotations);

TYPED_TEST(Frozen, body_is_reported_once_and_stands_still_at_its_last_good_pose) {
    static World<Crowd<TypeParam>> world;
    for_all_guests([](int guest_i, const WayOut& way) {
        Run<TypeParam> run(world, guest_i, way.body);
        const BodyId id = run.ids[guest_i];
        int frozen_steps = 0;
        BodyState at_rest{};
        for (int step_i = 0; step_i < 100; ++step_i) {
            const bool was_frozen = world.is_frozen(id);
            const Vector r_CM = world.state(id).value.r_CM;
            const Status pushed = world.add_central_force(id, way.F);
            const Status turned = world.add_torque(id, way.tau);
            EXPECT_EQ(pushed, was_frozen ? Status::frozen : Status::ok);
            EXPECT_EQ(turned, was_frozen ? Status::frozen : Status::ok);

            const StepReport report = ingot::step(world, h);
            const BodyState state = world.state(id).value;
            EXPECT_EQ(report.bodies_frozen, !was_frozen && world.is_frozen(id) ? 1 : 0);
            EXPECT_TRUE(ingot::is_finite(state.r_CM) && ingot::is_finite(state.v_CM) && ingot::is_finite(state.A) && ingot::is_finite(state.L));
            EXPECT_TRUE(ingot::is_finite(world.omega(id).value) && ingot::is_finite(world.kinetic_energy()));
            if (was_frozen) {
                ASSERT_TRUE(same_bits(state, at_rest)) << "step " << step_i;
                continue;
            }
            if (!world.is_frozen(id)) continue;
            ++frozen_steps;
            at_rest = state;
            EXPECT_FALSE(report.clean());
            EXPECT_EQ(report.status, Status::ok);
            EXPECT_LE(ingot::orthogonality_error(state.A), 8 * ingot::epsilon);
            for (const scalar motion : {state.v_CM.x, state.v_CM.y, state.v_CM.z, state.L.x, state.L.y, state.L.z}) EXPECT_EQ(motion, 0);
            for (const scalar coordinate : {state.r_CM.x - r_CM.x, state.r_CM.y - r_CM.y})
                EXPECT_LT(coordinate, limits::position_max) << "it has not gone anywhere";
        }
        EXPECT_EQ(frozen_steps, 1) << "it did freeze, and once";
        EXPECT_EQ(world.kinetic_energy(id).value, 0);
    });
}

TYPED_TEST(Frozen, body_is_not_noticed_by_others_to_the_bit) {
    static World<Crowd<TypeParam>> world, undisturbed;
    for_all_guests([](int guest_i, const WayOut& way) {
        Run<TypeParam> run(world, guest_i, way.body), without(undisturbed, guest_i, plain_body({0, 0, 1000}));
        for (int step_i = 0; step_i < 60; ++step_i) {
            (void)world.add_central_force(run.ids[guest_i], way.F);
            (void)world.add_torque(run.ids[guest_i], way.tau);
            (void)ingot::step(world, h);
            (void)ingot::step(undisturbed, h);
            for (int body_i = 0; body_i < crowd; ++body_i) {
                if (body_i == guest_i) continue;
                ASSERT_TRUE(same_bits(world.state(run.ids[body_i]).value, undisturbed.state(without.ids[body_i]).value))
                    << "body " << body_i << " at step " << step_i;
            }
        }
        EXPECT_TRUE(world.is_frozen(run.ids[guest_i]));
        EXPECT_FALSE(undisturbed.is_frozen(without.ids[guest_i]));
    });
}

TYPED_TEST(Frozen, slot_gives_a_sound_body_after_it_is_removed) {
    static World<Crowd<TypeParam>> world, fresh;
    for_all_guests([](int guest_i, const WayOut& way) {
        Run<TypeParam> run(world, guest_i, way.body);
        for (int step_i = 0; step_i < 60; ++step_i) {
            (void)world.add_central_force(run.ids[guest_i], way.F);
            (void)world.add_torque(run.ids[guest_i], way.tau);
            (void)ingot::step(world, h);
        }
        ASSERT_TRUE(world.is_frozen(run.ids[guest_i]));
        ASSERT_EQ(world.remove(run.ids[guest_i]), Status::ok);
        BodyDef def = plain_body({0, 0, 2000});
        def.state.L = {1, 2, 3};
        const BodyId id = world.add(def).value;
        EXPECT_EQ(id.slot, guest_i);
        EXPECT_FALSE(world.is_frozen(id));

        // It moves as a body that is alone in a new world.
        clear(fresh);
        (void)fresh.set_gravity(world.gravity());
        while (fresh.step_count() < world.step_count()) (void)ingot::step(fresh, h);  // polar steps go by the count
        const BodyId twin = fresh.add(def).value;
        (void)ingot::step(world, h);
        (void)ingot::step(fresh, h);
        EXPECT_TRUE(same_bits(world.state(id).value, fresh.state(twin).value));
    });
}

TYPED_TEST(Frozen, body_holds_up_what_lies_on_it) {
    static World<Crowd<TypeParam>> world;
    clear(world);
    BodyDef leaving = plain_body({limits::position_max, 0, 0}, ingot::Sphere{1});
    leaving.state.v_CM = {limits::speed_max, 0, 0};
    const BodyId frozen = world.add(leaving).value;
    (void)ingot::step(world, h);
    ASSERT_TRUE(world.is_frozen(frozen));

    BodyDef ball = plain_body({limits::position_max, 0, 2}, ingot::Sphere{1});
    const BodyId on_top = world.add(ball).value;
    (void)world.set_gravity({0, 0, -10});
    for (int step_i = 0; step_i < 300; ++step_i) (void)ingot::step(world, h);
    EXPECT_GT(world.state(on_top).value.r_CM.z, scalar(1.9));
    EXPECT_EQ(world.state(frozen).value.r_CM.z, 0);
}

TYPED_TEST(Frozen, all_bodies_at_once) {
    static World<Crowd<TypeParam>> world;
    clear(world);
    for (int body_i = 0; body_i < crowd; ++body_i) {
        BodyDef def = plain_body({static_cast<scalar>(body_i), 0, limits::position_max});
        def.state.v_CM = {0, 0, limits::speed_max};
        ASSERT_TRUE(world.add(def).ok());
    }
    EXPECT_EQ(ingot::step(world, h).bodies_frozen, crowd);
    EXPECT_EQ(world.kinetic_energy(), 0);
    EXPECT_TRUE(ingot::step(world, h).clean()) << "the news is told once";
}

template <class Rotation>
class NotFrozen : public ::testing::Test {};
using RotationsOfAnySpin = ::testing::Types<ingot::MoserVeselov, ingot::Listing1Euler>;
TYPED_TEST_SUITE(NotFrozen, RotationsOfAnySpin);

/// Motions that a range of input allows and that stay in it: nobody is frozen.
TYPED_TEST(NotFrozen, is_a_body_whose_motion_stays_in_range) {
    static World<Crowd<TypeParam>> world;
    const scalar ratios[] = {1, 10, 1000, scalar(1e5), limits::inertia_ratio_max / 2};
    for (const scalar ratio : ratios) {
        for (const scalar angle : {scalar(0.01), scalar(0.3), scalar(0.6), scalar(3)}) {  // of a step
            // Listing 1 keeps no energy: a body may end up spinning about the axis of its least moment.
            if (TypeParam::as_printed && angle / h * ratio > limits::spin_runaway) continue;
            clear(world);
            for (const Vector& I : {Vector{1 / ratio, 1, 1}, Vector{1, 1 / ratio, 1}, Vector{1, 1, 1 / ratio}}) {
                for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, scalar(0.6), scalar(0.8)}}) {
                    if (world.body_count() == crowd) continue;
                    BodyDef def = plain_body({});
                    def.mass.I_body = I;
                    def.state.L = ingot::scaled(I, axis * (angle / h));
                    ASSERT_TRUE(world.add(def).ok());
                }
            }
            int frozen = 0;
            for (int step_i = 0; step_i < 60; ++step_i) frozen += ingot::step(world, h).bodies_frozen;
            EXPECT_EQ(frozen, 0) << "moments 1 : " << ratio << ", " << angle << " rad a step";
        }
    }
}

/// Lanes are advanced together, and a fast body takes more substeps than a slow one: none of them may notice.
TYPED_TEST(Frozen, or_not_a_body_moves_beside_others_as_it_moves_alone) {
    static World<Crowd<TypeParam>> world, alone;
    std::mt19937_64 random(1997);
    std::uniform_real_distribution<scalar> share(0, 1), unit(-1, 1);
    const auto direction = [&] { return Vector{unit(random), unit(random), unit(random)}; };
    const auto power = [&](scalar least, scalar most) { return std::pow(scalar(10), least + (most - least) * share(random)); };
    for (int round_i = 0; round_i < ingot_reference::draws(200); ++round_i) {
        // From balls to needles, from rest to spins that are clamped, from a breath to a blow.
        BodyDef defs[crowd];
        Vector blows[crowd];
        for (int body_i = 0; body_i < crowd; ++body_i) {
            const scalar ratio = std::pow(limits::inertia_ratio_max / 2, share(random));
            defs[body_i] = plain_body({});
            defs[body_i].mass.I_body = {ratio, 1, ratio};
            defs[body_i].state.L = ingot::scaled(defs[body_i].mass.I_body, direction() * (body_i % 2 == 0 ? 0 : power(-1, 5)));
            blows[body_i] = direction() * (ratio * power(-2, 2));
        }
        const auto play = [&](World<Crowd<TypeParam>>& stage, int first, int last, BodyId* ids) {
            clear(stage);
            for (int body_i = first; body_i <= last; ++body_i) {
                ids[body_i] = stage.add(defs[body_i]).value;
                (void)stage.add_torque(ids[body_i], blows[body_i]);
            }
            for (int step_i = 0; step_i < 20; ++step_i) (void)ingot::step(stage, h);
        };
        BodyId ids[crowd], lone_ids[crowd];
        play(world, 0, crowd - 1, ids);
        for (int body_i = 0; body_i < crowd; ++body_i) {
            play(alone, body_i, body_i, lone_ids);
            SCOPED_TRACE("round " + std::to_string(round_i) + ", body " + std::to_string(body_i));
            ASSERT_EQ(world.is_frozen(ids[body_i]), alone.is_frozen(lone_ids[body_i]));
            ASSERT_TRUE(same_bits(world.state(ids[body_i]).value, alone.state(lone_ids[body_i]).value));
        }
    }
}

/// What is allowed at the door is no reason to freeze: a body at rest in the last place that there is, along each axis.
TEST(Frozen, is_no_body_at_rest_at_the_limit) {
    static World<Crowd<ingot::MoserVeselov>> world;
    for (const Vector& r : {Vector{limits::position_max, 0, 0}, Vector{0, -limits::position_max, 0}, Vector{0, 0, limits::position_max}}) {
        clear(world);
        const BodyId id = world.add(plain_body(r)).value;
        for (int step_i = 0; step_i < 3; ++step_i) ASSERT_TRUE(ingot::step(world, h).clean());
        EXPECT_FALSE(world.is_frozen(id));
        const Vector now = world.state(id).value.r_CM;
        EXPECT_TRUE(now.x == r.x && now.y == r.y && now.z == r.z);
    }
}

#if !INGOT_DOUBLE
/// The digits of A that wait in A_low for the next step enter with that step's turn, or not at all: in no lane count does a
/// neighbour carry them in.
TEST(FrozenInFlight, body_keeps_the_pose_of_the_step_before) {
    static World<Crowd<ingot::MoserVeselov>> world;
    for (int steps = 1; steps <= 40; ++steps) {
        clear(world);
        BodyDef speck = plain_body({});
        speck.mass.I_body = Vector{1, 1, 1} * (2 * limits::inertia_min);
        speck.state.L = Vector{1, scalar(0.25), scalar(-0.5)} * (limits::inertia_min * 1000);
        const BodyId id = world.add(speck).value;
        for (int step_i = 0; step_i < steps; ++step_i) (void)ingot::step(world, h);
        const BodyState before = world.state(id).value;
        ASSERT_EQ(world.add_torque(id, {0, limits::torque_max, 0}), Status::ok);
        EXPECT_EQ(ingot::step(world, h).bodies_frozen, 1);
        const BodyState after = world.state(id).value;
        ASSERT_EQ(memcmp(&before.A, &after.A, sizeof after.A), 0) << "after " << steps << " steps";
    }
}
#endif

}  // namespace
