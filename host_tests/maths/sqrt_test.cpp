// SPDX-License-Identifier: MIT
// sqrt_by_digits against the square root of the hardware, which IEEE 754 defines to the bit.
#include <gtest/gtest.h>
#include <ingot/math/sqrt.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "reference/draws.h"
#include "reference/random_input.h"

namespace {

using ingot::scalar;
using ingot_reference::RandomInput;

#if INGOT_DOUBLE
using Bits = std::uint64_t;
constexpr int fraction_bits = 52;
constexpr Bits exponents = 2048;
#else
using Bits = std::uint32_t;
constexpr int fraction_bits = 23;
constexpr Bits exponents = 256;
#endif

scalar number_of(Bits b) {
    scalar x;
    std::memcpy(&x, &b, sizeof x);
    return x;
}

Bits bits_of(scalar x) {
    Bits b;
    std::memcpy(&b, &x, sizeof b);
    return b;
}

/// The same bits, or both NaN.
bool agrees(scalar x) {
    const scalar by_digits = ingot::sqrt_by_digits(x), by_hardware = std::sqrt(x);
    return bits_of(by_digits) == bits_of(by_hardware) || (std::isnan(by_digits) && std::isnan(by_hardware));
}

TEST(SqrtByDigits, every_exponent) {
    RandomInput random(41);
    constexpr Bits fraction_max = (Bits(1) << fraction_bits) - 1;
    for (Bits exponent = 0; exponent < exponents; ++exponent) {
        for (const Bits fraction : {Bits(0), Bits(1), fraction_max / 2, fraction_max - 1, fraction_max}) {
            const Bits b = exponent << fraction_bits | fraction;
            ASSERT_TRUE(agrees(number_of(b))) << b;
            ASSERT_TRUE(agrees(-number_of(b))) << b;
        }
        for (int i = 0; i < 100; ++i) {
            const Bits b = exponent << fraction_bits | (static_cast<Bits>(random.bits()) & fraction_max);
            ASSERT_TRUE(agrees(number_of(b))) << b;
        }
    }
}

TEST(SqrtByDigits, denormals) {
    for (int bit = 0; bit < fraction_bits; ++bit) {
        const Bits b = Bits(1) << bit;
        for (const Bits near : {b - 1, b, b + 1}) ASSERT_TRUE(agrees(number_of(near))) << near;
    }
    ASSERT_TRUE(agrees(std::numeric_limits<scalar>::denorm_min()));
}

TEST(SqrtByDigits, special_values) {
    const scalar inf = std::numeric_limits<scalar>::infinity();
    EXPECT_EQ(bits_of(ingot::sqrt_by_digits(scalar(0))), bits_of(scalar(0)));
    EXPECT_EQ(bits_of(ingot::sqrt_by_digits(scalar(-0.0))), bits_of(scalar(-0.0)));
    EXPECT_EQ(ingot::sqrt_by_digits(inf), inf);
    for (const scalar x :
         {-inf, scalar(-1), -std::numeric_limits<scalar>::denorm_min(), std::numeric_limits<scalar>::quiet_NaN(),
          -std::numeric_limits<scalar>::quiet_NaN(), std::numeric_limits<scalar>::signaling_NaN()})
        EXPECT_TRUE(std::isnan(ingot::sqrt_by_digits(x))) << x;
    for (const scalar x :
         {scalar(1), scalar(2), scalar(3), scalar(4), std::numeric_limits<scalar>::max(), std::numeric_limits<scalar>::min(),
          std::nextafter(scalar(1), scalar(0)), std::nextafter(scalar(1), scalar(2))})
        EXPECT_TRUE(agrees(x)) << x;
}

/// Squares and their neighbours: where the root is just at, or next to, a number.
TEST(SqrtByDigits, squares_and_their_neighbours) {
    RandomInput random(42);
    for (int i = 0; i < 100'000; ++i) {
        const scalar root = static_cast<scalar>(random.integer(1, 1 << (fraction_bits / 2)));
        const scalar square = root * root;
        ASSERT_EQ(ingot::sqrt_by_digits(square), root);
        ASSERT_TRUE(agrees(std::nextafter(square, scalar(0))));
        ASSERT_TRUE(agrees(std::nextafter(square, std::numeric_limits<scalar>::max())));
    }
}

TEST(SqrtByDigits, random_bits) {
    RandomInput random(43);
    for (int i = 0; i < ingot_reference::draws(10'000'000); ++i) {
        const scalar x = number_of(static_cast<Bits>(random.bits()) & ~(Bits(1) << (sizeof(Bits) * 8 - 1)));
        if (!agrees(x)) FAIL() << bits_of(x);
    }
}

/// sqrt itself is the hardware's here; on cores without one it is sqrt_by_digits.
TEST(Sqrt, is_correctly_rounded) {
    RandomInput random(44);
    for (int i = 0; i < 100'000; ++i) {
        const scalar x = static_cast<scalar>(std::abs(random.of_any_size(-100, 100)));
        ASSERT_EQ(bits_of(ingot::sqrt(x)), bits_of(std::sqrt(x))) << x;
    }
}

#if !INGOT_DOUBLE
/// All 2^32 floats. Minutes.
TEST(SqrtByDigits, DISABLED_every_float) {
    for (std::uint64_t b = 0; b < std::uint64_t{1} << 32; ++b)
        if (!agrees(number_of(static_cast<Bits>(b)))) FAIL() << b;
}
#endif

}  // namespace
