// SPDX-License-Identifier: MIT
// Figures drawn at random for the reference, and the same in a world.
#pragma once

#include <ingot/ingot.h>

#include <algorithm>
#include <vector>

#include "control/dynamics_reference.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace ingot_control {

using ingot_reference::RandomInput;
using ingot_reference::to_vector;

struct DrawnTree {
    int bodies;
    double mass_ratio;  ///< of any two, at most
    double speed;       ///< rad/s, m/s: of each coordinate, at most
    bool tied;          ///< to the ground, by its first body
};

/// Its coordinates, and where they are.
struct DrawnFigure {
    RefFigure figure;
    std::vector<RefCoordinate> q;
    Vector3d g = Vector3d::Zero();
};

inline ingot::Joint joint_of(RefKind kind) {
    switch (kind) {
        case RefKind::ball: return ingot::BallJoint{};
        case RefKind::hinge: return ingot::HingeJoint{};
        case RefKind::slider: return ingot::SliderJoint{};
        case RefKind::universal: return ingot::UniversalJoint{};
        case RefKind::wheel: return ingot::WheelJoint{};
        default: return ingot::FixedJoint{};
    }
}

/// Each body hangs by a joint of any kind, A and B either way round, on one before it; all coordinates, rates and accelerations are drawn.
inline DrawnFigure draw_figure(RandomInput& random, const DrawnTree& drawn) {
    constexpr RefKind kinds[] = {RefKind::ball, RefKind::hinge, RefKind::slider, RefKind::universal, RefKind::fixed, RefKind::wheel};
    DrawnFigure of;
    RefFigure& figure = of.figure;
    figure.floats = !drawn.tied;
    figure.root = {still(Vector3d(Vector3d::Zero())), still(Matrix3d(Matrix3d::Identity()))};
    of.g = 9.81 * random.direction();
    if (figure.floats) {
        figure.root = {still(random.vector(1)), still(random.rotation())};
        figure.count = 6;
    }
    for (int body_i = 0; body_i < drawn.bodies; ++body_i) {
        RefBody body;
        body.M = std::exp(random.real(0, std::log(drawn.mass_ratio)));
        body.I_body = random.moments(body.M) * 0.1;
        body.weight = body.M * of.g;
        if (body_i > 0 || drawn.tied) {
            body.parent = body_i == 0 ? -1 : random.integer(0, body_i - 1);
            body.kind = kinds[random.integer(0, 5)];
            body.is_A = random.integer(0, 1) == 1;
            body.anchor_A = random.direction() * random.real(0.1, 0.5);
            body.anchor_B = random.direction() * random.real(0.1, 0.5);
            body.axis_A = random.direction();
            body.axis_B = body.axis_A.cross(random.direction()).normalized();
            body.start = random.rotation();
            body.first = figure.count;
            figure.count += directions_of(body.kind);
        }
        figure.bodies.push_back(body);
    }
    for (int k = 0; k < figure.count; ++k) of.q.push_back({random.real(-0.5, 0.5), random.real(-1, 1) * drawn.speed, random.real(-5, 5)});
    return of;
}

/// In a world: bodies and joints of the same numbers; the null id where there is no joint.
struct BuiltFigure {
    std::vector<ingot::BodyId> bodies;
    std::vector<ingot::JointId> joints;
    bool sound = true;
};

inline ingot::BodyState state_of(const RefPose& pose, const Vector3d& I_body) {
    ingot::BodyState state;
    state.r_CM = to_vector(pose.r.at);
    state.A = ingot_reference::to_matrix(pose.A.at);
    state.v_CM = to_vector(pose.r.rate);
    state.L = to_vector(Vector3d(pose.A.at * I_body.cwiseProduct(pose.A.at.transpose() * pose.spin())));
    return state;
}

/// The ground is `ground`, or, of the null id, the world. Joined where all coordinates are 0, then moved to where they are.
template <class Scene>
BuiltFigure add_figure(ingot::World<Scene>& world, const DrawnFigure& drawn, ingot::BodyId ground = {}) {
    const RefFigure& figure = drawn.figure;
    std::vector<RefCoordinate> zero(drawn.q.size(), RefCoordinate{0, 0, 0});
    RefFigure resting = figure;
    resting.root = {still(figure.root.r.at), still(figure.root.A.at)};
    const std::vector<RefPose> begin = resting.poses(zero), now = figure.poses(drawn.q);
    BuiltFigure built;
    built.sound = world.set_gravity(to_vector(drawn.g)) == ingot::Status::ok;
    for (std::size_t i = 0; i < figure.size(); ++i) {
        const RefBody& body = figure.bodies[i];
        ingot::BodyDef def = ingot_reference::definition(body.M, body.I_body);
        def.state = state_of(begin[i], body.I_body);
        const auto id = world.add(def);
        built.sound = built.sound && id.ok();
        built.bodies.push_back(id.value);
        built.joints.push_back({});
        if (i == 0 && figure.floats) continue;
        const RefPose& parent = body.parent < 0 ? resting.root : begin[static_cast<std::size_t>(body.parent)];
        const RefPose& of_A = body.is_A ? begin[i] : parent;
        const ingot::BodyId parent_id = body.parent < 0 ? ground : built.bodies[static_cast<std::size_t>(body.parent)];
        ingot::JointDef joint;
        joint.body_A = body.is_A ? id.value : parent_id;
        joint.body_B = body.is_A ? parent_id : id.value;
        joint.joint = joint_of(body.kind);
        joint.P = to_vector(Vector3d(of_A.r.at + of_A.A.at * body.anchor_A));
        joint.axis = to_vector(Vector3d((of_A.A.at * body.axis_A).normalized()));
        joint.axis_B = to_vector(Vector3d((of_A.A.at * body.axis_B).normalized()));
        const auto joined = world.add_joint(joint);
        built.sound = built.sound && joined.ok();
        built.joints.back() = joined.value;
    }
    for (std::size_t i = 0; i < figure.size(); ++i)
        built.sound = built.sound && world.set_state(built.bodies[i], state_of(now[i], figure.bodies[i].I_body)) == ingot::Status::ok;
    return built;
}

/// By which the numbers of the kernel's figure go: number_of[k] is that of coordinate k.
template <int bodies>
std::vector<int> numbers_of(const ingot::FigureDynamics<bodies>& dynamics, const DrawnFigure& drawn, const BuiltFigure& built) {
    std::vector<int> numbers(drawn.q.size());
    for (int k = 0; k < (drawn.figure.floats ? 6 : 0); ++k) numbers[static_cast<std::size_t>(k)] = k;
    for (std::size_t i = 0; i < built.joints.size(); ++i) {
        const auto directions = dynamics.directions_of(built.joints[i]);
        for (int k = 0; k < directions.value.count; ++k)
            numbers[static_cast<std::size_t>(drawn.figure.bodies[i].first + k)] = directions.value.first + k;
    }
    return numbers;
}

}  // namespace ingot_control
