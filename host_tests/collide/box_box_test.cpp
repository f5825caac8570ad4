// SPDX-License-Identifier: MIT
// Two boxes: against all 15 axes in long double, flat on each other, through parallel edges, step after step.
#include <gtest/gtest.h>

#include <cstdio>
#include <set>

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

/// Boxes of any proportions up to 1000:1:1: no overlap is missed, and none is seen where an axis separates.
TEST(BoxBox, agrees_with_all_axes) {
    RandomInput random(1411);
    int overlapping = 0, apart = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto half = [&] {
            Vector3d h(random.real(0.2, 2), random.real(0.2, 2), random.real(0.2, 2));
            if (i % 4 == 0) h *= 0.01, h(random.integer(0, 2)) *= 1000;
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
            ASSERT_GE(least(m), exact_one.s - rounding - hidden - 0.011L * smallest) << i;
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
