// SPDX-License-Identifier: MIT
// A ragdoll of eleven capsules: six ball joints and four hinges.
#pragma once

#include "well_but_for_impacts.h"

namespace scenes {

/// Of a ragdoll: a capsule along z, and where its joint to its parent is. Standing, in m, with the feet at z = 0.
struct RagdollPart {
    int parent;
    ingot::scalar x, y, z, half_length, radius, M;
    bool is_hinge;
    ingot::scalar joint_y, joint_z;
};
inline constexpr int parts_of_ragdoll = 11;

/// Pelvis, chest, head, two arms of two parts, two legs of two parts: 66 kg.
constexpr RagdollPart ragdoll_part(int part_i) {
    using ingot::scalar;
    constexpr auto m = [](double x) { return static_cast<scalar>(x); };
    constexpr RagdollPart parts[parts_of_ragdoll] = {
        {-1, 0, 0, m(1.0), m(0.16), m(0.12), 12, false, 0, 0},
        {0, 0, 0, m(1.35), m(0.2), m(0.13), 18, false, 0, m(1.15)},
        {1, 0, 0, m(1.72), m(0.06), m(0.1), 5, false, 0, m(1.57)},
        {1, 0, m(0.28), m(1.33), m(0.2), m(0.05), 2, false, m(0.22), m(1.5)},
        {3, 0, m(0.28), m(1.03), m(0.18), m(0.045), m(1.3), true, m(0.28), m(1.18)},
        {1, 0, m(-0.28), m(1.33), m(0.2), m(0.05), 2, false, m(-0.22), m(1.5)},
        {5, 0, m(-0.28), m(1.03), m(0.18), m(0.045), m(1.3), true, m(-0.28), m(1.18)},
        {0, 0, m(0.1), m(0.72), m(0.3), m(0.07), 7, false, m(0.1), m(0.92)},
        {7, 0, m(0.1), m(0.28), m(0.3), m(0.06), 4, true, m(0.1), m(0.5)},
        {0, 0, m(-0.1), m(0.72), m(0.3), m(0.07), 7, false, m(-0.1), m(0.92)},
        {9, 0, m(-0.1), m(0.28), m(0.3), m(0.06), 4, true, m(-0.1), m(0.5)}};
    return parts[part_i];
}

struct RagdollIds {
    ingot::BodyId parts[parts_of_ragdoll];
    ingot::JointId joints[parts_of_ragdoll];  ///< of each part to its parent; the first has none
};

/// A turns it as a whole, about its feet, which stand at place.
template <class S>
ingot::Status add_ragdoll(ingot::World<S>& world, const ingot::Vector& place, const ingot::Matrix& A, RagdollIds& ids) {
    using ingot::scalar;
    for (int part_i = 0; part_i < parts_of_ragdoll; ++part_i) {
        const RagdollPart part = ragdoll_part(part_i);
        const ingot::MassDistribution solid = ingot::with_mass(ingot::solid_capsule(1, part.radius, part.half_length), part.M);
        ingot::BodyDef body;
        body.mass = {solid.M, {solid.I.xx, solid.I.yy, solid.I.zz}, {}, ingot::identity_matrix<scalar>()};
        body.shape = ingot::Capsule{part.radius, part.half_length};
        body.state.A = A;
        body.state.r_CM = place + A * ingot::Vector{part.x, part.y, part.z};
        body.friction = scalar(0.6);
        const ingot::Result<ingot::BodyId> added = world.add(body);
        if (!added.ok()) return added.status;
        ids.parts[part_i] = added.value;
        if (part.parent < 0) continue;
        ingot::JointDef def;
        def.body_A = ids.parts[part.parent];
        def.body_B = added.value;
        def.P = place + A * ingot::Vector{0, part.joint_y, part.joint_z};
        def.axis = A.c1;
        if (part.is_hinge) def.joint = ingot::HingeJoint{};
        else def.joint = ingot::BallJoint{};
        const ingot::Result<ingot::JointId> joint = world.add_joint(def);
        if (!joint.ok()) return joint.status;
        ids.joints[part_i] = joint.value;
    }
    return ingot::Status::ok;
}

/// Two of them fall on the ground and on each other.
struct Ragdolls : ingot::Scene {
    static constexpr const char* name = "ragdolls";
    static constexpr const char* title = "two ragdolls fall on each other";
    static constexpr int ragdolls = 2;
    static constexpr int max_bodies = 1 + ragdolls * parts_of_ragdoll, max_joints = ragdolls * (parts_of_ragdoll - 1);
    static constexpr int max_manifolds = 80, max_pairs = 240;
    static constexpr bool translates = true, sleeps = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint>;
    using shapes = ingot::Shapes<ingot::Capsule, ingot::HalfSpace>;

    static constexpr ingot::scalar h = ingot::scalar(1) / 60;  ///< s
    static constexpr int golden_steps = 90;
    static bool went_well(ingot::StepReport report) { return well_but_for_impacts(report); }
};
inline ingot::Status set_up(ingot::World<Ragdolls>& world) {
    using ingot::scalar;
    ingot::Status status = world.set_gravity({0, 0, scalar(-9.81)});
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    ground.friction = scalar(0.6);
    if (status == ingot::Status::ok) status = world.add(ground).status;
    constexpr ingot::Vector x = {1, 0, 0};
    const ingot::Matrix lying = ingot::axis_angle(x, scalar(-1.2)), leaning = ingot::axis_angle(x, scalar(0.3));
    RagdollIds ids;
    if (status == ingot::Status::ok) status = add_ragdoll(world, {0, scalar(-0.8), scalar(0.5)}, lying, ids);
    if (status == ingot::Status::ok) status = add_ragdoll(world, {0, scalar(0.3), scalar(0.9)}, leaning, ids);
    return status;
}

}  // namespace scenes
