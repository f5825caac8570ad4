// SPDX-License-Identifier: MIT
// The door: what a body must be before it may enter a world. Ranges stand in base/limits.h.
#pragma once

#include "../base/limits.h"
#include "mass_properties.h"

namespace ingot { inline namespace INGOT_ABI {

/// The primary state of a body (Hecker 1997): the body frame has its origin at the centre of mass and lies along the
/// principal axes of inertia.
struct BodyState {
    Vector r_CM{};                             ///< m, world
    Vector v_CM{};                             ///< m/s, world
    Matrix A = identity_matrix<scalar>();      ///< body to world
    Vector L{};                                ///< kg m^2/s, world, about the centre of mass
};

/// Errors: not_finite, bad_mass, bad_inertia (a moment outside limits::inertia_min .. inertia_max, larger than the sum of
///         the other two, or limits::inertia_ratio_max times the smallest).
Status check_mass_properties(const MassProperties& mass);

/// Errors: not_finite, not_a_rotation.
Status check_rotation(const Matrix& A);

/// Errors: those of check_rotation, out_of_range (beyond limits::position_max, speed_max, spin_max).
Status check_state(const BodyState& state, const Vector& inv_I_body);

/// Errors: not_finite, out_of_range (a component beyond the limit).
Status check_vector(const Vector& v, scalar limit);

/// Errors: bad_step.
constexpr Status check_step(scalar h) {
    return h >= limits::step_min && h <= limits::step_max ? Status::ok : Status::bad_step;
}

/// The rotation next to A. An A orthonormal to rounding is returned bitwise; -0 becomes +0 in every entry.
Matrix nearest_rotation(const Matrix& A);

/// What one step towards it adds to A: polar_correction, as code that is there once.
Matrix correction_of_rotation(const Matrix& A);

/// The inverse principal moments as body tiles keep them (see RotationTile).
struct ScaledInverseInertia {
    Vector ratio;
    scalar scale;  ///< a power of two, kg^-1 m^-2
};
ScaledInverseInertia scaled_inverse_inertia(const Vector& I_body);

} }  // namespace ingot
