// SPDX-License-Identifier: MIT
#include "console_format.h"

namespace ingot::platform {
namespace {

constexpr int u64_digits = 20;

// Subtracted instead of divided by: a 64-bit division is a library call of 400 to 700 bytes on a Cortex-M.
constexpr uint64_t powers_of_ten[u64_digits] = {
    10000000000000000000u, 1000000000000000000u, 100000000000000000u, 10000000000000000u, 1000000000000000u,
    100000000000000u, 10000000000000u, 1000000000000u, 100000000000u, 10000000000u,
    1000000000u, 100000000u, 10000000u, 1000000u, 100000u,
    10000u, 1000u, 100u, 10u, 1u};

int clamp(int value, int low, int high) { return value < low ? low : value > high ? high : value; }

/// Appends to a NumberText; the arrays are sized for the longest number, so there is no overflow to check.
struct Writer {
    NumberText out{};
    int length = 0;

    void put(char c) { out.text[length++] = c; }

    /// Decimal digits with a point before the last `decimals` of them, and at least one digit before the point.
    void put_decimal(uint64_t value, int decimals) {
        bool started = false;
        for (int digit_i = 0; digit_i < u64_digits; ++digit_i) {
            const int digits_left = u64_digits - 1 - digit_i;
            int digit = 0;
            for (; value >= powers_of_ten[digit_i]; value -= powers_of_ten[digit_i]) ++digit;

            started = started || digit != 0 || digits_left == decimals;
            if (!started) continue;
            put(static_cast<char>('0' + digit));
            if (digits_left == decimals && decimals > 0) put('.');
        }
    }
};

}  // namespace

NumberText format_u64(uint64_t value) {
    Writer writer;
    writer.put_decimal(value, 0);
    return writer.out;
}

NumberText format_hex(uint64_t value, int digits) {
    constexpr int digits_max = 16;
    const int wanted = clamp(digits, 1, digits_max);
    Writer writer;
    writer.put('0');
    writer.put('x');
    bool started = false;
    for (int digit_i = digits_max - 1; digit_i >= 0; --digit_i) {
        const unsigned nibble = static_cast<unsigned>(value >> (4 * digit_i)) & 0xFu;
        started = started || nibble != 0 || digit_i < wanted;
        if (started) writer.put("0123456789abcdef"[nibble]);
    }
    return writer.out;
}

NumberText format_decimal(int64_t scaled, int decimals) {
    constexpr int decimals_max = 18;
    Writer writer;
    if (scaled < 0) writer.put('-');
    // Negated as unsigned: -INT64_MIN does not exist.
    const uint64_t magnitude = scaled < 0 ? 0u - static_cast<uint64_t>(scaled) : static_cast<uint64_t>(scaled);
    writer.put_decimal(magnitude, clamp(decimals, 0, decimals_max));
    return writer.out;
}

}  // namespace ingot::platform
