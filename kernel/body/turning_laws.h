// SPDX-License-Identifier: MIT
// How a free body turns, written once: see turning_inertia.h. Inertia says what spin a momentum is.
//
//     spin(A, L)                       omega, rad/s
//     slope(A, omega, L, scale)        by how much half the energy, times 2 scale, changes with a small turn
#pragma once

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "kinematics.h"
#include "turning_inertia.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of a body that turns about any axis.
struct FreeInertia {
    Vector inv_I_body;

    INGOT_INLINE Vector spin(const Matrix& A, const Vector& L) const { return spin_of(A, inv_I_body, L); }
    INGOT_INLINE SymmetricMatrix inverse_world(const Matrix& A) const { return inverse_inertia_world(A, inv_I_body); }
    static INGOT_INLINE Vector slope(const Matrix&, const Vector& omega, const Vector& L, scalar scale) { return cross(omega, L * scale); }
};

namespace turning {

/// The turn that takes L . omega, twice the energy, to what it should be, by Newton's method; 0 where it is that, to rounding. scale: one over a
/// moment of inertia of the body, so that neither mass nor size matters.
template <class Inertia>
Vector turn_back(const Inertia& inertia, const Matrix& A, const Vector& L, scalar scale, scalar twice_energy) {
    const Vector omega = inertia.spin(A, L), y = L * scale;
    const Vector x = inertia.slope(A, omega, L, scale);
    const scalar x_sq = length_sq(x), gain = (dot(y, omega) - twice_energy) / 2;
    if (!(x_sq > 0) || !(abs(gain) > limits::energy_rounding * twice_energy)) return {};
    return x * clamp(-gain / x_sq, limits::energy_turn_max / sqrt(x_sq));
}

template <class Inertia>
Matrix return_energy(const Inertia& inertia, const Matrix& A, const Vector& L, scalar twice_energy) {
    const scalar scale = inertia.inv_I_body.x + inertia.inv_I_body.y + inertia.inv_I_body.z;
    Matrix now = A;
    for (int i = 0; i < limits::energy_turns; ++i) {
        const Vector back = turn_back(inertia, now, L, scale, twice_energy * scale);
        if (back.x == 0 && back.y == 0 && back.z == 0) break;
        now = turned_about(now, back);
    }
    return now;
}

template <class Inertia>
Vector turn_freely(const Inertia& inertia, Matrix& A, const Vector& L, scalar h) {
    const Vector omega = inertia.spin(A, L);
    const scalar angle_sq = length_sq(omega) * h * h, twice_energy = dot(L, omega);
    int parts = 1;
    // bound: limits::turn_parts_max
    while (parts < limits::turn_parts_max && angle_sq > limits::turn_of_part * limits::turn_of_part * static_cast<scalar>(parts * parts)) ++parts;
    const scalar part = h / static_cast<scalar>(parts);
    Vector turned = {};
    for (int part_i = 0; part_i < parts; ++part_i) {  // bound: limits::turn_parts_max
        const Matrix middle = turned_about(A, inertia.spin(A, L) * (part / 2));
        const Vector turn = inertia.spin(middle, L) * part;
        A = return_energy(inertia, turned_about(A, turn * (1 + length_sq(turn) / 12)), L, twice_energy);  // the angle without Cayley's error
        turned += turn;
    }
    return turned;
}

}  // namespace turning

} }  // namespace ingot
