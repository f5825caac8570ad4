// SPDX-License-Identifier: MIT
// The exact constrained substep, by its laws, by closed forms, and by the contact reference, which shares nothing with it.
#include "joints/constrained_step_reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "joints/constrained_reference.h"
#include "joints/figure_scenes.h"
#include "reference/contact_problems.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_figures;
using ingot_reference::RandomInput;

constexpr double bar = 1e-10;

/// Two ways through the same laws: sets tried one by one, and pivoting. W of fewer columns than rows is singular.
TEST(BoundedProblem, pivoting_agrees_with_enumeration) {
    RandomInput random(11);
    for (int draw = 0; draw < 200; ++draw) {
        const int n = random.integer(1, 7), columns = random.integer(std::max(1, n - 3), n + 2);
        Eigen::MatrixXd B(columns, n);
        for (int i = 0; i < columns; ++i)
            for (int j = 0; j < n; ++j) B(i, j) = random.real(-1, 1);
        // q in the range of W, so that a solution exists whatever the bounds.
        Eigen::VectorXd x(columns);
        for (int i = 0; i < columns; ++i) x(i) = random.real(-1, 1);
        BoundedProblem problem{B.transpose() * B, B.transpose() * x, Eigen::VectorXd::Zero(n), Eigen::VectorXd::Constant(n, infinity)};
        for (int i = 0; i < n; ++i) {
            if (random.integer(0, 2) != 0) continue;
            problem.lower(i) = -random.real(0, 0.5);
            problem.upper(i) = random.real(0, 0.5);
        }
        const Eigen::VectorXd by_sets = solve_by_enumeration(problem), by_pivots = solve_by_pivoting(problem);
        EXPECT_LE(problem.miss(by_sets), bar) << draw;
        EXPECT_LE(problem.miss(by_pivots), bar) << draw;
        EXPECT_LE((B * (by_sets - by_pivots)).norm(), 1e-8) << draw;  // velocities are unique
    }
}

/// Contacts alone, without friction: the contact reference.
TEST(ConstrainedStep, contacts_agree_with_the_contact_reference) {
    RandomInput random(5);
    for (int draw = 0; draw < 50; ++draw) {
        ingot_reference::ContactProblem problem;
        problem.bodies.emplace_back();
        const int bodies = random.integer(1, 4), points = random.integer(1, 10);
        std::vector<StepBody> step{StepBody()};
        for (int body_i = 1; body_i <= bodies; ++body_i) {
            const double M = std::ldexp(1.0, random.integer(0, 8));
            const Matrix3d A = random.rotation();
            ingot_reference::ContactBody body;
            body.inv_M = 1 / M;
            body.inv_I_world = A * random.moments(M).cwiseInverse().asDiagonal() * A.transpose();
            body.r_CM = Vector3d(0, 0, body_i);
            body.v_CM = random.vector(1) - Vector3d(0, 0, 1);
            body.omega = random.vector(1);
            problem.bodies.push_back(body);
            step.push_back({body.inv_M, body.inv_I_world, body.r_CM, body.v_CM, body.omega, Vector3d::Zero(), Vector3d::Zero()});
        }
        std::vector<StepRow> rows;
        for (int point_i = 0; point_i < points; ++point_i) {  // normals lean upwards onto the body of the larger number: no contradiction
            const int body_A = random.integer(1, bodies), body_B = random.integer(0, body_A - 1);
            const Vector3d n = (random.direction() + Vector3d(0, 0, 1.5)).normalized();
            const ingot_reference::ContactPoint point =
                ingot_reference::point_between(body_A, body_B, Vector3d(0, 0, body_A - 0.5) + random.vector(0.4), n, 0);
            problem.points.push_back(point);
            rows.push_back({point_row(step, body_B, point.r_P, body_A, point.r_P, n), 0, 0, 0, infinity});
        }
        const ingot_reference::ContactSolution exact = ingot_reference::solve_contacts_without_friction(problem);
        for (const BoundedBy method : {BoundedBy::enumeration, BoundedBy::pivoting}) {
            const StepSolution solution = solve_step(step, rows, method);
            EXPECT_LE(solution.miss, 1e-9);
            for (std::size_t body_i = 1; body_i < step.size(); ++body_i) {
                EXPECT_LE((solution.v_CM[body_i] - exact.v_CM[body_i]).norm(), 1e-8) << draw;
                EXPECT_LE((solution.omega[body_i] - exact.omega[body_i]).norm(), 1e-8) << draw;
            }
        }
    }
}

std::vector<StepRow> held_rows(const JointRows& rows, const FigureState& state, double h, bool second_order) {
    std::vector<StepRow> all;
    for (int joint_i = 0; joint_i < rows.scene().joint_count(); ++joint_i) {
        const FigureJoint& joint = rows.scene().joint(joint_i);
        const auto ahead = [&](int body_i) { return rotation_ahead(rows.scene(), state, body_i, h); };
        const JointTarget target = second_order ? second_order_target(rows, state, joint_i, h, ahead(joint.body_A), ahead(joint.body_B))
                                                : plain_target(rows, state, joint_i, h);
        for (const StepRow& row : locked_rows(rows, state, joint_i, target)) all.push_back(row);
    }
    return all;
}

std::vector<StepBody> under_forces(const JointRows& rows, const FigureState& state, double h) {
    const FigureScene& scene = rows.scene();
    std::vector<StepBody> bodies = step_bodies(scene, state);
    const AppliedLoads loads = applied_loads(rows, state);
    const FigureInertia inertia(scene, state);
    for (std::size_t body_i = 0; body_i < bodies.size(); ++body_i) {
        StepBody& body = bodies[body_i];
        body.impulse = h * loads.force[body_i];
        body.angular_impulse = h * (loads.torque[body_i] - body.omega.cross(inertia.I(static_cast<int>(body_i)) * body.omega));
    }
    return bodies;
}

/// Without contact a substep goes over into the exact motion as h does.
TEST(ConstrainedStep, goes_over_into_the_exact_motion) {
    const FigureScene scene = mixed_tree(true, 3);
    const JointRows rows(scene);
    const FigureState start = start_of(scene);
    double last = 0, last_h = 0;
    for (const double h : {4e-3, 2e-3, 1e-3, 5e-4}) {
        const StepSolution solution = solve_step(under_forces(rows, start, h), held_rows(rows, start, h, true));
        ConstrainedReference exact(scene);
        exact.advance_to(h);
        double error = 0;
        for (int body_i = 0; body_i < scene.body_count(); ++body_i) {
            const std::size_t i = static_cast<std::size_t>(body_i);
            error = std::max(
                {error, (solution.v_CM[i] - exact.state().body(body_i).v_CM).norm(), (solution.omega[i] - exact.state().body(body_i).omega).norm()});
        }
        // Velocities that carry positions over h are those of its middle, h/2 before the exact ones: off by half an acceleration.
        if (last > 0) {
            EXPECT_NEAR(std::log(last / error) / std::log(last_h / h), 1, 0.2);
        }
        last = error;
        last_h = h;
    }
}

/// The free velocities, less what joints forbid, are the nearest that joints allow: any allowed motion is square to the change (Gauss).
TEST(ConstrainedStep, changes_velocities_least) {
    const FigureScene scene = ragdoll_20();
    const JointRows rows(scene);
    RandomInput random(4);
    FigureState state = start_of(scene), other = state;
    for (FigureState* each : {&state, &other})
        for (BodyMotion& body : each->bodies) {
            body.v_CM = random.vector(1);
            body.omega = random.vector(3);
        }
    const std::vector<StepRow> held = held_rows(rows, start_of(scene), 1, false);
    const StepSolution solution = solve_step(step_bodies(scene, state), held), allowed = solve_step(step_bodies(scene, other), held);
    EXPECT_LE(solution.unmet, 1e-13);
    double product = 0, size = 0;
    const FigureInertia inertia(scene, state);
    for (int body_i = 0; body_i < scene.body_count(); ++body_i) {
        const std::size_t i = static_cast<std::size_t>(body_i);
        const Vector3d dv = solution.v_CM[i] - state.body(body_i).v_CM, dw = solution.omega[i] - state.body(body_i).omega;
        const double p = scene.body(body_i).M * dv.dot(allowed.v_CM[i]), L = dw.dot(inertia.I(body_i) * allowed.omega[i]);
        product += p + L;
        size += std::abs(p) + std::abs(L);
    }
    EXPECT_LE(std::abs(product), 1e-12 * size);
}

/// Rotating at a steady rate, with rotations known ahead, targets of second order end together; plain ones miss by (omega h)^2.
TEST(ConstrainedStep, second_order_targets_close_gaps) {
    FigureScene scene;
    const Vector3d spin(0, 0, 3);
    for (const double x : {-0.5, 0.5}) {
        FigureBody body = box(1, Vector3d(0.5, 0.1, 0.1), Vector3d(x, 0, 0));
        body.omega = spin;
        body.v_CM = spin.cross(body.r_CM);
        scene.add(body);
    }
    scene.g.setZero();
    scene.join(hinge(0, 1, Vector3d::Zero(), Vector3d::UnitZ()));
    const JointRows rows(scene);
    FigureState state = start_of(scene);
    state.body(1).r_CM += Vector3d(1e-3, 2e-3, -1e-3);  // apart
    const auto gap_after = [&](double h, bool second_order) {
        const StepSolution solution = solve_step(step_bodies(scene, state), held_rows(rows, state, h, second_order));
        FigureState after = with_velocities(state, solution);
        for (std::size_t body_i = 0; body_i < 2; ++body_i) {
            after.bodies[body_i].r_CM += h * after.bodies[body_i].v_CM;
            after.bodies[body_i].q = rotation_by(h * after.bodies[body_i].omega) * after.bodies[body_i].q;
        }
        return gap(rows, after, 0);
    };
    // Closing the gap turns the bodies a little, which the rotation ahead did not know: h^2 omega times that.
    EXPECT_LE(gap_after(0.01, true), 0.01 * gap_after(0.01, false) + 1e-4);
    state.body(1).r_CM = Vector3d(0.5, 0, 0);
    // A chord leaves its tangent by (omega h)^3 / 6 sideways, which turns the bodies so much, and that shifts chords by omega h of it.
    EXPECT_LE(gap_after(0.01, true), std::pow(0.03, 4));
    EXPECT_NEAR(gap_after(0.01, false), 2 * 0.5 * 0.03 * 0.03 / 2, 1e-6);
}

/// Drives: v = (v_0 - h kp e / J) / (1 + (h kd + h^2 kp) / J); motors: no more than h torque.
TEST(ConstrainedStep, drives_and_motors_have_closed_forms) {
    const double J = 1e-3, h = 1.0 / 240, kp = 3, kd = 0.02, e = 0.4, v_0 = 2;
    FigureScene scene = spring_rotor(J, 0, 0, 0);
    scene.body(0).omega = Vector3d(0, 0, v_0);
    const JointRows rows(scene);
    const FigureState state = start_of(scene);
    std::vector<StepRow> all = held_rows(rows, state, h, false);
    const double R = h * kd + h * h * kp;
    all.push_back({turn_row(the_world, 0, Vector3d::UnitZ()), -h * kp * e / R, 1 / R, -infinity, infinity});
    StepSolution solution = solve_step(step_bodies(scene, state), all);
    EXPECT_NEAR(solution.omega[0].z(), (v_0 - h * kp * e / J) / (1 + R / J), 1e-13);
    EXPECT_NEAR(solution.impulse.back(), J * (solution.omega[0].z() - v_0), 1e-15);

    const double torque = 0.1;
    all.back() = {turn_row(the_world, 0, Vector3d::UnitZ()), 50, 0, -h * torque, h * torque};
    solution = solve_step(step_bodies(scene, state), all);
    EXPECT_NEAR(solution.impulse.back(), h * torque, 1e-18);
    EXPECT_NEAR(solution.omega[0].z(), v_0 + h * torque / J, 1e-13);
    all.back().target = v_0 + 0.1;  // within its torque: there it is
    solution = solve_step(step_bodies(scene, state), all);
    EXPECT_NEAR(solution.omega[0].z(), v_0 + 0.1, 1e-13);
}

/// A ball hits the tip of a rod on a hinge: j = -(1 + e) v_n / (1/m + l^2/J).
TEST(ConstrainedStep, an_impact_sees_the_joint) {
    const double e = 0.5, m = 0.3, J = 1.0 / 3;
    FigureScene scene = pendulum_with_stop(0, -infinity, 0);
    scene.add(sphere(m, 0.1, Vector3d(-0.1, 0, -1)));
    scene.body(1).v_CM = Vector3d(2, 0, 0);
    const JointRows rows(scene);
    const FigureState state = start_of(scene);
    const std::vector<StepBody> bodies = step_bodies(scene, state);
    std::vector<StepRow> all = held_rows(rows, state, 1, false);
    const Vector3d tip(0, 0, -1), n(1, 0, 0);
    all.push_back({point_row(bodies, 1, tip, 0, tip, n), e * 2, 0, 0, infinity});
    const StepSolution solution = solve_step(bodies, all);
    EXPECT_NEAR(solution.impulse.back(), (1 + e) * 2 / (1 / m + 1 / J), 1e-13);
    EXPECT_NEAR(solution.omega[0].y(), -solution.impulse.back() / J, 1e-13);
}

/// Doubled hinges: the same velocities, loads that are not determined; a free row beside them is.
TEST(ConstrainedStep, redundant_rows_are_told) {
    FigureScene scene = door(2);
    const JointRows rows(scene);
    const FigureState state = start_of(scene);
    const double h = 0.01;
    const StepSolution two = solve_step(under_forces(rows, state, h), held_rows(rows, state, h, false));
    EXPECT_LE(two.unmet, 1e-13);
    EXPECT_FALSE(two.determined[0]);
    scene.joints.pop_back();
    const JointRows fewer(scene);
    const StepSolution one = solve_step(under_forces(fewer, state, h), held_rows(fewer, state, h, false));
    for (const bool determined : one.determined) EXPECT_TRUE(determined);
    EXPECT_LE((one.omega[0] - two.omega[0]).norm(), 1e-13);
    EXPECT_LE((one.v_CM[0] - two.v_CM[0]).norm(), 1e-13);
}

/// A torso a thousand times as heavy as its feet, upright on the ground: it stands still, and the ground carries its weight.
TEST(ConstrainedStep, a_heavy_figure_stands) {
    const FigureScene scene = standing_figure(1000);
    const JointRows rows(scene);
    const FigureState state = start_of(scene);
    const double h = 1.0 / 240;
    const std::vector<StepBody> bodies = under_forces(rows, state, h);
    std::vector<StepRow> all = held_rows(rows, state, h, false);
    const std::size_t joints = all.size();
    for (int body_i = 1; body_i < scene.body_count(); ++body_i) {
        const FigureBody& foot = scene.body(body_i);
        if (foot.shape != FigureShape::box || foot.r_CM.z() > foot.half_extent.z() + 1e-9) continue;
        for (const double x : {-1.0, 1.0})
            for (const double y : {-1.0, 1.0}) {
                const Vector3d corner = foot.r_CM + Vector3d(x * foot.half_extent.x(), y * foot.half_extent.y(), -foot.half_extent.z());
                all.push_back({point_row(bodies, the_world, corner, body_i, corner, Vector3d::UnitZ()), 0, 0, 0, infinity});
            }
    }
    ASSERT_EQ(all.size(), joints + 16);
    const StepSolution solution = solve_step(bodies, all);
    double carried = 0;
    for (std::size_t row_i = joints; row_i < all.size(); ++row_i) carried += solution.impulse[row_i];
    EXPECT_NEAR(carried, h * 9.81 * mass(scene), 1e-9 * h * 9.81 * mass(scene));
    for (const Vector3d& v : solution.v_CM) EXPECT_LE(v.norm(), 1e-9);
}

}  // namespace
