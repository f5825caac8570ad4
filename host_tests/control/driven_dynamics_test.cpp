// SPDX-License-Identifier: MIT
// Torques that FigureDynamics computes, given by the drives of a world.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "control/read_figure.h"

namespace {

using namespace ingot_control;

struct Driven : ingot::Scene {
    static constexpr int max_bodies = 16, max_joints = 16;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::FixedJoint, ingot::WheelJoint,
                                 ingot::WithDrives>;
};
using Figure = Read<Driven>;

/// Has every joint give a torque, and the root of what floats a wrench, over the next step.
void give(Figure& of) {
    const auto torque_of = [&](std::size_t i, int k) { return of.torques[of.order[static_cast<std::size_t>(of.drawn.figure.bodies[i].first + k)]]; };
    if (of.figure.floats()) {
        EXPECT_EQ(of.world->add_central_force(of.built.bodies[0], {of.torques[0], of.torques[1], of.torques[2]}), Status::ok);
        EXPECT_EQ(of.world->add_torque(of.built.bodies[0], {of.torques[3], of.torques[4], of.torques[5]}), Status::ok);
    }
    for (std::size_t i = 0; i < of.size(); ++i) {
        const RefKind kind = of.drawn.figure.bodies[i].kind;
        const ingot::JointId id = of.built.joints[i];
        if (id == ingot::JointId{}) continue;
        if (kind == RefKind::ball) {
            EXPECT_EQ(of.world->set_ball_drive(id, ingot::SpringDrive{}, {}, {}, {torque_of(i, 0), torque_of(i, 1), torque_of(i, 2)}), Status::ok);
            continue;
        }
        for (int k = 0; k < directions_of(kind); ++k) {
            ingot::SpringDrive drive;
            drive.feedforward = torque_of(i, k);
            EXPECT_EQ(of.world->set_joint_drive(id, drive, k), Status::ok);
        }
    }
}

/// What a torque of 1 along one number of a figure at rest makes of its rate in a step: rad/s^2, m/s^2.
struct Felt {
    double expected = 1, given = 1;
    double most = 0;  ///< of any of its numbers
};
Felt felt_in_step(Figure& of, RandomInput& random, double h) {
    Felt felt;
    of.drawn = draw_figure(random, {random.integer(1, 5), 10, 0, true});
    of.drawn.g.setZero();
    of.built = add_figure(*of.world, of.drawn);
    of.read();
    if (of.count() == 0) return felt;
    const int k = random.integer(0, of.count() - 1);
    felt.expected = 1 / static_cast<double>(of.figure.effective_inertia(k).value);
    for (int i = 0; i < of.count(); ++i) felt.most = std::max(felt.most, 1 / static_cast<double>(of.figure.effective_inertia(i).value));
    for (scalar& torque : of.torques) torque = 0;
    of.torques[k] = 1;
    give(of);
    (void)ingot::step(*of.world, static_cast<scalar>(h));
    of.read();
    EXPECT_EQ(of.figure.direction_rates(of.torques, of.count()), Status::ok);
    felt.given = static_cast<double>(of.torques[k]) / h;
    return felt;
}

/// What is asked of the second step of h, as a root mean square over all numbers: how far the mean acceleration is off. Velocities that a
/// step leaves fit the pose within its last substep: after the first step all by as much, and not those that were set.
double off_after(double h, std::uint64_t seed) {
    RandomInput random(seed);
    double sum = 0, all = 0;
    for (int run_i = 0; run_i < draws(80); ++run_i) {
        Figure of;
        of.drawn = draw_figure(random, {random.integer(2, 5), 3, 1, run_i % 2 == 0});
        of.built = add_figure(*of.world, of.drawn);
        VectorXd before(of.drawn.figure.count);
        for (int step_i = 0; step_i < 2; ++step_i) {
            of.read();
            EXPECT_EQ(of.figure.direction_rates(of.torques, of.count()), Status::ok);
            before = of.given();
            EXPECT_EQ(of.figure.inverse_dynamics(of.numbers, of.torques, of.count()), Status::ok);
            give(of);
            (void)ingot::step(*of.world, static_cast<scalar>(h));
        }
        of.read();
        EXPECT_EQ(of.figure.direction_rates(of.torques, of.count()), Status::ok);
        const VectorXd wanted = in_order(of.numbers, of.order);
        const VectorXd off = (of.given() - before) / h - wanted;
        for (Eigen::Index i = 0; i < off.size(); ++i) sum += off(i) * off(i);  // gcc warns of squaredNorm() here: a null pointer, it thinks
        all += wanted.squaredNorm();
    }
    return std::sqrt(sum / all);
}

}  // namespace

/// Nothing but the torque acts as it begins: what rates and turns add grows with the square of the step. Joints draw together in a substep, a quarter
/// of the step, what places were rounded by.
TEST(Dynamics, effective_inertia_is_what_a_drive_feels) {
    RandomInput random(10);
    const double h = sizeof(scalar) == 8 ? 1e-3 : 1.0 / 60;
    for (int run_i = 0; run_i < draws(80); ++run_i) {
        Figure of;
        const Felt felt = felt_in_step(of, random, h);
        const double roundings = 64 * eps / (h * h), second = 8 * felt.most * felt.most * h * h;
        EXPECT_NEAR(felt.given, felt.expected, roundings + second);
    }
}

/// Drives that give what was computed make the accelerations that were asked for: to first order, as means over a step.
TEST(Dynamics, torques_as_computed_accelerate_as_asked) {
    const double at_120 = off_after(1.0 / 120, 8), at_240 = off_after(1.0 / 240, 8);
    EXPECT_LE(at_240, 0.1);
    EXPECT_NEAR(at_120 / at_240, 2, 0.2);
}
