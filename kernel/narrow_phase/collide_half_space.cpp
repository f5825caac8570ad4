// SPDX-License-Identifier: MIT
// Corners, ends and rims above a face without end.
#include "contact_geometry.h"
#include "collide_pairs.h"

namespace ingot { inline namespace INGOT_ABI {

void collide_capsule_half_space(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold*) {
    const HeightAbove face = face_below(B, A.r);
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
    const HeightAbove face = face_below(B, A.r);
    const Vector half = A.shape.size;
    const Vector edges[3] = {A.A.c0 * half.x, A.A.c1 * half.y, A.A.c2 * half.z};
    scalar rise[3];
    for (int i = 0; i < 3; ++i) rise[i] = dot(face.n, edges[i]);
    if (face.height - (abs(rise[0]) + abs(rise[1]) + abs(rise[2])) > margin) return no_points(face.n, manifold);

    // Of a box thinner than the margin all eight corners are near, and the upper ones span as much as those below: then the face that looks down is
    // what touches.
    int upright = 0;
    for (int i = 1; i < 3; ++i)
        if (abs(rise[i]) * component(half, upright) > abs(rise[upright]) * component(half, i)) upright = i;
    const uint32_t upper = rise[upright] > 0 ? 1u << upright : 0u;

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
    if (count == 8) {
        count = 0;
        for (int i = 0; i < 8; ++i)
            if ((candidates[i].feature & 1u << upright) != upper) candidates[count++] = candidates[i];
    }
    keep_points(candidates, count, frame, limits::flatness * smallest_of(half), before, manifold);
}

void collide_cylinder_half_space(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                                 const Manifold* before_it) {
    const Before before = remember(before_it);
    const HeightAbove face = face_below(B, A.r);
    const scalar r = A.shape.size.x, h = A.shape.size.y;
    const Vector down = transpose_times(A.A, -face.n);
    const scalar across = sqrt(down.x * down.x + down.y * down.y), rise = -(h * abs(down.z));
    if (face.height + rise - r * across > margin) return no_points(face.n, manifold);

    // The lower end: four points of its rim that are fixed to the body, and its lowest where that is lower than these; the upper
    // end has its own lowest, for a cylinder on its side. In the frame of the cylinder, feature by feature.
    // One that is clearly tilted rolls on its lowest point: with a fixed one as it passes by, it would roll as a square does, and lose energy.
    const ContactFrame frame = frame_about(face.n, A.r - face.n * face.height);
    Candidate candidates[6];
    int count = 0;
    scalar fixed_lowest = scalar_max;
    const auto add = [&](const Vector& p, uint32_t feature) {
        const Vector from_centre = A.A * p;
        const scalar s = face.height + dot(face.n, from_centre);
        if (!(s <= margin)) return;
        candidates[count++] = {dot(from_centre, frame.e_x), dot(from_centre, frame.e_y), s * scalar(0.5), s, feature};
    };
    const scalar lower = down.z < 0 ? -h : h;
    const uint32_t end = down.z < 0 ? 0u : 8u;
    const Vector rim[4] = {{r, 0, lower}, {0, r, lower}, {-r, 0, lower}, {0, -r, lower}};
    // Steeper than this the points beside the lowest are not what it stands on, but its side may lie.
    const bool on_its_end = abs(down.z) >= limits::facing_sin;
    const bool rolls = across > limits::rolling_sin;
    uint32_t nearest = 0;
    for (uint32_t k = 0; k < 4; ++k) {
        const scalar s = face.height - dot(down, rim[k]);
        nearest = s < fixed_lowest ? k : nearest;
        fixed_lowest = s < fixed_lowest ? s : fixed_lowest;
    }
    for (uint32_t k = 0; k < 4; ++k)
        if (on_its_end && !(rolls && k == nearest)) add(rim[k], end | k);
    if (across > 0) {
        const Vector lowest{r * (down.x / across), r * (down.y / across), lower};
        if (!on_its_end || rolls || face.height - dot(down, lowest) < fixed_lowest - limits::flatness * r) add(lowest, end | 4u);
        add({lowest.x, lowest.y, -lower}, end | 5u);
    }
    keep_points(candidates, count, frame, limits::flatness * (r < h ? r : h), before, manifold);
}

namespace {

/// Bit per corner: of the face of a hull that looks most against n.
uint32_t corners_against(const ConvexHull& hull, const Vector& n) {
    int lowest = 0;
    scalar least = 2;
    // bound: 2 limits::hull_vertices_max - 4
    for (int face_i = 0; face_i < hull.face_count; ++face_i) {
        const scalar up = dot(hull.faces[face_i].n, n);
        if (up < least) {
            least = up;
            lowest = face_i;
        }
    }
    const HullFace& face = hull.faces[lowest];
    uint32_t corners = 0;
    // bound: limits::hull_vertices_max
    for (int i = 0; i < face.loop_count; ++i) corners |= 1u << hull.loops[face.loop_first + i];
    return corners;
}

}  // namespace

void collide_hull_half_space(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                             const Manifold* before_it) {
    const Before before = remember(before_it);
    const HeightAbove face = face_below(B, A.r);
    if (face.height - A.hull->radius > margin) return no_points(face.n, manifold);
    const Vector n = transpose_times(A.A, face.n);
    const ContactFrame frame = frame_about(face.n, A.r - face.n * face.height);
    Candidate candidates[limits::hull_vertices_max];
    int count = 0;
    // bound: limits::hull_vertices_max
    for (int i = 0; i < A.hull->vertex_count && count < limits::hull_vertices_max; ++i) {
        const Vector& p = A.hull->vertices[i];
        const scalar s = face.height + dot(n, p);
        if (!(s <= margin)) continue;
        const Vector from_centre = A.A * p;
        candidates[count++] = {dot(from_centre, frame.e_x), dot(from_centre, frame.e_y), s * scalar(0.5), s,
                               static_cast<uint32_t>(i)};
    }
    // Of a hull thinner than the margin all corners are near, and upper ones would carry as well, and be drawn down: then the face that looks down is
    // what touches, and whatever corner is lowest.
    if (count == A.hull->vertex_count) {
        int lowest = 0;
        // bound: limits::hull_vertices_max
        for (int i = 1; i < count; ++i)
            if (candidates[i].separation < candidates[lowest].separation) lowest = i;
        const uint32_t kept = corners_against(*A.hull, n) | 1u << lowest;
        int kept_count = 0;
        for (int i = 0; i < count; ++i)
            if ((kept >> i & 1u) != 0) candidates[kept_count++] = candidates[i];
        count = kept_count;
    }
    keep_near_points(candidates, count, frame, limits::flatness * A.hull->radius, before, margin, manifold);
}

} }  // namespace ingot
