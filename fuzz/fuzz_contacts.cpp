// SPDX-License-Identifier: MIT
// The narrow phase, pair by pair, against two oracles that share no code with it.
//
//   Gap: the largest separation along any of many directions is no more than the distance of the shapes, by the support points of both: so a least
//   separation below it, beyond what limits.h allows, is a point that overlaps where there is room between the shapes. Along the manifold's own n,
//   the separation of the two shapes is that of the deepest point.
//   Surfaces: A point and the two ends of its separation lie on both shapes, by the distance of a point from each shape in closed form.
//   Swapped (where both kinds are the same) and moved as a whole, the pair gives the same depth.
//   n is of unit length, points are finite and no further apart than the margin, and the same call gives the same bits.
//
// INGOT_FUZZ_RUN names the function; fuzz_fault breaks a promise on purpose (CMakeLists.txt).
#include "bytes.h"
#include "fuzz_world.h"

namespace {

using namespace fuzz;
using ingot::Manifold;
using ingot::PlacedShape;
using Real = double;

struct V {
    Real x, y, z;
};
V wide(const Vector& v) { return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)}; }
V operator+(const V& a, const V& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
V operator-(const V& a, const V& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
V operator*(const V& a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
V cross(const V& a, const V& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Real dot(const V& a, const V& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Real length(const V& a) { return __builtin_sqrt(dot(a, a)); }
Real larger(Real a, Real b) { return a > b ? a : b; }
Real size_of(Real x) { return x < 0 ? -x : x; }
/// In the frame of a shape.
V to_body(const PlacedShape& s, const V& v) { return {dot(wide(s.A.c0), v), dot(wide(s.A.c1), v), dot(wide(s.A.c2), v)}; }

/// How far a shape reaches along a unit vector, from the origin of the world.
Real reach(const PlacedShape& s, const V& n) {
    const V d = to_body(s, n), size = wide(s.shape.size);
    Real most = dot(n, wide(s.r));
    switch (s.shape.kind) {
        case ShapeKind::sphere: return most + size.x;
        case ShapeKind::capsule: return most + size.x + size.y * size_of(d.z);
        case ShapeKind::box: return most + size.x * size_of(d.x) + size.y * size_of(d.y) + size.z * size_of(d.z);
        default: return most + size.x * __builtin_sqrt(d.x * d.x + d.y * d.y) + size.y * size_of(d.z);  // cylinder
    }
}

/// Distance of a point from a shape; within it minus the way to the nearest surface.
Real distance(const PlacedShape& s, const V& P) {
    if (s.shape.kind == ShapeKind::half_space) return dot(to_body(s, P - wide(s.r)), wide(s.shape.size)) - static_cast<Real>(s.shape.offset);
    const V p = to_body(s, P - wide(s.r)), size = wide(s.shape.size);
    const auto outside = [](Real a, Real b, Real c) {
        const V out = {larger(a, 0), larger(b, 0), larger(c, 0)};
        const Real in = larger(larger(a, b), c);
        return in > 0 ? length(out) : in;
    };
    const Real across = __builtin_sqrt(p.x * p.x + p.y * p.y), along = size_of(p.z);
    switch (s.shape.kind) {
        case ShapeKind::sphere: return length(p) - size.x;
        case ShapeKind::capsule: return length({p.x, p.y, larger(along - size.y, 0)}) - size.x;
        case ShapeKind::box: return outside(size_of(p.x) - size.x, size_of(p.y) - size.y, size_of(p.z) - size.z);
        default: return outside(across - size.x, along - size.y, across - size.x);
    }
}

/// Of two shapes along n, from B to A.
Real gap_along(const PlacedShape& A, const PlacedShape& B, const V& n) {
    const Real of_A = -reach(A, n * -1);
    if (B.shape.kind != ShapeKind::half_space) return of_A - reach(B, n);
    const V face = wide(B.A.c0) * static_cast<Real>(B.shape.size.x) + wide(B.A.c1) * static_cast<Real>(B.shape.size.y) +
                   wide(B.A.c2) * static_cast<Real>(B.shape.size.z);
    return -reach(A, face * -1) - dot(face, wide(B.r)) - static_cast<Real>(B.shape.offset);
}

bool collide(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold) {
    manifold = {};
    const auto are = [&](ShapeKind a, ShapeKind b) { return A.shape.kind == a && B.shape.kind == b; };
#define INGOT_PAIR(a, b)                                  \
    if (are(ShapeKind::a, ShapeKind::b)) {                \
        ingot::collide_##a##_##b(A, B, margin, manifold); \
        return true;                                      \
    }
    INGOT_PAIR(sphere, sphere)
    INGOT_PAIR(sphere, capsule)
    INGOT_PAIR(sphere, box)
    INGOT_PAIR(sphere, cylinder)
    INGOT_PAIR(sphere, half_space)
    INGOT_PAIR(capsule, capsule)
    INGOT_PAIR(capsule, box)
    INGOT_PAIR(capsule, cylinder)
    INGOT_PAIR(capsule, half_space)
    INGOT_PAIR(box, box)
    INGOT_PAIR(box, cylinder)
    INGOT_PAIR(box, half_space)
    INGOT_PAIR(cylinder, cylinder)
    INGOT_PAIR(cylinder, half_space)
#undef INGOT_PAIR
    return false;
}

Real least(const Manifold& m) {
    Real s = 1e30;
    for (int i = 0; i < m.count; ++i) s = static_cast<Real>(m.points[i].separation) < s ? static_cast<Real>(m.points[i].separation) : s;
    return s;
}

/// What the choices of limits.h leave, as in host_tests/collide/pairs_test.cpp: of the sizes of both, and rounding of places.
Real slack_of(const PlacedShape& A, const PlacedShape& B) {
    const auto has = [&](ShapeKind kind) { return A.shape.kind == kind || B.shape.kind == kind; };
    const Real size = static_cast<Real>(ingot::bounding_radius(A.shape) + ingot::bounding_radius(B.shape));
    const Real far = length(wide(A.r)) + length(wide(B.r)) + size_of(static_cast<Real>(B.shape.offset));
    Real share = 64 * static_cast<Real>(ingot::epsilon);
    const bool round = A.shape.kind == ShapeKind::sphere || (has(ShapeKind::capsule) && A.shape.kind == B.shape.kind);
    if (!round) share += static_cast<Real>(limits::edge_preference + limits::corner_slack);
    if (has(ShapeKind::capsule)) share += static_cast<Real>(1 - limits::lying_cos + limits::flatness);
    if (has(ShapeKind::cylinder)) share += static_cast<Real>(limits::nearest_direction + limits::round_accuracy) + 0.02;  // and cap_corners: 1.9 %
    return share * size + 64 * static_cast<Real>(ingot::epsilon) * far;
}

/// The smallest half extent.
Real least_extent(const PlacedShape& s) {
    const V size = wide(s.shape.size);
    Real least_of = size.x;
    if (s.shape.kind == ShapeKind::box && size.z < least_of) least_of = size.z;
    if ((s.shape.kind == ShapeKind::box || s.shape.kind == ShapeKind::cylinder) && size.y < least_of) least_of = size.y;
    return least_of;
}

uint64_t seen = 0;
void see(const Manifold& m) {
    const auto add = [](const void* data, size_t size) {
        for (size_t i = 0; i < size; ++i) seen = (seen ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3u;
    };
    add(&m.count, sizeof m.count);
    add(&m.n, sizeof m.n);
    for (int i = 0; i < m.count; ++i) add(&m.points[i].P, sizeof m.points[i].P);
}

/// Sizes from a centimetre to a hundred metres, the ratio of two up to a hundred or so.
Shape shape(Bytes& in, uint8_t kind) {
    const auto size = [&] { return scalar(0.02) + static_cast<scalar>(in.raw<uint16_t>()) / 8192 * (in.byte() < 16 ? 8 : 1); };
    const scalar a = size(), b = size(), c = size();
    switch (kind) {
        case 0: return ingot::Sphere{a};
        case 1: return ingot::Capsule{a, b};
        case 2: return ingot::Box{{a, b, c}};
        case 3: return ingot::Cylinder{a, b};
        default: return ingot::HalfSpace{{0, 0, 1}, a - 1};
    }
}
Matrix orientation(Bytes& in) {
    const uint8_t kind = in.byte();
    Vector n = {static_cast<scalar>(in.raw<int16_t>()), static_cast<scalar>(in.raw<int16_t>()), static_cast<scalar>(in.raw<int16_t>())};
    const scalar angle = static_cast<scalar>(in.raw<int16_t>()) / (kind < 64 ? 30000000 : 8192);  // at times nearly along the axes
    if (kind < 32 || ingot::length_sq(n) == 0) return ingot::identity_matrix<scalar>();
    n = n * (1 / ingot::sqrt(ingot::length_sq(n)));
    const Result<Matrix> A = ingot::rotation_about(n, angle);
    return A.ok() ? ingot::nearest_rotation(A.value) : ingot::identity_matrix<scalar>();
}

void demand_pair(const PlacedShape& A, const PlacedShape& B, scalar margin, const Manifold& m) {
    demand(m.count >= 0 && m.count <= Manifold::points_max, "a manifold has up to four points");
    const Real slack = slack_of(A, B);
    // Directions to look along: of a lattice, of all axes, and of the centres.
    Real gap = -1e30;
    const auto look = [&](V n) {
        const Real l = length(n);
        if (!(l > 1e-9)) return;
        gap = larger(gap, gap_along(A, B, n * (1 / l)));
        gap = larger(gap, gap_along(A, B, n * (-1 / l)));
    };
    const V axes[] = {wide(A.A.c0), wide(A.A.c1), wide(A.A.c2), wide(B.A.c0), wide(B.A.c1), wide(B.A.c2), wide(A.r) - wide(B.r)};
    for (const V& axis : axes) look(axis);
    const bool boxes = A.shape.kind == ShapeKind::box && B.shape.kind == ShapeKind::box;  // by all their axes, exactly
    for (int i = 0; boxes && i < 9; ++i) look(cross(axes[i % 3], axes[3 + i / 3]));
    for (int i = 0; i < 13; ++i) look({static_cast<Real>(i % 3 - 1), static_cast<Real>(i / 3 % 3 - 1), static_cast<Real>(i / 9 - 1)});
    if (m.count == 0) {
        // No point: the shapes are apart. Witness of the contrary: the centre of a shape within the other.
        demand(!(distance(B, wide(A.r)) < -slack), "overlap always gives a point");
        if (B.shape.kind != ShapeKind::half_space) demand(!(distance(A, wide(B.r)) < -slack), "overlap always gives a point");
        return;
    }
    demand(ingot::is_finite(m.n) && magnitude(ingot::length_sq(m.n) - 1) <= 64 * ingot::epsilon, "the normal of a manifold is of unit length");
    Real s = least(m);
    if (fuzz_fault == 1) s -= 0.2 * static_cast<Real>(ingot::bounding_radius(A.shape));
    demand(s <= static_cast<Real>(margin) + slack, "points are no further apart than the margin");
    // Overlapping cylinders are parted along a direction that no turn improves: not always the best there is (narrow_phase.h).
    const bool round = A.shape.kind == ShapeKind::cylinder || B.shape.kind == ShapeKind::cylinder;
    // Boxes whose edges cross all but in a face have the points of that face: as deep across it as the boxes are across the edges.
    const Real least_gap = gap < 0 && round ? gap_along(A, B, wide(m.n)) : gap < 0 && boxes ? gap / static_cast<Real>(limits::facing_cos) : gap;
    demand(s >= least_gap - slack, "shapes that are apart do not overlap");
    // Deeper than that n may be far from square to the surfaces, and the ends of a separation beyond their rims.
    const Real of_A = least_extent(A), of_B = B.shape.kind == ShapeKind::half_space ? of_A : least_extent(B);
    const bool shallow = s > -static_cast<Real>(limits::shallow) * (of_A < of_B ? of_A : of_B);
    // Those points of boxes are in both: along n the boxes may be deeper. So are those of a capsule that lies on a face, up to the root of flatness
    // aslant: its end beyond the rim may be deeper by as much of its length.
    const bool in_both = boxes || (A.shape.kind == ShapeKind::capsule && B.shape.kind == ShapeKind::box);
    const Real along_n = gap_along(A, B, wide(m.n)), deep_enough = in_both ? larger(gap, along_n) : along_n;
    if (shallow) demand(s >= along_n - slack && (s > 0 || s <= deep_enough + slack), "the deepest point is as deep as the shapes");
    // Rods that all but lie along each other have a point at each end of their common stretch, between their axes: aside of them as those part.
    Real aside = 0;
    if (A.shape.kind == ShapeKind::capsule && B.shape.kind == ShapeKind::capsule)
        aside = 2 * static_cast<Real>(A.shape.size.y < B.shape.size.y ? A.shape.size.y : B.shape.size.y) * length(cross(wide(A.A.c2), wide(B.A.c2)));
    const Real off = slack + aside;
    for (int i = 0; i < m.count; ++i) {
        demand(ingot::is_finite(m.points[i].P) && ingot::is_finite(m.points[i].separation), "points are finite");
        const V half = wide(m.n) * (static_cast<Real>(m.points[i].separation) / 2), P = wide(m.points[i].P);
        demand(!shallow || (distance(A, P + half) <= off && distance(B, P - half) <= off), "a point lies on both shapes");
    }
}

}  // namespace

uint64_t INGOT_FUZZ_RUN(const uint8_t* data, size_t size) {
    Bytes in(data, size);
    seen = 0;
    const uint8_t kinds = in.byte(), how = in.byte();
    PlacedShape A = {shape(in, kinds % 4u), {}, orientation(in), nullptr}, B = {shape(in, kinds / 4u % 5u), {}, orientation(in), nullptr};
    if (B.shape.kind < A.shape.kind) {
        const PlacedShape C = A;
        A = B, B = C;
    }
    // Beside each other, by a share of the sizes: at times exactly along an axis, and at times far from the origin.
    const scalar sizes = ingot::bounding_radius(A.shape) + ingot::bounding_radius(B.shape);
    const auto share = [&] { return static_cast<scalar>(in.raw<int16_t>()) / 32768; };
    const scalar x = share(), y = share(), z = share();
    A.r = Vector{x, (how & 1u) != 0 ? y : 0, (how & 2u) != 0 ? z : 0} * (sizes * scalar(1.05));
    if ((how & 28u) == 28u) {
        const Vector away = {share() * 1000, share() * 1000, share() * 1000};
        A.r += away, B.r += away;
    }
    const scalar margin = (how & 32u) != 0 ? scalar(0) : limits::contact_margin;
    Manifold m, again;
    if (!collide(A, B, margin, m)) return 0;
    see(m);
    demand_pair(A, B, margin, m);
    (void)collide(A, B, margin, again);
    demand(m.count == again.count && same_bytes(&m.n, &again.n, sizeof m.n) &&
               same_bytes(m.points, again.points, sizeof m.points[0] * static_cast<size_t>(m.count)),
           "the same call gives the same bits");

    // Of overlapping cylinders the way out need not be the shortest, and another one may be found from the other side.
    if (m.count == 0 || (least(m) < 0 && (A.shape.kind == ShapeKind::cylinder || B.shape.kind == ShapeKind::cylinder))) return seen;
    // Of shapes that are apart, edges and corners that are not above each other are left out (narrow_phase.h): rounding may tell which.
    const Real slack = 2 * slack_of(A, B);
    const auto as_deep = [&] {
        return m.count == 0 || again.count == 0 || (least(m) > slack && least(again) > slack) || size_of(least(m) - least(again)) <= slack;
    };
    if (A.shape.kind == B.shape.kind) {
        (void)collide(B, A, margin, again);
        demand(as_deep(), "swapped, a pair is as deep");
        const Manifold& found = m.count != 0 ? m : again;
        demand((m.count != 0) == (again.count != 0) || least(found) > -slack, "swapped, a pair that overlaps does so");
    }
    const Vector by = {scalar(0.25), -3, scalar(1.5)};
    PlacedShape moved_A = A, moved_B = B;
    moved_A.r += by, moved_B.r += by;
    (void)collide(moved_A, moved_B, margin, again);
    if (fuzz_fault == 2 && again.count > 0) again.points[0].separation -= sizes;
    demand(as_deep(), "moved, a pair is as deep");
    return seen;
}
