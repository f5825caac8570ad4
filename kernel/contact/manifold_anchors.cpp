// SPDX-License-Identifier: MIT
#include "manifold_anchors.h"

#include "../base/limits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr int points = Manifold::points_max;

/// A times each of four columns. Loops over four numbers: compilers make one instruction of each.
void turn(const Matrix& A, const scalar (&from)[3][points], scalar (&to)[3][points]) {
    for (int i = 0; i < points; ++i) to[0][i] = A.c0.x * from[0][i] + A.c1.x * from[1][i] + A.c2.x * from[2][i];
    for (int i = 0; i < points; ++i) to[1][i] = A.c0.y * from[0][i] + A.c1.y * from[1][i] + A.c2.y * from[2][i];
    for (int i = 0; i < points; ++i) to[2][i] = A.c0.z * from[0][i] + A.c1.z * from[1][i] + A.c2.z * from[2][i];
}

void put(scalar (&to)[3][points], int point_i, const Vector& value) {
    to[0][point_i] = value.x;
    to[1][point_i] = value.y;
    to[2][point_i] = value.z;
}

}  // namespace

void anchor(const BodyFrame& A, const BodyFrame& B, const Manifold& manifold, scalar margin, ManifoldAnchors& anchors) {
    anchors.margin = margin;
    anchors.n_A = transpose_times(A.A, manifold.n);
    anchors.n_B = transpose_times(B.A, manifold.n);
    for (int point_i = 0; point_i < manifold.count; ++point_i) {
        const ManifoldPoint& point = manifold.points[point_i];
        const Vector half_gap = manifold.n * (point.separation * scalar(0.5));
        put(anchors.on_A, point_i, transpose_times(A.A, point.P - A.r + half_gap));
        put(anchors.on_B, point_i, transpose_times(B.A, point.P - B.r - half_gap));
    }
    for (int point_i = manifold.count; point_i < points; ++point_i) {
        put(anchors.on_A, point_i, {});
        put(anchors.on_B, point_i, {});
    }
}

bool renew_from_anchors(const BodyFrame& A, const BodyFrame& B, scalar slip, scalar margin, const ManifoldAnchors& anchors, Manifold& manifold) {
    if (!(anchors.margin > 0) || margin > anchors.margin + limits::contact_margin / 2) return false;
    const Vector n = B.A * anchors.n_B, tilt = A.A * anchors.n_A - n;
    if (!(length_sq(tilt) <= limits::recycled_slip * limits::recycled_slip)) return false;

    const Vector between = A.r - B.r;
    scalar at_A[3][points], at_B[3][points], separation[points], slipped_sq[points];
    turn(A.A, anchors.on_A, at_A);
    turn(B.A, anchors.on_B, at_B);
    for (int i = 0; i < points; ++i) {
        const scalar x = between.x + (at_A[0][i] - at_B[0][i]), y = between.y + (at_A[1][i] - at_B[1][i]), z = between.z + (at_A[2][i] - at_B[2][i]);
        const scalar s = n.x * x + n.y * y + n.z * z;
        const scalar across_x = x - n.x * s, across_y = y - n.y * s, across_z = z - n.z * s;
        separation[i] = s;
        slipped_sq[i] = across_x * across_x + across_y * across_y + across_z * across_z;
        at_B[0][i] = B.r.x + at_B[0][i] + x * scalar(0.5);
        at_B[1][i] = B.r.y + at_B[1][i] + y * scalar(0.5);
        at_B[2][i] = B.r.z + at_B[2][i] + z * scalar(0.5);
    }
    scalar least = limits::unbounded;
    for (int i = 0; i < manifold.count; ++i) {
        if (!(slipped_sq[i] <= slip * slip)) return false;
        least = separation[i] < least ? separation[i] : least;
    }
    if (least > margin) return false;
    manifold.n = n;
    for (int i = 0; i < manifold.count; ++i) {
        manifold.points[i].P = {at_B[0][i], at_B[1][i], at_B[2][i]};
        manifold.points[i].separation = separation[i];
    }
    return true;
}

} }  // namespace ingot
