// SPDX-License-Identifier: MIT
// The auxiliary state (Eqs. 18 and 20) and the motion of points of a body (Eqs. 10 to 13).
#include <gtest/gtest.h>
#include <ingot/body/auxiliary.h>
#include <ingot/body/kinematics.h>

#include <limits>

#include "reference/eigen_free_body.h"
#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "reference/random_input.h"
#include "tiles.h"

namespace {

using namespace ingot_reference;
using ingot::scalar;
using ingot_stages::Tiles;
using Column = Eigen::Matrix<long double, 3, 1>;
using Square = Eigen::Matrix<long double, 3, 3>;

constexpr double u = static_cast<double>(roundoff<scalar>);

TEST(Auxiliary, is_the_similarity_transform_and_the_spin_of_L) {
    RandomInput random(121);
    const int slots = 3 * ingot::lanes + 1;
    for (int round = 0; round < 50; ++round) {
        Tiles tiles(slots);
        std::vector<ingot::BodyDef> defs;
        for (int slot = 0; slot < slots; ++slot) {
            const Eigen::Vector3d moments = random.moments(1);
            ingot::BodyDef def = definition(1, Eigen::Vector3d(moments * std::abs(random.of_any_size(-10, 10))));
            def.state.A = to_matrix(random.rotation());
            def.state.L = to_vector(random.vector(5));
            tiles.write(slot, def);
            defs.push_back(def);
            ingot::set_lane(tiles.translation(slot).inv_I_world, slot % ingot::lanes, ingot::SymmetricMatrix{});
        }
        ingot::refresh_inv_I_world(tiles.view());
        for (int slot = 0; slot < slots; ++slot) {
            const ingot::BodyState s = tiles.state(slot);
            const Square A = to_eigen<long double>(s.A);
            const Column J = to_eigen<long double>(defs[static_cast<std::size_t>(slot)].mass.I_body).cwiseInverse();
            const Square inv_I = A * J.asDiagonal() * A.transpose();
            const Square computed =
                to_eigen<long double>(ingot::lane_of(tiles.translation(slot).inv_I_world, slot % ingot::lanes));
            // 1 / I and its scaling: 2 roundings; a product and three products summed: 4
            ASSERT_LE(worst_relative_error(computed, inv_I, Square(A.cwiseAbs() * J.asDiagonal() * A.cwiseAbs().transpose())),
                      gamma<scalar>(6));
            const Column L = to_eigen<long double>(s.L);
            const Column omega = inv_I * L;
            // A^T L: 3 roundings; 1 / I and its scaling, and their product with it: 3; A times that: 3
            ASSERT_LE(worst_relative_error(to_eigen<long double>(ingot::omega_of(tiles.view(), slot)), omega,
                                           Column(A.cwiseAbs() * J.asDiagonal() * A.cwiseAbs().transpose() * L.cwiseAbs())),
                      gamma<scalar>(9));
        }
    }
}

/// Half above limits::spin_runaway and half below, in every lane; a spin that is no number counts as above.
TEST(Auxiliary, spins_that_ran_away_are_marked) {
    const int slots = 2 * ingot::lanes + 1;
    for (int parity : {0, 1}) {
        Tiles tiles(slots);
        const auto runs_away = [&](int slot) { return slot % 2 == parity; };
        for (int slot = 0; slot < slots; ++slot) {
            tiles.write(slot, definition(1, Eigen::Vector3d(2, 2, 2)));
            const scalar omega = ingot::limits::spin_runaway * (runs_away(slot) ? scalar(1.001) : scalar(0.999));
            ingot::set_lane(tiles.rotation(slot).L, slot % ingot::lanes, ingot::Vector{0, 2 * omega, 0});
        }
        if (runs_away(slots - 1)) tiles.rotation(slots - 1).L[0][(slots - 1) % ingot::lanes] = std::numeric_limits<scalar>::quiet_NaN();
        ingot::mark_runaway_spins(tiles.view());
        for (int slot = 0; slot < slots; ++slot) EXPECT_EQ(ingot::is_frozen(tiles.view(), slot), runs_away(slot)) << "slot " << slot;
    }
}

TEST(Auxiliary, immovable_bodies_have_neither) {
    Tiles tiles(1);
    ingot::BodyDef wall{};
    wall.immovable = true;
    tiles.write(0, wall);
    ingot::refresh_inv_I_world(tiles.view());
    EXPECT_EQ(to_eigen(ingot::lane_of(tiles.translation(0).inv_I_world, 0)), Eigen::Matrix3d(Eigen::Matrix3d::Zero()));
    EXPECT_EQ(to_eigen(ingot::omega_of(tiles.view(), 0)), Eigen::Vector3d(0, 0, 0));
}

/// Eq. 17 and Eq. 18 are inverses of each other.
TEST(Kinematics, L_of_a_spin_gives_the_spin_back) {
    RandomInput random(123);
    for (int i = 0; i < 500; ++i) {
        const ingot::Matrix A = to_matrix(random.rotation());
        const ingot::Vector I = to_vector(random.moments(2)), omega = to_vector(random.vector(3));
        const ingot::Vector L = angular_momentum_of_spin(A, I, omega);
        const ingot::Vector back = inverse_inertia_world(A, ingot::Vector{1 / I.x, 1 / I.y, 1 / I.z}) * L;
        // 3 + 1 + 3 roundings in L and 4 + 1 + 3 in omega, A orthonormal to 4 u, all times at most the ratio of moments (20).
        ASSERT_LE(largest_difference(to_eigen(back), to_eigen(omega)), 20 * 23 * u * to_eigen(omega).norm());
    }
}

using WideColumn = ingot::Vec3<long double>;
WideColumn wide(const Column& v) { return {v(0), v(1), v(2)}; }
ingot::Mat3<long double> wide(const Square& m) {
    return {wide(Column(m.col(0))), wide(Column(m.col(1))), wide(Column(m.col(2)))};
}

/// Where a point of a freely flying body is: o = r_0 + v t + a t^2 / 2, and the body turns as it does.
struct Flight {
    Column r_0, v_0, a, I, L, r_body;
    Square A_0;

    explicit Flight(RandomInput& random)
        : r_0(random.vector(3).cast<long double>()),
          v_0(random.vector(3).cast<long double>()),
          a(random.vector(3).cast<long double>()),
          I(random.moments(1).cast<long double>()),
          r_body(random.vector(1).cast<long double>()),
          A_0(random.rotation().cast<long double>()) {
        A_0 += A_0 * (Square::Identity() - A_0.transpose() * A_0) / 2;  // orthonormal to long double
        L = A_0 * I.cwiseProduct(random.vector(3).cast<long double>());
    }
    FreeBody body_at(long double t) const {
        FreeBody body(I, A_0, L);
        body.advance(t);
        return body;
    }
    /// Eq. 11.
    Column point_at(long double t) const {
        const WideColumn b =
            ingot::point_position(wide(Column(r_0 + v_0 * t + a * t * t / 2)), wide(body_at(t).A()), wide(r_body));
        return to_eigen<long double>(b);
    }
};

// Central differences over d = 2^-10 s leave d^2/6 of the third (d^2/12 of the fourth) derivative; with |omega| < 20 rad/s and
// |r| < 1.8 m that is below 2^-20 / 6 * 1.8 * 20^3 = 2.3e-3 (times 20 and halved for the acceleration). One Richardson step
// from 2 d leaves d^4 |omega|^5 |r| / 30 = 2e-7 (and 4e-6), rounding 1e-19 / d = 1e-16 (1e-13).
constexpr long double d = 0x1p-10L;

Column first_derivative(const Flight& f) {
    const auto difference = [&](long double s) -> Column { return (f.point_at(s) - f.point_at(-s)) / (2 * s); };
    return (4 * difference(d) - difference(2 * d)) / 3;
}
Column second_derivative(const Flight& f) {
    const auto difference = [&](long double s) -> Column {
        return (f.point_at(s) - 2 * f.point_at(0) + f.point_at(-s)) / (s * s);
    };
    return (4 * difference(d) - difference(2 * d)) / 3;
}

TEST(Kinematics, velocity_of_a_point_is_the_rate_of_its_position) {
    RandomInput random(124);
    for (int i = 0; i < 50; ++i) {
        const Flight f(random);
        const Column omega = f.body_at(0).omega(), r = f.A_0 * f.r_body;
        const Column v = to_eigen<long double>(ingot::point_velocity(wide(f.v_0), wide(omega), wide(r)));
        ASSERT_LE(largest_difference(v, first_derivative(f)), 2e-7);
    }
}

TEST(Kinematics, acceleration_of_a_point_is_the_second_rate_of_its_position) {
    RandomInput random(125);
    for (int i = 0; i < 50; ++i) {
        const Flight f(random);
        const Column omega = f.body_at(0).omega(), r = f.A_0 * f.r_body;
        const Square inv_I = f.A_0 * f.I.cwiseInverse().asDiagonal() * f.A_0.transpose();
        const Column alpha = -inv_I * omega.cross(f.L);  // dL/dt = 0
        const Column a = to_eigen<long double>(ingot::point_acceleration(wide(f.a), wide(alpha), wide(omega), wide(r)));
        ASSERT_LE(largest_difference(a, second_derivative(f)), 4e-6);
    }
}

/// Eq. 10.
TEST(Kinematics, rate_of_the_orientation_is_that_of_its_columns) {
    RandomInput random(126);
    for (int i = 0; i < 50; ++i) {
        const Flight f(random);
        const Square rate = to_eigen<long double>(ingot::orientation_rate(wide(f.body_at(0).omega()), wide(f.A_0)));
        const auto difference = [&](long double s) -> Square { return (f.body_at(s).A() - f.body_at(-s).A()) / (2 * s); };
        ASSERT_LE(largest_difference(rate, Square((4 * difference(d) - difference(2 * d)) / 3)), 2e-7);
    }
}

}  // namespace
