// SPDX-License-Identifier: MIT
#pragma once

#include "../math/sym3.h"

namespace ingot { inline namespace INGOT_ABI {

/// What Figure 4 needs to know of a body that collides at a point P. An immovable body has inv_M = 0, inv_I_world = 0.
struct CollidingBody {
    scalar inv_M{};               ///< kg^-1
    SymmetricMatrix inv_I_world{};  ///< kg^-1 m^-2, world axes
    Vector v_CM{};                ///< m/s
    Vector omega{};               ///< rad/s, world axes
    Vector r_P{};                 ///< m, from the centre of mass to P, world axes
};

/// The impulse between two bodies that collide at a point P without friction.
///
///     j = -(1+e) (v_AP - v_BP).n / (1/M_A + 1/M_B + [(I_A^-1 (r_AP x n)) x r_AP + (I_B^-1 (r_BP x n)) x r_BP] . n)
///
/// A receives +j n at P, B receives -j n: v_CM += j n / M, L += r_P x j n.
/// Needs:   |n| = 1, n from B to A; 0 <= e <= 1; at least one of the bodies moves.
/// Units:   N s. Zero when the points separate or rest, (v_AP - v_BP).n >= 0.
/// Source:  Hecker 1997, Fig. 4.
scalar collision_impulse(const CollidingBody& A, const CollidingBody& B, const Vector& n, scalar e);

} }  // namespace ingot
