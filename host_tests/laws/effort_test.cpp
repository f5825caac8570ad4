// SPDX-License-Identifier: MIT
// Whatever effort a scene names, the laws of contact are the same; more of it is nearer to the exact motion.
#include <cmath>
#include <cstdio>
#include <vector>

#include "laws/thrown_bodies.h"
#include "reference/ball_and_brick.h"
#include "reference/brief_types.h"
#include "reference/draws.h"

namespace {

using namespace thrown_bodies;
using ingot::Status;

constexpr int rates[] = {30, 60, 120, 240, 1000};

template <class S>
class Efforts : public ::testing::Test {};
using Scenes = ingot_reference::BriefTypes<3, Room<ingot::BlockSweeps, false, 2, 3>, Room<ingot::SequentialImpulses, false, 8, 1>,
                                           Room<ingot::HybridIslands<8, 24>, false, 16, 1>, Room<ingot::BlockSweeps, false, 4, 2>,
                                           Room<ingot::BlockSweeps, false, 8, 6>, Room<ingot::BlockSweeps, false, 16, 16>,
                                           Room<ingot::SequentialImpulses, false, 2, 3>>;
TYPED_TEST_SUITE(Efforts, Scenes);

/// Among each other, without gravity, e and mu as they come.
TYPED_TEST(Efforts, give_no_energy) {
    if (TypeParam::solver::is_pointwise) GTEST_SKIP() << "not a law yet of sequential impulses: see every_solver_test";
    RandomInput random(81);
    double worst = 0;
    for (int case_i = 0; case_i < ingot_reference::draws(20); ++case_i) {
        const double e = case_i % 4 == 0 ? 1 : random.real(0, 1), mu = case_i % 2 == 0 ? 0 : random.real(0, 1), h = 1.0 / rates[case_i % 5];
        Thrown<TypeParam> thrown(0, {e, mu});
        close_room(thrown, 2);
        throw_forty(thrown, random);
        const double gain = largest_gain(thrown, h, rates[case_i % 5] > 500 ? 0.5 : 3);
        EXPECT_LE(gain, gain_of_step<TypeParam>) << "case " << case_i << " e " << e << " mu " << mu << " h " << h;
        worst = std::max(worst, gain);
    }
    printf("    largest gain of a step, of the energy %.3g, allowed %.3g\n", worst, gain_of_step<TypeParam>);
}

/// Dice in a tray lie there after 15 s: none is faster than gravity makes it in a substep, nor deeper in another by more than that is a way in one.
/// What is paid for them as usual, or more, has let them fall asleep, but for one tray in sixteen, where a die may rock on two others.
TYPED_TEST(Efforts, bring_dice_to_rest) {
    if (TypeParam::solver::is_pointwise) GTEST_SKIP() << "not a law yet: of the usual effort too, one tray in eight is awake after 15 s at 30 Hz";
    constexpr ingot::Effort effort = TypeParam::effort;
    int asleep = 0, trays = ingot_reference::draws(16);
    for (int seed = 0; seed < trays; ++seed) {
        RandomInput random(static_cast<uint32_t>(300 + seed));
        const double h = 1.0 / rates[seed % 4], fall = 9.81 * h / effort.substeps;
        Thrown<TypeParam> dice(9.81, {random.real(0, 0.5), random.real(0.3, 0.9)});
        drop_dice(dice, 42, random);
        for (double t = 0; t < 15 && dice.world->awake_count() > 0; t += h) (void)ingot::step(*dice.world, scalar(h));
        asleep += dice.world->awake_count() == 0 ? 1 : 0;
        double fastest = 0, deepest = 0;
        for (int i = 5; i < 47; ++i)
            fastest = std::max(fastest, to_eigen(dice.world->state(dice.world->body_at(i)).value.v_CM).norm());
        for (const ingot::ContactInfo& contact : dice.world->contacts()) deepest = std::max(deepest, -static_cast<double>(contact.separation));
        EXPECT_LE(fastest, fall) << "seed " << seed << ", step " << h;
        EXPECT_LE(deepest, static_cast<double>(ingot::limits::touching_gap) + fall * h / effort.substeps) << "seed " << seed << ", step " << h;
    }
    printf("    asleep: %d of %d\n", asleep, trays);
    if (effort.substeps * effort.sweeps >= ingot::limits::substeps * ingot::limits::sweeps) {
        EXPECT_GE(16 * asleep, 15 * trays);
    }
}

/// Walls of 45 bricks that shake, 40 m apart and in turn in the slots; one of them may be left out.
template <class S>
std::vector<ingot::BodyState> states_of_wall(bool first, bool second, int which, double h, uint32_t seed) {
    RandomInput random(seed);
    Thrown<S> walls(9.81, {random.real(0, 0.5), 0.5});
    walls.wall({0, 1, 0}, 0);
    std::vector<ingot::BodyId> of_wall;
    for (int layer = 0; layer < 9; ++layer)
        for (int i = 0; i < 2 * (9 - layer); ++i) {
            const int wall = i % 2;
            const Vector3d aside = any_vector(0.02, random).cwiseProduct(Vector3d(1, 0, 1)), v = any_vector(0.3, random);
            const double spin = random.real(-0.5, 0.5);
            if (wall == 0 ? !first : !second) continue;
            BodyDef def = ingot_reference::definition(20, Vector3d::Constant(20 * 0.16 / 6));
            def.shape = ingot::Box{{scalar(0.2), scalar(0.2), scalar(0.2)}};
            def.friction = scalar(0.5);
            def.state.r_CM = ingot_reference::to_vector((Vector3d(0.44 * (i / 2 + 0.5 * layer) + 40 * wall, 0.2 + 0.4 * layer, 0) + aside).eval());
            def.state.v_CM = ingot_reference::to_vector(v);
            def.state.L = {0, scalar(spin), 0};
            const auto added = walls.world->add(def);
            EXPECT_TRUE(added.ok());
            if (wall == which) of_wall.push_back(added.value);
        }
    int least = 1 << 16;
    for (double t = 0; t < 1.5; t += h) least = std::min(least, int{ingot::step(*walls.world, scalar(h)).contacts});
    EXPECT_GT(least, ingot::limits::small_island * (first + second)) << "too few to be swept as many are";
    std::vector<ingot::BodyState> states;
    for (const ingot::BodyId id : of_wall) states.push_back(walls.world->state(id).value);
    return states;
}

/// Substeps, sweeps and which way they go are each island's own: a wall moves alone as beside another.
TYPED_TEST(Efforts, are_the_same_in_company) {
    for (int case_i = 0; case_i < ingot_reference::draws(4); ++case_i)
        for (const int which : {0, 1}) {
            const double h = 1.0 / rates[case_i % 4];
            const auto seed = static_cast<uint32_t>(700 + 50 * case_i);
            const auto alone = states_of_wall<TypeParam>(which == 0, which == 1, which, h, seed);
            const auto together = states_of_wall<TypeParam>(true, true, which, h, seed);
            ASSERT_EQ(alone.size(), together.size());
            for (std::size_t i = 0; i < alone.size(); ++i) {
                EXPECT_EQ(to_eigen(alone[i].r_CM), to_eigen(together[i].r_CM)) << "case " << case_i << " body " << i;
                EXPECT_EQ(to_eigen(alone[i].L), to_eigen(together[i].L)) << "case " << case_i << " body " << i;
            }
        }
}

/// Impulses are told of the whole step, however many substeps it has.
TYPED_TEST(Efforts, carry_the_weight_of_what_rests) {
    for (const int rate : rates) {
        const double h = 1.0 / rate;
        Thrown<TypeParam> column(9.81, {0, 0.5});
        column.wall({0, 1, 0}, 0);
        double weight = 0;
        for (int i = 0; i < 3; ++i) {
            BodyDef def = ingot_reference::definition(1 + i, Vector3d::Constant(1.0 / 6));
            def.shape = ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}};
            def.friction = scalar(0.5);
            def.state.r_CM = {0, scalar(0.5 + i), 0};
            ASSERT_EQ(column.world->add(def).status, Status::ok);
            weight += 9.81 * (1 + i);
        }
        for (int step_i = 0; step_i < rate / 3; ++step_i) ASSERT_EQ(ingot::step(*column.world, scalar(h)).status, Status::ok);
        double of_ground = 0;
        for (const ingot::ContactInfo& contact : column.world->contacts_of(column.world->body_at(0))) of_ground += static_cast<double>(contact.j);
        EXPECT_NEAR(of_ground / h, weight, 1e-5 * weight) << rate;
    }
}

template <int substeps>
struct Slope : ingot::Scene {
    static constexpr int max_bodies = 2, max_manifolds = 2;
    static constexpr bool translates = true;
    static constexpr ingot::Effort effort = {substeps, 3};
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};

/// m, the furthest that bricks which slide up a slope and down again are off after two seconds. They turn round within a substep.
template <int substeps>
double way_off() {
    constexpr int bricks = 64;
    RandomInput random(91);
    double most = 0;
    for (int i = 0; i < bricks; ++i) {
        const double alpha = random.real(0.3, 0.6), mu = random.real(0.1, 0.8) * std::tan(alpha), v_0 = -random.real(1, 4), g = 9.8125, h = 1.0 / 60;
        ingot::World<Slope<substeps>> world;
        EXPECT_EQ(world.set_gravity({scalar(g * std::sin(alpha)), 0, scalar(-g * std::cos(alpha))}), Status::ok);
        BodyDef ground;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        ground.friction = scalar(mu);
        EXPECT_TRUE(world.add(ground).ok());
        BodyDef brick = ingot_reference::definition(2, Vector3d(0.2, 0.4, 0.4));
        brick.shape = ingot::Box{{1, scalar(0.5), scalar(0.1)}};
        brick.friction = scalar(mu);
        brick.state.r_CM = {0, 0, scalar(0.1)};
        brick.state.v_CM = {scalar(v_0), 0, 0};
        const auto id = world.add(brick);
        EXPECT_TRUE(id.ok());
        for (int step_i = 0; step_i < 120; ++step_i) (void)ingot::step(world, scalar(h));
        using Real = long double;
        const ingot_reference::BrickOnIncline exact(static_cast<Real>(g), static_cast<Real>(mu), std::sin(static_cast<Real>(alpha)),
                                                    std::cos(static_cast<Real>(alpha)), static_cast<Real>(v_0));
        most = std::max(most, std::abs(static_cast<double>(world.state(id.value).value.r_CM.x) - static_cast<double>(exact.at(2).s)));
    }
    printf("    %d substeps: %.3g mm\n", substeps, 1e3 * most);
    return most;
}

/// However few substeps there are, what slides up a slope and down again goes the exact way: it turns round within a substep. What is left is the
/// speed below which a slip is not split, and the rounding of a speed of 4 m/s in each substep of 120 steps.
TEST(Effort, of_few_substeps_goes_the_exact_way_up_a_slope_and_back) {
    const auto allowed = [](int substeps) {
        return 2 * (2 * static_cast<double>(ingot::limits::reversal_speed) + 120 * substeps * 4 * static_cast<double>(ingot::epsilon));
    };
    EXPECT_LE(way_off<2>(), allowed(2));
    EXPECT_LE(way_off<8>(), allowed(8));
}

}  // namespace
