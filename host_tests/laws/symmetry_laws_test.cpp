// SPDX-License-Identifier: MIT
// Motion that is played backwards, seen from another frame, from a moving one, or through a mirror is the same motion.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <cstdio>

#include "laws/bodies.h"
#include "reference/eigen_free_body.h"

namespace {

using namespace ingot_laws;
using namespace ingot_reference;

constexpr scalar h = scalar(1) / 60;

struct Flyer : ingot::Scene {};

struct Spinner {
    ingot::World<Flyer> world{};
    Known body;

    Spinner(const Eigen::Vector3d& I, const Eigen::Matrix3d& A, const Eigen::Vector3d& w_body) {
        ingot::BodyDef def = definition(1, I);
        def.state.A = to_matrix(A);
        def.state.L = to_vector(Eigen::Vector3d(A * I.cwiseProduct(w_body)));
        body = add(world, def);
    }
    ingot::BodyState state() const { return world.state(body.id).value; }
    void fly(int steps) {
        for (int step_i = 0; step_i < steps; ++step_i) ASSERT_TRUE(ingot::step(world, h).clean());
    }
};

/// The book case, and two more as far from the separatrix, where roundings grow slowly; spins up to 1.5 rad/s.
const Eigen::Vector3d moments[] = {{1, 2, 3}, {1, 1.5, 1.75}, {2, 1, 2.5}};
const Eigen::Vector3d spins[] = {{0.5, 1, 0.75}, {1, 0.25, 0.5}, {-0.5, 0.5, -1}};

/// R13, 6000 steps each way: 1e-12 in double. In float a step rounds the angle once or twice at random, and A at the turning
/// point is one that has lost its compensation: sqrt(12000) 2 u, times at most 4 for how a small error of a tumbling body
/// grows.
TEST(Symmetry, time_reversal) {
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
        RandomInput random(211u + static_cast<unsigned>(i));
        Spinner spinner(moments[i], random.rotation(), spins[i]);
        const ingot::BodyState begin = spinner.state();
        spinner.fly(6000);
        ASSERT_GT(attitude_error(to_eigen(spinner.state().A), to_eigen(begin.A)), 0.01);
        ingot::BodyState reversed = spinner.state();
        reversed.L = -reversed.L;
        ASSERT_EQ(spinner.world.set_state(spinner.body.id, reversed), ingot::Status::ok);
        spinner.fly(6000);
        worst = std::max(worst, attitude_error(to_eigen<long double>(spinner.state().A), to_eigen<long double>(begin.A)));
    }
    std::printf("    there and back, 2 x 6000 steps: %.1e rad\n", worst);
    EXPECT_LE(worst, bar(1e-12, std::sqrt(12000.0) * 2 * u * 4));
}

/// Where the exact motion leads from a state of the kernel's: what the rounding of that state makes of it.
Square exact_after(const ingot::BodyState& begin, const Known& body, int steps) {
    Square A = to_eigen<long double>(begin.A);
    for (int i = 0; i < 3; ++i) A += A * (Square::Identity() - A.transpose() * A) / 2;
    FreeBody exact(body.I, A, to_eigen<long double>(begin.L));
    exact.advance(steps * static_cast<long double>(h));
    return exact.A();
}

/// R14: A0 and L turned by R, 3600 steps: R A(t), to 1e-12 (double), 1e-5 (float). What the rounding of the turned L and A does
/// to the exact motion is not the kernel's: it is measured on the reference and added.
TEST(Symmetry, frame_indifference) {
    double worst = 0, worst_of_input = 0;
    for (int i = 0; i < 3; ++i) {
        RandomInput random(221u + static_cast<unsigned>(i));
        const Eigen::Matrix3d A = random.rotation();
        Spinner here(moments[i], A, spins[i]);
        const Square exact_here = exact_after(here.state(), here.body, 3600);
        here.fly(3600);
        for (int k = 0; k < 5; ++k) {
            const Eigen::Matrix3d R = random.rotation();
            Spinner there(moments[i], R * A, spins[i]);
            const double of_input =
                attitude_error(exact_after(there.state(), there.body, 3600), Square(R.cast<long double>() * exact_here));
            there.fly(3600);
            const double off = attitude_error(attitude(there.world, there.body),
                                              Square(R.cast<long double>() * attitude(here.world, here.body)));
            EXPECT_LE(off, bar(1e-12, 1e-5) + of_input) << "body " << i << ", frame " << k;
            worst = std::max(worst, off);
            worst_of_input = std::max(worst_of_input, of_input);
        }
    }
    std::printf("    seen from another frame, 3600 steps: %.1e rad, of which the rounding of the input up to %.1e\n", worst,
                worst_of_input);
}

/// Axes that change places and signs round nothing: the turned motion is the motion, bitwise.
TEST(Symmetry, quarter_turns_of_the_frame_are_bitwise) {
    RandomInput random(231);
    Eigen::Matrix3d R;
    R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    const Eigen::Matrix3d A = random.rotation();
    Spinner here(moments[0], A, spins[0]), there(moments[0], A, spins[0]);
    ingot::BodyState turned = here.state();
    turned.A = to_matrix(Eigen::Matrix3d(R * to_eigen(turned.A)));
    turned.L = to_vector(Eigen::Vector3d(R * to_eigen(turned.L)));
    ASSERT_EQ(there.world.set_state(there.body.id, turned), ingot::Status::ok);
    here.fly(1);
    there.fly(1);
    // A^T L is a sum of three whose order changes: one step differs by the rounding of that sum, in an angle below 1/30 rad.
    EXPECT_LE(largest_difference(to_eigen(there.state().A), Eigen::Matrix3d(R * to_eigen(here.state().A))), 2 * u);
}

/// A body with its axes renamed is the same body: A P, P^T I, for P an even change of axes.
TEST(Symmetry, names_of_the_body_axes_do_not_matter) {
    RandomInput random(241);
    Eigen::Matrix3d P;
    P << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    for (int i = 0; i < 3; ++i) {
        const Eigen::Matrix3d A = random.rotation();
        Spinner here(moments[i], A, spins[i]), renamed(Eigen::Vector3d(P.transpose() * moments[i]), Eigen::Matrix3d(A * P),
                                                       Eigen::Vector3d(P.transpose() * spins[i]));
        here.fly(3600);
        renamed.fly(3600);
        const Square expected = to_eigen<long double>(here.state().A) * P.cast<long double>();
        EXPECT_LE(attitude_error(to_eigen<long double>(renamed.state().A), expected), bar(1e-12, 1e-5));  // the bars of R14
    }
}

struct Balls : ingot::Scene {
    static constexpr int max_bodies = 6;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 16;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere>;
};

/// Five balls on their way into each other, all with the velocity `frame` on top.
std::vector<Known> add_colliding_balls(ingot::World<Balls>& world, const Eigen::Vector3d& frame) {
    std::vector<Known> balls;
    for (int i = 0; i < 5; ++i) {
        const double angle = 1.2 * i;
        const Eigen::Vector3d r((2 + 0.25 * i) * std::cos(angle), (2 + 0.25 * i) * std::sin(angle), 0.05 * i);
        balls.push_back(add(world, ball(1 + 0.5 * i, 0.5, r, Eigen::Vector3d(-r + frame), 1)));
    }
    return balls;
}

/// Positions, velocities and impacts relative to the frame are the same: the frame adds roundings of its own path and speed.
TEST(Symmetry, galilean_invariance) {
    const Eigen::Vector3d frame(4, -8, 2);
    ingot::World<Balls> here{}, there{};
    const std::vector<Known> still = add_colliding_balls(here, Eigen::Vector3d::Zero()),
                             moving = add_colliding_balls(there, frame);
    int impacts = 0;
    constexpr int steps = 256;
    const scalar h_exact = scalar(1) / 64;
    for (int step_i = 0; step_i < steps; ++step_i) {
        const ingot::StepReport a = ingot::step(here, h_exact), b = ingot::step(there, h_exact);
        ASSERT_TRUE(a.clean() && b.clean());
        ASSERT_EQ(a.impact_waves, b.impact_waves) << "an impact in one frame is one in the other; step " << step_i;
        impacts += a.impact_waves;
    }
    EXPECT_GE(impacts, 3);
    const double t = steps / 64.0, path = 4 + t * (frame.norm() + 3), speed = frame.norm() + 3;
    for (std::size_t i = 0; i < still.size(); ++i) {
        // Each step rounds r (one of the size of the path); impacts turn an error of place into one of direction, over a ball's
        // half metre, at most 4 times each; v is off by that times the speed of 3 m/s, and the place by that over time.
        const double place = steps * u * path, direction = std::pow(4, impacts) * (place + 4 * u * speed);
        EXPECT_LE(largest_difference(velocity(there, moving[i]), Eigen::Vector3d(velocity(here, still[i]) + frame)),
                  3 * direction);
        EXPECT_LE(largest_difference(position(there, moving[i]), Eigen::Vector3d(position(here, still[i]) + frame * t)),
                  3 * direction * t + place);
    }
}

/// The mirror image of balls that collide: y and z as they were, x with its sign changed, bitwise.
TEST(Symmetry, mirror_image_of_colliding_balls_is_bitwise) {
    const auto mirrored = [](const Eigen::Vector3d& v) { return Eigen::Vector3d(-v(0), v(1), v(2)); };
    ingot::World<Balls> here{}, there{};
    const std::vector<Known> balls = add_colliding_balls(here, Eigen::Vector3d(0.1, 0.2, 0.3));
    std::vector<Known> images;
    for (const Known& known : balls) {
        const double M = static_cast<double>(known.M);
        images.push_back(add(there, ball(M, 0.5, mirrored(position(here, known)), mirrored(velocity(here, known)), 1)));
    }
    int impacts = 0;
    for (int step_i = 0; step_i < 300; ++step_i) {
        const ingot::StepReport report = ingot::step(here, h);
        ASSERT_TRUE(report.clean());
        ASSERT_TRUE(ingot::step(there, h).clean());
        impacts += report.impact_waves;
    }
    EXPECT_GE(impacts, 3);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        EXPECT_EQ(position(there, images[i]), mirrored(position(here, balls[i])));
        EXPECT_EQ(velocity(there, images[i]), mirrored(velocity(here, balls[i])));
    }
}

}  // namespace
