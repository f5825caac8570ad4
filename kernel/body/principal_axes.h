// SPDX-License-Identifier: MIT
// The axes along which a symmetric tensor is diagonal. Made of + - * / alone, so that a tensor known to the compiler has its
// axes at compile time, with the bits it would have at run time.
#pragma once

#include "../base/limits.h"
#include "../base/status.h"
#include "../math/rotation.h"

namespace ingot { inline namespace INGOT_ABI {

namespace limits {

/// Sweeps of three Jacobi rotations. The worst of 40 million tensors needed 6, the last of which only looks. Beyond:
/// not_converged.
inline constexpr int jacobi_sweeps_max = 12;
/// Two moments that differ by less than this fraction of their sum, with a product of inertia as small, count as equal: what
/// turning, moving and summing parts leaves of an exact equality. All axes in their plane are principal; the user's are kept.
inline constexpr scalar equal_moments = 8 * epsilon;

}  // namespace limits

/// S = A diag(moments) A^T.
struct PrincipalAxes {
    Vector moments;  ///< unit of the tensor
    Matrix A;        ///< columns are the axes; a rotation
};

namespace jacobi {

/// A tensor on its way to the diagonal, seen along `axes`.
struct Tensor {
    scalar diagonal[3];
    scalar off[3];    ///< off[r] is the entry in neither row nor column r
    Vector axes[3];
};

/// sqrt(x) for 1 <= x <= 2, within an ulp. Heron's rule: the relative error e becomes e^2 / 2, from 6e-2 at the begin to
/// 1.7e-3, 1.5e-6, 1.1e-12, 7e-25.
constexpr scalar sqrt_of_1_to_2(scalar x) {
    scalar root = (1 + x) / 2;
    for (int step_i = 0; step_i < (INGOT_DOUBLE ? 4 : 3); ++step_i) root = (root + x / root) / 2;  // bound: 4
    return root;
}

/// tan(theta) of the theta in -pi/4 .. pi/4 with tan(2 theta) = x / y, for x other than 0: x / (y +- sqrt(x^2 + y^2)), formed
/// from the ratio of the smaller to the larger so that nothing overflows.
constexpr scalar tangent_of_half(scalar x, scalar y) {
    if (abs(x) <= abs(y)) {
        const scalar ratio = x / y;
        return ratio / (1 + sqrt_of_1_to_2(1 + ratio * ratio));
    }
    const scalar ratio = y / x;
    const scalar root = sqrt_of_1_to_2(1 + ratio * ratio);
    return 1 / (ratio < 0 ? ratio - root : ratio + root);
}

/// True where the entry off[r] is as good as zero: below the rounding of both moments beside it, or the two are equal.
constexpr bool is_diagonal(const Tensor& S, int r) {
    const scalar first = abs(S.diagonal[(r + 1) % 3]), second = abs(S.diagonal[(r + 2) % 3]);
    const scalar smaller = first < second ? first : second;
    const scalar equal = limits::equal_moments * (first + second);
    return abs(S.off[r]) <= epsilon / 2 * smaller ||
           (2 * abs(S.off[r]) <= equal && abs(S.diagonal[(r + 1) % 3] - S.diagonal[(r + 2) % 3]) <= equal);
}

/// Turns the axes p and q beside r by the angle theta, at most pi/4, that makes the entry between them zero.
/// Source: Rutishauser, "The Jacobi method for real symmetric matrices", 1966: with tau = tan(theta / 2) the changes are small
///         terms added to what was there.
constexpr void annihilate(Tensor& S, int r) {
    const int p = (r + 1) % 3, q = (r + 2) % 3;
    const scalar t = tangent_of_half(2 * S.off[r], S.diagonal[q] - S.diagonal[p]);
    const scalar c = 1 / sqrt_of_1_to_2(1 + t * t);
    const scalar s = t * c, tau = s / (1 + c);

    S.diagonal[p] -= t * S.off[r];
    S.diagonal[q] += t * S.off[r];
    S.off[r] = 0;
    const scalar S_rp = S.off[q], S_rq = S.off[p];
    S.off[q] = S_rp - s * (S_rq + tau * S_rp);
    S.off[p] = S_rq + s * (S_rp - tau * S_rq);
    const Vector axis_p = S.axes[p], axis_q = S.axes[q];
    S.axes[p] = axis_p - s * (axis_q + tau * axis_p);
    S.axes[q] = axis_q + s * (axis_p - tau * axis_q);
}

/// Which axis is called x, y, z, and which way it points.
struct Naming {
    int axis[3];
    scalar sign[3];
};

/// Of the 24 right-handed ways to name the axes of a rotation the one that turns least: that has the largest trace, which is
/// 1 + 2 cos(angle). Of equals it is the first, and the user's own order is first.
///
/// The largest sum of magnitudes will do: it belongs to a right-handed one. Those come within 62.8 degrees of any orientation
/// (Handscomb 1958), a trace of 1.91 or more; that of a left-handed one, a turn and a mirror, is 1 at most.
constexpr Naming nearest_naming(const Matrix& axes) {
    constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    const Vector &x = axes.c0, &y = axes.c1, &z = axes.c2;
    const scalar entry[3][3] = {{x.x, x.y, x.z}, {y.x, y.y, y.z}, {z.x, z.y, z.z}};
    int best = 0;
    scalar best_sum = 0;
    for (int order_i = 0; order_i < 6; ++order_i) {
        const int(&order)[3] = orders[order_i];
        const scalar sum = abs(entry[order[0]][0]) + abs(entry[order[1]][1]) + abs(entry[order[2]][2]);
        if (sum > best_sum) {
            best = order_i;
            best_sum = sum;
        }
    }
    Naming naming{};
    for (int k = 0; k < 3; ++k) {
        naming.axis[k] = orders[best][k];
        naming.sign[k] = entry[naming.axis[k]][k] < 0 ? scalar(-1) : scalar(1);
    }
    return naming;
}

}  // namespace jacobi

/// Principal axes of a symmetric tensor, named so that A turns the user's axes as little as it can: the moments are in the
/// order of the axes they are next to, not in the order of size.
///
/// A tensor that is diagonal to rounding gives A = 1 exactly and its own diagonal, bit for bit; of a body with equal moments
/// (a ball, a cube, a cylinder) only those axes turn that must.
/// Units:   moments in the unit of the tensor, kg m^2.
/// Error:   the moments within 9 epsilon of the largest, those that count as equal within 25; |A^T A - 1| within 2.5 epsilon. In
///          float that leaves the smallest moment of a rod 1000:1 that lies askew in its frame no more than a digit: describe
///          long bodies along the axes.
/// Errors:  not_finite, bad_inertia (an entry beyond limits::inertia_max; no entry of a tensor exceeds its largest moment),
///          not_converged (after limits::jacobi_sweeps_max sweeps).
/// Cost:    about 150 flops and 15 divisions a rotation, at most 3 a sweep, rarely more than 4 sweeps; for set-up. A diagonal
///          tensor costs one look.
/// Source:  Jacobi 1846, cyclic; Golub and Van Loan, "Matrix Computations", 8.5.
constexpr Result<PrincipalAxes> principal_axes(const SymmetricMatrix& S) {
    if (!is_finite(S)) return {Status::not_finite, {}};
    const scalar entries[6] = {S.xx, S.yy, S.zz, S.xy, S.xz, S.yz};
    for (scalar entry : entries)
        if (abs(entry) > limits::inertia_max) return {Status::bad_inertia, {}};

    jacobi::Tensor T{{S.xx, S.yy, S.zz}, {S.yz, S.xz, S.xy}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    bool turned = true;
    for (int sweep_i = 0; turned && sweep_i < limits::jacobi_sweeps_max; ++sweep_i) {
        turned = false;
        for (int r = 2; r >= 0; --r) {
            if (jacobi::is_diagonal(T, r)) continue;
            jacobi::annihilate(T, r);
            turned = true;
        }
    }
    if (turned) return {Status::not_converged, {}};

    const jacobi::Naming named = jacobi::nearest_naming({T.axes[0], T.axes[1], T.axes[2]});
    const Matrix A = {T.axes[named.axis[0]] * named.sign[0], T.axes[named.axis[1]] * named.sign[1],
                      T.axes[named.axis[2]] * named.sign[2]};
    const Vector moments = {T.diagonal[named.axis[0]], T.diagonal[named.axis[1]], T.diagonal[named.axis[2]]};
    return {Status::ok, {moments, A + polar_correction(A) + Matrix{}}};  // x + 0 turns -0 into +0
}

} }  // namespace ingot
