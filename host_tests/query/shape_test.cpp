// SPDX-License-Identifier: MIT
#include <ingot/query/cast_shape.h>

#include "query/field.h"

using namespace query_field;

namespace {

/// Distance of two shapes by the oracle: polyhedra with a radius feature by feature; cylinders only against balls.
Real gap_of(const PlacedShape& A, const PlacedShape& B) {
    if (A.shape.kind == ShapeKind::sphere) return query_oracle::distance_of(B, exact(A.r)) - A.shape.size.x;
    if (B.shape.kind == ShapeKind::sphere) return query_oracle::distance_of(A, exact(B.r)) - B.shape.size.x;
    if (B.shape.kind == ShapeKind::half_space) {
        const V n = exact(B.A) * exact(B.shape.size);
        return n.dot(exact(B.r)) * -1 - B.shape.offset - query_oracle::support_of(A, -n);
    }
    return ingot_oracle::signed_distance(ingot_collide::oracle_of(A), ingot_collide::oracle_of(B));
}
PlacedShape moved(PlacedShape s, const V& by) {
    s.r = to_vector(V(exact(s.r) + by));
    return s;
}

/// Cylinders meet balls, all else meets all else.
Shape shape_that_the_oracle_knows(RandomInput& random, const Shape& other) {
    if (other.kind == ShapeKind::cylinder) return ingot::Sphere{size(random)};
    return any_shape(random, other.kind == ShapeKind::sphere ? 4 : 3);
}

struct Case {
    PlacedShape moving, still;
    Vector way;
};

Case any_case(RandomInput& random, int case_i) {
    Case c{any_placed(random, place / 2), any_placed(random, place / 2), {}};
    c.moving.shape = shape_that_the_oracle_knows(random, c.still.shape);
    if (case_i % 8 == 0) {
        c.still.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        c.moving.shape = any_shape(random);
    }
    const Eigen::Vector3d from = ingot_reference::to_eigen(c.moving.r), to = ingot_reference::to_eigen(c.still.r);
    // Towards it, past it at about the sum of the sizes, anywhere.
    const Eigen::Vector3d aim = to + random.vector(case_i % 3 == 0 ? 3 : 1);
    c.way = to_vector(Eigen::Vector3d((aim - from) * random.real(0.3, 2)));
    return c;
}

TEST(ShapeCast, stops_short_of_what_it_meets) {
    RandomInput random(31);
    int met = 0, missed = 0, inside = 0;
    for (int case_i = 0; case_i < 2500; ++case_i) {
        const Case c = any_case(random, case_i);
        World<Field> world;
        const BodyId id = world.add(body_of(c.still)).value;
        const PlacedShape still = placed_in(world, id, c.still.shape);
        const auto gap_at = [&](Real t) {
            PlacedShape A = c.moving;
            A.A = ingot::nearest_rotation(A.A);
            return gap_of(moved(A, exact(c.way) * t), still);
        };
        const Result<QueryHit> hit = world.cast_shape(c.moving, c.way);
        ASSERT_TRUE(hit.ok());
        const double R = static_cast<double>(ingot::bounding_radius(c.moving.shape));
        const double R_B = still.shape.kind == ShapeKind::half_space ? R : static_cast<double>(ingot::bounding_radius(still.shape));
        // As the header says; the oracle's own place is rounded where it is moved to.
        const double most = static_cast<double>(ingot::limits::cast_gap) * std::min(R, R_B) + 2 * tolerance;
        const Real begin = gap_at(0);
        if (std::abs(begin) < most) continue;
        if (begin < 0) {
            ++inside;
            EXPECT_TRUE(hit.value.found()) << case_i;
            EXPECT_EQ(hit.value.fraction, 0);
            EXPECT_NEAR(static_cast<double>((exact(hit.value.n) + exact(c.way).normalized()).norm()), 0, 8 * static_cast<double>(ingot::epsilon));
            continue;
        }
        const auto way = query_oracle::walk(gap_at, 50);
        if (std::abs(way.least) < most) {  // it grazes: either answer, but never too far
            if (hit.value.found()) {
                EXPECT_GE(static_cast<double>(gap_at(hit.value.fraction)), -2 * tolerance);
            }
            continue;
        }
        if (std::abs(way.at_least - 1) < 1e-3L && std::abs(way.least) < 2 * most) continue;
        ASSERT_EQ(hit.value.found(), way.least < 0) << case_i << " least " << static_cast<double>(way.least);
        if (!hit.value.found()) {
            ++missed;
            EXPECT_EQ(hit.value.fraction, 1);
            continue;
        }
        ++met;
        const double gap = static_cast<double>(gap_at(hit.value.fraction));
        EXPECT_GE(gap, -2 * tolerance) << case_i << ": never into it";
        EXPECT_LE(gap, most) << case_i << ": never far from it";
        EXPECT_LE(static_cast<double>(hit.value.fraction), static_cast<double>(way.at_least) + 1e-3);
        EXPECT_LT(exact(hit.value.n).dot(exact(c.way)), 0);
        EXPECT_NEAR(static_cast<double>(exact(hit.value.n).norm()), 1, 8 * static_cast<double>(ingot::epsilon));
        EXPECT_NEAR(static_cast<double>(query_oracle::distance_of(still, exact(hit.value.P))), 0, 2 * tolerance);
        // A plane through P across n has the body below it, but for what its angle is off: cast_gap and roundings over the gap.
        if (still.shape.kind != ShapeKind::half_space) {
            const V n = exact(hit.value.n);
            const double angle = 8 * 24 * static_cast<double>(ingot::epsilon) / most;
            EXPECT_LE(static_cast<double>(query_oracle::support_of(still, n) - n.dot(exact(hit.value.P))),
                      most + 2 * R_B * std::max(angle, static_cast<double>(ingot::limits::nearest_accuracy)));
        }
        if (HasFailure()) FAIL() << case_i << " kinds " << static_cast<int>(c.moving.shape.kind) << " " << static_cast<int>(still.shape.kind);
    }
    EXPECT_GT(met, 800);
    EXPECT_GT(missed, 400);
    EXPECT_GT(inside, 30);
}

/// Balls past a ball, ever closer to touching it: the worst of Newton's method, whose steps then halve.
TEST(ShapeCast, that_grazes_ends_in_bounded_time_and_never_too_far) {
    int met = 0;
    for (int power = 2; power < 24; ++power) {
        for (const double side : {-1.0, 1.0}) {
            World<Field> world;
            (void)world.add(body_of({ingot::Sphere{1}, {}, ingot::identity_matrix<scalar>(), nullptr}));
            const auto y = static_cast<scalar>(2 + side * std::ldexp(1.0, -power));
            const PlacedShape moving = {ingot::Sphere{1}, {-6, y, 0}, ingot::identity_matrix<scalar>(), nullptr};
            const QueryHit hit = world.cast_shape(moving, {12, 0, 0}).value;
            const double gap = std::hypot(-6 + 12 * static_cast<double>(hit.fraction), static_cast<double>(y)) - 2;
            const double most = static_cast<double>(ingot::limits::cast_gap) + tolerance;
            if (static_cast<double>(y) < 2 - tolerance) {
                EXPECT_TRUE(hit.found()) << power;
                EXPECT_LE(gap, most) << power;
                EXPECT_GE(gap, -tolerance) << power;
            } else if (static_cast<double>(y) > 2 + most) {
                EXPECT_FALSE(hit.found()) << power;
            }
            met += hit.found() ? 1 : 0;
        }
    }
    EXPECT_GE(met, 20);
}

TEST(ShapeCast, meets_the_first_of_many_bodies) {
    RandomInput random(33);
    int met = 0;
    for (int world_i = 0; world_i < 12; ++world_i) {
        Bodies bodies;
        const auto world = field_of<Field>(random, 40, bodies, 4);
        for (int cast_i = 0; cast_i < 60; ++cast_i) {
            const PlacedShape moving = {ingot::Sphere{static_cast<scalar>(random.real(0.05, 0.5))}, to_vector(random.vector(place)),
                                        to_matrix(random.rotation()), nullptr};
            const Vector way = to_vector(random.vector(place));
            const double most = 1e-3;
            Real first = 2, second = 2;
            std::size_t first_i = 0;
            bool unclear = false;
            for (std::size_t i = 0; i < bodies.ids.size(); ++i) {
                const auto f = [&](Real t) {
                    return query_oracle::distance_of(bodies.placed[i], exact(moving.r) + exact(way) * t) - moving.shape.size.x;
                };
                const auto found = query_oracle::walk(f);
                unclear = unclear || std::abs(found.least) < most || std::abs(f(0)) < most;
                if (found.enters < first) {
                    second = first;
                    first = found.enters;
                    first_i = i;
                } else {
                    second = std::min(second, found.enters);
                }
            }
            if (unclear) continue;
            const QueryHit hit = world->cast_shape(moving, way).value;
            ASSERT_EQ(hit.found(), first <= 1);
            met += hit.found() ? 1 : 0;
            if (!hit.found()) continue;
            EXPECT_LE(static_cast<double>(hit.fraction), static_cast<double>(first) + tolerance) << "never past the first";
            if (second > first + 0.02L) {
                EXPECT_EQ(hit.body, bodies.ids[first_i]);
            }
        }
    }
    EXPECT_GT(met, 100);
}

TEST(Overlaps, are_those_that_the_oracle_finds) {
    RandomInput random(34);
    int yes = 0, no = 0;
    for (int world_i = 0; world_i < 240; ++world_i) {
        Bodies bodies;
        const auto world = field_of<Field>(random, 60, bodies, world_i % 2 == 0 ? 3 : 4);
        PlacedShape shape = any_placed(random, place, 3);
        if (world_i % 2 != 0) shape.shape = ingot::Sphere{size(random)};
        const PlacedShape turned = {shape.shape, shape.r, ingot::nearest_rotation(shape.A), nullptr};
        BodyId found[101];
        const Result<int> count = world->find_overlaps(shape, found, 101);
        ASSERT_TRUE(count.ok());
        for (int i = 1; i < count.value; ++i) EXPECT_LT(found[i - 1].slot, found[i].slot);
        for (std::size_t i = 0; i < bodies.ids.size(); ++i) {
            const Real gap = gap_of(turned, bodies.placed[i]);
            if (std::abs(gap) < tolerance) continue;
            ++(gap < 0 ? yes : no);
            EXPECT_EQ(std::count(found, found + count.value, bodies.ids[i]), gap < 0 ? 1 : 0) << static_cast<double>(gap);
        }
        for (int i = 0; i < count.value; ++i) EXPECT_GE(index_of(bodies, found[i]), 0) << "of no body that has gone";
    }
    EXPECT_GT(yes, 100);
    EXPECT_GT(no, 1000);
}

TEST(Overlaps, beyond_the_capacity_are_counted) {
    World<Field> world;
    BodyId ids[6];
    for (BodyId& id : ids) id = world.add(body_of({ingot::Sphere{1}, {}, ingot::identity_matrix<scalar>(), nullptr})).value;
    const PlacedShape shape = {ingot::Box{{1, 1, 1}}, {1, 1, 0}, ingot::identity_matrix<scalar>(), nullptr};
    BodyId found[4] = {};
    EXPECT_EQ(world.find_overlaps(shape, found, 3).value, 6);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(found[i], ids[i]);
    EXPECT_EQ(found[3], BodyId{}) << "nothing is written beyond the capacity";
    EXPECT_EQ(world.find_overlaps(shape, nullptr, 0).value, 6);
}

TEST(Nearest, is_the_surface_that_the_oracle_finds) {
    RandomInput random(35);
    int outside = 0, inside = 0, none = 0;
    for (int world_i = 0; world_i < 40; ++world_i) {
        Bodies bodies;
        const auto world = field_of<Field>(random, 40, bodies);
        if (world_i % 2 == 0) put(*world, {ingot::HalfSpace{{0, 0, 1}, scalar(-place)}, {}, ingot::identity_matrix<scalar>(), nullptr}, bodies);
        for (int case_i = 0; case_i < 50; ++case_i) {
            const Vector point = to_vector(random.vector(place));
            const auto within = static_cast<scalar>(random.real(0, 4));
            Real best = HUGE_VALL, second = HUGE_VALL;
            std::size_t best_i = 0;
            for (std::size_t i = 0; i < bodies.ids.size(); ++i) {
                const Real distance = query_oracle::distance_of(bodies.placed[i], exact(point));
                if (distance < best) {
                    second = best;
                    best = distance;
                    best_i = i;
                } else {
                    second = std::min(second, distance);
                }
            }
            if (best + tolerance > 0) {  // also one that is asked for hardly further than it is
                EXPECT_TRUE(world->find_nearest(point, static_cast<scalar>(best + tolerance)).value.found()) << best;
            }
            if (std::abs(best - within) < tolerance) continue;
            const QueryNearest nearest = world->find_nearest(point, within).value;
            ASSERT_EQ(nearest.found(), best < within);
            if (!nearest.found()) {
                ++none;
                EXPECT_EQ(nearest.distance, within);
                continue;
            }
            EXPECT_NEAR(static_cast<double>(nearest.distance), static_cast<double>(best), tolerance);
            if (second > best + tolerance) {
                EXPECT_EQ(nearest.body, bodies.ids[best_i]);
            }
            ++(best < 0 ? inside : outside);
            const int index = index_of(bodies, nearest.body);
            ASSERT_GE(index, 0);
            const PlacedShape& body = bodies.placed[static_cast<std::size_t>(index)];
            EXPECT_NEAR(static_cast<double>(query_oracle::distance_of(body, exact(nearest.P))), 0, tolerance) << "on the surface";
            EXPECT_NEAR(static_cast<double>((exact(nearest.P) + exact(nearest.n) * nearest.distance - exact(point)).norm()), 0, tolerance);
        }
    }
    EXPECT_GT(outside, 500);
    EXPECT_GT(inside, 50);
    EXPECT_GT(none, 100);
}

}  // namespace
