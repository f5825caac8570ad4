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

SymmetricMatrix turned_about(const SymmetricMatrix& tensor, const Vector& turn) {
    return rotated(Matrix{turned_about(Vector{1, 0, 0}, turn), turned_about(Vector{0, 1, 0}, turn), turned_about(Vector{0, 0, 1}, turn)}, tensor);
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

Vector turn_freely(SymmetricMatrix& inv_I_world, const Vector& L, scalar h) {
    const Vector omega = inv_I_world * L, y = L * (inv_I_world.xx + inv_I_world.yy + inv_I_world.zz);
    const Vector turn = turned_about(inv_I_world, omega * (h / 2)) * L * h;  // by omega in the middle
    SymmetricMatrix after = turned_about(inv_I_world, turn);
    for (int i = 0; i < limits::energy_turns; ++i) {
        const Vector back = turn_back(after * L, y, dot(y, omega));
        if (is_still(back)) break;
        after = turned_about(after, back);
    }
    inv_I_world = after;
    return turn;
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

} }  // namespace ingot
