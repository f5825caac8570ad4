// SPDX-License-Identifier: MIT
// Recycled manifolds against new ones and against the exact distance, within the bound that recycle.h states.
#include <gtest/gtest.h>
#include <ingot/collide/recycle.h>

#include <cstdio>
#include <cstring>
#include <limits>

#include "collide/placed.h"

namespace {

using namespace ingot_collide;
using Eigen::Matrix3d;
using Eigen::Vector3d;

const scalar margin = scalar(0.05), allowed = scalar(0.01);
using M = Eigen::Matrix<long double, 3, 3>;

/// The move in long double, of the shape with the smaller radius: its turn by angle and axis.
long double exact_move(const PlacedShape& A_0, const PlacedShape& B_0, const PlacedShape& A, const PlacedShape& B) {
    const M Q_0 = exact(B_0.A).transpose() * exact(A_0.A), Q = exact(B.A).transpose() * exact(A.A);
    const V r_0 = exact(B_0.A).transpose() * (exact(A_0.r) - exact(B_0.r)),
            r = exact(B.A).transpose() * (exact(A.r) - exact(B.r));
    const long double theta = Eigen::AngleAxis<long double>(M(Q * Q_0.transpose())).angle(), chord = 2 * std::sin(theta / 2);
    const bool of_A = size_of(A) <= size_of(B);
    const V dr = of_A ? V(r - r_0) : V(Q.transpose() * r - Q_0.transpose() * r_0);
    return dr.norm() + chord * static_cast<long double>(std::min(size_of(A), size_of(B)));
}

struct Scene {
    PlacedShape A, B;
};

/// Nearly touching, in an attitude at random or with faces on each other.
Scene touching(RandomInput& random, int i) {
    const auto shape = [&](int kind) -> PlacedShape {
        if (kind == 0)
            return placed(ingot::Box{{static_cast<scalar>(random.real(0.3, 1.5)), static_cast<scalar>(random.real(0.3, 1.5)),
                                      static_cast<scalar>(random.real(0.3, 1.5))}});
        if (kind == 1) return placed(ingot::Capsule{scalar(0.4), static_cast<scalar>(random.real(0.3, 1.5))});
        PlacedShape s = placed(ingot::Hull{1});
        s.hull = hull_of(random);
        s.shape = ingot::Hull{s.hull->radius};
        return s;
    };
    Scene scene{shape(i % 3 == 1 ? 1 : 0), shape(i % 3 == 0 ? 0 : 2)};
    const Matrix3d T = random.rotation();
    scene.B.A = to_matrix(T);
    scene.A.A = i % 2 == 0 ? scene.B.A : to_matrix(random.rotation());
    const Vector3d at = random.vector(3), towards = i % 2 == 0 ? Vector3d(T.col(2)) : random.direction();
    scene.B.r = to_vector(at);
    double away = size_of(scene.A) + size_of(scene.B);
    for (int k = 0; k < 12; ++k) {
        scene.A.r = to_vector(Vector3d(at + towards * away));
        away -= static_cast<double>(ingot_oracle::signed_distance(oracle_of(scene.A), oracle_of(scene.B))) -
                random.real(-0.03, 0.02);
    }
    return scene;
}

void turn_about(PlacedShape& s, const Matrix3d& T, const Vector3d& shift) {
    s.r = to_vector(Vector3d(T * exact(s.r).cast<double>() + shift));
    s.A = to_matrix(Matrix3d(T * exact(s.A).cast<double>()));
}

/// Whatever both do together, and each a little on its own: accepted exactly where the move is within what is allowed, and then
/// no separation is further from the exact distance than twice the move and what the first test was off.
TEST(Recycle, separations_keep_the_bound) {
    RandomInput random(1441);
    int recycled = 0, refused = 0;
    long double worst = 0;
    for (int i = 0; i < 1200; ++i) {
        const Scene before = touching(random, i);
        Manifold first{}, m{};
        ASSERT_TRUE(collide(before.A, before.B, margin, first));
        ingot::KeptManifold kept{};
        keep_manifold(before.A, before.B, first, kept);
        Scene now = before;
        const double step = std::exp(random.real(-12, -3.5));
        turn_about(now.A, turned(random.direction(), random.real(0, 1) * step), random.vector(step));
        const Matrix3d T = random.rotation();
        const Vector3d shift = random.vector(5);
        turn_about(now.A, T, shift), turn_about(now.B, T, shift);

        const long double move = exact_move(before.A, before.B, now.A, now.B);
        const double rounding = 64 * ingot::epsilon * (size_of(now.A) + size_of(now.B) + 16);
        ASSERT_NEAR(static_cast<double>(moved_since(now.A, now.B, kept)), static_cast<double>(move), rounding) << i;
        // No point moves further, wherever it is in the ball that holds the shape.
        if (size_of(now.A) <= size_of(now.B)) {
            const V p = random.direction().cast<long double>() * size_of(now.A);
            const V was = exact(before.B.A).transpose() * (exact(before.A.A) * p + exact(before.A.r) - exact(before.B.r));
            const V is = exact(now.B.A).transpose() * (exact(now.A.A) * p + exact(now.A.r) - exact(now.B.r));
            ASSERT_LE((is - was).norm(), moved_since(now.A, now.B, kept) + rounding) << i;
        }
        if (!recycle_manifold(now.A, now.B, kept, allowed, margin, m)) {
            ++refused;
            ASSERT_GT(move, allowed - rounding);
            ASSERT_EQ(m.count, 0);
            continue;
        }
        ASSERT_LE(move, allowed + rounding);
        const long double exact_before = ingot_oracle::signed_distance(oracle_of(before.A), oracle_of(before.B));
        const long double exact_now = ingot_oracle::signed_distance(oracle_of(now.A), oracle_of(now.B));
        ASSERT_LE(std::abs(exact_now - exact_before), move + rounding);
        if (first.count == 0 || m.count < first.count) {
            ASSERT_TRUE(first.count > 0 || exact_now > margin - move - rounding);
            continue;
        }
        ++recycled;
        const long double off = std::abs(static_cast<long double>(least(first)) - exact_before);
        worst = std::max(worst, (std::abs(least(m) - exact_now) - off) / (move + rounding));
        ASSERT_LE(std::abs(least(m) - exact_now), off + 2 * move + rounding) << i;
        for (int k = 0; k < m.count; ++k) {
            ASSERT_EQ(m.points[k].feature, first.points[k].feature);
            ASSERT_LE(std::abs(static_cast<double>(m.points[k].separation - first.points[k].separation)),
                      static_cast<double>(move) + rounding);
            const V in_B_0 = exact(before.B.A).transpose() * (exact(first.points[k].P) - exact(before.B.r));
            const V in_B = exact(now.B.A).transpose() * (exact(m.points[k].P) - exact(now.B.r));
            // The point of A moves by the move, that of B does not. Seen from A it is the other way.
            const bool of_A = size_of(now.A) <= size_of(now.B);
            if (of_A) {
                ASSERT_LE((in_B - in_B_0).norm(), move / 2 + rounding) << i;
            }
        }
    }
    std::printf("%d recycled, %d refused; off by %.2Lf of the move at most\n", recycled, refused, worst);
    EXPECT_GT(recycled, 300);
    EXPECT_GT(refused, 100);
}

/// A box that sinks and tips on another: what a new test says of the same corners, but for the square of the turn.
TEST(Recycle, faces_agree_with_a_new_test) {
    RandomInput random(1442);
    for (int i = 0; i < 1000; ++i) {
        const Matrix3d T = random.rotation();
        PlacedShape B = placed(ingot::Box{{2, 2, scalar(0.5)}}, {1, 2, 3}, T),
                    A = placed(ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}},
                               Vector3d(1, 2, 3) + T * Vector3d(0.2, 0.1, 1), T);
        Manifold first{}, recycled{}, fresh{};
        collide(A, B, margin, first);
        ASSERT_EQ(first.count, 4);
        ingot::KeptManifold kept{};
        keep_manifold(A, B, first, kept);
        const double theta = i % 2 == 0 ? 0 : random.real(0, 3e-3), sink = random.real(-2e-3, 2e-3);
        A.A = to_matrix(Matrix3d(T * turned(Vector3d::UnitX(), theta)));
        A.r = to_vector(Vector3d(exact(A.r).cast<double>() + T.col(2) * sink));
        ASSERT_TRUE(recycle_manifold(A, B, kept, allowed, margin, recycled));
        collide(A, B, margin, fresh, &first);
        ASSERT_EQ(fresh.count, 4);
        // n of the new test is that of A or B: cos theta of a corner of A at most 0.9 m away, and s sin theta.
        const double tolerance = theta * theta + 3e-3 * theta + 32 * ingot::epsilon * 6;
        for (int k = 0; k < 4; ++k)
            for (int l = 0; l < 4; ++l)
                if (recycled.points[k].feature == fresh.points[l].feature) {
                    ASSERT_NEAR(static_cast<double>(recycled.points[k].separation),
                                static_cast<double>(fresh.points[l].separation), tolerance)
                        << i;
                }
        ASSERT_NEAR(static_cast<double>(least(recycled)), static_cast<double>(least(fresh)), tolerance) << i;
    }
}

TEST(Recycle, what_is_not_finite_asks_for_a_new_test) {
    const PlacedShape A = placed(ingot::Box{{1, 1, 1}}, {0, 0, 1.99}), B = placed(ingot::Box{{1, 1, 1}});
    Manifold m{};
    collide(A, B, margin, m);
    ingot::KeptManifold kept{};
    keep_manifold(A, B, m, kept);
    for (const scalar bad : {std::numeric_limits<scalar>::quiet_NaN(), std::numeric_limits<scalar>::infinity()})
        for (int i = 0; i < 2; ++i) {
            PlacedShape C = A;
            (i == 0 ? C.r.x : C.A.c1.y) = bad;
            Manifold w = m;
            EXPECT_FALSE(recycle_manifold(C, B, kept, allowed, margin, w));
            EXPECT_EQ(std::memcmp(&w.points, &m.points, sizeof m.points), 0);
        }
}

}  // namespace
