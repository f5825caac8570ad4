// SPDX-License-Identifier: MIT
// A snapshot knows nothing of lanes: saved by one kernel, loaded by another, it goes on with the same hashes.
#include "snapshot/lanes.h"

#include <gtest/gtest.h>

namespace {

using namespace lanes_test;

/// In brief, 4 and 8 lanes: CMakeLists.txt builds no others then.
std::vector<Kernel> all_kernels() {
#if INGOT_TEST_BRIEF
    return {kernel_of_4(), kernel_of_8()};
#else
    return {kernel_of_1(), kernel_of_4(), kernel_of_8()};
#endif
}

TEST(SnapshotLanes, a_world_of_any_lane_count_goes_on_in_any_other) {
    const std::vector<Kernel> kernels = all_kernels();
    for (std::size_t i = 1; i < kernels.size(); ++i) EXPECT_LT(kernels[i - 1].lanes, kernels[i].lanes);
    constexpr int before = 80, after = 120;
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        const Trace stayed = kernels[0].go_on(kernels[0].begin(seed, before), seed, before, after);
        ASSERT_TRUE(stayed.loaded);
        ASSERT_NE(stayed.hashes.front(), stayed.hashes.back());
        for (const Kernel& from : kernels) {
            const std::vector<uint8_t> bytes = from.begin(seed, before);
            EXPECT_EQ(bytes, kernels[0].begin(seed, before)) << from.lanes << " lanes";
            for (const Kernel& to : kernels) {
                const Trace moved = to.go_on(bytes, seed, before, after);
                EXPECT_TRUE(moved.loaded) << "seed " << seed << ", " << from.lanes << " to " << to.lanes;
                EXPECT_EQ(moved.hashes, stayed.hashes) << "seed " << seed << ", " << from.lanes << " to " << to.lanes;
                EXPECT_EQ(moved.bytes, stayed.bytes) << "seed " << seed << ", " << from.lanes << " to " << to.lanes;
            }
        }
    }
}

/// Found by fuzz_friction: a ball that shared a block of rows with a box was brought to its place in several pushes, and alone in one.
TEST(Lanes, balls_bounce_alike_beside_boxes) {
    const std::vector<Kernel> kernels = all_kernels();
    const std::vector<uint64_t> alone = kernels[0].land();
    ASSERT_EQ(alone.size(), 300u);
    for (const Kernel& kernel : kernels) EXPECT_EQ(kernel.land(), alone) << kernel.lanes << " lanes";
}

}  // namespace
