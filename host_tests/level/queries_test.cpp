// SPDX-License-Identifier: MIT
// What a world answers about its levels: against all triangles one by one, in double; and in company, where the nearer of two answers counts.
#include <gtest/gtest.h>

#include <memory>

#include "ground.h"
#include "reference/draws.h"

namespace {

using namespace level_test;
using ingot::LevelTriangle;
using ingot::PlacedShape;
using Exact = ingot::Vec3<double>;

struct ByTree : OnLevel {
    using broad_phase = ingot::QueryTree;
};

Exact exact(const Vector& v) { return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)}; }
double norm(const Exact& v) { return std::sqrt(dot(v, v)); }

/// The point of a triangle that is nearest to p. Source: Ericson, "Real-Time Collision Detection", 2005, 5.1.5.
Exact nearest_on(const Exact (&c)[3], const Exact& p) {
    const Exact n = cross(c[1] - c[0], c[2] - c[0]);
    bool inside = true;
    for (int i = 0; i < 3; ++i) inside = inside && dot(cross(n, c[(i + 1) % 3] - c[i]), p - c[i]) >= 0;
    if (inside) return p - n * (dot(n, p - c[0]) / dot(n, n));
    Exact best = c[0];
    for (int i = 0; i < 3; ++i) {
        const Exact along = c[(i + 1) % 3] - c[i];
        const double t = std::min(1.0, std::max(0.0, dot(along, p - c[i]) / dot(along, along)));
        if (norm(c[i] + along * t - p) < norm(best - p)) best = c[i] + along * t;
    }
    return best;
}

/// The triangles of a level where it is placed, in double.
struct Triangles {
    std::vector<std::array<Exact, 3>> all;

    Triangles(const LevelTable& table, const LevelDef& def) {
        for (const uint32_t number : triangles_of(table)) {
            const LevelTriangle triangle = triangle_of(table, number);
            std::array<Exact, 3> placed;
            for (size_t i = 0; i < 3; ++i) {
                const Exact p = exact(triangle.corners[i]);
                placed[i] = exact(def.r) + exact(def.A.c0) * p.x + exact(def.A.c1) * p.y + exact(def.A.c2) * p.z;
            }
            all.push_back(placed);
        }
    }
    double distance(const Exact& p) const {
        double least = 1e30;
        for (const auto& t : all) least = std::min(least, norm(nearest_on({t[0], t[1], t[2]}, p) - p));
        return least;
    }
};

/// A ground of any kind, anywhere, turned any way, and a world of it; beside it some bodies, and a world of both.
template <class S>
struct Company {
    Ground ground;
    LevelDef def;
    std::unique_ptr<World<S>> level{new World<S>}, bodies{new World<S>}, both{new World<S>};
    Vector middle;
    scalar reach;

    explicit Company(Random& random) {
        switch (random() % 3) {
            case 0: {  // not of slivers, whose planes are uncertain
                constexpr Seams seams[] = {Seams::grid, Seams::boxes, Seams::field};
                ground = plane_of(random, seams[random() % 3]);
                break;
            }
            case 1: ground = room_of(random); break;
            default:
                ground.field = field(random, 20, 14, random() % 2 == 0, 4, [&](int, int) { return between(random, 0, 900); });
                ground.view = ground.field.view;
        }
        S::levels[0] = ground.view;
        def.A = any_rotation(random);
        def.r = {draw(random, -20, 20), draw(random, -20, 20), draw(random, -20, 20)};
        middle = def.r + def.A * ground.view.middle();
        reach = static_cast<scalar>(length(ingot::half_extents_of(ground.view)));
        std::vector<BodyDef> defs;
        for (int i = between(random, 1, 12); i > 0; --i) {
            BodyDef body = goer(random, static_cast<Goer>(between(random, 0, goers_count - 1)), draw(random, 0.05, 0.8) * reach / 4, 0);
            body.state.r_CM = place(random);
            body.state.A = any_rotation(random);
            defs.push_back(body);
        }
        const bool first = random() % 2 == 0;
        if (first) {
            EXPECT_TRUE(both->add_level(def).ok());
        }
        for (const BodyDef& body : defs) EXPECT_TRUE(both->add(body).ok() && bodies->add(body).ok());
        if (!first) {
            EXPECT_TRUE(both->add_level(def).ok());
        }
        EXPECT_TRUE(level->add_level(def).ok());
    }
    static scalar draw(Random& random, double low, double high) { return static_cast<scalar>(within(random, low, high)); }
    Vector place(Random& random) const {
        const Vector half = ingot::half_extents_of(ground.view) * scalar(1.2) + Vector{1, 1, 1};
        return middle + def.A * Vector{half.x * draw(random, -1, 1), half.y * draw(random, -1, 1), half.z * draw(random, -1, 1)};
    }
    PlacedShape shape(Random& random) const {
        const BodyDef body = goer(random, static_cast<Goer>(between(random, 0, goers_count - 1)), draw(random, 0.02, 0.3) * reach / 4, 0);
        return {body.shape, place(random), any_rotation(random), body.shape.kind == ingot::ShapeKind::hull ? Slab::hulls : nullptr};
    }
};

/// The nearer of two answers, of which each may be none.
template <class Hit, class Far>
void expect_nearer(const ingot::Result<Hit>& both, const ingot::Result<Hit>& a, const ingot::Result<Hit>& b, const Far& far_of) {
    ASSERT_TRUE(both.ok() && a.ok() && b.ok());
    EXPECT_EQ(far_of(both.value), std::min(far_of(a.value), far_of(b.value)));
}

template <class S>
struct LevelQueries : testing::Test {};
using Scenes = testing::Types<OnLevel, ByTree>;
TYPED_TEST_SUITE(LevelQueries, Scenes);

TYPED_TEST(LevelQueries, in_company_are_the_nearer_of_two) {
    int met = 0;
    for (int draw = 0; draw < ingot_reference::draws(200); ++draw) {
        Random random(static_cast<uint64_t>(5200 + draw));
        const Company<TypeParam> of(random);
        for (int query = 0; query < 20 && !testing::Test::HasFailure(); ++query) {
            const Vector from = of.place(random), way = of.place(random) - from;
            const PlacedShape moving = of.shape(random);
            const auto fraction = [](const ingot::QueryHit& hit) { return hit.found() ? hit.fraction : scalar(2); };
            expect_nearer(of.both->cast_ray(from, way), of.level->cast_ray(from, way), of.bodies->cast_ray(from, way), fraction);
            expect_nearer(of.both->cast_shape(moving, way), of.level->cast_shape(moving, way), of.bodies->cast_shape(moving, way), fraction);
            const scalar far = of.draw(random, 0, 1) * of.reach;
            // Behind a level there is no end to its inside: its surface counts.
            const auto near = of.both->find_nearest(from, far), on_level = of.level->find_nearest(from, far);
            const auto on_body = of.bodies->find_nearest(from, far);
            ASSERT_TRUE(near.ok() && on_level.ok() && on_body.ok());
            const bool is_of_level = on_level.value.found() && (!on_body.value.found() || std::abs(on_level.value.distance) < on_body.value.distance);
            EXPECT_EQ(near.value.found(), on_level.value.found() || on_body.value.found());
            EXPECT_EQ(near.value.distance, is_of_level ? on_level.value.distance : on_body.value.distance);
            ingot::QueryHit hits[16];
            BodyId ids[16];
            const int rays = of.both->cast_ray_all(from, way, hits, 16).value, shapes = of.both->cast_shape_all(moving, way, hits, 16).value;
            EXPECT_EQ(rays, of.level->cast_ray_all(from, way, hits, 16).value + of.bodies->cast_ray_all(from, way, hits, 16).value);
            EXPECT_EQ(shapes, of.level->cast_shape_all(moving, way, hits, 16).value + of.bodies->cast_shape_all(moving, way, hits, 16).value);
            EXPECT_EQ(of.both->find_overlaps(moving, ids, 16).value,
                      of.level->find_overlaps(moving, ids, 16).value + of.bodies->find_overlaps(moving, ids, 16).value);
            met += rays + shapes;
        }
        ASSERT_FALSE(testing::Test::HasFailure()) << "draw " << draw;
    }
    EXPECT_GT(met, 100);
}

/// Places are up to 60 m away: some roundings of them.
constexpr double roundings = 64 * 60 * static_cast<double>(ingot::epsilon);

TYPED_TEST(LevelQueries, tell_what_all_triangles_do) {
    int overlapped = 0, behind = 0, hit = 0, hit_from_behind = 0;
    for (int draw = 0; draw < ingot_reference::draws(200); ++draw) {
        Random random(static_cast<uint64_t>(5300 + draw));
        const Company<TypeParam> of(random);
        const Triangles triangles(of.ground.view, of.def);
        for (int query = 0; query < 6 && !testing::Test::HasFailure(); ++query) {
            const Vector p = of.place(random);
            const double distance = triangles.distance(exact(p));
            const auto near = of.level->find_nearest(p, of.reach * 4);
            ASSERT_TRUE(near.ok() && near.value.found());
            EXPECT_NEAR(std::abs(static_cast<double>(near.value.distance)), distance, roundings);
            const double nearer = distance * 0.99 - roundings;
            if (nearer > 0) {
                EXPECT_FALSE(of.level->find_nearest(p, static_cast<scalar>(nearer)).value.found());
            }

            const auto radius = static_cast<scalar>(distance * within(random, 0.5, 1.5) + 0.01);
            const PlacedShape ball = {ingot::Sphere{radius}, p, ingot::identity_matrix<scalar>(), nullptr};
            BodyId ids[2];
            const bool overlaps = distance < static_cast<double>(radius);
            if (std::abs(distance - static_cast<double>(radius)) > 1e-4 * distance + roundings) {
                EXPECT_EQ(of.level->find_overlaps(ball, ids, 2).value, overlaps ? 1 : 0);
                overlapped += overlaps ? 1 : 0;
                behind += near.value.distance < 0 && !overlaps ? 1 : 0;
            }

            const PlacedShape moving = {ingot::Sphere{static_cast<scalar>(distance * 0.5 + 0.01)}, p, ingot::identity_matrix<scalar>(), nullptr};
            const Vector way = of.place(random) - p;
            const auto cast = of.level->cast_shape(moving, way);
            ASSERT_TRUE(cast.ok());
            // From either side: what begins behind triangles meets those that it comes to from outside, and nothing below the others.
            if (cast.value.found() && std::abs(near.value.distance) > moving.shape.size.x) {
                ++hit;
                hit_from_behind += near.value.distance < 0 ? 1 : 0;
                const double there = triangles.distance(exact(p) + exact(way) * static_cast<double>(cast.value.fraction));
                const double off = there - static_cast<double>(moving.shape.size.x);
                EXPECT_LE(off, 2 * static_cast<double>(ingot::limits::cast_gap * moving.shape.size.x) + roundings) << "it stops at the ground";
            }
        }
        ASSERT_FALSE(testing::Test::HasFailure()) << "draw " << draw;
    }
    EXPECT_GT(overlapped, 20);
    EXPECT_GT(behind, 20);
    EXPECT_GT(hit, 10);
    EXPECT_GT(hit_from_behind, 5);
}

/// m, how far a box and a triangle are apart along the axis that parts them most; below 0: they overlap by so much.
/// Source: Gottschalk et al., "OBBTree", 1996: the normals of faces, and the cross products of edges.
double apart(const std::array<Exact, 3>& corners, const Exact& r, const Exact (&axes)[3], const Exact& half) {
    const Exact edges[3] = {corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]};
    double most = -1e30;
    const auto try_axis = [&](const Exact& axis) {
        if (norm(axis) < 1e-9) return;
        const Exact n = axis * (1 / norm(axis));
        double low = 1e30, high = -1e30;
        for (const Exact& corner : corners) low = std::min(low, dot(n, corner - r)), high = std::max(high, dot(n, corner - r));
        const double reach = std::abs(dot(n, axes[0])) * half.x + std::abs(dot(n, axes[1])) * half.y + std::abs(dot(n, axes[2])) * half.z;
        most = std::max({most, low - reach, -high - reach});
    };
    try_axis(cross(edges[0], edges[1]));
    for (const Exact& axis : axes) {
        try_axis(axis);
        for (const Exact& edge : edges) try_axis(cross(axis, edge));
    }
    return most;
}

/// The triangle itself counts, from either side, and no thickness of it.
TEST(LevelOverlaps, of_boxes_are_what_separating_axes_tell) {
    int with = 0, without = 0, behind = 0;
    for (int draw = 0; draw < ingot_reference::draws(400); ++draw) {
        Random random(static_cast<uint64_t>(5400 + draw));
        const level_tool::MeshData mesh = built(loose_triangles(random, between(random, 1, 6), 4096, 2048));
        OnLevel::levels[0] = mesh.view;
        std::unique_ptr<World<OnLevel>> world{new World<OnLevel>};
        LevelDef def;
        def.r = {static_cast<scalar>(within(random, -20, 20)), static_cast<scalar>(within(random, -20, 20)), 0};
        ASSERT_TRUE(world->add_level(def).ok());
        const Triangles triangles(mesh.view, def);
        for (int query = 0; query < 40; ++query) {
            const auto size = [&random] { return static_cast<scalar>(0.1 * std::pow(10, within(random, 0, 1))); };
            // About a corner of one of them, and beside it by up to its own size.
            const ingot::Box form = {{size(), size(), size()}};
            const Exact corner = triangles.all[random() % triangles.all.size()][random() % 3];
            const double reach = static_cast<double>(ingot::bounding_radius(form));
            const auto about = [&](double p) { return static_cast<scalar>(p + within(random, -1.5, 1.5) * (0.1 + reach)); };
            const PlacedShape box = {form, {about(corner.x), about(corner.y), about(corner.z)}, any_rotation(random), nullptr};
            const Exact axes[3] = {exact(box.A.c0), exact(box.A.c1), exact(box.A.c2)};
            double least = 1e30;
            bool is_behind = false;
            for (const auto& triangle : triangles.all) {
                const double far = apart(triangle, exact(box.r), axes, exact(box.shape.size));
                if (far < least) is_behind = dot(cross(triangle[1] - triangle[0], triangle[2] - triangle[0]), exact(box.r) - triangle[0]) < 0;
                least = std::min(least, far);
            }
            if (std::abs(least) < 1e-4 + roundings) continue;
            BodyId ids[2];
            EXPECT_EQ(world->find_overlaps(box, ids, 2).value, least < 0 ? 1 : 0) << draw << " " << query << ": " << least;
            ++(least < 0 ? with : without);
            behind += is_behind && least > 0 && least < 0.1 ? 1 : 0;
        }
    }
    EXPECT_GT(with, ingot_reference::draws(400));
    EXPECT_GT(without, ingot_reference::draws(400));
    EXPECT_GT(behind, ingot_reference::draws(400));
}

}  // namespace
