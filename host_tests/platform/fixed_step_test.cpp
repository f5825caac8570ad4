// SPDX-License-Identifier: MIT
// Laws of the fixed-step accumulator, against exact 128-bit arithmetic.
#include <ingot/platform/fixed_step.h>

#include <gtest/gtest.h>

#include <random>

namespace {

using ingot::platform::FixedStep;
using ingot::platform::StepRate;
using ingot::platform::StepsDue;

__extension__ typedef unsigned __int128 Exact;

constexpr uint32_t unlimited = UINT32_MAX;

/// Time in units of which a step has a whole number: see FixedStep.
Exact units(uint64_t ticks, StepRate rate) { return Exact{ticks} * rate.steps; }
Exact units_per_step(uint64_t hz, StepRate rate) { return Exact{hz} * rate.seconds; }

uint64_t exact_steps(uint64_t ticks, uint64_t hz, StepRate rate) {
    return static_cast<uint64_t>(units(ticks, rate) / units_per_step(hz, rate));
}

float exact_fraction(uint64_t ticks, uint64_t hz, StepRate rate) {
    const Exact rest = units(ticks, rate) % units_per_step(hz, rate);
    return static_cast<float>(static_cast<uint32_t>((rest << 24) / units_per_step(hz, rate))) / 16777216.0f;
}

struct Case {
    uint64_t hz;
    StepRate rate;
};

// Clocks and rates whose step is no whole number of ticks, save for the last; the first is the board clock at 60 Hz.
const Case cases[] = {
    {25'000'000, {60, 1}},
    {16'000'000, {60, 1}},
    {1'000'000'000, {60, 1}},
    {1'000'000'000, {60'000, 1'001}},
    {32'768, {144, 1}},
    {1'193'182, {15, 1}},
    {2'147'483'648, {240, 1}},
    {1'000, {7, 3'600}},
    {61, {60, 1}},
    {60, {60, 1}},
};

TEST(FixedStep, days_of_irregular_calls_end_at_the_exact_step) {
    std::mt19937_64 random(1997);
    for (const Case& c : cases) {
        const uint64_t start = random() >> 1;
        const uint64_t end = start + 3 * 86'400 * c.hz;
        std::uniform_int_distribution<uint64_t> pause(0, c.hz / 2);

        FixedStep pace(c.hz, c.rate, unlimited);
        pace.restart(start);
        uint64_t taken = 0;
        for (uint64_t now = start; now < end; now += pause(random)) {
            const StepsDue due = pace.advance(now);
            taken += due.steps;
            ASSERT_EQ(due.dropped, 0u);
            ASSERT_EQ(taken, exact_steps(now - start, c.hz, c.rate));
            ASSERT_EQ(pace.steps_taken(), taken);
        }
        EXPECT_GT(taken, 0u);
    }
}

TEST(FixedStep, how_time_is_cut_into_calls_does_not_matter) {
    for (const Case& c : cases) {
        const uint64_t end = 20 * c.hz + 17;
        FixedStep once(c.hz, c.rate, unlimited);
        FixedStep often(c.hz, c.rate, unlimited);
        once.restart(0);
        often.restart(0);
        for (uint64_t now = 0; now < end; now += c.hz / 1000 + 1) (void)often.advance(now);
        (void)often.advance(end);
        (void)once.advance(end);
        EXPECT_EQ(once.steps_taken(), often.steps_taken());
        EXPECT_EQ(once.fraction(), often.fraction());
    }
}

TEST(FixedStep, a_step_comes_at_the_first_tick_at_which_it_is_due) {
    const Case c = {25'000'000, {60, 1}};
    FixedStep pace(c.hz, c.rate, 5);
    pace.restart(0);
    EXPECT_EQ(pace.advance(416'666).steps, 0u);  // step 1 ends at 416666.67
    EXPECT_EQ(pace.advance(416'667).steps, 1u);
    EXPECT_EQ(pace.advance(833'333).steps, 0u);  // step 2 at 833333.33
    EXPECT_EQ(pace.advance(833'334).steps, 1u);
    EXPECT_EQ(pace.advance(1'249'999).steps, 0u);
    EXPECT_EQ(pace.advance(1'250'000).steps, 1u);  // step 3 at 1250000 exactly
    EXPECT_EQ(pace.fraction(), 0.0f);
}

TEST(FixedStep, never_more_than_the_catch_up_limit_and_nothing_is_lost_silently) {
    std::mt19937_64 random(4);
    for (const Case& c : cases) {
        for (const uint32_t steps_max : {0u, 1u, 5u}) {
            FixedStep pace(c.hz, c.rate, steps_max);
            pace.restart(0);
            std::uniform_int_distribution<uint64_t> pause(0, 20 * c.hz);
            uint64_t now = 0, taken = 0, dropped = 0;
            for (int call_i = 0; call_i < 1000; ++call_i) {
                now += pause(random);
                const StepsDue due = pace.advance(now);
                ASSERT_LE(due.steps, steps_max);
                if (due.dropped > 0) {
                    ASSERT_EQ(due.steps, steps_max);
                }
                taken += due.steps;
                dropped += due.dropped;
                ASSERT_EQ(taken + dropped, exact_steps(now, c.hz, c.rate));
                ASSERT_EQ(pace.steps_taken(), taken);
                ASSERT_EQ(pace.steps_dropped(), dropped);
                ASSERT_EQ(pace.fraction(), exact_fraction(now, c.hz, c.rate)) << "dropping keeps the grid of time";
            }
        }
    }
}

TEST(FixedStep, fraction_is_exact_and_never_one) {
    std::mt19937_64 random(5);
    for (const Case& c : cases) {
        FixedStep pace(c.hz, c.rate, unlimited);
        pace.restart(0);
        std::uniform_int_distribution<uint64_t> pause(0, c.hz / 20);
        uint64_t now = 0;
        for (int call_i = 0; call_i < 10'000; ++call_i) {
            now += pause(random);
            (void)pace.advance(now);
            ASSERT_GE(pace.fraction(), 0.0f);
            ASSERT_LT(pace.fraction(), 1.0f);
            ASSERT_EQ(pace.fraction(), exact_fraction(now, c.hz, c.rate));
        }
    }
}

TEST(FixedStep, fraction_does_not_round_up_to_one_in_a_very_long_step) {
    FixedStep pace(1'000'000'000, {1, 3'600}, 1);  // the last tick is 2.8e-13 of a step away from the next
    pace.restart(0);
    EXPECT_EQ(pace.advance(3'600'000'000'000 - 1).steps, 0u);
    EXPECT_EQ(pace.fraction(), 1.0f - 0x1p-24f);
    EXPECT_EQ(pace.advance(3'600'000'000'000).steps, 1u);
    EXPECT_EQ(pace.fraction(), 0.0f);
}

TEST(FixedStep, the_longest_pause_there_is_is_counted_exactly) {
    for (const Case& c : cases) {
        FixedStep pace(c.hz, c.rate, 5);
        pace.restart(0);
        const StepsDue due = pace.advance(UINT64_MAX);
        EXPECT_EQ(due.steps, 5u);
        EXPECT_EQ(due.steps + due.dropped, exact_steps(UINT64_MAX, c.hz, c.rate));
        EXPECT_EQ(pace.fraction(), exact_fraction(UINT64_MAX, c.hz, c.rate));
    }
}

TEST(FixedStep, a_clock_that_goes_back_stands_still) {
    FixedStep pace(1000, {10, 1}, 5);
    pace.restart(5000);
    EXPECT_EQ(pace.advance(5150).steps, 1u);
    EXPECT_EQ(pace.advance(5000).steps, 0u);
    EXPECT_EQ(pace.fraction(), 0.5f);
    EXPECT_EQ(pace.advance(5049).steps, 0u);
    EXPECT_EQ(pace.advance(5050).steps, 1u);
}

TEST(FixedStep, restart_forgets) {
    FixedStep pace(1000, {10, 1}, 5);
    pace.restart(0);
    (void)pace.advance(990);
    pace.restart(1'000'000);
    EXPECT_EQ(pace.steps_taken(), 0u);
    EXPECT_EQ(pace.steps_dropped(), 0u);
    EXPECT_EQ(pace.fraction(), 0.0f);
    EXPECT_EQ(pace.advance(1'000'099).steps, 0u);
    EXPECT_EQ(pace.advance(1'000'100).steps, 1u);
}

TEST(FixedStep, senseless_rates_are_refused_and_never_step) {
    const Case senseless[] = {
        {0, {60, 1}},                  // no ticks
        {1000, {0, 1}},                // no steps
        {1000, {60, 0}},               // no time
        {59, {60, 1}},                 // a step shorter than a tick
        {1ull << 62, {60, 1}},         // sums would overflow
        {UINT64_MAX, {UINT32_MAX, UINT32_MAX}},
    };
    for (const Case& c : senseless) {
        FixedStep pace(c.hz, c.rate, 5);
        EXPECT_FALSE(pace.valid());
        pace.restart(0);
        const StepsDue due = pace.advance(UINT64_MAX);
        EXPECT_EQ(due.steps, 0u);
        EXPECT_EQ(due.dropped, 0u);
        EXPECT_EQ(pace.fraction(), 0.0f);
    }
    for (const Case& c : cases) EXPECT_TRUE(FixedStep(c.hz, c.rate, 5).valid());
}

TEST(FixedStep, the_largest_allowed_product_does_not_overflow) {
    const Case c = {1ull << 31, {1u << 16, 1u << 16}};  // product 2^63
    FixedStep pace(c.hz, c.rate, 3);
    ASSERT_TRUE(pace.valid());
    pace.restart(0);
    uint64_t now = 0;
    for (const uint64_t pause : {(1ull << 47) - 1, 1ull << 47, 1ull << 63, (1ull << 15) - 1, 1ull}) {
        now += pause;
        (void)pace.advance(now);
        EXPECT_EQ(pace.steps_taken() + pace.steps_dropped(), exact_steps(now, c.hz, c.rate));
        EXPECT_EQ(pace.fraction(), exact_fraction(now, c.hz, c.rate));
    }
}

TEST(FixedStep, h_is_the_step_rounded_once) {
    constexpr FixedStep pace(1000, {60, 1}, 5);
    EXPECT_EQ(pace.h(), 1.0f / 60.0f);
    EXPECT_EQ(pace.h<double>(), 1.0 / 60.0);
    EXPECT_EQ(FixedStep(1000, {1, 10}, 5).h(), 10.0f);
}

}  // namespace
