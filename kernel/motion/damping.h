// SPDX-License-Identifier: MIT
// Velocities that die away by themselves, each body by rates of its own.
#pragma once

#include "../base/limits.h"
#include "../base/status.h"
#include "../body/body_tiles.h"
#include "../math/decay_share.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of a body, in 1/s: without forces v_CM goes as exp(-linear t), L as exp(-angular t).
struct Damping {
    scalar linear = 0, angular = 0;  ///< 1/s, 0 to limits::damping_max
};

/// Errors: not_finite, out_of_range (outside 0 .. limits::damping_max).
constexpr Status check_damping(const Damping& damping) {
    if (!is_finite(damping.linear) || !is_finite(damping.angular)) return Status::not_finite;
    const auto in_range = [](scalar rate) { return rate >= 0 && rate <= limits::damping_max; };
    return in_range(damping.linear) && in_range(damping.angular) ? Status::ok : Status::out_of_range;
}

/// F_T and tau_T += what takes this share of v_CM and of L away in h seconds: exact for a body without other forces, at any h.
///
/// As forces, so that contacts, flights and r_CM see them: what rests presses with all of its weight. A body that falls comes to rest at the speed
/// g h / (1 - exp(-c h)), which is g / c and c h / 2 of it more.
inline void add_damping(const BodyView& bodies, const Damping& damping, scalar h, int slot) {
    const Place at = place_of(slot);
    RotationTile& rotation = bodies.rotation[at.tile];
    if (damping.angular > 0 && is_dynamic(bodies, slot)) {
        const Vector L = lane_of(rotation.L, at.lane);
        set_lane(rotation.tau_T, at.lane, lane_of(rotation.tau_T, at.lane) - L * (decay_share(damping.angular * h) / h));
    }
    if (bodies.translation == nullptr) return;
    TranslationTile& translation = bodies.translation[at.tile];
    const scalar inv_M = translation.inv_M[at.lane];
    if (!(damping.linear > 0 && inv_M > 0)) return;
    const Vector v_CM = lane_of(translation.v_CM, at.lane);
    set_lane(translation.F_T, at.lane, lane_of(translation.F_T, at.lane) - v_CM * (decay_share(damping.linear * h) / (h * inv_M)));
}

} }  // namespace ingot
