// SPDX-License-Identifier: MIT
// for_triangles_in tells what all triangles, looked at one by one, would.
#include <gtest/gtest.h>
#include <ingot/level/level_walk.h>

#include <cmath>
#include <set>

#include "fields.h"

namespace {

using namespace level_test;
using ingot::LevelTriangle;
using ingot::scalar;
using ingot::Vector;

bool boxes_meet(const ingot::LevelTable& level, const LevelTriangle& t, const Vector& low, const Vector& high) {
    const Vector least = min(min(t.corners[0], t.corners[1]), t.corners[2]), most = max(max(t.corners[0], t.corners[1]), t.corners[2]);
    const bool reaches_down = !level.is_mesh();
    return least.x <= high.x && least.y <= high.y && (reaches_down || least.z <= high.z) && most.x >= low.x && most.y >= low.y && most.z >= low.z;
}

std::set<uint32_t> told_in(const ingot::LevelTable& level, const Vector& low, const Vector& high) {
    std::set<uint32_t> numbers;
    for_triangles_in(level, low, high, [&](const LevelTriangle& t) { EXPECT_TRUE(numbers.insert(t.number).second) << "told twice"; });
    return numbers;
}
std::set<uint32_t> all_in(const ingot::LevelTable& level, const std::vector<LevelTriangle>& all, const Vector& low, const Vector& high) {
    std::set<uint32_t> numbers;
    for (const LevelTriangle& t : all)
        if (boxes_meet(level, t, low, high)) numbers.insert(t.number);
    return numbers;
}

/// A place in or about the level, often where a corner of it is to the bit, or next to one.
scalar draw_place(Random& random, scalar low, scalar high, scalar corner) {
    const auto share = static_cast<scalar>(random() % 1024) / 1024;
    switch (random() % 4) {
        case 0: return corner;
        case 1: return std::nextafter(corner, scalar(1e9));
        case 2: return std::nextafter(corner, scalar(-1e9));
        default: return low + (high - low) * (share * scalar(1.25) - scalar(0.125));
    }
}

/// How many triangles were told in all.
size_t expect_walk_equals_all(const ingot::LevelTable& level, Random& random, int boxes) {
    std::vector<LevelTriangle> all;
    for (const uint32_t number : triangles_of(level)) all.push_back(triangle_of(level, number));
    EXPECT_FALSE(all.empty());
    if (all.empty()) return 0;
    size_t told = 0;
    for (int i = 0; i < boxes && !testing::Test::HasFailure(); ++i) {
        const Vector corner = all[random() % all.size()].corners[random() % 3];
        const Vector low{draw_place(random, level.low.x, level.high.x, corner.x), draw_place(random, level.low.y, level.high.y, corner.y),
                         draw_place(random, level.low.z, level.high.z, corner.z)};
        const scalar size = static_cast<scalar>(random() % 64) / (random() % 2 == 0 ? 128 : 4096);
        const Vector high = random() % 8 == 0 ? low : low + (level.high - level.low) * size;
        const std::set<uint32_t> met = told_in(level, low, high);
        EXPECT_EQ(met, all_in(level, all, low, high)) << "box " << i;
        told += met.size();
    }
    return told;
}

TEST(LevelWalk, tells_all_triangles_of_a_mesh_that_a_box_meets_and_no_other) {
    Random random(15);
    EXPECT_GT(expect_walk_equals_all(built(loose_triangles(random, 1, 65535, 65535)).view, random, 2000), 500);
    for (int round = 0; round < 6; ++round) {
        const int extent = round % 2 == 0 ? 65535 : 3000, size = round % 3 == 0 ? extent : extent / 20;
        const level_tool::MeshData mesh =
            built(loose_triangles(random, 100 << round % 3, extent, size), scalar(1) / 1024, 1 << round, -5000, 8000000);
        EXPECT_GT(expect_walk_equals_all(mesh.view, random, 2000), 2000);
    }
    const level_tool::MeshData hills = built(terrain(random, 24, 100, [&](int, int) { return between(random, 0, 400); }));
    EXPECT_GT(expect_walk_equals_all(hills.view, random, 2000), 2000);
    EXPECT_GT(expect_walk_equals_all(built(slivers(80, true)).view, random, 2000), 2000);
    EXPECT_GT(expect_walk_equals_all(built(slivers(80, false)).view, random, 2000), 2000);
    EXPECT_GT(expect_walk_equals_all(built(village(random, 6)).view, random, 2000), 2000);
}

TEST(LevelWalk, tells_all_triangles_of_a_field_that_a_box_meets_or_is_below_and_no_other) {
    Random random(16);
    for (int round = 0; round < 8; ++round) {
        const int columns = round == 0 ? 2 : between(random, 2, 70), rows = round == 1 ? 2 : between(random, 2, 40);
        const int most = round % 2 == 0 ? 65535 : 600;
        Field hills = field(random, columns, rows, round % 4 < 2, round < 4 ? 0 : 3, [&](int, int) { return between(random, 0, most); });
        if (round % 2 == 1) {
            hills.view.heights.spacing_x = static_cast<scalar>(between(random, 1, 999)) / 700;
            hills.view.heights.spacing_y = static_cast<scalar>(between(random, 1, 999)) / 700;
            finish_heights(hills, columns, rows);
        }
        expect_walk_equals_all(hills.view, random, 2000);
    }
    // A field of nothing but holes, one of nothing but cliffs, and one that is long.
    const Field nothing = field(random, 20, 20, false, 1, [](int, int) { return 0; });
    EXPECT_TRUE(told_in(nothing.view, nothing.view.low, nothing.view.high).empty());
    const Field cliffs = field(random, 30, 30, true, 0, [](int column, int row) { return (column + row) % 2 * 65535; });
    EXPECT_GT(expect_walk_equals_all(cliffs.view, random, 2000), 2000);
    Field in_bytes = field(random, 33, 40, false, 5, [&](int, int) { return between(random, 0, 60000); });
    (void)level_tool::put_into_bytes(in_bytes, 33, 40);
    finish_heights(in_bytes, 33, 40);
    EXPECT_GT(expect_walk_equals_all(in_bytes.view, random, 2000), 2000);
    const Field wall = field(random, 3000, 2, false, 0, [&](int, int) { return between(random, 0, 900); });
    EXPECT_GT(expect_walk_equals_all(wall.view, random, 200), 200);
}

TEST(LevelWalk, tells_nothing_of_a_level_that_is_none) {
    Random random(49);
    const level_tool::MeshData mesh = built(village(random, 3));
    const Field hills = field(random, 9, 9, false, 0, [](int column, int row) { return column * row; });
    ingot::LevelTable no_node = mesh.view, no_row = hills.view, no_column = hills.view;
    no_node.mesh.node_count = 0;
    no_row.heights.rows = 1;
    no_column.heights.columns = 1;
    for (const ingot::LevelTable& none : {ingot::LevelTable{}, no_node, no_row, no_column}) {
        EXPECT_TRUE(told_in(none, {-infinity, -infinity, -infinity}, {infinity, infinity, infinity}).empty());
        ingot::LevelHit hit{};
        EXPECT_FALSE(cast_ray_on_level(none, none.middle() + Vector{0, 0, 100}, {0, 0, -200}, hit));
    }
    EXPECT_EQ(triangle_of(mesh.view, mesh.view.mesh.triangle_count).edges, LevelTriangle{}.edges);
    EXPECT_EQ(length_sq(triangle_of(hills.view, 2 * 8 * 8).corners[1]), 0);
}

TEST(LevelWalk, tells_nothing_of_a_box_that_is_none) {
    Random random(17);
    const level_tool::MeshData mesh = built(village(random, 3));
    const Field hills = field(random, 9, 9, false, 0, [](int column, int row) { return column * row; });
    for (const ingot::LevelTable* level : {&mesh.view, &hills.view}) {
        const size_t all = told_in(*level, {-infinity, -infinity, -infinity}, {infinity, infinity, infinity}).size();
        EXPECT_EQ(all, triangles_of(*level).size());
        EXPECT_EQ(told_in(*level, {-scalar(1e30), -scalar(1e9), -scalar(1e20)}, {scalar(1e30), scalar(1e9), scalar(1e9)}).size(), all);
        for (int axis = 0; axis < 6; ++axis) {
            scalar places[6] = {-infinity, -infinity, -infinity, infinity, infinity, infinity};
            places[axis] = not_a_number;
            EXPECT_TRUE(told_in(*level, {places[0], places[1], places[2]}, {places[3], places[4], places[5]}).empty());
            places[axis] = axis < 3 ? infinity : -infinity;
            const bool is_below_ground = axis == 5 && !level->is_mesh();
            if (!is_below_ground) {
                EXPECT_TRUE(told_in(*level, {places[0], places[1], places[2]}, {places[3], places[4], places[5]}).empty());
            }
        }
        EXPECT_TRUE(told_in(*level, level->high, level->low).empty());
    }
}

/// Edges of a field, and of the same ground as a mesh: the integers say the same as orient3d of the triangles.
TEST(LevelWalk, edges_are_what_the_triangles_beside_them_make_them) {
    Random random(18);
    for (int round = 0; round < 8; ++round) {
        const Field hills = field(random, 12, 9, round % 2 == 0, round < 4 ? 0 : 4, [&](int, int) { return between(random, 0, 3) * 256; });
        std::vector<LevelTriangle> all;
        for (const uint32_t number : triangles_of(hills.view)) all.push_back(triangle_of(hills.view, number));
        for (const LevelTriangle& t : all) {
            for (int i = 0; i < 3; ++i) {
                const Vector &a = t.corners[i], &b = t.corners[(i + 1) % 3];
                ingot::EdgeKind expected = ingot::EdgeKind::border;
                for (const LevelTriangle& other : all)
                    for (int k = 0; k < 3; ++k) {
                        const Vector &from = other.corners[k], &to = other.corners[(k + 1) % 3], &far = other.corners[(k + 2) % 3];
                        if (from.x != b.x || from.y != b.y || to.x != a.x || to.y != a.y) continue;
                        const Vector area = cross(b - a, t.corners[(i + 2) % 3] - a);
                        const double height = static_cast<double>(dot(area, far - a)) / static_cast<double>(std::sqrt(dot(area, area)));
                        // The heights here are whole units: less than a hundredth is rounding.
                        expected = std::abs(height) < 0.01 ? ingot::EdgeKind::flat : height < 0 ? ingot::EdgeKind::convex : ingot::EdgeKind::concave;
                    }
                ASSERT_EQ(t.edge(i), expected) << t.number << ", edge " << i;
            }
        }
    }
}

/// Both sides of one triangle: a blade. And two of them, edge to edge, that face each other: a crack, as wide as the lattice is fine.
TEST(LevelWalk, edges_of_a_blade_are_convex_and_of_a_crack_concave) {
    Soup blade;
    blade.points = {lattice_point(0, 0, 0), lattice_point(900, 0, 0), lattice_point(0, 900, 7)};
    blade.faces = {{0, 1, 2}, {1, 0, 2}};
    for (const ingot::LatticeTriangle& t : built(blade).triangles) EXPECT_EQ(t.edges, 0b101010);
    Soup crack;
    crack.points = {lattice_point(0, 0, 0), lattice_point(900, 0, 0), lattice_point(0, 900, 0), lattice_point(0, 900, 1)};
    crack.faces = {{0, 1, 2}, {1, 0, 3}};
    for (const ingot::LatticeTriangle& t : built(crack).triangles) EXPECT_TRUE(t.edges == 0b000011 || t.edges == 0b110000);
}

}  // namespace
