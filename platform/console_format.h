// SPDX-License-Identifier: MIT
// Numbers to text. Used by console.h; of use by itself where text goes elsewhere.
#pragma once

#include <stdint.h>

namespace ingot::platform {

/// A formatted number by value: long enough for every number below, always zero-terminated.
struct NumberText {
    char text[24];  ///< sign, 20 digits, decimal point, terminator, and one to spare
};

/// Decimal digits, no sign, no leading zeros. Cost: at most 9 subtractions per digit; no division.
NumberText format_u64(uint64_t value);

/// "0x" and at least `digits` lower-case hexadecimal digits. digits outside 1..16 are clamped.
NumberText format_hex(uint64_t value, int digits);

/// scaled / 10^decimals, exactly, with that many decimals: (5, 2) is 0.05. decimals outside 0..18 are clamped.
NumberText format_decimal(int64_t scaled, int decimals);

}  // namespace ingot::platform
