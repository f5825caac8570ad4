// SPDX-License-Identifier: MIT
// Movers that are put below hills: they come out on the right side at once, whatever is beside.
#include <gtest/gtest.h>

#include "course.h"

namespace {

using namespace mover_test;
using ingot_reference::draws;

/// Hills of a mesh or a field, up to 70 degrees steep; the first level of the street as long as they last.
struct Hills {
    static constexpr int n = 24;
    std::vector<uint16_t> heights = std::vector<uint16_t>((n + 1) * (n + 1));
    level_tool::MeshData mesh;
    ingot::Result<ingot::HeightFieldOf<n + 1, n + 1>> field{};

    Hills(level_test::Random& random, bool as_mesh) {
        const double rough = about(random, 20, 2500);  // m / 1024, over cells of 1 m
        for (uint16_t& height : heights) height = static_cast<uint16_t>(within(random, 0, rough));
        const auto& samples = *reinterpret_cast<const uint16_t(*)[(n + 1) * (n + 1)]>(heights.data());
        field = ingot::height_field_of<n + 1, n + 1, (n + 1) * (n + 1)>(samples, 1, 1, scalar(1) / 1024);
        EXPECT_TRUE(field.ok());
        const auto height_at = [this](int column, int row) { return heights[static_cast<size_t>(row * (n + 1) + column)]; };
        if (as_mesh) mesh = level_test::built(level_test::terrain(random, n, 1024, height_at));
        Street::levels[0] = as_mesh ? mesh.view : field.value.view();
    }
    Hills(const Hills&) = delete;
    Hills& operator=(const Hills&) = delete;
};

/// m, of the ground at x, y.
double ground_at(double x, double y) {
    double height = -1e9;
    const auto at = [&](scalar z) { return Vector{static_cast<scalar>(x), static_cast<scalar>(y), z}; };
    ingot::for_triangles_in(Street::levels[0], at(-100), at(100), [&](const ingot::LevelTriangle& triangle) {
        const Exact a = in_double(triangle.corners[0]), b = in_double(triangle.corners[1]), c = in_double(triangle.corners[2]);
        const auto inside = [&](const Exact& p, const Exact& q) { return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x) >= -1e-9; };
        const Exact n = cross(b - a, c - a);
        if (inside(a, b) && inside(b, c) && inside(c, a)) height = std::max(height, a.z - (n.x * (x - a.x) + n.y * (y - a.y)) / n.z);
    });
    return height;
}

scalar least_gap(World<Street>& world, const Mover& mover) {
    ingot::MoverPlane planes[ingot::movers::planes_max];
    const auto count = world.collide_mover(mover, planes);
    EXPECT_TRUE(count.ok());
    scalar least = 0;
    for (int k = 0; k < count.value; ++k) least = std::min(least, planes[k].gap);
    return least;
}

/// Above the ground with its axis, all along, and in nothing with its skin.
bool is_out(World<Street>& world, const Mover& mover) {
    for (const double t : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        const V p = exact(mover.r + mover.up * mover.capsule.half_length * static_cast<scalar>(t));
        if (!(p.z() > ground_at(p.x(), p.y()))) return false;
    }
    return least_gap(world, mover) >= -mover.skin / 64;
}

Mover drawn_mover(level_test::Random& random, bool upright) {
    Mover mover;
    if (random() % 2 == 0) mover.capsule = {static_cast<scalar>(about(random, 0.1, 0.5)), static_cast<scalar>(about(random, 0.1, 1))};
    const double tilt = !upright && random() % 3 == 0 ? within(random, 0, pi) : 0, around = within(random, 0, 2 * pi);
    mover.up = rounded(V(std::sin(tilt) * std::cos(around), std::sin(tilt) * std::sin(around), std::cos(tilt)).normalized());
    // It may have stood before it was put there.
    if (random() % 2 == 0) mover.ground = {MoverFooting::walkable, {}, 0, {0, 0, 1}, {}, {}};
    return mover;
}

/// A push is as far as its radius. So it is out after as many moves as it was radii deep, one that lands, and some more where a valley bends its way.
/// It goes no further than up out of it and beside what it meets there, and none of it becomes speed.
TEST(MoverBelowHills, comes_out_as_fast_as_it_may) {
    constexpr int more = 6;
    int deep = 0;
    for (int draw = 0; draw < draws(2000); ++draw) {
        level_test::Random random(static_cast<uint64_t>(draw));
        auto& world = empty_world<Street>();
        if (random() % 2 == 0) {
            ASSERT_EQ(world.set_gravity({0, 0, 0}), Status::ok);
        }
        const bool as_mesh = draw % 2 == 0;
        const Hills hills(random, as_mesh);
        ASSERT_TRUE(world.add_level({}).ok());
        Mover mover = drawn_mover(random, as_mesh);
        const double radius = static_cast<double>(mover.capsule.radius), half = static_cast<double>(mover.capsule.half_length);
        const double reach = half * std::abs(static_cast<double>(mover.up.z)) + radius, size = 2 * (half + radius);
        const double x = within(random, 6, 18), y = within(random, 6, 18), depth = within(random, 0, 2 * reach);
        mover.r = rounded(V(x, y, ground_at(x, y) + reach - depth));
        const V from = exact(mover.r);
        deep += depth > reach + radius ? 1 : 0;
        int moves = 0;
        for (; moves < 400 && !is_out(world, mover); ++moves) {
            const V before = exact(mover.r);
            ASSERT_EQ(world.move(mover, {}, scalar(1) / 60), Status::ok);
            EXPECT_LT((exact(mover.r) - before).norm(), ingot::movers::slides_max * (radius + 0.01)) << draw;
        }
        EXPECT_LE(moves, depth / radius + more) << draw << (as_mesh ? " mesh" : " field");
        EXPECT_LT((exact(mover.r) - from).norm(), depth + size) << draw << (as_mesh ? " mesh" : " field");
    }
    EXPECT_GT(deep, draws(2000) / 8);
}

/// Boxes beside and above: it never comes into them, whether or not they leave it a way out.
TEST(MoverBelowHills, passes_through_nothing_on_its_way_out) {
    int met = 0, out = 0;
    for (int draw = 0; draw < draws(1000); ++draw) {
        level_test::Random random(static_cast<uint64_t>(draw));
        auto& world = empty_world<Street>();
        const Hills hills(random, draw % 2 == 0);
        ASSERT_TRUE(world.add_level({}).ok());
        Mover mover = drawn_mover(random, true);
        const double reach = static_cast<double>(mover.capsule.half_length + mover.capsule.radius);
        const double x = within(random, 6, 18), y = within(random, 6, 18), depth = within(random, 0, 2 * reach);
        mover.r = rounded(V(x, y, ground_at(x, y) + reach - depth));
        std::vector<Block> blocks;
        for (int i = 0; i < 6; ++i) {
            const V half{about(random, 0.05, 1), about(random, 0.05, 1), about(random, 0.05, 1)}, middle = exact(mover.r);
            const V r = middle + V(within(random, -1, 1), within(random, -1, 1), within(random, -0.5, 2.5));
            const Block block = {-half, half, ingot::identity_matrix<scalar>(), exact(rounded(r))};
            if (gap_to(mover, block) > 0.015) blocks.push_back(block);
        }
        add_as_boxes(world, blocks);
        double least = 1;
        for (int i = 0; i < 40; ++i) {
            ASSERT_EQ(world.move(mover, {}, scalar(1) / 60), Status::ok);
            for (const Block& block : blocks) least = std::min(least, gap_to(mover, block));
        }
        met += least < 0.015 ? 1 : 0;
        out += is_out(world, mover) ? 1 : 0;
        EXPECT_GT(least, 0) << draw << (draw % 2 == 0 ? " mesh" : " field");
    }
    EXPECT_GT(met, draws(1000) / 10);
    EXPECT_GT(out, draws(1000) / 2);
}

/// Who is all behind a mesh, and does not touch it, meets nothing of it: not where it is, nor on its way.
TEST(MoverBelowHills, of_a_mesh_that_it_does_not_touch_meets_nothing) {
    for (int draw = 0; draw < draws(200); ++draw) {
        level_test::Random random(static_cast<uint64_t>(draw));
        auto& world = empty_world<Street>();
        const Hills hills(random, true);
        ASSERT_TRUE(world.add_level({}).ok());
        Mover mover = drawn_mover(random, true);
        mover.ground = {};
        const double reach = static_cast<double>(mover.capsule.half_length + mover.capsule.radius);
        mover.r = rounded(V(within(random, 6, 18), within(random, 6, 18), -reach - 0.02));
        EXPECT_EQ(least_gap(world, mover), 0) << draw;
        const Vector from = mover.r, v = {static_cast<scalar>(within(random, -3, 3)), static_cast<scalar>(within(random, -3, 3)), 0};
        mover.v = v;
        ASSERT_EQ(world.move(mover, {v}, scalar(1) / 64), Status::ok);
        EXPECT_LT((exact(mover.r) - exact(from) - exact(v) / 64).head(2).norm(), 1e-5) << draw;
    }
}

}  // namespace
