// SPDX-License-Identifier: MIT
#pragma once

#include "../math/vec3.h"
#include "state_hash.h"

namespace ingot { inline namespace INGOT_ABI {

/// Makes one number of all that it is given.
class Signature {
public:
    constexpr void operator()(const char* text) {
        // bound: a name ends with a zero; computed by the compiler
        for (; *text != 0; ++text) hash_ = (hash_ ^ static_cast<uint8_t>(*text)) * 0x100000001b3u;
        hash_ *= 0x100000001b3u;
    }
    template <class T>
    constexpr void operator()(const T& number) {
        const uint64_t bits = static_cast<uint64_t>(number);
        for (int byte_i = 0; byte_i < 8; ++byte_i) hash_ = (hash_ ^ (bits >> (8 * byte_i) & 0xffu)) * 0x100000001b3u;
    }
    constexpr void operator()(const scalar& number) { (*this)(static_cast<int64_t>(number * scalar(1 << 30))); }
    constexpr void operator()(const Vector& v) {
        (*this)(v.x);
        (*this)(v.y);
        (*this)(v.z);
    }
    constexpr uint64_t hash() const { return hash_; }

private:
    uint64_t hash_ = state_hash_seed;
};

} }  // namespace ingot
