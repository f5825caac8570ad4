// SPDX-License-Identifier: MIT
// A hardware counter of 32 bits made into one of 64.
#pragma once

#include <stdint.h>

namespace ingot::platform {

/// Extends an upward 32-bit counter that wraps on its own.
///
/// The difference of two readings modulo 2^32 is exact whether or not the counter wrapped between them, as long as it did
/// not wrap twice. So there is no wrap flag and no interrupt to race with; the price is that somebody has to read it once
/// per 2^32 ticks.
///
/// A zeroed extension is valid: it counts from a counter value of 0. Not safe against interrupts by itself; the caller
/// holds them off.
struct CounterExtension {
    uint64_t total;  ///< ticks
    uint32_t last;   ///< counter value at the last call

    /// Begins again at zero ticks, with the counter standing at `now`.
    void restart(uint32_t now) {
        total = 0;
        last = now;
    }

    /// Ticks since restart(), `now` being the counter.
    uint64_t extend(uint32_t now) {
        total += static_cast<uint32_t>(now - last);
        last = now;
        return total;
    }
};

}  // namespace ingot::platform
