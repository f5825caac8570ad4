// SPDX-License-Identifier: MIT
// A biped of seven bodies that walks in a plane, and the law by which it does: no force from outside, no reference motion.
//
// Source: Yin, Loken, van de Panne, "SIMBICON: Simple Biped Locomotion Control", SIGGRAPH 2007: two poses that follow each other, one in time, one
// at a foot strike; the trunk and the swing thigh are held in the world, with their torques on the stance thigh; and the swing thigh goes where the
// centre of mass is about to be.
#pragma once

#include <ingot/ingot.h>

namespace scenes {

/// x is forwards, z up; legs swing about y.
struct WalkingInPlane : ingot::Scene {
    static constexpr int max_bodies = 8, max_joints = 11, max_loops = 5, max_manifolds = 8, max_pairs = 16;
    static constexpr bool translates = true;
    static constexpr ingot::Effort effort = {4, 16};  // few contacts, and servos that are to be right with them
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
    using joints = ingot::Joints<ingot::HingeJoint, ingot::ParallelJoint, ingot::ServoJoint, ingot::WithDrives>;
};

/// Ids of a walker. [2]: legs; which of them stands changes with each step.
struct Walker {
    ingot::BodyId trunk{}, thigh[2]{}, shank[2]{}, foot[2]{};
    ingot::JointId hip[2]{}, knee[2]{}, ankle[2]{};
    ingot::JointId upright[2]{};  ///< servo of the trunk, with its torque on this thigh
    ingot::JointId swing[2]{};    ///< servo of this thigh, with its torque on the other
};

/// A bone of a walker: a box, and where its joint to the one before is, m, above the ground and ahead of the hip.
struct WalkerPart {
    ingot::scalar M;                  ///< kg
    ingot::Vector half_extents;       ///< m
    ingot::scalar x, z, joint_z;      ///< m
};
namespace walker_parts {
using ingot::scalar;
inline constexpr WalkerPart trunk = {50, {scalar(0.1), scalar(0.15), scalar(0.35)}, 0, scalar(1.26), 0};
inline constexpr WalkerPart thigh = {scalar(7.5), {scalar(0.06), scalar(0.06), scalar(0.215)}, 0, scalar(0.695), scalar(0.91)};
inline constexpr WalkerPart shank = {scalar(3.5), {scalar(0.05), scalar(0.05), scalar(0.21)}, 0, scalar(0.27), scalar(0.48)};
inline constexpr WalkerPart foot = {scalar(1.1), {scalar(0.115), scalar(0.04), scalar(0.03)}, scalar(0.055), scalar(0.03), scalar(0.06)};
inline constexpr scalar apart = scalar(0.1);  ///< m, of each leg from the middle
}  // namespace walker_parts

/// How it walks: angles of rad, forwards; a knee bends below 0; toes are up above 0.
struct Gait {
    ingot::scalar stiffness = 300, damping = 30;         ///< N m/rad, N m s/rad; of every drive
    ingot::scalar max_torque = ingot::unlimited;         ///< N m; of an ankle 0.7 of it
    ingot::scalar lift_time = ingot::scalar(0.3);        ///< s, of the first pose; the second one goes on to the foot strike
    ingot::scalar least_time = ingot::scalar(0.02);      ///< s, of the second pose
    ingot::scalar catch_time = ingot::scalar(0.1);       ///< s, in the first pose: from then on a foot that carries alone has struck, as after a push
    /// Of the rate at which the swing hip's target goes with the distance, how much its drive is told. The law as published says nothing of it. 1
    /// keeps it up to date between two steps: pushed on by 70 N s it walks on at 60 steps a second, too; without, at 120.
    ingot::scalar lead = 0;
    struct Pose {
        ingot::scalar swing_hip, per_distance, per_speed, swing_knee, swing_ankle, stance_knee, stance_ankle, trunk;
    };
    Pose lift = {ingot::scalar(0.4), 0, ingot::scalar(0.2), ingot::scalar(-1.1), ingot::scalar(0.2), ingot::scalar(-0.05), ingot::scalar(0.2), 0};
    Pose reach = {ingot::scalar(-0.7), ingot::scalar(2.2), 0, ingot::scalar(-0.05), ingot::scalar(0.2), ingot::scalar(-0.1), ingot::scalar(0.2), 0};
    ingot::scalar hip_least = ingot::scalar(-0.9), hip_most = ingot::scalar(1.3);
};

/// What the law remembers between two steps of the world.
struct WalkState {
    int stance = 0;            ///< the leg that stands
    bool reaches = false;      ///< in the second pose
    ingot::scalar time = 0;    ///< s, in the pose
    int steps = 0;             ///< foot strikes
};

namespace walker_parts {
template <class S>
ingot::BodyId add_part(ingot::World<S>& world, const WalkerPart& part, ingot::scalar x, ingot::scalar y, ingot::scalar v, ingot::Status& status,
                       bool touches = true) {
    ingot::BodyDef body;
    const ingot::MassDistribution solid = ingot::with_mass(ingot::solid_box(1, part.half_extents), part.M);
    body.mass = {solid.M, {solid.I.xx, solid.I.yy, solid.I.zz}, {}, ingot::identity_matrix<scalar>()};
    if (touches) body.shape = ingot::Box{part.half_extents};
    body.state.r_CM = {x + part.x, y, part.z};
    body.state.v_CM = {v, 0, 0};
    body.friction = scalar(0.8);
    const ingot::Result<ingot::BodyId> added = world.add(body);
    if (status == ingot::Status::ok) status = added.status;
    return added.value;
}
template <class S, class Kind>
ingot::JointId join(ingot::World<S>& world, Kind kind, ingot::BodyId A, ingot::BodyId B, const ingot::Vector& P, ingot::Status& status) {
    ingot::JointDef def;
    def.body_A = A;
    def.body_B = B;
    def.joint = kind;
    def.P = P;
    def.axis = {0, -1, 0};
    const ingot::Result<ingot::JointId> added = world.add_joint(def);
    if (status == ingot::Status::ok) status = added.status;
    return added.value;
}
}  // namespace walker_parts

/// Stands at place, on the ground, and moves forwards with v, m/s. Errors: those of World::add and add_joint.
template <class S>
ingot::Status add_walker(ingot::World<S>& world, const ingot::Vector& place, ingot::scalar v, Walker& walker) {
    using namespace walker_parts;
    ingot::Status status = ingot::Status::ok;
    const auto at = [&](scalar y, scalar z) { return ingot::Vector{place.x, y, z}; };
    walker.trunk = add_part(world, trunk, place.x, place.y, v, status);
    (void)join(world, ingot::ParallelJoint{}, {}, walker.trunk, at(place.y, trunk.z), status);
    for (int leg_i = 0; leg_i < 2; ++leg_i) {
        const scalar y = leg_i == 0 ? place.y + apart : place.y - apart;
        walker.thigh[leg_i] = add_part(world, thigh, place.x, y, v, status);
        walker.shank[leg_i] = add_part(world, shank, place.x, y, v, status);
        walker.foot[leg_i] = add_part(world, foot, place.x, y, v, status);
        walker.hip[leg_i] = join(world, ingot::HingeJoint{}, walker.trunk, walker.thigh[leg_i], at(y, thigh.joint_z), status);
        walker.knee[leg_i] = join(world, ingot::HingeJoint{}, walker.thigh[leg_i], walker.shank[leg_i], at(y, shank.joint_z), status);
        walker.ankle[leg_i] = join(world, ingot::HingeJoint{}, walker.shank[leg_i], walker.foot[leg_i], at(y, foot.joint_z), status);
    }
    for (int leg_i = 0; leg_i < 2; ++leg_i) {
        walker.upright[leg_i] = join(world, ingot::ServoJoint{}, walker.thigh[leg_i], walker.trunk, at(place.y, thigh.joint_z), status);
        walker.swing[leg_i] = join(world, ingot::ServoJoint{}, walker.thigh[1 - leg_i], walker.thigh[leg_i], at(place.y, thigh.joint_z), status);
    }
    return status;
}
/// The ground it walks on.
template <class S>
ingot::Status add_ground(ingot::World<S>& world) {
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}};
    ground.friction = ingot::scalar(0.8);
    const ingot::Status status = world.set_gravity({0, 0, ingot::scalar(-9.81)});
    return status == ingot::Status::ok ? world.add(ground).status : status;
}

/// N s, that the ground, or whatever it stands on, gave to a foot in the last step.
template <class S>
ingot::scalar load_of(const ingot::World<S>& world, ingot::BodyId foot) {
    ingot::scalar sum = 0;
    for (const ingot::ContactInfo& contact : world.contacts_of(foot)) sum += contact.j;
    return sum;
}

/// m, world. Of a Walker, or another with such feet.
template <class S, class AWalker>
ingot::Vector ankle_of(const ingot::World<S>& world, const AWalker& walker, int leg_i) {
    const ingot::BodyState foot = world.state(walker.foot[leg_i]).value;
    return foot.r_CM + foot.A * ingot::Vector{-walker_parts::foot.x, 0, walker_parts::foot.joint_z - walker_parts::foot.z};
}

/// Drives a walker for the next step, of h seconds. Between any two steps. Errors: those of World::set_joint_drive.
template <class S>
ingot::Status walk(ingot::World<S>& world, const Walker& walker, const Gait& gait, WalkState& state, ingot::scalar h) {
    using ingot::scalar;
    int swing = 1 - state.stance;
    const bool carries = load_of(world, walker.foot[swing]) > 0, is_alone = !(load_of(world, walker.foot[state.stance]) > 0);
    if (!state.reaches && state.time >= gait.lift_time) {
        state.reaches = true;
        state.time = 0;
    } else if (carries && (state.reaches ? state.time >= gait.least_time : is_alone && state.time >= gait.catch_time)) {
        state = {swing, false, 0, state.steps + 1};
        swing = 1 - state.stance;
    }
    state.time += h;

    const ingot::FigureInfo whole = world.figure(walker.trunk).value;
    const ingot::Vector ankle = ankle_of(world, walker, state.stance);
    const Gait::Pose& pose = state.reaches ? gait.reach : gait.lift;
    const scalar wanted = pose.swing_hip + pose.per_distance * (whole.r_CM.x - ankle.x) + pose.per_speed * whole.v_CM.x;
    const scalar hip = ingot::max(gait.hip_least, ingot::min(gait.hip_most, wanted));

    ingot::Status status = ingot::Status::ok;
    const auto drive = [&](ingot::JointId joint, scalar target, scalar share, scalar rate = 0) {
        const scalar most = gait.max_torque < ingot::unlimited ? gait.max_torque * share : ingot::unlimited;
        const ingot::Status set = world.set_joint_drive(joint, ingot::SpringDrive{gait.stiffness, gait.damping, target, rate, 0, most});
        if (status == ingot::Status::ok) status = set;
    };
    const auto release = [&](ingot::JointId joint) {
        const ingot::Status set = world.set_joint_drive(joint, {});
        if (status == ingot::Status::ok) status = set;
    };
    drive(walker.upright[state.stance], pose.trunk, 1);
    drive(walker.swing[swing], hip, 1, hip == wanted ? gait.lead * pose.per_distance * whole.v_CM.x : scalar(0));
    release(walker.upright[swing]);
    release(walker.swing[state.stance]);
    drive(walker.knee[swing], pose.swing_knee, 1);
    drive(walker.ankle[swing], pose.swing_ankle, scalar(0.7));
    drive(walker.knee[state.stance], pose.stance_knee, 1);
    drive(walker.ankle[state.stance], pose.stance_ankle, scalar(0.7));
    return status;
}

/// How it stands: servos hold it straight, and the ankles carry it, as those of an inverted pendulum whose foot ends.
struct Stand {
    ingot::scalar stiffness = 1000, damping = 100;                                       ///< N m/rad, N m s/rad; of trunk, hips and knees
    ingot::scalar per_metre = 800, per_speed = 250, middle = ingot::scalar(0.05);        ///< N, N s, m ahead of the ankles
    ingot::scalar heel = ingot::scalar(-0.055), toes = ingot::scalar(0.165);             ///< m: as far as the load goes under the feet
};

/// Drives a walker that stands on both feet for the next step. Errors: those of World::set_joint_drive.
template <class S>
ingot::Status stand(ingot::World<S>& world, const Walker& walker, const Stand& law, ingot::scalar weight) {
    using ingot::scalar;
    const ingot::FigureInfo whole = world.figure(walker.trunk).value;
    const scalar x = whole.r_CM.x - (ankle_of(world, walker, 0).x + ankle_of(world, walker, 1).x) / 2;
    const scalar wanted = weight * x + law.per_metre * (x - law.middle) + law.per_speed * whole.v_CM.x;
    const scalar torque = ingot::max(law.heel * weight, ingot::min(law.toes * weight, wanted));
    ingot::Status status = ingot::Status::ok;
    const auto set = [&](ingot::JointId joint, const ingot::JointDrive& drive) {
        const ingot::Status answer = world.set_joint_drive(joint, drive);
        if (status == ingot::Status::ok) status = answer;
    };
    for (int leg_i = 0; leg_i < 2; ++leg_i) {
        set(walker.hip[leg_i], ingot::SpringDrive{law.stiffness, law.damping});
        set(walker.knee[leg_i], ingot::SpringDrive{law.stiffness, law.damping});
        set(walker.ankle[leg_i], ingot::SpringDrive{0, 0, 0, 0, -torque / 2});
        set(walker.upright[leg_i], {});
        set(walker.swing[leg_i], {});
    }
    return status;
}

/// m, how high the trunk's middle is: below 0.9 it has fallen.
template <class S>
ingot::scalar height_of(const ingot::World<S>& world, const Walker& walker) {
    return world.state(walker.trunk).value.r_CM.z;
}

}  // namespace scenes
