// SPDX-License-Identifier: MIT
// What free flight conserves, over random bodies and orientations.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <cstring>

#include "laws/bodies.h"
#include "reference/eigen_free_body.h"

namespace {

using namespace ingot_laws;
using namespace ingot_reference;

constexpr int count = 13;  // not a multiple of any number of lanes
constexpr scalar h = scalar(1) / 60;

struct Flyers : ingot::Scene {
    static constexpr int max_bodies = count;
    static constexpr bool translates = true;
};
using World = ingot::World<Flyers>;

/// Random solids of spins up to `spin` rad/s, anywhere, in motion.
std::vector<Known> add_random_bodies(World& world, RandomInput& random, double spin) {
    std::vector<Known> bodies;
    for (int i = 0; i < count; ++i) {
        const double M = random.real(0.1, 10);
        const Eigen::Vector3d I = random.moments(M);
        const Eigen::Matrix3d A = random.rotation();
        ingot::BodyDef def = definition(M, I);
        const Eigen::Vector3d axis = random.direction();
        const Eigen::Vector3d w_body = axis * random.real(0.1, spin);
        def.state = {to_vector(random.vector(10)), to_vector(random.vector(3)), to_matrix(A),
                     to_vector(A * I.cwiseProduct(w_body))};
        bodies.push_back(add(world, def));
    }
    return bodies;
}

std::vector<ingot::BodyState> states(const World& world, const std::vector<Known>& bodies) {
    std::vector<ingot::BodyState> all;
    for (const Known& body : bodies) all.push_back(world.state(body.id).value);
    return all;
}

TEST(FreeFlight, torque_free_body_keeps_L) {
    RandomInput random(201);
    World world{};
    const std::vector<Known> bodies = add_random_bodies(world, random, 100);
    const std::vector<ingot::BodyState> begin = states(world, bodies);
    ASSERT_EQ(world.set_gravity({1, 2, -9}), ingot::Status::ok);
    for (int step_i = 0; step_i < 2000; ++step_i) {
        for (const Known& body : bodies)  // a force through the centre of mass is no torque
            ASSERT_EQ(world.add_central_force(body.id, to_vector(random.vector(10))), ingot::Status::ok);
        ASSERT_TRUE(ingot::step(world, h).clean());
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const ingot::Vector L = world.state(bodies[i].id).value.L;
        EXPECT_EQ(std::memcmp(&L, &begin[i].L, sizeof L), 0) << "body " << i;
    }
}

/// What is left over 10^4 steps is the rounding of A, in which y = A^T L is counted: 3 roundings of each of its terms, twice in
/// y^2, times the ratio of moments (20) that a small error of direction may cost.
TEST(FreeFlight, energy_of_a_free_body_stays) {
    RandomInput random(202);
    World world{};
    const std::vector<Known> bodies = add_random_bodies(world, random, 20);
    const std::vector<ingot::BodyState> begin = states(world, bodies);
    for (int step_i = 0; step_i < 10'000; ++step_i) {
        ASSERT_TRUE(ingot::step(world, h).clean());
        if (step_i % 100 != 99) continue;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const long double ratio =
                rotation_energy(world.state(bodies[i].id).value, bodies[i].I) / rotation_energy(begin[i], bodies[i].I);
            ASSERT_LE(static_cast<double>(std::abs(ratio - 1)), 6 * 20 * u) << "body " << i << ", step " << step_i;
        }
    }
}

/// R9's bar, after 10^5 steps and along the way; spins below 15 rad/s turn at most 1/4 rad a step.
TEST(FreeFlight, attitude_stays_orthonormal) {
    RandomInput random(203);
    World world{};
    const std::vector<Known> bodies = add_random_bodies(world, random, 3);
    double worst = 0;
    for (int step_i = 0; step_i < 100'000; ++step_i) {
        (void)ingot::step(world, h);
        if (step_i % 997 != 0) continue;
        for (const Known& body : bodies) worst = std::max(worst, orthogonality_defect(attitude(world, body)));
    }
    std::printf("    orthogonality, worst over 1e5 steps: %.1e\n", worst);
    EXPECT_LE(worst, bar(1e-14, 3e-7));
    for (const Known& body : bodies) EXPECT_NEAR(static_cast<double>(attitude(world, body).determinant()), 1, bar(2e-14, 5e-7));
}

/// The path of the centre of mass knows nothing of the rotation: it is the parabola, whatever the body does.
TEST(FreeFlight, rotation_does_not_move_the_centre_of_mass) {
    RandomInput random(204);
    World turning{}, still{};
    std::vector<Known> bodies = add_random_bodies(turning, random, 50);
    std::vector<Known> twins;
    for (const Known& body : bodies) {
        ingot::BodyDef def = definition(static_cast<double>(body.M), body.I);
        def.state = turning.state(body.id).value;
        def.state.L = {};
        twins.push_back(add(still, def));
    }
    ASSERT_EQ(turning.set_gravity({0, 0, -10}), ingot::Status::ok);
    ASSERT_EQ(still.set_gravity({0, 0, -10}), ingot::Status::ok);
    for (int step_i = 0; step_i < 600; ++step_i) {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            ASSERT_EQ(turning.add_torque(bodies[i].id, to_vector(random.vector(1))), ingot::Status::ok);
        }
        ASSERT_TRUE(ingot::step(turning, h).clean());
        ASSERT_TRUE(ingot::step(still, h).clean());
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        EXPECT_EQ(position(turning, bodies[i]), position(still, twins[i]));
        EXPECT_EQ(velocity(turning, bodies[i]), velocity(still, twins[i]));
    }
}

/// Neither force nor time moves it, nor does a polar step round its A.
TEST(FreeFlight, immovable_body_keeps_its_pose_bitwise) {
    RandomInput random(207);
    World world{};
    std::vector<ingot::BodyId> walls;
    for (int i = 0; i < count; ++i) {
        ingot::BodyDef wall{};
        wall.immovable = true;
        wall.state.r_CM = to_vector(random.vector(10));
        wall.state.A = to_matrix(random.rotation());
        walls.push_back(world.add(wall).value);
    }
    ASSERT_EQ(world.set_gravity({0, 0, -10}), ingot::Status::ok);
    std::vector<ingot::BodyState> begin;
    for (const ingot::BodyId id : walls) begin.push_back(world.state(id).value);
    for (int step_i = 0; step_i < 100; ++step_i) ASSERT_TRUE(ingot::step(world, h).clean());
    for (std::size_t i = 0; i < walls.size(); ++i) {
        EXPECT_EQ(world.add_central_force(walls[i], {1, 0, 0}), ingot::Status::immovable);
        const ingot::BodyState end = world.state(walls[i]).value;
        EXPECT_EQ(std::memcmp(&end, &begin[i], sizeof end), 0) << "wall " << i;
    }
}

/// An impulse at a point is v += j / M, L += r x j, at once; and what it did it undoes.
TEST(FreeFlight, impulse_and_its_opposite_cancel) {
    RandomInput random(205);
    World world{};
    const std::vector<Known> bodies = add_random_bodies(world, random, 5);
    const std::vector<ingot::BodyState> begin = states(world, bodies);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const ingot::Vector j = to_vector(random.vector(5)), P = to_vector(random.vector(5));
        ASSERT_EQ(world.apply_impulse(bodies[i].id, j, P), ingot::Status::ok);
        const ingot::BodyState s = world.state(bodies[i].id).value;
        const Column lever = to_eigen<long double>(P) - to_eigen<long double>(s.r_CM), impulse = to_eigen<long double>(j);
        const Column v = to_eigen<long double>(begin[i].v_CM) + impulse / bodies[i].M,
                     L = to_eigen<long double>(begin[i].L) + lever.cross(impulse);
        // 1 / M, j / M, and the sum; P - r, two products, their difference, and the sum
        EXPECT_LE(largest_difference(to_eigen(s.v_CM), v),
                  3 * u * (length_of(v) + length_of(impulse) / static_cast<double>(bodies[i].M)));
        EXPECT_LE(largest_difference(to_eigen(s.L), L), 5 * u * (length_of(L) + 2 * length_of(lever) * length_of(impulse)));
        ASSERT_EQ(world.apply_impulse(bodies[i].id, -j, P), ingot::Status::ok);
        const ingot::BodyState back = world.state(bodies[i].id).value;
        EXPECT_LE(largest_difference(to_eigen(back.v_CM), to_eigen(begin[i].v_CM)),
                  2 * u * length_of(v) + u * length_of(to_eigen(begin[i].v_CM)));
        EXPECT_LE(largest_difference(to_eigen(back.L), to_eigen(begin[i].L)),
                  2 * u * length_of(L) + u * length_of(to_eigen(begin[i].L)));
    }
}

/// A force at a point over one step is the impulse h F at that point: for L and v to the last rounding.
TEST(FreeFlight, force_at_a_point_is_an_impulse_spread_over_the_step) {
    RandomInput random(206);
    World pushed{}, kicked{};
    const std::vector<Known> bodies = add_random_bodies(pushed, random, 5);
    std::memcpy(static_cast<void*>(&kicked), &pushed, sizeof kicked);
    for (const Known& body : bodies) {
        const ingot::Vector F = to_vector(random.vector(5)), P = to_vector(random.vector(5));
        ASSERT_EQ(pushed.add_force(body.id, F, P), ingot::Status::ok);
        ASSERT_EQ(kicked.apply_impulse(body.id, F * scalar(0.015625), P), ingot::Status::ok);
    }
    ASSERT_TRUE(ingot::step(pushed, scalar(0.015625)).clean());  // 2^-6: h F is exact
    for (const Known& body : bodies) {
        EXPECT_EQ(to_eigen(pushed.state(body.id).value.L), to_eigen(kicked.state(body.id).value.L));
        const Eigen::Vector3d v = velocity(kicked, body);
        EXPECT_LE(largest_difference(velocity(pushed, body), v), 2 * u * length_of(v));
    }
}

}  // namespace
