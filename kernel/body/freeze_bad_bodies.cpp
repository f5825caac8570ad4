// SPDX-License-Identifier: MIT
#include "freeze_bad_bodies.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

void zero_rows(scalar (*rows)[lanes], int lane_i, int count) {
    // bound: 9: numbers of a matrix
    for (int row_i = 0; row_i < count; ++row_i) rows[row_i][lane_i] = 0;
}

/// Neither force nor torque moves the body any more.
void make_immovable(const BodyView& bodies, Place at) {
    RotationTile& rotation = bodies.rotation[at.tile];
    for (auto& row : rotation.inv_I_ratio) row[at.lane] = scalar(1) / 3;
    rotation.inv_I_scale[at.lane] = 0;
    zero_rows(rotation.L, at.lane, 3);
    zero_rows(rotation.tau_T, at.lane, 3);
    if (bodies.compensation != nullptr) zero_rows(bodies.compensation[at.tile].A_low, at.lane, 9);
    if (bodies.energy != nullptr) bodies.energy[at.tile].E_0[at.lane] = 0;
    if (bodies.translation != nullptr) {
        TranslationTile& translation = bodies.translation[at.tile];
        translation.inv_M[at.lane] = 0;
        zero_rows(translation.v_CM, at.lane, 3);
        zero_rows(translation.F_T, at.lane, 3);
    }
}

}  // namespace

int freeze_bad_bodies(const BodyView& bodies) {
    int count = 0;
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        RotationTile& tile = bodies.rotation[tile_i];
        if (bodies.translation != nullptr) tile.bad = static_cast<uint16_t>(tile.bad | bodies.translation[tile_i].bad);
        if (tile.bad == 0) continue;
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            const bool movable = tile.inv_I_scale[lane_i] > 0;  // an immovable body is never marked: this is a new mark
            if ((tile.bad >> lane_i & 1u) == 0 || !movable) continue;
            make_immovable(bodies, {tile_i, lane_i});
            ++count;
        }
    }
    return count;
}

bool is_frozen(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    return (bodies.rotation[at.tile].bad >> at.lane & 1u) != 0;
}

void set_identity_body(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    make_immovable(bodies, at);
    const uint16_t others = static_cast<uint16_t>(~(1u << at.lane));
    RotationTile& rotation = bodies.rotation[at.tile];
    set_lane(rotation.A, at.lane, identity_matrix<scalar>());
    rotation.bad = static_cast<uint16_t>(rotation.bad & others);
    rotation.kicked = static_cast<uint16_t>(rotation.kicked & others);
    if (bodies.translation != nullptr) {
        TranslationTile& translation = bodies.translation[at.tile];
        set_lane(translation.r_CM, at.lane, Vector{});
        translation.bad = static_cast<uint16_t>(translation.bad & others);
    }
}

} }  // namespace ingot
