// SPDX-License-Identifier: MIT
// What surfaces may have beside friction and restitution, for scenes that name it: resistance to being rolled, and a velocity of their own.
//
// Both are kept by shape slot, apart from Surface. Those of a pair are made anew in every step, so they may be changed while bodies touch.
#pragma once

#include "../narrow_phase/manifold_record.h"

namespace ingot { inline namespace INGOT_ABI {

/// What surfaces have beside friction and restitution, by shape slot; null where the scene names none.
struct ShapeMaterials {
    const scalar* rolling_levers;      ///< m
    const Vector* surface_velocities;  ///< m/s, in the shape's axes
};

/// Rolling resistance of two bodies that touch.
struct RollingRecord {
    scalar lever;  ///< m; of the two, the larger
    Vector j;      ///< N m s, world, given to A in the last substep
};

/// By record, for all pairs that touch. A pair that has just begun to touch has no impulse yet, whichever pair had its record before.
/// lever_of_shape: m, by the slots that manifolds name.
void mix_rolling_levers(const ManifoldView& manifolds, const scalar* lever_of_shape, RollingRecord* of_record);

/// How fast the surface of A moves over A, less that of B over B; m/s, world, by record.
/// velocity_of_shape: m/s, in the shape's own axes; shapes: as bodies, where they are.
void turn_surface_velocities(const BodyView& shapes, const ManifoldView& manifolds, const Vector* velocity_of_shape, Vector* of_record);

} }  // namespace ingot
