// SPDX-License-Identifier: MIT
// Rows of joints by what they are: functions of the poses, so that rate and bias are derivatives along any motion.
#include "joints/joint_rows.h"

#include <gtest/gtest.h>

#include "joints/constrained_reference.h"
#include "joints/figure_scenes.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_figures;
using ingot_reference::RandomInput;

/// Each body goes on by its velocities, which stay: no body accelerates.
FigureState moved(const FigureState& state, double t) {
    FigureState after = state;
    after.t += t;
    for (BodyMotion& body : after.bodies) {
        body.r_CM += t * body.v_CM;
        body.q = (rotation_by(t * body.omega) * body.q).normalized();
    }
    return after;
}

/// All kinds, steered wheels and a rod among them.
FigureScene every_kind(std::uint64_t seed) {
    FigureScene scene = mixed_tree(true, seed);
    for (FigureJoint& joint : scene.joints)
        if (joint.kind == FigureJointKind::wheel) joint.steer_rate = 0.7;
    FigureJoint parallel = joint_of(FigureJointKind::parallel, 2, 4, Vector3d::Zero(), Vector3d(1, 2, 3), Vector3d(1, 2, 3));
    scene.join(parallel);
    return scene;
}

// Central differences over +-d with d = 1e-4: velocities up to 4 rad/s and 4 m/s on arms below 1 m make third and fourth derivatives of some 8^3 and
// 8^4, so they err by 8^3 d^2/6 = 1e-6 and 8^4 d^2/12 = 4e-6; rounding of the second one adds 4 eps / d^2 = 1e-7.
constexpr double d = 1e-4, bar = 1e-5;

TEST(JointRows, rate_and_bias_are_the_derivatives_of_value) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const FigureScene scene = every_kind(seed);
        const JointRows rows(scene);
        RandomInput random(seed);
        FigureState state = start_of(scene);
        state.t = random.real(0, 3);
        for (BodyMotion& body : state.bodies) {  // off the joints, so that no term hides
            body.r_CM += random.vector(0.1);
            body.q = (rotation_by(random.vector(0.2)) * body.q).normalized();
            body.v_CM = random.vector(2);
            body.omega = random.vector(2);
        }
        for (int joint_i = 0; joint_i < scene.joint_count(); ++joint_i) {
            std::vector<FigureRow> before, now, after;
            rows.add_locked(moved(state, -d), joint_i, before);
            rows.add_locked(state, joint_i, now);
            rows.add_locked(moved(state, d), joint_i, after);
            for (std::size_t row_i = 0; row_i < now.size(); ++row_i) {
                if (!now[row_i].has_value) continue;
                EXPECT_NEAR(now[row_i].rate(state), (after[row_i].value - before[row_i].value) / (2 * d), bar) << joint_i << " row " << row_i;
                EXPECT_NEAR(now[row_i].bias, (after[row_i].value - 2 * now[row_i].value + before[row_i].value) / (d * d), bar)
                    << joint_i << " row " << row_i;
            }
        }
    }
}

double acceleration_along(const FigureRow& row, const VectorXd& a) {
    double sum = row.bias;
    for (int part_i = 0; part_i < row.part_count; ++part_i) {
        const FigureRow::Part& part = row.parts[part_i];
        sum += part.on_v.dot(a.segment<3>(6 * part.body)) + part.on_omega.dot(a.segment<3>(6 * part.body + 3));
    }
    return sum;
}

std::vector<FigureMeasure> measures_of(FigureJointKind kind) {
    switch (kind) {
        case FigureJointKind::hinge: return {FigureMeasure::angle};
        case FigureJointKind::wheel: return {FigureMeasure::angle, FigureMeasure::travel};
        case FigureJointKind::slider: return {FigureMeasure::travel};
        case FigureJointKind::universal: return {FigureMeasure::first, FigureMeasure::second};
        case FigureJointKind::ball: return {FigureMeasure::cone, FigureMeasure::twist};
        case FigureJointKind::distance: return {FigureMeasure::length};
        default: return {};
    }
}

/// Angles are those of joints that hold, so this goes along exact motions. Rates here reach r rad/s: differences err by about r^3 d^2 / 6.
TEST(JointRows, measures_move_as_they_say) {
    constexpr double step = 1e-4;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        FigureScene scene = mixed_tree(false, seed);
        scene.g.setZero();
        for (FigureJoint& joint : scene.joints)
            if (joint.kind == FigureJointKind::wheel) joint.steer_rate = 0.7;
        hold_joints(scene);
        ConstrainedReference reference(scene);
        reference.advance_to(0.2 - step);
        const FigureState before = reference.state();
        reference.advance_to(0.2);
        const FigureState now = reference.state();
        const VectorXd a = reference.accelerations();
        reference.advance_to(0.2 + step);
        const FigureState after = reference.state();
        double fastest = 1;
        for (const BodyMotion& body : now.bodies) fastest = std::max(fastest, body.omega.norm());
        const double near = std::pow(2 * fastest, 3) * step * step, nearer = near * 2 * fastest + 1e-15 / step * fastest;
        for (int joint_i = 0; joint_i < scene.joint_count(); ++joint_i) {
            for (const FigureMeasure which : measures_of(scene.joint(joint_i).kind)) {
                const JointRows& rows = reference.rows();
                const FigureRow row = rows.measure(now, joint_i, which), first = rows.measure(before, joint_i, which),
                                last = rows.measure(after, joint_i, which);
                // Cones and twists turn as fast as 1 / sin of the cone's angle near its tip, 1 / cos of half of it at its end.
                double sharp = 1;
                if (which == FigureMeasure::cone) sharp = 1 / std::sin(row.value);
                if (which == FigureMeasure::twist) sharp = 1 / std::cos(rows.measure(now, joint_i, FigureMeasure::cone).value / 2);
                const double factor = sharp * sharp * sharp;
                EXPECT_NEAR(row.rate(now), std::remainder(last.value - first.value, 2 * pi) / (2 * step), near * factor) << joint_i;
                EXPECT_NEAR(acceleration_along(row, a), (last.rate(after) - first.rate(before)) / (2 * step), nearer * factor * sharp) << joint_i;
            }
        }
    }
}

/// A hinge reads the angle that it was turned by, a universal joint both of its angles, a ball cone and twist.
TEST(JointRows, measures_read_what_a_joint_was_turned_by) {
    RandomInput random(3);
    for (int draw = 0; draw < 100; ++draw) {
        const Vector3d n = random.direction(), b = square_to(n);
        FigureScene scene;
        FigureBody body;
        body.A = random.rotation();
        scene.add(body);
        body.A = random.rotation();
        scene.add(body);
        scene.join(hinge(0, 1, Vector3d::Zero(), n));
        scene.join(joint_of(FigureJointKind::universal, 0, 1, Vector3d::Zero(), n, b));
        scene.join(ball(0, 1, Vector3d::Zero()));
        scene.joint(2).axis_A = scene.joint(2).axis_B = n;
        const JointRows rows(scene);
        const FigureState start = start_of(scene);
        const auto turned = [&](const Quaterniond& turn) {
            FigureState state = start;
            state.body(1).q = turn * state.body(1).q;
            return state;
        };
        const double alpha = random.real(-3, 3), beta = random.real(-1.5, 1.5);
        EXPECT_NEAR(rows.measure(turned(rotation_by(alpha * n)), 0, FigureMeasure::angle).value, alpha, 1e-14);

        const FigureState both = turned(rotation_by(alpha * n) * rotation_by(beta * b));
        EXPECT_NEAR(rows.measure(both, 1, FigureMeasure::first).value, alpha, 1e-14);
        EXPECT_NEAR(rows.measure(both, 1, FigureMeasure::second).value, beta, 1e-14);

        const FigureState swung = turned(rotation_by(beta * b) * rotation_by(alpha * n));  // the twist first, then the swing
        EXPECT_NEAR(rows.measure(swung, 2, FigureMeasure::cone).value, std::abs(beta), 1e-14);
        EXPECT_NEAR(std::remainder(rows.measure(swung, 2, FigureMeasure::twist).value - alpha, 2 * pi), 0, 1e-14);
        EXPECT_LE((rows.rotation(turned(rotation_by(alpha * n)), 2) - alpha * n).norm(), 1e-14);
    }
}

}  // namespace
