// SPDX-License-Identifier: MIT
// Movers on floors and along walls of hulls, and around what is round. Not in brief: it is a scene more to compile.
#include <gtest/gtest.h>

#include "course.h"

namespace {

using namespace mover_test;

constexpr scalar half = scalar(0.5);
constexpr auto cube = ingot::convex_hull<8>({{-half, -half, -half}, {half, -half, -half}, {-half, half, -half}, {half, half, -half},
                                             {-half, -half, half}, {half, -half, half}, {-half, half, half}, {half, half, half}});
static_assert(cube.ok());

struct OfHulls : ingot::Scene {
    static constexpr int max_bodies = 250, max_manifolds = 250;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Hull, ingot::Cylinder>;
    static constexpr ingot::ConvexHull hulls[] = {cube.value.view()};
};

void add_cube(World<OfHulls>& world, int x, int y, double z) {
    BodyDef def;
    def.immovable = true;
    def.shape = ingot::hull_of<OfHulls>(0);
    def.state.r_CM = {static_cast<scalar>(x), static_cast<scalar>(y), static_cast<scalar>(z)};
    ASSERT_TRUE(world.add(def).ok());
}
/// A floor of 13 by 13 cubes, and a wall on it at y = 4.5.
World<OfHulls>& courtyard() {
    auto& world = empty_world<OfHulls>();
    for (int x = -6; x <= 6; ++x) {
        for (int y = -6; y <= 6; ++y) add_cube(world, x, y, -0.5);
        for (int z = 0; z < 2; ++z) add_cube(world, x, 5, z + 0.5);
    }
    return world;
}

TEST(MoverOnHulls, goes_as_on_one_slab) {
    auto& world = courtyard();
    level_test::Random random(3);
    for (int way = 0; way < 60; ++way) {
        const V begin{within(random, -1, 1), within(random, -1, 1), 0};
        Mover mover = standing_at(world, begin.x(), begin.y(), 0);
        const double angle = within(random, 0, 6.28), speed = about(random, 0.5, 8);
        const MoverInput input = {{static_cast<scalar>(speed * std::cos(angle)), static_cast<scalar>(speed * std::sin(angle)), 0}, 0};
        const V from = exact(mover.r);
        const int steps = static_cast<int>(3 / speed * 120);
        for (int i = 0; i < steps; ++i) {
            ASSERT_EQ(world.move(mover, input, scalar(1) / 120), Status::ok);
            ASSERT_TRUE(stands(mover));
            ASSERT_NEAR(static_cast<double>(mover.r.z), 0.91, 1e-4);
        }
        const V by = exact(mover.r) - from, wanted = exact(input.v) * (steps / 120.0);
        EXPECT_LT((by - wanted).head(2).norm(), 1e-4 * wanted.norm()) << way;
    }
}

TEST(MoverOnHulls, slides_along_a_wall_of_them_and_around_a_column) {
    auto& world = courtyard();
    Mover mover = standing_at(world, -4, 4, 0);
    for (int i = 0; i < 30; ++i) ASSERT_EQ(world.move(mover, {{1, 2, 0}, 0}, scalar(1) / 60), Status::ok);
    const double x = static_cast<double>(mover.r.x);
    for (int i = 0; i < 120; ++i) ASSERT_EQ(world.move(mover, {{1, 2, 0}, 0}, scalar(1) / 60), Status::ok);
    EXPECT_NEAR(static_cast<double>(mover.r.x) - x, 2, 2e-3);
    EXPECT_NEAR(static_cast<double>(mover.r.y), 4.5 - 0.31, 1e-4);

    BodyDef column;
    column.immovable = true;
    column.shape = ingot::Cylinder{half, 2};
    column.state.r_CM = {2, 0, 2};
    ASSERT_TRUE(world.add(column).ok());
    mover = standing_at(world, 0, 0.1, 0);
    double gap = 1;
    for (int i = 0; i < 200; ++i) {
        ASSERT_EQ(world.move(mover, {{2, 0, 0}, 0}, scalar(1) / 60), Status::ok);
        gap = std::min(gap, std::hypot(static_cast<double>(mover.r.x) - 2, static_cast<double>(mover.r.y)) - 0.8);
    }
    EXPECT_GT(static_cast<double>(mover.r.x), 4) << "it gets around";
    EXPECT_NEAR(gap, 0.01, 1.5e-3);
}

}  // namespace
