// SPDX-License-Identifier: MIT
// soft_float against the arithmetic of the hardware, which IEEE 754 defines to the bit.
#include <gtest/gtest.h>
#include <ingot/math/soft_float.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "reference/draws.h"
#include "reference/random_input.h"

namespace {

using ingot::soft_float::Bits;
using ingot_reference::RandomInput;

float number_of(Bits b) {
    float x;
    std::memcpy(&x, &b, sizeof x);
    return x;
}

Bits bits_of(float x) {
    Bits b;
    std::memcpy(&b, &x, sizeof b);
    return b;
}

/// The bits of the hardware; NaN, whose bits IEEE 754 leaves open, as soft_float has it.
bool is_right(Bits computed, float expected) {
    return std::isnan(expected) ? computed == 0x7fc00000u : computed == bits_of(expected);
}

/// Operations that the compiler may neither fold nor fuse.
struct Hardware {
    volatile float a, b;
    float sum() const { return a + b; }
    float difference() const { return a - b; }
    float product() const { return a * b; }
    float quotient() const { return a / b; }
};

::testing::AssertionResult all_agree(Bits a, Bits b) {
    namespace soft = ingot::soft_float;
    const Hardware hard{number_of(a), number_of(b)};
    const float x = hard.a, y = hard.b;
    const soft::Order order = x < y ? soft::less : x > y ? soft::greater : x == y ? soft::equal : soft::unordered;
    if (is_right(soft::add(a, b), hard.sum()) && is_right(soft::subtract(a, b), hard.difference()) &&
        is_right(soft::multiply(a, b), hard.product()) && is_right(soft::divide(a, b), hard.quotient()) &&
        soft::order_of(a, b) == order && soft::is_less(a, b) == (x < y ? 1 : 0) && (soft::is_less_or_equal(a, b) != 0) == (x <= y) &&
        (soft::is_greater(a, b) != 0) == (x > y) && (soft::is_greater_or_equal(a, b) != 0) == (x >= y) &&
        (soft::is_equal(a, b) != 0) == (x == y) && (soft::is_unordered(a, b) != 0) == (order == soft::unordered))
        return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << std::hex << a << " and " << b << ": " << soft::add(a, b) << " " << soft::subtract(a, b) << " "
                                         << soft::multiply(a, b) << " " << soft::divide(a, b) << " " << soft::order_of(a, b);
}

/// Every exponent with the fractions at which rounding, carry and normalisation turn, of both signs; zeros, denormals,
/// infinities and NaN among them.
std::vector<Bits> corner_cases() {
    std::vector<Bits> cases;
    for (Bits exponent = 0; exponent < 256; ++exponent)
        for (const Bits fraction : {0x000000u, 0x000001u, 0x400000u, 0x555555u, 0x7fffffu})
            for (const Bits sign : {0u, 0x80000000u}) cases.push_back(sign | exponent << 23 | fraction);
    return cases;
}

TEST(SoftFloat, every_pair_of_corner_cases) {
    const std::vector<Bits> cases = corner_cases();
    for (const Bits a : cases)
        for (const Bits b : cases) ASSERT_TRUE(all_agree(a, b));
}

/// One bit of the fraction set or clear, at exponents near each other: every place to which a bit is shifted.
TEST(SoftFloat, every_shift_of_every_bit) {
    for (const Bits exponent_a : {0u, 1u, 2u, 100u, 127u, 253u, 254u})
        for (Bits exponent_b = 0; exponent_b < 256; ++exponent_b)
            for (int bit_a = 0; bit_a < 23; ++bit_a)
                for (int bit_b = 0; bit_b < 23; ++bit_b) {
                    const Bits one_a = Bits(1) << bit_a, one_b = Bits(1) << bit_b;
                    ASSERT_TRUE(all_agree(exponent_a << 23 | one_a, exponent_b << 23 | one_b));
                    ASSERT_TRUE(all_agree(exponent_a << 23 | (0x7fffffu ^ one_a), 0x80000000u | exponent_b << 23 | (0x7fffffu ^ one_b)));
                }
}

TEST(SoftFloat, numbers_of_any_bits) {
    RandomInput random(43);
    for (int i = 0; i < ingot_reference::draws(5000000); ++i)
        ASSERT_TRUE(all_agree(static_cast<Bits>(random.bits()), static_cast<Bits>(random.bits())));
}

/// Of like size, where sums cancel and ties are common.
TEST(SoftFloat, numbers_of_like_size) {
    RandomInput random(44);
    for (int i = 0; i < ingot_reference::draws(5000000); ++i) {
        const Bits a = static_cast<Bits>(random.bits()), b = static_cast<Bits>(random.bits());
        const Bits exponent = a >> 23 & 0xffu, shift = b >> 23 & 0x1fu;
        const Bits near = (exponent + shift) & 0xffu;
        ASSERT_TRUE(all_agree(a, (b & 0x807fffffu) | near << 23));
        ASSERT_TRUE(all_agree(a & 0xff800fffu, (b & 0x807ff000u) | near << 23));
    }
}

/// Products and quotients at both ends of the range: denormal results, and the least that overflow.
TEST(SoftFloat, ends_of_the_range) {
    RandomInput random(45);
    for (int i = 0; i < ingot_reference::draws(5000000); ++i) {
        const Bits a = static_cast<Bits>(random.bits()), b = static_cast<Bits>(random.bits());
        const Bits sum = i % 2 == 0 ? 127u - 24u + (b >> 23 & 0x1fu) : 127u + 254u - (b >> 23 & 0x3u);
        const Bits exponent_a = a >> 23 & 0xffu;
        const Bits exponent_b = (sum - exponent_a) & 0xffu;
        ASSERT_TRUE(all_agree(a, (b & 0x807fffffu) | exponent_b << 23));
    }
}

}  // namespace
