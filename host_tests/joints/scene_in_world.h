// SPDX-License-Identifier: MIT
// A scene of figure_scenes.h in a world, and its state brought back: bodies and joints of the world in the order of the scene.
#pragma once

#include <ingot/ingot.h>

#include "figures.h"
#include "joints/figure.h"
#include "reference/kernel_types.h"

namespace ingot_figures {

using figures::Built;

/// An end of the reference, which may be infinite.
inline ingot::scalar end_of(double end) {
    return end == infinity ? ingot::unlimited : end == -infinity ? -ingot::unlimited : static_cast<ingot::scalar>(end);
}

/// Kinds: ball, hinge, slider, universal, fixed, with their limits; a distance that is a rod or a rope, parallel.
inline ingot::Joint kernel_joint(const FigureJoint& joint) {
    const ingot::scalar lower = end_of(joint.lower), upper = end_of(joint.upper), e = static_cast<ingot::scalar>(joint.restitution);
    switch (joint.kind) {
        case FigureJointKind::ball:
            return ingot::BallJoint{end_of(joint.cone), end_of(joint.twist_lower), end_of(joint.twist_upper), e,
                                    ingot_reference::to_vector(joint.axis_A)};
        case FigureJointKind::hinge: return ingot::HingeJoint{lower, upper, e};
        case FigureJointKind::slider: return ingot::SliderJoint{lower, upper, e};
        case FigureJointKind::universal: return ingot::UniversalJoint{{lower, upper}, {}, e};
        case FigureJointKind::fixed: return ingot::FixedJoint{};
        case FigureJointKind::parallel: return ingot::ParallelJoint{};
        case FigureJointKind::distance:
            if (joint.is_rod()) return ingot::RodJoint{static_cast<ingot::scalar>(joint.most)};
            return ingot::RopeJoint{static_cast<ingot::scalar>(joint.most)};
        default: return {};
    }
}

/// With its shape, where the world's scene has shapes.
template <class Scene>
ingot::BodyDef definition_of(const FigureBody& body) {
    using namespace ingot_reference;
    ingot::BodyDef def;
    def.state.r_CM = to_vector(body.r_CM);
    def.state.A = to_matrix(body.A);
    def.immovable = body.M == 0;
    if (!def.immovable) {
        def.mass = to_mass(body.M, body.I_body);
        def.state.v_CM = to_vector(body.v_CM);
        def.state.L = to_vector(body.A * body.I_body.cwiseProduct(body.A.transpose() * body.omega));
    }
    if constexpr (ingot::has_shapes<Scene>) {
        const ingot::Vector half = to_vector(body.half_extent);
        if (body.shape == FigureShape::box) def.shape = ingot::Box{half};
        if (body.shape == FigureShape::sphere) def.shape = ingot::Sphere{half.x};
        if (body.shape == FigureShape::capsule) def.shape = ingot::Capsule{half.x, half.z};
        def.friction = static_cast<ingot::scalar>(body.friction);
        def.restitution = static_cast<ingot::scalar>(body.restitution);
    }
    return def;
}

/// body_of(i): what the world calls body i of the scene.
template <class BodyOf>
ingot::JointDef joint_def(const FigureJoint& joint, const BodyOf& body_of) {
    using ingot_reference::to_vector;
    ingot::JointDef def;
    def.body_A = body_of(joint.body_A);
    def.body_B = body_of(joint.body_B);
    def.joint = kernel_joint(joint);
    def.P = to_vector(joint.anchor);
    def.P_B = to_vector(joint.anchor_B);
    def.axis = to_vector(joint.kind == FigureJointKind::ball ? joint.axis_B : joint.axis_A);
    if (joint.kind == FigureJointKind::universal) def.axis_B = to_vector(joint.axis_B);
    return def;
}

/// Bodies and joints of a scene as it starts.
template <class Scene>
Built add_scene(ingot::World<Scene>& world, const FigureScene& scene) {
    using ingot_reference::to_vector;
    Built built;
    built.sound = world.set_gravity(to_vector(scene.g)) == ingot::Status::ok;
    for (const FigureBody& body : scene.bodies) {
        const auto id = world.add(definition_of<Scene>(body));
        built.sound = built.sound && id.ok();
        built.bodies.push_back(id.value);
    }
    for (const FigureJoint& joint : scene.joints) {
        const auto body_of = [&](int body_i) { return body_i == the_world ? ingot::BodyId{} : built.bodies[static_cast<std::size_t>(body_i)]; };
        const auto id = world.add_joint(joint_def(joint, body_of));
        built.sound = built.sound && id.ok();
        built.joints.push_back(id.value);
    }
    return built;
}

/// As the reference has it.
template <class Scene>
FigureState state_of(const ingot::World<Scene>& world, const Built& built) {
    using ingot_reference::to_eigen;
    FigureState state;
    for (const ingot::BodyId id : built.bodies) {
        const ingot::BodyState body = world.state(id).value;
        state.bodies.push_back(
            {to_eigen(body.r_CM), Quaterniond(to_eigen(body.A)).normalized(), to_eigen(body.v_CM), to_eigen(world.omega(id).value)});
    }
    return state;
}

}  // namespace ingot_figures
