// SPDX-License-Identifier: MIT
// Scenes start as they say: on their joints, within their limits, with masses and energies that are published or told.
#include "joints/figure_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "joints/figure_measures.h"

namespace {

using namespace ingot_figures;

std::vector<FigureScene> all_scenes() {
    const Matrix3d R = rotation_by(Vector3d(0.3, 0.5, 0.7)).toRotationMatrix();
    ChainOptions hinged;
    hinged.kind = FigureJointKind::hinge;
    RagdollOptions balls;
    balls.all_balls = true;
    return {planar_pendulum(9.8125, 2.5),
            spherical_pendulum(10, 1.25, Vector3d(0.75, 0, -1), Vector3d(0, 2.75, 0)),
            double_parallel_pendulum({}),
            double_perpendicular_pendulum({}),
            pendulum_with_stop(1.2, -0.3, 0),
            spring_rotor(1e-3, 1, 0, 1),
            chain(),
            chain(hinged),
            floating_chain(),
            breaking_chain(),
            heavy_top(),
            binary_tree(),
            mixed_tree(),
            mixed_tree(true, 9),
            ragdoll_11(),
            ragdoll_11(balls),
            ragdoll_20(),
            ragdoll_20(balls),
            heap_of_ragdolls(16),
            heap_of_ragdolls(128),
            column_of_ragdolls(),
            standing_figure(1000),
            lying_figure(30),
            bridge(),
            rope_over_edge(),
            door(3),
            four_bar(),
            four_bar(true, 2, 3, R),
            bennett_loop(1, 2),
            slider_crank(),
            car(),
            car(2, 150, 0.3),
            arm(),
            rotor_on_base()};
}

TEST(FigureScenes, start_on_their_joints_and_within_their_limits) {
    for (const FigureScene& scene : all_scenes()) {
        const JointRows rows(scene);
        const FigureState start = start_of(scene);
        EXPECT_LE(worst_gap(rows, start), 1e-14) << scene.name;
        EXPECT_LE(worst_misalignment(rows, start), 1e-14) << scene.name;
        EXPECT_LE(worst_excess(rows, start), 1e-14) << scene.name;
        std::vector<FigureRow> locked;
        for (int joint_i = 0; joint_i < scene.joint_count(); ++joint_i) rows.add_locked(start, joint_i, locked);
        double fastest = 1;
        for (const FigureBody& body : scene.bodies) fastest = std::max({fastest, body.omega.norm(), body.v_CM.norm()});
        for (const FigureRow& row : locked) EXPECT_NEAR(row.rate(start), 0, 1e-13 * fastest) << scene.name;
    }
}

/// Rotations turn, moments are possible ones, axes are unit vectors, parents stand before children.
TEST(FigureScenes, are_well_formed) {
    for (const FigureScene& scene : all_scenes()) {
        for (const FigureBody& body : scene.bodies) {
            EXPECT_LE((body.A.transpose() * body.A - Matrix3d::Identity()).norm(), 1e-14) << scene.name;
            if (body.M <= 0) continue;
            for (int i = 0; i < 3; ++i) EXPECT_GE(body.I_body.sum() - 2 * body.I_body(i), 0) << scene.name;
            EXPECT_GT(body.I_body.minCoeff(), 0) << scene.name;
        }
        for (const FigureJoint& joint : scene.joints) {
            EXPECT_NEAR(joint.axis_A.norm(), 1, 1e-14) << scene.name;
            EXPECT_NEAR(joint.axis_B.norm(), 1, 1e-14) << scene.name;
            EXPECT_LT(joint.body_A, joint.body_B) << scene.name;
            EXPECT_LT(joint.body_B, scene.body_count()) << scene.name;
        }
    }
}

/// Lowest point of a body that has a shape.
double bottom(const FigureBody& body) {
    if (body.shape == FigureShape::sphere) return body.r_CM.z() - body.half_extent.x();
    if (body.shape == FigureShape::capsule) return body.r_CM.z() - body.half_extent.x() - std::abs(body.A(2, 2)) * body.half_extent.z();
    return body.r_CM.z() - (body.A.row(2).cwiseAbs() * body.half_extent)(0);
}

TEST(FigureScenes, have_the_measures_they_name) {
    EXPECT_NEAR(mass(ragdoll_11()), 73.9, 1e-12);
    EXPECT_NEAR(mass(ragdoll_20()), 76.1, 1e-12);
    EXPECT_NEAR(mass(standing_figure(1000)) - mass(standing_figure(1)), 999 * 23, 1e-9);
    const FigureScene hanging = chain();
    EXPECT_EQ(hanging.body_count(), 21);
    double M_g_L = 0;
    for (const FigureBody& body : hanging.bodies) M_g_L += 9.81 * body.M * body.r_CM.x();
    EXPECT_NEAR(M_g_L, 11.04e3, 5);
    EXPECT_EQ(ragdoll_20().body_count(), 20);
    EXPECT_EQ(ragdoll_20().joint_count(), 19);
    EXPECT_EQ(binary_tree(4).body_count(), 15);
    EXPECT_EQ(bridge().joint_count(), 31);
    EXPECT_EQ(rope_over_edge().joint_count(), 31);
    EXPECT_EQ(heap_of_ragdolls(128).body_count(), 1 + 128 * 11);
    int balls = 0;
    for (const FigureJoint& joint : ragdoll_11().joints) balls += joint.kind == FigureJointKind::ball;
    EXPECT_EQ(balls, 6);
}

TEST(FigureScenes, stand_on_the_ground_or_above_it) {
    for (const FigureScene& scene : {heap_of_ragdolls(16), heap_of_ragdolls(128), column_of_ragdolls(), lying_figure(30), standing_figure(1), car()})
        for (const FigureBody& body : scene.bodies) {
            if (body.M <= 0 || body.shape == FigureShape::none) continue;
            EXPECT_GE(bottom(body), -1e-12) << scene.name;
        }
    double lowest = 1;
    for (const FigureBody& body : standing_figure().bodies)
        if (body.M > 0) lowest = std::min(lowest, bottom(body));
    EXPECT_NEAR(lowest, 0, 1e-12);
    for (const FigureBody& body : rope_over_edge().bodies) {  // no link is in the wall
        if (body.M <= 0) continue;
        const Vector3d inside(std::abs(body.r_CM.x()) - 0.18, 0, body.r_CM.z() - 4);
        EXPECT_GE(std::max(inside.x(), inside.z()), 0.02 - 1e-12);
    }
    // Centre of mass over the feet.
    const FigureScene standing = standing_figure(1000);
    const Vector3d centre = centre_of_mass(standing, start_of(standing));
    EXPECT_GT(centre.x(), -0.06);
    EXPECT_LT(centre.x(), 0.17);
}

TEST(FigureScenes, bennett_loop_closes) {
    const FigureScene scene = bennett_loop();
    const JointRows rows(scene);
    // Both ends of the fourth link stand in the world: 0.877 m and 70 degrees.
    const FigureState start = start_of(scene);
    const Vector3d p = rows.anchor_A(start, 0), q = rows.anchor_A(start, 3);
    EXPECT_NEAR((p - q).norm(), 0.6 * std::sin(70 * pi / 180) / std::sin(40 * pi / 180), 1e-14);
    EXPECT_NEAR(rows.axis_A(start, 0).dot(rows.axis_A(start, 3)), std::cos(70 * pi / 180), 1e-14);
}

}  // namespace
