// SPDX-License-Identifier: MIT
#include "compound.h"

#include "../body/auxiliary.h"

namespace ingot { inline namespace INGOT_ABI {

void place_shapes(const BodyView& bodies, const CompoundView& compounds, int slot) {
    const Place from = place_of(slot);
    const TranslationTile& body = bodies.translation[from.tile];
    const Matrix A = lane_of(bodies.rotation[from.tile].A, from.lane);
    const Vector r_CM = lane_of(body.r_CM, from.lane), v_CM = lane_of(body.v_CM, from.lane), omega = omega_of(bodies, slot);

    const int first = slot * compounds.shapes_of_body;
    // bound: max_shapes_of_body from first on
    for (int shape_slot = first; shape_slot < first + compounds.shapes_of_body; ++shape_slot) {
        if (compounds.surfaces[shape_slot].shape.kind == ShapeKind::none) continue;
        const ShapePlace& place = compounds.places[shape_slot];
        const Place to = place_of(shape_slot);
        RotationTile& rotation = compounds.shapes.rotation[to.tile];
        TranslationTile& translation = compounds.shapes.translation[to.tile];
        set_lane(translation.r_CM, to.lane, r_CM + A * place.r);
        set_lane(translation.v_CM, to.lane, v_CM);
        translation.inv_M[to.lane] = body.inv_M[from.lane];
        set_lane(rotation.A, to.lane, A * place.A);
        set_lane(rotation.L, to.lane, omega);
        set_lane(rotation.inv_I_ratio, to.lane, Vector{1, 1, 1});
        rotation.inv_I_scale[to.lane] = 1;
    }
}

} }  // namespace ingot
