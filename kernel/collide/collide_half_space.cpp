// SPDX-License-Identifier: MIT
// Corners, ends and rims above a face without end.
#include "contact_geometry.h"
#include "narrow_phase.h"

namespace ingot { inline namespace INGOT_ABI {

void collide_capsule_half_space(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold*) {
    const WorldFace face = face_below(B, A.r);
    const Vector end = A.A.c2 * A.shape.size.y;
    const scalar rise = dot(face.n, end), radius = A.shape.size.x;
    no_points(face.n, manifold);
    for (uint32_t end_i = 0; end_i < 2; ++end_i) {
        const scalar s = (end_i == 0 ? face.height - rise : face.height + rise) - radius;
        if (!(s <= margin)) continue;
        const Vector c = end_i == 0 ? A.r - end : A.r + end;
        manifold.points[manifold.count++] = {c - face.n * (radius + s * scalar(0.5)), s, end_i};
    }
}

void collide_box_half_space(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                            const Manifold* before_it) {
    const Before before = remember(before_it);
    const WorldFace face = face_below(B, A.r);
    const Vector half = A.shape.size;
    const Vector edges[3] = {A.A.c0 * half.x, A.A.c1 * half.y, A.A.c2 * half.z};
    scalar rise[3];
    for (int i = 0; i < 3; ++i) rise[i] = dot(face.n, edges[i]);
    if (face.height - (abs(rise[0]) + abs(rise[1]) + abs(rise[2])) > margin) return no_points(face.n, manifold);

    const ContactFrame frame = frame_about(face.n, A.r - face.n * face.height);
    Candidate candidates[8];
    int count = 0;
    for (uint32_t corner = 0; corner < 8; ++corner) {
        const scalar x = (corner & 1u) != 0 ? scalar(1) : scalar(-1), y = (corner & 2u) != 0 ? scalar(1) : scalar(-1),
                     z = (corner & 4u) != 0 ? scalar(1) : scalar(-1);
        const scalar s = face.height + (x * rise[0] + y * rise[1] + z * rise[2]);
        if (!(s <= margin)) continue;
        const Vector p = edges[0] * x + edges[1] * y + edges[2] * z;
        candidates[count++] = {dot(p, frame.e_x), dot(p, frame.e_y), s * scalar(0.5), s, corner};
    }
    keep_points(candidates, count, frame, limits::flatness * smallest_of(half), before, manifold);
}

} }  // namespace ingot
