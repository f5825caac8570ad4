// SPDX-License-Identifier: MIT
// Figures drawn at random, and a ragdoll of eleven bodies.
#pragma once

#include <ingot/ingot.h>

#include <cmath>
#include <vector>

#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace figures {

using ingot::scalar;
using ingot::Vector;
using ingot_reference::RandomInput;

using AllJoints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::FixedJoint>;
inline const ingot::Joint kinds[] = {ingot::BallJoint{}, ingot::HingeJoint{}, ingot::SliderJoint{}, ingot::UniversalJoint{}, ingot::FixedJoint{}};

inline Vector vector_of(const Eigen::Vector3d& v) { return {static_cast<scalar>(v.x()), static_cast<scalar>(v.y()), static_cast<scalar>(v.z())}; }

/// What a figure is drawn from.
struct Drawn {
    int bodies;
    double size;        ///< m, of its bodies
    double mass_ratio;  ///< of any two, at most
    double spin;        ///< rad/s, about as much
    bool tied;          ///< to the world, by its first body
};

struct Built {
    std::vector<ingot::BodyId> bodies;
    std::vector<ingot::JointId> joints;
    bool sound = true;  ///< no call was refused
};

/// A tree of boxes, each joined by a joint of a random kind to one before it, A and B either way round.
template <class World>
void add_figure(World& world, RandomInput& random, const Drawn& drawn, const Eigen::Vector3d& place, Built& built) {
    const size_t first = built.bodies.size();
    const auto arm = [&]() -> Eigen::Vector3d { return random.direction() * (drawn.size * random.real(0.5, 1.5)); };
    for (int body_i = 0; body_i < drawn.bodies; ++body_i) {
        ingot::BodyDef def;
        const double M = 100 * std::pow(2 * drawn.size, 3) * std::exp(random.real(0, std::log(drawn.mass_ratio)));
        const Vector half_extents = vector_of(Eigen::Vector3d(random.real(0.2, 1), random.real(0.2, 1), random.real(0.2, 1)) * drawn.size);
        def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, half_extents), static_cast<scalar>(M))).value;
        def.state.A = ingot_reference::to_matrix(random.rotation());
        ingot::JointDef joint;
        Eigen::Vector3d P = place;
        if (body_i > 0) {
            joint.body_A = built.bodies[first + static_cast<size_t>(random.integer(0, body_i - 1))];
            P = ingot_reference::to_eigen(world.state(joint.body_A).value.r_CM) + arm();
        }
        def.state.r_CM = vector_of(P + arm());
        const auto id = world.add(def);
        built.sound = built.sound && id.ok();
        built.bodies.push_back(id.value);
        joint.body_B = id.value;
        if (random.integer(0, 1) == 1) std::swap(joint.body_A, joint.body_B);
        joint.P = vector_of(P);
        const Eigen::Vector3d axis = random.direction();
        joint.axis = vector_of(axis);
        joint.axis_B = vector_of(axis.cross(random.direction()).normalized());
        joint.joint = kinds[random.integer(0, 4)];
        if (body_i == 0 && !drawn.tied) continue;
        const auto joint_id = world.add_joint(joint);
        built.sound = built.sound && joint_id.ok();
        built.joints.push_back(joint_id.value);
    }
    for (size_t i = first; i < built.bodies.size(); ++i) {
        const scalar I = world.mass(built.bodies[i]).value * static_cast<scalar>(drawn.size * drawn.size * 0.3);
        const ingot::Status status = world.apply_angular_impulse(built.bodies[i], vector_of(random.direction() * drawn.spin) * I);
        built.sound = built.sound && status == ingot::Status::ok;
    }
}

/// Of a ragdoll: a capsule along z, and where its joint to its parent is. Standing, in m, with the feet at z = 0.
struct Part {
    int parent;
    double x, y, z, half_length, radius, M;
    bool is_hinge;
    double joint_y, joint_z;
};
inline constexpr int parts_of_ragdoll = 11;
inline constexpr Part ragdoll_parts[parts_of_ragdoll] = {
    {-1, 0, 0, 1.0, 0.16, 0.12, 12, false, 0, 0},         {0, 0, 0, 1.35, 0.2, 0.13, 18, false, 0, 1.15},
    {1, 0, 0, 1.72, 0.06, 0.1, 5, false, 0, 1.57},        {1, 0, 0.28, 1.33, 0.2, 0.05, 2, false, 0.22, 1.5},
    {3, 0, 0.28, 1.03, 0.18, 0.045, 1.3, true, 0.28, 1.18}, {1, 0, -0.28, 1.33, 0.2, 0.05, 2, false, -0.22, 1.5},
    {5, 0, -0.28, 1.03, 0.18, 0.045, 1.3, true, -0.28, 1.18}, {0, 0, 0.1, 0.72, 0.3, 0.07, 7, false, 0.1, 0.92},
    {7, 0, 0.1, 0.28, 0.3, 0.06, 4, true, 0.1, 0.5},      {0, 0, -0.1, 0.72, 0.3, 0.07, 7, false, -0.1, 0.92},
    {9, 0, -0.1, 0.28, 0.3, 0.06, 4, true, -0.1, 0.5}};

/// Six ball joints and four hinges; A turns it as a whole, about its feet.
template <class World>
void add_ragdoll(World& world, const Vector& place, const ingot::Matrix& A, Built& built) {
    const size_t first = built.bodies.size();
    const auto at = [&](double x, double y, double z) {
        return place + A * Vector{static_cast<scalar>(x), static_cast<scalar>(y), static_cast<scalar>(z)};
    };
    for (const Part& part : ragdoll_parts) {
        const auto radius = static_cast<scalar>(part.radius), half_length = static_cast<scalar>(part.half_length);
        ingot::BodyDef def;
        def.mass = ingot::principal(ingot::with_mass(ingot::solid_capsule(1, radius, half_length), static_cast<scalar>(part.M))).value;
        def.shape = ingot::Capsule{radius, half_length};
        def.state.A = A;
        def.state.r_CM = at(part.x, part.y, part.z);
        def.friction = scalar(0.6);
        const auto id = world.add(def);
        built.sound = built.sound && id.ok();
        built.bodies.push_back(id.value);
        if (part.parent < 0) continue;
        ingot::JointDef joint;
        joint.body_A = built.bodies[first + static_cast<size_t>(part.parent)];
        joint.body_B = id.value;
        joint.P = at(0, part.joint_y, part.joint_z);
        joint.axis = A.c1;
        joint.joint = part.is_hinge ? ingot::Joint(ingot::HingeJoint{}) : ingot::Joint(ingot::BallJoint{});
        const auto joint_id = world.add_joint(joint);
        built.sound = built.sound && joint_id.ok();
        built.joints.push_back(joint_id.value);
    }
}

/// m, of all its joints.
template <class World>
double worst_gap(const World& world, const Built& built) {
    double worst = 0;
    for (const ingot::JointId id : built.joints) worst = std::max(worst, static_cast<double>(world.joint_gap(id).value));
    return worst;
}

/// J, with that of height.
template <class World>
double energy_of(const World& world, const Built& built, double g) {
    double energy = static_cast<double>(world.kinetic_energy());
    for (const ingot::BodyId id : built.bodies)
        energy += g * static_cast<double>(world.mass(id).value) * static_cast<double>(world.state(id).value.r_CM.z);
    return energy;
}

}  // namespace figures
