// SPDX-License-Identifier: MIT
// The 15 axes that may separate two boxes: see Gottschalk, Lin, Manocha, "OBBTree", 1996.
#pragma once

#include "contact_geometry.h"

namespace ingot { inline namespace INGOT_ABI {

inline constexpr uint8_t axis_after[5] = {0, 1, 2, 0, 1};  // axis_after[i + 1] and axis_after[i + 2] are the other two axes

// Axes by number: 0 .. 2 the faces of A, 3 .. 5 those of B, 6 + 3 i + j the edges i of A and j of B.
inline constexpr int first_edge_axis = 6;
inline constexpr int no_axis = -1;

inline constexpr Vector Matrix::*column_of[3] = {&Matrix::c0, &Matrix::c1, &Matrix::c2};
INGOT_INLINE const Vector& column(const Matrix& A, int i) { return A.*column_of[i]; }

/// Which axis separates the boxes best, where that is by no more than the margin.
struct BestAxis {
    int face;           ///< 0 .. 5
    int edge;           ///< 6 .. 14 where two edges separate clearly better than any face, else no_axis
    scalar separation;  ///< m, of the better of the two
    scalar smallest;    ///< m, half extent
};

/// The boxes as they see each other, of which every axis is made.
struct BoxesAlong {
    scalar a[3], b[3];  ///< m, half extents
    scalar d_of_A[3];   ///< m, from the centre of B to that of A, along the axes of A
    scalar R[3][3];     ///< R[j][i] = A_i . B_j
};

/// kept: the separation along the face of the step before.
INGOT_INLINE void look_at_face(int axis, scalar s, int axis_before, scalar& kept, BestAxis& best) {
    if (axis == axis_before) kept = s;
    if (!(s > best.separation)) return;
    best.separation = s;
    best.face = axis;
}

/// The face that separates best, that of the step before if it is as good but for axis_hysteresis. Fills in R.
/// False where a face separates the boxes by more than the margin: the manifold has its direction then.
INGOT_INLINE bool find_face_axis(const PlacedShape& A, const PlacedShape& B, scalar margin, int axis_before, BoxesAlong& boxes, BestAxis& best,
                                 Manifold& manifold) {
    const Vector d = A.r - B.r, d_A = transpose_times(A.A, d);
    scalar(&d_of_A)[3] = boxes.d_of_A, (&R)[3][3] = boxes.R;
    const scalar(&a)[3] = boxes.a, (&b)[3] = boxes.b;
    d_of_A[0] = d_A.x, d_of_A[1] = d_A.y, d_of_A[2] = d_A.z;
    scalar reach_A[3] = {a[0], a[1], a[2]};
    best.separation = -scalar_max;
    best.face = 0;
    scalar kept = -scalar_max;

    for (int j = 0; j < 3; ++j) {
        const Vector& B_j = column(B.A, j);
        const Vector r = transpose_times(A.A, B_j);
        R[j][0] = r.x, R[j][1] = r.y, R[j][2] = r.z;
        for (int i = 0; i < 3; ++i) reach_A[i] += b[j] * abs(R[j][i]);
        const scalar along = dot(B_j, d), s = abs(along) - (b[j] + (a[0] * abs(r.x) + a[1] * abs(r.y) + a[2] * abs(r.z)));
        if (s > margin) return no_points(along < 0 ? -B_j : B_j, manifold), false;
        look_at_face(3 + j, s, axis_before, kept, best);
    }
    for (int i = 0; i < 3; ++i) {
        const scalar s = abs(d_of_A[i]) - reach_A[i];
        if (s > margin) return no_points(d_of_A[i] < 0 ? -column(A.A, i) : column(A.A, i), manifold), false;
        look_at_face(i, s, axis_before, kept, best);
    }
    if (axis_before >= 0 && axis_before < first_edge_axis && kept + limits::axis_hysteresis * best.smallest >= best.separation) {
        best.separation = kept;
        best.face = axis_before;
    }
    return true;
}

/// The pair of edges that separates clearly better than that face, where there is one.
/// False where two edges separate the boxes by more than the margin: the manifold has their direction.
INGOT_INLINE bool find_edge_axis(const PlacedShape& A, const PlacedShape& B, scalar margin, int axis_before, const BoxesAlong& boxes,
                                 BestAxis& best, Manifold& manifold) {
    const scalar(&d_of_A)[3] = boxes.d_of_A, (&R)[3][3] = boxes.R, (&a)[3] = boxes.a, (&b)[3] = boxes.b;
    best.edge = no_axis;
    // What is compared is less by the rounding of a product that nearly cancels.
    scalar least = best.separation + limits::edge_preference * best.smallest;
    for (int j = 0; j < 3; ++j) {
        const int j1 = axis_after[j + 1], j2 = axis_after[j + 2];
        for (int i = 0; i < 3; ++i) {
            const int i1 = axis_after[i + 1], i2 = axis_after[i + 2];
            const scalar length_sq_of_axis = R[j][i1] * R[j][i1] + R[j][i2] * R[j][i2];
            if (!(length_sq_of_axis > limits::parallel_sin_sq)) continue;
            const scalar along = d_of_A[i2] * R[j][i1] - d_of_A[i1] * R[j][i2];
            const scalar reach =
                (a[i1] * abs(R[j][i2]) + a[i2] * abs(R[j][i1])) + (b[j1] * abs(R[j2][i]) + b[j2] * abs(R[j1][i]));
            const scalar inv_length = 1 / sqrt(length_sq_of_axis);
            scalar s = (abs(along) - reach - 8 * epsilon * (abs(along) + reach)) * inv_length;
            if (s > margin) {
                const Vector n = cross(column(A.A, i), column(B.A, j)) * (along < 0 ? -inv_length : inv_length);
                return no_points(n, manifold), false;
            }
            const int axis = first_edge_axis + 3 * i + j;
            if (axis == axis_before) s += limits::axis_hysteresis * best.smallest;
            if (!(s > least)) continue;
            least = s;
            best.separation = s;
            best.edge = axis;
        }
    }
    return true;
}

/// False where an axis separates the boxes by more than the margin: the manifold has its direction.
INGOT_INLINE bool find_axis(const PlacedShape& A, const PlacedShape& B, scalar margin, int axis_before, BestAxis& best, Manifold& manifold) {
    BoxesAlong boxes;
    boxes.a[0] = A.shape.size.x, boxes.a[1] = A.shape.size.y, boxes.a[2] = A.shape.size.z;
    boxes.b[0] = B.shape.size.x, boxes.b[1] = B.shape.size.y, boxes.b[2] = B.shape.size.z;
    const scalar smallest_a = smallest_of(A.shape.size), smallest_b = smallest_of(B.shape.size);
    best.smallest = smallest_a < smallest_b ? smallest_a : smallest_b;
    return find_face_axis(A, B, margin, axis_before, boxes, best, manifold) &&
           find_edge_axis(A, B, margin, axis_before, boxes, best, manifold);
}

} }  // namespace ingot
