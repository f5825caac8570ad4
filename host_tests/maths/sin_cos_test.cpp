// SPDX-License-Identifier: MIT
// sin_cos against long double, and against the promise of its docstring.
#include <gtest/gtest.h>
#include <ingot/math/trig.h>

#include <cmath>
#include <cstdio>
#include <cstring>

#include "reference/measure.h"
#include "reference/random_input.h"

namespace {

using ingot::scalar;
using ingot_reference::RandomInput;
using ingot_reference::ulps_off;

/// The docstring of sin_cos: within 1 ulp of the larger of the result and this floor.
constexpr long double promised_ulps = 1;
constexpr long double promised_floor = INGOT_DOUBLE ? 0x1p-50L : 0x1p-20L;
constexpr long double half_pi = 1.57079632679489661923132169163975144L;

/// Keeps the worst error and where it was.
class Worst {
public:
    void check(scalar angle) {
        const ingot::SinCos computed = ingot::sin_cos(angle);
        keep(ulps_off(computed.sin, std::sin(static_cast<long double>(angle)), promised_floor), angle, "sin");
        keep(ulps_off(computed.cos, std::cos(static_cast<long double>(angle)), promised_floor), angle, "cos");
    }
    void expect_promise(const char* where) const {
        std::printf("    %s: worst error %.3Lf ulp, %s(%.17g)\n", where, ulps_, of_, static_cast<double>(angle_));
        EXPECT_LE(ulps_, promised_ulps) << where << ": " << of_ << "(" << static_cast<double>(angle_) << ")";
    }

private:
    void keep(long double ulps, scalar angle, const char* of) {
        if (ulps <= ulps_) return;
        ulps_ = ulps;
        angle_ = angle;
        of_ = of;
    }
    long double ulps_ = 0;
    scalar angle_ = 0;
    const char* of_ = "";
};

TEST(SinCos, within_promise_all_over_the_range) {
    RandomInput random(31);
    Worst worst;
    for (int i = 0; i < 1'000'000; ++i) worst.check(static_cast<scalar>(random.real(-1000, 1000)));
    worst.expect_promise("uniform over [-1000, 1000]");
}

TEST(SinCos, within_promise_for_small_angles) {
    RandomInput random(32);
    Worst worst;
    for (int i = 0; i < 500'000; ++i) worst.check(static_cast<scalar>(random.of_any_size(-60, 3)));
    worst.expect_promise("2^-60 to 2^4");
}

/// Near the zeros of sine or cosine the reduction has to subtract nearly equal numbers.
TEST(SinCos, within_promise_near_the_zeros) {
    RandomInput random(33);
    Worst worst;
    for (int q = -636; q <= 636; ++q) {
        const scalar zero = static_cast<scalar>(q * half_pi);
        scalar up = zero, down = zero;
        for (int ulp_i = 0; ulp_i < 32; ++ulp_i) {
            worst.check(up);
            worst.check(down);
            up = std::nextafter(up, scalar(2000));
            down = std::nextafter(down, scalar(-2000));
        }
        for (int i = 0; i < 200; ++i)
            worst.check(static_cast<scalar>(q * half_pi + static_cast<long double>(random.of_any_size(-40, -1))));
    }
    worst.expect_promise("next to multiples of pi/2");
}

/// Where reduction changes from one quadrant to the next, |r| is largest.
TEST(SinCos, within_promise_between_quadrants) {
    Worst worst;
    for (int q = -636; q < 636; ++q) {
        scalar angle = static_cast<scalar>((q + 0.5L) * half_pi);
        for (int ulp_i = -16; ulp_i < 0; ++ulp_i) angle = std::nextafter(angle, scalar(-2000));
        for (int ulp_i = -16; ulp_i < 16; ++ulp_i) {
            worst.check(angle);
            angle = std::nextafter(angle, scalar(2000));
        }
    }
    worst.expect_promise("next to odd multiples of pi/4");
}

/// The worst that a search over 2.4e8 doubles, and over every float, has found.
TEST(SinCos, within_promise_at_the_worst_angles_known) {
    const double angles[] = {977.01969021008017,  -703.73237968021249, -920.42414059812393, -141.36776315882287,
                             -639.34535615329469, -692.75243137365328, -878.05952144267519, 925.23028888038016,
                             603.185791015625,    838.80523681640625,  731.9910888671875,   709.99993896484375,
                             774.402587890625,    667.58843994140625,  645.5972900390625,   881.21673583984375};
    Worst worst;
    for (const double angle : angles) worst.check(static_cast<scalar>(angle));
    worst.expect_promise("worst angles known");
}

TEST(SinCos, is_odd_and_even_bitwise) {
    RandomInput random(34);
    for (int i = 0; i < 100'000; ++i) {
        const scalar angle = static_cast<scalar>(random.real(0, 1000));
        const ingot::SinCos plus = ingot::sin_cos(angle), minus = ingot::sin_cos(-angle);
        ASSERT_EQ(plus.sin, -minus.sin) << angle;
        ASSERT_EQ(plus.cos, minus.cos) << angle;
    }
}

TEST(SinCos, known_values_and_ends_of_the_range) {
    EXPECT_EQ(ingot::sin_cos(0).sin, 0);
    EXPECT_EQ(ingot::sin_cos(0).cos, 1);
    EXPECT_FALSE(std::isnan(ingot::sin_cos(1000).sin));
    EXPECT_FALSE(std::isnan(ingot::sin_cos(-1000).cos));
    const scalar beyond = std::nextafter(scalar(1000), scalar(2000)), inf = std::numeric_limits<scalar>::infinity();
    for (const scalar angle : {beyond, -beyond, inf, -inf, std::numeric_limits<scalar>::quiet_NaN()}) {
        EXPECT_TRUE(std::isnan(ingot::sin_cos(angle).sin)) << angle;
        EXPECT_TRUE(std::isnan(ingot::sin_cos(angle).cos)) << angle;
    }
}

TEST(SinCos, compiler_and_run_time_give_the_same_bits) {
    constexpr ingot::SinCos at_compile_time[] = {ingot::sin_cos(1), ingot::sin_cos(scalar(-2.5)), ingot::sin_cos(1000)};
    const volatile scalar angles[] = {1, scalar(-2.5), 1000};
    for (int i = 0; i < 3; ++i) {
        const ingot::SinCos at_run_time = ingot::sin_cos(angles[i]);
        EXPECT_EQ(std::memcmp(&at_run_time, &at_compile_time[i], sizeof at_run_time), 0);
    }
}

#if !INGOT_DOUBLE
/// All floats of [0, 1000]; the sine is odd and the cosine even. Minutes.
TEST(SinCos, DISABLED_within_promise_for_every_float) {
    Worst worst;
    for (scalar angle = 0; angle <= 1000; angle = std::nextafter(angle, scalar(2000))) worst.check(angle);
    worst.expect_promise("every float of [0, 1000]");
}
#endif

}  // namespace
