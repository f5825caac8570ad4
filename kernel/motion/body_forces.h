// SPDX-License-Identifier: MIT
// Forces and torques that turn with their body over a step: engines, fins, reaction wheels.
#pragma once

#include "force_field.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// Those of a tile as a field, so that a step takes them as it takes fields: add_field_forces_to with ahead = h/2 is of second order in the turn.
struct HeldInBody : ForceField {
    static constexpr bool depends_on_velocity = false;
    const BodyForceTile& tile;

    INGOT_INLINE explicit HeldInBody(const BodyForceTile& of) : tile(of) {}
    INGOT_INLINE Wrench operator()(const BodyMotion& body) const { return {body.A * load(tile.F_body), body.A * load(tile.tau_body)}; }
};

/// True where some body of the tile is pushed.
INGOT_INLINE bool any_pushed(const BodyForceTile& tile) {
    const Vec3<lane> F = load(tile.F_body), tau = load(tile.tau_body);
    return any((abs(F.x) + abs(F.y) + abs(F.z)) + (abs(tau.x) + abs(tau.y) + abs(tau.z)) > lane{});
}

/// The sums of the next step begin.
INGOT_INLINE void clear_forces(BodyForceTile& tile) {
    store(tile.F_body, Vec3<lane>{});
    store(tile.tau_body, Vec3<lane>{});
}

/// L += h A tau_body, and v_CM += h A F_body / M where the scene translates: forces that turn with their bodies, as these stand. With h/2 before a
/// free flight and h/2 after it the step is of second order, and half as far off as with the whole of it, turned to where the body will be in the
/// middle. What would not be finite marks its body bad.
///
/// Shapes:  forces: a tile for each of bodies. Units: h in s. Cost: 42 flops a body, of tiles where some body is pushed.
void push_in_body(const BodyView& bodies, const BodyForceTile* forces, scalar h);

/// The sums of the next step begin.
void clear_forces_in_body(BodyForceTile* forces, int tile_count);

} }  // namespace ingot

#pragma GCC diagnostic pop
