// SPDX-License-Identifier: MIT
// Contacts of scenes without friction, against distances computed in doubles.
#include <gtest/gtest.h>
#include <ingot/impulse/collide_shapes.h>

#include <vector>

#include "joints/figure.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace {

using Eigen::Vector3d;
using ingot::Contact;
using ingot::Placed;
using ingot::scalar;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;
using ingot_reference::to_matrix;
using ingot_reference::to_vector;

constexpr double eps = static_cast<double>(ingot::epsilon), flatness = static_cast<double>(ingot::limits::flatness);

/// Room for the contacts of a pair.
struct Sink {
    Contact contacts[8] = {};
    ingot::Index count = 0, lost = 0;
    ingot::ContactSink sink{{contacts, &count, 8}, 1, 0, scalar(0.5), &lost};
};

/// A wall anywhere, any way: its face goes through r + A n offset.
struct Wall {
    Vector3d n, on_it;
    Placed placed;

    explicit Wall(RandomInput& random) {
        const Eigen::Matrix3d A = random.rotation();
        const Vector3d n_body = random.direction(), r = random.vector(2);
        const double offset = random.real(-2, 2);
        placed = {ingot::HalfSpace{to_vector(n_body), static_cast<scalar>(offset)}, to_vector(r), to_matrix(A)};
        n = to_eigen(placed.A) * to_eigen(placed.shape.size);
        on_it = to_eigen(placed.r_CM) + n * static_cast<double>(placed.shape.offset);
    }
    double height(const Vector3d& P) const { return n.dot(P - on_it); }
};

/// Places are up to 6 m from the origin, and their heights sums of a dozen rounded numbers as large.
constexpr double near = 12 * 6 * eps;

TEST(WithoutFriction, balls_touch_walls_wherever_they_are) {
    RandomInput random(1461);
    int touching = 0;
    for (int case_i = 0; case_i < 2000; ++case_i) {
        const Wall wall(random);
        const double radius = random.real(0.1, 1), gap = random.real(-0.01, 0.01) * radius;
        const Placed ball = {
            ingot::Sphere{static_cast<scalar>(radius)}, to_vector(wall.on_it + wall.n * (radius + gap) + wall.n.cross(random.vector(2))), {}};
        const double separation = wall.height(to_eigen(ball.r_CM)) - static_cast<double>(ball.shape.size.x);
        if (std::abs(separation - flatness * radius) < near) continue;
        Sink found;
        ingot::collide_sphere_half_space(ball, wall.placed, found.sink);
        ASSERT_EQ(found.count, separation < flatness * radius ? 1 : 0) << case_i;
        if (found.count == 0) continue;
        ++touching;
        EXPECT_NEAR(static_cast<double>(found.contacts[0].separation), separation, near);
        EXPECT_LE((to_eigen(found.contacts[0].n) - wall.n).norm(), 8 * eps);
    }
    EXPECT_GT(touching, 800);
}

/// Corners that are above the deepest by no more than `flatness` come with it, wherever the deepest is.
TEST(WithoutFriction, boxes_touch_walls_with_the_corners_that_are_level) {
    RandomInput random(1462);
    int with_few = 0, with_four = 0, in_the_air = 0;
    for (int case_i = 0; case_i < 4000; ++case_i) {
        const Wall wall(random);
        const Vector3d half(random.real(0.2, 1), random.real(0.2, 1), random.real(0.2, 1));
        const double margin = flatness * half.norm();
        // Turned off the level by some margins at most, or at all.
        const Eigen::Matrix3d level = ingot_figures::least_turn(Vector3d::UnitZ(), wall.n).toRotationMatrix();
        const Vector3d tilt = random.vector(case_i % 4 == 0 ? 0.5 : 2 * flatness);
        const Eigen::Matrix3d A = level * Eigen::AngleAxisd(tilt.norm(), tilt.normalized()).toRotationMatrix();
        double lowest = 0;
        for (int i = 0; i < 8; ++i)
            lowest =
                std::min(lowest, wall.n.dot(A * Vector3d(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(), i & 4 ? half.z() : -half.z())));
        const Vector3d r = wall.on_it + wall.n * (random.real(-2, 1.5) * margin - lowest) + wall.n.cross(random.vector(2));
        const Placed box = {ingot::Box{to_vector(half)}, to_vector(r), to_matrix(A)};

        std::vector<double> separations;
        for (int i = 0; i < 8; ++i) {
            const Vector3d size = to_eigen(box.shape.size),
                           corner(i & 1 ? size.x() : -size.x(), i & 2 ? size.y() : -size.y(), i & 4 ? size.z() : -size.z());
            separations.push_back(wall.height(to_eigen(box.r_CM) + to_eigen(box.A) * corner));
        }
        const double deepest = *std::min_element(separations.begin(), separations.end()), least = std::max(deepest, 0.0) + margin;
        const bool is_clear = std::abs(deepest - margin) > near &&
                              std::none_of(separations.begin(), separations.end(), [&](double s) { return std::abs(s - least) < 2 * near; });
        if (!is_clear) continue;
        std::vector<double> expected;
        for (const double s : separations)
            if (deepest <= margin && s <= least) expected.push_back(s);

        Sink found;
        ingot::collide_box_half_space(box, wall.placed, found.sink);
        ASSERT_EQ(found.count, expected.size()) << case_i;
        for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(static_cast<double>(found.contacts[i].separation), expected[i], near);
        with_few += !expected.empty() && expected.size() < 4 ? 1 : 0;
        with_four += expected.size() == 4 ? 1 : 0;
        in_the_air += !expected.empty() && deepest > 0 ? 1 : 0;
    }
    EXPECT_GT(with_few, 200);
    EXPECT_GT(with_four, 200);
    EXPECT_GT(in_the_air, 200);
}

}  // namespace
