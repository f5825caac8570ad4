// SPDX-License-Identifier: MIT
// Figure 4: collision_impulse and World::collide against the table of exact collisions, and the laws of an impact.
#include <gtest/gtest.h>
#include <ingot/ingot.h>
#include <ingot/impulse/impulse.h>

#include <cstdio>

#include "reference/impulse_table.h"
#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_reference;
using ingot::scalar;
using Column = Eigen::Matrix<long double, 3, 1>;
using Square = Eigen::Matrix<long double, 3, 3>;

constexpr bool is_double = INGOT_DOUBLE != 0;
constexpr double u = static_cast<double>(roundoff<scalar>);
/// I1: relative, for impulse and velocities.
constexpr double bar = is_double ? 1e-13 : 1e-5;

struct Pair : ingot::Scene {
    static constexpr int max_bodies = 2;
    static constexpr bool translates = true;
};
using World = ingot::World<Pair>;

ingot::SymmetricMatrix to_symmetric(const Square& m) {
    const auto s = [](long double x) { return static_cast<scalar>(x); };
    return {s(m(0, 0)), s(m(1, 1)), s(m(2, 2)), s(m(0, 1)), s(m(0, 2)), s(m(1, 2))};
}

ingot::CollidingBody to_colliding(const ImpulseBody<long double>& b) {
    return {static_cast<scalar>(b.inv_M), to_symmetric(b.inv_I_world), to_vector(b.v), to_vector(b.omega), to_vector(b.r_P)};
}

double relative(long double computed, long double exact) { return static_cast<double>(std::abs(computed / exact - 1)); }

/// Relative to the larger of the velocities before and after: one that nearly vanishes has been subtracted from the other.
double relative(const ingot::Vector& computed, const Column& exact, const Column& before) {
    const double size = static_cast<double>(std::max(exact.norm(), before.norm()));
    return size > 0 ? largest_difference(to_eigen<long double>(computed), exact) / size : to_eigen(computed).norm();
}

TEST(CollisionImpulse, I1_agrees_with_the_table) {
    double worst = 0;
    for (const ImpulseCase& c : impulse_cases()) {
        const scalar j = collision_impulse(to_colliding(c.A), to_colliding(c.B), to_vector(c.n), static_cast<scalar>(c.e));
        worst = std::max(worst, relative(static_cast<long double>(j), c.j));
        ASSERT_LE(relative(static_cast<long double>(j), c.j), bar) << "row " << c.row + 1;
    }
    std::printf("    impulse, worst of 100 rows: %.1e relative\n", worst);
}

/// A at the origin, B where its offset leads to the same point P.
struct Collision {
    World world{};
    ingot::BodyId A, B;
    ingot::Vector P, n;
    explicit Collision(const ImpulseCase& c) : P(to_vector(c.A.r_P)), n(to_vector(c.n)) {
        ingot::BodyDef a = definition(static_cast<double>(c.M_A), c.I_A);
        a.state = {{},
                   to_vector(c.A.v),
                   to_matrix(c.A_A),
                   to_vector(Column(c.A_A * c.I_A.cwiseProduct(c.A_A.transpose() * c.A.omega)))};
        A = world.add(a).value;
        ingot::BodyDef b{};
        b.immovable = c.B_is_fixed();
        if (!b.immovable) b.mass = to_mass(static_cast<double>(c.M_B), c.I_B);
        b.state = {to_vector(Column(c.A.r_P - c.B.r_P)), to_vector(c.B.v), to_matrix(c.A_B),
                   to_vector(Column(c.A_B * c.I_B.cwiseProduct(c.A_B.transpose() * c.B.omega)))};
        B = world.add(b).value;
    }
};

TEST(Collide, I1_agrees_with_the_table) {
    double worst_j = 0, worst_v = 0, worst_omega = 0;
    int fixed = 0;
    for (const ImpulseCase& c : impulse_cases()) {
        if (c.B_is_fixed()) {
            ASSERT_EQ(c.v_B_after.norm() + c.omega_B_after.norm(), 0.0L);
            ++fixed;
        }
        Collision collision(c);
        World& world = collision.world;
        const ingot::Result<scalar> j =
            world.collide(collision.A, collision.B, collision.P, collision.n, static_cast<scalar>(c.e));
        ASSERT_EQ(j.status, ingot::Status::ok) << "row " << c.row + 1;
        const double off_j = relative(static_cast<long double>(j.value), c.j);
        const double off_v = std::max(relative(world.state(collision.A).value.v_CM, c.v_A_after, c.A.v),
                                      relative(world.state(collision.B).value.v_CM, c.v_B_after, c.B.v));
        const double off_omega = std::max(relative(world.omega(collision.A).value, c.omega_A_after, c.A.omega),
                                          relative(world.omega(collision.B).value, c.omega_B_after, c.B.omega));
        ASSERT_LE(off_j, bar) << "row " << c.row + 1;
        ASSERT_LE(off_v, bar) << "row " << c.row + 1;
        ASSERT_LE(off_omega, bar) << "row " << c.row + 1;
        worst_j = std::max(worst_j, off_j);
        worst_v = std::max(worst_v, off_v);
        worst_omega = std::max(worst_omega, off_omega);
    }
    EXPECT_EQ(fixed, 20);
    std::printf("    collide, worst of 100 rows: j %.1e, v %.1e, omega %.1e relative\n", worst_j, worst_v, worst_omega);
}

/// I2: the momentum of both together, to 2 ulp of the larger of the two. The momentum of each is counted in long double.
TEST(Collide, I2_keeps_linear_momentum) {
    for (const ImpulseCase& c : impulse_cases()) {
        if (c.B_is_fixed()) continue;
        Collision collision(c);
        const auto momentum = [&](ingot::BodyId id, long double M) -> Column {
            return M * to_eigen<long double>(collision.world.state(id).value.v_CM);
        };
        const long double M_A = static_cast<scalar>(c.M_A), M_B = static_cast<scalar>(c.M_B);
        const Column before = momentum(collision.A, M_A) + momentum(collision.B, M_B);
        ASSERT_TRUE(collision.world.collide(collision.A, collision.B, collision.P, collision.n, static_cast<scalar>(c.e)).ok());
        const Column A = momentum(collision.A, M_A), B = momentum(collision.B, M_B);
        const double larger = static_cast<double>(std::max({A.norm(), B.norm(), before.norm()}));
        ASSERT_LE(largest_difference(Column(A + B), before), 2 * 2 * u * larger) << "row " << c.row + 1;
    }
}

// Random pairs.

struct RandomPair {
    World world{};
    ingot::BodyId A, B;
    ingot::Vector P, n;
    double M[2];
    Column I[2];

    explicit RandomPair(RandomInput& random) {
        ingot::BodyId ids[2];
        for (int k = 0; k < 2; ++k) {
            M[k] = static_cast<double>(static_cast<scalar>(std::exp(random.real(-4, 4))));
            ingot::BodyDef def = definition(M[k], random.moments(M[k]));
            I[k] = to_eigen<long double>(def.mass.I_body);
            const Eigen::Matrix3d attitude = random.rotation();
            def.state = {to_vector(random.vector(2)), to_vector(random.vector(5)), to_matrix(attitude),
                         to_vector(attitude * I[k].cast<double>().cwiseProduct(random.vector(4)))};
            ids[k] = world.add(def).value;
        }
        A = ids[0];
        B = ids[1];
        P = to_vector(random.vector(2));
        n = to_vector(random.direction());
        if (approach() > 0) n = -n;
    }
    /// n.(v_AP - v_BP) from the primary state.
    double approach() const {
        return static_cast<double>(to_eigen<long double>(n).dot(velocity_at_P(A, 0) - velocity_at_P(B, 1)));
    }
    Column omega(ingot::BodyId id, int k) const {
        const ingot::BodyState s = world.state(id).value;
        const Square rotation = to_eigen<long double>(s.A);
        return rotation * (rotation.transpose() * to_eigen<long double>(s.L)).cwiseQuotient(I[k]);
    }
    Column velocity_at_P(ingot::BodyId id, int k) const {
        const ingot::BodyState s = world.state(id).value;
        return to_eigen<long double>(s.v_CM) + omega(id, k).cross(to_eigen<long double>(P) - to_eigen<long double>(s.r_CM));
    }
    long double energy() const {
        const auto of = [&](ingot::BodyId id, int k) {
            const ingot::BodyState s = world.state(id).value;
            return (static_cast<long double>(M[k]) * to_eigen<long double>(s.v_CM).squaredNorm() +
                    to_eigen<long double>(s.L).dot(omega(id, k))) /
                   2;
        };
        return of(A, 0) + of(B, 1);
    }
    /// About the origin.
    Column angular_momentum() const {
        const auto of = [&](ingot::BodyId id, int k) -> Column {
            const ingot::BodyState s = world.state(id).value;
            return to_eigen<long double>(s.r_CM).cross(static_cast<long double>(M[k]) * to_eigen<long double>(s.v_CM)) +
                   to_eigen<long double>(s.L);
        };
        return of(A, 0) + of(B, 1);
    }
};

TEST(Collide, I4_elastic_impact_keeps_the_energy) {
    RandomInput random(141);
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        RandomPair pair(random);
        const long double before = pair.energy();
        ASSERT_GT(pair.world.collide(pair.A, pair.B, pair.P, pair.n, 1).value, 0);
        worst = std::max(worst, relative(pair.energy(), before));
    }
    std::printf("    elastic impact, worst of 2000 pairs: energy %.1e relative\n", worst);
    EXPECT_LE(worst, is_double ? 1e-13 : 1e-6);
}

/// Without friction the energy changes by -(1 - e^2) j |v_n| / (2 (1 + e)): it never grows.
TEST(Collide, impact_takes_the_energy_that_restitution_says) {
    RandomInput random(142);
    for (int i = 0; i < 2000; ++i) {
        RandomPair pair(random);
        const scalar e = static_cast<scalar>(random.real(0, 1));
        const long double before = pair.energy();
        const double v_n = pair.approach();
        const double j = static_cast<double>(pair.world.collide(pair.A, pair.B, pair.P, pair.n, e).value);
        const double taken = static_cast<double>(before - pair.energy());
        // j is off by up to 20 roundings of its terms (a speed is a difference), and so is the energy, as in I4
        ASSERT_NEAR(taken, (1 - static_cast<double>(e)) * j * -v_n / 2,
                    (is_double ? 1e-13 : 1e-6) * static_cast<double>(before));
    }
}

TEST(Collide, points_part_with_restitution_times_their_speed) {
    RandomInput random(143);
    for (int i = 0; i < 2000; ++i) {
        RandomPair pair(random);
        const scalar e = i % 10 == 0 ? 0 : static_cast<scalar>(random.real(0, 1));
        const double before = pair.approach();
        const double terms = static_cast<double>(pair.velocity_at_P(pair.A, 0).norm() + pair.velocity_at_P(pair.B, 1).norm()) +
                             4 * static_cast<double>(pair.omega(pair.A, 0).norm() + pair.omega(pair.B, 1).norm());
        ASSERT_TRUE(pair.world.collide(pair.A, pair.B, pair.P, pair.n, e).ok());
        // v_n: 10 roundings of v and omega x r; K and j: 20 of |v_n|; omega after: 20 of itself. Speeds after are below 20
        // terms.
        ASSERT_NEAR(pair.approach(), -static_cast<double>(e) * before, 50 * 20 * u * terms);
    }
}

TEST(Collide, keeps_angular_momentum) {
    RandomInput random(144);
    for (int i = 0; i < 2000; ++i) {
        RandomPair pair(random);
        const Column before = pair.angular_momentum();
        const double j = static_cast<double>(pair.world.collide(pair.A, pair.B, pair.P, pair.n, 1).value);
        // r_P x j n about each centre: 4 roundings; M (v += j n / M): 4; levers are below 2 sqrt 3 + 2 sqrt 3, and the states
        // themselves are rounded once.
        const double size = static_cast<double>(before.norm()) + 7 * j + 30 * (pair.M[0] + pair.M[1]);
        ASSERT_LE(largest_difference(pair.angular_momentum(), before), 10 * u * size);
    }
}

TEST(Collide, who_is_called_A_does_not_matter) {
    RandomInput random(145);
    for (int i = 0; i < 500; ++i) {
        RandomPair there(random);
        RandomPair back = there;
        const scalar j = there.world.collide(there.A, there.B, there.P, there.n, scalar(0.5)).value;
        ASSERT_EQ(back.world.collide(back.B, back.A, back.P, -back.n, scalar(0.5)).value, j);
        ASSERT_EQ(there.world.state_hash(), back.world.state_hash());
    }
}

TEST(Collide, points_that_part_are_left_alone) {
    RandomInput random(146);
    for (int i = 0; i < 500; ++i) {
        RandomPair pair(random);
        const std::uint64_t before = pair.world.state_hash();
        const ingot::Result<scalar> j = pair.world.collide(pair.A, pair.B, pair.P, -pair.n, 1);
        ASSERT_TRUE(j.ok());
        ASSERT_EQ(j.value, 0);
        ASSERT_EQ(pair.world.state_hash(), before);
    }
}

/// I3: as slow as 1e-12 m/s, with a fast sideways motion; n is exact, so nothing is subtracted.
TEST(Collide, I3_grazing_impact) {
    for (const double v_n : {-1e-3, -1e-6, -1e-12, is_double ? -1e-300 : -1e-37}) {
        for (const scalar e : {scalar(0), scalar(1)}) {
            World world{};
            ingot::BodyDef def = definition(2, Eigen::Vector3d(1, 2, 2.5));
            def.state.v_CM = {100, -50, static_cast<scalar>(v_n)};
            const ingot::BodyId A = world.add(def).value;
            ingot::BodyDef floor{};
            floor.immovable = true;
            const ingot::BodyId B = world.add(floor).value;
            const ingot::Vector P = {scalar(0.5), scalar(-0.25), scalar(-1)};
            const scalar j = world.collide(A, B, P, {0, 0, 1}, e).value;
            // K = 1/M + ((r x n)_x^2 / 1 + (r x n)_y^2 / 2) with r x n = (-1/4, -1/2, 0)
            const double K = 0.5 + 0.0625 + 0.125,
                         exact = -(1 + static_cast<double>(e)) * static_cast<double>(static_cast<scalar>(v_n)) / K;
            EXPECT_NEAR(static_cast<double>(j) / exact, 1, 10 * u) << v_n;
            EXPECT_GT(j, 0);
            const ingot::BodyState s = world.state(A).value;
            EXPECT_EQ(s.v_CM.x, 100) << "no friction";
            EXPECT_EQ(s.v_CM.y, -50);
        }
    }
}

TEST(Collide, immovable_side_does_not_move) {
    RandomInput random(147);
    for (int i = 0; i < 200; ++i) {
        World world{};
        ingot::BodyDef def = definition(1, random.moments(1));
        def.state.v_CM = to_vector(random.vector(3));
        const ingot::BodyId A = world.add(def).value;
        ingot::BodyDef wall{};
        wall.immovable = true;
        wall.state.r_CM = to_vector(random.vector(1));
        wall.state.A = to_matrix(random.rotation());
        const ingot::BodyId B = world.add(wall).value;
        const ingot::BodyState before = world.state(B).value;
        const ingot::Vector v = def.state.v_CM;
        Eigen::Vector3d n = random.direction();
        if (n.dot(to_eigen(v)) > 0) n = -n;
        const bool swapped = i % 2 == 1;
        const scalar j = world
                             .collide(swapped ? B : A, swapped ? A : B, to_vector(random.vector(1)),
                                      to_vector(swapped ? Eigen::Vector3d(-n) : n), 1)
                             .value;
        ASSERT_GT(j, 0);
        const ingot::BodyState after = world.state(B).value;
        ASSERT_EQ(to_eigen(after.r_CM), to_eigen(before.r_CM));
        ASSERT_EQ(to_eigen(after.A), to_eigen(before.A));
        ASSERT_EQ(to_eigen(after.v_CM), Eigen::Vector3d(0, 0, 0));
        ASSERT_EQ(to_eigen(after.L), Eigen::Vector3d(0, 0, 0));
    }
}

}  // namespace
