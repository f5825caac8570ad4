// SPDX-License-Identifier: MIT
// The convex hull of a few points, as a constant.
//
//     constexpr auto rock = ingot::convex_hull<6>({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
//     static_assert(rock.ok());
//     static constexpr ingot::ConvexHull shape = rock.value.view();        // rock must have static storage
//     constexpr auto mass = ingot::principal(ingot::solid_hull(2600, rock.value.view()).value);
//
// A body's hull is seen from its centre of mass, along its principal axes; convex_hull_of_body brings points of any frame there:
//
//     constexpr auto body = ingot::convex_hull_of_body<6>({...}, mass.value);
//     struct Rocks : ingot::Scene { ... static constexpr ingot::ConvexHull hulls[] = {body.value.view()}; };
//     def.shape = ingot::hull_of<Rocks>(0);
#pragma once

#include "../base/limits.h"
#include "../base/status.h"
#include "../body/mass_properties.h"
#include "convex_hull.h"

namespace ingot { inline namespace INGOT_ABI {

/// The arrays of a hull of up to N points. Faces of any number of corners; points inside, or on an edge, are left out.
template <unsigned N>
struct HullOf {
    static constexpr unsigned room = N < 4 ? 4 : N;  ///< for so many points
    Vector vertices[room];  ///< see ConvexHull
    HullFace faces[2 * room - 4];  ///< see ConvexHull
    HullEdge edges[3 * room - 6];  ///< see ConvexHull
    uint8_t loops[6 * room - 12];  ///< see ConvexHull
    uint8_t vertex_count, face_count, edge_count;  ///< see ConvexHull
    Vector centre;  ///< m, see ConvexHull
    scalar radius, inner_radius;  ///< m, see ConvexHull

    /// What Scene::hulls, PlacedShape and solid_hull take: it points here.
    constexpr ConvexHull view() const {
        return {vertices, faces, edges, loops, vertex_count, face_count, edge_count, centre, radius, inner_radius};
    }
};

namespace hulls {

// Planes are found in double whatever the scalar, so that the roundings of the points are the only ones that count.
using Point = Vec3<double>;

constexpr double magnitude(double x) { return x < 0 ? -x : x; }

/// Heron's rule on a number between 1 and 3: five steps from (1 + x) / 2 leave no error above a rounding.
constexpr double length(const Point& v) {
    const double x = magnitude(v.x), y = magnitude(v.y), z = magnitude(v.z);
    const double most = x > y ? (x > z ? x : z) : (y > z ? y : z);
    if (!(most > 0)) return 0;
    const Point u = v * (1 / most);
    const double sum = dot(u, u);
    double root = (1 + sum) / 2;
    for (int step_i = 0; step_i < 5; ++step_i) root = (root + sum / root) / 2;
    return root * most;
}

/// Gift wrapping with faces of any number of corners.
template <unsigned room>
struct Wrapping {
    static constexpr int N = static_cast<int>(room);
    Point points[room];
    double tolerance;  // m

    uint8_t loops[6 * room], loop_first[2 * room + 1];
    int face_count;

    /// All corners of the face with the outward unit normal n through points[start], counter-clockwise, behind the faces that
    /// there are. 0: there is no room, or it is no polygon.
    constexpr int add_loop(const Point& n, int start) {
        const int first = face_count == 0 ? 0 : loop_first[face_count];
        int corners = 0, at = start;
        // bound: limits::hull_vertices_max: refused at corners >= N
        do {
            if (first + corners >= 6 * N || corners >= N) return 0;
            loops[first + corners++] = static_cast<uint8_t>(at);
            int next = -1;
            Point to{};
            double to_length = 0;
            // bound: limits::hull_vertices_max
            for (int q = 0; q < N; ++q) {
                const Point d = points[q] - points[at];
                const double distance = length(d);
                if (!(distance > tolerance) || magnitude(dot(n, points[q] - points[start])) > tolerance) continue;
                const double side = next < 0 ? -1 : dot(n, cross(to, d));  // of `to`: left where positive
                const double level = tolerance * to_length;
                if (next < 0 || side < -level || (side <= level && dot(to, d) > 0 && distance > to_length)) {
                    next = q;
                    to = d;
                    to_length = distance;
                }
            }
            if (next < 0) return 0;
            at = next;
        } while (at != start);
        return corners;
    }

    /// The outward unit normal of the face that has the edge from a to b; zero where all points lie on its line.
    constexpr Point normal_over(int a, int b) const {
        const Point e = points[b] - points[a];
        const double e_length = length(e);
        Point n{};
        double away = 0;  // of the point that made n, from the line of the edge
        for (int pass = 0; pass < 2; ++pass) {
            for (int q = 0; q < N; ++q) {
                const Point d = points[q] - points[a], m = cross(e, d);
                const double m_length = length(m), distance = m_length / e_length;
                if (!(distance > tolerance)) continue;
                const double height = dot(n, d);
                if (away > 0 && !(height > 0 && (height > tolerance || distance > away))) continue;
                n = m * (1 / m_length);
                away = distance;
            }
        }
        return n;
    }

    /// The face with the edge from a to b, or -1.
    constexpr int face_with(int a, int b) const {
        // bound: 2 limits::hull_vertices_max - 4
        for (int face_i = 0; face_i < face_count; ++face_i) {
            const int first = loop_first[face_i], end = loop_first[face_i + 1];
            // bound: 6 limits::hull_vertices_max: part of the loops of a hull
            for (int k = first; k < end; ++k)
                if (loops[k] == a && loops[k + 1 < end ? k + 1 : first] == b) return face_i;
        }
        return -1;
    }

    constexpr bool add_face(const Point& n, int start) {
        if (face_count >= 2 * N - 4) return false;
        if (face_count == 0) loop_first[0] = 0;
        const int corners = add_loop(n, start);
        if (corners < 3) return false;
        loop_first[face_count + 1] = static_cast<uint8_t>(loop_first[face_count] + corners);
        ++face_count;
        return true;
    }

    /// A plane through the lowest point that touches the hull there, turned about the y axis until it touches more: a face,
    /// or an edge of two faces.
    constexpr bool add_first_face() {
        int lowest = 0;
        for (int q = 1; q < N; ++q) {
            const Point &p = points[q], &l = points[lowest];
            if (p.x < l.x || (p.x == l.x && (p.z < l.z || (p.z == l.z && p.y < l.y)))) lowest = q;
        }
        Point n{-1, 0, 0};
        double away = 0;
        for (int q = 0; q < N; ++q) {
            const Point d = points[q] - points[lowest], across{d.x, 0, d.z};
            const double distance = length(across);
            if (!(distance > tolerance)) continue;
            const double height = dot(n, d);
            if (away > 0 && !(height > 0 && (height > tolerance || distance > away))) continue;
            n = Point{-across.z, 0, across.x} * (1 / distance);
            away = distance;
        }
        if (!(away > 0)) return false;
        if (add_face(n, lowest)) return true;
        // An edge: its other end is the point of the plane that is furthest.
        int end = -1;
        double furthest = tolerance;
        for (int q = 0; q < N; ++q) {
            const Point d = points[q] - points[lowest];
            if (magnitude(dot(n, d)) > tolerance || !(length(d) > furthest)) continue;
            end = q;
            furthest = length(d);
        }
        if (end < 0) return false;
        const Point m = normal_over(lowest, end);
        return length(m) > 0 && add_face(m, lowest);
    }

    /// Every edge gets its second face.
    constexpr bool close() {
        for (int face_i = 0; face_i < face_count; ++face_i) {
            const int first = loop_first[face_i], end = loop_first[face_i + 1];
            for (int k = first; k < end; ++k) {
                const int a = loops[k], b = loops[k + 1 < end ? k + 1 : first];
                if (face_with(b, a) >= 0) continue;
                const Point n = normal_over(b, a);
                if (!(length(n) > 0) || !add_face(n, b) || face_with(b, a) < 0) return false;
            }
        }
        return face_count >= 4;
    }
};

/// Sets the points and the tolerance, and checks their place and size.
template <unsigned room>
constexpr Status take_points(const Vector (&points)[room], Wrapping<room>& wrapping) {
    double size = 0;
    // bound: limits::hull_vertices_max
    for (int i = 0; i < wrapping.N; ++i) {
        const Vector& p = points[i];
        if (!(abs(p.x) <= limits::position_max && abs(p.y) <= limits::position_max && abs(p.z) <= limits::position_max))
            return Status::out_of_range;
        wrapping.points[i] = {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
        const double away = length(wrapping.points[i] - wrapping.points[0]);
        size = away > size ? away : size;
    }
    if (!(size >= static_cast<double>(limits::size_min) && size <= 4 * static_cast<double>(limits::size_max)))
        return size > 1 ? Status::out_of_range : Status::bad_shape;
    wrapping.tolerance = static_cast<double>(limits::hull_flatness) * size;
    return Status::ok;
}

/// The corners in use, in the order of the points; renamed: their new numbers. Returns their middle.
template <unsigned room>
constexpr Point name_corners(const Vector (&points)[room], const Wrapping<room>& wrapping, uint8_t (&renamed)[room], HullOf<room>& hull) {
    const int loops_end = wrapping.loop_first[wrapping.face_count];
    Point sum{};
    // bound: limits::hull_vertices_max
    for (int i = 0; i < wrapping.N; ++i) {
        bool used = false;
        // bound: 6 limits::hull_vertices_max
        for (int k = 0; k < loops_end; ++k) used = used || wrapping.loops[k] == i;
        if (!used) continue;
        renamed[i] = hull.vertex_count;
        hull.vertices[hull.vertex_count++] = points[i];
        sum = sum + (wrapping.points[i] - wrapping.points[0]);
        const double radius = length(wrapping.points[i]) * (1 + 4 * static_cast<double>(epsilon));  // its roundings
        hull.radius = static_cast<double>(hull.radius) < radius ? static_cast<scalar>(radius) : hull.radius;
    }
    return wrapping.points[0] + sum * (1.0 / hull.vertex_count);
}

/// The plane and the loop of a face. False where it has no area, or points lie above it.
template <unsigned room>
constexpr bool describe_face(const Wrapping<room>& wrapping, int face_i, const uint8_t (&renamed)[room], const Point& centre, HullOf<room>& hull) {
    const int first = wrapping.loop_first[face_i], end = wrapping.loop_first[face_i + 1];
    // The vector area: for a polygon that is flat but for rounding the best normal (Newell).
    Point area{};
    const Point& origin = wrapping.points[wrapping.loops[first]];
    // bound: limits::hull_vertices_max: ++k
    for (int k = first + 1; k + 1 < end; ++k)
        area = area + cross(wrapping.points[wrapping.loops[k]] - origin, wrapping.points[wrapping.loops[k + 1]] - origin);
    const double area_length = length(area);
    if (!(area_length > 0)) return false;
    const Point n = area * (1 / area_length);
    double offset = dot(n, origin);
    for (int k = first; k < end; ++k) {
        const double along = dot(n, wrapping.points[wrapping.loops[k]]);
        offset = along > offset ? along : offset;
        hull.loops[k] = renamed[wrapping.loops[k]];
    }
    for (int i = 0; i < wrapping.N; ++i)
        if (dot(n, wrapping.points[i]) - offset > 4 * wrapping.tolerance) return false;
    const auto depth = static_cast<scalar>(offset - dot(n, centre));
    hull.inner_radius = face_i == 0 || depth < hull.inner_radius ? depth : hull.inner_radius;
    hull.faces[face_i] = {{static_cast<scalar>(n.x), static_cast<scalar>(n.y), static_cast<scalar>(n.z)},
                          static_cast<scalar>(offset),
                          static_cast<uint8_t>(first),
                          static_cast<uint8_t>(end - first)};
    return true;
}

/// The edges around a face that the faces before it have not named. False where one of them has not two faces.
template <unsigned room>
constexpr bool name_edges(const Wrapping<room>& wrapping, int face_i, const uint8_t (&renamed)[room], HullOf<room>& hull) {
    constexpr int N = Wrapping<room>::N;
    const int first = wrapping.loop_first[face_i], end = wrapping.loop_first[face_i + 1];
    for (int k = first; k < end; ++k) {
        const int a = wrapping.loops[k], b = wrapping.loops[k + 1 < end ? k + 1 : first];
        const int right = wrapping.face_with(b, a);
        if (right < 0 || wrapping.face_with(a, b) != face_i) return false;  // open, or three faces at an edge
        if (a > b) continue;
        if (hull.edge_count >= 3 * N - 6) return false;
        hull.edges[hull.edge_count++] = {renamed[a], renamed[b], static_cast<uint8_t>(face_i), static_cast<uint8_t>(right)};
    }
    return true;
}

}  // namespace hulls

/// The convex hull of N points. Points closer to a face, an edge or each other than limits::hull_flatness of the size are part
/// of it.
///
/// Units:   m, in the user's frame.
/// Errors:  not_finite, no_room (more than limits::hull_vertices_max points), bad_shape (fewer than 4 points, or all on one
///          plane, line or spot to limits::hull_flatness; or so that its faces cannot be told apart), out_of_range (a size
///          beyond limits::size_min .. size_max or a point beyond limits::position_max).
/// Cost:    none at run time where the points are constants; about N^2 30 products of vectors.
/// Source:  Chand and Kapur, "An algorithm for convex polytopes", 1970 (gift wrapping).
template <unsigned room>
constexpr Result<HullOf<room>> convex_hull(const Vector (&points)[room]) {
    constexpr int N = static_cast<int>(room);
    Result<HullOf<room>> result{};
    for (const Vector& p : points)
        if (!is_finite(p)) return {Status::not_finite, {}};
    if (N > limits::hull_vertices_max) return {Status::no_room, {}};
    if (N < 4) return {Status::bad_shape, {}};

    if constexpr (N >= 4 && N <= limits::hull_vertices_max) {
        hulls::Wrapping<room> wrapping{};
        const Status taken = hulls::take_points(points, wrapping);
        if (taken != Status::ok) return {taken, {}};
        if (!wrapping.add_first_face() || !wrapping.close()) return {Status::bad_shape, {}};

        HullOf<room>& hull = result.value;
        uint8_t renamed[room] = {};
        const hulls::Point centre = hulls::name_corners(points, wrapping, renamed, hull);
        hull.centre = {static_cast<scalar>(centre.x), static_cast<scalar>(centre.y), static_cast<scalar>(centre.z)};
        // bound: 2 limits::hull_vertices_max - 4
        for (int face_i = 0; face_i < wrapping.face_count; ++face_i)
            if (!hulls::describe_face(wrapping, face_i, renamed, centre, hull) || !hulls::name_edges(wrapping, face_i, renamed, hull))
                return {Status::bad_shape, {}};
        hull.face_count = static_cast<uint8_t>(wrapping.face_count);
        if (hull.vertex_count - hull.edge_count + hull.face_count != 2) return {Status::bad_shape, {}};
    }
    return result;
}

/// The same hull in the frame of the body that has this mass, origin at the centre of mass and axes along the principal ones: what
/// Scene::hulls holds. Errors: as convex_hull.
template <unsigned room>
constexpr Result<HullOf<room>> convex_hull_of_body(const Vector (&points)[room], const MassProperties& mass) {
    Vector in_body[room] = {};
    // bound: limits::hull_vertices_max: the array of the caller
    for (unsigned i = 0; i < room; ++i) in_body[i] = transpose_times(mass.A_principal, points[i] - mass.r_CM);
    return convex_hull(in_body);
}

/// Mass, centre of mass and inertia of a hull, in the frame of its points. Errors: as solid_mesh.
constexpr Result<MassDistribution> solid_hull(scalar density, const ConvexHull& hull) {
    MeshTriangle triangles[2 * limits::hull_vertices_max - 4] = {};
    int count = 0;
    // bound: 2 limits::hull_vertices_max - 4
    for (int face_i = 0; face_i < hull.face_count; ++face_i) {
        const HullFace& face = hull.faces[face_i];
        const uint8_t* loop = hull.loops + face.loop_first;
        // bound: limits::hull_vertices_max: ++k
        for (int k = 1; k + 1 < face.loop_count && count < 2 * limits::hull_vertices_max - 4; ++k)
            triangles[count++] = {loop[0], loop[k], loop[k + 1]};
    }
    return solid_mesh(density, hull.vertices, hull.vertex_count, triangles, count);
}

} }  // namespace ingot
