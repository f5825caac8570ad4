// SPDX-License-Identifier: MIT
#include <ingot/query/ray_on_shapes.h>

#include "query/field.h"

using namespace query_field;

namespace {

struct Ray {
    Vector from, way;
    V at(Real t) const { return exact(from) + exact(way) * t; }
};

/// Rays that have a good chance: from outside, from inside, along axes, past rims, far longer than the shape.
Ray any_ray(RandomInput& random, const PlacedShape& at) {
    const Eigen::Vector3d r = ingot_reference::to_eigen(at.r);
    Eigen::Vector3d from = random.vector(place);
    const Eigen::Vector3d aim = r + random.vector(2.5);
    if (random.integer(0, 9) == 0) from = r + random.vector(1);
    Eigen::Vector3d way = (aim - from) * random.real(0.2, 3);
    const double along = random.real(-9, 9);
    if (random.integer(0, 4) == 0) way = along * ingot_reference::to_eigen(at.A).col(random.integer(0, 2));
    if (random.integer(0, 9) == 0) way = along * Eigen::Vector3d::Unit(random.integer(0, 2));
    return {to_vector(from), to_vector(way)};
}

void expect_enters(const PlacedShape& s, const Ray& ray, scalar fraction, const V& P, const V& n) {
    EXPECT_NEAR(static_cast<double>(query_oracle::distance_of(s, ray.at(fraction))), 0, tolerance);
    EXPECT_NEAR(static_cast<double>((P - ray.at(fraction)).norm()), 0, tolerance);
    EXPECT_NEAR(static_cast<double>(n.norm()), 1, 8 * static_cast<double>(ingot::epsilon));
    // The plane through P across n has the whole solid below it.
    EXPECT_LE(static_cast<double>(query_oracle::support_of(s, n.normalized()) - n.normalized().dot(P)), 4 * tolerance);
    EXPECT_LE(static_cast<double>(n.dot(exact(ray.way))), tolerance) << "out of the body, against the ray";
}

/// From a point of the surface, to a rounding, inward: it is met there and at no time before the begin.
TEST(Ray, from_the_surface_of_a_ball_meets_it_at_once) {
    World<Field> world;
    (void)world.add(body_of({ingot::Sphere{1}, {}, ingot::identity_matrix<scalar>(), nullptr}));
    RandomInput random(22);
    int outside = 0;
    for (int case_i = 0; case_i < 20000; ++case_i) {
        const Vector from = to_vector(random.direction());
        if (!(ingot::length_sq(from) > 1)) continue;
        ++outside;
        const Result<QueryHit> hit = world.cast_ray(from, from * scalar(-100));
        ASSERT_TRUE(hit.ok() && hit.value.found()) << case_i;
        EXPECT_GE(hit.value.fraction, 0) << case_i;
        EXPECT_LE(static_cast<double>(hit.value.fraction) * 100, tolerance) << case_i;
        EXPECT_NEAR(static_cast<double>((exact(hit.value.n) - exact(from)).norm()), 0, tolerance) << case_i;
    }
    EXPECT_GT(outside, 500);
}

TEST(Ray, enters_each_shape_where_the_oracle_does) {
    RandomInput random(21);
    int met[8] = {}, missed[8] = {}, inside[8] = {};
    for (int case_i = 0; case_i < 20000; ++case_i) {
        PlacedShape s = any_placed(random, place / 2);
        if (case_i % 6 == 0) s.shape = ingot::HalfSpace{to_vector(random.direction()), static_cast<scalar>(random.real(-2, 2))};
        auto world = std::make_unique<World<Field>>();
        Bodies bodies;
        const Result<BodyId> added = world->add(body_of(s));
        if (!added.ok()) continue;  // a direction that rounding made too long
        bodies.placed.push_back(placed_in(*world, added.value, s.shape));
        const Ray ray = any_ray(random, s);
        const auto way = query_oracle::walk([&](Real t) { return query_oracle::distance_of(bodies.placed[0], ray.at(t)); });
        const Result<QueryHit> hit = world->cast_ray(ray.from, ray.way);
        ASSERT_TRUE(hit.ok());
        const auto kind = static_cast<std::size_t>(s.shape.kind);
        const Real at_begin = query_oracle::distance_of(bodies.placed[0], ray.at(0)), at_end = query_oracle::distance_of(bodies.placed[0], ray.at(1));
        if (std::abs(way.least) < tolerance || std::abs(at_begin) < tolerance || std::abs(at_end) < tolerance) continue;
        ASSERT_EQ(hit.value.found(), way.enters <= 1) << case_i << " kind " << kind << " least " << static_cast<double>(way.least);
        if (!hit.value.found()) {
            ++missed[kind];
            EXPECT_EQ(hit.value.fraction, 1);
            EXPECT_EQ(hit.value.body, BodyId{});
            continue;
        }
        EXPECT_EQ(hit.value.body, added.value);
        if (way.enters <= 0) {
            ++inside[kind];
            EXPECT_EQ(hit.value.fraction, 0);
            EXPECT_NEAR(static_cast<double>((exact(hit.value.n) + exact(ray.way).normalized()).norm()), 0, 8 * static_cast<double>(ingot::epsilon));
            continue;
        }
        ++met[kind];
        EXPECT_LE(static_cast<double>(hit.value.fraction), static_cast<double>(way.at_least) + tolerance) << "where it enters, not where it leaves";
        expect_enters(bodies.placed[0], ray, hit.value.fraction, exact(hit.value.P), exact(hit.value.n));
        if (HasFailure()) FAIL() << case_i << " kind " << kind;
    }
    for (const ShapeKind kind : {ShapeKind::sphere, ShapeKind::capsule, ShapeKind::box, ShapeKind::cylinder, ShapeKind::half_space}) {
        EXPECT_GT(met[static_cast<std::size_t>(kind)], 300);
        EXPECT_GT(missed[static_cast<std::size_t>(kind)], 300);
        EXPECT_GT(inside[static_cast<std::size_t>(kind)], 30);
    }
}

/// An octahedron: faces, and nothing else of a hull, are what a ray looks at.
TEST(Ray, enters_a_hull_where_the_oracle_does) {
    const auto third = static_cast<scalar>(1 / std::sqrt(3.0L));
    const Vector vertices[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    ingot::HullFace faces[8] = {};
    for (int i = 0; i < 8; ++i)
        faces[i] = {{(i & 1) != 0 ? third : -third, (i & 2) != 0 ? third : -third, (i & 4) != 0 ? third : -third}, third, 0, 0};
    ingot::ConvexHull hull{};
    hull.vertices = vertices;
    hull.faces = faces;
    hull.vertex_count = 6;
    hull.face_count = 8;
    const PlacedShape s = {ingot::Hull{1}, {}, ingot::identity_matrix<scalar>(), &hull};
    RandomInput random(22);
    int met = 0, missed = 0, inside = 0;
    for (int case_i = 0; case_i < 4000; ++case_i) {
        const Eigen::Vector3d from = random.vector(case_i % 4 == 0 ? 0.7 : 3), aim = random.vector(1);
        const Ray ray = {to_vector(from), to_vector(Eigen::Vector3d((aim - from) * 2))};
        const auto way = query_oracle::walk([&](Real t) { return query_oracle::distance_of(s, ray.at(t)); });
        if (std::abs(way.least) < tolerance || std::abs(query_oracle::distance_of(s, ray.at(0))) < tolerance) continue;
        const ingot::RayEntry entry = ingot::ray_on_hull(hull, {ray.from, ray.way});
        ASSERT_EQ(entry.meets, way.enters <= 1) << case_i;
        ++(!entry.meets ? missed : way.enters > 0 ? met : inside);
        if (entry.meets && way.enters > 0) expect_enters(s, ray, entry.fraction, ray.at(entry.fraction), exact(entry.n));
    }
    EXPECT_GT(met, 500);
    EXPECT_GT(missed, 500);
    EXPECT_GT(inside, 50);
}

TEST(Ray, meets_the_first_of_many_bodies) {
    int met = 0, missed = 0;
    RandomInput random(23);
    for (int world_i = 0; world_i < 20; ++world_i) {
        Bodies bodies;
        const auto world = field_of<Field>(random, 60, bodies);
        for (int ray_i = 0; ray_i < 80; ++ray_i) {
            const Ray ray = {to_vector(random.vector(place)), to_vector(random.vector(place))};
            Real first = 2, second = 2;
            std::size_t first_i = 0;
            bool grazes = false;
            for (std::size_t i = 0; i < bodies.ids.size(); ++i) {
                const auto way = query_oracle::walk([&](Real t) { return query_oracle::distance_of(bodies.placed[i], ray.at(t)); });
                grazes = grazes || std::abs(way.least) < tolerance || std::abs(query_oracle::distance_of(bodies.placed[i], ray.at(0))) < tolerance;
                if (way.enters < first) {
                    second = first;
                    first = way.enters;
                    first_i = i;
                } else {
                    second = std::min(second, way.enters);
                }
            }
            if (grazes) continue;
            const QueryHit hit = world->cast_ray(ray.from, ray.way).value;
            ASSERT_EQ(hit.found(), first <= 1);
            ++(hit.found() ? met : missed);
            if (!hit.found()) continue;
            if (first <= 0) {
                EXPECT_EQ(hit.fraction, 0);
            } else {
                const int index = index_of(bodies, hit.body);
                ASSERT_GE(index, 0);
                expect_enters(bodies.placed[static_cast<std::size_t>(index)], ray, hit.fraction, exact(hit.P), exact(hit.n));
            }
            if (second > first + 0.01L) {
                EXPECT_EQ(hit.body, bodies.ids[first_i]);
            }
        }
    }
    EXPECT_GT(met, 300);
    EXPECT_GT(missed, 20);
}

TEST(Ray, of_a_kilometre_meets_a_ball_of_a_centimetre) {
    World<Field> world;
    BodyDef def = body_of({ingot::Sphere{scalar(0.0078125)}, {512, 0, 0}, ingot::identity_matrix<scalar>(), nullptr});
    const BodyId id = world.add(def).value;
    // 7 mm beside the centre is within its radius of 7.8 mm, 8 mm is not.
    EXPECT_EQ(world.cast_ray({-512, scalar(0.007), 0}, {2048, 0, 0}).value.body, id);
    EXPECT_FALSE(world.cast_ray({-512, scalar(0.008), 0}, {2048, 0, 0}).value.found());
    const QueryHit hit = world.cast_ray({-512, 0, 0}, {2048, 0, 0}).value;
    EXPECT_NEAR(hit.P.x, 512 - 0.0078125, 2048 * static_cast<double>(ingot::epsilon));
    EXPECT_EQ(hit.n.x, -1);
}

TEST(Ray, that_meets_two_at_once_takes_the_lower_slot) {
    World<Field> world;
    const PlacedShape ball = {ingot::Sphere{1}, {5, 0, 0}, ingot::identity_matrix<scalar>(), nullptr};
    BodyId ids[9];
    for (BodyId& id : ids) id = world.add(body_of(ball)).value;
    EXPECT_EQ(world.cast_ray({}, {10, 0, 0}).value.body, ids[0]);
    (void)world.remove(ids[0]);
    EXPECT_EQ(world.cast_ray({}, {10, 0, 0}).value.body, ids[1]);
    EXPECT_EQ(world.cast_ray({}, {10, 0, 0}).value.fraction, scalar(0.4));
    for (const BodyId id : ids) (void)world.remove(id);
    EXPECT_FALSE(world.cast_ray({}, {10, 0, 0}).value.found());
}

struct WithHulls : Field {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Hull>;
    static constexpr auto cube =
        ingot::convex_hull({{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}});
    static constexpr ingot::ConvexHull hulls[] = {cube.value.view()};
};

/// Hulls and balls of one world, each met by the routine of its kind; a ball has no hull to be asked.
TEST(Ray, meets_hulls_in_a_world_of_balls) {
    World<WithHulls> world;
    PlacedShape cube = {ingot::hull_of<WithHulls>(0), {4, 0, 0}, ingot::identity_matrix<scalar>(), nullptr};
    const BodyId cube_id = world.add(body_of(cube)).value, ball_id = world.add(body_of({ingot::Sphere{1}, {-4, 0, 0}, cube.A, nullptr})).value;
    const QueryHit on_cube = world.cast_ray({0, scalar(0.5), 0}, {8, 0, 0}).value, on_ball = world.cast_ray({}, {-8, 0, 0}).value;
    EXPECT_EQ(on_cube.body, cube_id);
    EXPECT_EQ(on_cube.fraction, scalar(0.375));
    EXPECT_EQ(on_cube.n.x, -1);
    EXPECT_EQ(on_ball.body, ball_id);
    EXPECT_EQ(on_ball.fraction, scalar(0.375));
    EXPECT_FALSE(world.cast_ray({0, 2, 0}, {8, 0, 0}).value.found());
    const QueryNearest nearest = world.find_nearest({2, 0, 0}, 9).value;
    EXPECT_EQ(nearest.body, cube_id);
    EXPECT_NEAR(static_cast<double>(nearest.distance), 1, tolerance);
    // A hull that moves is one of the scene's.
    cube.r = {-1, 0, 0};
    cube.hull = nullptr;
    EXPECT_EQ(world.cast_shape(cube, {-8, 0, 0}).status, Status::bad_shape);
    cube.hull = &WithHulls::hulls[0];
    const QueryHit of_cube = world.cast_shape(cube, {-8, 0, 0}).value;
    EXPECT_EQ(of_cube.body, ball_id);
    EXPECT_NEAR(static_cast<double>(of_cube.fraction), 0.125, tolerance + static_cast<double>(ingot::limits::cast_gap));
}

}  // namespace
