// SPDX-License-Identifier: MIT
// Orientations as quaternions: for files, networks and engines that keep them so, and for drawing between two steps. The kernel itself turns
// matrices.
#pragma once

#include "rotation.h"

namespace ingot { inline namespace INGOT_ABI {

namespace limits {

/// Largest | |q|^2 - 1 | of a quaternion that is taken for a rotation; the matrix made of it is orthonormal all the same.
inline constexpr scalar quaternion_length = orthogonality;
/// Terms of the series of slerp: each is less than half of the one before.
inline constexpr int slerp_terms_max = INGOT_DOUBLE ? 56 : 27;

}  // namespace limits

/// The turn by an angle about the unit axis n: w = cos(angle/2), (x, y, z) = n sin(angle/2). q and -q are the same turn.
struct Quaternion {
    scalar w = 1, x = 0, y = 0, z = 0;  ///< see above; as it is, no turn
};

namespace quaternions {

/// p . q: the cosine of half of the angle between two turns, but for its sign.
constexpr scalar dot(const Quaternion& p, const Quaternion& q) { return (p.w * q.w + p.x * q.x) + (p.y * q.y + p.z * q.z); }

/// Each component times s.
constexpr Quaternion scaled(const Quaternion& q, scalar s) { return {q.w * s, q.x * s, q.y * s, q.z * s}; }

/// The quaternion of a rotation A with w >= 0, and its largest component above 0 where w is 0.
///
/// Of 4 w^2 = 1 + trace A, and the same for x, y and z, the largest is at least 1: the others come from differences over its root, and nothing
/// cancels. Cost: a square root, a division and 20 flops. Source: Shepperd, "Quaternion from rotation matrix", 1978.
inline Quaternion from_rotation(const Matrix& A) {
    const scalar a = A.c0.x, b = A.c1.y, c = A.c2.z;
    const scalar fours[4] = {1 + (a + b + c), 1 + (a - b - c), 1 + (b - a - c), 1 + (c - a - b)};  // 4 w^2, 4 x^2, 4 y^2, 4 z^2
    int largest = 0;
    for (int i = 1; i < 4; ++i) largest = fours[i] > fours[largest] ? i : largest;
    const scalar root = sqrt(fours[largest]), f = scalar(0.5) / root, first = scalar(0.5) * root;
    const scalar wx = (A.c1.z - A.c2.y) * f, wy = (A.c2.x - A.c0.z) * f, wz = (A.c0.y - A.c1.x) * f;
    const scalar xy = (A.c1.x + A.c0.y) * f, xz = (A.c2.x + A.c0.z) * f, yz = (A.c2.y + A.c1.z) * f;
    const Quaternion by_largest[4] = {{first, wx, wy, wz}, {wx, first, xy, xz}, {wy, xy, first, yz}, {wz, xz, yz, first}};
    const Quaternion& q = by_largest[largest];
    const scalar sign = q.w < 0 ? scalar(-1) : scalar(1);
    return {q.w * sign + 0, q.x * sign + 0, q.y * sign + 0, q.z * sign + 0};  // -0 becomes +0: one value, one set of bits
}

/// The rotation of a quaternion of any length but zero, each entry to 17 roundings. Cost: a division and 32 flops.
constexpr Matrix to_rotation(const Quaternion& q) {
    const scalar s = 2 / dot(q, q);
    const scalar wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z, xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
    const scalar xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
    return {{1 - s * (yy + zz), s * (xy + wz), s * (xz - wy)},
            {s * (xy - wz), 1 - s * (xx + zz), s * (yz + wx)},
            {s * (xz + wy), s * (yz - wx), 1 - s * (xx + yy)}};
}

/// sin(t phi) / sin(phi), 0 <= t <= 1, of the angle with cos(phi) = x, 0 <= x <= 1: a hypergeometric series in 1 - x, of which no term is negative.
/// Source: Eberly, "A fast and accurate algorithm for computing SLERP", 2011, Eq. 8, summed until nothing is added.
constexpr scalar slerp_weight(scalar t, scalar x) {
    scalar term = t, sum = t;
    for (int i = 1; i <= limits::slerp_terms_max; ++i) {
        const scalar n = static_cast<scalar>(i);
        term *= (n - t) * (n + t) / (n * (2 * n + 1)) * (1 - x);
        const scalar next = sum + term;
        if (next == sum) break;
        sum = next;
    }
    return sum;
}

/// The shorter way from p to q at a constant rate, t of it; of length 1 to the rounding of p and q.
constexpr Quaternion slerp(const Quaternion& p, const Quaternion& q, scalar t) {
    const scalar along = dot(p, q), x = abs(along) < 1 ? abs(along) : scalar(1);
    const Quaternion a = scaled(p, slerp_weight(1 - t, x)), b = scaled(q, along < 0 ? -slerp_weight(t, x) : slerp_weight(t, x));
    return {a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z};
}

}  // namespace quaternions

/// The quaternion of a rotation, with w >= 0.
///
/// Error:  8 roundings of each component, and what A is off a rotation.
/// Errors: not_finite, not_a_rotation (an entry of A^T A - 1 beyond limits::orthogonality, or det A < 0).
inline Result<Quaternion> quaternion_of(const Matrix& A) {
    if (!is_finite(A)) return {Status::not_finite, {}};
    if (!(orthogonality_error(A) <= limits::orthogonality) || !(determinant(A) > 0)) return {Status::not_a_rotation, {}};
    return {Status::ok, quaternions::from_rotation(A)};
}

/// The rotation of a quaternion: what BodyState::A takes. Its length does not matter: each entry is that of a rotation to 17 roundings.
///
/// Errors: not_finite, not_a_rotation (|q|^2 off 1 by more than limits::quaternion_length).
constexpr Result<Matrix> rotation_of(const Quaternion& q) {
    if (!is_finite(q.w) || !is_finite(q.x) || !is_finite(q.y) || !is_finite(q.z)) return {Status::not_finite, {}};
    if (!(abs(quaternions::dot(q, q) - 1) <= limits::quaternion_length)) return {Status::not_a_rotation, {}};
    return {Status::ok, quaternions::to_rotation(q)};
}

} }  // namespace ingot
