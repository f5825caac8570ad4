// SPDX-License-Identifier: MIT
#include "turning_inertia.h"

#include "turning_laws.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

Vector turned_about(const Vector& a, const Vector& turn) {
    const Vector c = turn * scalar(0.5), x = cross(c, a);
    return a + (x + cross(c, x)) * (2 / (1 + length_sq(c)));
}

}  // namespace

bool turns_inertia(const Vector& inv_I_ratio, const Vector& turn) {
    const scalar least = min(inv_I_ratio.x, min(inv_I_ratio.y, inv_I_ratio.z)), most = max(inv_I_ratio.x, max(inv_I_ratio.y, inv_I_ratio.z));
    const scalar spread = most - least, felt = limits::inertia_turn * least;
    return length_sq(turn) * (spread * spread) > felt * felt;
}

Matrix turned_about(const Matrix& A, const Vector& turn) {
    const Matrix turned = {turned_about(A.c0, turn), turned_about(A.c1, turn), turned_about(A.c2, turn)};
    return turned + polar_correction(turned);
}

Matrix return_energy(const Matrix& A, const Vector& inv_I_body, const Vector& L, scalar twice_energy) {
    return turning::return_energy(FreeInertia{inv_I_body}, A, L, twice_energy);
}

Vector turn_freely(Matrix& A, const Vector& inv_I_body, const Vector& L, scalar h) { return turning::turn_freely(FreeInertia{inv_I_body}, A, L, h); }

} }  // namespace ingot
