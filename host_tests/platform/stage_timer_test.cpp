// SPDX-License-Identifier: MIT
#include <ingot/platform/stage_timer.h>

#include <gtest/gtest.h>
#include <string.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace {

using ingot::platform::StageId;
using ingot::platform::StageScope;
using ingot::platform::StageStats;
using ingot::platform::StageTimer;

TEST(StageTimer, statistics_equal_those_of_the_list_of_durations) {
    std::mt19937_64 random(1);
    std::uniform_int_distribution<uint64_t> duration(0, 1u << 30);
    StageTimer<2> timer;
    const StageId stage = timer.add_stage("stage");
    const StageId other = timer.add_stage("other");
    std::vector<uint64_t> durations;
    uint64_t now = 12345;
    for (int i = 0; i < 1000; ++i) {
        durations.push_back(duration(random));
        timer.begin_at(stage, now);
        now += durations.back();
        timer.end_at(stage, now);

        const StageStats stats = timer.stage(stage);
        const uint64_t sum = std::accumulate(durations.begin(), durations.end(), uint64_t{0});
        ASSERT_EQ(stats.count, durations.size());
        ASSERT_EQ(stats.min, *std::min_element(durations.begin(), durations.end()));
        ASSERT_EQ(stats.max, *std::max_element(durations.begin(), durations.end()));
        ASSERT_EQ(stats.last, durations.back());
        ASSERT_EQ(stats.sum, sum);
        ASSERT_EQ(stats.mean(), sum / durations.size());
    }
    EXPECT_EQ(timer.stage(other).count, 0u) << "stages do not mix";
}

TEST(StageTimer, a_stage_not_measured_yet_is_all_zero) {
    StageTimer<1> timer;
    const StageStats stats = timer.stage(timer.add_stage("quiet"));
    EXPECT_STREQ(stats.name, "quiet");
    EXPECT_EQ(stats.count, 0u);
    EXPECT_EQ(stats.min, 0u);
    EXPECT_EQ(stats.max, 0u);
    EXPECT_EQ(stats.mean(), 0u);
}

TEST(StageTimer, a_full_array_gives_null_and_null_measures_nothing) {
    StageTimer<2> timer;
    EXPECT_TRUE(timer.add_stage("one"));
    EXPECT_TRUE(timer.add_stage("two"));
    EXPECT_EQ(timer.size(), timer.capacity());
    const StageId none = timer.add_stage("three");
    EXPECT_FALSE(none);
    EXPECT_EQ(timer.size(), 2);

    timer.record(none, 7);
    timer.begin(none);
    timer.end(none);
    for (int32_t id = 1; id <= timer.size(); ++id) EXPECT_EQ(timer.stage(StageId{id}).count, 0u);
    EXPECT_STREQ(timer.stage(none).name, "?");
}

TEST(StageTimer, ids_from_nowhere_are_refused) {
    StageTimer<4> timer;
    (void)timer.add_stage("only");
    for (const int32_t id : {-1, 0, 2, 4, 5, INT32_MAX, INT32_MIN}) {
        timer.record(StageId{id}, 7);
        EXPECT_EQ(timer.stage(StageId{id}).count, 0u);
    }
}

TEST(StageTimer, an_end_without_a_begin_is_no_measurement) {
    StageTimer<1> timer;
    const StageId stage = timer.add_stage("stage");
    timer.end_at(stage, 10);
    EXPECT_EQ(timer.stage(stage).count, 0u);
    timer.begin_at(stage, 20);
    timer.begin_at(stage, 30);  // the later one counts
    timer.end_at(stage, 35);
    timer.end_at(stage, 99);
    EXPECT_EQ(timer.stage(stage).count, 1u);
    EXPECT_EQ(timer.stage(stage).last, 5u);
}

TEST(StageTimer, stages_may_nest) {
    StageTimer<2> timer;
    const StageId outer = timer.add_stage("outer");
    const StageId inner = timer.add_stage("inner");
    {
        const StageScope measure_outer(timer, outer);
        for (int i = 0; i < 3; ++i) const StageScope measure_inner(timer, inner);
    }
    EXPECT_EQ(timer.stage(outer).count, 1u);
    EXPECT_EQ(timer.stage(inner).count, 3u);
    EXPECT_GE(timer.stage(outer).sum, timer.stage(inner).sum);
}

TEST(StageTimer, reset_keeps_the_stages) {
    StageTimer<2> timer;
    const StageId stage = timer.add_stage("stage");
    timer.record(stage, 9);
    timer.reset();
    EXPECT_STREQ(timer.stage(stage).name, "stage");
    EXPECT_EQ(timer.stage(stage).count, 0u);
    timer.record(stage, 4);
    EXPECT_EQ(timer.stage(stage).min, 4u);
    EXPECT_EQ(timer.stage(stage).max, 4u);
}

TEST(StageTimer, zeroed_memory_is_an_empty_timer) {
    StageTimer<3> timer;
    timer.record(timer.add_stage("stage"), 9);
    memset(static_cast<void*>(&timer), 0, sizeof timer);
    EXPECT_EQ(timer.size(), 0);
    const StageId stage = timer.add_stage("again");
    timer.record(stage, 4);
    EXPECT_EQ(timer.stage(stage).count, 1u);
    EXPECT_EQ(timer.stage(stage).max, 4u);
}

}  // namespace
