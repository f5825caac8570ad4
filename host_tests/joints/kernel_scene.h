// SPDX-License-Identifier: MIT
// Plain scenes of joints brought into a world of the kernel, and states out of it.
#pragma once

#include <ingot/ingot.h>

#include <vector>

#include "joints/figure.h"
#include "reference/kernel_types.h"

namespace kernel_scene {

using ingot::scalar;
using ingot::Vector;
using ingot_figures::FigureBody;
using ingot_figures::FigureJoint;
using ingot_figures::FigureJointKind;
using ingot_figures::FigureScene;
using ingot_figures::FigureShape;
using ingot_figures::FigureState;

inline Vector vector_of(const Eigen::Vector3d& v) { return {static_cast<scalar>(v.x()), static_cast<scalar>(v.y()), static_cast<scalar>(v.z())}; }

/// An end of the reference, which may be infinite.
inline scalar end_of(double end) {
    return end == ingot_figures::infinity ? ingot::unlimited : end == -ingot_figures::infinity ? -ingot::unlimited : static_cast<scalar>(end);
}

struct Built {
    std::vector<ingot::BodyId> bodies;
    std::vector<ingot::JointId> joints;
    bool sound = true;  ///< no call was refused
};

inline ingot::Joint kind_of(const FigureJoint& joint) {
    const scalar lower = end_of(joint.lower), upper = end_of(joint.upper), e = static_cast<scalar>(joint.restitution);
    switch (joint.kind) {
        case FigureJointKind::ball:
            return ingot::BallJoint{end_of(joint.cone), end_of(joint.twist_lower), end_of(joint.twist_upper), e, vector_of(joint.axis_A)};
        case FigureJointKind::hinge: return ingot::HingeJoint{lower, upper, e};
        case FigureJointKind::slider: return ingot::SliderJoint{lower, upper, e};
        case FigureJointKind::universal: return ingot::UniversalJoint{{lower, upper}, {}, e};
        case FigureJointKind::fixed: return ingot::FixedJoint{};
        default: return {};
    }
}

template <class Scene>
ingot::BodyDef definition_of(const FigureBody& body) {
    ingot::BodyDef def;
    def.state.r_CM = vector_of(body.r_CM);
    def.state.A = ingot_reference::to_matrix(body.A);
    def.immovable = body.M == 0;
    if (!def.immovable) {
        def.mass.M = static_cast<scalar>(body.M);
        def.mass.I_body = vector_of(body.I_body);
        def.state.v_CM = vector_of(body.v_CM);
        def.state.L = vector_of(body.A * body.I_body.asDiagonal() * body.A.transpose() * body.omega);
    }
    if constexpr (ingot::has_shapes<Scene>) {
        const Vector half = vector_of(body.half_extent);
        if (body.shape == FigureShape::box) def.shape = ingot::Box{half};
        if (body.shape == FigureShape::sphere) def.shape = ingot::Sphere{half.x};
        if (body.shape == FigureShape::capsule) def.shape = ingot::Capsule{half.x, half.z};
        def.friction = static_cast<scalar>(body.friction);
        def.restitution = static_cast<scalar>(body.restitution);
    }
    return def;
}

/// Bodies and joints of a scene as it starts, all together moved.
template <class Scene>
Built add_scene(ingot::World<Scene>& world, const FigureScene& scene, const Eigen::Vector3d& moved = {0, 0, 0}) {
    Built built;
    built.sound = world.set_gravity(vector_of(scene.g)) == ingot::Status::ok;
    for (FigureBody body : scene.bodies) {
        body.r_CM += moved;
        const auto id = world.add(definition_of<Scene>(body));
        built.sound = built.sound && id.ok();
        built.bodies.push_back(id.value);
    }
    for (const FigureJoint& joint : scene.joints) {
        ingot::JointDef def;
        if (joint.body_A != ingot_figures::the_world) def.body_A = built.bodies[static_cast<size_t>(joint.body_A)];
        def.body_B = built.bodies[static_cast<size_t>(joint.body_B)];
        def.joint = kind_of(joint);
        def.P = vector_of(joint.anchor + moved);
        def.axis = vector_of(joint.kind == FigureJointKind::ball ? joint.axis_B : joint.axis_A);
        if (joint.kind == FigureJointKind::universal) def.axis_B = vector_of(joint.axis_B);
        const auto id = world.add_joint(def);
        built.sound = built.sound && id.ok();
        built.joints.push_back(id.value);
    }
    return built;
}

/// As the reference has it.
template <class Scene>
FigureState state_of(const ingot::World<Scene>& world, const Built& built, double t, const Eigen::Vector3d& moved = {0, 0, 0}) {
    FigureState state;
    state.t = t;
    for (const ingot::BodyId id : built.bodies) {
        const ingot::BodyState body = world.state(id).value;
        state.bodies.push_back({ingot_reference::to_eigen(body.r_CM) - moved,
                                Eigen::Quaterniond(ingot_reference::to_eigen(body.A)).normalized(), ingot_reference::to_eigen(body.v_CM),
                                ingot_reference::to_eigen(world.omega(id).value)});
    }
    return state;
}

/// m, of all its joints.
template <class Scene>
double worst_gap(const ingot::World<Scene>& world, const Built& built) {
    double worst = 0;
    for (const ingot::JointId id : built.joints) worst = std::max(worst, static_cast<double>(world.joint_gap(id).value));
    return worst;
}

}  // namespace kernel_scene
