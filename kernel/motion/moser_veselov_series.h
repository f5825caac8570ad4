// SPDX-License-Identifier: MIT
#pragma once

#include "../math/vec3.h"

namespace ingot { inline namespace INGOT_ABI {

/// The two numbers that turn moments of inertia into those for which the discrete motion is the true one:
/// 1 / I_modified = S / I + D.
template <class T>
struct ModifiedInertia {
    T S_minus_1;
    T D;
};

/// S - 1 and D to the given order of the method.
///
/// Shapes:  j the inverse moments over their scale, s1 = j.x + j.y + j.z in (1/2, 1]; H the energy and C = |y|^2 / 2, both
///          times (h scale)^2: everything is free of units and, for |omega| h <= 0.5, below 1.
/// Source:  Hairer and Vilmart 2006 in the symmetric functions of j: s1, s2 = j.x j.y + j.y j.z + j.z j.x, s3 = j.x j.y j.z.
template <int order, class T>
INGOT_INLINE ModifiedInertia<T> modified_inertia(const Vec3<T>& j, T H, T C) {
    if constexpr (order == 2) return {T{}, T{}};
    const auto q = [](double numerator, double denominator) { return splat<T>(static_cast<scalar>(numerator / denominator)); };
    const T s1 = j.x + j.y + j.z, s2 = j.x * j.y + j.z * (j.x + j.y), s3 = j.x * j.y * j.z;
    const T P = s1 * H, Q = s2 * C, R = s2 * H, U = s3 * C;  // the products that recur
    T S = Q * q(1, 6) - P * q(1, 3);
    T D = R * q(1, 6) - U * q(1, 3);
    if constexpr (order >= 6) {
        S = S + (P * P - P * Q + Q * Q) * q(1, 30) - R * H * q(1, 60) + U * H * q(2, 15) - s1 * U * C * q(1, 10);
        D = D + U * P * q(2, 15) - R * P * q(1, 60) - s3 * H * H * q(1, 10) - (R * Q + U * Q) * q(1, 60);
    }
    if constexpr (order >= 8) {
        const T s1s1 = s1 * s1, s1s2 = s1 * s2, s1s3 = s1 * s3, s2s2 = s2 * s2, s2s3 = s2 * s3, s3s3 = s3 * s3;
        const T HH = H * H, HC = H * C, CC = C * C;
        S += (s1s2 * q(1, 630) - s1 * s1s1 * q(1, 630) + s3 * q(1, 35)) * (HH * H)
           + (s1s1 * s2 * q(1, 420) - s1s3 * q(53, 630) + s2s2 * q(41, 2520)) * (HC * H)
           + (s1s1 * s3 * q(11, 210) - s1 * s2s2 * q(1, 70) - s2s3 * q(1, 84)) * (HC * C)
           + (s2 * s2s2 * q(17, 2520) - s1s2 * s3 * q(11, 420) + s3s3 * q(5, 126)) * (CC * C);
        D += (s1s1 * s2 * q(1, 1260) + s1s3 * q(1, 42) - s2s2 * q(13, 1260)) * (HH * H)
           + (s1 * s2s2 * q(13, 2520) - s1s1 * s3 * q(8, 315) + s2s3 * q(11, 252)) * (HC * H)
           + (s2 * s2s2 * q(1, 1260) - s1s2 * s3 * q(1, 1260) - s3s3 * q(22, 315)) * (HC * C)
           + (s1 * s3s3 * q(1, 35) - s2s2 * s3 * q(19, 2520)) * (CC * C);
        if constexpr (order >= 10) {
            S += (s1s1 * s1s1 * q(1, 22680) - s1s1 * s2 * q(1, 15120) - s1s3 * q(3, 280) + s2s2 * q(17, 5040)) * (HH * HH)
               + (s1s1 * s3 * q(23, 945) - s1s1 * s1s2 * q(1, 11340) - s1 * s2s2 * q(11, 1890) - s2s3 * q(23, 1260)) * (HH * HC)
               + (s1s1 * s2s2 * q(13, 3780) - s1s1 * s1s3 * q(17, 1260) + s1s2 * s3 * q(1, 252) + s2 * s2s2 * q(1, 2520) +
                  s3s3 * q(53, 1260)) * (HH * CC)
               + (s1s1 * s2s3 * q(17, 1260) - s1s2 * s2s2 * q(11, 3240) - s1 * s3s3 * q(47, 945) + s2s2 * s3 * q(47, 7560)) * (HC * CC)
               + (s1s3 * s1s3 * q(1, 120) - s1s2 * s2s3 * q(19, 2520) + s2s2 * s2s2 * q(31, 22680) + s2 * s3s3 * q(97, 15120)) * (CC * CC);
            D += (s2s3 * q(17, 1680) - s1s1 * s1s2 * q(1, 45360) - s1s1 * s3 * q(1, 360) - s1 * s2s2 * q(1, 7560)) * (HH * HH)
               + (s1s1 * s1s3 * q(8, 2835) - s1s1 * s2s2 * q(1, 1512) - s1s2 * s3 * q(23, 1890) + s2 * s2s2 * q(97, 22680) -
                  s3s3 * q(1, 35)) * (HH * HC)
               + (s1s1 * s2s3 * q(19, 7560) - s1s2 * s2s2 * q(1, 1512) + s1 * s3s3 * q(89, 1890) - s2s2 * s3 * q(19, 1080)) * (HH * CC)
               + (s1s2 * s2s3 * q(37, 7560) - s1s3 * s1s3 * q(2, 105) - s2s2 * s2s2 * q(1, 45360) + s2 * s3s3 * q(19, 1260)) * (HC * CC)
               + (s1s2 * s3s3 * q(3, 560) - s2 * s2s2 * s3 * q(61, 45360) - s3 * s3s3 * q(61, 4536)) * (CC * CC);
        }
    }
    return {S, D};
}

} }  // namespace ingot
