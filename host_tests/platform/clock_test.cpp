// SPDX-License-Identifier: MIT
#include <ingot/platform/clock.h>

#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <thread>

#include <ingot/platform/counter_extension.h>

namespace {

using namespace ingot::platform;

TEST(Clock, never_decreases) {
    clock_start();
    uint64_t last = clock_ticks();
    for (int i = 0; i < 100'000; ++i) {
        const uint64_t now = clock_ticks();
        ASSERT_GE(now, last);
        last = now;
    }
}

TEST(Clock, frequency_is_that_of_the_ticks) {
    clock_start();
    ASSERT_GT(clock_frequency_hz(), 0u);
    const uint64_t before = clock_ticks();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const double seconds = static_cast<double>(clock_ticks() - before) / static_cast<double>(clock_frequency_hz());
    EXPECT_GE(seconds, 0.019);
    EXPECT_LT(seconds, 10.0) << "a busy machine may sleep long, but not this long";
}

TEST(Clock, says_what_it_is) {
    ASSERT_NE(clock_name(), nullptr);
    EXPECT_STRNE(clock_name(), "");
    EXPECT_FALSE(clock_counts_instructions());
    EXPECT_EQ(clock_ticks_to_instructions(1000), 0u);
}

TEST(CounterExtension, sums_every_increment_below_one_round) {
    std::mt19937_64 random(2);
    for (const uint32_t start : {0u, 1u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu}) {
        CounterExtension extension{};
        extension.restart(start);
        uint64_t exact = 0;
        for (int i = 0; i < 10'000; ++i) {
            // Every size of increment, the largest legal one included.
            const uint32_t increment = i % 100 == 0 ? UINT32_MAX : static_cast<uint32_t>(random()) >> (random() % 32);
            exact += increment;
            ASSERT_EQ(extension.extend(start + static_cast<uint32_t>(exact)), exact);
        }
        EXPECT_GT(exact, uint64_t{100} << 32);
    }
}

TEST(CounterExtension, a_counter_that_stands_still_adds_nothing) {
    CounterExtension extension{};
    extension.restart(77);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(extension.extend(77), 0u);
}

}  // namespace
