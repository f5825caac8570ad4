// SPDX-License-Identifier: MIT
// A biped of thirteen bodies that walks in space: hips, ankles, waist, neck and shoulders are ball joints, and nothing holds it up but its servos.
//
// The law is that of walker.h, forwards and sideways: the swing leg goes where the centre of mass is about to be, and as much further outwards.
#pragma once

#include "walker.h"

namespace scenes {

/// x is forwards, y to the left, z up.
struct WalkingInSpace : ingot::Scene {
    static constexpr int max_bodies = 14, max_joints = 16, max_loops = 4, max_manifolds = 8, max_pairs = 16;
    static constexpr bool translates = true;
    static constexpr ingot::Effort effort = {4, 12};
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::BallServoJoint, ingot::WithDrives>;
};

/// Ids of it. [2]: left and right.
struct SpatialWalker {
    ingot::BodyId pelvis{}, chest{}, head{}, arm[2]{}, forearm[2]{}, thigh[2]{}, shank[2]{}, foot[2]{};
    ingot::JointId waist{}, neck{}, shoulder[2]{}, elbow[2]{}, hip[2]{}, knee[2]{}, ankle[2]{};
    ingot::JointId upright[2]{};  ///< servo of the pelvis, with its torque on this thigh
    ingot::JointId swing[2]{};    ///< servo of this thigh, with its torque on the other
};

/// Its bones beside those of a leg.
namespace spatial_parts {
using ingot::scalar;
inline constexpr WalkerPart pelvis = {14, {scalar(0.1), scalar(0.15), scalar(0.08)}, 0, scalar(0.97), 0};
inline constexpr WalkerPart chest = {26, {scalar(0.11), scalar(0.17), scalar(0.2)}, 0, scalar(1.27), scalar(1.05)};
inline constexpr WalkerPart head = {scalar(4.5), {scalar(0.09), scalar(0.08), scalar(0.12)}, 0, scalar(1.62), scalar(1.5)};
inline constexpr WalkerPart arm = {scalar(2.1), {scalar(0.04), scalar(0.04), scalar(0.15)}, 0, scalar(1.27), scalar(1.42)};
inline constexpr WalkerPart forearm = {scalar(1.6), {scalar(0.035), scalar(0.035), scalar(0.15)}, 0, scalar(0.97), scalar(1.12)};
}  // namespace spatial_parts

/// Stands at the origin, and moves forwards with v, m/s. Errors: those of World::add and add_joint.
template <class S>
ingot::Status add_walker(ingot::World<S>& world, ingot::scalar v, SpatialWalker& walker) {
    using ingot::scalar;
    using walker_parts::join;
    namespace parts = spatial_parts;
    ingot::Status status = ingot::Status::ok;
    const auto add = [&](const WalkerPart& part, scalar y) { return walker_parts::add_part(world, part, 0, y, v, status, false); };
    walker.pelvis = add(parts::pelvis, 0);
    walker.chest = add(parts::chest, 0);
    walker.head = add(parts::head, 0);
    walker.waist = join(world, ingot::BallJoint{}, walker.pelvis, walker.chest, {0, 0, parts::chest.joint_z}, status);
    walker.neck = join(world, ingot::BallJoint{}, walker.chest, walker.head, {0, 0, parts::head.joint_z}, status);
    for (int side_i = 0; side_i < 2; ++side_i) {
        const scalar y = side_i == 0 ? walker_parts::apart : -walker_parts::apart, y_arm = y * scalar(2.2);
        const auto leg = [&](const WalkerPart& part, bool touches) { return walker_parts::add_part(world, part, 0, y, v, status, touches); };
        walker.arm[side_i] = add(parts::arm, y_arm);
        walker.forearm[side_i] = add(parts::forearm, y_arm);
        walker.thigh[side_i] = leg(walker_parts::thigh, false);
        walker.shank[side_i] = leg(walker_parts::shank, false);
        walker.foot[side_i] = leg(walker_parts::foot, true);
        walker.shoulder[side_i] = join(world, ingot::BallJoint{}, walker.chest, walker.arm[side_i], {0, y_arm, parts::arm.joint_z}, status);
        const ingot::Vector elbow = {0, y_arm, parts::forearm.joint_z};
        walker.elbow[side_i] = join(world, ingot::HingeJoint{}, walker.arm[side_i], walker.forearm[side_i], elbow, status);
        walker.hip[side_i] = join(world, ingot::BallJoint{}, walker.pelvis, walker.thigh[side_i], {0, y, walker_parts::thigh.joint_z}, status);
        const ingot::Vector knee = {0, y, walker_parts::shank.joint_z};
        walker.knee[side_i] = join(world, ingot::HingeJoint{}, walker.thigh[side_i], walker.shank[side_i], knee, status);
        const ingot::Vector ankle = {0, y, walker_parts::foot.joint_z};
        walker.ankle[side_i] = join(world, ingot::BallJoint{}, walker.shank[side_i], walker.foot[side_i], ankle, status);
    }
    for (int side_i = 0; side_i < 2; ++side_i) {
        const ingot::Vector middle = {0, 0, walker_parts::thigh.joint_z};
        walker.upright[side_i] = join(world, ingot::BallServoJoint{}, walker.thigh[side_i], walker.pelvis, middle, status);
        walker.swing[side_i] = join(world, ingot::BallServoJoint{}, walker.thigh[1 - side_i], walker.thigh[side_i], middle, status);
    }
    return status;
}

/// How it walks: as Gait, with what is of space. rad, N m/rad; dampings are a tenth of stiffnesses.
struct SpatialGait {
    ingot::scalar leg = 300, pelvis = 1000, waist = 1000, neck = 60, shoulder = 40, elbow = 20;
    ingot::scalar max_torque = ingot::unlimited;  ///< N m, of each
    ingot::scalar lift_time = ingot::scalar(0.3), least_time = ingot::scalar(0.02);                                   ///< s
    ingot::scalar lift_hip = ingot::scalar(0.4), reach_hip = ingot::scalar(-0.1), outwards = ingot::scalar(0.05);     ///< rad, of the swing leg
    ingot::scalar per_distance = ingot::scalar(0.5), per_speed = ingot::scalar(0.22);                                 ///< both forwards and sideways
    ingot::scalar lift_knee = ingot::scalar(-1.1), reach_knee = ingot::scalar(-0.05);                                 ///< of the swing leg
    ingot::scalar stance_knee_lift = ingot::scalar(-0.05), stance_knee_reach = ingot::scalar(-0.1), toes = ingot::scalar(0.1);
};

/// Drives it for the next step, of h seconds. Errors: those of World::set_joint_drive.
template <class S>
ingot::Status walk(ingot::World<S>& world, const SpatialWalker& walker, const SpatialGait& gait, WalkState& state, ingot::scalar h) {
    using ingot::scalar;
    int swing = 1 - state.stance;
    if (!state.reaches && state.time >= gait.lift_time) {
        state.reaches = true;
        state.time = 0;
    } else if (state.reaches && state.time >= gait.least_time && load_of(world, walker.foot[swing]) > 0) {
        state = {swing, false, 0, state.steps + 1};
        swing = 1 - state.stance;
    }
    state.time += h;

    const ingot::FigureInfo whole = world.figure(walker.pelvis).value;
    const ingot::Vector to_centre = whole.r_CM - ankle_of(world, walker, state.stance);
    const auto within = [](scalar least, scalar most, scalar x) { return ingot::max(least, ingot::min(most, x)); };
    const auto ahead = [&](scalar d, scalar v) { return gait.per_distance * d + gait.per_speed * v; };
    const scalar forwards = (state.reaches ? gait.reach_hip : gait.lift_hip) + ahead(to_centre.x, whole.v_CM.x);
    const scalar sideways = (swing == 0 ? gait.outwards : -gait.outwards) + ahead(to_centre.y, whole.v_CM.y);

    ingot::Status status = ingot::Status::ok;
    const auto note = [&](ingot::Status answer) { status = status == ingot::Status::ok ? answer : status; };
    const auto spring = [&](scalar stiffness, scalar target = 0) {
        return ingot::SpringDrive{stiffness, stiffness / 10, target, 0, 0, gait.max_torque};
    };
    note(world.set_ball_drive(walker.upright[state.stance], spring(gait.pelvis)));
    note(world.set_ball_drive(walker.upright[swing], {}));
    // A leg that hangs down goes forwards about -y, and to the left about x.
    const ingot::Vector hip = {within(scalar(-0.5), scalar(0.5), sideways), -within(scalar(-0.9), scalar(1.3), forwards), 0};
    note(world.set_ball_drive(walker.swing[swing], spring(gait.leg), hip));
    note(world.set_ball_drive(walker.swing[state.stance], {}));
    note(world.set_joint_drive(walker.knee[swing], spring(gait.leg, state.reaches ? gait.reach_knee : gait.lift_knee)));
    note(world.set_joint_drive(walker.knee[state.stance], spring(gait.leg, state.reaches ? gait.stance_knee_reach : gait.stance_knee_lift)));
    for (int side_i = 0; side_i < 2; ++side_i) {
        note(world.set_ball_drive(walker.ankle[side_i], spring(gait.leg), {0, -gait.toes, 0}));
        note(world.set_ball_drive(walker.shoulder[side_i], spring(gait.shoulder)));
        note(world.set_joint_drive(walker.elbow[side_i], spring(gait.elbow)));
    }
    note(world.set_ball_drive(walker.waist, spring(gait.waist)));
    note(world.set_ball_drive(walker.neck, spring(gait.neck)));
    return status;
}

}  // namespace scenes
