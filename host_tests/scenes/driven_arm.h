// SPDX-License-Identifier: MIT
// An arm of six hinges that is driven, and two ways to have it follow a path: by torques that are computed, and by stiff servos.
#pragma once

#include <ingot/ingot.h>

#include "jointed.h"

namespace scenes {

/// The arm of ArmOfSix, with its motors.
struct DrivenArm : ingot::Scene {
    static constexpr int max_bodies = 6, max_joints = 6;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::HingeJoint, ingot::WithDrives>;
};

/// Its joints, from the base on.
struct ArmIds {
    ingot::BodyId link[6]{};
    ingot::JointId hinge[6]{};
};

/// Stretched out, all angles 0.
inline ingot::Status set_up(ingot::World<DrivenArm>& world, ArmIds& ids) {
    using ingot::scalar;
    constexpr ingot::Vector x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
    constexpr Link links[] = {
        {3, {scalar(0.08), scalar(0.08), scalar(0.1)}, {0, 0, scalar(0.1)}, {}, z},
        {scalar(2.5), {scalar(0.2), scalar(0.05), scalar(0.05)}, {scalar(0.2), 0, scalar(0.25)}, {0, 0, scalar(0.25)}, y},
        {scalar(1.5), {scalar(0.1), scalar(0.04), scalar(0.04)}, {scalar(0.5), 0, scalar(0.25)}, {scalar(0.4), 0, scalar(0.25)}, y},
        {1, {scalar(0.1), scalar(0.035), scalar(0.035)}, {scalar(0.7), 0, scalar(0.25)}, {scalar(0.6), 0, scalar(0.25)}, x},
        {scalar(0.6), {scalar(0.05), scalar(0.03), scalar(0.03)}, {scalar(0.85), 0, scalar(0.25)}, {scalar(0.8), 0, scalar(0.25)}, y},
        {scalar(0.4), {scalar(0.03), scalar(0.03), scalar(0.02)}, {scalar(0.93), 0, scalar(0.25)}, {scalar(0.9), 0, scalar(0.25)}, x}};
    ingot::Status status = world.set_gravity({0, 0, scalar(-9.81)});
    for (int i = 0; i < 6 && status == ingot::Status::ok; ++i) {
        const ingot::MassDistribution solid = ingot::with_mass(ingot::solid_box(1, links[i].half_extents), links[i].M);
        ingot::BodyDef body;
        body.mass = {solid.M, {solid.I.xx, solid.I.yy, solid.I.zz}, {}, ingot::identity_matrix<scalar>()};
        body.state.r_CM = links[i].r_CM;
        const ingot::Result<ingot::BodyId> link = world.add(body);
        if (!link.ok()) return link.status;
        ids.link[i] = link.value;
        ingot::JointDef hinge;
        if (i > 0) hinge.body_A = ids.link[i - 1];
        hinge.body_B = link.value;
        hinge.joint = ingot::HingeJoint{};
        hinge.P = links[i].P;
        hinge.axis = links[i].axis;
        const ingot::Result<ingot::JointId> joint = world.add_joint(hinge);
        status = joint.status;
        ids.hinge[i] = joint.value;
    }
    return status;
}

/// Where a joint should be.
struct PathPoint {
    ingot::scalar angle, rate, acceleration;  ///< rad, rad/s, rad/s^2
};

/// Computed torque: by inverse dynamics each joint is made a unit mass on a spring and a damper.
///
/// The step is cut into substeps, and each pushes first and moves then: rates that it leaves are those of half a substep ago, and what is held acts
/// from then on, so its middle is half of the step less half a substep ahead. Both are made up for by how they changed since the last step; without
/// that the arm is off by ten times as much at 60 Hz, and to first order.
/// Source: Craig, "Introduction to Robotics", chapter 10.
class ComputedTorque {
public:
    /// Sets the drives for the next step. path: as it is now; frequency: rad/s, of the springs.
    ingot::Status follow(ingot::World<DrivenArm>& world, const ArmIds& ids, const PathPoint (&path)[6], ingot::scalar frequency) {
        using ingot::scalar;
        constexpr scalar half_substep = scalar(0.5) / DrivenArm::effort.substeps, middle = scalar(0.5) - half_substep;  // of a step
        scalar accelerations[6] = {}, torques[6] = {}, rates[6] = {};
        ingot::Status status = world.read_dynamics(ids.link[0], figure_);
        if (status == ingot::Status::ok) status = figure_.direction_rates(rates, 6);
        for (int i = 0; i < 6 && status == ingot::Status::ok; ++i) {
            const int number = figure_.directions_of(ids.hinge[i]).value.first;
            const scalar rate = begun_ ? rates[number] + (rates[number] - last_rates_[number]) * half_substep : rates[number];
            const scalar slow = path[i].rate - rate, short_by = path[i].angle - world.joint_angle(ids.hinge[i]).value;
            accelerations[number] = path[i].acceleration + frequency * (2 * slow + frequency * short_by);
        }
        if (status == ingot::Status::ok) status = figure_.inverse_dynamics(accelerations, torques, 6);
        for (int i = 0; i < 6 && status == ingot::Status::ok; ++i) {
            const int number = figure_.directions_of(ids.hinge[i]).value.first;
            ingot::SpringDrive drive;  // without stiffness: it gives what was computed
            drive.feedforward = begun_ ? torques[number] + (torques[number] - last_torques_[number]) * middle : torques[number];
            last_torques_[number] = torques[number];
            last_rates_[number] = rates[number];
            status = world.set_joint_drive(ids.hinge[i], drive);
        }
        begun_ = true;
        return status;
    }

private:
    ingot::FigureDynamics<6> figure_;
    ingot::scalar last_torques_[6] = {}, last_rates_[6] = {};
    bool begun_ = false;
};

/// Servos as stiff as can be: the kernel solves them with the arm, so no step is too long. path: now; ahead: at the end of the step.
inline ingot::Status follow_by_servos(ingot::World<DrivenArm>& world, const ArmIds& ids, const PathPoint (&path)[6], const PathPoint (&ahead)[6],
                                      ingot::scalar h) {
    ingot::Status status = ingot::Status::ok;
    for (int i = 0; i < 6 && status == ingot::Status::ok; ++i) {
        ingot::SpringDrive servo;
        servo.stiffness = ingot::scalar(1e6);
        servo.target = path[i].angle;
        servo.target_rate = (ahead[i].angle - path[i].angle) / h;
        status = world.set_joint_drive(ids.hinge[i], servo);
    }
    return status;
}

}  // namespace scenes
