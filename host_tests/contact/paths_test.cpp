// SPDX-License-Identifier: MIT
// Ways of fast bodies through a step, and when two of them meet: against closed forms, and against the distance of the shapes looked at along
// the way by an oracle that knows no kernel.
#include <gtest/gtest.h>
#include <ingot/base/limits.h>
#include <ingot/body/auxiliary.h>
#include <ingot/constraint/solver_view.h>
#include <ingot/continuous/next_impact.h>
#include <ingot/continuous/pair_contacts.h>
#include <ingot/continuous/pair_sub_world.h>
#include <ingot/continuous/parting_plane.h>
#include <ingot/continuous/time_of_impact.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

#include "collide/placed.h"
#include "scenes/hulls.h"
#include "stages/tiles.h"

namespace {

using namespace ingot_collide;
using Eigen::Vector3d;
using ingot::BodyPath;
using ingot::PathPoint;

constexpr double eps = static_cast<double>(ingot::epsilon);

Eigen::Matrix3d turn_by(const Vector3d& turn) { return turn.norm() > 0 ? turned(turn, turn.norm()) : Eigen::Matrix3d(Eigen::Matrix3d::Identity()); }
Vector3d in_double(const ingot::Vector& v) { return exact(v).cast<double>(); }

TEST(Path, goes_from_its_begin_to_its_end_by_a_parabola_and_a_steady_turn) {
    RandomInput random(1461);
    for (int i = 0; i < 300; ++i) {
        const double from = random.real(0, 0.6), until = from + random.real(0.2, 0.4), time = until - from;
        const Vector3d fall = random.vector(0.3), turn = random.vector(0.5), away = random.vector(2);
        const Eigen::Matrix3d A = random.rotation();
        // The turns at both ends are somewhat off the steady one, as those of a body that precesses are.
        const Vector3d off = i % 2 == 0 ? random.vector(0.02) : Vector3d(Vector3d::Zero());
        const PathPoint begin = {to_vector(random.vector(2)), {}, to_vector(Vector3d(turn + off)), to_matrix(A)};
        const PathPoint end = {to_vector(Vector3d(in_double(begin.r_CM) + away)),
                               {},
                               to_vector(Vector3d(turn + off / 2)),
                               to_matrix(Eigen::Matrix3d(turn_by(turn * time) * A))};
        BodyPath path{};
        ingot::lay_path(begin, static_cast<scalar>(from), end, static_cast<scalar>(until), to_vector(fall), path);
        EXPECT_EQ(path.next, ingot::never);
        for (const double share : {0.0, 0.25, 0.5, 1.0}) {
            const double u = time * share;
            const ingot::PathFrame at = ingot::frame_on_path(path, static_cast<scalar>(from + u));
            // r = begin + u (way + u fall) with r(time) = end: the way is away / time - fall time.
            const Vector3d r = in_double(begin.r_CM) + u * (away / time - fall * time + u * fall);
            EXPECT_LE((in_double(at.r_CM) - r).norm(), 64 * eps) << i << " at " << share;
            // The turn that is off by d = off time is put right by a vector that is added to it: to |turn| |d| / 2, half the commutator of
            // the two, and d^2. A turn by x is sqrt(2) x in Frobenius' norm.
            const Eigen::Matrix3d A_at = turn_by(turn * u) * A;
            const double d = off.norm() * time, allowed = std::sqrt(2.0) * (turn.norm() * time * d / 2 + d * d) + 64 * eps;
            EXPECT_LE((exact(at.A).cast<double>() - A_at).norm(), allowed) << i << " at " << share;
        }
    }
}

TEST(Path, of_a_body_that_turns_far_ends_where_it_has_turned_by_an_angle) {
    const double part = static_cast<double>(ingot::limits::angle_per_path), parts_max = ingot::limits::path_parts_max;
    for (const double angle : {0.1 * part, 0.99 * part, 1.5 * part, 3.0 * part, parts_max * part, 2 * parts_max * part}) {
        for (const double from : {0.0, 0.3, 0.75}) {
            const double most = std::max(part, angle / parts_max), left = angle * (1 - from);
            const double end = left > most ? from + most / angle : 1;
            EXPECT_NEAR(
                static_cast<double>(ingot::end_of_path({0, static_cast<scalar>(angle), 0}, static_cast<scalar>(from), ingot::limits::angle_per_path)),
                end, 16 * eps)
                << angle;
        }
    }
}

/// The only shape of the body that goes this path.
ingot::ShapeOnPath on(const BodyPath& path, const Shape& shape) { return {path, shape, nullptr, nullptr, bounding_radius(shape)}; }
scalar least_half_extent(const Shape& shape) { return ingot::least_half_extent(shape, nullptr); }
scalar time_of_impact(const ingot::ShapeOnPath& A, const ingot::ShapeOnPath& B, scalar latest = 1) {
    return ingot::time_of_impact(A, B, {1, 0, latest, 0}).t;
}

/// A sphere, a capsule or a box of 0.1 to 0.5 m.
Shape any_shape(RandomInput& random) {
    const auto length = [&] { return static_cast<scalar>(random.real(0.1, 0.5)); };
    switch (random.integer(0, 2)) {
        case 0: return ingot::Sphere{length()};
        case 1: {
            const scalar radius = length();
            return ingot::Capsule{radius, 4 * length()};  // its rim is beyond 1 m, where the square of a spin counts for more than the spin
        }
        default: {
            const scalar x = length(), y = length();
            return ingot::Box{{x, y, 3 * length()}};
        }
    }
}

/// Towards the origin, nearly, from some metres away, and beyond it; `from` is when it begins.
BodyPath any_path(RandomInput& random, double from, double side) {
    BodyPath path{};
    const Vector3d begin = side * Vector3d(2, 0, 0) + random.vector(0.4), end = -side * random.real(0, 1.5) * Vector3d(1, 0, 0) + random.vector(0.6);
    path.r_CM = to_vector(begin);
    path.A = to_matrix(random.rotation());
    path.fall = to_vector(Vector3d(0, 0, -random.real(0, 0.5)));
    path.way = to_vector(Vector3d((end - begin) / (1 - from)));
    path.turn = to_vector(Vector3d(random.direction() * random.real(0, 2)));
    path.from = static_cast<scalar>(from);
    path.until = 1;
    path.next = ingot::never;
    return path;
}

/// Where the path has the shape, by its definition.
PlacedShape place_at(const BodyPath& path, const Shape& shape, double t) {
    const double u = t - static_cast<double>(path.from);
    PlacedShape s = placed(shape);
    s.r = to_vector(Vector3d(in_double(path.r_CM) + u * (in_double(path.way) + u * in_double(path.fall))));
    s.A = to_matrix(Eigen::Matrix3d(turn_by(in_double(path.turn) * u) * exact(path.A).cast<double>()));
    return s;
}
double gap_at(const BodyPath& path_A, const Shape& A, const BodyPath& path_B, const Shape& B, double t) {
    return static_cast<double>(ingot_oracle::signed_distance(oracle_of(place_at(path_A, A, t)), oracle_of(place_at(path_B, B, t))));
}

/// Where two shapes have met, but for roundings.
double meeting_gap(const Shape& A, const Shape& B) {
    const scalar least = std::min(least_half_extent(A), least_half_extent(B));
    return std::min(static_cast<double>(ingot::limits::impact_gap * least), static_cast<double>(ingot::limits::impact_gap_max));
}

TEST(TimeOfImpact, is_when_the_shapes_meet_and_never_later) {
    RandomInput random(1462);
    int met = 0, passed = 0, ruled_out = 0, early = 0;
    for (int i = 0; i < 400; ++i) {
        const double from_A = i % 3 == 0 ? random.real(0, 0.5) : 0, from_B = i % 3 == 1 ? random.real(0, 0.5) : 0, begin = std::max(from_A, from_B);
        const Shape A = any_shape(random), B = any_shape(random);
        BodyPath path_A = any_path(random, from_A, 1), path_B = any_path(random, from_B, -1);
        if (i % 10 == 9) path_B.r_CM.y += 6;  // well beside it
        if (i % 4 == 3) {                     // each is drawn towards the other, or away from it
            const scalar pull = i % 8 == 3 ? scalar(1) : scalar(-1);
            path_A.fall.x -= pull;
            path_B.fall.x += pull;
        }
        const auto gap = [&](double t) { return gap_at(path_A, A, path_B, B, t); };
        // Both move and turn by less than `speed` in a step, so between two looks the gap changes by no more than speed / looks.
        constexpr int looks = 200;
        double least_before = gap(begin), first = 2, least = least_before;
        for (int k = 1; k <= looks; ++k) {
            const double t = begin + (1 - begin) * k / looks;
            least = std::min(least, gap(t));
            if (first > 1 && least < 0) first = t;
        }
        if (least_before < 0.05) continue;
        const double roundings = 64 * eps * 4, near = meeting_gap(A, B) + roundings;
        const double t = static_cast<double>(time_of_impact(on(path_A, A), on(path_B, B)));
        const bool may = ingot::may_meet(on(path_A, A), on(path_B, B), 1);
        ruled_out += may ? 0 : 1;
        if (first <= 1) {
            EXPECT_TRUE(may) << i;
            EXPECT_LE(t, first + 1e-5) << i;
        }
        if (t > 1) {
            ++passed;
            EXPECT_EQ(t, ingot::never);
            EXPECT_GE(least, -roundings) << i;
            continue;
        }
        ++met;
        EXPECT_GE(t, begin);
        early += gap(t) > near ? 1 : 0;  // after limits::approaches_max they are taken for met where they are
        EXPECT_GE(gap(t), -roundings) << i << ": and no further";
        // No look before it saw them overlap, and with a deadline before it nothing is met.
        EXPECT_GE(first, t - 1e-5) << i;
        EXPECT_EQ(time_of_impact(on(path_A, A), on(path_B, B), static_cast<scalar>(begin + (t - begin) * 0.9)), ingot::never);
    }
    EXPECT_GT(met, 150);
    EXPECT_LE(early, met / 50) << "and they have come together";
    EXPECT_GT(passed, 30);
    EXPECT_GT(ruled_out, 5);
}

/// Two balls on a line: the time is a closed form, with gravity too.
TEST(TimeOfImpact, of_balls_is_that_of_the_parabola) {
    for (const double fall : {0.0, 0.5, 2.0}) {
        for (const double from : {0.0, 0.25}) {
            BodyPath path_A{}, path_B{};
            path_A.A = path_B.A = ingot::identity_matrix<scalar>();
            path_A.r_CM = {0, 0, 2};
            path_A.way = {0, 0, -1}, path_A.fall = {0, 0, static_cast<scalar>(-fall)};
            path_A.from = static_cast<scalar>(from);
            path_A.until = path_B.until = 4;
            const double t = static_cast<double>(time_of_impact(on(path_A, ingot::Sphere{scalar(0.5)}), on(path_B, ingot::Sphere{scalar(0.25)}), 4));
            // 2 - u - fall u^2 = 0.75
            const double u = fall > 0 ? (-1 + std::sqrt(1 + 5 * fall)) / (2 * fall) : 1.25, speed = 1 + 2 * fall * u;
            EXPECT_LE(t, from + u + 1e-6);
            EXPECT_GE(t, from + u - (static_cast<double>(ingot::limits::impact_gap_max) + 64 * eps) / speed - 1e-6) << fall << " " << from;
        }
    }
}

/// Balls of millimetres: the gap in which they have met is a fraction of their size, not of a metre.
TEST(TimeOfImpact, of_small_balls_is_at_a_gap_as_small) {
    for (const double radius : {0.0005, 0.002, 0.01, 0.05}) {
        BodyPath path_A{}, path_B{};
        path_A.A = path_B.A = ingot::identity_matrix<scalar>();
        path_A.r_CM = {0, 0, scalar(0.25)};
        path_A.way = {0, 0, scalar(-0.5)};
        path_A.until = path_B.until = 1;
        const Shape A = ingot::Sphere{static_cast<scalar>(radius)}, B = ingot::Sphere{static_cast<scalar>(2 * radius)};
        const double t = static_cast<double>(time_of_impact(on(path_A, A), on(path_B, B))), meets = (0.25 - 3 * radius) / 0.5;
        // Positions of up to 0.25 m are rounded, each some times; t, which is below 1, itself.
        const double roundings = 16 * eps;
        EXPECT_LE(t, meets + roundings) << radius;
        EXPECT_GE(t, meets - meeting_gap(A, B) / 0.5 - roundings) << radius;
    }
}

/// A rod of a kilometre, across the way of a ball: its nearest point is known to the rounding of its length, which is what the gap has to make up
/// for. Along the way all lengths are below 1 m, so that the time itself is known to some roundings.
TEST(TimeOfImpact, of_a_long_rod_is_not_later_for_its_length) {
    for (const double half : {1.0, 30.0, 1000.0}) {
        for (const bool rod_first : {true, false}) {
            const Shape rod = ingot::Capsule{scalar(0.0625), static_cast<scalar>(half)}, ball = ingot::Sphere{scalar(0.125)};
            BodyPath path_A{}, path_B{};
            path_A.A = path_B.A = ingot::identity_matrix<scalar>();
            (rod_first ? path_A : path_B).A = {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};  // its axis along x
            path_A.r_CM = {0, 0, 1};
            path_A.way = {0, 0, -1};
            path_A.until = path_B.until = 1;
            const Shape &A = rod_first ? rod : ball, &B = rod_first ? ball : rod;
            const double t = static_cast<double>(time_of_impact(on(path_A, A), on(path_B, B))), meets = 1 - 0.1875;
            EXPECT_LE(t, meets + 8 * eps) << half;
            EXPECT_GE(t, meets - meeting_gap(A, B) - 4 * eps * (half + 4)) << half;
        }
    }
}

/// Two shapes side by side along n, `deep` m in each other (apart where it is negative): the distance of their centres, by the oracle.
double distance_at(const BodyPath& path_A, const Shape& A, const BodyPath& path_B, const Shape& B, const Vector3d& n, double deep) {
    double low = 0, high = 4;
    for (int i = 0; i < 60; ++i) {
        BodyPath moved = path_A;
        const double middle = (low + high) / 2;
        moved.r_CM = to_vector(Vector3d(in_double(path_B.r_CM) + n * middle));
        (gap_at(moved, A, path_B, B, 0) < -deep ? low : high) = middle;
    }
    return high;
}

/// Shapes that touch at the begin, or are in each other by up to most of the thinner one. Before the time that is told nobody gets deeper than a
/// skin, or than at the begin, whichever way they go and turn. And who parts is not stopped.
TEST(TimeOfImpact, of_shapes_that_touch_is_when_they_would_get_deeper) {
    RandomInput random(1465);
    int met = 0, passed = 0, parted = 0;
    for (int i = 0; i < 600; ++i) {
        const Shape A = any_shape(random), B = any_shape(random);
        const double least = static_cast<double>(std::min(least_half_extent(A), least_half_extent(B)));
        const double skin = static_cast<double>(ingot::limits::skin_share) * least, near = meeting_gap(A, B), roundings = 64 * eps * 4;
        BodyPath path_A{}, path_B{};
        for (BodyPath* path : {&path_A, &path_B}) {
            path->A = to_matrix(random.rotation());
            path->turn = to_vector(Vector3d(random.direction() * random.real(0, 1)));
            path->until = 1;
        }
        const Vector3d n = random.direction();
        const double deep = i % 3 == 0 ? 0 : random.real(0, i % 3 == 1 ? skin : 0.7 * least);
        path_A.r_CM = to_vector(Vector3d(n * distance_at(path_A, A, path_B, B, n, deep)));
        path_A.way = to_vector(Vector3d(random.direction() * random.real(0, 2)));
        const auto gap = [&](double t) { return gap_at(path_A, A, path_B, B, t); };
        const PlacedShape at_A = place_at(path_A, A, 0), at_B = place_at(path_B, B, 0);
        const ingot::PartingPlane parting = ingot::parting_plane(at_A, at_B, ingot::closest_points(at_A, at_B));
        if (!parting.found) continue;
        const double deep_as_seen = -static_cast<double>(parting.plane.gap), allowed = std::max(skin, deep_as_seen) + near + roundings;
        EXPECT_GE(deep_as_seen, deep - roundings) << i << ": no direction parts them by less";
        const ingot::TimeOfImpact impact = ingot::time_of_impact(on(path_A, A), on(path_B, B), {1, 0, 1, 0});
        EXPECT_TRUE(impact.touched) << i;
        const double t = static_cast<double>(impact.t), end = std::min(t, 1.0);
        constexpr int looks = 100;
        for (int k = 0; k <= looks; ++k) {
            const double depth = -gap(end * k / looks);
            EXPECT_LE(depth, allowed) << i << " at " << end * k / looks << " of " << t;
        }
        (t > 1 ? passed : met) += 1;
        if (t > 1 && gap(1) > near) ++parted;
    }
    EXPECT_GT(met, 100);
    EXPECT_GT(passed, 50);
    EXPECT_GT(parted, 30);
}

/// A cube is parted from a ball that is in its skin by the same plane whether it is given as a box or as a hull.
TEST(PartingPlane, of_a_cube_is_that_of_a_hull_that_is_one) {
    RandomInput random(1466);
    const ingot::ConvexHull cube = scenes::cube_hull.hull.value.view();  // of half a metre to each side
    for (int i = 0; i < 1000; ++i) {
        const Shape B = ingot::Sphere{static_cast<scalar>(random.real(0.1, 0.5))};
        const PlacedShape as_box = placed(ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}}, Vector3d::Zero(), random.rotation());
        PlacedShape as_hull = as_box;
        as_hull.shape = ingot::Hull{1};
        as_hull.hull = &cube;
        BodyPath path_A{}, path_B{};
        path_A.A = as_box.A;
        path_B.A = to_matrix(random.rotation());
        const Vector3d n = random.direction();
        path_A.r_CM = to_vector(Vector3d(n * distance_at(path_A, as_box.shape, path_B, B, n, random.real(0, 0.1))));
        PlacedShape at_box = as_box, at_hull = as_hull;
        at_box.r = at_hull.r = path_A.r_CM;
        const PlacedShape at_B = place_at(path_B, B, 0);
        const ingot::PartingPlane of_box = ingot::parting_plane(at_box, at_B, ingot::closest_points(at_box, at_B));
        const ingot::PartingPlane of_hull = ingot::parting_plane(at_hull, at_B, ingot::closest_points(at_hull, at_B));
        ASSERT_TRUE(of_box.found && of_hull.found) << i;
        // Of places of a metre, on the way to a direction that is known by what the cube without its skin is apart.
        EXPECT_NEAR(static_cast<double>(of_hull.plane.gap), static_cast<double>(of_box.plane.gap), 32 * eps) << i;
    }
}

/// A ball below a box, touching it: what is told is when the box has come down to a skin, by its way or by its turn. Where contacts have seen to them
/// up to some gap, they count as touching up to it.
TEST(TimeOfImpact, of_bodies_that_touch_is_a_skin_later) {
    const Shape box = ingot::Box{{1, 1, scalar(0.5)}}, ball = ingot::Sphere{scalar(0.25)};
    const double skin = static_cast<double>(ingot::limits::skin_share) * 0.25, lever = 0.75, gap = meeting_gap(box, ball) + 64 * eps;
    for (const double from : {0.0, 0.25, 0.75}) {
        for (const bool box_first : {true, false}) {
            for (const bool turns : {false, true}) {
                for (const double share : {-1.1, 0.9, 1.5}) {
                    for (const double apart : {0.0, 4 * gap}) {
                        // A ball right below a box, beside its middle. The box comes down, or turns so that this end of it does.
                        BodyPath of_box{}, of_ball{};
                        of_box.A = of_ball.A = ingot::identity_matrix<scalar>();
                        of_ball.r_CM = {static_cast<scalar>(lever), 0, static_cast<scalar>(-0.75 - apart)};
                        const double closing = share * (skin + apart) / (1 - from);
                        if (turns)
                            of_box.turn = {0, static_cast<scalar>(closing / lever), 0};
                        else
                            of_box.way = {0, 0, static_cast<scalar>(-closing)};
                        of_box.until = of_ball.until = 1;
                        of_box.from = static_cast<scalar>(from);
                        const BodyPath &path_A = box_first ? of_box : of_ball, &path_B = box_first ? of_ball : of_box;
                        const Shape &A = box_first ? box : ball, &B = box_first ? ball : box;
                        const scalar touch = static_cast<scalar>(2 * apart);
                        const ingot::TimeOfImpact impact = ingot::time_of_impact(on(path_A, A), on(path_B, B), {1, 0, 1, touch});
                        SCOPED_TRACE(::testing::Message() << "from " << from << ", box " << (box_first ? "first" : "second")
                                                          << (turns ? ", turns, " : ", falls, ") << share << ", " << apart);
                        EXPECT_TRUE(impact.touched);
                        const double t = static_cast<double>(impact.t);
                        if (share < 1) {
                            EXPECT_EQ(impact.t, ingot::never);
                        } else {
                            EXPECT_NEAR(t, from + (1 - from) / share, (1 - from) * (gap + 0.02 * skin) / (skin + apart));  // the turn is a sine
                        }
                        if (apart > 0) {
                            EXPECT_FALSE(ingot::time_of_impact(on(path_A, A), on(path_B, B), {1, 0, 1, 0}).touched);
                        }
                    }
                }
            }
        }
    }
}

/// A plate that is edge on in a ball from the begin, deeper than all skins: it may get no deeper. Where even its middle is inside nothing is met.
TEST(TimeOfImpact, of_a_plate_deep_in_a_ball_is_at_once_or_never) {
    const double gap = static_cast<double>(ingot::limits::impact_gap_max) + 64 * eps;
    const auto time_of = [&](double distance, double way) {
        BodyPath path_A{}, path_B{};
        path_A.A = path_B.A = ingot::identity_matrix<scalar>();
        path_A.r_CM = {0, 0, static_cast<scalar>(distance)};
        path_A.way = {0, 0, static_cast<scalar>(way)};
        path_A.until = path_B.until = 1;
        return static_cast<double>(time_of_impact(on(path_A, ingot::Box{{1, scalar(0.125), 1}}), on(path_B, ingot::Sphere{1})));
    };
    EXPECT_LE(time_of(1.3, -0.5), gap / 0.5);
    EXPECT_EQ(time_of(1.3, 0.5), static_cast<double>(ingot::never)) << "they part";
    EXPECT_EQ(time_of(0.9, -0.5), static_cast<double>(ingot::never)) << "its middle is inside: contacts see to it";
}

TEST(Path, of_a_body_has_a_half_extent_of_its_shape) {
    EXPECT_EQ(least_half_extent(ingot::Sphere{2}), 2);
    EXPECT_EQ(least_half_extent(ingot::Capsule{2, 1}), 2);
    EXPECT_EQ(least_half_extent(ingot::Cylinder{2, 3}), 2);
    EXPECT_EQ(least_half_extent(ingot::Cylinder{3, 2}), 2);
    for (const ingot::Vector& size : {ingot::Vector{1, 2, 3}, ingot::Vector{2, 1, 3}, ingot::Vector{2, 3, 1}})
        EXPECT_EQ(least_half_extent(ingot::Box{size}), 1);
    // Of a hull that is a cube, as that of the cube; of a tetrahedron the radius of a ball about the mean of its corners, (1, 1, 1) / 4.
    const ingot::ConvexHull cube = scenes::cube_hull.hull.value.view(), tetrahedron = scenes::tetrahedron_hull.hull.value.view();
    EXPECT_NEAR(static_cast<double>(ingot::least_half_extent(ingot::Hull{1}, &cube)), 0.5, 4 * eps);
    EXPECT_NEAR(static_cast<double>(ingot::least_half_extent(ingot::Hull{1}, &tetrahedron)), 0.25 / std::sqrt(3.0), 4 * eps);
    EXPECT_EQ(least_half_extent(ingot::HalfSpace{{0, 0, 1}, 0}), ingot::limits::unbounded);
    EXPECT_EQ(least_half_extent(Shape{}), ingot::limits::unbounded);
}

TEST(Path, is_fast_by_way_and_turn_and_not_when_it_is_no_number) {
    const ingot::BodyExtent box = {1, 1, 1};
    const scalar enough = ingot::limits::fast_share, nan = std::numeric_limits<scalar>::quiet_NaN(),
                 infinity = std::numeric_limits<scalar>::infinity();
    const auto fast = [&](const ingot::Vector& way, const ingot::Vector& fall, const ingot::Vector& turn, scalar from) {
        BodyPath path{};
        path.way = way, path.fall = fall, path.turn = turn, path.from = from, path.until = 1;
        return ingot::is_fast_path(path, box);
    };
    EXPECT_TRUE(fast({enough * 2, 0, 0}, {}, {}, 0));
    EXPECT_FALSE(fast({enough / 2, 0, 0}, {}, {}, 0));
    EXPECT_FALSE(fast({enough * scalar(1.5), 0, 0}, {}, {}, scalar(0.5))) << "half of the step is left";
    EXPECT_TRUE(fast({}, {0, 0, enough * 2}, {}, 0));
    EXPECT_TRUE(fast({}, {}, {0, enough * 2, 0}, 0)) << "a point of the rim";
    EXPECT_FALSE(fast({}, {}, {0, enough / 2, 0}, 0));
    for (const scalar bad : {nan, infinity}) {
        EXPECT_FALSE(fast({bad, 0, 0}, {}, {}, 0));
        EXPECT_FALSE(fast({enough * 2, 0, 0}, {}, {0, 0, bad}, 0));
    }
}

/// Before a step: where bodies are, how they go on by their velocities, and nobody is met yet.
TEST(Path, begins_with_the_motion_of_its_body) {
    constexpr scalar h = scalar(1) / 64;
    constexpr int slots = ingot::lanes + 3;
    RandomInput random(1464);
    for (int i = 0; i < 20; ++i) {
        ingot_stages::Tiles tiles(slots);
        ingot::Surface surfaces[slots] = {};
        ingot::BodyState states[slots];
        Vector3d omegas[slots];
        bool fast[slots];
        for (int slot = 0; slot < slots; ++slot) {
            // Boxes of 2 m, as balls turn: they get beyond their size by their way, by their turn, by both together, or not.
            const int kind = random.integer(0, 3);
            const double travel = kind == 0 ? 1.1 : kind == 1 ? 0 : kind == 2 ? 0.55 : 0.4, spin = (kind == 1 ? 1.1 : kind == 2 ? 0.55 : 0.4) / 2;
            ingot::BodyDef def = ingot_reference::definition(1, Vector3d(2 * Vector3d::Ones()));
            def.immovable = i % 3 == 0 && slot == 1;
            omegas[slot] = def.immovable ? Vector3d(Vector3d::Zero()) : Vector3d(random.direction() * (spin * 64));
            states[slot] = {to_vector(random.vector(2)), to_vector(Vector3d(random.direction() * (travel * 64))), to_matrix(random.rotation()),
                            to_vector(Vector3d(2 * omegas[slot]))};
            if (def.immovable) states[slot].v_CM = states[slot].L = {};
            def.state = states[slot];
            tiles.write(slot, def);
            states[slot] = tiles.state(slot);  // A is made orthonormal
            fast[slot] = kind != 3 && !def.immovable;
            surfaces[slot].shape = ingot::Box{{1, 1, 1}};
            surfaces[slot].bounding_radius = 2;
        }
        ingot::refresh_inv_I_world(tiles.view());
        BodyPath paths[slots];
        std::memset(static_cast<void*>(paths), 0x5a, sizeof paths);  // of the step before
        const ingot::BodyShapes shapes = {{surfaces, slots}, nullptr, {}, 1};
        for (int slot = 0; slot < slots; ++slot) {
            paths[slot].fast = ingot::begins_fast(tiles.view(), shapes, h, slot);
            ingot::begin_path(tiles.view(), h, slot, paths[slot]);
        }
        for (int slot = 0; slot < slots; ++slot) {
            const BodyPath& path = paths[slot];
            EXPECT_EQ(exact(path.r_CM), exact(states[slot].r_CM));
            EXPECT_EQ(exact(path.A), exact(states[slot].A));
            EXPECT_EQ(exact(path.v_CM), exact(states[slot].v_CM));
            EXPECT_EQ(exact(path.L), exact(states[slot].L));
            EXPECT_EQ(exact(path.way), V(exact(states[slot].v_CM) * static_cast<long double>(h))) << "h is a power of two";
            EXPECT_LE((in_double(path.turn) - omegas[slot] / 64).norm(), 64 * eps) << slot;
            EXPECT_EQ(exact(path.fall), V(V::Zero()));
            EXPECT_EQ(path.from, 0);
            EXPECT_EQ(path.until, 1);
            EXPECT_EQ(path.next, ingot::never);
            EXPECT_EQ(path.fast, fast[slot]) << slot;
        }
    }
}

/// No method follows a body that turns by hundreds of radians in a step: its path does so by 500.
TEST(Path, turns_by_no_more_than_it_can) {
    const PathPoint begin = {{}, {}, {0, 0, 2000}, ingot::identity_matrix<scalar>()};
    BodyPath path{};
    ingot::lay_path(begin, 0, begin, 1, {}, path);
    EXPECT_NEAR(static_cast<double>(path.turn.z), 500, 2) << "and what that leaves to A, at most half a turn's sine";
    EXPECT_TRUE(ingot::is_finite(path.turn));
}

/// A state that is no number is not put: the body keeps the one it has, and is marked.
TEST(PairSubWorld, refuse_a_state_that_is_no_number) {
    constexpr scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    RandomInput random(1463);
    for (int bad = 0; bad < 5; ++bad) {
        ingot_stages::Tiles tiles(ingot::lanes + 2);
        constexpr int slot = ingot::lanes + 1;
        ingot::BodyDef def = ingot_reference::definition(1, Vector3d::Ones());
        def.state = {to_vector(random.vector(1)), to_vector(random.vector(1)), to_matrix(random.rotation()), to_vector(random.vector(1))};
        tiles.write(slot, def);
        tiles.rotation(slot).kicked = 0;
        const ingot::FlightState before = ingot::flight_state(tiles.view(), slot);
        ingot::FlightState next = {to_vector(random.vector(1)), to_vector(random.vector(1)), to_vector(random.vector(1)),
                                   to_matrix(random.rotation())};
        (bad == 0 ? next.r_CM.y : bad == 1 ? next.v_CM.z : bad == 3 ? next.A.c1.z : next.L.x) = bad < 4 ? nan : scalar(0.25);
        ingot::BodyView view = tiles.view();
        if (bad == 3) view.compensation = nullptr;
        ingot::put_state(view, slot, next);
        const ingot::FlightState after = ingot::flight_state(tiles.view(), slot);
        const ingot::FlightState& expected = bad < 4 ? before : next;
        EXPECT_EQ(exact(after.r_CM), exact(expected.r_CM));
        EXPECT_EQ(exact(after.v_CM), exact(expected.v_CM));
        EXPECT_EQ(exact(after.L), exact(expected.L));
        EXPECT_EQ(exact(after.A), exact(expected.A));
        const unsigned bit = 1u << (slot % ingot::lanes);
        EXPECT_EQ(tiles.rotation(slot).bad, bad < 4 ? bit : 0u);
        EXPECT_EQ(tiles.rotation(slot).kicked, bad < 4 ? 0u : bit);
        view.compensation = nullptr;
        ingot::put_state(view, slot, before);  // a scene that keeps no low digits
        EXPECT_EQ(exact(ingot::flight_state(tiles.view(), slot).A), exact(before.A));
    }
}

/// Places 0 and 1 press on each other where any of the points of their manifolds has an impulse. What is left of points before does not count, nor
/// what carries the one on something fixed.
TEST(PairContacts, press_on_each_other_where_a_point_carries) {
    static ingot::PairContacts<3, 3, ingot::SolverView> contacts;
    ingot::Index lost = 0;
    for (int at = 0; at < 2; ++at) {
        for (int count = 0; count <= 4; ++count) {
            for (unsigned carrying = 0; carrying < 16; ++carrying) {
                contacts.count = 0;
                ingot::Manifold manifold{};
                manifold.count = static_cast<int8_t>(count);
                for (int i = 0; i < 2; ++i) contacts.take(manifold, {{0}, {i}}, {0, 1, ingot::no_record}, lost);
                contacts.take(manifold, {{0}, {2}}, {0, 2, ingot::no_record}, lost);
                EXPECT_FALSE(contacts.carries(0, 1));
                for (int point_i = 0; point_i < 4; ++point_i) {
                    contacts.records[at].j[point_i] = (carrying >> point_i & 1u) != 0 ? scalar(0.5) : 0;
                    contacts.records[2].j[point_i] = 1;
                }
                EXPECT_EQ(contacts.carries(0, 1), (carrying & ((1u << count) - 1u)) != 0) << count << " points, " << carrying;
            }
        }
    }
    EXPECT_EQ(lost, 0);
}

/// Where there is no room the deepest are kept, in the order of their shapes, whatever order they come in; of those as deep the lower.
TEST(PairContacts, keep_the_deepest) {
    using Contacts = ingot::PairContacts<3, 3, ingot::SolverView>;
    static Contacts contacts;
    int order[5] = {0, 1, 2, 3, 4};
    for (const bool all_alike : {false, true}) {
        std::sort(order, order + 5);
        do {
            contacts.count = 0;
            ingot::Index lost = 0;
            for (const int number : order) {
                ingot::Manifold manifold{};
                manifold.count = 1;
                manifold.points[0].separation = all_alike ? scalar(-1) : static_cast<scalar>(-number);
                contacts.take(manifold, {{number}, {0}}, {0, 2, ingot::no_record}, lost);
            }
            EXPECT_EQ(contacts.count, 3);
            EXPECT_EQ(lost, 2);
            for (int i = 0; i < 3; ++i) EXPECT_EQ(contacts.shapes[i].A.number, all_alike ? i : i + 2);
            EXPECT_EQ(contacts.find({{2}, {0}}), all_alike ? 2 : 0);
            EXPECT_EQ(contacts.find({{2}, {1}}), -1);
        } while (std::next_permutation(order, order + 5));
    }
}

/// Who meets something first comes first, whatever order times come and change in; of two at the same time the lower slot.
TEST(FollowedBodies, come_in_the_order_of_time) {
    constexpr int slots = 40;
    RandomInput random(1466);
    for (int round = 0; round < 40; ++round) {
        BodyPath paths[slots] = {};
        ingot::Index queue[slots];
        ingot::FollowedBodies bodies = {paths, queue, 0, 0};
        EXPECT_EQ(bodies.first(), -1);
        for (int change = 0; change < 200; ++change) {
            const int slot = random.integer(0, slots - 1);
            paths[slot].next = random.integer(0, 4) == 0 ? ingot::never : static_cast<scalar>(random.integer(0, 20)) / 20;
            bodies.follow(slot);
            bodies.move(slot);
            paths[random.integer(0, slots - 1)].next = 0;  // what has not been moved yet does not count
            int first = -1;
            for (int i = 0; i < slots; ++i)
                if (paths[i].is_followed && paths[i].due <= 1 && (first < 0 || paths[i].due < paths[first].due)) first = i;
            ASSERT_EQ(bodies.first(), first);
        }
    }
}

/// A ball shows nothing of its turn, what is round nothing of that about its axis; whatever has several shapes, or edges, shows all.
/// Who has another path now is told once, in the order in which it came, and nobody else, whatever stands in the places that are free.
TEST(ChangedPaths, are_told_once_each) {
    RandomInput random(1479);
    for (int i = 0; i < 1000; ++i) {
        ingot::ChangedPaths changed = {{-1, -1, -1, -1}, 0};
        std::vector<int> expected;
        for (int times = random.integer(0, 8); times > 0; --times) {
            const int slot = random.integer(0, ingot::ChangedPaths::room - 1);
            const bool is_new = std::find(expected.begin(), expected.end(), slot) == expected.end();
            EXPECT_EQ(changed.has(slot), !is_new);
            changed.add(slot);
            if (is_new) expected.push_back(slot);
        }
        EXPECT_FALSE(changed.has(-1));
        std::vector<int> told;
        changed.over_all([&told](int slot) { told.push_back(slot); });
        EXPECT_EQ(told, expected);
    }
}

TEST(Path, of_what_is_round_is_not_seen_to_turn_about_its_axis) {
    RandomInput random(1467);
    const Shape shapes[] = {ingot::Sphere{1}, ingot::Capsule{1, 2}, ingot::Cylinder{1, 2}, ingot::Box{{1, 2, 3}}};
    for (int i = 0; i < 40; ++i) {
        ingot::Surface surface{};
        surface.shape = shapes[i % 4];
        surface.bounding_radius = ingot::bounding_radius(surface.shape);
        ingot::ShapePlace place{};
        place.A = ingot::identity_matrix<scalar>();
        const ingot::Matrix A = to_matrix(random.rotation());
        const Vector3d turn = random.direction(), axis = in_double(A.c2);
        const Vector3d expected = i % 4 == 0 ? Vector3d(Vector3d::Zero()) : i % 4 == 3 ? turn : Vector3d(turn - axis * axis.dot(turn));
        EXPECT_LE((in_double(ingot::seen_turn({{&surface, 1}, nullptr, {}, 1}, 0, A, to_vector(turn))) - expected).norm(), 16 * eps) << i;
        EXPECT_LE((in_double(ingot::seen_turn({{&surface, 1}, &place, {}, 1}, 0, A, to_vector(turn))) - turn).norm(), eps) << i;
        const ingot::BodyExtent extent = ingot::extent_of({{&surface, 1}, nullptr, {}, 1}, 0);
        EXPECT_EQ(extent.reach, i % 4 == 0 ? 0 : extent.radius);
        EXPECT_EQ(ingot::extent_of({{&surface, 1}, &place, {}, 1}, 0).reach, extent.radius);
    }
}

/// How long two bodies move little against each other, whether one gets past its size, and how far apart they may be to touch: closed forms.
TEST(PairSubWorld, know_how_far_they_move_in_a_while) {
    const double h = 1.0 / 64;
    for (int case_i = 0; case_i < 5; ++case_i) {
        ingot_stages::Tiles tiles(2);
        ingot::Surface surfaces[2] = {};
        // Spins of 3 and 5 rad/s about z, moments of 2: L = 6 and 10; speeds of 7 m/s against each other; or hardly moving; or turning fast; or at
        // rest; or turning fast and thin.
        const double v = case_i == 0 ? 7 : case_i == 3 ? 0 : 0.001, size[2] = {0.5, 0.25};
        const double thin = case_i == 4 ? 1e-4 : 1, radius[2] = {0.75 * thin, thin};
        const bool turns_slowly = case_i == 0 || case_i == 1;
        const double spin[2] = {case_i == 3 ? 0 : turns_slowly ? 3.0 : 300.0, case_i == 3 ? 0 : turns_slowly ? 5.0 : 10.0};
        for (int which = 0; which < 2; ++which) {
            ingot::BodyDef def = ingot_reference::definition(1, Vector3d(2 * Vector3d::Ones()));
            def.state.v_CM = {0, static_cast<scalar>(which == 0 ? -v / 4 : 3 * v / 4), 0};  // against each other
            def.state.L = {0, 0, static_cast<scalar>(2 * spin[which])};
            tiles.write(which, def);
            const auto half = static_cast<scalar>(size[which]);
            surfaces[which].shape = ingot::Box{{half, half, half}};
            surfaces[which].bounding_radius = static_cast<scalar>(radius[which]);
        }
        static ingot::PairSubWorld<0> two;
        two.clear();
        for (int which = 0; which < 2; ++which) {
            BodyPath path{};
            ingot::begin_path(tiles.view(), static_cast<scalar>(h), which, path);
            two.take(tiles.view(), {{surfaces, 2}, nullptr, {}, 1}, which, path);
        }
        const ingot::Movers room = two.movers();
        const double near = 32 * eps;
        const auto reach = [&](int which) { return std::min(spin[which] * h, 2.0) * radius[which]; };
        const double margin = static_cast<double>(ingot::limits::contact_margin) + v * h + reach(0) + reach(1);
        EXPECT_NEAR(static_cast<double>(room.margin(0, 1, static_cast<scalar>(h), 1)), margin, near * 4) << case_i;
        const double fastest = v + spin[0] * radius[0] + spin[1] * radius[1], most = static_cast<double>(ingot::limits::step_max);
        const double by_way = std::min(most, static_cast<double>(ingot::limits::together_share) * size[1] / fastest);
        const double by_turn = std::min(most, static_cast<double>(ingot::limits::tilt_of_contact) / std::max(spin[0], spin[1]));
        EXPECT_NEAR(static_cast<double>(room.moment()) / std::min(by_way, by_turn), 1, near) << case_i;
        const auto travel = [&](int which) { return (which == 0 ? v / 4 : 3 * v / 4) * h + spin[which] * h * radius[which]; };
        const double fast_share = static_cast<double>(ingot::limits::fast_share);
        EXPECT_EQ(room.some_fast(static_cast<scalar>(h)), travel(0) > fast_share * size[0] || travel(1) > fast_share * size[1]) << case_i;
        EXPECT_FALSE(room.some_fast(scalar(1e-6)));
    }
}

}  // namespace
