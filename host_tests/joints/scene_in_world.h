// SPDX-License-Identifier: MIT
// A scene of figure_scenes.h in a world, and its state brought back: bodies and joints of the world in the order of the scene.
#pragma once

#include <ingot/ingot.h>

#include <vector>

#include "joints/figure.h"
#include "reference/kernel_types.h"

namespace ingot_figures {

struct InWorld {
    std::vector<ingot::BodyId> bodies;
    std::vector<ingot::JointId> joints;
    bool sound = true;  ///< no call was refused
};

inline ingot::Joint joint_kind(FigureJointKind kind) {
    switch (kind) {
        case FigureJointKind::ball: return ingot::BallJoint{};
        case FigureJointKind::hinge: return ingot::HingeJoint{};
        case FigureJointKind::slider: return ingot::SliderJoint{};
        case FigureJointKind::universal: return ingot::UniversalJoint{};
        case FigureJointKind::fixed: return ingot::FixedJoint{};
        default: return {};
    }
}

/// The world has the shapes of the scene, or none.
template <bool with_shapes, class World>
InWorld bring(World& world, const FigureScene& scene) {
    using namespace ingot_reference;
    InWorld in;
    in.sound = world.set_gravity(to_vector(scene.g)) == ingot::Status::ok;
    for (const FigureBody& body : scene.bodies) {
        ingot::BodyDef def;
        def.immovable = body.M == 0;
        if (body.M > 0) def.mass = to_mass(body.M, body.I_body);
        const Vector3d L = body.A * body.I_body.cwiseProduct(body.A.transpose() * body.omega);
        def.state = {to_vector(body.r_CM), to_vector(body.v_CM), to_matrix(body.A), def.immovable ? ingot::Vector{} : to_vector(L)};
        if constexpr (with_shapes) {
            const auto s = [&](double x) { return static_cast<ingot::scalar>(x); };
            if (body.shape == FigureShape::sphere) def.shape = ingot::Sphere{s(body.half_extent.x())};
            if (body.shape == FigureShape::capsule) def.shape = ingot::Capsule{s(body.half_extent.x()), s(body.half_extent.z())};
            if (body.shape == FigureShape::box) def.shape = ingot::Box{to_vector(body.half_extent)};
            def.friction = s(body.friction);
            def.restitution = s(body.restitution);
        }
        const auto id = world.add(def);
        in.sound = in.sound && id.ok();
        in.bodies.push_back(id.value);
    }
    for (const FigureJoint& joint : scene.joints) {
        ingot::JointDef def;
        if (joint.body_A != the_world) def.body_A = in.bodies[static_cast<size_t>(joint.body_A)];
        def.body_B = in.bodies[static_cast<size_t>(joint.body_B)];
        def.joint = joint_kind(joint.kind);
        def.P = to_vector(joint.anchor);
        def.axis = to_vector(joint.axis_A);
        def.axis_B = to_vector(joint.axis_B);
        const auto id = world.add_joint(def);
        in.sound = in.sound && id.ok();
        in.joints.push_back(id.value);
    }
    return in;
}

template <class World>
FigureState state_of(const World& world, const InWorld& in) {
    using namespace ingot_reference;
    FigureState state;
    for (const ingot::BodyId id : in.bodies) {
        const ingot::BodyState body = world.state(id).value;
        BodyMotion motion;
        motion.r_CM = to_eigen(body.r_CM);
        motion.q = Quaterniond(to_eigen(body.A)).normalized();
        motion.v_CM = to_eigen(body.v_CM);
        motion.omega = to_eigen(world.omega(id).value);
        state.bodies.push_back(motion);
    }
    return state;
}

/// m, of all its joints, as the world tells it.
template <class World>
double worst_joint_gap(const World& world, const InWorld& in) {
    double worst = 0;
    for (const ingot::JointId id : in.joints) worst = std::max(worst, static_cast<double>(world.joint_gap(id).value));
    return worst;
}

}  // namespace ingot_figures
