// SPDX-License-Identifier: MIT
#include "wide.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

using WideBits = uint64_t;

constexpr WideBits wide_sign = WideBits(1) << 63, wide_one = WideBits(1) << 52, wide_infinity = WideBits(0x7ff) << 52;
constexpr int wide_low_bits = 3;  ///< below the last place: two decide the rounding, the third holds what is left

WideBits bits_of(double x) {
    WideBits bits;
    INGOT_COPY_BYTES(&bits, &x, sizeof bits);
    return bits;
}
double double_of(WideBits bits) {
    double x;
    INGOT_COPY_BYTES(&x, &bits, sizeof x);
    return x;
}

int wide_exponent(WideBits x) {
    const int exponent = static_cast<int>(x >> 52 & 0x7ffu);
    return exponent != 0 ? exponent : 1;
}
WideBits wide_significand(WideBits x) {
    const WideBits fraction = x & (wide_one - 1);
    return ((x & wide_infinity) != 0 ? fraction | wide_one : fraction) << wide_low_bits;
}

}  // namespace

double sum_in_integers(double a_value, double b_value) {
    WideBits a = bits_of(a_value), b = bits_of(b_value);
    if ((a << 1) < (b << 1)) {
        const WideBits larger = b;
        b = a;
        a = larger;
    }
    const WideBits sign = a & wide_sign;
    const bool opposite = ((a ^ b) & wide_sign) != 0;
    if ((a & wide_infinity) == wide_infinity) {
        const bool is_nan = (a << 12) != 0 || (opposite && (b & wide_infinity) == wide_infinity);
        return double_of(is_nan ? wide_infinity | wide_one >> 1 : a);
    }
    int exponent = wide_exponent(a);
    const int shift = exponent - wide_exponent(b);
    WideBits m = wide_significand(a), m_b = wide_significand(b);
    if (shift > 63)
        m_b = m_b != 0 ? 1 : 0;
    else if (shift > 0)
        m_b = m_b >> shift | ((m_b << (64 - shift)) != 0 ? 1u : 0u);
    m = opposite ? m - m_b : m + m_b;
    if (m == 0) return double_of(opposite ? 0 : sign);
    constexpr WideBits one = wide_one << wide_low_bits;
    if (m >= 2 * one) {
        m = m >> 1 | (m & 1u);
        ++exponent;
    }
    if (m < one) {
        int up = INGOT_ZEROS_ABOVE(m) - (63 - 52 - wide_low_bits);
        if (up >= exponent) up = exponent - 1;
        m <<= up;
        exponent -= up;
    }
    const WideBits tail = m & 7u;
    WideBits x = m >> wide_low_bits;
    x = (x & wide_one) != 0 ? (static_cast<WideBits>(exponent) << 52) + (x & (wide_one - 1)) : x;
    if (tail > 4 || (tail == 4 && (x & 1u) != 0)) ++x;  // a carry goes on into the exponent, as it should
    return double_of(sign | (x > wide_infinity ? wide_infinity : x));
}

} }  // namespace ingot
