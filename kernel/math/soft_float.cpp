// SPDX-License-Identifier: MIT
#include "soft_float.h"

namespace ingot { inline namespace INGOT_ABI { namespace soft_float {

namespace {

constexpr Bits sign_bit = 0x80000000u, infinity = 0x7f800000u, nan = 0x7fc00000u;
constexpr int exponent_of_infinity = 255, bias = 127;
constexpr Bits leading_one = Bits(1) << 23;

int exponent_of(Bits x) { return static_cast<int>((x << 1) >> 24); }

Bits fraction_of(Bits x) { return (x << 9) >> 9; }

/// x / 2^shift, 0 < shift < 32; the lowest bit is set when any bit beyond it is.
Bits shifted_right(Bits x, int shift) { return x >> shift | ((x << (32 - shift)) != 0 ? 1u : 0u); }

/// The float next to m 2^(exponent - bias - 31), ties to even. m is not zero; its lowest bit stands for all below it.
INGOT_NOINLINE Bits rounded(Bits sign, int exponent, Bits m) {
    // bound: 31: a number that is not 0 is shifted up
    for (; (m & sign_bit) == 0; m <<= 1) --exponent;
    if (exponent >= exponent_of_infinity) return sign | infinity;
    if (exponent <= 0) {
        m = shifted_right(m, exponent < -30 ? 31 : 1 - exponent);
        exponent = 1;
    }
    // The leading one adds itself to the exponent; so does a carry, up to infinity.
    const Bits x = (static_cast<Bits>(exponent - 1) << 23) + (m >> 8) + (m >> 7 & 1u);
    return sign | ((m & 0xffu) == 0x80u ? x & ~1u : x);
}

/// A number that is not zero as m 2^(exponent - bias - 23), the leading one of m at bit 23.
struct Parts {
    int exponent;
    Bits m;
};
INGOT_INLINE Parts normal_parts_of(Bits x) {
    Parts p = {exponent_of(x), fraction_of(x)};
    if (p.exponent != 0) return {p.exponent, p.m | leading_one};
    // bound: 23: a number that is not 0 is shifted up
    for (p.exponent = 1; p.m < leading_one; p.m <<= 1) --p.exponent;
    return p;
}

}  // namespace

Bits add(Bits a, Bits b) {
    if ((a << 1) < (b << 1)) {
        const Bits larger = b;
        b = a;
        a = larger;
    }
    const Bits opposite = (a ^ b) & sign_bit;
    if (exponent_of(a) == exponent_of_infinity) {
        const bool is_nan = (a << 9) != 0 || (opposite != 0 && exponent_of(b) == exponent_of_infinity);
        return is_nan ? nan : a;
    }
    // One bit for the carry; seven below, so that no tie is mistaken.
    int exponent = exponent_of(a), exponent_b = exponent_of(b);
    Bits m = fraction_of(a) << 7, m_b = fraction_of(b) << 7;
    if (exponent != 0)
        m |= leading_one << 7;
    else
        exponent = 1;
    if (exponent_b != 0)
        m_b |= leading_one << 7;
    else
        exponent_b = 1;
    const int shift = exponent - exponent_b;
    if (shift != 0) m_b = shifted_right(m_b, shift > 31 ? 31 : shift);
    m = opposite != 0 ? m - m_b : m + m_b;
    if (m == 0) return opposite != 0 ? 0 : a;
    return rounded(a & sign_bit, exponent + 1, m);
}

Bits subtract(Bits a, Bits b) { return add(a, b ^ sign_bit); }

Bits multiply(Bits a, Bits b) {
    const Bits sign = (a ^ b) & sign_bit;
    a &= ~sign_bit;
    b &= ~sign_bit;
    if (a >= infinity || b >= infinity) return a > infinity || b > infinity || a == 0 || b == 0 ? nan : sign | infinity;
    if (a == 0 || b == 0) return sign;
    const Parts p = normal_parts_of(a), q = normal_parts_of(b);
    // 24 by 24 bits in halves that a 32-bit product holds; what falls off the end is marked.
    const Bits p_high = p.m >> 8, p_low = p.m & 0xffu, q_high = q.m >> 8, q_low = q.m & 0xffu;
    const Bits low = p_low * q_low, middle = p_high * q_low + p_low * q_high + (low >> 8);
    const Bits m = p_high * q_high + (middle >> 8);
    return rounded(sign, p.exponent + q.exponent - bias + 1, m | (((middle | low) & 0xffu) != 0 ? 1u : 0u));
}

Bits divide(Bits a, Bits b) {
    const Bits sign = (a ^ b) & sign_bit;
    a &= ~sign_bit;
    b &= ~sign_bit;
    if (a > infinity || b > infinity || (a == b && (a == 0 || a == infinity))) return nan;
    if (a == infinity || b == 0) return sign | infinity;
    if (b == infinity || a == 0) return sign;
    const Parts p = normal_parts_of(a), q = normal_parts_of(b);
    // 26 digits of the quotient, which has its leading one in the first or the second.
    Bits rest = p.m, quotient = 0;
    for (int digit_i = 0; digit_i < 26; ++digit_i) {
        quotient <<= 1;
        if (rest >= q.m) {
            rest -= q.m;
            quotient |= 1;
        }
        rest <<= 1;
    }
    return rounded(sign, p.exponent - q.exponent + bias, quotient << 6 | (rest != 0 ? 1u : 0u));
}

INGOT_NOINLINE Order order_of(Bits a, Bits b) {
    if ((a << 1) > (infinity << 1) || (b << 1) > (infinity << 1)) return unordered;
    const auto signed_magnitude = [](Bits x) {
        const int32_t magnitude = static_cast<int32_t>(x & ~sign_bit);
        return (x & sign_bit) != 0 ? -magnitude : magnitude;
    };
    const int32_t x = signed_magnitude(a), y = signed_magnitude(b);
    return x < y ? less : x > y ? greater : equal;
}

int is_equal(Bits a, Bits b) { return order_of(a, b) & equal; }
int is_less(Bits a, Bits b) { return order_of(a, b) & less; }
int is_less_or_equal(Bits a, Bits b) { return order_of(a, b) & (less | equal); }
int is_greater_or_equal(Bits a, Bits b) { return order_of(a, b) & (greater | equal); }
int is_greater(Bits a, Bits b) { return order_of(a, b) & greater; }
int is_unordered(Bits a, Bits b) { return order_of(a, b) & unordered; }

} } }  // namespace ingot::soft_float
