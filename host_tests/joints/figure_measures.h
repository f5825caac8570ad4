// SPDX-License-Identifier: MIT
// What is measured on a figure in any state, whoever computed it: energy, momentum, gaps, angles beyond their limits.
#pragma once

#include "joints/joint_rows.h"

namespace ingot_figures {

/// J, of all bodies that move.
double kinetic_energy(const FigureScene& scene, const FigureState& state);

/// J: weight, and springs of servos and suspensions without a torque limit.
double potential_energy(const JointRows& rows, const FigureState& state);
double energy(const JointRows& rows, const FigureState& state);

double mass(const FigureScene& scene);
Vector3d centre_of_mass(const FigureScene& scene, const FigureState& state);

/// kg m/s.
Vector3d momentum(const FigureScene& scene, const FigureState& state);
/// kg m^2/s, about the origin.
Vector3d angular_momentum(const FigureScene& scene, const FigureState& state);

/// m: how far the anchors of a joint are from where it lets them be; across the axis for sliders and wheels, beyond least and most for a distance.
double gap(const JointRows& rows, const FigureState& state, int joint_i);
double worst_gap(const JointRows& rows, const FigureState& state);

/// rad: by how much a joint's locked axes miss each other.
double misalignment(const JointRows& rows, const FigureState& state, int joint_i);
double worst_misalignment(const JointRows& rows, const FigureState& state);

/// rad or m: by how much the worst limit is exceeded; negative: room to the nearest.
double worst_excess(const JointRows& rows, const FigureState& state);

/// rad or m, and their rates: what a joint's free direction reads.
double measured(const JointRows& rows, const FigureState& state, int joint_i, FigureMeasure which);
double measured_rate(const JointRows& rows, const FigureState& state, int joint_i, FigureMeasure which);

/// Share of the kinetic energy that sits in velocities which the locked rows do not allow: what their projection would take away.
double inadmissible_share(const JointRows& rows, const FigureState& state);

/// Torque (N m) or force (N) that a drive puts on a free direction; the cut at max_torque is in it.
double drive_torque(const FigureDrive& drive, double x, double rate);

/// Force and torque, about its centre of mass, on each body: weight, servos, suspensions; not motors.
struct AppliedLoads {
    std::vector<Vector3d> force, torque;
    void add(const FigureRow& row, double lambda);
};
AppliedLoads applied_loads(const JointRows& rows, const FigureState& state);

}  // namespace ingot_figures
