// SPDX-License-Identifier: MIT
// Sums of doubles in integers: the bits of the machine's.
#include <gtest/gtest.h>
#include <ingot/math/wide.h>

#include <cstring>
#include <limits>
#include <random>

namespace {

uint64_t bits_of(double x) {
    uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}
double double_of(uint64_t bits) {
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

/// Returns true where both give the same bits; every NaN is the same.
bool same_sum(double a, double b) {
    const double sum = a + b, own = ingot::sum_in_integers(a, b);
    return sum != sum ? own != own : bits_of(sum) == bits_of(own);
}

TEST(SumInIntegers, has_the_bits_of_the_machine) {
    std::mt19937_64 random(1);
    constexpr uint64_t exponent = 0x7ffull << 52;
    for (int case_i = 0; case_i < 4000000; ++case_i) {
        uint64_t a = random(), b = random();
        if (case_i % 3 != 0) {  // exponents up to 70 apart
            const uint64_t of_a = (a & exponent) >> 52, apart = random() % 70;
            b = (b & ~exponent) | (of_a > apart ? of_a - apart : 0) << 52;
        }
        if (case_i % 5 == 0) b &= ~uint64_t(0) << (random() % 53);  // ties
        if (case_i % 7 == 0) a &= ~uint64_t(0) << (random() % 53);
        ASSERT_TRUE(same_sum(double_of(a), double_of(b))) << std::hexfloat << double_of(a) << " + " << double_of(b);
    }
}

TEST(SumInIntegers, of_the_ends_of_the_range) {
    using limits = std::numeric_limits<double>;
    const double ends[] = {
        0., 1., limits::denorm_min(), limits::min(), limits::min() - limits::denorm_min(), limits::max(), limits::infinity(), limits::quiet_NaN()};
    for (const double a : ends)
        for (const double b : ends)
            for (const double sign_a : {1., -1.})
                for (const double sign_b : {1., -1.}) EXPECT_TRUE(same_sum(sign_a * a, sign_b * b)) << sign_a * a << " + " << sign_b * b;
}

TEST(OwnDouble, compares_as_the_machine_does) {
    for (const double a : {-1.0, 0.0, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
        for (const double b : {-1.0, 0.0, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
            const ingot::OwnDouble own_a = a, own_b = b;
            EXPECT_EQ(own_a < own_b, a < b);
            EXPECT_EQ(own_a > own_b, a > b);
            EXPECT_EQ(own_a <= own_b, a <= b);
            EXPECT_EQ(own_a >= own_b, a >= b);
            EXPECT_EQ(own_a == own_b, a == b);
            EXPECT_EQ(own_a != own_b, a != b);
        }
    }
}

/// What libgcc 12 rounds wrongly on cores with Thumb-2 and no double unit.
TEST(SumInIntegers, of_exponents_33_apart) { EXPECT_EQ(ingot::sum_in_integers(0x1.fa8658p-16, -0x1p17), 0x1.fa8658p-16 - 0x1p17); }

}  // namespace
