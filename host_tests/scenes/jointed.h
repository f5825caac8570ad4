// SPDX-License-Identifier: MIT
// Machines with joints for the smallest targets and the golden hashes: a pendulum of two rods, and an arm of six hinges.
#pragma once

#include <ingot/ingot.h>

namespace scenes {

/// What they share: as many joints as bodies, all of them hinges, and nothing that touches.
template <int links>
struct Hinged : ingot::Scene {
    static constexpr int max_bodies = links, max_joints = links;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::HingeJoint>;
    using rotation = ingot::LieMidpoint;  // of bodies without joints, of which there are none: the smallest

    static constexpr ingot::scalar h = ingot::scalar(1) / 60;  ///< s
    static constexpr ingot::scalar g = ingot::scalar(9.81);    ///< m s^-2
};

/// One link of a machine: a solid box, and the hinge that it hangs on.
struct Link {
    ingot::scalar M;              ///< kg
    ingot::Vector half_extents;   ///< m
    ingot::Vector r_CM;           ///< m, world
    ingot::Vector P, axis;        ///< m and unit, world: the hinge to the link before, of the first one to the world
};

template <class S>
ingot::Status set_up_links(ingot::World<S>& world, const Link (&links)[S::max_bodies]) {
    ingot::Status status = world.set_gravity({0, 0, -S::g});
    ingot::BodyId before{};
    for (int link_i = 0; link_i < S::max_bodies && status == ingot::Status::ok; ++link_i) {
        const Link& link = links[link_i];
        const ingot::MassDistribution solid = ingot::with_mass(ingot::solid_box(1, link.half_extents), link.M);
        ingot::BodyDef body;
        body.mass = {solid.M, {solid.I.xx, solid.I.yy, solid.I.zz}, {}, ingot::identity_matrix<ingot::scalar>()};
        body.state.r_CM = link.r_CM;
        const ingot::Result<ingot::BodyId> added = world.add(body);
        if (!added.ok()) return added.status;
        ingot::JointDef hinge;
        hinge.body_A = before;
        hinge.body_B = added.value;
        hinge.joint = ingot::HingeJoint{};
        hinge.P = link.P;
        hinge.axis = link.axis;
        status = world.add_joint(hinge).status;
        before = added.value;
    }
    return status;
}

/// Two rods of half a metre, let go as they point sideways: chaotic, and with no friction anywhere.
struct DoublePendulum : Hinged<2> {
    static constexpr const char* name = "double_pendulum";
    static constexpr const char* title = "a pendulum of two rods";
    static constexpr int golden_steps = 600;
};
inline ingot::Status set_up(ingot::World<DoublePendulum>& world) {
    using ingot::scalar;
    constexpr ingot::Vector rod = {scalar(0.25), scalar(0.02), scalar(0.02)}, y = {0, 1, 0};
    constexpr Link links[] = {{1, rod, {scalar(0.25), 0, 0}, {}, y}, {1, rod, {scalar(0.75), 0, 0}, {scalar(0.5), 0, 0}, y}};
    return set_up_links<DoublePendulum>(world, links);
}

/// An arm with the axes of an industrial robot, 9 kg, stretched out and let go: its motors are off.
struct ArmOfSix : Hinged<6> {
    static constexpr const char* name = "arm_6";
    static constexpr const char* title = "a robot's arm of six hinges falls";
    static constexpr int golden_steps = 300;
};
inline ingot::Status set_up(ingot::World<ArmOfSix>& world) {
    using ingot::scalar;
    constexpr ingot::Vector x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
    constexpr Link links[] = {
        {3, {scalar(0.08), scalar(0.08), scalar(0.1)}, {0, 0, scalar(0.1)}, {}, z},
        {scalar(2.5), {scalar(0.2), scalar(0.05), scalar(0.05)}, {scalar(0.2), 0, scalar(0.25)}, {0, 0, scalar(0.25)}, y},
        {scalar(1.5), {scalar(0.1), scalar(0.04), scalar(0.04)}, {scalar(0.5), 0, scalar(0.25)}, {scalar(0.4), 0, scalar(0.25)}, y},
        {1, {scalar(0.1), scalar(0.035), scalar(0.035)}, {scalar(0.7), 0, scalar(0.25)}, {scalar(0.6), 0, scalar(0.25)}, x},
        {scalar(0.6), {scalar(0.05), scalar(0.03), scalar(0.03)}, {scalar(0.85), 0, scalar(0.25)}, {scalar(0.8), 0, scalar(0.25)}, y},
        {scalar(0.4), {scalar(0.03), scalar(0.03), scalar(0.02)}, {scalar(0.93), 0, scalar(0.25)}, {scalar(0.9), 0, scalar(0.25)}, x}};
    return set_up_links<ArmOfSix>(world, links);
}

}  // namespace scenes
