// SPDX-License-Identifier: MIT
#include "manifold_anchors.h"

#include "../base/limits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr int points_max = Manifold::points_max;

/// A times each of four columns. Loops over four numbers: compilers make one instruction of each.
void turn(const Matrix& A, const scalar (&from)[3][points_max], scalar (&to)[3][points_max]) {
    // bound: 4: Manifold::points_max
    for (int i = 0; i < points_max; ++i) to[0][i] = A.c0.x * from[0][i] + A.c1.x * from[1][i] + A.c2.x * from[2][i];
    for (int i = 0; i < points_max; ++i) to[1][i] = A.c0.y * from[0][i] + A.c1.y * from[1][i] + A.c2.y * from[2][i];
    for (int i = 0; i < points_max; ++i) to[2][i] = A.c0.z * from[0][i] + A.c1.z * from[1][i] + A.c2.z * from[2][i];
}

void put(scalar (&to)[3][points_max], int point_i, const Vector& value) {
    to[0][point_i] = value.x;
    to[1][point_i] = value.y;
    to[2][point_i] = value.z;
}

}  // namespace

void anchor(const BodyFrame& A, const BodyFrame& B, const Manifold& manifold, scalar margin, ManifoldAnchors& anchors) {
    anchors.margin = margin;
    anchors.n_A = transpose_times(A.A, manifold.n);
    anchors.n_B = transpose_times(B.A, manifold.n);
    // bound: 4: Manifold::points_max
    for (int point_i = 0; point_i < manifold.count; ++point_i) {
        const ManifoldPoint& point = manifold.points[point_i];
        const Vector half_gap = manifold.n * (point.separation * scalar(0.5));
        anchors.separation[point_i] = point.separation;
        put(anchors.on_A, point_i, transpose_times(A.A, point.P - A.r + half_gap));
        put(anchors.on_B, point_i, transpose_times(B.A, point.P - B.r - half_gap));
    }
    for (int point_i = manifold.count; point_i < points_max; ++point_i) {
        put(anchors.on_A, point_i, {});
        put(anchors.on_B, point_i, {});
        anchors.separation[point_i] = 0;
    }
}

bool renew_from_anchors(const BodyFrame& A, const BodyFrame& B, const RenewLimits& within, const ManifoldAnchors& anchors, Manifold& manifold) {
    if (!(anchors.margin > 0) || within.margin > anchors.margin + within.spare) return false;
    const Vector n = B.A * anchors.n_B, tilt = A.A * anchors.n_A - n;
    if (!(length_sq(tilt) <= limits::recycled_slip * limits::recycled_slip)) return false;

    const Vector between = A.r - B.r;
    scalar at_A[3][points_max], at_B[3][points_max], separation[points_max], moved_sq[points_max];
    turn(A.A, anchors.on_A, at_A);
    turn(B.A, anchors.on_B, at_B);
    for (int i = 0; i < points_max; ++i) {
        const scalar x = between.x + (at_A[0][i] - at_B[0][i]), y = between.y + (at_A[1][i] - at_B[1][i]), z = between.z + (at_A[2][i] - at_B[2][i]);
        const scalar s = n.x * x + n.y * y + n.z * z;
        const scalar s_0 = anchors.separation[i], moved_x = x - n.x * s_0, moved_y = y - n.y * s_0, moved_z = z - n.z * s_0;
        separation[i] = s;
        moved_sq[i] = moved_x * moved_x + moved_y * moved_y + moved_z * moved_z;
        at_B[0][i] = B.r.x + at_B[0][i] + x * scalar(0.5);
        at_B[1][i] = B.r.y + at_B[1][i] + y * scalar(0.5);
        at_B[2][i] = B.r.z + at_B[2][i] + z * scalar(0.5);
    }
    scalar least = limits::unbounded;
    for (int i = 0; i < manifold.count; ++i) {
        if (!(moved_sq[i] <= within.slip * within.slip)) return false;
        least = separation[i] < least ? separation[i] : least;
    }
    if (least > within.margin) return false;
    manifold.n = n;
    for (int i = 0; i < manifold.count; ++i) {
        manifold.points[i].P = {at_B[0][i], at_B[1][i], at_B[2][i]};
        manifold.points[i].separation = separation[i];
    }
    return true;
}

} }  // namespace ingot
