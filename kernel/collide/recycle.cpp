// SPDX-License-Identifier: MIT
#include "recycle.h"

#include "../base/limits.h"

namespace ingot { inline namespace INGOT_ABI {

void anchor(const PlacedShape& A, const PlacedShape& B, const Manifold& manifold, scalar margin, ManifoldAnchors& anchors) {
    anchors.margin = margin;
    anchors.n_A = transpose_times(A.A, manifold.n);
    anchors.n_B = transpose_times(B.A, manifold.n);
    for (int point_i = 0; point_i < manifold.count; ++point_i) {
        const ManifoldPoint& point = manifold.points[point_i];
        const Vector half_gap = manifold.n * (point.separation * scalar(0.5));
        anchors.on_A[point_i] = transpose_times(A.A, point.P - A.r + half_gap);
        anchors.on_B[point_i] = transpose_times(B.A, point.P - B.r - half_gap);
    }
}

bool renew_from_anchors(const PlacedShape& A, const PlacedShape& B, scalar slip, scalar margin, const ManifoldAnchors& anchors, Manifold& manifold) {
    if (!(anchors.margin > 0) || margin > anchors.margin + limits::contact_margin / 2) return false;
    const scalar slip_sq = slip * slip;
    const Vector n = B.A * anchors.n_B, tilt = A.A * anchors.n_A - n;
    if (!(length_sq(tilt) <= limits::recycled_slip * limits::recycled_slip)) return false;
    const Vector between = A.r - B.r;
    Vector P[Manifold::points_max];
    scalar separation[Manifold::points_max], least = limits::unbounded;
    for (int point_i = 0; point_i < manifold.count; ++point_i) {
        const Vector at_A = A.A * anchors.on_A[point_i], at_B = B.A * anchors.on_B[point_i], gap = between + (at_A - at_B);
        separation[point_i] = dot(n, gap);
        if (!(length_sq(gap - n * separation[point_i]) <= slip_sq)) return false;
        P[point_i] = B.r + at_B + gap * scalar(0.5);
        least = separation[point_i] < least ? separation[point_i] : least;
    }
    if (least > margin) return false;
    manifold.n = n;
    for (int point_i = 0; point_i < manifold.count; ++point_i) {
        manifold.points[point_i].P = P[point_i];
        manifold.points[point_i].separation = separation[point_i];
    }
    return true;
}

} }  // namespace ingot
