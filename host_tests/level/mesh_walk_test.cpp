// SPDX-License-Identifier: MIT
// for_triangles_in tells what all triangles, looked at one by one, would.
#include "meshes.h"

#include <gtest/gtest.h>
#include <ingot/level/level_walk.h>

#include <limits>
#include <set>

namespace {

using namespace level_test;
using ingot::LevelTriangle;
using ingot::scalar;
using ingot::Vector;

bool boxes_meet(const LevelTriangle& t, const Vector& low, const Vector& high) {
    const Vector least = min(min(t.corners[0], t.corners[1]), t.corners[2]), most = max(max(t.corners[0], t.corners[1]), t.corners[2]);
    return least.x <= high.x && least.y <= high.y && least.z <= high.z && most.x >= low.x && most.y >= low.y && most.z >= low.z;
}

std::set<uint32_t> told_in(const ingot::LevelTable& level, const Vector& low, const Vector& high) {
    std::set<uint32_t> numbers;
    for_triangles_in(level, low, high, [&](const LevelTriangle& t) { EXPECT_TRUE(numbers.insert(t.number).second) << "told twice"; });
    return numbers;
}
std::set<uint32_t> all_in(const ingot::LevelTable& level, const Vector& low, const Vector& high) {
    std::set<uint32_t> numbers;
    for (uint32_t i = 0; i < level.mesh.triangle_count; ++i)
        if (boxes_meet(triangle_of(level, i), low, high)) numbers.insert(i);
    return numbers;
}

/// A place in or about the level, often on the lattice to the bit, or next to it.
scalar draw_place(Random& random, scalar low, scalar high, scalar step) {
    const auto share = static_cast<scalar>(random() % 1024) / 1024;
    const scalar place = low + (high - low) * (share * scalar(1.25) - scalar(0.125));
    switch (random() % 4) {
        case 0: return step * static_cast<scalar>(static_cast<int64_t>(place / step));
        case 1: return std::nextafter(step * static_cast<scalar>(static_cast<int64_t>(place / step)), scalar(1e9));
        case 2: return std::nextafter(step * static_cast<scalar>(static_cast<int64_t>(place / step)), scalar(-1e9));
        default: return place;
    }
}

void expect_walk_equals_all(const ingot::LevelTable& level, Random& random, int boxes) {
    ASSERT_GT(level.mesh.triangle_count, 0);
    for (int i = 0; i < boxes; ++i) {
        Vector low{draw_place(random, level.low.x, level.high.x, level.step), draw_place(random, level.low.y, level.high.y, level.step),
                   draw_place(random, level.low.z, level.high.z, level.step)};
        const auto size = static_cast<scalar>(random() % 64) / 128;
        Vector high = low + (level.high - level.low) * size;
        if (random() % 8 == 0) high = low;
        ASSERT_EQ(told_in(level, low, high), all_in(level, low, high)) << "box " << i;
    }
}

TEST(MeshWalk, tells_all_triangles_that_a_box_meets_and_no_other) {
    Random random(15);
    expect_walk_equals_all(built(loose_triangles(random, 1, 65535, 65535)).view, random, 2000);
    for (int round = 0; round < 6; ++round) {
        const int extent = round % 2 == 0 ? 65535 : 3000, size = round % 3 == 0 ? extent : extent / 20;
        expect_walk_equals_all(built(loose_triangles(random, 100 << round % 3, extent, size)).view, random, 2000);
    }
    expect_walk_equals_all(built(terrain(random, 24, 100, [&](int, int) { return between(random, 0, 400); })).view, random, 2000);
    expect_walk_equals_all(built(slivers(80, true)).view, random, 2000);
    expect_walk_equals_all(built(slivers(80, false)).view, random, 2000);
    expect_walk_equals_all(built(village(random, 6)).view, random, 2000);
}

}  // namespace
