// SPDX-License-Identifier: MIT
// The contact reference itself, by the laws it is to obey and by closed forms: nothing here is the kernel.
//
// Bars: the solver stops at 1e-11 m/s; closed forms hold to 1e-10 m/s with speeds around 1, so ten digits.
#include "reference/contact_reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/contact_problems.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_reference;

constexpr double bar = 1e-10;
constexpr double g = 9.81, h = 1.0 / 60;

/// Bodies in a heap: each point's normal leans upwards and pushes the body of the larger number, so that bounds never
/// contradict each other (lifting later bodies faster satisfies them all).
ContactProblem random_heap(RandomInput& random, int bodies, int points, double mu_max, int mass_binades) {
    ContactProblem problem;
    problem.bodies.emplace_back();
    for (int body_i = 1; body_i <= bodies; ++body_i) {
        const double M = std::ldexp(1.0, random.integer(0, mass_binades));
        const Matrix3d A = random.rotation();
        ContactBody body;
        body.inv_M = 1 / M;
        body.inv_I_world = A * random.moments(M).cwiseInverse().asDiagonal() * A.transpose();
        body.r_CM = random.vector(1) + Vector3d(0, 0, body_i);
        body.v_CM = random.vector(1) - Vector3d(0, 0, 1);
        body.omega = random.vector(1);
        problem.bodies.push_back(body);
    }
    for (int point_i = 0; point_i < points; ++point_i) {
        ContactPoint point;
        point.body_A = random.integer(1, bodies);
        point.body_B = random.integer(0, point.body_A - 1);
        point.n = (random.vector(0.8) + Vector3d::UnitZ()).normalized();
        point.r_P = problem.bodies[static_cast<std::size_t>(point.body_A)].r_CM + random.vector(0.5);
        point.mu = random.real(0, mu_max);
        point.v_n_target = random.real(0, 1) < 0.3 ? random.real(0, 0.5) : 0;
        point.separation = random.real(0, 1) < 0.3 ? random.real(0, 0.02) : 0;
        if (random.real(0, 1) < 0.2) point.v_t_drive = point.n.cross(random.vector(1));
        problem.points.push_back(point);
    }
    problem.h = h;
    return problem;
}

/// Least kinetic energy metric by trying every set of pushing points; empty where no set obeys the laws.
std::vector<ContactSolution> by_enumeration(const ContactProblem& problem) {
    const int count = static_cast<int>(problem.points.size());
    std::vector<ContactSolution> found;
    ContactSolution none;
    none.impulse.assign(problem.points.size(), Vector3d::Zero());
    const auto normal_velocities = [&](const Eigen::VectorXd& p) {
        ContactSolution pushed = none;
        for (int i = 0; i < count; ++i)
            pushed.impulse[static_cast<std::size_t>(i)] = p(i) * problem.points[static_cast<std::size_t>(i)].n;
        apply_impulses(problem, pushed);
        Eigen::VectorXd u(count);
        for (int i = 0; i < count; ++i) {
            const ContactPoint& point = problem.points[static_cast<std::size_t>(i)];
            const auto at = [&](int body_i) -> Vector3d {
                const std::size_t b = static_cast<std::size_t>(body_i);
                return pushed.v_CM[b] + pushed.omega[b].cross(point.r_P - problem.bodies[b].r_CM);
            };
            u(i) = (at(point.body_A) - at(point.body_B)).dot(point.n) - problem.bound(point);
        }
        return u;
    };
    const Eigen::VectorXd u_free = normal_velocities(Eigen::VectorXd::Zero(count));
    Eigen::MatrixXd W(count, count);
    for (int c = 0; c < count; ++c) W.col(c) = normal_velocities(Eigen::VectorXd::Unit(count, c)) - u_free;
    for (unsigned set = 0; set < (1u << count); ++set) {
        std::vector<int> in;
        for (int i = 0; i < count; ++i)
            if ((set >> i & 1u) != 0) in.push_back(i);
        const int size = static_cast<int>(in.size());
        Eigen::MatrixXd part(size, size);
        Eigen::VectorXd right(size);
        for (int r = 0; r < size; ++r) {
            right(r) = -u_free(in[static_cast<std::size_t>(r)]);
            for (int c = 0; c < size; ++c) part(r, c) = W(in[static_cast<std::size_t>(r)], in[static_cast<std::size_t>(c)]);
        }
        const Eigen::VectorXd x = size > 0 ? Eigen::VectorXd(part.completeOrthogonalDecomposition().solve(right)) : right;
        if (size > 0 && x.minCoeff() < -1e-11) continue;
        Eigen::VectorXd p = Eigen::VectorXd::Zero(count);
        for (int i = 0; i < size; ++i) p(in[static_cast<std::size_t>(i)]) = x(i);
        const Eigen::VectorXd u = u_free + W * p;
        if (u.minCoeff() < -1e-11 || std::abs(u.dot(p)) > 1e-10) continue;
        ContactSolution solution = none;
        for (int i = 0; i < count; ++i)
            solution.impulse[static_cast<std::size_t>(i)] = p(i) * problem.points[static_cast<std::size_t>(i)].n;
        apply_impulses(problem, solution);
        found.push_back(solution);
    }
    return found;
}

TEST(ContactReference, random_heaps_without_friction_obey_the_laws_and_agree_with_enumeration) {
    RandomInput random(4);
    for (int trial = 0; trial < 100; ++trial) {
        const ContactProblem problem = random_heap(random, random.integer(1, 4), random.integer(1, 8), 0, 6);
        const ContactSolution solution = solve_contacts_without_friction(problem);
        ASSERT_TRUE(solution.converged) << trial << " residual " << solution.residual;
        EXPECT_LE(contact_defects(problem, solution).worst(), bar) << trial;
        const std::vector<ContactSolution> all = by_enumeration(problem);
        ASSERT_FALSE(all.empty()) << trial;
        for (const ContactSolution& other : all) EXPECT_LE(velocity_distance(problem, solution, other), 1e-9) << trial;
        const ContactSolution cone = solve_contacts(problem);
        EXPECT_TRUE(cone.converged) << trial << " residual " << cone.residual;
        EXPECT_LE(velocity_distance(problem, solution, cone), bar) << trial;
    }
}

TEST(ContactReference, random_heaps_with_friction_obey_the_laws) {
    RandomInput random(5);
    int most_systems = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const int bodies = random.integer(1, 12);
        const ContactProblem problem = random_heap(random, bodies, random.integer(1, 5 * bodies), 1, trial % 2 == 0 ? 0 : 10);
        const ContactSolution solution = solve_contacts(problem);
        EXPECT_TRUE(solution.converged) << trial << " residual " << solution.residual;
        EXPECT_LE(contact_defects(problem, solution).worst(), bar) << trial;
        most_systems = std::max(most_systems, solution.iterations);
    }
    std::printf("most linear systems in one heap: %d\n", most_systems);
}

TEST(ContactReference, a_first_guess_leads_to_the_same_velocities_sooner) {
    ContactProblem problem = stack_of_boxes(std::vector<double>(10, 1.0), {0.5, 0.5, 0.5}, 0.6);
    fall(problem, {0, 0, -g}, h);
    const ContactSolution cold = solve_contacts(problem), warm = solve_contacts(problem, 1e-11, &cold);
    EXPECT_TRUE(warm.converged);
    EXPECT_LE(velocity_distance(problem, cold, warm), bar);
    EXPECT_LT(2 * warm.iterations, cold.iterations);
}

TEST(ContactReference, a_wrong_solution_is_told_from_a_right_one) {
    RandomInput random(6);
    for (int trial = 0; trial < 50; ++trial) {
        const ContactProblem problem = random_heap(random, 3, 6, 0.8, 2);
        const ContactSolution right = solve_contacts(problem);
        const std::size_t point_i = static_cast<std::size_t>(random.integer(0, 5));
        ContactSolution wrong = right;
        wrong.impulse[point_i] += 1e-6 * random.direction();
        EXPECT_GE(contact_defects(problem, wrong).momentum, 1e-9);  // velocities left alone: 1e-6 N s on at most 4 kg
        apply_impulses(problem, wrong);
        EXPECT_GE(contact_defects(problem, wrong).worst(), 1e-9) << trial;
        EXPECT_GE(contact_residual(problem, wrong), 1e-9) << trial;
        EXPECT_GE(velocity_distance(problem, right, wrong), 1e-9) << trial;
    }
}

TEST(ContactReference, bounds_that_contradict_each_other_are_reported) {
    ContactProblem problem;
    problem.bodies = {ContactBody{}, solid_ball(1, 0.5, {0, 0, 0.5})};
    problem.points = {point_between(1, 0, {0, 0, 0}, Vector3d::UnitZ(), 0),
                      point_between(1, 0, {0, 0, 1}, -Vector3d::UnitZ(), 0)};
    problem.points[0].v_n_target = problem.points[1].v_n_target = 1;  // up and down at once
    EXPECT_FALSE(solve_contacts_without_friction(problem).converged);
    EXPECT_FALSE(solve_contacts(problem).converged);
}

TEST(ContactReference, a_box_on_four_corners_rests_on_a_quarter_each) {
    for (const double mu : {0.0, 0.6}) {
        ContactProblem problem = stack_of_boxes({3.0}, {0.5, 0.4, 0.3}, mu);
        fall(problem, {0, 0, -g}, h);
        const ContactSolution solution = solve_contacts(problem);
        EXPECT_TRUE(solution.converged);
        EXPECT_LE(solution.v_CM[1].norm() + solution.omega[1].norm(), bar);
        for (const Vector3d& p : solution.impulse) EXPECT_NEAR(p.z(), 3 * g * h / 4, bar);
        EXPECT_LE(velocity_distance(problem, solution, solve_contacts_without_friction(problem)), bar);
    }
}

TEST(ContactReference, a_box_dropped_flat_bounces_flat) {
    ContactProblem problem = stack_of_boxes({3.0}, {0.5, 0.4, 0.3}, 0.5);
    problem.bodies[1].v_CM = {0, 0, -2};
    for (ContactPoint& point : problem.points) point.v_n_target = 1;  // e = 0.5
    problem.h = 0;
    const ContactSolution solution = solve_contacts(problem);
    EXPECT_TRUE(solution.converged);
    EXPECT_LE((solution.v_CM[1] - Vector3d(0, 0, 1)).norm() + solution.omega[1].norm(), bar);
}

TEST(ContactReference, a_gap_may_close_in_the_step_and_no_further) {
    ContactProblem problem = stack_of_boxes({3.0}, {0.5, 0.4, 0.3}, 0.5);
    for (ContactPoint& point : problem.points) point.separation = 0.001;
    problem.bodies[1].v_CM = {0, 0, -1};
    problem.h = h;
    EXPECT_NEAR(solve_contacts(problem).v_CM[1].z(), -0.001 / h, bar);
    problem.h = 0;  // an impact is not one at a distance
    EXPECT_EQ(solve_contacts(problem).v_CM[1].z(), -1);
}

TEST(ContactReference, a_box_on_an_incline_sticks_or_slides) {
    const double alpha = std::acos(-1) / 6, threshold = std::tan(alpha);
    for (const double factor : {0.5, 0.7, 1 - 1e-6, 1 + 1e-6, 1.2}) {
        const double mu = factor * threshold;
        ContactProblem problem = stack_of_boxes({2.0}, {0.5, 0.5, 0.5}, mu);
        fall(problem, {g * std::sin(alpha), 0, -g * std::cos(alpha)}, h);  // the axes of the incline, x down the slope
        const ContactSolution solution = solve_contacts(problem);
        EXPECT_TRUE(solution.converged) << factor;
        const double dv = factor < 1 ? g * (std::sin(alpha) - mu * std::cos(alpha)) * h : 0;
        EXPECT_LE((solution.v_CM[1] - Vector3d(dv, 0, 0)).norm() + solution.omega[1].norm(), bar) << factor;
    }
}

TEST(ContactReference, friction_is_the_same_in_every_direction) {
    for (int degrees = 0; degrees < 90; degrees += 5) {
        const double phi = degrees * std::acos(-1) / 180;
        ContactProblem problem = stack_of_boxes({2.0}, {0.5, 0.5, 0.01}, 0.4);
        problem.bodies[1].v_CM = 3 * Vector3d(std::cos(phi), std::sin(phi), 0);
        fall(problem, {0, 0, -g}, h);
        const ContactSolution solution = solve_contacts(problem);
        const Vector3d expected = (3 - 0.4 * g * h) * Vector3d(std::cos(phi), std::sin(phi), 0);
        EXPECT_LE((solution.v_CM[1] - expected).norm(), bar) << degrees;
    }
}

TEST(ContactReference, every_interface_of_a_stack_carries_what_is_above) {
    const std::vector<std::vector<double>> stacks = {
        std::vector<double>(10, 1.0),      std::vector<double>(40, 1.0), {1, 1000}, {1, 1e6},
        {1, 1, 1, 1, 1, 1, 1, 1, 1, 1000}, {1, 10, 100, 1000, 1e4},      {1e4, 1}};
    for (const std::vector<double>& masses : stacks) {
        ContactProblem problem = stack_of_boxes(masses, {0.5, 0.5, 0.5}, 0.6);
        fall(problem, {0, 0, -g}, h);
        const ContactSolution solution = solve_contacts(problem), smooth = solve_contacts_without_friction(problem);
        EXPECT_TRUE(solution.converged) << masses.size() << " residual " << solution.residual;
        EXPECT_TRUE(smooth.converged) << masses.size() << " residual " << smooth.residual;
        double load = 0;
        for (std::size_t box_i = masses.size(); box_i-- > 0;) {
            load += masses[box_i] * g * h;
            double sum = 0;
            for (std::size_t corner = 0; corner < 4; ++corner) sum += solution.impulse[4 * box_i + corner].z();
            EXPECT_NEAR(sum, load, 1e-9 * load) << masses.size() << ", interface " << box_i;
            EXPECT_LE(solution.v_CM[box_i + 1].norm(), bar) << masses.size() << ", box " << box_i;
            EXPECT_LE(smooth.v_CM[box_i + 1].norm(), bar) << masses.size() << ", box " << box_i;
        }
    }
}

TEST(ContactReference, a_ball_slides_then_rolls) {
    const double mu = 0.25, R = 0.5;
    ContactProblem problem;
    problem.bodies = {ContactBody{}, solid_ball(2, R, {0, 0, R})};
    problem.points = {point_between(1, 0, {0, 0, 0}, Vector3d::UnitZ(), mu)};
    problem.bodies[1].v_CM = {3, -1, 0};
    problem.bodies[1].omega = {0, -8, 4};
    const ContactBody at_start = problem.bodies[1];
    const Vector3d slip = at_start.v_CM + at_start.omega.cross(Vector3d(0, 0, -R));
    const double t_roll = 2 * slip.norm() / (7 * mu * g);
    int steps = 0;
    for (; steps < 120; ++steps) {
        fall(problem, {0, 0, -g}, h);
        const ContactSolution solution = solve_contacts(problem);
        ASSERT_TRUE(solution.converged);
        problem.bodies[1].v_CM = solution.v_CM[1];
        problem.bodies[1].omega = solution.omega[1];
        const double t = (steps + 1) * h;
        // A constant force makes velocities exact at any step; the step that ends the slip ends it exactly.
        const double s = std::min(t, t_roll);
        const Vector3d v = at_start.v_CM - mu * g * s * slip.normalized();
        const Vector3d omega = at_start.omega - mu * g * s * 5 / (2 * R) * Vector3d(0, 0, -1).cross(slip.normalized());
        EXPECT_LE((solution.v_CM[1] - v).norm(), 1e-9) << t;
        EXPECT_LE((solution.omega[1] - omega).norm(), 1e-9) << t;
    }
    EXPECT_GT(steps * h, t_roll);
}

TEST(ContactReference, a_belt_drags_what_lies_on_it) {
    ContactProblem problem = stack_of_boxes({2.0}, {0.5, 0.5, 0.01}, 0.4);
    for (ContactPoint& point : problem.points) point.v_t_drive = {1, 0, 0};
    fall(problem, {0, 0, -g}, h);
    EXPECT_NEAR(solve_contacts(problem).v_CM[1].x(), 0.4 * g * h, bar);
    problem.bodies[1].v_CM.x() = 1 - 1e-3;
    EXPECT_NEAR(solve_contacts(problem).v_CM[1].x(), 1, bar);
}

TEST(ContactReference, a_twisting_patch_takes_its_bounded_share) {
    ContactProblem problem = stack_of_boxes({2.0}, {0.5, 0.4, 0.3}, 0);
    FrictionPatch patch;
    patch.body_A = 1;
    patch.body_B = 0;
    patch.mu = 0.5;
    patch.mu_twist = 0.1;
    patch.points = {0, 1, 2, 3};
    problem.patches = {patch};
    problem.bodies[1].v_CM = {2, 0, 0};
    problem.bodies[1].omega = {0, 0, 3};
    fall(problem, {0, 0, -g}, h);
    const ContactSolution sliding = solve_contacts(problem);
    EXPECT_TRUE(sliding.converged);
    EXPECT_LE(contact_defects(problem, sliding).worst(), bar);
    const double N = 2 * g * h;
    EXPECT_NEAR(sliding.v_CM[1].x(), 2 - 0.5 * g * h, bar);
    EXPECT_NEAR(sliding.omega[1].z(), 3 - 0.1 * N * problem.bodies[1].inv_I_world(2, 2), bar);
    problem.bodies[1].v_CM = {0.01, 0, -g * h};
    problem.bodies[1].omega = {0, 0, 0.01};
    const ContactSolution sticking = solve_contacts(problem);
    EXPECT_TRUE(sticking.converged);
    EXPECT_LE(sticking.v_CM[1].norm() + sticking.omega[1].norm(), bar);
}

}  // namespace
