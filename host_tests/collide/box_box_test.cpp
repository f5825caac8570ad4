// SPDX-License-Identifier: MIT
// Two boxes: against all 15 axes in long double, flat on each other, through parallel edges, step after step.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <map>
#include <set>
#include <vector>

#include "collide/placed.h"

namespace {

using namespace ingot_collide;
using Eigen::Vector3d;

const scalar margin = scalar(0.02);

PlacedShape box(const Vector3d& half, const Vector3d& r, const Eigen::Matrix3d& A = Eigen::Matrix3d::Identity()) {
    return placed(ingot::Box{to_vector(half)}, r, A);
}

std::set<std::uint32_t> features(const Manifold& m) {
    std::set<std::uint32_t> all;
    for (int i = 0; i < m.count; ++i) all.insert(m.points[i].feature);
    return all;
}

/// Boxes of any proportions, needles of 1000:1:1 and plates of 100:100:1 too: no overlap is missed, and none is seen where an axis separates.
TEST(BoxBox, agrees_with_all_axes) {
    RandomInput random(1411);
    int overlapping = 0, apart = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto half = [&] {
            Vector3d h(random.real(0.2, 2), random.real(0.2, 2), random.real(0.2, 2));
            if (i % 4 == 0) h *= 0.01, h(random.integer(0, 2)) *= 1000;
            if (i % 4 == 1) h(random.integer(0, 2)) *= 0.01;
            return h;
        };
        const Vector3d h_A = half(), h_B = half();
        const Eigen::Matrix3d T = random.rotation();
        const Eigen::Matrix3d near = i % 3 == 0 ? turned(random.direction(), std::exp(random.real(-16, -3))) : random.rotation();
        const PlacedShape A = box(h_A, random.vector((h_A + h_B).norm() * 0.7), T), B = box(h_B, Vector3d::Zero(), T * near);
        const ingot_oracle::Separation exact_one = ingot_oracle::best_axis(oracle_of(A), oracle_of(B));
        Manifold m{};
        ingot::collide_box_box(A, B, margin, m);
        const long double size = (h_A + h_B).norm(), rounding = 64 * ingot::epsilon * size;
        if (exact_one.s < -rounding) {
            ++overlapping;
            ASSERT_GT(m.count, 0) << i << " overlap " << exact_one.s << " of " << size;
            // Deeper only by the preference for faces: of the smallest half extent, and what near parallel edges hide.
            const long double hidden = std::sqrt(static_cast<long double>(ingot::limits::parallel_sin_sq)) * size;
            const long double smallest = std::min(h_A.minCoeff(), h_B.minCoeff());
            // Edges that cross all but in a face, up to facing_cos, have the points of that face, as deep across it as the overlap is across
            // the edges.
            const V n = exact(m.n);
            const bool lies_flat = m.count > 1 && std::abs(n.dot(exact_one.n)) > ingot::limits::facing_cos;
            const long double best = lies_flat ? exact_one.s / ingot::limits::facing_cos : exact_one.s;
            ASSERT_GE(least(m), best - hidden - 0.011L * smallest - rounding) << i;
        }
        if (exact_one.s > margin + rounding) {
            ++apart;
            ASSERT_EQ(m.count, 0) << i;
        }
    }
    ASSERT_GT(overlapping, 3000);
    ASSERT_GT(apart, 3000);
}

/// Face on face: four points, at the corners of what both faces share.
TEST(BoxBox, face_on_face_has_four_points) {
    RandomInput random(1412);
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Matrix3d T = random.rotation();
        const double turn = i % 2 == 0 ? 0 : random.real(0, 6.3), gap = random.real(-0.01, 0.01);
        const Vector3d shift(random.real(-0.8, 0.8), random.real(-0.8, 0.8), 2 + gap);
        const PlacedShape A = box({1, 1, 1}, T * shift, T * turned(Vector3d::UnitZ(), turn)), B = box({1, 1, 1}, {0, 0, 0}, T);
        Manifold m{};
        ingot::collide_box_box(A, B, margin, m);
        ASSERT_EQ(m.count, 4) << i;
        ASSERT_EQ(features(m).size(), 4u);
        for (int k = 0; k < 4; ++k) {
            ASSERT_NEAR(static_cast<double>(m.points[k].separation), gap, 32 * ingot::epsilon) << i;
            const V P = T.transpose().cast<long double>() * exact(m.points[k].P);
            ASSERT_LE(P.head<2>().cwiseAbs().maxCoeff(), 1 + ingot::limits::corner_slack);
            ASSERT_NEAR(static_cast<double>(P(2)), 1 + gap / 2, 32 * ingot::epsilon);
        }
        ASSERT_NEAR(static_cast<double>((T.transpose().cast<long double>() * exact(m.n))(2)), 1, 8 * ingot::epsilon);
    }
}

/// A resting box that trembles keeps its four features; without the step before it would not always.
TEST(BoxBox, trembling_keeps_its_features) {
    RandomInput random(1413);
    int changes = 0;
    for (int scene = 0; scene < 100; ++scene) {
        const Eigen::Matrix3d T = random.rotation();
        const double turn = scene % 3 == 0 ? 0 : random.real(0, 6.3);
        const Vector3d shift = scene % 2 == 0 ? Vector3d(0, 0, 2) : Vector3d(random.real(-1, 1), random.real(-1, 1), 2);
        const PlacedShape B = box({1, 1, 1}, {0, 0, 0}, T);
        Manifold m{};
        std::set<std::uint32_t> last;
        for (int step = 0; step < 200; ++step) {
            const Eigen::Matrix3d tremble = turned(random.direction(), 2e-5);
            const PlacedShape A = box({1, 1, 1}, T * (shift + random.vector(2e-5)), T * turned(Vector3d::UnitZ(), turn) * tremble);
            ingot::collide_box_box(A, B, margin, m, &m);
            ASSERT_EQ(m.count, 4);
            if (step > 0) changes += features(m) != last;
            last = features(m);
        }
    }
    std::printf("%d of 19900 steps changed a feature\n", changes);
    EXPECT_EQ(changes, 0);
}

/// Two bars, edge on edge, turned through parallel: what separates them changes as little as they move, and the deepest point
/// with it (accuracy case C15).
TEST(BoxBox, edges_turn_through_parallel) {
    for (const double tilt : {0.785398, 0.3, 0.05, 0.0}) {
        const PlacedShape B = box({1, 0.2, 0.2}, {0, 0, 0}, turned(Vector3d::UnitX(), tilt));
        const double reach = 0.2 * (std::cos(tilt) + std::sin(tilt)), step = 1e-3;
        Manifold m{};
        long double last = 0, largest = 0;
        for (int i = -300; i <= 300; ++i) {
            const Eigen::Matrix3d T = turned(Vector3d::UnitZ(), i * step) * turned(Vector3d::UnitX(), tilt);
            const PlacedShape A = box({1, 0.2, 0.2}, {0, 0.4 * (std::cos(tilt) - std::sin(tilt)), 2 * reach - 1e-3}, T);
            ingot::collide_box_box(A, B, margin, m, &m);
            ASSERT_GT(m.count, 0) << tilt << " " << i;
            const long double s = least(m);
            // No point moves by more than step times the half length, 1 m, and what that does to the depth is of second order.
            if (i > -300) largest = std::max(largest, std::abs(s - last));
            last = s;
            const long double exact_s = ingot_oracle::signed_distance(oracle_of(A), oracle_of(B));
            ASSERT_NEAR(static_cast<double>(s), static_cast<double>(exact_s), 0.01 * 0.2 + 1e-3) << tilt << " " << i;
        }
        std::printf("tilt %g: largest change of the depth in a turn of 1 mrad %.2Lg m\n", tilt, largest);
        EXPECT_LE(largest, 2 * step * 1.02) << tilt;
    }
}

/// Two cards that lean on each other meet edge to edge. The normal is the middle of what both edges allow, not that of one face, with two points at
/// the ends of what the edges share; it turns steadily as they shift, up to the normal of the face that an edge then lies on; and edges that
/// are apart have the direction between them (accuracy case C10).
TEST(BoxBox, leaning_cards_have_the_normal_between_their_faces) {
    const double tilt = 25 * 3.14159265358979324 / 180, half = 0.5, thin = 0.02, rounded = 0.01 * thin;
    const double x = half * std::sin(tilt) + thin * std::cos(tilt);
    // A place is right to a few roundings of 0.5 m, which is a share of the rounding of the edges.
    const double near = 16 * static_cast<double>(ingot::epsilon) / rounded;
    const auto card = [&](double side, const Vector3d& shift) {
        return box({thin, 0.3, half}, Vector3d(side * x, 0, 0) + shift, turned(Vector3d::UnitY(), -side * tilt));
    };
    const auto normal_at = [&](const Vector3d& shift, Manifold& m) {
        Manifold seen_from_B{};
        ingot::collide_box_box(card(1, shift), card(-1, {0, 0, 0}), margin, m);
        ingot::collide_box_box(card(-1, {0, 0, 0}), card(1, shift), margin, seen_from_B);
        EXPECT_EQ(seen_from_B.count, m.count);
        if (m.count > 0) {
            EXPECT_NEAR(static_cast<double>(seen_from_B.n.x), -static_cast<double>(m.n.x), near);
            EXPECT_NEAR(static_cast<double>(seen_from_B.n.z), -static_cast<double>(m.n.z), near);
        }
        return std::atan2(static_cast<double>(m.n.z), static_cast<double>(m.n.x));
    };
    Manifold m{};
    EXPECT_NEAR(normal_at({0, 0.1, 0}, m), 0, near);
    ASSERT_EQ(m.count, 2);
    EXPECT_NE(m.points[0].feature, m.points[1].feature);
    EXPECT_NEAR(std::abs(static_cast<double>(m.points[0].P.y - m.points[1].P.y)), 0.5, 1e-6);
    EXPECT_NEAR(static_cast<double>(m.points[0].separation), 0, 1e-6);

    double last = 0;
    for (double up = 0; up <= 2 * rounded; up += rounded / 64) {
        const double angle = normal_at({0, 0, up}, m);
        if (std::atan2(up, rounded) < tilt - near) { EXPECT_EQ(m.count, 2) << up; }
        EXPECT_NEAR(angle, std::min(std::atan2(up, rounded), tilt), 2 * near) << up;
        EXPECT_LE(angle - last, 1.0 / 64 + 2 * near);
        last = angle;
    }
    EXPECT_NEAR(last, tilt, 1e-6);
    EXPECT_NEAR(normal_at({0.01, 0, 0.003}, m), std::atan2(0.003, 0.01 + rounded), 1e-4);
    EXPECT_NEAR(static_cast<double>(m.points[0].separation), std::hypot(0.01, 0.003), 1e-5);
    (void)normal_at({0.1, 0, 0}, m);
    EXPECT_EQ(m.count, 0);
}

/// The features of two edges that meet tell them and their ends from all others: a box is given as each of the 24 turns of it that look the same, and
/// the edge that meets is another one of its own each time, either way round.
TEST(BoxBox, edges_that_meet_are_told_from_each_other) {
    RandomInput random(1413);
    std::map<std::array<int, 2>, std::set<std::uint32_t>> features_of;  // by the edges of A and of B
    std::map<std::uint32_t, std::array<int, 2>> edges_of;
    const double tilt = random.real(20, 30) * 3.14159265358979324 / 180, half = random.real(0.3, 1), thin = 0.1 * half, wide = random.real(0.3, 1);
    const double x = half * std::sin(tilt) + thin * std::cos(tilt);
    std::vector<Eigen::Matrix3d> turns;
    for (int code = 0; code < 27 * 8; ++code) {
        Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
        for (int k = 0, rest = code % 27; k < 3; ++k, rest /= 3) turn(rest % 3, k) = (code / 27 >> k & 1) != 0 ? -1 : 1;
        if (std::abs(turn.determinant() - 1) < 0.1) turns.push_back(turn);
    }
    ASSERT_EQ(turns.size(), 24u);
    // A card leans to one side; as another turn of itself it has other half extents, and its edge at the top has another place in it.
    const auto card = [&](double side, const Eigen::Matrix3d& turn) {
        const Vector3d own = (turn.transpose() * Vector3d(thin, wide, half)).cwiseAbs();
        return box(own, Vector3d(side * x, 0, 0), turned(Vector3d::UnitY(), -side * tilt) * turn);
    };
    const auto edge = [&](double side, const Eigen::Matrix3d& turn) {
        const Vector3d way = turn.transpose() * Vector3d(-side, 0, 1);  // of the edge at the top, which is along y
        return static_cast<int>(std::lround(way.x() + 3 * way.y() + 9 * way.z()));
    };
    for (const Eigen::Matrix3d& of_A : turns)
        for (const Eigen::Matrix3d& of_B : turns) {
            Manifold m{};
            ingot::collide_box_box(card(1, of_A), card(-1, of_B), margin, m);
            ASSERT_EQ(m.count, 2);
            const std::array<int, 2> edges = {edge(1, of_A), edge(-1, of_B)};
            for (const std::uint32_t feature : features(m)) {
                features_of[edges].insert(feature);
                EXPECT_TRUE(edges_of.emplace(feature, edges).first->second == edges) << "feature " << feature << " is of two pairs of edges";
            }
            EXPECT_EQ(features(m).size(), 2u);
        }
    EXPECT_EQ(features_of.size(), 144u);
    for (const auto& [edges, all] : features_of) EXPECT_EQ(all.size(), 2u) << edges[0] << " " << edges[1];
}

/// Centres at one place: the axis of the smallest half extent, always the same (accuracy case C16).
TEST(BoxBox, coincident_centres_have_a_normal) {
    const PlacedShape A = box({1, 2, 0.5}, {3, 4, 5}), B = box({1, 2, 0.5}, {3, 4, 5});
    Manifold m{};
    ingot::collide_box_box(A, B, margin, m);
    EXPECT_EQ(m.count, 4);
    EXPECT_EQ(std::abs(static_cast<double>(m.n.z)), 1);
    EXPECT_EQ(static_cast<double>(m.points[0].separation), -1);
}

/// What separated them before still does: one projection says so, and the direction stays.
TEST(BoxBox, cached_axis_keeps_them_apart) {
    const PlacedShape A = box({1, 1, 1}, {2.5, 0.1, 0.2}), B = box({1, 1, 1}, {0, 0, 0});
    Manifold m{}, again{};
    ingot::collide_box_box(A, B, margin, m);
    ASSERT_EQ(m.count, 0);
    ASSERT_NEAR(static_cast<double>(m.n.x), 1, 1e-6);
    ingot::collide_box_box(A, B, margin, again, &m);
    ASSERT_EQ(again.count, 0);
    ASSERT_EQ(static_cast<double>(again.n.x), static_cast<double>(m.n.x));
}

}  // namespace
