// SPDX-License-Identifier: MIT
// What every manifold keeps, whatever the shapes.
#include <gtest/gtest.h>

#include <cstdio>

#include "collide/placed.h"
#include "reference/draws.h"

namespace {

using namespace ingot_collide;
using ingot_oracle::Convex;
using ingot_oracle::signed_distance;
using ingot_reference::draws;

constexpr double u = ingot::epsilon / 2;

Shape shape_of(ShapeKind kind, RandomInput& random) {
    const auto length = [&] { return static_cast<scalar>(std::exp(random.real(-1.5, 1))); };
    switch (kind) {
        case ShapeKind::sphere: return ingot::Sphere{length()};
        case ShapeKind::capsule: return ingot::Capsule{length(), length()};
        case ShapeKind::cylinder: return ingot::Cylinder{length(), length()};
        case ShapeKind::hull: return ingot::Hull{1};
        default: return ingot::Box{{length(), length(), length()}};
    }
}

void give_hull(PlacedShape& s, RandomInput& random) {
    if (s.shape.kind != ShapeKind::hull) return;
    s.hull = hull_of(random);
    s.shape = ingot::Hull{s.hull->radius};
}

/// Turned at random, or along the axes, or nearly so.
Eigen::Matrix3d orientation(RandomInput& random) {
    const int kind = random.integer(0, 5);
    if (kind == 0) return Eigen::Matrix3d::Identity();
    if (kind == 1) return turned(random.direction(), 1e-6);
    if (kind == 2) return turned(random.direction(), 1e-3);
    if (kind == 3) return turned(Eigen::Vector3d::Unit(random.integer(0, 2)), 0.25 * 3.14159265358979 * random.integer(1, 7));
    return random.rotation();
}

/// Two shapes at a distance between deep overlap and just beyond the margin.
std::array<PlacedShape, 2> pair_of(ShapeKind a, ShapeKind b, RandomInput& random, double wanted) {
    const Shape shape_A = shape_of(a, random), shape_B = shape_of(b, random);
    const Eigen::Matrix3d A = orientation(random), B = orientation(random);
    const Eigen::Vector3d at = random.vector(3);
    const Eigen::Vector3d towards =
        random.integer(0, 2) == 0 ? Eigen::Vector3d(B.col(random.integer(0, 2))) : random.direction();
    PlacedShape placed_A = placed(shape_A, at, A), placed_B = placed(shape_B, at, B);
    give_hull(placed_A, random), give_hull(placed_B, random);
    double away = size_of(placed_A) + size_of(placed_B);
    for (int i = 0; i < 12; ++i) {  // to the wanted distance, nearly
        placed_A.r = to_vector(Eigen::Vector3d(at + towards * away));
        const double off = static_cast<double>(signed_distance(oracle_of(placed_A, 8), oracle_of(placed_B, 8))) - wanted;
        away -= off;
        if (std::abs(off) < 1e-7) break;
    }
    return {placed_A, placed_B};
}

struct Kinds {
    ShapeKind a, b;
    const char* name;
};
bool has_kind(const Kinds& kinds, ShapeKind kind) { return kinds.a == kind || kinds.b == kind; }
void PrintTo(const Kinds& kinds, std::ostream* out) { *out << kinds.name; }

/// The oracle takes all pairs of edges: the more of them, the fewer cases.
int all_cases(const Kinds& kinds) {
    if (kinds.a == ShapeKind::cylinder && kinds.b == ShapeKind::cylinder) return 80;
    const bool many_edges = has_kind(kinds, ShapeKind::hull) || has_kind(kinds, ShapeKind::cylinder);
    return kinds.a == ShapeKind::sphere ? 3000 : many_edges ? 300 : 2000;
}
int cases(const Kinds& kinds) { return draws(all_cases(kinds)); }

/// How far a manifold may be from what is exact: the choices in limits that stand for nearly parallel features.
struct Slack {
    long double separation, depth, surface;
};
Slack slack_of(const PlacedShape& A, const PlacedShape& B) {
    const long double size = size_of(A) + size_of(B), rounding = 32 * ingot::epsilon * size;
    Slack slack{rounding, rounding, rounding};
    const auto has = [&](ShapeKind kind) { return A.shape.kind == kind || B.shape.kind == kind; };
    if ((has(ShapeKind::box) || has(ShapeKind::hull) || has(ShapeKind::cylinder)) && !has(ShapeKind::sphere)) {
        slack.depth += ingot::limits::edge_preference * size;
        slack.surface += ingot::limits::corner_slack * size;
        slack.separation += ingot::limits::corner_slack * size;
    }
    if (has(ShapeKind::hull) || has(ShapeKind::cylinder)) {
        const long double direction = ingot::limits::nearest_direction * size;
        slack.separation += direction, slack.depth += direction, slack.surface += direction;
    }
    if (has(ShapeKind::capsule)) {
        slack.separation += ingot::limits::flatness * size;
        slack.surface += (1 - ingot::limits::lying_cos) * size;
        slack.depth += ingot::limits::flatness * size;
    }
    if (has(ShapeKind::cylinder)) {
        const long double prism = (1 - std::cos(3.14159265358979L / 48)) * size;
        slack.separation += prism, slack.depth += prism, slack.surface += prism;
    }
    return slack;
}

class Pair : public ::testing::TestWithParam<Kinds> {};

/// Points exist where shapes overlap, are where both surfaces are, and moving A along n by the depth ends the overlap.
TEST_P(Pair, meets_the_oracle) {
    RandomInput random(1401);
    const Kinds kinds = GetParam();
    long double worst_s = 0, worst_depth = 0, worst_surface = 0, worst_left = 0;
    int touching = 0, missed = 0, points = 0;
    const int count = cases(kinds);
    for (int i = 0; i < count; ++i) {
        const scalar margin = scalar(0.05);
        const double wanted = i % 3 == 0   ? -random.real(0, 0.8)
                              : i % 3 == 1 ? random.real(-0.02, 0.07)
                                           : random.real(-1e-5, 1e-5);
        const auto [A, B] = pair_of(kinds.a, kinds.b, random, wanted);
        const Convex a = oracle_of(A), b = oracle_of(B);
        const long double exact_s = signed_distance(a, b);
        const Slack slack = slack_of(A, B);
        Manifold m{};
        ASSERT_TRUE(collide(A, B, margin, m));
        ASSERT_LE(m.count, 4);
        ASSERT_NEAR(static_cast<double>(exact(m.n).norm()), 1, 16 * u) << i;
        if (m.count == 0) {
            ASSERT_GT(exact_s, -slack.separation) << i;
            missed += exact_s <= margin - slack.separation;
            continue;
        }
        ++touching;
        points += m.count;
        const long double s = least(m);
        ASSERT_LE(s, margin);
        // No point is nearer than the shapes are; where they overlap none is deeper than it must be, but for the preferences.
        ASSERT_GE(s, exact_s - slack.depth) << i << " exact " << exact_s;
        worst_depth = std::max(worst_depth, exact_s - s);
        if (exact_s > -slack.separation && m.count > 0) worst_s = std::max(worst_s, s - exact_s);
        const V n = exact(m.n);
        const long double left = -signed_distance(a.moved(-s * n), b);
        ASSERT_LE(left, slack.separation)
            << i << " s " << s << " exact " << exact_s << " count " << m.count;
        worst_left = std::max(worst_left, left);
        for (int k = 0; k < m.count; ++k) {
            const V P = exact(m.points[k].P);
            const V half = n * (static_cast<long double>(m.points[k].separation) / 2);
            // For overlaps the points are on the surfaces, but not on the side where the other shape is nearest.
            const long double off_A = signed_distance(ingot_oracle::point(P + half, 0), a),
                              off_B = signed_distance(ingot_oracle::point(P - half, 0), b);
            worst_surface = std::max({worst_surface, std::abs(off_A), std::abs(off_B)});
            ASSERT_LE(std::abs(off_A), slack.surface)
                << i << " point " << k << " of " << m.count << " s " << m.points[k].separation;
            ASSERT_LE(std::abs(off_B), slack.surface)
                << i << " point " << k << " of " << m.count << " s " << m.points[k].separation;
        }
    }
    std::printf(
        "%s: %d touching, %.2f points, %d apart without a point, s %.2Lg, deeper %.2Lg, left %.2Lg, off the surface %.2Lg\n",
        kinds.name, touching, static_cast<double>(points) / touching, missed, worst_s, worst_depth, worst_left, worst_surface);
}

/// Whatever the step before has left, of the same pair a little aside, of another pose, or nothing like it: what it says is a hint, which makes
/// no contact and hides none.
TEST_P(Pair, meets_the_oracle_whatever_was_before) {
    RandomInput random(1405);
    const Kinds kinds = GetParam();
    const scalar margin = scalar(0.05);
    int touching = 0, parted = 0;
    for (int i = 0; i < all_cases(kinds) / 4; ++i) {
        auto [A, B] = pair_of(kinds.a, kinds.b, random, i % 2 == 0 ? random.real(0.02, 0.2) : random.real(-0.3, 0.02));
        Manifold m{};
        collide(A, B, margin, m);
        // Into each other, out of each other, or turned.
        if (i % 4 < 3) A.r = to_vector(Eigen::Vector3d((exact(A.r) - (random.real(-0.1, 0.3) * exact(m.n))).cast<double>() + random.vector(0.02)));
        if (i % 4 == 2) A.A = to_matrix(Eigen::Matrix3d(exact(A.A).cast<double>() * turned(random.direction(), random.real(0, 0.3))));
        if (i % 4 == 3) m.n = to_vector(random.direction());
        const Manifold before = m;
        collide(A, B, margin, m, &m);
        const Convex a = oracle_of(A), b = oracle_of(B);
        const long double exact_s = signed_distance(a, b), size = size_of(A) + size_of(B);
        const Slack slack = slack_of(A, B);
        ASSERT_NEAR(static_cast<double>(exact(m.n).norm()), 1, 16 * u) << i;
        if (m.count == 0) {
            ++parted;
            ASSERT_GT(exact_s, -slack.separation) << i << " before " << before.count;
            continue;
        }
        ++touching;
        const long double s = least(m);
        ASSERT_LE(s, margin) << i;
        ASSERT_GE(s, exact_s - slack.depth - ingot::limits::axis_hysteresis * size) << i << " before " << before.count;
        ASSERT_LE(-signed_distance(a.moved(-s * exact(m.n)), b), slack.separation) << i;
    }
    EXPECT_GT(touching, all_cases(kinds) / 16);
    EXPECT_GT(parted, all_cases(kinds) / 64);
}

/// Swapped shapes of one kind: the same separations, and n the other way.
TEST_P(Pair, can_be_swapped) {
    const Kinds kinds = GetParam();
    if (kinds.a != kinds.b) GTEST_SKIP();
    RandomInput random(1402);
    for (int i = 0; i < cases(kinds); ++i) {
        const auto [A, B] = pair_of(kinds.a, kinds.b, random, random.real(-0.5, 0.05));
        Manifold m{}, w{};
        collide(A, B, scalar(0.05), m), collide(B, A, scalar(0.05), w);
        if (m.count == 0 || w.count == 0) continue;
        const double tolerance = static_cast<double>(slack_of(A, B).depth);
        ASSERT_NEAR(static_cast<double>(least(m)), static_cast<double>(least(w)), tolerance) << i;
    }
}

/// Both shapes moved and turned together: the same manifold, moved and turned.
TEST_P(Pair, moves_along) {
    RandomInput random(1403);
    const Kinds kinds = GetParam();
    int other_features = 0;
    for (int i = 0; i < cases(kinds); ++i) {
        const auto [A, B] = pair_of(kinds.a, kinds.b, random, random.real(-0.3, 0.04));
        const Eigen::Matrix3d T = random.rotation();
        const auto along = [&](PlacedShape s) {
            s.r = to_vector(Eigen::Vector3d(T * exact(s.r).cast<double>()));
            s.A = to_matrix(Eigen::Matrix3d(T * exact(s.A).cast<double>()));
            return s;
        };
        Manifold m{}, w{};
        collide(A, B, scalar(0.05), m), collide(along(A), along(B), scalar(0.05), w);
        if (m.count == 0 || w.count == 0) continue;
        const double size = size_of(A) + size_of(B) + 6;
        if (m.points[0].feature != w.points[0].feature || m.count != w.count) {
            ++other_features;
            ASSERT_NEAR(static_cast<double>(least(m)), static_cast<double>(least(w)), static_cast<double>(slack_of(A, B).depth))
                << i;
            continue;
        }
        // Directions that are searched for end within nearest_direction; round_accuracy is less.
        static_assert(ingot::limits::round_accuracy <= ingot::limits::nearest_direction);
        const double searched =
            has_kind(kinds, ShapeKind::hull) || has_kind(kinds, ShapeKind::cylinder) ? ingot::limits::nearest_direction : 0;
        ASSERT_NEAR(static_cast<double>(least(m)), static_cast<double>(least(w)), (64 * u + searched) * size) << i;
    }
    ASSERT_LT(other_features, cases(kinds) / 10);  // ties of shapes along the axes
}

/// Coincident centres, NaN, infinities, huge and tiny sizes: bounded time, at most four points, and a unit normal when finite.
TEST_P(Pair, survives_what_is_degenerate) {
    RandomInput random(1404);
    const Kinds kinds = GetParam();
    const double sizes[] = {1e-6, 1e-3, 1, 1e3, 1e6};
    for (int i = 0; i < 2000; ++i) {
        const auto sized = [&](ShapeKind kind) {
            Shape shape = shape_of(kind, random);
            const auto scale = static_cast<scalar>(sizes[random.integer(0, 4)]);
            const auto fit = [&](scalar x) {
                return std::min(std::max(x * scale, ingot::limits::size_min), ingot::limits::size_max);
            };
            shape.size = {fit(shape.size.x), shape.size.y > 0 ? fit(shape.size.y) : 0,
                          shape.size.z > 0 ? fit(shape.size.z) : 0};
            return shape;
        };
        PlacedShape A = placed(sized(kinds.a), {0, 0, 0}, orientation(random)),
                    B = placed(sized(kinds.b), {0, 0, 0}, orientation(random));
        give_hull(A, random), give_hull(B, random);
        if (i % 2 == 0) A.r = to_vector(Eigen::Vector3d(random.direction() * std::abs(random.of_any_size(-60, 3))));
        if (i % 5 == 1) A.r = B.r = {scalar(1e9), scalar(-1e9), scalar(1e9)};
        Manifold m{};
        collide(A, B, scalar(0.01), m);
        ASSERT_NEAR(static_cast<double>(exact(m.n).norm()), 1, 32 * u) << i;
        if (i % 2 != 0) {
            ASSERT_GT(m.count, 0) << i;
        }
        for (int k = 0; k < m.count; ++k)
            ASSERT_TRUE(ingot::is_finite(m.points[k].P) && ingot::is_finite(m.points[k].separation)) << i;

        scalar* numbers[] = {&A.r.x, &A.A.c0.y, &A.shape.size.x, &B.r.z, &B.A.c2.z, &B.shape.size.x};
        *numbers[random.integer(0, 5)] =
            i % 3 == 0 ? std::numeric_limits<scalar>::quiet_NaN() : std::numeric_limits<scalar>::infinity();
        Manifold bad{}, again{};
        collide(A, B, scalar(0.01), bad, &m);
        collide(A, B, scalar(0.01), again, &m);
        ASSERT_TRUE(bad.count >= 0 && bad.count <= 4) << i;
        ASSERT_EQ(bad.count, again.count);
    }
}

/// How far a point is outside a box or a cylinder, in closed form; 0 inside.
long double outside(const PlacedShape& s, const V& P) {
    const V p = exact(s.A).transpose() * (P - exact(s.r)), size = exact(s.shape.size);
    if (s.shape.kind == ShapeKind::box) return (p.cwiseAbs() - size).cwiseMax(0).norm();
    return std::hypot(std::max(std::hypot(p.x(), p.y()) - size.x(), 0.0L), std::max(std::abs(p.z()) - size.y(), 0.0L));
}

/// Rods up to 15 m long and 4 cm thick beside boxes of some centimetres: what touches is where the box is. In float the corners that the search for
/// nearest points keeps are all but in a plane, a triangle of them has weights to no more than epsilon (length / thickness)^2, and the rest
/// of the rod seemed to lie on both sides of the box: the point was a metre off.
TEST(Rod, is_touched_where_the_other_is) {
    RandomInput random(1405);
    int touching = 0;
    long double worst = 0;
    for (int i = 0; i < 4000; ++i) {
        const double radius = 0.02, half = std::exp(random.real(-1, 2)), gap = random.real(0.001, 0.015);
        const Eigen::Matrix3d T_A = orientation(random), T_B = orientation(random);
        PlacedShape A = placed(ingot::Box{{static_cast<scalar>(random.real(0.02, 0.08)), scalar(0.02), scalar(0.02)}}, {0, 0, 0}, T_A);
        const PlacedShape B = placed(ingot::Cylinder{static_cast<scalar>(radius), static_cast<scalar>(half)}, {0, 0, 0}, T_B);
        const double turn = random.real(0, 6.3);
        const Eigen::Vector3d aside = T_B * Eigen::Vector3d(std::cos(turn), std::sin(turn), 0);
        const double reach = exact(A.shape.size).cast<double>().dot((T_A.transpose() * aside).cwiseAbs());
        A.r = to_vector(Eigen::Vector3d(T_B.col(2) * (half * random.real(-0.9, 0.9)) + aside * (radius + reach + gap)));
        Manifold m{};
        ASSERT_TRUE(collide(A, B, scalar(0.02), m));
        if (m.count == 0) continue;  // edges and corners that are apart and not above each other
        ++touching;
        // Of the sixteen corners of an end, of what is nearly parallel, and of those weights: a difference of products of two sums of three has 18
        // roundings of length^4, for each of three weights, over the square of the area, and stands for a point as far away as the length.
        const long double prism = (1 - std::cos(3.14159265358979L / ingot::limits::cap_corners)) * radius;
        const long double weights = 3 * 18 * ingot::epsilon * (2 * half) * (2 * half) / (2 * radius);
        const long double slack = prism + (ingot::limits::round_aside + ingot::limits::corner_slack) * radius + weights;
        for (int k = 0; k < m.count; ++k) {
            const V P = exact(m.points[k].P), way = exact(m.n) * (static_cast<long double>(m.points[k].separation) / 2);
            const long double off = std::max(outside(A, P + way), outside(B, P - way));
            ASSERT_LE(off, slack) << i << " of half length " << half;
            worst = std::max(worst, off);
        }
    }
    std::printf("rods: %d touching, %.2Lg off the surface\n", touching, worst);
    ASSERT_GT(touching, 3000);
}

/// Over a face of a hull, wherever over it, a ball is as far as the plane is. A search that roundings end early may know the direction to no more
/// than ten-thousandths: along that a corner of the face, a metre away, seemed to be in the ball.
TEST(Ball, is_as_far_from_a_face_as_its_plane) {
    RandomInput random(1406);
    int over = 0;
    long double worst = 0;
    for (int i = 0; i < draws(100000); ++i) {
        const ingot::ConvexHull& hull = *hull_of(random);
        const ingot::HullFace& face = hull.faces[random.integer(0, hull.face_count - 1)];
        const std::uint8_t* loop = hull.loops + face.loop_first;
        const int k = random.integer(1, face.loop_count - 2);
        const V a = exact(hull.vertices[loop[0]]), b = exact(hull.vertices[loop[k]]), c = exact(hull.vertices[loop[k + 1]]);
        const V n = exact(face.n);
        double s = random.real(0, 1), t = random.real(0, 1);
        if (s + t > 1) s = 1 - s, t = 1 - t;
        const V on_face = a + (b - a) * static_cast<long double>(s) + (c - a) * static_cast<long double>(t);
        const double radius = std::exp(random.real(-3, 0)), gap = random.real(-0.1 * radius, 0.015);
        PlacedShape B = placed(ingot::Hull{hull.radius}, random.vector(3), orientation(random));
        B.hull = &hull;
        const V r = exact(B.r) + exact(B.A) * (on_face + n * static_cast<long double>(radius + gap));
        const PlacedShape A = placed(ingot::Sphere{static_cast<scalar>(radius)}, r.cast<double>());
        const long double height = (exact(B.A) * n).dot(exact(A.r) - exact(B.r)) - static_cast<long double>(face.offset) - exact(A.shape.size).x();
        Manifold m{};
        ASSERT_TRUE(collide(A, B, scalar(0.02), m));
        ASSERT_EQ(m.count, 1) << i;
        // What a search is content with, corners that are off the plane of their face, and roundings of the places.
        const long double size = static_cast<long double>(hull.radius) + static_cast<long double>(radius) + 3;
        const long double slack = static_cast<long double>(ingot::limits::nearest_accuracy) * static_cast<long double>(radius + gap) +
                                  static_cast<long double>(ingot::limits::hull_flatness * hull.radius) + 32 * ingot::epsilon * size;
        const long double off = std::abs(static_cast<long double>(m.points[0].separation) - height);
        EXPECT_LE(off, slack) << i << " of radius " << radius << ", gap " << gap;
        worst = std::max(worst, off);
        ++over;
    }
    std::printf("balls over faces: %.2Lg off\n", worst);
    EXPECT_EQ(over, draws(100000));
}

using K = ShapeKind;
INSTANTIATE_TEST_SUITE_P(
    All, Pair,
    ::testing::Values(Kinds{K::sphere, K::sphere, "sphere_sphere"}, Kinds{K::sphere, K::capsule, "sphere_capsule"},
                      Kinds{K::sphere, K::box, "sphere_box"}, Kinds{K::sphere, K::cylinder, "sphere_cylinder"},
                      Kinds{K::capsule, K::capsule, "capsule_capsule"}, Kinds{K::capsule, K::box, "capsule_box"},
                      Kinds{K::box, K::box, "box_box"}, Kinds{K::sphere, K::hull, "sphere_hull"},
                      Kinds{K::capsule, K::hull, "capsule_hull"}, Kinds{K::capsule, K::cylinder, "capsule_cylinder"},
                      Kinds{K::box, K::cylinder, "box_cylinder"}, Kinds{K::box, K::hull, "box_hull"},
                      Kinds{K::cylinder, K::cylinder, "cylinder_cylinder"}, Kinds{K::cylinder, K::hull, "cylinder_hull"},
                      Kinds{K::hull, K::hull, "hull_hull"}),
    [](const auto& of) { return std::string(of.param.name); });

}  // namespace
