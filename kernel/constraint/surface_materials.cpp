// SPDX-License-Identifier: MIT
#include "surface_materials.h"

namespace ingot { inline namespace INGOT_ABI {

void mix_rolling_levers(const ManifoldView& manifolds, const scalar* lever_of_shape, RollingRecord* of_record) {
    for (int pair_i = 0; pair_i < *manifolds.count; ++pair_i) {  // bound: max_manifolds
        const BodyPair& pair = manifolds.pairs[pair_i];
        const scalar A = lever_of_shape[pair.body_A], B = lever_of_shape[pair.body_B];
        RollingRecord& record = of_record[pair.record];
        record.lever = A > B ? A : B;
        if (age_of(manifolds.records[pair.record]) == 0) record.j = {};
    }
}

void turn_surface_velocities(const BodyView& shapes, const ManifoldView& manifolds, const Vector* velocity_of_shape, Vector* of_record) {
    const auto in_world = [&](int slot) {
        const Place at = place_of(slot);
        return lane_of(shapes.rotation[at.tile].A, at.lane) * velocity_of_shape[slot];
    };
    for (int pair_i = 0; pair_i < *manifolds.count; ++pair_i) {
        const BodyPair& pair = manifolds.pairs[pair_i];
        of_record[pair.record] = in_world(pair.body_A) - in_world(pair.body_B);
    }
}

} }  // namespace ingot
