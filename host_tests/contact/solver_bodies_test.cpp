// SPDX-License-Identifier: MIT
// What the solver gives back to the bodies: motion that is finite, or none.
#include <gtest/gtest.h>
#include <ingot/solver/sweeps/move_bodies.h>
#include <ingot/solver/sweeps/plan_islands.h>
#include <ingot/body/auxiliary.h>

#include <cstring>
#include <limits>

#include "reference/kernel_types.h"
#include "reference/random_input.h"
#include "stages/tiles.h"

namespace {

using ingot::scalar;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;
using ingot_reference::to_matrix;
using ingot_reference::to_vector;
using Eigen::Vector3d;

constexpr scalar h = scalar(1) / 64;
constexpr double eps = static_cast<double>(ingot::epsilon);
const ingot::Vector gravity = {0, 0, -8};

/// Two bodies, solver bodies 1 and 2, that have gone through a step: [0] is all that cannot move.
struct Solved {
    static constexpr int slots[3] = {0, 1, ingot::lanes + 1};
    ingot_stages::Tiles tiles{ingot::lanes + 2};
    ingot::SolverBody bodies[3] = {};
    ingot::SolverBodyHistory histories[3] = {};
    ingot::Island islands[2] = {};
    ingot::Index slot_of[3] = {0, 1, ingot::lanes + 1}, island_of[3] = {ingot::no_island, 0, 1}, batch_bodies[2] = {1, 2};
    Vector3d v[3], L[3], dp[3], L_sum[3];

    Solved() {
        RandomInput random(1471);
        for (int i = 1; i < 3; ++i) {
            ingot::BodyDef def = ingot_reference::definition(2, random.moments(2));
            def.state = {to_vector(random.vector(1)), to_vector(random.vector(1)), to_matrix(random.rotation()), to_vector(random.vector(1))};
            tiles.write(slots[i], def);
            tiles.rotation(slots[i]).kicked = 0;
            v[i] = random.vector(1), L[i] = random.vector(1), dp[i] = random.vector(0.01), L_sum[i] = random.vector(1) * ingot::limits::substeps;
            for (int k = 0; k < 3; ++k) {
                bodies[i].v_CM[k] = static_cast<scalar>(v[i](k)), bodies[i].L[k] = static_cast<scalar>(L[i](k));
                bodies[i].dp[k] = static_cast<scalar>(dp[i](k)), histories[i].L_sum[k] = static_cast<scalar>(L_sum[i](k));
            }
            bodies[i].v_CM[3] = scalar(0.5);
        }
        ingot::refresh_inv_I_world(tiles.view());
    }
    ingot::SolverView view() {
        ingot::SolverView solver{};
        solver.bodies = bodies, solver.histories = histories, solver.slot_of = slot_of;
        solver.body_count = 3;
        solver.islands = islands, solver.island_of = island_of, solver.batch_bodies = batch_bodies;
        solver.island_count = solver.batch_body_count = 2;
        for (ingot::Island& island : islands) island.in_batch = true;
        return solver;
    }
};

/// The forces that it leaves make integrate_v and integrate_r end with the velocity and at the place that the solver found.
TEST(SolverBodies, leave_the_motion_that_was_found) {
    Solved solved;
    ingot::write_contact_motion(solved.view(), ingot::NoJointedBodies{}, solved.tiles.view(), gravity, h);
    for (int i = 1; i < 3; ++i) {
        const int slot = Solved::slots[i], lane_i = slot % ingot::lanes;
        const ingot::BodyState state = solved.tiles.state(slot);
        EXPECT_LE((to_eigen(state.v_CM) - solved.v[i]).norm(), 8 * eps);
        EXPECT_LE((to_eigen(state.L) - solved.L[i]).norm(), 8 * eps);
        // With a = F/M + g: dp = (v - a h / 2) h.
        const Vector3d F = to_eigen(ingot::lane_of(solved.tiles.translation(slot).F_T, lane_i)), a = F * 0.5 + to_eigen(gravity);
        EXPECT_LE(((solved.v[i] - a * static_cast<double>(h) / 2) * static_cast<double>(h) - solved.dp[i]).norm(), 64 * eps);
        // With the mean L of the substeps in the middle: L - tau h / 2.
        const Vector3d tau = to_eigen(ingot::lane_of(solved.tiles.rotation(slot).tau_T, lane_i));
        EXPECT_LE((solved.L[i] - tau * static_cast<double>(h) / 2 - solved.L_sum[i] / ingot::limits::substeps).norm(), 64 * eps);
        EXPECT_EQ(solved.tiles.rotation(slot).bad, 0u);
        EXPECT_EQ(solved.tiles.rotation(slot).kicked, 1u << lane_i);
    }
}

TEST(SolverBodies, that_are_no_numbers_are_marked_and_left_as_they_were) {
    for (int part = 0; part < 4; ++part) {
        for (const scalar bad : {std::numeric_limits<scalar>::quiet_NaN(), -std::numeric_limits<scalar>::infinity()}) {
            Solved solved;
            const ingot::BodyState before = solved.tiles.state(1);
            ingot::SolverBody& body = solved.bodies[1];
            (part == 0 ? body.v_CM : part == 1 ? body.L : part == 2 ? body.dp : body.dth)[part % 3] = bad;
            ingot::write_contact_motion(solved.view(), ingot::NoJointedBodies{}, solved.tiles.view(), gravity, h);
            EXPECT_NE(solved.tiles.rotation(1).bad & 1u << (1 % ingot::lanes), 0u) << part;
            EXPECT_EQ(to_eigen(solved.tiles.state(1).v_CM), to_eigen(before.v_CM));
            EXPECT_EQ(to_eigen(solved.tiles.state(1).L), to_eigen(before.L));
            const int other = Solved::slots[2];
            EXPECT_EQ(solved.tiles.rotation(other).bad & 1u << (other % ingot::lanes), 0u) << "nobody else is";
            EXPECT_LE((to_eigen(solved.tiles.state(other).v_CM) - solved.v[2]).norm(), 8 * eps);
        }
    }
}

/// Beyond the drift of L_sum, dth turns A by Cayley's formula: a rotation about it by 2 atan(|push| / 2).
TEST(SolverBodies, turn_by_what_dth_has_beyond_the_drift) {
    RandomInput random(1472);
    for (int i = 0; i < 50; ++i) {
        Solved solved;
        const Vector3d push = random.vector(i % 2 == 0 ? 0.01 : 1);
        const Eigen::Matrix3d inv_I = to_eigen(ingot::lane_of(solved.tiles.translation(1).inv_I_world, 1 % ingot::lanes)),
                              A = to_eigen(solved.tiles.state(1).A);
        const Vector3d dth = push + inv_I * solved.L_sum[1] * static_cast<double>(h) / ingot::limits::substeps;
        for (int k = 0; k < 3; ++k) solved.bodies[1].dth[k] = static_cast<scalar>(dth(k));
        ingot::turn_by_corrections(solved.view(), ingot::NoJointedBodies{}, solved.tiles.view(), h);
        const Eigen::Matrix3d expected = Eigen::AngleAxisd(2 * std::atan(push.norm() / 2), push.normalized()).toRotationMatrix() * A;
        EXPECT_LE((to_eigen(solved.tiles.state(1).A) - expected).norm(), 64 * eps) << i;
    }
    // One that has gone bad is not turned, nor one whose turn is beyond all numbers.
    for (const bool bad : {true, false}) {
        Solved solved;
        const Eigen::Matrix3d A = to_eigen(solved.tiles.state(1).A);
        solved.bodies[1].dth[0] = bad ? scalar(1) : std::numeric_limits<scalar>::max();
        if (bad) solved.tiles.rotation(1).bad = static_cast<std::uint16_t>(1u << (1 % ingot::lanes));
        ingot::turn_by_corrections(solved.view(), ingot::NoJointedBodies{}, solved.tiles.view(), h);
        EXPECT_EQ(to_eigen(solved.tiles.state(1).A), A);
    }
}

/// v and L change by a h and tau h, what they were is kept, and each island knows its fastest speed: its sweeps end where the rounding of that is
/// all that is left.
TEST(SolverBodies, are_kicked_by_what_accelerates_them) {
    Solved solved;
    const Vector3d a(1, -2, 3), tau(-4, 5, 6);
    for (int i = 1; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            solved.histories[i].a[k] = static_cast<scalar>(i * a(k)), solved.histories[i].tau[k] = static_cast<scalar>(i * tau(k));
    ingot::SolverView solver = solved.view();
    ingot::kick_bodies(solver, h);
    double speed[3] = {};
    for (int i = 1; i < 3; ++i) {
        const ingot::SolverBody& body = solved.bodies[i];
        const Vector3d v(body.v_CM[0], body.v_CM[1], body.v_CM[2]), L(body.L[0], body.L[1], body.L[2]);
        // A product and a sum are rounded, of numbers up to 1 + 1/4 here.
        EXPECT_LE((v - solved.v[i] - a * i * static_cast<double>(h)).lpNorm<Eigen::Infinity>(), 2 * eps) << i;
        EXPECT_LE((L - solved.L[i] - tau * i * static_cast<double>(h)).lpNorm<Eigen::Infinity>(), 2 * eps) << i;
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(solved.histories[i].v_begin[k], static_cast<scalar>(solved.v[i](k)));
            EXPECT_EQ(solved.histories[i].L_begin[k], static_cast<scalar>(solved.L[i](k)));
        }
        speed[i] = v.norm();
    }
    const auto rounding = [&](int island_i) { return static_cast<double>(ingot::rounding_of_speeds(solved.islands[island_i], 1)); };
    for (int i = 1; i < 3; ++i) EXPECT_NEAR(rounding(i - 1), 4 * eps * speed[i], 16 * eps * eps) << "of its own body, " << i;

    // Both in one island: the faster one counts.
    solved.island_of[2] = 0;
    for (int i = 1; i < 3; ++i)
        for (int k = 0; k < 3; ++k) solved.histories[i].a[k] = 0;
    ingot::kick_bodies(solver, h);
    EXPECT_NEAR(rounding(0), 4 * eps * std::max(speed[1], speed[2]), 16 * eps * eps);

    solved.bodies[2].v_CM[0] = 2 * ingot::limits::rounding_speed_max;
    ingot::kick_bodies(solver, h);
    EXPECT_EQ(ingot::rounding_of_speeds(solved.islands[0], 1), 4 * ingot::epsilon * ingot::limits::rounding_speed_max);
}

/// Of a batch only its own bodies move: the others are at the end of their step already, or at its begin.
TEST(SolverBodies, of_other_batches_are_left_alone) {
    Solved solved;
    for (int i = 1; i < 3; ++i)
        for (int k = 0; k < 3; ++k) solved.histories[i].a[k] = solved.histories[i].tau[k] = 1;
    ingot::SolverView solver = solved.view();
    solved.islands[0].in_batch = false;
    solved.islands[0].fastest_sq = 7;
    solved.islands[0].steady = solved.islands[1].steady = true;
    solved.batch_bodies[0] = 2;
    solver.batch_body_count = 1;
    solver.substeps = ingot::limits::substeps;
    const ingot::SolverBody body[2] = {solved.bodies[1], solved.bodies[2]};
    const ingot::SolverBodyHistory history[2] = {solved.histories[1], solved.histories[2]};
    ingot::kick_bodies(solver, h);
    ingot::drift_bodies(solver, solved.tiles.view(), h);
    EXPECT_EQ(std::memcmp(&solved.bodies[1], &body[0], sizeof body[0]), 0);
    EXPECT_EQ(std::memcmp(&solved.histories[1], &history[0], sizeof history[0]), 0);
    EXPECT_EQ(solved.islands[0].fastest_sq, 7);
    EXPECT_TRUE(solved.islands[0].steady);
    EXPECT_NE(std::memcmp(&solved.bodies[2], &body[1], sizeof body[1]), 0);
    EXPECT_NE(std::memcmp(&solved.histories[2], &history[1], sizeof history[1]), 0);
    EXPECT_NE(solved.islands[1].fastest_sq, 0);
}

}  // namespace
