// SPDX-License-Identifier: MIT
// What lengths of contacts are measured by. Those of limits.h (contact_margin, touching_gap) are in units of the scene's length_unit, the size of a
// typical thing; a thin shape halves them, as often as it takes, until they are small beside its least half extent. So a coin of a millimetre is no
// margin thick, and worlds whose lengths, speeds and length_unit are a power of two apart go the same way to the bit.
#pragma once

#include "if.h"
#include "limits.h"

namespace ingot { inline namespace INGOT_ABI {

/// 2^-halvings, 0 .. limits::halvings_max: put together from its bits.
INGOT_INLINE scalar half_to_the(unsigned halvings) {
    using Bits = If<INGOT_DOUBLE != 0, uint64_t, uint32_t>;
    constexpr unsigned digits = INGOT_DOUBLE ? 52 : 23, one = INGOT_DOUBLE ? 1023 : 127;
    const Bits bits_of_it = static_cast<Bits>(one - halvings) << digits;
    scalar x = 0;
    INGOT_COPY_BYTES(&x, &bits_of_it, sizeof x);
    return x;
}

/// What lengths of contacts are measured by that are halved so many times, m.
INGOT_INLINE scalar scale_of(scalar unit, unsigned halvings) { return unit * half_to_the(halvings); }

/// How many times a shape halves them: until limits::thin_extent is no more than its least half extent, m.
INGOT_INLINE uint8_t halvings_of(scalar least_half_extent, scalar unit) {
    unsigned halvings = 0;
    // bound: limits::halvings_max
    while (halvings < limits::halvings_max && least_half_extent < limits::thin_extent * scale_of(unit, halvings)) ++halvings;
    return static_cast<uint8_t>(halvings);
}

/// How far apart two shapes may be and still have a manifold, m, beside what they travel: contact_margin at that scale; but where that is less than
/// what gravity moves a body from rest in the step, `fall`, as much as that, up to contact_margin of the unit.
INGOT_INLINE scalar margin_at(scalar scale, scalar unit, scalar fall) {
    const scalar margin = limits::contact_margin * scale, most = limits::contact_margin * unit;
    return margin < fall ? (fall < most ? fall : most) : margin;
}

} }  // namespace ingot
