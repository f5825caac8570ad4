// SPDX-License-Identifier: MIT
// Queries that go through the tree answer what those answer that look at all bodies.
#include "query/twins.h"
#include "reference/brief_types.h"
#include "reference/draws.h"

using namespace query_twins;
using ingot_reference::draws;

namespace {

template <int bodies, int shapes_of_body, bool sleepy, bool follows, class Search = ingot::AllPairs>
using Two = Twins<Yard<Search, bodies, shapes_of_body, sleepy, follows>, Yard<ingot::QueryTree, bodies, shapes_of_body, sleepy, follows>>;

template <class Worlds>
class QueriesByTree : public ::testing::Test {};
using Kinds = ingot_reference::BriefTypes<2, Two<60, 1, true, true>, Two<40, 3, false, false>, Two<60, 1, false, false>, Two<40, 3, true, false>>;
TYPED_TEST_SUITE(QueriesByTree, Kinds);

constexpr Cloud clouds[] = {{10, 0.2, 2}, {30, 0.01, 100}, {2e4, 0.5, 20}, {0.5, 0.01, 0.1}};

/// What the worlds of several lives were asked to do, and would not.
struct Edits {
    int asked = 0, refused = 0;
    ~Edits() { EXPECT_LT(refused, asked / 2) << "most edits are edits"; }
};

/// A life of edits, steps and snapshots, with queries at any time: before the first step too, and between two edits.
template <class Worlds>
void expect_same_life(std::uint64_t seed, const Cloud& cloud, int turns, int first_bodies, int queries, Edits& edits_of_all) {
    Worlds twins(seed, cloud);
    EXPECT_EQ(twins.all->set_gravity({0, 0, -10}), Status::ok);
    EXPECT_EQ(twins.tree->set_gravity({0, 0, -10}), Status::ok);
    for (int body_i = 0; body_i < first_bodies; ++body_i) twins.add();
    for (int turn_i = 0; turn_i < turns; ++turn_i) {
        for (int query_i = 0; query_i < queries; ++query_i) twins.ask();
        if (::testing::Test::HasFailure()) FAIL() << "seed " << seed << " turn " << turn_i;
        const int edits = twins.random.integer(0, 1) == 0 ? 0 : twins.random.integer(1, 4);
        for (int edit_i = 0; edit_i < edits; ++edit_i) {
            twins.edit();
            twins.ask();
        }
        if (twins.random.integer(0, 3) != 0) twins.step();
        if (twins.random.integer(0, 29) == 0) twins.reload();
        if (::testing::Test::HasFailure()) FAIL() << "seed " << seed << " after turn " << turn_i;
    }
    EXPECT_GT(twins.answered, turns);
    edits_of_all.asked += twins.edits;
    edits_of_all.refused += twins.refused;
}

TYPED_TEST(QueriesByTree, are_the_same_whatever_is_done_to_bodies) {
    Edits edits;
    for (int seed = 1; seed <= draws(96); ++seed) {
        const int first_bodies = (1 + seed % 12) * TypeParam::All::max_bodies / 16;
        expect_same_life<TypeParam>(static_cast<std::uint64_t>(seed), clouds[seed % 4], 60, first_bodies, 8, edits);
        if (this->HasFatalFailure()) return;
    }
}

/// Where a scene has many bodies, and the linear search goes by a tree of pairs that is not kept for it.
using Many = Two<4000, 1, false, false, ingot::SortedTree>;
using ManyAsleep = Two<1500, 3, true, false, ingot::SortedTree>;

TEST(QueriesOfManyByTree, are_the_same_whatever_is_done_to_bodies) {
    Edits edits;
    expect_same_life<Many>(101, {60, 0.05, 1.5}, draws(12), 3600, draws(120), edits);
    expect_same_life<Many>(102, {300, 0.01, 100}, draws(4), 1000, draws(120), edits);
    expect_same_life<ManyAsleep>(103, {60, 0.05, 1.5}, draws(20), 1200, draws(60), edits);
}

using OneOfMany = Yard<ingot::QueryTree, 4000, 1, false, false>;  // a world that is there already: another one is seconds of a compiler

/// Ground that is tilted by so little that its normal has a 1 in it, and the length 1: a kilometre away it is higher than where it is level.
TEST(TreeOfQueries, meets_tilted_ground_far_away) {
    constexpr bool is_double = sizeof(scalar) == sizeof(double);
    const scalar tilt = is_double ? scalar(1e-9) : scalar(1) / 8192, away = is_double ? scalar(5e8) : scalar(4096), height = tilt * away;
    using S = OneOfMany;
    auto world = std::make_unique<World<S>>();
    const BodyId ground = world->add(body_of({ingot::HalfSpace{{tilt, 0, 1}, 0}, {}, ingot::identity_matrix<scalar>(), nullptr})).value;
    for (int i = 0; i < 30; ++i)
        ASSERT_TRUE(world->add(body_of({ingot::Sphere{1}, {scalar(3 * i), 0, 5}, ingot::identity_matrix<scalar>(), nullptr})).ok());
    ASSERT_EQ(ingot::step(*world, scalar(1) / 60).status, Status::ok);
    const Vector above = {-away, 0, 10 * height};
    const QueryHit hit = world->cast_ray(above, {0, 0, scalar(-9.5) * height}).value;  // it ends above where the ground is level
    EXPECT_EQ(hit.body, ground);
    EXPECT_NEAR(static_cast<double>(hit.P.z), static_cast<double>(height), 1e-3 * static_cast<double>(height));
    EXPECT_EQ(world->find_nearest(above, scalar(9.5) * height).value.body, ground);
}

/// A body that leaves its fat AABB within a step is found where it is at its end.
TEST(TreeOfQueries, finds_what_a_step_has_thrown) {
    using S = OneOfMany;
    auto world = std::make_unique<World<S>>();
    std::vector<BodyId> balls;
    for (int i = 0; i < 30; ++i)
        balls.push_back(world->add(body_of({ingot::Sphere{1}, {scalar(4 * i), 0, 0}, ingot::identity_matrix<scalar>(), nullptr})).value);
    const scalar h = scalar(1) / 64;
    ASSERT_EQ(ingot::step(*world, h).status, Status::ok);
    for (const BodyId ball : balls) ASSERT_EQ(world->add_central_force(ball, {0, 0, 64 * 64 * 20}), Status::ok);
    ASSERT_EQ(ingot::step(*world, h).status, Status::ok);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const ingot::Vector r = world->state(balls[i]).value.r_CM;
        ASSERT_GT(r.z, 9) << "far beyond what its fat AABB was";
        const QueryHit hit = world->cast_ray({r.x - 2, 0, r.z}, {4, 0, 0}).value;
        EXPECT_EQ(hit.body, balls[i]);
        EXPECT_FALSE(world->cast_ray({r.x - 2, 0, 0}, {4, 0, 0}).value.found()) << "nor where it was";
    }
}

}  // namespace
