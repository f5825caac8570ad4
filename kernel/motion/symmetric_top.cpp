// SPDX-License-Identifier: MIT
#include "symmetric_top.h"

#include "../math/lane_trig.h"
#include "turn.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// sin and 1 - cos of an angle, the latter without cancellation. Angles beyond the range give NaN, which marks the body bad.
struct Angle {
    lane sin, one_minus_cos;
};
INGOT_INLINE Angle angle_of(lane angle) {
    const SinCosOf<lane> half = lane_sin_cos(angle * splat<lane>(scalar(0.5)));
    const lane in_range = select(abs(angle) <= splat<lane>(1000), splat<lane>(1), splat<lane>(INGOT_NAN(scalar)));
    return {splat<lane>(2) * half.sin * half.cos * in_range, splat<lane>(2) * half.sin * half.sin};
}

/// (exp([u]) - 1) A for a turn by |u| about u, world axes.
INGOT_INLINE Mat3<lane> turn_about(const Mat3<lane>& A, const Vec3<lane>& u) {
    const lane angle = sqrt(length_sq(u));
    const lane inverse = splat<lane>(1) / select(angle > lane{}, angle, splat<lane>(1));
    const Vec3<lane> n = u * inverse;
    const Angle turn = angle_of(angle);
    const auto column = [&](const Vec3<lane>& a) {
        const Vec3<lane> n_a = cross(n, a);
        return n_a * turn.sin + cross(n, n_a) * turn.one_minus_cos;
    };
    return {column(A.c0), column(A.c1), column(A.c2)};
}

/// Turns the pair (a, b) within its plane, towards b: a <- a cos + b sin, b <- b cos - a sin.
template <class V>
INGOT_INLINE void turn_pair(V& a, V& b, const Angle& angle) {
    const V a_next = a + (b * angle.sin - a * angle.one_minus_cos);
    b = b - (a * angle.sin + b * angle.one_minus_cos);
    a = a_next;
}

/// A tile whose axes are renamed, in cyclic order, so that z is the axis of the body's nearest symmetry: x and y are the two
/// moments that differ least. y_body = A^T L.
struct NearlySymmetric {
    Mat3<lane> A;
    Vec3<lane> y, J;
    mask z_was_x, z_was_y;

    INGOT_INLINE NearlySymmetric(const Mat3<lane>& A_, const Vec3<lane>& J_, const Vec3<lane>& L) {
        const lane xy = abs(J_.x - J_.y), yz = abs(J_.y - J_.z), zx = abs(J_.z - J_.x);
        z_was_x = both(yz < xy, yz <= zx);
        z_was_y = both(zx < xy, zx < yz);
        A = {renamed(A_.c0, A_.c1, A_.c2), renamed(A_.c1, A_.c2, A_.c0), renamed(A_.c2, A_.c0, A_.c1)};
        J = {renamed(J_.x, J_.y, J_.z), renamed(J_.y, J_.z, J_.x), renamed(J_.z, J_.x, J_.y)};
        y = transpose_times(A, L);
    }

    /// The axis that takes the place of `self`, which is followed by `next` and `last` in cyclic order.
    template <class V>
    INGOT_INLINE V renamed(const V& self, const V& next, const V& last) const {
        return select(z_was_x, next, select(z_was_y, last, self));
    }

    /// exp of the turn about z by `angle`, in body axes: A <- A R_z, y <- R_z^T y.
    INGOT_INLINE void turn_z(const Angle& angle) {
        turn_pair(A.c0, A.c1, angle);
        turn_pair(y.x, y.y, angle);
    }
    INGOT_INLINE void turn_y(const Angle& angle) {
        turn_pair(A.c2, A.c0, angle);
        turn_pair(y.z, y.x, angle);
    }

    INGOT_INLINE Mat3<lane> with_old_names() const {
        // Names were passed on to the left (z was x) or to the right (z was y); they go back the other way.
        const auto back = [&](const Vec3<lane>& self, const Vec3<lane>& next, const Vec3<lane>& last) {
            return select(z_was_x, last, select(z_was_y, next, self));
        };
        return {back(A.c0, A.c1, A.c2), back(A.c1, A.c2, A.c0), back(A.c2, A.c0, A.c1)};
    }
};

INGOT_INLINE Mat3<lane> polar_when_due(const Mat3<lane>& A, const FlightClock& clock) {
    return clock.steps % limits::polar_interval == 0 ? A + polar_correction(A) : A;
}

/// Strang: half of what remains, the symmetric top's own turn, the other half.
INGOT_INLINE void strang(NearlySymmetric& body, lane h) {
    const lane half = h * splat<lane>(scalar(0.5));
    body.turn_y(angle_of(half * (body.J.y - body.J.x) * body.y.y));
    body.turn_z(angle_of(h * (body.J.z - body.J.x) * body.y.z));
    body.turn_y(angle_of(half * (body.J.y - body.J.x) * body.y.y));
}

}  // namespace

int SymmetricTop::integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock) {
    const lane step = splat<lane>(h);
    integrate_tiles(bodies, clock, [&](const Mat3<lane>& A, const Vec3<lane>& inv_I_body, const Vec3<lane>& L) {
        NearlySymmetric body(A, inv_I_body, L);
        const lane J_t = (body.J.x + body.J.y) * splat<lane>(scalar(0.5));
        body.turn_z(angle_of(step * (body.J.z - J_t) * body.y.z));
        const Mat3<lane> turned = body.with_old_names();
        return polar_when_due(turned + turn_about(turned, L * (J_t * step)), clock);
    });
    return 0;
}

template <int order_>
int SymmetricTopSplitting<order_>::integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock) {
    // Yoshida 1990, table 1, solution A: weights of the seven Strang steps, symmetric about the middle.
    constexpr double w1 = -1.17767998417887100695, w2 = 0.23557321335935813368, w3 = 0.78451361047755726382;
    constexpr double order_6[7] = {w3, w2, w1, 1 - 2 * (w1 + w2 + w3), w1, w2, w3};
    integrate_tiles(bodies, clock, [&](const Mat3<lane>& A, const Vec3<lane>& inv_I_body, const Vec3<lane>& L) {
        NearlySymmetric body(A, inv_I_body, L);
        if constexpr (order_ == 2) {
            strang(body, splat<lane>(h));
        } else {
            for (double weight : order_6) strang(body, splat<lane>(h * static_cast<scalar>(weight)));
        }
        const Mat3<lane> turned = body.with_old_names();
        return polar_when_due(turned + turn_about(turned, L * (body.J.x * splat<lane>(h))), clock);
    });
    return 0;
}

template struct SymmetricTopSplitting<2>;
template struct SymmetricTopSplitting<6>;

} }  // namespace ingot
