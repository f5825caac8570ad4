// SPDX-License-Identifier: MIT
// The kernel's Listing 1 against the Eigen one, with gravity and forces at points.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include "reference/eigen_listing1.h"
#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_reference;
using ingot::scalar;
using Column = Eigen::Matrix<long double, 3, 1>;
using Square = Eigen::Matrix<long double, 3, 3>;
using Reference = Listing1Body<long double>;
using Force = ForceAtPoint<long double>;

struct Printed : ingot::Scene {
    static constexpr int max_bodies = 5;
    static constexpr bool translates = true;
    using rotation = ingot::Listing1Euler;
};
using World = ingot::World<Printed>;

constexpr double u = static_cast<double>(roundoff<scalar>);
constexpr scalar h = scalar(1) / 64;
const Eigen::Vector3d gravity(0.5, -0.25, -9.75);

struct Body {
    double M;
    Eigen::Vector3d I;
    Eigen::Vector3d P_body[2];  ///< where two forces attack
    ingot::BodyId id;
};

Body add_random_body(World& world, RandomInput& random) {
    Body body;
    body.M = std::ldexp(1, random.integer(-2, 3));
    body.I = to_eigen(to_vector(random.moments(body.M)));
    for (Eigen::Vector3d& P : body.P_body) P = random.vector(0.5);
    ingot::BodyDef def = definition(body.M, body.I);
    const Eigen::Matrix3d A = random.rotation();
    def.state = {to_vector(random.vector(4)), to_vector(random.vector(2)), to_matrix(A),
                 to_vector(A * body.I.cwiseProduct(random.vector(2)))};
    body.id = world.add(def).value;
    return body;
}

Reference reference_of(const World& world, const Body& body) {
    const ingot::BodyState s = world.state(body.id).value;
    return Reference::initialised(static_cast<long double>(body.M), body.I.cast<long double>(), to_eigen<long double>(s.r_CM),
                                  to_eigen<long double>(s.v_CM), to_eigen<long double>(s.A), to_eigen<long double>(s.L));
}

/// The forces of one step: two numbers of the kernel's type at a world point of the kernel's type each.
struct Push {
    ingot::Vector F, P;
};
std::vector<Push> pushes(const Body& body, const Reference& state, int step_i) {
    std::vector<Push> all;
    for (int k = 0; k < 2; ++k) {
        const double phase = 0.11 * step_i + k;
        const Eigen::Vector3d F = body.M * Eigen::Vector3d(3 * std::cos(phase), 2 * std::sin(2 * phase), std::sin(phase));
        all.push_back({to_vector(F), to_vector(Column(state.r + state.A * body.P_body[k].cast<long double>()))});
    }
    return all;
}

std::vector<Force> forces(const Body& body, const Reference& state, const std::vector<Push>& all) {
    std::vector<Force> result{{static_cast<long double>(body.M) * gravity.cast<long double>(), Column::Zero()}};
    for (const Push& push : all) result.push_back({to_eigen<long double>(push.F), to_eigen<long double>(push.P) - state.r});
    return result;
}

/// Both begin every step at the kernel's state, so the difference is the rounding of one step and can be counted.
TEST(Listing1, every_step_is_the_printed_one) {
    RandomInput random(101);
    World world{};
    ASSERT_EQ(world.set_gravity(to_vector(gravity)), ingot::Status::ok);
    std::vector<Body> bodies;
    for (int i = 0; i < Printed::max_bodies; ++i) bodies.push_back(add_random_body(world, random));

    for (int step_i = 0; step_i < 300; ++step_i) {
        std::vector<Reference> expected;
        std::vector<std::vector<Push>> all;
        for (const Body& body : bodies) {
            expected.push_back(reference_of(world, body));
            all.push_back(pushes(body, expected.back(), step_i));
            for (const Push& push : all.back()) ASSERT_EQ(world.add_force(body.id, push.F, push.P), ingot::Status::ok);
        }
        ASSERT_TRUE(ingot::step(world, h).clean());

        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const Reference before = expected[i];
            double sum_of_forces = 0, sum_of_moments = 0;  // of magnitudes
            for (const Push& push : all[i]) {
                sum_of_forces += length_of(to_eigen(push.F));
                sum_of_moments += length_of(to_eigen(push.F)) * (length_of(to_eigen(push.P)) + length_of(before.r));
            }
            expected[i].step(static_cast<long double>(h), forces(bodies[i], before, all[i]));
            const ingot::BodyState after = world.state(bodies[i].id).value;
            const double v_size = length_of(before.v), L_size = length_of(before.L), inv_I = 1 / bodies[i].I.minCoeff();

            // r + h v: a product and a sum
            ASSERT_LE(largest_difference(to_eigen(after.r_CM), expected[i].r), 2 * u * (length_of(before.r) + h * v_size));
            // two forces summed, times an inverse mass, plus g, times h, added to v: 6 roundings
            ASSERT_LE(largest_difference(to_eigen(after.v_CM), expected[i].v),
                      6 * u * (v_size + h * (sum_of_forces / bodies[i].M + gravity.norm())));
            // P - r, cross product, two summed, times h, added to L: 6 roundings
            ASSERT_LE(largest_difference(to_eigen(after.L), expected[i].L), 6 * u * (L_size + h * 2 * sum_of_moments));
            // Gram-Schmidt: below 40 (see maths/rotation_test.cpp). omega of step n, which the kernel has from I^-1 = A
            // I_body^-1 A^T with 6 roundings an entry and 3 of the product, in sums of three: 27, times h.
            ASSERT_LE(largest_difference(to_eigen(after.A), expected[i].A), (40 + 27 * h * inv_I * L_size) * u);
            // The error of A counts twice in I^-1, which is smaller than inv_I, and once more in sums of three.
            const double inv_I_error = 3 * (6 + 2 * (40 + 27 * h * inv_I * L_size)) * u * inv_I;
            ASSERT_LE(largest_difference(to_eigen(world.omega(bodies[i].id).value), expected[i].omega),
                      (inv_I_error + 3 * u * inv_I) * 1.8 * length_of(expected[i].L));
        }
    }
}

/// Distance of two states in A, and in the rest relative to scales of the motion.
double distance(const Reference& a, const Reference& b) {
    return std::max({largest_difference(a.A, b.A), largest_difference(a.L, b.L) / (1 + length_of(b.L)),
                     largest_difference(a.v, b.v) / (1 + length_of(b.v)), largest_difference(a.r, b.r) / (1 + length_of(b.r))});
}

/// Left alone, kernel and reference part as fast as roundings grow. How fast that is the reference itself tells: its twin,
/// moved by `nudge` at the begin, says what becomes of a deviation. Each of n steps adds at most 60 u (the bounds above).
TEST(Listing1, stays_with_the_printed_one_as_long_as_roundings_allow) {
    RandomInput random(102);
    constexpr double nudge = 1e-9;
    for (int body_i = 0; body_i < 5; ++body_i) {
        World world{};
        ASSERT_EQ(world.set_gravity(to_vector(gravity)), ingot::Status::ok);
        const Body body = add_random_body(world, random);
        Reference exact = reference_of(world, body), twin = exact;
        const Column axis = random.direction().cast<long double>();
        twin.A = Eigen::AngleAxis<long double>(static_cast<long double>(nudge), axis).toRotationMatrix() * twin.A;
        twin.L *= 1 + static_cast<long double>(nudge);
        twin.v *= 1 + static_cast<long double>(nudge);
        twin.compute_auxiliary();

        double growth = 1;
        for (int step_i = 0; step_i < 400; ++step_i) {
            for (const Push& push : pushes(body, reference_of(world, body), step_i))
                ASSERT_EQ(world.add_force(body.id, push.F, push.P), ingot::Status::ok);
            ASSERT_TRUE(ingot::step(world, h).clean());
            exact.step(static_cast<long double>(h), forces(body, exact, pushes(body, exact, step_i)));
            twin.step(static_cast<long double>(h), forces(body, twin, pushes(body, twin, step_i)));
            growth = std::max(growth, distance(twin, exact) / nudge);
            ASSERT_LE(distance(reference_of(world, body), exact), (step_i + 1) * 60 * u * growth) << "step " << step_i;
        }
    }
}

/// The baseline is as bad as it is said to be: explicit Euler gains energy, and keeps L.
TEST(Listing1, gains_energy_and_keeps_L) {
    RandomInput random(103);
    World world{};
    std::vector<Body> bodies;
    for (int i = 0; i < Printed::max_bodies; ++i) bodies.push_back(add_random_body(world, random));
    std::vector<ingot::BodyState> begin;
    std::vector<double> energy;
    for (const Body& body : bodies) {
        begin.push_back(world.state(body.id).value);
        const Reference r = reference_of(world, body);
        energy.push_back(static_cast<double>(r.L.dot(r.omega)));
    }
    for (int step_i = 0; step_i < 640; ++step_i) ASSERT_TRUE(ingot::step(world, h).clean());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        EXPECT_EQ(to_eigen(world.state(bodies[i].id).value.L), to_eigen(begin[i].L)) << "no torque: not one bit of L changes";
        const Reference r = reference_of(world, bodies[i]);
        EXPECT_GT(static_cast<double>(r.L.dot(r.omega)), energy[i]);
    }
}

}  // namespace
