// SPDX-License-Identifier: MIT
// Figures drawn at random, and ragdolls; what tests of joints ask of a world.
#pragma once

#include <ingot/ingot.h>

#include <cmath>
#include <vector>

#include "reference/kernel_types.h"
#include "reference/random_input.h"
#include "scenes/ragdolls.h"

namespace figures {

using ingot::scalar;
using ingot::Vector;
using ingot_reference::RandomInput;
using ingot_reference::to_vector;

inline constexpr double g = 9.81;  ///< m/s^2
inline constexpr double eps = static_cast<double>(ingot::epsilon);
inline constexpr double rates[] = {30, 60, 120, 240, 1000};  ///< steps a second

/// m, of a gap. A push ends below limits::joint_gap, and what it leaves grows by what the next substep turns. Float adds roundings of places.
inline constexpr double held = 2 * static_cast<double>(ingot::limits::joint_gap) + 64 * eps;

/// All kinds, and what joints may have beside: WithLimits, WithDrives.
template <class... Beside>
using AllJointsWith = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::FixedJoint, Beside...>;
using AllJoints = AllJointsWith<>;
inline const ingot::Joint kinds[] = {ingot::BallJoint{}, ingot::HingeJoint{}, ingot::SliderJoint{}, ingot::UniversalJoint{}, ingot::FixedJoint{}};

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

/// False where the world refuses it.
template <class World>
[[nodiscard]] bool weigh(World& world) {
    return world.set_gravity({0, 0, static_cast<scalar>(-g)}) == ingot::Status::ok;
}
/// The half-space below z = 0. False where the world refuses it.
template <class World>
[[nodiscard]] bool add_ground(World& world) {
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    ground.friction = scalar(0.6);
    return world.add(ground).ok();
}

/// A tree of boxes, each joined by a joint of a random kind to one before it, A and B either way round.
template <class World>
void add_figure(World& world, RandomInput& random, const Drawn& drawn, const Eigen::Vector3d& place, Built& built) {
    const size_t first = built.bodies.size();
    const auto arm = [&]() -> Eigen::Vector3d { return random.direction() * (drawn.size * random.real(0.5, 1.5)); };
    for (int body_i = 0; body_i < drawn.bodies; ++body_i) {
        ingot::BodyDef def;
        const double M = 100 * std::pow(2 * drawn.size, 3) * std::exp(random.real(0, std::log(drawn.mass_ratio)));
        const Vector half_extents = to_vector(Eigen::Vector3d(random.real(0.2, 1), random.real(0.2, 1), random.real(0.2, 1)) * drawn.size);
        def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, half_extents), static_cast<scalar>(M))).value;
        def.state.A = ingot_reference::to_matrix(random.rotation());
        ingot::JointDef joint;
        Eigen::Vector3d P = place;
        if (body_i > 0) {
            joint.body_A = built.bodies[first + static_cast<size_t>(random.integer(0, body_i - 1))];
            P = ingot_reference::to_eigen(world.state(joint.body_A).value.r_CM) + arm();
        }
        def.state.r_CM = to_vector(P + arm());
        const auto id = world.add(def);
        built.sound = built.sound && id.ok();
        built.bodies.push_back(id.value);
        joint.body_B = id.value;
        if (random.integer(0, 1) == 1) std::swap(joint.body_A, joint.body_B);
        joint.P = to_vector(P);
        const Eigen::Vector3d axis = random.direction();
        joint.axis = to_vector(axis);
        joint.axis_B = to_vector(axis.cross(random.direction()).normalized());
        joint.joint = kinds[random.integer(0, 4)];
        if (body_i == 0 && !drawn.tied) continue;
        const auto joint_id = world.add_joint(joint);
        built.sound = built.sound && joint_id.ok();
        built.joints.push_back(joint_id.value);
    }
    for (size_t i = first; i < built.bodies.size(); ++i) {
        const scalar I = world.mass(built.bodies[i]).value * static_cast<scalar>(drawn.size * drawn.size * 0.3);
        const ingot::Status status = world.apply_angular_impulse(built.bodies[i], to_vector(random.direction() * drawn.spin) * I);
        built.sound = built.sound && status == ingot::Status::ok;
    }
}

using scenes::parts_of_ragdoll;

/// Six ball joints and four hinges; A turns it as a whole, about its feet.
template <class S>
void add_ragdoll(ingot::World<S>& world, const Vector& place, const ingot::Matrix& A, Built& built) {
    scenes::RagdollIds ids;
    built.sound = scenes::add_ragdoll(world, place, A, ids) == ingot::Status::ok && built.sound;
    built.bodies.insert(built.bodies.end(), ids.parts, ids.parts + parts_of_ragdoll);
    built.joints.insert(built.joints.end(), ids.joints + 1, ids.joints + parts_of_ragdoll);
}

/// m, of all its joints.
template <class World>
double worst_gap(const World& world, const Built& built) {
    double worst = 0;
    for (const ingot::JointId id : built.joints) worst = std::max(worst, static_cast<double>(world.joint_gap(id).value));
    return worst;
}

/// J, of some bodies.
template <class World>
double kinetic_energy_of(const World& world, const std::vector<ingot::BodyId>& bodies) {
    using ingot_reference::to_eigen;
    double sum = 0;
    for (const ingot::BodyId id : bodies) {
        const ingot::BodyState state = world.state(id).value;
        sum += (static_cast<double>(world.mass(id).value) * to_eigen(state.v_CM).squaredNorm() +
                to_eigen(state.L).dot(to_eigen(world.omega(id).value))) / 2;
    }
    return sum;
}

/// J, with that of height.
template <class World>
double energy_of(const World& world, const Built& built) {
    double energy = static_cast<double>(world.kinetic_energy());
    for (const ingot::BodyId id : built.bodies)
        energy += g * static_cast<double>(world.mass(id).value) * static_cast<double>(world.state(id).value.r_CM.z);
    return energy;
}

/// Whether bodies are where others are, and move as they do, to the bit.
template <class A, class B>
bool are_same(const A& a, const B& b, const std::vector<ingot::BodyId>& of_a, const std::vector<ingot::BodyId>& of_b) {
    using ingot_reference::to_eigen;
    bool same = of_a.size() == of_b.size();
    for (size_t i = 0; same && i < of_a.size(); ++i) {
        const ingot::BodyState x = a.state(of_a[i]).value, y = b.state(of_b[i]).value;
        same = to_eigen(x.r_CM) == to_eigen(y.r_CM) && to_eigen(x.A) == to_eigen(y.A) && to_eigen(x.v_CM) == to_eigen(y.v_CM) &&
               to_eigen(x.L) == to_eigen(y.L);
    }
    return same;
}

}  // namespace figures
