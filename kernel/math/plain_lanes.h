// SPDX-License-Identifier: MIT
// The lane type without vectors, for lanes.h: `lanes` numbers side by side, each operation in each of them. What vectors of a compiler do with
// operators stands here, and no more.
#pragma once

#include "../base/config.h"

#if INGOT_STANDARD_CPP && INGOT_LANES > 1

namespace ingot { inline namespace INGOT_ABI {

/// True or false in each lane.
struct mask {
    bool at[lanes];

    INGOT_INLINE constexpr bool operator[](int lane_i) const { return at[lane_i]; }
};

struct alignas(sizeof(scalar) * static_cast<unsigned>(lanes)) lane {
    scalar at[lanes];

    INGOT_INLINE constexpr scalar& operator[](int lane_i) { return at[lane_i]; }
    INGOT_INLINE constexpr scalar operator[](int lane_i) const { return at[lane_i]; }
};

/// of(lane_i) for each.
template <class Of>
INGOT_INLINE constexpr lane each_lane(const Of& of) {
    lane value{};
    for (int lane_i = 0; lane_i < lanes; ++lane_i) value.at[lane_i] = of(lane_i);
    return value;
}
template <class Of>
INGOT_INLINE constexpr mask each_mask(const Of& of) {
    mask value{};
    for (int lane_i = 0; lane_i < lanes; ++lane_i) value.at[lane_i] = of(lane_i);
    return value;
}

INGOT_INLINE constexpr lane operator-(const lane& a) {
    return each_lane([&](int lane_i) { return -a.at[lane_i]; });
}

// Of two lanes, of a lane and a number, of a number and a lane.
#define INGOT_OF_LANES(sign, Answer, each)                                       \
    INGOT_INLINE constexpr Answer operator sign(const lane& a, const lane& b) {  \
        return each([&](int lane_i) { return a.at[lane_i] sign b.at[lane_i]; }); \
    }                                                                            \
    INGOT_INLINE constexpr Answer operator sign(const lane& a, scalar b) {       \
        return each([&](int lane_i) { return a.at[lane_i] sign b; });            \
    }                                                                            \
    INGOT_INLINE constexpr Answer operator sign(scalar a, const lane& b) {       \
        return each([&](int lane_i) { return a sign b.at[lane_i]; });            \
    }
INGOT_OF_LANES(+, lane, each_lane)
INGOT_OF_LANES(-, lane, each_lane)
INGOT_OF_LANES(*, lane, each_lane)
INGOT_OF_LANES(/, lane, each_lane)
INGOT_OF_LANES(<, mask, each_mask)
INGOT_OF_LANES(<=, mask, each_mask)
INGOT_OF_LANES(>, mask, each_mask)
INGOT_OF_LANES(>=, mask, each_mask)
INGOT_OF_LANES(==, mask, each_mask)
INGOT_OF_LANES(!=, mask, each_mask)
#undef INGOT_OF_LANES

template <class T>
INGOT_INLINE constexpr lane& operator+=(lane& a, const T& b) {
    return a = a + b;
}
template <class T>
INGOT_INLINE constexpr lane& operator-=(lane& a, const T& b) {
    return a = a - b;
}
template <class T>
INGOT_INLINE constexpr lane& operator*=(lane& a, const T& b) {
    return a = a * b;
}

INGOT_INLINE lane load(const scalar* from) {
    return each_lane([&](int lane_i) { return from[lane_i]; });
}
INGOT_INLINE void store(scalar* to, const lane& value) {
    for (int lane_i = 0; lane_i < lanes; ++lane_i) to[lane_i] = value.at[lane_i];
}
INGOT_INLINE constexpr lane select(const mask& m, const lane& a, const lane& b) {
    return each_lane([&](int lane_i) { return m.at[lane_i] ? a.at[lane_i] : b.at[lane_i]; });
}
INGOT_INLINE uint16_t bits(const mask& m) {
    uint16_t b = 0;
    for (int lane_i = 0; lane_i < lanes; ++lane_i) b = static_cast<uint16_t>(b | (m.at[lane_i] ? 1u << lane_i : 0u));
    return b;
}
INGOT_INLINE bool any(const mask& m) { return bits(m) != 0; }
INGOT_INLINE mask mask_from_bits(uint16_t b) {
    return each_mask([&](int lane_i) { return (b >> lane_i & 1u) != 0; });
}

INGOT_INLINE constexpr mask both(const mask& a, const mask& b) {
    return each_mask([&](int lane_i) { return a.at[lane_i] && b.at[lane_i]; });
}
INGOT_INLINE constexpr mask either(const mask& a, const mask& b) {
    return each_mask([&](int lane_i) { return a.at[lane_i] || b.at[lane_i]; });
}
INGOT_INLINE constexpr mask opposite(const mask& a) {
    return each_mask([&](int lane_i) { return !a.at[lane_i]; });
}

} }  // namespace ingot

#endif
