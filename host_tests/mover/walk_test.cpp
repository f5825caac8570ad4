// SPDX-License-Identifier: MIT
// How a mover goes: over stairs, up to its slope, along walls, into corners, on moving ground.
#include <gtest/gtest.h>

#include "course.h"

namespace {

using namespace mover_test;

struct Stairs {
    double rise, tread;
};
constexpr Stairs stairs_of[] = {{0.17, 0.29}, {0.20, 0.25}, {0.30, 0.30}};
constexpr int steps_of_stairs = 8;

/// Up along x from x = 4, a landing of 6 m, and down again; as boxes that stand on the ground. With a wall on one side.
std::vector<Block> staircase(const Stairs& stairs, double& length) {
    const double rise = on_lattice(stairs.rise), tread = on_lattice(stairs.tread);
    std::vector<Block> blocks = {{{-6, -4, -1}, {30, 4, 0}}, {{-6, 1.5, 0}, {30, 2, 6}}};
    double x = 4;
    for (int i = 1; i <= steps_of_stairs; ++i, x += tread) blocks.push_back({{x, -1.5, 0}, {x + tread, 1.5, rise * i}});
    blocks.push_back({{x, -1.5, 0}, {x + 6, 1.5, rise * steps_of_stairs}});
    x += 6;
    for (int i = steps_of_stairs; i >= 1; --i, x += tread) blocks.push_back({{x, -1.5, 0}, {x + tread, 1.5, rise * i}});
    length = x;
    return blocks;
}

/// What a walk along x over a course did.
struct Walked {
    double seconds = 0, highest = 0, least_gap = 1, aside = 0;
    int in_air = 0;
};
template <class S>
Walked walk(World<S>& world, Mover mover, const std::vector<Block>& blocks, double speed, double to, scalar h, double across = 0) {
    Walked walked;
    const double y = static_cast<double>(mover.r.y);
    const MoverInput input = {{static_cast<scalar>(speed), static_cast<scalar>(across), 0}, 0};
    const int steps = static_cast<int>(2 * to / speed / static_cast<double>(h));
    for (int i = 0; i < steps && static_cast<double>(mover.r.x) < to; ++i) {
        EXPECT_EQ(world.move(mover, input, h), Status::ok);
        walked.seconds += static_cast<double>(h);
        walked.highest = std::max(walked.highest, static_cast<double>(mover.r.z) - 0.91);
        walked.in_air += stands(mover) ? 0 : 1;
        walked.aside = std::max(walked.aside, std::abs(static_cast<double>(mover.r.y) - y));
        walked.least_gap = std::min(walked.least_gap, gap_to(mover, blocks));
    }
    return walked;
}

/// Over both flights, at every rate and speed, in the middle and along the wall: as fast as on the flat, and never off the ground.
template <class S>
void climb_all(bool as_mesh) {
    const scalar rates[] = {30, 60, 240};
    const double speeds[] = {1, 2.5, 5, 8};
    for (const Stairs& stairs : stairs_of)
        for (const scalar rate : rates)
            for (const double speed : speeds) {
                if (INGOT_TEST_BRIEF && rate > 100 && speed < 5) continue;
                for (const double across : {0.0, 0.5}) {
                    double to = 0;
                    const std::vector<Block> blocks = staircase(stairs, to);
                    auto& world = empty_world<S>();
                    level_tool::MeshData mesh;
                    if (as_mesh)
                        add_as_mesh(world, blocks, mesh);
                    else
                        add_as_boxes(world, blocks);
                    const Mover mover = standing_at(world, 0, across > 0 ? 1.19 : 0, 0);
                    const Walked walked = walk(world, mover, blocks, speed, to + 3, 1 / rate, across);
                    const auto where = ::testing::Message() << stairs.rise << "/" << stairs.tread << " at " << speed << " m/s, " << rate
                                                            << " Hz, across " << across;
                    EXPECT_NEAR(walked.highest, on_lattice(stairs.rise) * steps_of_stairs, 2e-3) << where;
                    const double flat = (to + 3 - static_cast<double>(mover.r.x)) / speed;
                    EXPECT_LT(walked.seconds, flat * 1.01 + 1 / static_cast<double>(rate)) << where;
                    EXPECT_EQ(walked.in_air, 0) << where;
                    EXPECT_GT(walked.least_gap, 0) << where;
                    if (::testing::Test::HasFailure()) return;
                }
            }
}

TEST(MoverOnStairs, of_boxes_is_as_fast_as_on_the_flat) { climb_all<Street>(false); }
TEST(MoverOnStairs, of_triangles_is_as_fast_as_on_the_flat) { climb_all<Street>(true); }

}  // namespace
