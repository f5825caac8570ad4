// SPDX-License-Identifier: MIT
#include "recycle.h"

#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

Matrix relative_turn(const PlacedShape& A, const PlacedShape& B) {
    return {transpose_times(B.A, A.A.c0), transpose_times(B.A, A.A.c1), transpose_times(B.A, A.A.c2)};
}

}  // namespace

void keep_manifold(const PlacedShape& A, const PlacedShape& B, const Manifold& manifold, KeptManifold& kept) {
    kept.A_in_B = relative_turn(A, B);
    kept.r_in_B = transpose_times(B.A, A.r - B.r);
    kept.n_B = transpose_times(B.A, manifold.n);
    kept.count = manifold.count;
    for (int i = 0; i < manifold.count; ++i) {
        const ManifoldPoint& point = manifold.points[i];
        const Vector half = manifold.n * (point.separation * scalar(0.5));
        kept.on_A[i] = transpose_times(A.A, (point.P - A.r) + half);
        kept.on_B[i] = transpose_times(B.A, (point.P - B.r) - half);
        kept.features[i] = point.feature;
    }
}

scalar moved_since(const PlacedShape& A, const PlacedShape& B, const KeptManifold& kept) {
    const Matrix Q = relative_turn(A, B);
    const Vector r = transpose_times(B.A, A.r - B.r), dx = Q.c0 - kept.A_in_B.c0, dy = Q.c1 - kept.A_in_B.c1,
                 dz = Q.c2 - kept.A_in_B.c2;
    const scalar chord = sqrt((length_sq(dx) + length_sq(dy) + length_sq(dz)) * scalar(0.5));
    const scalar R_A = bounding_radius(A.shape), R_B = bounding_radius(B.shape);
    const bool of_A = B.shape.kind == ShapeKind::half_space || R_A <= R_B;
    // The origin of B as seen from A is -Q^T r.
    const Vector dr = of_A ? r - kept.r_in_B : transpose_times(Q, r) - transpose_times(kept.A_in_B, kept.r_in_B);
    return sqrt(length_sq(dr)) + chord * (of_A ? R_A : R_B);
}

bool recycle_manifold(const PlacedShape& A, const PlacedShape& B, const KeptManifold& kept, scalar allowed, scalar margin,
                      Manifold& manifold) {
    if (!(moved_since(A, B, kept) <= allowed)) return false;
    const Vector d = A.r - B.r, n = B.A * kept.n_B;
    manifold.n = n;
    manifold.count = 0;
    for (int i = 0; i < kept.count; ++i) {
        const Vector a = d + A.A * kept.on_A[i], b = B.A * kept.on_B[i];
        const scalar separation = dot(n, a - b);
        if (!(separation <= margin)) continue;
        manifold.points[manifold.count++] = {B.r + (a + b) * scalar(0.5), separation, kept.features[i]};
    }
    return true;
}

} }  // namespace ingot
