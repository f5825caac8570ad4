// SPDX-License-Identifier: MIT
// The drive of a ball joint that is at its largest torque: three rows as one, whose impulse has a largest length.
//
//     gamma j + K j + rate = target,  |j| <= most;   where that is more than it may be, j is along what the law asks for:
//     (K + (gamma + mu) 1) j = b,  |j| = most,  mu > 0        b = target - rate, of the impulses of all others
//
// target - K j - rate - gamma j = mu j then, so the torque that is asked for at the end of the substep and the one that is given have one direction,
// whichever way contacts turn the body meanwhile. |j| falls as mu grows, and Newton's method on 1/|j| finds mu from below: Hebden 1973; More and
// Sorensen, "Computing a trust region step", SIAM J. Sci. Stat. Comput. 4 (1983).
#pragma once

#include "../base/figure_limits.h"
#include "../math/sqrt.h"
#include "../math/vec3.h"

namespace ingot { inline namespace INGOT_ABI {

/// How three rates answer: of[i] to an impulse of 1 on the i-th.
struct AnswerOfThree {
    Vector of[3];
};

/// K + more 1, factored; more: 0 or above. Pivots that are none are of what bodies gone bad answer, or of rounding: nothing is solved by these then.
class ThreeRows {
public:
    ThreeRows(const AnswerOfThree& K, scalar more)
        : a_{{K.of[0].x + more, K.of[1].x, K.of[2].x}, {K.of[0].y, K.of[1].y + more, K.of[2].y}, {K.of[0].z, K.of[1].z, K.of[2].z + more}} {
        for (int k = 0; k < 2; ++k)  // bound: 3
            for (int i = k + 1; i < 3; ++i) {
                a_[i][k] = a_[k][k] > 0 ? a_[i][k] / a_[k][k] : 0;
                for (int c = k + 1; c < 3; ++c) a_[i][c] -= a_[i][k] * a_[k][c];
            }
    }
    Vector solve(const Vector& b) const {
        const scalar y = b.y - a_[1][0] * b.x, z = b.z - a_[2][0] * b.x - a_[2][1] * y;
        const scalar x_2 = over(z, a_[2][2]), x_1 = over(y - a_[1][2] * x_2, a_[1][1]);
        return {over(b.x - a_[0][1] * x_1 - a_[0][2] * x_2, a_[0][0]), x_1, x_2};
    }

private:
    static scalar over(scalar value, scalar pivot) { return pivot > 0 ? value / pivot : scalar(0); }
    scalar a_[3][3];
};

/// The impulse of three rows. b: what their rates are to change by; gamma, most: see above.
inline Vector impulse_of_three(const AnswerOfThree& K, scalar gamma, const Vector& b, scalar most) {
    Vector j = ThreeRows(K, gamma).solve(b);
    scalar length = sqrt(length_sq(j));
    if (!(length > most)) return j;
    if (!(most > 0)) return {};
    scalar mu = 0;
    // bound: limits::torque_passes
    for (int pass = 0; pass < limits::torque_passes && abs(length - most) > most * limits::torque_settled; ++pass) {
        const scalar falls = dot(j, ThreeRows(K, gamma + mu).solve(j));
        if (!(falls > 0)) break;
        mu = max(mu + (length * length / falls) * ((length - most) / most), 0);
        j = ThreeRows(K, gamma + mu).solve(b);
        length = sqrt(length_sq(j));
    }
    return length > most ? j * (most / length) : j;
}

} }  // namespace ingot
