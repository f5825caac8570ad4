// SPDX-License-Identifier: MIT
// Mass, centre of mass and inertia of solids: of simple shapes, of meshes, of bodies made of parts, of a tensor from elsewhere.
//
//     constexpr MassDistribution bar = solid_cylinder(7850, 0.01f, 0.05f);
//     constexpr MassDistribution hammer = combined(bar, placed(solid_box(7850, {0.02f, 0.02f, 0.04f}), A, {0, 0, 0.06f}));
//     constexpr Result<MassProperties> mass = principal(hammer);    // in flash: nothing of it is left to do at run time
//
//     static_assert(mass.ok(), "a solid hammer");
//
// Densities in kg m^-3, lengths in m. What describes no solid is refused by principal at the latest: a density or size that is
// not positive, and an A that is no rotation, give a distribution of NaN, which stays one through every sum and ends there as
// not_finite; a mass that comes out zero or negative ends as bad_mass.
#pragma once

#include "../base/status.h"
#include "../math/rotation.h"
#include "principal_axes.h"

namespace ingot { inline namespace INGOT_ABI {

/// Mass, centre of mass and inertia of a solid, all in the frame its user models it in.
struct MassDistribution {
    scalar M{};              ///< kg
    Vector r_CM{};           ///< m, centre of mass in the user's frame
    SymmetricMatrix I{};     ///< kg m^2, about the centre of mass, along the user's axes
};

/// The same in the body frame of the kernel: origin at the centre of mass, axes along the principal axes.
struct MassProperties {
    scalar M{};          ///< kg
    Vector I_body{};     ///< kg m^2, principal moments
    Vector r_CM{};       ///< m, centre of mass in the user's frame: keeps that frame reachable
    Matrix A_principal = identity_matrix<scalar>();  ///< columns are the principal axes in the user's frame; a rotation
};

/// A triangle of a mesh: indices of its vertices, counter-clockwise as seen from outside the solid.
struct MeshTriangle {
    int a{}, b{}, c{};  ///< index of a vertex
};

namespace solids {

inline constexpr scalar pi = scalar(3.14159265358979323846);

/// What comes of arguments that describe no solid.
constexpr MassDistribution no_solid() {
    constexpr scalar nan = INGOT_NAN(scalar);
    return {nan, {nan, nan, nan}, {nan, nan, nan, nan, nan, nan}};
}

/// Its tensor is diagonal: I_x, I_y, I_z about a centre of mass at height z.
constexpr MassDistribution along_axes(scalar M, scalar z, scalar I_x, scalar I_y, scalar I_z) {
    return {M, {0, 0, z}, {I_x, I_y, I_z, 0, 0, 0}};
}

/// r r^T.
constexpr SymmetricMatrix outer(const Vector& r) {
    return {r.x * r.x, r.y * r.y, r.z * r.z, r.x * r.y, r.x * r.z, r.y * r.z};
}

/// The inertia tensor tr(S) 1 - S of a solid whose second moments are S = integral of r r^T dm; it is the sum of
/// -m tilde(r) tilde(r) of Hecker 1997, Eq. 19. Without a subtraction, and without -0.
constexpr SymmetricMatrix inertia_from(const SymmetricMatrix& S) {
    return {S.yy + S.zz, S.xx + S.zz, S.xx + S.yy, 0 - S.xy, 0 - S.xz, 0 - S.yz};
}

/// What a mass M adds to the tensor when it is seen from a point r away from its centre (Huygens and Steiner).
constexpr SymmetricMatrix parallel_axis(scalar M, const Vector& r) { return inertia_from(outer(r) * M); }

}  // namespace solids

// Simple shapes. Each is the integral of its density over the solid; the formulas are those of any table (for instance Beer and
// Johnston, "Vector Mechanics for Engineers", inside the back cover) and stand in host_tests/reference to 32 digits.
// Error: at most 13 roundings of sizes of any kind (I_x of a capsule; a box takes 7); on the table, 2 ulps.

/// A ball about the origin. M = 4/3 pi r^3 density, I = 2/5 M r^2.
constexpr MassDistribution solid_sphere(scalar density, scalar radius) {
    if (!(density > 0 && radius > 0)) return solids::no_solid();
    const scalar r2 = radius * radius, M = density * (4 * (solids::pi * (r2 * radius)) / 3), I = M * (2 * r2) / 5;
    return solids::along_axes(M, 0, I, I, I);
}

/// A box about the origin, along the axes. M = 8 a b c density, I_x = M (b^2 + c^2) / 3 with half extents a, b, c.
constexpr MassDistribution solid_box(scalar density, const Vector& half_extents) {
    const scalar a = half_extents.x, b = half_extents.y, c = half_extents.z;
    if (!(density > 0 && a > 0 && b > 0 && c > 0)) return solids::no_solid();
    const scalar M = density * (8 * (a * b * c));
    return solids::along_axes(M, 0, M * (b * b + c * c) / 3, M * (a * a + c * c) / 3, M * (a * a + b * b) / 3);
}

/// A cylinder about the origin, its axis along z. M = 2 pi r^2 h density with half length h, I_z = M r^2 / 2,
/// I_x = M (r^2 / 4 + h^2 / 3).
constexpr MassDistribution solid_cylinder(scalar density, scalar radius, scalar half_length) {
    if (!(density > 0 && radius > 0 && half_length > 0)) return solids::no_solid();
    const scalar r2 = radius * radius, M = density * (2 * (solids::pi * (r2 * half_length)));
    const scalar I_x = M * (3 * r2 + 4 * (half_length * half_length)) / 12;
    return solids::along_axes(M, 0, I_x, I_x, M * r2 / 2);
}

/// A cylinder with two half balls on its ends, about the origin, its axis along z; half_length is that of the straight part,
/// and may be 0. With the masses M_c of the cylinder and M_s of the ball the ends make: I_z = M_c r^2 / 2 + 2/5 M_s r^2,
/// I_x = M_c (r^2 / 4 + h^2 / 3) + M_s (2/5 r^2 + h^2 + 3/4 h r): a half ball has its centre of mass 3/8 r above its flat side.
constexpr MassDistribution solid_capsule(scalar density, scalar radius, scalar half_length) {
    if (!(density > 0 && radius > 0 && half_length >= 0)) return solids::no_solid();
    const scalar h = half_length, r2 = radius * radius, h2 = h * h, section = density * (solids::pi * r2);
    const scalar M_c = 2 * (section * h), M_s = 4 * (section * radius) / 3;
    const scalar I_x = M_c * (3 * r2 + 4 * h2) / 12 + M_s * (8 * r2 + 20 * h2 + 15 * (h * radius)) / 20;
    return solids::along_axes(M_c + M_s, 0, I_x, I_x, M_c * r2 / 2 + M_s * (2 * r2) / 5);
}

/// A cone with its base on z = 0 and its tip at z = height. M = 1/3 pi r^2 h density, centre of mass at h / 4,
/// I_z = 3/10 M r^2, I_x = 3/80 M (4 r^2 + h^2).
constexpr MassDistribution solid_cone(scalar density, scalar radius, scalar height) {
    if (!(density > 0 && radius > 0 && height > 0)) return solids::no_solid();
    const scalar r2 = radius * radius, M = density * (solids::pi * (r2 * height) / 3);
    const scalar I_x = M * (3 * (4 * r2 + height * height)) / 80;
    return solids::along_axes(M, height / 4, I_x, I_x, M * (3 * r2) / 10);
}

/// An ellipsoid about the origin. M = 4/3 pi a b c density, I_x = M (b^2 + c^2) / 5 with semi-axes a, b, c along x, y, z: a
/// ball stretched along each axis.
constexpr MassDistribution solid_ellipsoid(scalar density, const Vector& semi_axes) {
    const scalar a = semi_axes.x, b = semi_axes.y, c = semi_axes.z;
    if (!(density > 0 && a > 0 && b > 0 && c > 0)) return solids::no_solid();
    const scalar M = density * (4 * (solids::pi * (a * b * c)) / 3);
    return solids::along_axes(M, 0, M * (b * b + c * c) / 5, M * (a * a + c * c) / 5, M * (a * a + b * b) / 5);
}

/// Half a ball with its flat side on z = 0. M = 2/3 pi r^3 density, centre of mass at 3/8 r, I_z = 2/5 M r^2,
/// I_x = 83/320 M r^2: that of half the ball about the flat side, 2/5 M r^2, less M (3/8 r)^2.
constexpr MassDistribution solid_hemisphere(scalar density, scalar radius) {
    if (!(density > 0 && radius > 0)) return solids::no_solid();
    const scalar r2 = radius * radius, M = density * (2 * (solids::pi * (r2 * radius)) / 3), I_x = M * (83 * r2) / 320;
    return solids::along_axes(M, 3 * radius / 8, I_x, I_x, M * (2 * r2) / 5);
}

/// A tetrahedron with corners a, b, c, d in any order. Flat ones have no mass.
///
/// M = density |(b - a) . ((c - a) x (d - a))| / 6; the second moments are M / 20 sum e e^T with the corners e seen from the
/// centre of mass, since the products of barycentric coordinates i and j have the mean (1 + delta_ij) / 20.
constexpr MassDistribution solid_tetrahedron(scalar density, const Vector& a, const Vector& b, const Vector& c,
                                             const Vector& d) {
    if (!(density > 0)) return solids::no_solid();
    const Vector ab = b - a, ac = c - a, ad = d - a;
    const Vector a_to_CM = (ab + ac + ad) * scalar(0.25);
    const Vector e_b = ab - a_to_CM, e_c = ac - a_to_CM, e_d = ad - a_to_CM;
    const SymmetricMatrix sum = solids::outer(a_to_CM) + solids::outer(e_b) + solids::outer(e_c) + solids::outer(e_d);
    const scalar M = density * abs(dot(ab, cross(ac, ad))) / 6;
    return {M, a + a_to_CM, solids::inertia_from(sum * (M / 20))};
}

// Solids of parts. The laws hold for holes too, which are parts of negative mass.

/// The same solid with the mass M, kg: the density is scaled, shape and centre of mass stay.
constexpr MassDistribution with_mass(const MassDistribution& solid, scalar M) {
    if (!(solid.M > 0)) return solids::no_solid();
    return {M, solid.r_CM, solid.I * (M / solid.M)};
}

/// A part seen from the frame of the compound: a point p of the part's frame lies at A p + r.
///
/// Needs:   A orthonormal to rounding (axis_angle, reorthogonalized): the tensor is off by as much as A^T A is off 1. Beyond
///          limits::orthogonality, or with det A < 0, there is no solid.
/// Source:  Hecker 1997, Eq. 2.
constexpr MassDistribution placed(const MassDistribution& part, const Matrix& A, const Vector& r) {
    if (!(orthogonality_error(A) <= limits::orthogonality && determinant(A) > 0)) return solids::no_solid();
    return {part.M, A * part.r_CM + r, rotated(A, part.I)};
}

/// Two parts as one body, in their common frame.
///
/// Both are moved to the common centre of mass at once: M_a r_a^2 + M_b r_b^2 = M_a M_b / M |r_b - r_a|^2. So parts far from
/// the origin lose nothing. A distribution of zeros is an empty part: what is combined with it stays, and no mass at all ends as
/// bad_mass.
constexpr MassDistribution combined(const MassDistribution& a, const MassDistribution& b) {
    const scalar M = a.M + b.M, share = M == 0 ? scalar(0) : b.M / M;
    const Vector a_to_b = b.r_CM - a.r_CM;
    return {M, a.r_CM + a_to_b * share, a.I + b.I + solids::parallel_axis(a.M * share, a_to_b)};
}

/// A solid less a hole that was counted in it, in their common frame. The tensor keeps the digits that the difference leaves.
constexpr MassDistribution without(const MassDistribution& solid, const MassDistribution& hole) {
    return combined(solid, {-hole.M, hole.r_CM, hole.I * scalar(-1)});
}

/// The tensor about any point of the user's frame, along the user's axes: I + M (d^2 1 - d d^T). Units: kg m^2.
constexpr SymmetricMatrix inertia_about(const MassDistribution& solid, const Vector& point) {
    return solid.I + solids::parallel_axis(solid.M, solid.r_CM - point);
}

// Meshes.

namespace solids {

/// A pyramid from the point of reference to one triangle, corners seen from that point.
struct Pyramid {
    Vector a, b, c;
    scalar six_V;       ///< six times its volume; negative where the triangle shows its back
    scalar six_V_size;  ///< what the roundings of six_V are relative to
};

constexpr scalar size_of(const Vector& v) { return abs(v.x) + abs(v.y) + abs(v.z); }

/// The point of reference is origin + offset; the two are apart so that a mesh far away keeps the digits of its size.
///
/// The area is the product of the two shorter edges: with the longest, needle-shaped triangles lose the digits of their width.
constexpr Pyramid pyramid_over(const MeshTriangle& t, const Vector* vertices, const Vector& offset) {
    const Vector &A = vertices[t.a], &B = vertices[t.b], &C = vertices[t.c], &origin = vertices[0];
    const Vector AB = B - A, BC = C - B, CA = A - C;
    const scalar AB2 = length_sq(AB), BC2 = length_sq(BC), CA2 = length_sq(CA);
    const bool AB_longest = AB2 >= BC2 && AB2 >= CA2, BC_longest = !AB_longest && BC2 >= CA2;
    const Vector e = AB_longest ? BC : BC_longest ? CA : AB, f = AB_longest ? CA : BC_longest ? AB : BC;
    const Vector a = (A - origin) - offset, b = (B - origin) - offset, c = (C - origin) - offset;
    return {a, b, c, dot(a, cross(e, f)), size_of(a) * size_of(e) * size_of(f)};
}

/// A number for each edge a -> b, and its negative, modulo 2^64, for b -> a.
/// Source: the finaliser of Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014.
constexpr uint64_t signed_edge_hash(int a, int b) {
    uint64_t x = static_cast<uint64_t>(a < b ? a : b) << 32 | static_cast<uint64_t>(a < b ? b : a);
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    x ^= x >> 31;
    return a < b ? x : a > b ? 0 - x : 0;
}

/// True where every directed edge has its opposite: the hashes of all edges then cancel to zero. A mesh that is not closed
/// passes with a chance of 2^-64.
/// Cost: one pass, no memory, about 20 integer operations an edge.
constexpr bool is_closed(const MeshTriangle* triangles, int triangle_count) {
    uint64_t sum = 0;
    for (int i = 0; i < triangle_count; ++i) {  // bound: the argument of the caller, who owns the mesh; not in the step
        const MeshTriangle& t = triangles[i];
        sum += signed_edge_hash(t.a, t.b) + signed_edge_hash(t.b, t.c) + signed_edge_hash(t.c, t.a);
    }
    return sum == 0;
}

constexpr Status check_mesh(const Vector* vertices, int vertex_count, const MeshTriangle* triangles, int triangle_count) {
    if (vertices == nullptr || triangles == nullptr || vertex_count < 4 || triangle_count < 4) return Status::bad_shape;
    for (int i = 0; i < vertex_count; ++i) {  // bound: the argument of the caller, who owns the mesh; not in the step
        const Vector& v = vertices[i];
        if (!is_finite(v)) return Status::not_finite;
        if (!(abs(v.x) <= limits::position_max && abs(v.y) <= limits::position_max && abs(v.z) <= limits::position_max))
            return Status::out_of_range;
    }
    for (int i = 0; i < triangle_count; ++i) {
        const int indices[3] = {triangles[i].a, triangles[i].b, triangles[i].c};
        for (int index : indices)
            if (index < 0 || index >= vertex_count) return Status::out_of_range;
    }
    return is_closed(triangles, triangle_count) ? Status::ok : Status::bad_shape;
}

}  // namespace solids

/// The solid inside a closed mesh of triangles, which share their vertices by index. Several shells are one solid; a shell
/// inside another, turned inside out, is a cavity.
///
/// The solid is the sum of the pyramids from a point to all triangles: first from a vertex, which gives the centre of mass,
/// then from there, so that neither a place far from the origin nor a lopsided shape costs digits.
/// Errors:  not_finite (density or a vertex), bad_mass (density not positive), out_of_range (a vertex beyond
///          limits::position_max, an index that names no vertex, a tensor too large to hold), bad_shape (fewer than 4 vertices
///          or triangles, null pointers, an edge without its opposite, inside out, a volume of zero to rounding).
/// Error:   epsilon times length over thickness, of the largest entry; the sums add half an epsilon a triangle at worst, and
///          that times the square root of their number as a rule.
/// Cost:    three passes, about 300 flops and 60 integer operations a triangle, one division; no memory.
/// Source:  Blow and Binstock, "How to find the inertia tensor (or other mass properties) of a 3D solid body represented by a
///          triangle mesh", 2004: a pyramid has the second moments V / 20 (a a^T + b b^T + c c^T + s s^T), s = a + b + c.
constexpr Result<MassDistribution> solid_mesh(scalar density, const Vector* vertices, int vertex_count,
                                              const MeshTriangle* triangles, int triangle_count) {
    if (!is_finite(density)) return {Status::not_finite, {}};
    if (!(density > 0)) return {Status::bad_mass, {}};
    const Status status = solids::check_mesh(vertices, vertex_count, triangles, triangle_count);
    if (status != Status::ok) return {status, {}};

    scalar six_V = 0, six_V_size = 0;
    Vector moment{};
    for (int i = 0; i < triangle_count; ++i) {
        const solids::Pyramid p = solids::pyramid_over(triangles[i], vertices, {});
        six_V += p.six_V;
        six_V_size += p.six_V_size;
        moment += (p.a + p.b + p.c) * p.six_V;
    }
    // A dot product of three factors that are differences and products themselves rounds by at most 8 halves of epsilon.
    if (!(six_V > 4 * epsilon * six_V_size)) return {is_finite(six_V_size) ? Status::bad_shape : Status::out_of_range, {}};
    const Vector offset = moment * (1 / (4 * six_V));  // the centre of a pyramid is the mean of its four corners

    six_V = 0;
    SymmetricMatrix sum{};
    for (int i = 0; i < triangle_count; ++i) {
        const solids::Pyramid p = solids::pyramid_over(triangles[i], vertices, offset);
        six_V += p.six_V;
        sum = sum + (solids::outer(p.a) + solids::outer(p.b) + solids::outer(p.c) + solids::outer(p.a + p.b + p.c)) * p.six_V;
    }
    const MassDistribution solid = {density * six_V / 6, vertices[0] + offset, solids::inertia_from(sum * (density / 120))};
    if (!is_finite(solid.M) || !is_finite(solid.I)) return {Status::out_of_range, {}};
    return {Status::ok, solid};
}

// The way into a world.

namespace solids {

/// What World::add asks of mass and moments: see check_mass_properties (body/check_body.h).
constexpr Status check_moments(scalar M, const Vector& I) {
    if (!is_finite(M) || !is_finite(I)) return Status::not_finite;
    if (!(M >= limits::mass_min && M <= limits::mass_max)) return Status::bad_mass;
    const scalar others[2] = {I.y, I.z};
    scalar smallest = I.x, largest = I.x;
    for (scalar moment : others) {
        smallest = moment < smallest ? moment : smallest;
        largest = moment > largest ? moment : largest;
    }
    const bool in_range = smallest >= limits::inertia_min && largest <= limits::inertia_max;
    if (!in_range || !(largest <= limits::inertia_ratio_max * smallest)) return Status::bad_inertia;
    // Of the three it is the largest moment that may pass the sum of the others.
    const scalar trace = I.x + I.y + I.z, excess = largest - (trace - largest);
    return excess > limits::triangle_inequality * trace ? Status::bad_inertia : Status::ok;
}

}  // namespace solids

/// What a body needs to know of its mass, from a solid or from any tensor about the centre of mass:
/// principal({M, r_CM, {Ixx, Iyy, Izz, Ixy, Ixz, Iyz}}), the products with the sign they have in the tensor.
///
/// The axes keep the names that are nearest: see principal_axes. A solid that lies along its user's axes keeps them, and its
/// moments, bit for bit. body/user_frame.h goes from the user's frame to the body's and back.
/// Errors:  not_finite, bad_mass, bad_inertia (as World::add has them: zero or negative, I1 + I2 < I3, beyond base/limits.h),
///          not_converged.
/// Cost:    that of principal_axes; none at run time where the solid is a constant.
constexpr Result<MassProperties> principal(const MassDistribution& solid) {
    if (!is_finite(solid.M) || !is_finite(solid.r_CM) || !is_finite(solid.I)) return {Status::not_finite, {}};
    if (!(solid.M >= limits::mass_min && solid.M <= limits::mass_max)) return {Status::bad_mass, {}};
    const Result<PrincipalAxes> axes = principal_axes(solid.I);
    if (!axes.ok()) return {axes.status, {}};
    const Status status = solids::check_moments(solid.M, axes.value.moments);
    if (status != Status::ok) return {status, {}};
    return {Status::ok, {solid.M, axes.value.moments, solid.r_CM, axes.value.A}};
}

} }  // namespace ingot
