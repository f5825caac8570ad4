// SPDX-License-Identifier: MIT
// How four normals of one manifold share a load that three could carry.
#include <gtest/gtest.h>
#include <ingot/solver/direct/normal_set.h>

#include <Eigen/Dense>

#include "reference/random_input.h"

namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;
using ingot_reference::RandomInput;

ingot::DirectVector direct(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Vector3d plain(const ingot::DirectVector& v) { return {v.x, v.y, v.z}; }

/// Four points of a plane between two bodies, or below one that stands on what cannot move: three are active, and carry something.
struct FourPoints {
    ingot::DirectBody bodies[3] = {};
    ingot::DirectView::Manifold manifold{};
    ingot::DirectRow rows[ingot::DirectView::row_count] = {};
    ingot::DirectView island{};
    Eigen::Matrix<double, 3, 4> balance;  ///< total and moments that impulses along the normals have
    Vector4d j;

    FourPoints(RandomInput& random, bool stands, const Vector4d& loads) : j(loads) {
        const Vector3d n = random.direction(), x = n.cross(random.direction()).normalized(), y = n.cross(x), middle = random.vector(1);
        for (int body_i = stands ? 2 : 1; body_i < 3; ++body_i) {
            bodies[body_i].inv_M = random.real(0.1, 2);
            bodies[body_i].linear = direct(random.vector(1));
            bodies[body_i].angular = direct(random.vector(1));
        }
        manifold.body[0] = stands ? 0 : 1;
        manifold.body[1] = 2;
        manifold.points = 4;
        manifold.rows = 15;
        manifold.active = 7;
        const Vector3d r_A = middle + random.vector(1), r_B = middle + random.vector(1);
        for (int row = 0; row < 4; ++row) {  // one in each quadrant
            const double along = random.real(0.2, 1) * ((row & 1) != 0 ? 1 : -1), across = random.real(0.2, 1) * ((row & 2) != 0 ? 1 : -1);
            const Vector3d P = middle + x * along + y * across;
            rows[row].d = direct(n);
            rows[row].J[0] = direct(stands ? Vector3d(Vector3d::Zero()) : Vector3d((P - r_A).cross(n)));
            rows[row].J[1] = direct(-(P - r_B).cross(n));
            rows[row].j = loads(row);
            balance.col(row) << 1, along, across;
        }
        island.bodies = bodies;
        island.rows = rows;
        island.manifolds = &manifold;
    }
    Vector4d impulses() const { return {rows[0].j, rows[1].j, rows[2].j, rows[3].j}; }
};

/// The impulses with the same total and the same moments that are most even, where none pulls: of j + s u, u being what `balance` does not see.
Vector4d most_even(const Eigen::Matrix<double, 3, 4>& balance, const Vector4d& j) {
    const Vector4d u = balance.fullPivLu().kernel().col(0).normalized();
    double low = -HUGE_VAL, high = HUGE_VAL;
    for (int i = 0; i < 4; ++i) (u(i) > 0 ? low : high) = u(i) > 0 ? std::max(low, -j(i) / u(i)) : std::min(high, -j(i) / u(i));
    return j + u * std::clamp(-u.dot(j), low, high);
}

/// Loads of up to 1, levers and sides of up to 4 m: sums of some tens of roundings, 1e-14, divided by areas that may be a hundredth of others.
constexpr double rounding = 1e-12;

TEST(NormalSet, spreads_a_load_as_evenly_as_none_pulls_and_moves_nothing) {
    RandomInput random(1);
    int inside = 0, at_bound = 0;
    for (int case_i = 0; case_i < 400; ++case_i) {
        Vector4d loads;
        for (int row = 0; row < 4; ++row) loads(row) = row < 3 ? random.real(0, 1) : 0;
        FourPoints four(random, case_i % 2 == 0, loads);
        const Vector3d linear[2] = {plain(four.bodies[1].linear), plain(four.bodies[2].linear)},
                       angular[2] = {plain(four.bodies[1].angular), plain(four.bodies[2].angular)};
        ingot::spread_load(four.island, four.manifold, four.rows);
        const Vector4d expected = most_even(four.balance, loads);
        EXPECT_LE((four.impulses() - expected).norm(), rounding) << case_i;
        EXPECT_LE((four.balance * (four.impulses() - loads)).norm(), rounding) << case_i;
        for (int i = 0; i < 2; ++i) {
            EXPECT_LE((plain(four.bodies[i + 1].linear) - linear[i]).norm(), rounding) << case_i;
            EXPECT_LE((plain(four.bodies[i + 1].angular) - angular[i]).norm(), rounding) << case_i;
        }
        ++(expected.minCoeff() > rounding ? inside : at_bound);
        // And back: the point that is no equation gives its load to the others, which are what they were.
        ingot::gather_load(four.island, four.manifold, four.rows);
        EXPECT_LE((four.impulses() - loads).norm(), rounding) << case_i;
        EXPECT_EQ(four.rows[3].j, 0);
    }
    EXPECT_GT(inside, 100);
    EXPECT_GT(at_bound, 10);
}

/// A load that is spread is left as it is; one that three points cannot be told from is, too.
TEST(NormalSet, leaves_what_is_even_or_has_not_four_points) {
    RandomInput random(2);
    for (int case_i = 0; case_i < 100; ++case_i) {
        Vector4d loads;
        for (int row = 0; row < 4; ++row) loads(row) = random.real(0.1, 1);
        FourPoints four(random, false, loads);
        ingot::spread_load(four.island, four.manifold, four.rows);
        const Vector4d once = four.impulses();
        ingot::spread_load(four.island, four.manifold, four.rows);
        EXPECT_LE((four.impulses() - once).norm(), rounding) << case_i;
        FourPoints few(random, false, loads);
        (case_i % 3 == 0 ? few.manifold.active : case_i % 3 == 1 ? few.manifold.rows : few.manifold.points) = 3;
        ingot::spread_load(few.island, few.manifold, few.rows);
        EXPECT_EQ(few.impulses(), loads) << case_i;
    }
}

}  // namespace
