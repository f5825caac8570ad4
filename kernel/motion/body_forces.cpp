// SPDX-License-Identifier: MIT
#include "body_forces.h"

#include "../base/limits.h"

namespace ingot { inline namespace INGOT_ABI {

void push_in_body(const BodyView& bodies, const BodyForceTile* forces, scalar h) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        if (!any_pushed(forces[tile_i])) continue;
        RotationTile& rotation = bodies.rotation[tile_i];
        const Mat3<lane> A = load(rotation.A);
        const lane step = select(load(rotation.inv_I_scale) > lane{}, splat<lane>(h), lane{});
        const Vec3<lane> kick = A * load(forces[tile_i].tau_body) * step;
        const auto kicked = abs(kick.x) + abs(kick.y) + abs(kick.z) > lane{};
        store_if_within(scalar_max, rotation.L, load(rotation.L) + kick, rotation.bad);
        rotation.kicked = static_cast<uint16_t>(rotation.kicked | bits(kicked));
        if (bodies.translation == nullptr) continue;
        TranslationTile& translation = bodies.translation[tile_i];
        const Vec3<lane> a = A * load(forces[tile_i].F_body) * load(translation.inv_M);
        store_if_within(limits::speed_runaway, translation.v_CM, load(translation.v_CM) + a * step, translation.bad);
    }
}

void clear_forces_in_body(BodyForceTile* forces, int tile_count) {
    for (int tile_i = 0; tile_i < tile_count; ++tile_i) clear_forces(forces[tile_i]);  // bound: max_bodies / lanes, rounded up
}

} }  // namespace ingot
