// SPDX-License-Identifier: MIT
// The exact constrained velocities of one substep, by dense algebra: what a solver of joints, limits, drives and contacts has to come to.
//
// Bodies have velocities u_0 before, and impulses from outside; the pose stands still. Rows ask, with J of the velocities after,
//
//     w = J u + compliance lambda - target,      lower <= lambda <= upper,
//     w = 0 between the bounds,  w >= 0 where lambda = lower,  w <= 0 where lambda = upper
//
// A locked row has no bounds; a drive none and a compliance; a limit or a contact has lower = 0; a motor -+ h max_torque. Velocities are unique:
// without compliance they are, of all that obey, the nearest to u_0 in the metric of the kinetic energy (Gauss). Multipliers need not be unique.
#pragma once

#include "joints/bounded_problem.h"
#include "joints/joint_rows.h"

namespace ingot_figures {

/// A body at the begin of a substep.
struct StepBody {
    double inv_M = 0;                         ///< kg^-1; 0: nothing moves it
    Matrix3d inv_I_world = Matrix3d::Zero();  ///< kg^-1 m^-2
    Vector3d r_CM = Vector3d::Zero();
    Vector3d v_CM = Vector3d::Zero();
    Vector3d omega = Vector3d::Zero();
    Vector3d impulse = Vector3d::Zero();          ///< N s: h times forces, warm-started impulses
    Vector3d angular_impulse = Vector3d::Zero();  ///< N m s, about the centre of mass
};

struct StepRow {
    FigureRow row;  ///< only its Jacobian is looked at
    double target = 0;
    double compliance = 0;  ///< 1 / (h damping + h^2 stiffness) of a drive
    double lower = -infinity, upper = infinity;

    bool is_equation() const { return lower == -infinity && upper == infinity; }
};

/// direction.(velocity of B at P_B - velocity of A at P_A); the points are in the world. body_A may be the_world.
FigureRow point_row(const std::vector<StepBody>& bodies, int body_A, const Vector3d& P_A, int body_B, const Vector3d& P_B, const Vector3d& direction);
/// direction.(omega_B - omega_A).
FigureRow turn_row(int body_A, int body_B, const Vector3d& direction);

struct StepSolution {
    std::vector<Vector3d> v_CM, omega;
    std::vector<double> impulse;   ///< lambda of each row
    std::vector<bool> determined;  ///< false: rows that carry share their load in more ways than one, and this is one of them
    double unmet = 0;              ///< largest miss of an equation: equations that contradict each other
    double miss = 0;               ///< largest miss of the laws of bounded rows
};

enum class BoundedBy { fewer_than_13_by_enumeration, enumeration, pivoting };

StepSolution solve_step(const std::vector<StepBody>& bodies, const std::vector<StepRow>& rows,
                        BoundedBy method = BoundedBy::fewer_than_13_by_enumeration);

/// The bodies of a scene, without impulses.
std::vector<StepBody> step_bodies(const FigureScene& scene, const FigureState& state);

/// A scene's state with the velocities of a solution.
FigureState with_velocities(const FigureState& state, const StepSolution& solution);

/// What the locked directions of a joint should do in a substep: of B against A, world axes, velocity of the anchors and angular velocity.
struct JointTarget {
    Vector3d g_rate = Vector3d::Zero(), W = Vector3d::Zero();
};

/// Brings what is apart together in h and no more: -g / h, and the same for axes.
JointTarget plain_target(const JointRows& rows, const FigureState& state, int joint_i, double h);

/// The same, less what arms and axes do on their chords, so that they are together after turning by R_A and R_B (rotations of the bodies over h).
JointTarget second_order_target(const JointRows& rows, const FigureState& state, int joint_i, double h, const Matrix3d& R_A, const Matrix3d& R_B);

/// The rotation that a body does in h by its spin and its gyroscopic change: |phi| about phi = h omega + h^2/2 I^-1 (L x omega).
Matrix3d rotation_ahead(const FigureScene& scene, const FigureState& state, int body_i, double h);

/// Rows of the locked directions as articulated trees see them: both velocities at the anchor of B, world axes. `point_of_A_itself`: that of A at its
/// own anchor.
std::vector<StepRow> locked_rows(const JointRows& rows, const FigureState& state, int joint_i, const JointTarget& target,
                                 bool point_of_A_itself = false);

}  // namespace ingot_figures
