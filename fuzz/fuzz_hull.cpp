// SPDX-License-Identifier: MIT
// Hulls and meshes from any points: duplicates, points in a plane, on a line, on a spot, raw bits.
//
//   A hull is refused for the reason there is, or it is one: closed (Euler), each edge between the two faces that name it, every point below every
//   face but for what limits::hull_flatness allows, and no corner that was not given.
//   Points on a lattice of whole numbers are decided exactly, apart from the kernel: flat ones are refused, and others are not.
//   The volume is that of the pyramids over its faces, and its mass is one that World::add takes, or refused.
//   A mesh of any indices is refused or gives finite numbers.
//
// INGOT_FUZZ_RUN names the function; fuzz_fault breaks a promise on purpose (CMakeLists.txt).
#include "bytes.h"
#include "fuzz_world.h"

#include <ingot/shape/hull_of_points.h>

namespace {

using namespace fuzz;
using Exact = long double;

struct Point {
    Exact x, y, z;
};
Point exact(const Vector& v) { return {static_cast<Exact>(v.x), static_cast<Exact>(v.y), static_cast<Exact>(v.z)}; }
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Exact dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point cross(const Point& a, const Point& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

/// Points as they come: whole numbers, copies, points between two others, numbers of all sorts, raw bits.
struct Points {
    Vector at[40];
    bool whole = true;  ///< all on the lattice

    void read(Bytes& in, int count) {
        const uint8_t sort = in.byte();
        for (int i = 0; i < count; ++i) at[i] = read_one(in, i, sort);
    }

private:
    Vector read_one(Bytes& in, int i, uint8_t sort) {
        const uint8_t kind = in.byte();
        const auto lattice = [&] { return static_cast<scalar>(static_cast<int>(in.byte() % 17u) - 8); };
        const int other = i > 0 ? kind % i : 0;
        if (i > 0 && kind >= 232) return at[other];
        if (sort < 128) {
            const scalar x = lattice(), y = lattice(), z = kind < 8 ? scalar(0) : lattice();
            return {x, y, z};
        }
        whole = false;
        if (i > 1 && kind >= 200) return (at[other] + at[i - 1]) * scalar(0.5);
        if (sort < 224) {
            const scalar x = in.number(4), y = in.number(4), z = in.number(4);
            return {x, y, z};
        }
        const scalar x = in.raw<scalar>(), y = in.raw<scalar>(), z = in.raw<scalar>();
        return {x, y, z};
    }
};

/// Exactly, for whole numbers.
bool all_in_one_plane(const Vector* points, int count) {
    for (int a = 1; a < count; ++a)
        for (int b = a + 1; b < count; ++b) {
            const Point o = exact(points[0]), n = cross(exact(points[a]) - o, exact(points[b]) - o);
            if (dot(n, n) == 0) continue;
            for (int c = 1; c < count; ++c)
                if (dot(n, exact(points[c]) - o) != 0) return false;
            return true;
        }
    return true;
}

bool has_edge(const ingot::ConvexHull& hull, int face_i, int a, int b) {
    const ingot::HullFace& face = hull.faces[face_i];
    for (int k = 0; k < face.loop_count; ++k)
        if (hull.loops[face.loop_first + k] == a && hull.loops[face.loop_first + (k + 1) % face.loop_count] == b) return true;
    return false;
}

template <unsigned room>
void demand_hull(const ingot::HullOf<room>& made, const Vector* points) {
    constexpr int count = static_cast<int>(room);
    ingot::ConvexHull hull = made.view();
    if (fuzz_fault == 1) --hull.edge_count;
    demand(hull.vertex_count >= 4 && hull.vertex_count <= count && hull.face_count >= 4, "a hull is a solid");
    demand(hull.vertex_count - hull.edge_count + hull.face_count == 2, "a hull is closed: Euler");

    Exact size = 0;
    for (int i = 0; i < count; ++i) {
        const Point d = exact(points[i]) - exact(points[0]);
        size = dot(d, d) > size ? dot(d, d) : size;
    }
    size = __builtin_sqrtl(size);
    Exact far = 0;
    for (int i = 0; i < hull.vertex_count; ++i) {
        bool given = false;
        for (int k = 0; k < count; ++k)
            given = given || (hull.vertices[i].x == points[k].x && hull.vertices[i].y == points[k].y && hull.vertices[i].z == points[k].z);
        demand(given, "corners of a hull are points that were given");
        const Point v = exact(hull.vertices[i]);
        far = dot(v, v) > far ? dot(v, v) : far;
    }
    far = __builtin_sqrtl(far);
    demand(static_cast<Exact>(hull.radius) >= far && static_cast<Exact>(hull.radius) <= far * (1 + 16 * static_cast<Exact>(ingot::epsilon)),
           "a ball holds the hull, and no larger one is named");

    int loops = 0;
    for (int face_i = 0; face_i < hull.face_count; ++face_i) {
        const ingot::HullFace& face = hull.faces[face_i];
        demand(face.loop_first == loops && face.loop_count >= 3, "loops follow each other");
        loops += face.loop_count;
        demand(magnitude(ingot::length_sq(face.n) - 1) <= 16 * ingot::epsilon, "the normal of a face is of unit length");
        for (int k = 0; k < face.loop_count; ++k) demand(hull.loops[face.loop_first + k] < hull.vertex_count, "loops name corners");
        // n is rounded, and so is the offset: of points as far as `far` from the origin.
        const Exact slack = 5 * static_cast<Exact>(limits::hull_flatness) * size + 4 * static_cast<Exact>(ingot::epsilon) * (far + size);
        for (int i = 0; i < count; ++i)
            demand(dot(exact(face.n), exact(points[i])) - static_cast<Exact>(face.offset) <= slack + (fuzz_fault == 2 ? -size / 8 : 0),
                   "no point is above a face");
        demand(static_cast<Exact>(face.offset) - dot(exact(face.n), exact(hull.centre)) >= -slack, "the centre is inside");
    }
    demand(loops == 2 * hull.edge_count, "every edge is in two loops");
    for (int edge_i = 0; edge_i < hull.edge_count; ++edge_i) {
        const ingot::HullEdge& edge = hull.edges[edge_i];
        demand(has_edge(hull, edge.face_left, edge.a, edge.b) && has_edge(hull, edge.face_right, edge.b, edge.a),
               "an edge runs between its two faces");
    }
}

/// Volume of the pyramids from the first corner.
Exact volume_of(const ingot::ConvexHull& hull) {
    Exact six_volumes = 0;
    const Point o = exact(hull.vertices[0]);
    for (int face_i = 0; face_i < hull.face_count; ++face_i) {
        const uint8_t* loop = hull.loops + hull.faces[face_i].loop_first;
        for (int k = 1; k + 1 < hull.faces[face_i].loop_count; ++k)
            six_volumes += dot(exact(hull.vertices[loop[0]]) - o, cross(exact(hull.vertices[loop[k]]) - o, exact(hull.vertices[loop[k + 1]]) - o));
    }
    return six_volumes / 6;
}

template <unsigned room>
uint64_t make_hull(Bytes& in) {
    Points points;
    points.read(in, static_cast<int>(room));
    Vector given[room];
    bool finite = true;
    for (unsigned i = 0; i < room; ++i) {
        given[i] = points.at[i];
        finite = finite && ingot::is_finite(given[i]);
    }
    const Result<ingot::HullOf<room>> made = ingot::convex_hull(given);
    demand(finite == (made.status != Status::not_finite), "points that are not finite are refused, and called so");
    if (room > limits::hull_vertices_max) demand(!finite || made.status == Status::no_room, "more points than there is room for are refused");
    if (room < 4) demand(!made.ok(), "three points are no solid");
    if (room >= 4 && room <= limits::hull_vertices_max && points.whole) {
        // Not flat, a lattice point is at least 1 / |n| from a plane of others, |n| <= 2 28^2 / 2: 50 times the flatness of the largest.
        const bool flat = all_in_one_plane(given, static_cast<int>(room));
        demand(made.status == (flat ? Status::bad_shape : Status::ok), "points of a lattice make a hull unless they are flat");
    }
    if (!made.ok()) return static_cast<uint64_t>(made.status);
    if constexpr (room >= 4 && room <= limits::hull_vertices_max) {
        demand_hull(made.value, given);
        const ingot::ConvexHull hull = made.value.view();
        const Result<ingot::MassDistribution> solid = ingot::solid_hull(1000, hull);
        if (points.whole) {
            demand(solid.ok(), "a hull of a lattice has a mass");
            const Exact M = 1000 * volume_of(hull), error = static_cast<Exact>(solid.value.M) - M;
            demand(M > 0 && (error < 0 ? -error : error) <= 64 * static_cast<Exact>(ingot::epsilon) * 1000 * 17 * 17 * 17,
                   "the mass is that of the volume");
        }
        if (solid.ok()) {
            const Result<ingot::MassProperties> mass = ingot::principal(solid.value);
            demand(!mass.ok() || ingot::check_mass_properties(mass.value) == Status::ok, "principal gives what add takes");
        }
    }
    return static_cast<uint64_t>(made.value.face_count);
}

/// Any triangles over any points.
uint64_t make_mesh(Bytes& in) {
    constexpr int room = 12;
    Points points;
    points.read(in, room);
    ingot::MeshTriangle triangles[20];
    const int triangle_count = in.byte() % 21, vertex_count = in.byte() % (room + 1);
    for (int i = 0; i < triangle_count; ++i) {
        const auto index = [&] {
            const uint8_t which = in.byte();
            return which < 248 ? which % room : in.raw<int32_t>();
        };
        const int a = index(), b = index(), c = index();
        triangles[i] = {a, b, c};
    }
    const Result<ingot::MassDistribution> solid = ingot::solid_mesh(in.number(1000), points.at, vertex_count, triangles, triangle_count);
    if (!solid.ok()) return static_cast<uint64_t>(solid.status);
    demand(ingot::is_finite(solid.value.M) && ingot::is_finite(solid.value.r_CM) && ingot::is_finite(solid.value.I),
           "a mesh that is taken gives finite numbers");
    for (int i = 0; i < triangle_count; ++i) {
        const ingot::MeshTriangle& t = triangles[i];
        demand(t.a >= 0 && t.a < vertex_count && t.b >= 0 && t.b < vertex_count && t.c >= 0 && t.c < vertex_count,
               "triangles name corners there are");
    }
    return 1;
}

}  // namespace

uint64_t INGOT_FUZZ_RUN(const uint8_t* data, size_t size) {
    Bytes in(data, size);
    switch (in.byte() % 12u) {
        case 0: return make_hull<1>(in);
        case 1: case 2: return make_hull<4>(in);
        case 3: return make_hull<5>(in);
        case 4: return make_hull<6>(in);
        case 5: case 6: return make_hull<8>(in);
        case 7: return make_hull<12>(in);
        case 8: return make_hull<20>(in);
        case 9: return make_hull<32>(in);
        case 10: return in.byte() % 8u == 0 ? make_hull<33>(in) : make_hull<9>(in);
        default: return make_mesh(in);
    }
}
