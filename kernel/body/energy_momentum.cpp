// SPDX-License-Identifier: MIT
#include "energy_momentum.h"

#include "auxiliary.h"

namespace ingot { inline namespace INGOT_ABI {

Vector linear_momentum_of(const BodyView& bodies, int slot) {
    if (bodies.translation == nullptr) return {};
    const Place at = place_of(slot);
    const TranslationTile& tile = bodies.translation[at.tile];
    const scalar inv_M = tile.inv_M[at.lane];
    if (!(inv_M > 0)) return {};
    return lane_of(tile.v_CM, at.lane) * (1 / inv_M);
}

scalar kinetic_energy_of(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    const RotationTile& rotation = bodies.rotation[at.tile];
    scalar twice = dot(lane_of(rotation.L, at.lane), omega_of(bodies, slot));
    if (bodies.translation != nullptr)
        twice += dot(lane_of(bodies.translation[at.tile].v_CM, at.lane), linear_momentum_of(bodies, slot));
    return twice * scalar(0.5);
}

Vector angular_momentum_of(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    const Vector L = lane_of(bodies.rotation[at.tile].L, at.lane);
    if (bodies.translation == nullptr) return L;
    return L + cross(lane_of(bodies.translation[at.tile].r_CM, at.lane), linear_momentum_of(bodies, slot));
}

scalar kinetic_energy_of_all(const BodyView& bodies) {
    scalar sum = 0;
    // bound: max_bodies, rounded up to whole tiles
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot) sum += kinetic_energy_of(bodies, slot);
    return sum;
}

Vector linear_momentum_of_all(const BodyView& bodies) {
    Vector sum{};
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot) sum += linear_momentum_of(bodies, slot);
    return sum;
}

Vector angular_momentum_of_all(const BodyView& bodies) {
    Vector sum{};
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot) sum += angular_momentum_of(bodies, slot);
    return sum;
}

} }  // namespace ingot
