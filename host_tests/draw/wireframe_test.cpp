// SPDX-License-Identifier: MIT
// Wireframes lie on their shapes: ends of lines against equations of surfaces, in double.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <Eigen/Dense>
#include <cmath>

#include "reference/random_input.h"
#include "scenes/hulls.h"

namespace {

using ingot::PlacedShape;
using ingot::scalar;
using ingot::ShapeKind;
using ingot::Vector;
using ingot_reference::RandomInput;
using V = Eigen::Vector3d;

V exact(const Vector& v) { return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)}; }
Vector rounded(const V& v) { return {static_cast<scalar>(v.x()), static_cast<scalar>(v.y()), static_cast<scalar>(v.z())}; }

/// How far a point of the shape's own frame is from the surface, m.
double off_surface(const PlacedShape& of, const V& p) {
    const double x = static_cast<double>(of.shape.size.x), y = static_cast<double>(of.shape.size.y);
    const double around = std::hypot(p.x(), p.y());
    switch (of.shape.kind) {
        case ShapeKind::sphere: return std::abs(p.norm() - x);
        case ShapeKind::capsule: return std::abs((p - V(0, 0, std::min(y, std::max(-y, p.z())))).norm() - x);
        case ShapeKind::cylinder: return std::max(std::abs(around - x), std::abs(std::abs(p.z()) - y));  // ends of lines are on its rims
        case ShapeKind::box: return (p.cwiseAbs() - exact(of.shape.size)).cwiseAbs().maxCoeff();         // and on corners
        case ShapeKind::half_space: return std::abs(p.dot(exact(of.shape.size)) - static_cast<double>(of.shape.offset));
        case ShapeKind::hull: {
            double least = 1e9;
            for (int i = 0; i < of.hull->vertex_count; ++i) least = std::min(least, (p - exact(of.hull->vertices[i])).norm());
            return least;
        }
        default: return 0;
    }
}

PlacedShape any(RandomInput& random, int kind) {
    PlacedShape shape;
    const auto size = [&] { return static_cast<scalar>(random.real(0.1, 2)); };
    switch (kind) {
        case 0: shape.shape = ingot::Sphere{size()}; break;
        case 1: shape.shape = ingot::Capsule{size(), size()}; break;
        case 2: shape.shape = ingot::Box{{size(), size(), size()}}; break;
        case 3: shape.shape = ingot::Cylinder{size(), size()}; break;
        case 4: shape.shape = ingot::HalfSpace{rounded(random.direction()), static_cast<scalar>(random.real(-2, 2))}; break;
        default:
            static constexpr ingot::ConvexHull rock = scenes::rock_hull.hull.value.view();
            shape.shape = ingot::Hull{rock.radius, 0};
            shape.hull = &rock;
    }
    shape.r = rounded(random.vector(10));
    const Eigen::Matrix3d A = random.rotation();
    shape.A = {rounded(A.col(0)), rounded(A.col(1)), rounded(A.col(2))};
    return shape;
}

TEST(Wireframe, lines_end_on_the_surface) {
    RandomInput random(1);
    // Places up to 20 m: some thirty roundings of them.
    const double tolerance = 32 * 20 * static_cast<double>(ingot::epsilon);
    for (int draw_i = 0; draw_i < 300; ++draw_i) {
        const PlacedShape shape = any(random, draw_i % 6);
        const int count = ingot::line_count(shape);
        ASSERT_GT(count, 0);
        Eigen::Matrix3d A;
        A << exact(shape.A.c0), exact(shape.A.c1), exact(shape.A.c2);
        for (int line_i = 0; line_i < count; ++line_i) {
            const ingot::Line line = ingot::line_of(shape, line_i, 1);
            for (const Vector& end : {line.a, line.b})
                ASSERT_LE(off_surface(shape, A.transpose() * (exact(end) - exact(shape.r))), tolerance) << draw_i % 6 << ", line " << line_i;
            ASSERT_GT((exact(line.a) - exact(line.b)).norm(), 0.01) << draw_i % 6 << ", line " << line_i;
        }
    }
}

TEST(Wireframe, no_line_comes_twice) {
    RandomInput random(2);
    for (int kind = 0; kind < 6; ++kind) {
        const PlacedShape shape = any(random, kind);
        for (int i = 0; i < ingot::line_count(shape); ++i)
            for (int k = 0; k < i; ++k) {
                const ingot::Line one = ingot::line_of(shape, i, 1), other = ingot::line_of(shape, k, 1);
                const V middle = exact(one.a + one.b), middle_of_other = exact(other.a + other.b);
                const bool crosses = kind == 4;  // lines of a net cross in their middles
                EXPECT_TRUE(crosses || (middle - middle_of_other).norm() > 1e-3) << kind << ": " << i << ", " << k;
            }
    }
}

TEST(Wireframe, of_a_capsule_is_as_long_as_the_capsule) {
    PlacedShape capsule;
    capsule.shape = ingot::Capsule{scalar(0.5), 2};
    scalar low = 0, high = 0;
    for (int line_i = 0; line_i < ingot::line_count(capsule); ++line_i) {
        const ingot::Line line = ingot::line_of(capsule, line_i, 1);
        low = std::min(low, std::min(line.a.z, line.b.z));
        high = std::max(high, std::max(line.a.z, line.b.z));
    }
    EXPECT_EQ(low, scalar(-2.5));
    EXPECT_EQ(high, scalar(2.5));
}

TEST(Wireframe, what_has_no_shape_has_no_line) {
    EXPECT_EQ(ingot::line_count({}), 0);
    PlacedShape hull;
    hull.shape = ingot::Hull{1, 0};
    EXPECT_EQ(ingot::line_count(hull), 0);  // its form is not known
}

}  // namespace
