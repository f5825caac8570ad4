// SPDX-License-Identifier: MIT
// Ridges of every angle, from nearly flat to blades: what lies across one touches it where the two cross, whichever way it leans.
#include <gtest/gtest.h>

#include <algorithm>

#include "ground.h"
#include "reference/draws.h"

namespace {

using namespace level_test;

Vector unit(const Vector& v) { return v * (1 / ingot::sqrt(length_sq(v))); }
scalar of(Random& random, double low, double high) { return static_cast<scalar>(within(random, low, high)); }

/// Two triangles that fall away on both sides of their common edge.
struct Ridge {
    Ground ground;
    Vector begin, along, e;  ///< m; of the edge, and its direction
    Vector n[2];             ///< of the triangles
    double angle;            ///< rad, between them
};

/// 0.1 to 10 m high above feet that are 2 to 4 m away.
Ridge ridge_of(Random& random) {
    Soup soup;
    const int height = static_cast<int>(about(random, 25, 2560));
    const auto point = [&random](int x, int y, int z, int off) {
        const int aside[] = {between(random, -200, 200), between(random, -200, 200)};
        return lattice_point(x + aside[0], y + aside[1], z + between(random, 0, off));
    };
    for (const int x : {500, 1600}) soup.points.push_back(point(x, 1024, height + height / 8, height / 8));
    for (const int y : {300, 1800}) soup.points.push_back(point(1024, y, 0, height / 4));
    soup.faces = {{0, 2, 1}, {0, 1, 3}};
    Ridge ridge;
    take_mesh(soup, 1.0 / 256, ridge.ground);
    const auto corner = [&soup](size_t i) {
        const auto& p = soup.points[i];
        return Vector{static_cast<scalar>(p.x), static_cast<scalar>(p.y), static_cast<scalar>(p.z)} * (scalar(1) / 256);
    };
    ridge.begin = corner(0);
    ridge.along = corner(1) - corner(0);
    ridge.e = unit(-ridge.along);
    ridge.n[0] = unit(cross(corner(2) - corner(0), ridge.along));
    ridge.n[1] = unit(cross(ridge.along, corner(3) - corner(0)));
    ridge.angle = std::atan2(static_cast<double>(dot(cross(ridge.n[0], ridge.n[1]), ridge.e)), static_cast<double>(dot(ridge.n[0], ridge.n[1])));
    return ridge;
}

/// A body whose line along u, seen from the side of -d, is lowest at Q: the side of what is round, or an edge.
BodyDef body_across(Random& random, Goer kind, const Vector& Q, const Vector& d, const Vector& u, scalar& size) {
    BodyDef def = goer(random, kind, size, 0);
    const scalar half = of(random, 0.1, 0.5), off = of(random, -0.6, 0.6);
    if (kind == Goer::roller || kind == Goer::wheel) {
        def.shape = kind == Goer::roller ? ingot::Shape(ingot::Capsule{size, half}) : ingot::Shape(ingot::Cylinder{size, half});
        def.state = {};
        def.state.A = ingot::nearest_rotation(Matrix{d, cross(u, d), u});
        def.state.r_CM = Q + d * size + u * (half * off);
        return def;
    }
    // An edge from a to b, in the body, between two sides whose normals are left and right.
    Vector a = {size, size, -half}, b = {size, size, half}, left = {1, 0, 0}, right = {0, 1, 0};
    if (kind == Goer::box) {
        def.shape = ingot::Box{{size, size, half}};
    } else {
        const ingot::ConvexHull& hull = Slab::hulls[0];
        const ingot::HullEdge& edge = hull.edges[between(random, 0, hull.edge_count - 1)];
        a = hull.vertices[edge.a], b = hull.vertices[edge.b];
        left = hull.faces[edge.face_left].n, right = hull.faces[edge.face_right].n;
        size = hull.inner_radius;
    }
    const Vector down = unit(unit(left + right) * of(random, 1, 2) + left * of(random, 0, 0.5)), v = unit(b - a);
    const Matrix body = {down, cross(v, down), v}, world = {-d, cross(u, -d), u};
    def.state = {};
    def.state.A = ingot::nearest_rotation(world * transposed(body));
    def.state.r_CM = Q - def.state.A * ((a + b) * scalar(0.5) + (b - a) * (off / 2));
    return def;
}

void expect_it_lies_on_the_ridge(int draw) {
    Random random(static_cast<uint64_t>(61000 + draw));
    const Ridge ridge = ridge_of(random);
    constexpr Goer kinds[] = {Goer::roller, Goer::wheel, Goer::box, Goer::pebble};
    const Goer kind = kinds[draw % 4];
    auto& world = empty_world<OnLevel>();
    const BodyId level = add_level(world, ridge.ground.view);
    (void)world.set_gravity({});
    // Any direction between those of the two sides.
    constexpr double slant = 0.4;
    const double angle = ridge.angle * within(random, 0, 1), way = within(random, slant, pi - slant);
    const Vector d = ridge.n[0] * static_cast<scalar>(std::cos(angle)) + cross(ridge.e, ridge.n[0]) * static_cast<scalar>(std::sin(angle));
    const Vector u = unit(ridge.e * static_cast<scalar>(std::cos(way)) + cross(d, ridge.e) * static_cast<scalar>(std::sin(way)));
    const Vector Q = ridge.begin + ridge.along * of(random, 0.3, 0.7);
    scalar size = of(random, 0.05, 0.2);
    BodyDef def = body_across(random, kind, Q, d, u, size);
    const bool round = kind == Goer::roller || kind == Goer::wheel;
    const scalar gap = size * (round ? of(random, -0.3, 0.01) : of(random, -0.05, 0.01));
    def.state.r_CM += d * gap;
    const ingot::Result<BodyId> id = world.add(def);
    ASSERT_EQ(id.status, Status::ok);
    (void)ingot::step(world, scalar(1) / 240);
    // Where it overlaps, it may be as deep in a face, elsewhere.
    scalar separation = 1, away_sq = 1;
    Vector normal{};
    for (const auto& contact : world.contacts_of(id.value))
        for (int i = 0; i < contact.point_count; ++i) {
            const scalar off_sq = length_sq(contact.points[i].P - (Q + d * (gap / 2)));
            if (!(off_sq < away_sq)) continue;
            away_sq = off_sq;
            separation = contact.points[i].separation;
            normal = contact.A == level ? -contact.n : contact.n;
        }
    const double rounding = 64 * 16 * static_cast<double>(ingot::epsilon);  // of places within 16 m
    const auto flush = static_cast<double>(ingot::limits::flush_gap), face_tilt = static_cast<double>(ingot::limits::face_tilt);
    // Directions as near to that of a side are of its plane, and points within the tolerance of surfaces are one. Edges end so far beyond the faces
    // that they lie on, left at no less than `slant`; and the direction of what is apart is known as well as where its nearest points are.
    const double least_turn = std::min(angle, ridge.angle - angle);
    const bool as_side = std::sin(least_turn) <= face_tilt + rounding && least_turn < 1;
    const double off_edges = round ? 0 : static_cast<double>(ingot::limits::corner_slack * size) / std::sin(slant);
    const double off_normal = 2 * rounding / static_cast<double>(size) + (round || gap <= 0 ? 0 : rounding / static_cast<double>(gap));
    const double off_side = as_side ? face_tilt * std::abs(static_cast<double>(gap)) / 2 : 0;  // half-way along the normal
    const std::string what = "draw " + std::to_string(draw) + ", body " + std::to_string(static_cast<int>(kind)) + ", ridge " +
                             std::to_string(ridge.angle) + ", direction " + std::to_string(angle) + ", gap " +
                             std::to_string(static_cast<double>(gap));
    EXPECT_NEAR(static_cast<double>(separation), static_cast<double>(gap), rounding + (as_side ? flush * face_tilt : 0)) << what;
    const double off_place = (as_side || !round ? flush : rounding) + off_edges + off_side;
    EXPECT_LE(std::sqrt(static_cast<double>(away_sq)), off_place) << what;
    EXPECT_LE(length(normal - d), (as_side ? face_tilt : 0) + off_normal) << what;
}

/// With the lowest line of its side, or an edge, across the ridge, a body is nearest to it where the two cross, by as much as it is above the plane
/// that leans on the ridge alone: along any direction between those of the two sides.
TEST(Ridges, carry_what_lies_across_them) {
    for (int draw = 0; draw < ingot_reference::draws(8000); ++draw) expect_it_lies_on_the_ridge(draw);
}

}  // namespace
