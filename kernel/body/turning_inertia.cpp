// SPDX-License-Identifier: MIT
#include "turning_inertia.h"

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "kinematics.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

Vector turned_about(const Vector& a, const Vector& turn) {
    const Vector c = turn * scalar(0.5), x = cross(c, a);
    return a + (x + cross(c, x)) * (2 / (1 + length_sq(c)));
}

/// The turn that takes y . omega, twice the energy, to what it should be, by Newton's method; 0 where it is that, to rounding. y: L over a moment of
/// inertia of the body, and the energy likewise, so that neither mass nor size matters.
Vector turn_back(const Vector& omega, const Vector& y, scalar twice_energy) {
    const Vector x = cross(omega, y);
    const scalar x_sq = length_sq(x), gain = (dot(y, omega) - twice_energy) / 2;
    if (!(x_sq > 0) || !(abs(gain) > limits::energy_rounding * twice_energy)) return {};
    return x * clamp(-gain / x_sq, limits::energy_turn_max / sqrt(x_sq));
}
bool is_still(const Vector& turn) { return turn.x == 0 && turn.y == 0 && turn.z == 0; }

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
    const scalar scale = inv_I_body.x + inv_I_body.y + inv_I_body.z;
    const Vector y = L * scale;
    Matrix now = A;
    for (int i = 0; i < limits::energy_turns; ++i) {
        const Vector back = turn_back(spin_of(now, inv_I_body, L), y, twice_energy * scale);
        if (is_still(back)) break;
        now = turned_about(now, back);
    }
    return now;
}

Vector turn_freely(Matrix& A, const Vector& inv_I_body, const Vector& L, scalar h) {
    const Vector omega = spin_of(A, inv_I_body, L);
    const scalar angle_sq = length_sq(omega) * h * h, twice_energy = dot(L, omega);
    int parts = 1;
    // bound: limits::turn_parts_max
    while (parts < limits::turn_parts_max && angle_sq > limits::turn_of_part * limits::turn_of_part * static_cast<scalar>(parts * parts)) ++parts;
    const scalar part = h / static_cast<scalar>(parts);
    Vector turned = {};
    for (int part_i = 0; part_i < parts; ++part_i) {  // bound: limits::turn_parts_max
        const Matrix middle = turned_about(A, spin_of(A, inv_I_body, L) * (part / 2));
        const Vector turn = spin_of(middle, inv_I_body, L) * part;
        A = return_energy(turned_about(A, turn * (1 + length_sq(turn) / 12)), inv_I_body, L, twice_energy);  // the angle without Cayley's error
        turned += turn;
    }
    return turned;
}

} }  // namespace ingot
