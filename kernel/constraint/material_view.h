// SPDX-License-Identifier: MIT
// What the solver works on in scenes whose surfaces resist being rolled, or move by themselves. Stages are templates over the view: of one without,
// nothing of this is compiled in.
#pragma once

#include "surface_materials.h"
#include "solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Rolling resistance of lanes manifolds: a torque about t_1 and t_2 against the turn of A relative to B, within a circle: |j| <= lever N.
///
/// The load is carried not at the middle of the contact but up to `lever` ahead of it, which is the classical coefficient of rolling friction.
/// So a ball of radius R slows by (5/7) g lever / R, and rests up to tan(alpha) = lever / R.
/// Source: as a cone beside that of friction, Tasora and Anitescu, "A complementarity-based rolling friction model for rigid contacts",
/// Meccanica 48 (2013). Of their three coefficients this is the rolling one; spin about n is resisted by areas alone, see TorsionRow.
struct RollingRows {
    scalar lever[lanes];                         ///< m
    scalar k_A[2][3][lanes], k_B[2][3][lanes];   ///< inv_I_world t, and its opposite
    scalar K[2][lanes];                          ///< compliance: 11, 22
    scalar inv_K[3][lanes], inv_K_max[lanes];    ///< as in FrictionPair
    scalar size[lanes];                          ///< m; radius of gyration: what turns an angular velocity into a speed worth settling
    scalar j[2][lanes], j_sweep[2][lanes], direction[2][lanes];  ///< N m s
};

/// m/s, along t_1 and t_2: by so much the surface of A goes faster than A does, relative to that of B. Friction brings surfaces to rest upon each
/// other, not bodies.
struct BeltRows {
    scalar speed[2][lanes];
};

template <bool surfaces_roll, bool surfaces_move>
struct MaterialView : SolverView {
    static constexpr bool rolls = surfaces_roll, has_belts = surfaces_move;

    RollingRows* rolling;           ///< by block; null where the scene has none
    RollingRecord* rolling_records; ///< by record
    BeltRows* belts;                ///< by block; null where the scene has none
    const Vector* belt_velocities;  ///< by record, m/s, world
};
using RollingView = MaterialView<true, false>;
using BeltView = MaterialView<false, true>;
using RollingBeltView = MaterialView<true, true>;

} }  // namespace ingot
