// SPDX-License-Identifier: MIT
// Jacobi's elliptic functions of one body, for the exact step.
#pragma once

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "../math/trig.h"

namespace ingot { inline namespace INGOT_ABI {

/// sn, cn, dn of one argument.
struct Jacobi {
    scalar sn, cn, dn;
};

/// The functions of one parameter m = 1 - mc: the arithmetic-geometric mean, done once, serves every argument.
///
/// Valid for: 0 <= m < 1 with mc >= epsilon^2, |u| <= 500. Bound: limits::agm_steps_max steps; 8 are the most that were seen.
/// Source:    Gauss and Landen; the descent through cotangents, without an arc sine, is Bulirsch's (Numerische Mathematik 7, 1965).
class JacobiOf {
public:
    explicit JacobiOf(scalar mc) {
        scalar a = 1, g = sqrt(mc);
        // bound: limits::agm_steps_max: only the header changes count_
        for (; count_ < limits::agm_steps_max; ++count_) {
            a_[count_] = a;
            g_[count_] = g;
            mean_ = (a + g) * scalar(0.5);
            if (abs(a - g) <= sqrt_epsilon * a) break;
            g = sqrt(a * g);
            a = mean_;
        }
        if (count_ == limits::agm_steps_max) --count_;
    }

    Jacobi operator()(scalar u) const {
        const SinCos phase = sin_cos(u * mean_);
        // Beside a zero of sn the square of the cotangent would overflow, and sn is its slope, 1, times the way there: to rounding.
        if (abs(phase.sin) <= epsilon * epsilon) return {phase.sin / mean_, phase.cos, 1};
        scalar cotangent = phase.cos / phase.sin, c = mean_ * cotangent, dn = 1;
        // bound: limits::agm_steps_max
        for (int step_i = count_; step_i >= 0; --step_i) {
            cotangent *= c;
            c *= dn;
            dn = (g_[step_i] + cotangent) / (a_[step_i] + cotangent);
            cotangent = c / a_[step_i];
        }
        const scalar sine = 1 / sqrt(c * c + 1);
        const scalar sn = phase.sin < 0 ? -sine : sine;
        return {sn, c * sn, dn};
    }

private:
    static constexpr scalar sqrt_epsilon = INGOT_DOUBLE ? scalar(1.5e-8) : scalar(3.5e-4);
    scalar a_[limits::agm_steps_max] = {}, g_[limits::agm_steps_max] = {};
    scalar mean_ = 1;
    int count_ = 0;
};

/// The functions of a sum of two arguments.
INGOT_INLINE Jacobi sum_of(const Jacobi& p, const Jacobi& q, scalar m) {
    const scalar inverse = 1 / (1 - m * (p.sn * p.sn) * (q.sn * q.sn));
    return {(p.sn * q.cn * q.dn + q.sn * p.cn * p.dn) * inverse, (p.cn * q.cn - p.sn * q.sn * p.dn * q.dn) * inverse,
            (p.dn * q.dn - m * p.sn * q.sn * p.cn * q.cn) * inverse};
}

/// The functions of p + q less those of p, for a short q: without a difference of nearly equal numbers.
INGOT_INLINE Jacobi change_by(const Jacobi& p, const Jacobi& q, scalar m) {
    const scalar sn_sq = q.sn * q.sn, m_sn_sq = m * (p.sn * p.sn) * sn_sq, inverse = 1 / (1 - m_sn_sq);
    const scalar less_cn = sn_sq / (1 + q.cn), less_dn = m * sn_sq / (1 + q.dn);  // 1 - cn, 1 - dn
    return {(q.sn * p.cn * p.dn - p.sn * (less_cn + q.cn * less_dn) + p.sn * m_sn_sq) * inverse,
            (p.cn * m_sn_sq - p.cn * less_cn - p.sn * q.sn * p.dn * q.dn) * inverse,
            (p.dn * m_sn_sq - p.dn * less_dn - m * p.sn * q.sn * p.cn * q.cn) * inverse};
}

} }  // namespace ingot
