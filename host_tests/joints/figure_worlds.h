// SPDX-License-Identifier: MIT
// Plain figures as worlds of the kernel, and where it takes them: what the references are compared with.
#pragma once

#include <ingot/ingot.h>

#include <cmath>
#include <vector>

#include "joints/figure_scenes.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace ingot_figures {

inline ingot::Joint kernel_joint(FigureJointKind kind) {
    switch (kind) {
        case FigureJointKind::hinge: return ingot::HingeJoint{};
        case FigureJointKind::slider: return ingot::SliderJoint{};
        case FigureJointKind::universal: return ingot::UniversalJoint{};
        case FigureJointKind::fixed: return ingot::FixedJoint{};
        default: return ingot::BallJoint{};
    }
}

/// What a tree is drawn from.
struct DrawnTree {
    int bodies;
    double mass_ratio;  ///< of any two, at most
    double spin;        ///< rad/s, of a body, before its joints have their say
    bool tied;          ///< to the world by its first body, and it has weight; else it floats without any
};
/// A tree of boxes: each is joined, by a joint of any kind of the five, A and B either way round, to one before it.
inline FigureScene random_tree(ingot_reference::RandomInput& random, const DrawnTree& drawn) {
    constexpr FigureJointKind kinds[] = {FigureJointKind::ball, FigureJointKind::hinge, FigureJointKind::slider, FigureJointKind::universal,
                                         FigureJointKind::fixed};
    FigureScene scene;
    scene.name = "random tree";
    if (!drawn.tied) scene.g.setZero();
    for (int body_i = 0; body_i < drawn.bodies; ++body_i) {
        const double size = random.real(0.1, 0.4), M = std::exp(random.real(0, std::log(drawn.mass_ratio)));
        const auto side = [&] { return size * random.real(0.2, 1); };
        const Vector3d half_extents(side(), side(), side());
        const int parent = body_i == 0 ? the_world : random.integer(0, body_i - 1);
        const Vector3d anchor = parent == the_world ? Vector3d(Vector3d::Zero()) : Vector3d(scene.body(parent).r_CM + size * random.direction());
        FigureBody body = box(M, half_extents, anchor + size * random.direction(), random.rotation());
        body.omega = random.vector(drawn.spin);
        scene.add(body);
        if (body_i == 0 && !drawn.tied) continue;
        const FigureJointKind kind = kinds[random.integer(0, 4)];
        const Vector3d axis = random.direction(), across = axis.cross(Vector3d(random.direction())).normalized();
        const bool turned = parent != the_world && random.integer(0, 1) == 1;
        scene.join(
            joint_of(kind, turned ? body_i : parent, turned ? parent : body_i, anchor, axis, kind == FigureJointKind::universal ? across : axis));
    }
    hold_joints(scene);
    return scene;
}

/// A scene of figures in a world of the kernel; bodies touch nothing. Kinds: ball, hinge, slider, universal, fixed.
template <class Scene>
class FigureWorld {
public:
    explicit FigureWorld(const FigureScene& scene) : scene_(scene) {
        using ingot_reference::to_vector;
        sound_ = world.set_gravity(to_vector(scene.g)) == ingot::Status::ok;
        for (const FigureBody& body : scene.bodies) {
            ingot::BodyDef def;
            def.immovable = body.M <= 0;
            if (!def.immovable) def.mass = ingot_reference::to_mass(body.M, body.I_body);
            def.state.r_CM = to_vector(body.r_CM);
            def.state.v_CM = to_vector(body.v_CM);
            def.state.A = ingot_reference::to_matrix(body.A);
            def.state.L = to_vector(body.A * body.I_body.cwiseProduct(body.A.transpose() * body.omega));
            const auto id = world.add(def);
            sound_ = sound_ && id.ok();
            bodies.push_back(id.value);
        }
        for (const FigureJoint& joint : scene.joints) {
            ingot::JointDef def;
            if (joint.body_A != the_world) def.body_A = bodies[static_cast<std::size_t>(joint.body_A)];
            if (joint.body_B != the_world) def.body_B = bodies[static_cast<std::size_t>(joint.body_B)];
            def.joint = kernel_joint(joint.kind);
            def.P = to_vector(joint.anchor);
            def.axis = to_vector(joint.axis_A);
            def.axis_B = to_vector(joint.axis_B);
            const auto id = world.add_joint(def);
            sound_ = sound_ && id.ok();
            joints.push_back(id.value);
        }
    }

    /// No call was refused.
    bool sound() const { return sound_; }

    FigureState state() const {
        FigureState state;
        for (std::size_t body_i = 0; body_i < bodies.size(); ++body_i) {
            const ingot::BodyState now = world.state(bodies[body_i]).value;
            const Matrix3d A = ingot_reference::to_eigen(now.A);
            BodyMotion motion;
            motion.r_CM = ingot_reference::to_eigen(now.r_CM);
            motion.v_CM = ingot_reference::to_eigen(now.v_CM);
            motion.q = Quaterniond(A).normalized();
            if (scene_.bodies[body_i].M > 0)
                motion.omega = A * (A.transpose() * ingot_reference::to_eigen(now.L)).cwiseQuotient(scene_.bodies[body_i].I_body);
            state.bodies.push_back(motion);
        }
        return state;
    }

    ingot::World<Scene> world;
    std::vector<ingot::BodyId> bodies;
    std::vector<ingot::JointId> joints;

private:
    const FigureScene scene_;
    bool sound_ = true;
};

}  // namespace ingot_figures
