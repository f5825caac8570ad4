// SPDX-License-Identifier: MIT
// Bodies that do not move along some axes of the world, or do not turn about some: games in a plane, characters that never tip over.
//
// A lock is an ideal constraint, v_i = 0 or omega_i = 0. Its impulse does no work, and it is whatever keeps the other equations as they are:
//
//     v_F = p_F / M                    F: the axes that are free, p = M v
//     omega_F = (I_FF)^-1 L_F          I = A Ibar A^T, of which I_FF has the rows and columns of the free axes
//
// Of all motions with this p_F and L_F it is that of the least energy, and v_locked = omega_locked = 0. So a body shows impulses the inverse mass 1/M
// along free axes and 0 along the others, and the inverse inertia
//
//     W = E (I_FF)^-1 E^T              E: the columns of the unit matrix of the free axes
//
// which is not A Ibar^-1 A^T without rows: that would be a body which is turned back after each impulse, and loses energy by it. L of such a body is
// its whole angular momentum, I omega; what the locks bear is in the part of it along locked axes, which hold_motion makes anew.
// Source: Gauss' principle of least constraint; the inverse of a block of two by the determinant of the third, Jacobi's complementary minors.
#pragma once

#include "body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// Bits of BodyDef::locks and World::set_locks; axes of the world.
struct AxisLocks {
    static constexpr unsigned translate_x = 1, translate_y = 2, translate_z = 4, rotate_x = 8, rotate_y = 16, rotate_z = 32;
    static constexpr unsigned translation = 7, rotation = 56, all = 63;
    /// What is left to a body that moves in a plane.
    static constexpr unsigned to_plane_xy = translate_z | rotate_x | rotate_y, to_plane_xz = translate_y | rotate_x | rotate_z,
                              to_plane_yz = translate_x | rotate_y | rotate_z;
};

/// Bit per axis, x first.
INGOT_INLINE unsigned translations_locked(unsigned locks) { return locks & 7u; }
INGOT_INLINE unsigned rotations_locked(unsigned locks) { return locks >> 3; }

/// v without its parts along locked axes. axes: a bit each.
INGOT_INLINE Vector free_part(const Vector& v, unsigned axes) {
    return {(axes & 1u) != 0 ? 0 : v.x, (axes & 2u) != 0 ? 0 : v.y, (axes & 4u) != 0 ? 0 : v.z};
}
/// v along free axes, and other along locked ones.
INGOT_INLINE Vector free_part_or(const Vector& v, const Vector& other, unsigned axes) {
    return {(axes & 1u) != 0 ? other.x : v.x, (axes & 2u) != 0 ? other.y : v.y, (axes & 4u) != 0 ? other.z : v.z};
}

/// W, kg^-1 m^-2, of a body whose turns about some axes are locked; with none, inverse_inertia_world. Its rows of locked axes are 0 to the bit. Sums
/// of positive terms alone: nothing cancels, whatever the ratio of the moments. Cost: 60 flops.
SymmetricMatrix inverse_inertia_of_free(const Matrix& A, const Vector& inv_I_body, unsigned axes);

/// What turns a body with locks: see turning_laws.h. Without one it is FreeInertia, to the bit.
struct LockedInertia {
    Vector inv_I_body;
    unsigned axes;  ///< that are locked

    Vector spin(const Matrix& A, const Vector& L) const;
    SymmetricMatrix inverse_world(const Matrix& A) const { return inverse_inertia_of_free(A, inv_I_body, axes); }
    /// All of the angular momentum of a spin, kg m^2 s^-1.
    Vector momentum(const Matrix& A, const Vector& omega) const;
    /// Twice the change of energy by a small turn x is 2 x . slope, of turns about free axes.
    Vector slope(const Matrix& A, const Vector& omega, const Vector& L, scalar scale) const;
};
/// Of the body of a slot.
LockedInertia locked_inertia_of(const BodyView& bodies, int slot, unsigned locks);

/// v_CM and L of a body with locks: nothing along locked axes, and of L what is felt there.
void hold_motion(const BodyView& bodies, int slot, unsigned locks);

/// Forces of the step along locked axes, and torques about them, are borne. gravity: m s^-2, which is added to F_T / M.
void hold_forces(const BodyView& bodies, int slot, unsigned locks, const Vector& gravity);

/// A as a body with locks turns it in h seconds, from L along free axes. About one free axis it turns by omega h, exactly, for its inertia stays the
/// same; about two in parts of limits::locked_turn_of_part, to fourth order, with its energy to rounding. Cost: about 2000 flops a part.
Matrix turned_with_locks(const Matrix& A, const LockedInertia& inertia, const Vector& L, scalar h);

/// A after anything else has turned it, from what it was: about one free axis the row of it stays to the bit, without one all of it.
Matrix hold_attitude(const Matrix& before, const Matrix& A, unsigned axes);

} }  // namespace ingot
