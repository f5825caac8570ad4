// SPDX-License-Identifier: MIT
#include "sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

#if INGOT_DOUBLE
using Bits = uint64_t;
constexpr int fraction_bits = 52, exponent_max = 2047, bias = 1023;
#else
using Bits = uint32_t;
constexpr int fraction_bits = 23, exponent_max = 255, bias = 127;
#endif
constexpr Bits hidden_bit = Bits(1) << fraction_bits;
constexpr Bits sign_bit = Bits(1) << (sizeof(Bits) * 8 - 1);

scalar from_bits(Bits b) {
    scalar x;
    INGOT_COPY_BYTES(&x, &b, sizeof x);
    return x;
}

}  // namespace

scalar sqrt_by_digits(scalar x) {
    Bits b;
    INGOT_COPY_BYTES(&b, &x, sizeof b);
    if ((b & ~sign_bit) == 0) return x;  // +0 and -0
    int exponent = static_cast<int>((b & ~sign_bit) >> fraction_bits);
    if (exponent == exponent_max || (b & sign_bit) != 0) {
        const bool infinite = b == Bits(exponent_max) << fraction_bits;
        return infinite ? x : from_bits((Bits(exponent_max) << fraction_bits) | (hidden_bit >> 1));
    }

    Bits significand = b & (hidden_bit - 1);
    if (exponent == 0) {  // denormal: shift the leading one into place
        exponent = 1;
        // bound: 52: a number that is not 0 is shifted up
        while ((significand & hidden_bit) == 0) {
            significand <<= 1;
            --exponent;
        }
    }
    significand |= hidden_bit;
    exponent -= bias;
    if (exponent & 1) significand <<= 1;

    // Digits of sqrt(significand * 2^fraction_bits), one more than is kept, so that the last one rounds.
    significand <<= 1;
    Bits root = 0, twice_root = 0;
    // bound: 54: a bit falls out each turn
    for (Bits digit = hidden_bit << 1; digit != 0; digit >>= 1) {
        const Bits trial = twice_root + digit;
        if (trial <= significand) {
            twice_root = trial + digit;
            significand -= trial;
            root += digit;
        }
        significand <<= 1;
    }
    // A root of a number that has a half-way digit would need twice as many digits as fit: there are no ties.
    root = (root + (root & 1)) >> 1;
    const int half_exponent = (exponent - (exponent & 1)) / 2;
    return from_bits(root + (Bits(half_exponent + bias - 1) << fraction_bits));
}

} }  // namespace ingot
