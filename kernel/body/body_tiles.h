// SPDX-License-Identifier: MIT
// Where bodies live: struct of arrays in tiles of `lanes` bodies. One pointer, constant offsets, no capacity in the code.
//
// A lane without a body holds the identity body (A = 1, all else zero): loops have no tail and never meet a NaN. The same
// values make a body immovable, so neither needs a mask.
#pragma once

#include "../math/sym3.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

inline constexpr int tile_alignment = static_cast<int>(sizeof(scalar)) * lanes;

/// Orientation and angular momentum of `lanes` bodies. The body frame is the principal frame of inertia.
struct alignas(tile_alignment) RotationTile {
    scalar A[9][lanes];            ///< body to world, columns c0 c1 c2
    scalar L[3][lanes];            ///< kg m^2 s^-1, world, about the centre of mass
    scalar tau_T[3][lanes];        ///< N m, world; summed until the next step
    /// Inverse moments about the principal axes: inv_I_body = inv_I_scale * inv_I_ratio. The scale is the power of two
    /// next above the sum of the three, so the product is exact and polynomials in the ratios neither overflow nor vanish.
    /// Immovable and empty lanes: scale 0, ratios 1/3.
    scalar inv_I_ratio[3][lanes];
    scalar inv_I_scale[lanes];     ///< kg^-1 m^-2
    uint16_t kicked;               ///< bit per lane: L was changed by something other than free flight
    uint16_t bad;                  ///< bit per lane: a stage met a value that is not finite; see freeze_bad_bodies
};

/// What A knows beyond its last bit (compensated sum); only for scenes whose rotation method compensates.
struct alignas(tile_alignment) CompensationTile {
    scalar A_low[9][lanes];  ///< the orientation is A + A_low
};

/// Energy at the begin of the free flight a body is in; only for scenes whose rotation method returns to it.
struct alignas(tile_alignment) EnergyTile {
    scalar E_0[lanes];  ///< in units of (h inv_I_scale)^2 J kg m^2, h that of the world's first step; 0: not known yet
};

/// Position and velocity of `lanes` bodies; only for scenes that translate.
struct alignas(tile_alignment) TranslationTile {
    scalar r_CM[3][lanes];  ///< m, world
    scalar v_CM[3][lanes];  ///< m s^-1, world
    scalar F_T[3][lanes];   ///< N, world; summed until the next step
    scalar inv_M[lanes];    ///< kg^-1; 0 for immovable and empty lanes
    scalar inv_I_world[6][lanes];  ///< kg^-1 m^-2, world; auxiliary, from A (Eq. 20), during a step with contacts
    uint16_t bad;           ///< as in RotationTile
};

/// What `lanes` bodies are pushed by in their own axes, summed until the next step; only for scenes with body_forces.
struct alignas(tile_alignment) BodyForceTile {
    scalar F_body[3][lanes];    ///< N
    scalar tau_body[3][lanes];  ///< N m, about the centre of mass
};

/// All bodies of a world, without its capacity: what stages work on. A pointer is null where the scene has no such part.
struct BodyView {
    RotationTile* rotation;
    TranslationTile* translation;
    CompensationTile* compensation;
    EnergyTile* energy;
    int tile_count;  ///< tiles that hold or held a body
};

/// One column or matrix of one lane. Row: LaneRow, or scalar[lanes].
template <class Row>
INGOT_INLINE Vector lane_of(const Row (&rows)[3], int lane_i) {
    return {rows[0][lane_i], rows[1][lane_i], rows[2][lane_i]};
}
template <class Row>
INGOT_INLINE Matrix lane_of(const Row (&rows)[9], int lane_i) {
    return {{rows[0][lane_i], rows[1][lane_i], rows[2][lane_i]},
            {rows[3][lane_i], rows[4][lane_i], rows[5][lane_i]},
            {rows[6][lane_i], rows[7][lane_i], rows[8][lane_i]}};
}
template <class Row>
INGOT_INLINE SymmetricMatrix lane_of(const Row (&rows)[6], int lane_i) {
    return {rows[0][lane_i], rows[1][lane_i], rows[2][lane_i], rows[3][lane_i], rows[4][lane_i], rows[5][lane_i]};
}
template <class Row>
INGOT_INLINE void set_lane(Row (&rows)[3], int lane_i, const Vector& value) {
    rows[0][lane_i] = value.x;
    rows[1][lane_i] = value.y;
    rows[2][lane_i] = value.z;
}
template <class Row>
INGOT_INLINE void set_lane(Row (&rows)[9], int lane_i, const Matrix& value) {
    const scalar entries[9] = {value.c0.x, value.c0.y, value.c0.z, value.c1.x, value.c1.y,
                               value.c1.z, value.c2.x, value.c2.y, value.c2.z};
    for (int row_i = 0; row_i < 9; ++row_i) rows[row_i][lane_i] = entries[row_i];
}
template <class Row>
INGOT_INLINE void set_lane(Row (&rows)[6], int lane_i, const SymmetricMatrix& value) {
    const scalar entries[6] = {value.xx, value.yy, value.zz, value.xy, value.xz, value.yz};
    for (int row_i = 0; row_i < 6; ++row_i) rows[row_i][lane_i] = entries[row_i];
}

inline constexpr uint16_t all_lanes = static_cast<uint16_t>((1ul << lanes) - 1ul);
/// True for lanes that are all there is: always, with one lane.
INGOT_INLINE constexpr bool is_all(uint16_t lane_bits) { return lanes == 1 || lane_bits == all_lanes; }

/// Marks one body of a tile.
inline void mark_lane_bad(uint16_t& bad, int lane_i) { bad = static_cast<uint16_t>(bad | 1u << lane_i); }
/// Marks the bodies of a tile that are not good.
INGOT_INLINE void mark_bad(uint16_t& bad, mask good) {
    const mask lost = opposite(good);
    if (any(lost)) bad = static_cast<uint16_t>(bad | bits(lost));
}

/// Stores `next` where no component is beyond the limit; where one is, or is NaN, the old value stays and the body is marked
/// bad.
INGOT_INLINE void store_if_within(scalar limit, scalar (&to)[3][lanes], const Vec3<lane>& next, uint16_t& bad) {
    const lane most = splat<lane>(limit);
    const mask good = both(both(abs(next.x) <= most, abs(next.y) <= most), abs(next.z) <= most);
    store(to, select(good, next, load(to)));
    mark_bad(bad, good);
}

/// Tile and lane of a body slot.
struct Place {
    int tile, lane;
};
INGOT_INLINE constexpr Place place_of(int slot) { return {slot / lanes, slot % lanes}; }

INGOT_INLINE Vector r_CM_of(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    return lane_of(bodies.translation[at.tile].r_CM, at.lane);
}
INGOT_INLINE Vector v_CM_of(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    return lane_of(bodies.translation[at.tile].v_CM, at.lane);
}

/// True for a body that can move: neither immovable nor frozen.
INGOT_INLINE bool is_dynamic(const BodyView& bodies, int slot) {
    return bodies.rotation[place_of(slot).tile].inv_I_scale[place_of(slot).lane] > 0;
}

} }  // namespace ingot

#pragma GCC diagnostic pop
