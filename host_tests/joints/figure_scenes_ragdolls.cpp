// SPDX-License-Identifier: MIT
// Figures of people. Upright, arms down, facing x, left is y; at the start bodies have the axes of the world. Masses and lengths of limbs are those
// of the walking figure of 13 bodies that was published with its gaits (pelvis 14, chest 26, head 4.5, arms 2.1 + 1.6, thighs 7.5, shanks 3.5, feet
// 1.1 kg; thigh 0.43 m, shank 0.42, hips 0.91 high and 0.1 off the middle, heel to toe -0.06 to 0.17). Thicknesses, the trunk and limits are chosen.
#include <string>

#include "joints/constrained_step_reference.h"
#include "joints/figure_scenes.h"
#include "reference/random_input.h"

namespace ingot_figures {

namespace {

constexpr double shoulder_y = 0.21, hip_y = 0.10;

/// Adds bodies and joints, parents first.
class Builder {
public:
    explicit Builder(const RagdollOptions& options) : options_(options) {}

    int add(const FigureBody& body) { return scene.add(body); }

    /// A ball whose cone opens about `middle` for what hangs along `limb`.
    void ball_joint(int A, int B, const Vector3d& anchor, const Vector3d& middle, const Vector3d& limb, double cone, double twist) {
        FigureJoint joint = joint_of(FigureJointKind::ball, A, B, anchor, middle, limb);
        if (options_.limits) {
            joint.cone = cone;
            joint.twist_lower = -twist;
            joint.twist_upper = twist;
        }
        finish(joint);
    }

    void hinge_joint(int A, int B, const Vector3d& anchor, const Vector3d& axis, double lower, double upper) {
        if (options_.all_balls) {
            const Vector3d down = -Vector3d::UnitZ();
            ball_joint(A, B, anchor, down, down, upper, 0.2);
            return;
        }
        FigureJoint joint = hinge(A, B, anchor, axis);
        if (options_.limits) {
            joint.lower = lower;
            joint.upper = upper;
        }
        finish(joint);
    }

    FigureScene scene;

private:
    void finish(FigureJoint joint) {
        joint.servo.stiffness = options_.stiffness;
        joint.servo.damping = options_.damping;
        if (options_.locked) joint = joint_of(FigureJointKind::fixed, joint.body_A, joint.body_B, joint.anchor, Vector3d::UnitZ(), Vector3d::UnitZ());
        scene.join(joint);
    }

    RagdollOptions options_;
};

/// A capsule from `from` to `to`, one above the other; its rounded ends reach beyond the joints by nothing.
FigureBody limb(double M, double radius, const Vector3d& from, const Vector3d& to) {
    return capsule(M, radius, (from - to).norm() / 2 - radius, (from + to) / 2);
}

FigureBody chest_of(const RagdollOptions& options) {
    FigureBody chest = box(26, Vector3d(0.11, 0.16, 0.19), Vector3d(0, 0, 1.31));
    chest.M *= options.torso_factor;
    chest.I_body *= options.torso_factor;
    return chest;
}

const Vector3d down(0, 0, -1), up(0, 0, 1), forward(1, 0, 0), left(0, 1, 0);

Vector3d sideways(double side) { return Vector3d(0.3, 0.5 * side, -1).normalized(); }  // middle of what arms and legs reach

}  // namespace

FigureScene ragdoll_11(const RagdollOptions& options) {
    Builder figure(options);
    figure.scene.name = "ragdoll_11";
    const int pelvis = figure.add(box(14, Vector3d(0.10, 0.15, 0.09), Vector3d(0, 0, 1.0)));
    const int chest = figure.add(chest_of(options));
    figure.ball_joint(pelvis, chest, Vector3d(0, 0, 1.105), up, up, 0.6, 0.5);
    const int head = figure.add(sphere(4.5, 0.11, Vector3d(0, 0, 1.65)));
    figure.ball_joint(chest, head, Vector3d(0, 0, 1.52), up, up, 0.7, 0.9);
    for (const double side : {1.0, -1.0}) {
        const Vector3d shoulder(0, shoulder_y * side, 1.45), elbow(0, shoulder_y * side, 1.16), wrist(0, shoulder_y * side, 0.86);
        const int upper = figure.add(limb(2.1, 0.045, shoulder, elbow));
        figure.ball_joint(chest, upper, shoulder, sideways(side), down, 1.3, 0.8);
        const int lower = figure.add(limb(1.6, 0.04, elbow, wrist));
        figure.hinge_joint(upper, lower, elbow, -left, 0, 2.4);  // bends forward
    }
    for (const double side : {1.0, -1.0}) {
        const Vector3d hip(0, hip_y * side, 0.91), knee(0, hip_y * side, 0.48), ankle(0, hip_y * side, 0.0);
        const int thigh = figure.add(limb(7.5, 0.07, hip, knee));
        figure.ball_joint(pelvis, thigh, hip, sideways(0.4 * side), down, 1.0, 0.5);
        const int shank = figure.add(limb(3.5, 0.05, knee, ankle));
        figure.hinge_joint(thigh, shank, knee, left, 0, 2.4);  // bends back
    }
    return figure.scene;
}

FigureScene floating_ragdoll(double restitution) {
    FigureScene scene = ragdoll_11();
    scene.name = "floating_ragdoll";
    scene.g.setZero();
    for (FigureJoint& joint : scene.joints) joint.restitution = restitution;
    set_rate(scene, 3, 8);
    return scene;
}

FigureScene ragdoll_20(const RagdollOptions& options) {
    Builder figure(options);
    figure.scene.name = "ragdoll_20";
    const int pelvis = figure.add(box(9, Vector3d(0.10, 0.15, 0.07), Vector3d(0, 0, 0.98)));
    const int abdomen = figure.add(box(5, Vector3d(0.09, 0.13, 0.04), Vector3d(0, 0, 1.08)));
    figure.ball_joint(pelvis, abdomen, Vector3d(0, 0, 1.045), up, up, 0.4, 0.3);
    FigureBody trunk = chest_of(options);
    trunk.M *= 23.0 / 26;  // the collar bones have the rest
    trunk.I_body *= 23.0 / 26;
    const int chest = figure.add(trunk);
    figure.ball_joint(abdomen, chest, Vector3d(0, 0, 1.12), up, up, 0.4, 0.3);
    const int head = figure.add(sphere(4.5, 0.11, Vector3d(0, 0, 1.65)));
    figure.ball_joint(chest, head, Vector3d(0, 0, 1.52), up, up, 0.7, 0.9);
    for (const double side : {1.0, -1.0}) {
        const Vector3d collar(0, 0.05 * side, 1.47), shoulder(0, shoulder_y * side, 1.47), elbow(0, shoulder_y * side, 1.17),
            wrist(0, shoulder_y * side, 0.92);
        const int bone = figure.add(capsule(1.5, 0.03, 0.05, (collar + shoulder) / 2, along(side * left)));
        figure.ball_joint(chest, bone, collar, side * left, side * left, 0.3, 0.3);
        const int upper = figure.add(limb(2.1, 0.045, shoulder, elbow));
        figure.ball_joint(bone, upper, shoulder, sideways(side), down, 1.3, 0.8);
        const int lower = figure.add(limb(1.2, 0.04, elbow, wrist));
        figure.hinge_joint(upper, lower, elbow, -left, 0, 2.4);
        const int hand = figure.add(box(0.4, Vector3d(0.04, 0.015, 0.08), wrist + 0.08 * down));
        figure.ball_joint(lower, hand, wrist, down, down, 0.9, 0.3);
    }
    for (const double side : {1.0, -1.0}) {
        const Vector3d hip(0, hip_y * side, 0.91), knee(0, hip_y * side, 0.48), ankle(0, hip_y * side, 0.07), toe(0.11, hip_y * side, 0.02);
        const int thigh = figure.add(limb(7.5, 0.07, hip, knee));
        figure.ball_joint(pelvis, thigh, hip, sideways(0.4 * side), down, 1.0, 0.5);
        const int shank = figure.add(limb(3.5, 0.05, knee, ankle));
        figure.hinge_joint(thigh, shank, knee, left, 0, 2.4);
        const int foot = figure.add(box(0.9, Vector3d(0.085, 0.045, 0.025), Vector3d(0.025, hip_y * side, 0.025)));
        figure.ball_joint(shank, foot, ankle, down, down, 0.6, 0.2);
        const int toes = figure.add(box(0.2, Vector3d(0.03, 0.045, 0.02), Vector3d(0.14, hip_y * side, 0.02)));
        figure.hinge_joint(foot, toes, toe, -left, -0.1, 1.0);  // toes bend up
    }
    return figure.scene;
}

namespace {

/// On its back, head along -x, centre at the origin.
Matrix3d on_its_back() { return Eigen::AngleAxisd(-pi / 2, left).toRotationMatrix(); }

void add_lying(FigureScene& scene, const FigureScene& figure, const Vector3d& r, ingot_reference::RandomInput& random) {
    const Matrix3d R = Eigen::AngleAxisd(random.real(-0.15, 0.15), random.direction()).toRotationMatrix() * on_its_back();
    insert(scene, figure, r - R * Vector3d(0, 0, 0.9), R);
}

}  // namespace

FigureScene heap_of_ragdolls(int count, const RagdollOptions& options, std::uint64_t seed) {
    FigureScene scene;
    scene.name = "heap_of_ragdolls";
    scene.add(ground());
    const FigureScene figure = ragdoll_11(options);
    ingot_reference::RandomInput random(seed);
    const int side = count <= 16 ? 2 : 4;
    for (int figure_i = 0; figure_i < count; ++figure_i) {
        const int layer = figure_i / (side * side), x = figure_i % side, y = figure_i / side % side;
        const double shift = layer % 2 == 0 ? 0 : 0.4;  // layers do not lie straight above each other
        add_lying(scene, figure, Vector3d(2.2 * (x - (side - 1) / 2.0) + shift, 1.1 * (y - (side - 1) / 2.0) + shift, 1.3 * (layer + 1)), random);
    }
    return scene;
}

FigureScene column_of_ragdolls(int count, const RagdollOptions& options, std::uint64_t seed) {
    FigureScene scene;
    scene.name = "column_of_ragdolls";
    scene.add(ground());
    const FigureScene figure = ragdoll_11(options);
    ingot_reference::RandomInput random(seed);
    for (int figure_i = 0; figure_i < count; ++figure_i) add_lying(scene, figure, Vector3d(0, 0, 1 + 1.2 * figure_i), random);
    return scene;
}

FigureScene standing_figure(double torso_factor) {
    RagdollOptions options;
    options.locked = true;
    options.torso_factor = torso_factor;
    FigureScene scene;
    scene.name = "standing_figure";
    scene.add(ground());
    insert(scene, ragdoll_20(options), Vector3d::Zero());
    return scene;
}

FigureScene lying_figure(double torso_factor, double height) {
    RagdollOptions options;
    options.torso_factor = torso_factor;
    FigureScene scene;
    scene.name = "lying_figure";
    scene.add(ground());
    insert(scene, ragdoll_20(options), Vector3d(0, 0, height + 0.2), on_its_back());
    return scene;
}

}  // namespace ingot_figures
