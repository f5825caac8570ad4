// SPDX-License-Identifier: MIT
// Limits, ropes, motors and breaking in the reference of constrained motion, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "joints/constrained_reference.h"
#include "joints/figure_scenes.h"

namespace {

using namespace ingot_figures;

constexpr double bar = 1e-10, g = 9.81;

double angle(const ConstrainedReference& reference, int joint_i = 0) {
    return measured(reference.rows(), reference.state(), joint_i, FigureMeasure::angle);
}
double rate(const ConstrainedReference& reference, int joint_i = 0) {
    return measured_rate(reference.rows(), reference.state(), joint_i, FigureMeasure::angle);
}

/// A rod falls into its stop: theta'^2 = 3 g (cos theta - cos theta_0), left with e times that; energy tells every speed after.
TEST(ConstrainedEvents, a_pendulum_bounces_off_its_stop) {
    for (const double e : {0.0, 0.5, 1.0}) {
        const double theta_0 = 1.2, stop = -0.3;
        ConstrainedReference reference(pendulum_with_stop(theta_0, stop, e));
        const double rise = 3 * g * (std::cos(stop) - std::cos(theta_0));
        double deepest = 1;
        bool bounced = false;
        for (double t = 0.01; t < 1.1 && !bounced; t += 0.01) {
            reference.advance_to(t);
            deepest = std::min(deepest, angle(reference) + theta_0 - stop);
            bounced = reference.event_count() == 1;
        }
        ASSERT_TRUE(bounced);
        EXPECT_GE(deepest, -1e-12);
        const double theta = angle(reference) + theta_0;
        EXPECT_NEAR(rate(reference) * rate(reference), 3 * g * (std::cos(theta) - std::cos(stop)) + e * e * rise, bar * 100) << e;
    }
}

/// From the horizontal down onto a stop straight below: e = 0 rests there, and the stop carries nothing but the rest of the turn.
TEST(ConstrainedEvents, a_stop_that_is_pressed_carries) {
    ConstrainedReference reference(pendulum_with_stop(pi / 2, 0.4, 0));
    reference.advance_to(2);
    EXPECT_NEAR(angle(reference), 0.4 - pi / 2, 1e-13);
    EXPECT_NEAR(rate(reference), 0, 1e-13);
    // The weight turns it on with g/2 sin(0.4).
    EXPECT_NEAR(reference.loads()[0].torque.y(), g / 2 * std::sin(0.4), bar);
}

/// A ball on a slack rope falls, and the rope takes the speed along itself: what is left is the speed across.
TEST(ConstrainedEvents, a_rope_snaps_taut) {
    FigureScene scene;
    scene.name = "rope";
    FigureBody ball = sphere(2, 0.1, Vector3d(0.6, 0, 0));
    FigureJoint rope = joint_of(FigureJointKind::distance, the_world, scene.add(ball), Vector3d::Zero(), Vector3d::UnitZ(), Vector3d::UnitZ());
    rope.anchor_B = ball.r_CM;
    rope.most = 1;
    scene.join(rope);
    ConstrainedReference reference(scene);
    const double depth = 0.8, t = std::sqrt(2 * depth / g);  // 0.6, 0.8, 1
    reference.advance_to(t - 1e-3);
    EXPECT_EQ(reference.event_count(), 0);
    EXPECT_NEAR(reference.loads()[0].force.norm(), 0, 1e-12);
    reference.advance_to(t + 1e-9);
    EXPECT_EQ(reference.event_count(), 1);
    const Vector3d across = Vector3d(-0.8, 0, -0.6), v = g * t * 0.6 * across;
    EXPECT_LE((reference.state().body(0).v_CM - v).norm(), 1e-7);
    reference.advance_to(t + 0.2);
    EXPECT_NEAR(reference.state().body(0).r_CM.norm(), 1, 1e-13);
    EXPECT_NEAR(reference.energy(), v.squaredNorm() - 2 * g * depth, bar * 10);
}

/// A motor gives its whole torque until it is at speed, then what holds the speed; a load beyond its torque turns it back.
TEST(ConstrainedEvents, a_motor_keeps_to_its_torque) {
    const double J = 1e-3, base = 1e9, speed = 1000, torque = 2;
    ConstrainedReference reference(rotor_on_base(J, base, speed, torque));
    reference.advance_to(0.3);
    EXPECT_NEAR(rate(reference), torque / J * 0.3, 1e-6);
    EXPECT_NEAR(reference.loads()[0].motor, torque, 0);
    reference.advance_to(0.6);
    EXPECT_NEAR(rate(reference), speed, bar * speed);
    EXPECT_NEAR(reference.loads()[0].motor, 0, 1e-6);
    EXPECT_EQ(reference.event_count(), 1);

    FigureScene lifting = pendulum_with_stop(0, -infinity, 0);
    lifting.joint(0).motor = {1, 3};  // g/2 sin theta passes 3 N m at theta = 0.658
    ConstrainedReference lifted(lifting);
    lifted.advance_to(0.6);
    EXPECT_NEAR(rate(lifted), 1, bar);
    EXPECT_NEAR(lifted.loads()[0].motor, g / 2 * std::sin(angle(lifted)), bar);
    lifted.advance_to(1);
    EXPECT_EQ(lifted.loads()[0].motor, 3);
    EXPECT_LT(rate(lifted), 1);
}

/// A pendulum from the horizontal breaks where 5/2 m g cos(theta) along and 1/4 m g sin(theta) across pass the limit; then it flies.
TEST(ConstrainedEvents, a_joint_breaks_at_its_force) {
    FigureScene scene = pendulum_with_stop(pi / 2, -infinity, 0);
    const auto force = [](double theta) { return g * std::hypot(2.5 * std::cos(theta), 0.25 * std::sin(theta)); };
    scene.joint(0).break_force = force(0.5);
    ConstrainedReference reference(scene);
    while (reference.event_count() == 0) reference.advance_to(reference.state().t + 0.01);
    EXPECT_FALSE(reference.scene().joint(0).enabled);
    // Spin stays, and it was that of theta = 0.5.
    const double spin = std::sqrt(3 * g * std::cos(0.5));
    EXPECT_NEAR(reference.state().body(0).omega.norm(), spin, bar);
    const double E = reference.energy();
    reference.advance_to(reference.state().t + 0.3);
    EXPECT_NEAR(reference.state().body(0).omega.norm(), spin, bar);
    EXPECT_NEAR(reference.energy(), E, bar);
}

/// A limb that stops at its limit takes the figure with it: momentum stays, energy goes with e < 1 and stays with e = 1.
TEST(ConstrainedEvents, limits_of_free_figures_keep_momentum) {
    for (const double e : {0.0, 1.0}) {
        const FigureScene scene = floating_ragdoll(e);
        ConstrainedReference reference(scene);
        const FigureState start = reference.state();
        const double E = reference.energy();
        reference.advance_to(0.7);
        EXPECT_GE(reference.event_count(), 1);
        EXPECT_LE(worst_excess(reference.rows(), reference.state()), 1e-12);
        EXPECT_LE((momentum(scene, reference.state()) - momentum(scene, start)).norm(), 1e-11);
        EXPECT_LE((angular_momentum(scene, reference.state()) - angular_momentum(scene, start)).norm(), 1e-10);
        if (e == 1) {
            EXPECT_NEAR(reference.energy(), E, bar);
        } else {
            EXPECT_LT(reference.energy(), 0.999 * E);
        }
    }
}

}  // namespace
