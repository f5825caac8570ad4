// SPDX-License-Identifier: MIT
// What planes leave of a way: against all points that could be the answer, in long double.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <ingot/ingot.h>

#include "reference/draws.h"

namespace planes_of_way { namespace {

using ingot::MoverPlane;
using ingot::scalar;
using ingot::Status;
using ingot::Vector;
using Real = long double;
using V = Eigen::Matrix<Real, 3, 1>;

constexpr Real epsilon = static_cast<Real>(ingot::epsilon);

V exact(const Vector& v) { return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)}; }
Vector rounded(const V& v) { return {static_cast<scalar>(v.x()), static_cast<scalar>(v.y()), static_cast<scalar>(v.z())}; }

/// Not of Eigen, which takes fifty times as long where it is not optimised.
using Exact = ingot::Vec3<Real>;
Exact of(const V& v) { return {v.x(), v.y(), v.z()}; }
Real norm(const Exact& v) { return std::sqrt(dot(v, v)); }

struct Planes {
    std::vector<Exact> n;
    std::vector<Real> least;
    Exact w{};
    Real size = 0;

    Real passed_by(const Exact& x) const {
        Real most = 0;
        for (size_t i = 0; i < n.size(); ++i) most = std::max(most, least[i] - dot(n[i], x));
        return most;
    }
    /// How far the nearest point of those that pass no plane by more than t is from w; infinity: there is none. All points that are nearest on one,
    /// two or three planes are looked at.
    Real distance(Real t) const {
        Real best = 512 * size;  // beyond twice of which planes do not meet
        bool found = false;
        const Real slack = 1e-14L * size;
        const auto consider = [&](const Exact& y) {
            const Real length = norm(y);
            if (!(length < best)) return;
            for (size_t i = 0; i < n.size(); ++i)
                if (dot(n[i], w + y) < least[i] - t - slack - 1e-14L * length) return;
            best = length;
            found = true;
        };
        const auto lacks = [&](size_t i) { return least[i] - t - dot(n[i], w); };
        consider({0, 0, 0});
        for (size_t i = 0; i < n.size(); ++i) {
            consider(n[i] * (lacks(i) / dot(n[i], n[i])));
            for (size_t k = i + 1; k < n.size(); ++k) {
                // On both planes, and in the plane of their normals: three planes again.
                consider_meeting(n[i], n[k], cross(n[i], n[k]), lacks(i), lacks(k), 0, 1e-22L, consider);
                for (size_t m = k + 1; m < n.size(); ++m) consider_meeting(n[i], n[k], n[m], lacks(i), lacks(k), lacks(m), 1e-13L, consider);
            }
        }
        return found ? best : std::numeric_limits<Real>::infinity();
    }
    /// By how much some plane has to be passed by.
    Real least_wrong() const {
        Real low = 0, high = passed_by(w);
        for (int i = 0; i < (INGOT_DOUBLE ? 60 : 45); ++i) {
            const Real middle = (low + high) / 2;
            (std::isfinite(distance(middle)) ? high : low) = middle;
        }
        return high;
    }

private:
    /// Cramer's rule.
    template <class Consider>
    static void consider_meeting(const Exact& a, const Exact& b, const Exact& c, Real at_a, Real at_b, Real at_c, Real least_det,
                                 const Consider& consider) {
        const Exact b_c = cross(b, c);
        const Real det = dot(a, b_c);
        if (std::abs(det) > least_det) consider((b_c * at_a + cross(c, a) * at_b + cross(a, b) * at_c) * (1 / det));
    }
};

/// Planes of every sort: any, upright, opposite, all but parallel, the same, axes of a box.
std::vector<MoverPlane> any_planes(std::mt19937& random, Vector& way) {
    std::uniform_real_distribution<double> even(-1, 1);
    const auto share = [&even](std::mt19937& from) { return static_cast<Real>(even(from)); };
    const auto any = [&] {
        V v(share(random), share(random), share(random));
        return v.norm() > 0.1 ? V(v.normalized()) : V(0, 0, 1);
    };
    way = rounded(any() * std::pow(Real{10}, 2 * share(random)));
    const int count = random() % 8 == 0 ? static_cast<int>(random() % 17) : static_cast<int>(random() % 6);
    const Real far = std::pow(Real{10}, 2 * share(random) - 1);
    std::vector<MoverPlane> planes;
    for (int i = 0; i < count; ++i) {
        V n = any();
        const int sort = static_cast<int>(random() % 7);
        if (sort == 1) n = V(n.x(), n.y(), 0).norm() > 0.1 ? V(n.x(), n.y(), 0).normalized() : V(1, 0, 0);
        if (sort == 2) n = V(0, 0, share(random) < 0 ? -1 : 1);
        if (sort >= 3 && !planes.empty()) {
            const V other = exact(planes[random() % planes.size()].n);
            const Real off = sort == 3 || sort == 6 ? 0 : std::pow(Real{10}, -1 - 2 * (share(random) + 1));
            n = sort >= 5 ? V(-other) : other;
            if (off > 0) n = (n + any() * off).normalized();
        }
        MoverPlane plane;
        plane.n = rounded(n);
        plane.gap = static_cast<scalar>((share(random) + Real{0.5}) * far);
        planes.push_back(plane);
    }
    return planes;
}

Planes seen(const std::vector<MoverPlane>& planes, const Vector& way) {
    Planes all;
    all.w = of(exact(way));
    all.size = norm(all.w);
    for (const MoverPlane& plane : planes) {
        all.n.push_back(of(exact(plane.n)));
        all.least.push_back(-static_cast<Real>(plane.gap));
        all.size = std::max(all.size, std::abs(all.least.back()));
    }
    return all;
}

bool same(const Vector& a, const Vector& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

Vector solved(const std::vector<MoverPlane>& planes, const Vector& way) {
    const auto x = ingot::solve_planes(way, planes.data(), static_cast<int>(planes.size()));
    EXPECT_TRUE(x.ok()) << ingot::name(x.status);
    return x.value;
}

/// What it gives is rounded once, and where it cannot keep all planes, found to an epsilon of all lengths. Of double, planes are kept to 64 roundings
/// of all lengths by components, up to 1.8 times as long, on either side.
constexpr Real kept = (INGOT_DOUBLE ? 256 : 4) * epsilon;

TEST(SolvePlanes, nearest_of_all_points_that_no_plane_forbids) {
    std::mt19937 random(1);
    constexpr int sets = INGOT_TEST_BRIEF ? 1000 : 100000;
    int bounded = 0, empty = 0;
    for (int draw = 0; draw < sets; ++draw) {
        Vector way;
        const std::vector<MoverPlane> planes = any_planes(random, way);
        const Planes all = seen(planes, way);
        const Exact x = of(exact(solved(planes, way)));
        const Real got = norm(x - all.w), roundings = kept * (all.size + got);
        const Real best = all.distance(0);
        bounded += best > 0 ? 1 : 0;
        empty += std::isfinite(best) ? 0 : 1;
        const Real least = std::isfinite(best) ? 0 : all.least_wrong();
        ASSERT_LE(all.passed_by(x), least + roundings) << draw << " of " << planes.size();
        // No further than where planes would be that are off by these roundings: of what is all but parallel that is far.
        ASSERT_LE(got, all.distance(-roundings) + roundings) << draw << " of " << planes.size() << ", best " << best;
    }
    EXPECT_GT(bounded, sets / 4);
    EXPECT_GT(empty, sets / 50);
}

TEST(SolvePlanes, order_does_not_matter_to_the_bit) {
    std::mt19937 random(2);
    for (int draw = 0; draw < (INGOT_TEST_BRIEF ? 500 : 20000); ++draw) {
        Vector way;
        std::vector<MoverPlane> planes = any_planes(random, way);
        const Vector x = solved(planes, way);
        std::shuffle(planes.begin(), planes.end(), random);
        ASSERT_TRUE(same(solved(planes, way), x)) << draw;
    }
}

TEST(SolvePlanes, a_power_of_two_larger_gives_the_same_bits) {
    std::mt19937 random(3);
    for (int draw = 0; draw < (INGOT_TEST_BRIEF ? 500 : 20000); ++draw) {
        Vector way;
        std::vector<MoverPlane> planes = any_planes(random, way);
        const Vector x = solved(planes, way);
        for (MoverPlane& plane : planes) plane.gap *= 64;
        ASSERT_TRUE(same(solved(planes, way * 64), x * 64)) << draw;
    }
}

TEST(SolvePlanes, way_that_is_free_keeps_its_bits_and_soft_planes_push_no_further_than_they_may) {
    MoverPlane floor;
    floor.n = {0, 0, 1};
    const Vector along = {scalar(0.3), scalar(-0.7), 0};
    EXPECT_TRUE(same(ingot::solve_planes(along, &floor, 1).value, along));
    EXPECT_TRUE(same(ingot::solve_planes(along, nullptr, 0).value, along));
    floor.gap = scalar(-0.5);
    EXPECT_EQ(ingot::solve_planes(along, &floor, 1).value.z, scalar(0.5));
    floor.push_max = scalar(0.125);
    EXPECT_EQ(ingot::solve_planes(along, &floor, 1).value.z, scalar(0.125));
}

TEST(ClipVelocity, leaves_what_no_surface_takes) {
    MoverPlane planes[2];
    planes[0].n = {0, 0, 1};
    planes[0].v = {5, 0, 3};  // a lift: what is along it does not count
    planes[1].n = {-1, 0, 0};
    const Vector v = ingot::clip_velocity({2, 1, -4}, planes, 2).value;
    EXPECT_TRUE(same(v, {0, 1, 3}));
    EXPECT_TRUE(same(ingot::clip_velocity({-2, 1, 4}, planes, 2).value, {-2, 1, 4}));
}

TEST(SolvePlanes, bad_input_is_refused) {
    MoverPlane planes[17];
    for (MoverPlane& plane : planes) plane.n = {0, 0, 1};
    const auto status = [&](const Vector& way, int count) {
        EXPECT_EQ(ingot::clip_velocity(way, planes, count).status, ingot::solve_planes(way, planes, count).status);
        return ingot::solve_planes(way, planes, count).status;
    };
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    EXPECT_EQ(status({1, 0, 0}, 16), Status::ok);
    EXPECT_EQ(status({1, 0, 0}, 17), Status::out_of_range);
    EXPECT_EQ(status({1, 0, 0}, -1), Status::out_of_range);
    EXPECT_EQ(status({1, nan, 0}, 1), Status::not_finite);
    for (int axis = 0; axis < 3; ++axis)
        for (const scalar far : {scalar(1e10), scalar(-1e10)})
            EXPECT_EQ(status({axis == 0 ? far : 0, axis == 1 ? far : 0, axis == 2 ? far : 0}, 1), Status::out_of_range);
    planes[1].n = {0, 0, scalar(1.01)};
    EXPECT_EQ(status({1, 0, 0}, 2), Status::bad_direction);
    planes[1].n = {0, 0, 1};
    const auto with = [&](auto change) {
        planes[1] = planes[0];
        change(planes[1]);
        EXPECT_EQ(status({1, 0, 0}, 1), Status::ok);
        return status({1, 0, 0}, 2);
    };
    EXPECT_EQ(with([&](MoverPlane& p) { p.gap = nan; }), Status::not_finite);
    EXPECT_EQ(with([&](MoverPlane& p) { p.n.y = nan; }), Status::not_finite);
    EXPECT_EQ(with([&](MoverPlane& p) { p.push_max = nan; }), Status::not_finite);
    EXPECT_EQ(with([&](MoverPlane& p) { p.v.z = nan; }), Status::not_finite);
    EXPECT_EQ(with([&](MoverPlane& p) { p.gap = scalar(-1e10); }), Status::out_of_range);
    EXPECT_EQ(with([&](MoverPlane& p) { p.v.x = scalar(1e7); }), Status::out_of_range);
    EXPECT_EQ(ingot::solve_planes({1, 0, 0}, nullptr, 1).status, Status::out_of_range);
}

} }  // namespace planes_of_way
