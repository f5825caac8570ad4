// SPDX-License-Identifier: MIT
#include "collide_manifolds.h"

namespace ingot { inline namespace INGOT_ABI {

void collide_sphere_sphere(const Placed& A, const Placed& B, scalar margin, Manifold& m) {
    const Vector d = A.r_CM - B.r_CM;
    const scalar distance = sqrt(length_sq(d)), r_A = A.shape.size.x, r_B = B.shape.size.x;
    const scalar s = distance - r_A - r_B;
    m.count = 0;
    if (s > margin) return;
    m.n = distance > epsilon * (r_A + r_B) ? d * (1 / distance) : Vector{1, 0, 0};
    m.count = 1;
    m.points[0] = {B.r_CM + m.n * (r_B + s * scalar(0.5)), s, 0};
}
void collide_sphere_box(const Placed&, const Placed&, scalar, Manifold& m) { m.count = 0; }
void collide_sphere_half_space(const Placed& A, const Placed& B, scalar margin, Manifold& m) {
    m.n = B.A * B.shape.size;
    const scalar s = dot(m.n, A.r_CM - B.r_CM) - B.shape.offset - A.shape.size.x;
    m.count = 0;
    if (s > margin) return;
    m.count = 1;
    m.points[0] = {A.r_CM - m.n * (A.shape.size.x + s * scalar(0.5)), s, 0};
}
void collide_box_half_space(const Placed& A, const Placed& B, scalar margin, Manifold& m) {
    m.n = B.A * B.shape.size;
    m.count = 0;
    const Vector half = A.shape.size;
    scalar s[8]; Vector P[8];
    bool used[8] = {};
    for (int i = 0; i < 8; ++i) {
        const Vector local = {(i & 1) ? half.x : -half.x, (i & 2) ? half.y : -half.y, (i & 4) ? half.z : -half.z};
        P[i] = A.r_CM + A.A * local;
        s[i] = dot(m.n, P[i] - B.r_CM) - B.shape.offset;
    }
    for (int k = 0; k < 4; ++k) {
        int best = -1;
        for (int i = 0; i < 8; ++i) if (!used[i] && s[i] <= margin && (best < 0 || s[i] < s[best])) best = i;
        if (best < 0) return;
        used[best] = true;
        m.points[m.count++] = {P[best] - m.n * (s[best] * scalar(0.5)), s[best], static_cast<uint32_t>(best)};
    }
}
void collide_box_box(const Placed& A, const Placed& B, scalar margin, Manifold& m) {  // axis-aligned stacks only
    m.count = 0;
    const Vector d = transpose_times(B.A, A.r_CM - B.r_CM);
    const Vector over = {A.shape.size.x + B.shape.size.x - abs(d.x), A.shape.size.y + B.shape.size.y - abs(d.y), A.shape.size.z + B.shape.size.z - abs(d.z)};
    if (over.x < -margin || over.y < -margin || over.z < -margin) return;
    if (over.x < over.z || over.y < over.z) return;
    const bool a_up = d.z > 0;
    const Placed &up = a_up ? A : B, &lo = a_up ? B : A;
    m.n = lo.A.c2 * (a_up ? scalar(1) : scalar(-1));
    const Vector n = lo.A.c2;
    const Vector c = transpose_times(lo.A, up.r_CM - lo.r_CM);
    for (int i = 0; i < 4; ++i) {
        Vector local = {(i & 1) ? up.shape.size.x : -up.shape.size.x, (i & 2) ? up.shape.size.y : -up.shape.size.y, -up.shape.size.z};
        // clip in x,y of lower
        Vector p = transpose_times(lo.A, up.r_CM + up.A * local - lo.r_CM);
        const scalar hx = lo.shape.size.x, hy = lo.shape.size.y;
        p.x = p.x > hx ? hx : p.x < -hx ? -hx : p.x; p.y = p.y > hy ? hy : p.y < -hy ? -hy : p.y;
        // height of upper's bottom plane at p
        const Vector world = lo.r_CM + lo.A * Vector{p.x, p.y, hx * 0};
        const Vector bottom = up.A.c2;
        const scalar t = dot(bottom, up.r_CM - up.A.c2 * up.shape.size.z - world) / dot(bottom, n);
        const scalar s = t - lo.shape.size.z;
        if (s > margin) continue;
        m.points[m.count++] = {world + n * (lo.shape.size.z + s * scalar(0.5)), s, static_cast<uint32_t>(i)};
    }
    (void)c;
}

} }  // namespace ingot
