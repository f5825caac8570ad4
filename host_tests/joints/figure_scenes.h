// SPDX-License-Identifier: MIT
// Scenes of joints: plain descriptions (figure.h), for any test and engine. Every scene starts exactly on its joints, in position and velocity.
//
// Masses, sizes and speeds without a word are chosen here, so that things are as people know them; those that are compared with published figures
// say so. Parents stand before their children. Bodies of mass 0 are the ground and what else stands still.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "joints/figure.h"

namespace ingot_figures {

// Bodies of even density -----------------------------------------------------------------------------------------------------------------------

Vector3d box_moments(double M, const Vector3d& half_extent);
Vector3d sphere_moments(double M, double radius);
/// About its own axis, body z, last. `half_length`: of the straight part.
Vector3d capsule_moments(double M, double radius, double half_length);
FigureBody box(double M, const Vector3d& half_extent, const Vector3d& r_CM, const Matrix3d& A = Matrix3d::Identity());
FigureBody sphere(double M, double radius, const Vector3d& r_CM);
FigureBody capsule(double M, double radius, double half_length, const Vector3d& r_CM, const Matrix3d& A = Matrix3d::Identity());
/// A slab whose top is z = 0.
FigureBody ground(double friction = 0.6);

FigureJoint ball(int body_A, int body_B, const Vector3d& anchor);
FigureJoint hinge(int body_A, int body_B, const Vector3d& anchor, const Vector3d& axis);
FigureJoint joint_of(FigureJointKind kind, int body_A, int body_B, const Vector3d& anchor, const Vector3d& axis_A, const Vector3d& axis_B);

/// The body to world rotation that takes body z along `direction`.
Matrix3d along(const Vector3d& direction);

/// Puts all of `part` into `scene`, turned by R about the origin and moved by r. Returns the index that its first body has there.
int insert(FigureScene& scene, const FigureScene& part, const Vector3d& r, const Matrix3d& R = Matrix3d::Identity());

/// Gives a joint's driven direction this rate, and the bodies the velocities nearest to those they have with which all joints hold.
void set_rate(FigureScene& scene, int joint_i, double rate);

/// Takes off the velocities that joints do not allow, by the least change of kinetic energy.
void hold_joints(FigureScene& scene);

/// Adds a motion as of one rigid body: v and omega about the common centre of mass.
void add_motion(FigureScene& scene, const Vector3d& v, const Vector3d& omega);

// Pendulums of the tables (pendulum_tables.h reads them) -----------------------------------------------------------------------------------------

/// theta'' = -k sin theta about world y, at rest at theta_0. 1 kg, centre 1/2 m from the hinge, moment 1/4 kg m^2, g = k.
FigureScene planar_pendulum(double k, double theta_0);

/// Moves as a point on a rod of length l, from r with v: 1 kg with moments 3/16 l^2 on a ball joint 3/4 l away swings alike, and does not spin.
FigureScene spherical_pendulum(double g, double l, const Vector3d& r, const Vector3d& v);

struct DoublePendulum {
    double m1 = 1, m2 = 1, l1 = 1, c1 = 0.5, c2 = 0.5;
    Vector3d I1 = Vector3d::Ones(), I2 = Vector3d::Ones();  ///< about the centres of mass
    double g = 9.8125, q1 = 0, q2 = 0, q1_rate = 0, q2_rate = 0;
};
/// Both hinges along world y, both angles from straight down.
FigureScene double_parallel_pendulum(const DoublePendulum& parameters);
/// The second hinge along body x: R1 = Ry(q1), R2 = R1 Rx(q2).
FigureScene double_perpendicular_pendulum(const DoublePendulum& parameters);

/// The angle of a body that is turned about y alone.
inline double turned_about_y(const Matrix3d& A) { return std::atan2(A(0, 2), A(2, 2)); }

/// A hinge along y with a stop at `stop`, at rest at theta_0 (angles from straight down; the joint's own angle starts from 0). 1 kg, 1 m, a thin rod.
FigureScene pendulum_with_stop(double theta_0, double stop, double restitution);

/// A disc on a hinge along z with a spring and damper, or with a servo: moment J, started at `angle` from its target.
FigureScene spring_rotor(double J, double stiffness, double damping, double angle, double max_torque = infinity);

// Chains, tops, trees ----------------------------------------------------------------------------------------------------------------------------

struct ChainOptions {
    int links = 20;
    double link_length = 0.5, link_mass = 1;
    double end_mass = 100, end_radius = 0.25;  ///< 0: no ball at the end
    Vector3d direction = Vector3d::UnitX();
    FigureJointKind kind = FigureJointKind::ball;  ///< ball, or hinge about y
    double break_force = infinity;
};
/// S5 as it stands: 20 links of 0.5 m and 1 kg, a ball of 100 kg whose surface is joined, horizontal, at rest. M g L = 11.04 kJ, as published. The
/// thickness of links (0.1 m) and the radius of the ball are chosen. chain_s5.csv has where it goes.
FigureScene chain(const ChainOptions& options = {});

/// A chain of free links without gravity, each with a turn of its own: all random, up to `spin` rad/s.
FigureScene floating_chain(int links = 20, double spin = 2, std::uint64_t seed = 1);

/// Hangs from a fixed end, and breaks at the first joint whose force passes 1.5 of what a chain hanging at rest has at its top.
FigureScene breaking_chain(int links = 10, double end_mass = 5);

/// S9: a square plate of 1 kg, 0.4 x 0.4 x 0.04 m, 0.3 m from its pivot, spin 100 rad/s, tilt 30 degrees, started in the slow steady precession,
/// 1.1479 rad/s. Its axis is body z.
FigureScene heavy_top(double spin = 100, double tilt = pi / 6);
/// Its steady precession, rad/s.
double top_precession(double spin = 100, double tilt = pi / 6);

/// S10 is published without its measures. Here: 2^levels - 1 links of 0.5 m and 1 kg, each carries two, ball joints, ends of 10 kg; held sideways.
FigureScene binary_tree(int levels = 4, double end_mass = 10);

/// Every kind that trees can have, one after another: hinge, universal, slider, ball, fixed, wheel, hinge; a rod across it if asked. Turning.
FigureScene mixed_tree(bool with_rod = false, std::uint64_t seed = 1);

// Figures ----------------------------------------------------------------------------------------------------------------------------------------

struct RagdollOptions {
    bool limits = true;
    double torso_factor = 1;  ///< times mass and moments of the chest
    double damping = 0;       ///< N m s, of every joint
    double stiffness = 0;     ///< N m, of every joint, towards the start
    bool locked = false;      ///< all joints fixed
    bool all_balls = false;   ///< knees, elbows and toes too
};
/// Pelvis, chest, head, upper arms, forearms, thighs, shanks: 6 balls with cone and twist limits, 4 hinges with limits; 73.9 kg, of the masses of the
/// walking figure of 13 bodies. Stands upright with arms down, soles at z = 0, faces x.
FigureScene ragdoll_11(const RagdollOptions& options = {});
/// It without gravity, its left elbow bending at 8 rad/s; restitution: of all limits.
FigureScene floating_ragdoll(double restitution);
/// ragdoll_11 with abdomen, collar bones, hands, feet and toes: 20 bodies, 19 joints, of which 6 hinges (elbows, knees, toes). 76.1 kg.
FigureScene ragdoll_20(const RagdollOptions& options = {});

/// Figures of eleven that lie in the air, in layers of 2 x 2 (16 and fewer) or 4 x 4, 1.3, 2.6, .. m above the ground, slightly turned at random.
FigureScene heap_of_ragdolls(int count = 16, const RagdollOptions& options = {}, std::uint64_t seed = 1);
/// Figures of eleven one above another: 1, 2.2, .. m.
FigureScene column_of_ragdolls(int count = 16, const RagdollOptions& options = {}, std::uint64_t seed = 1);
/// Figure of 20 with all joints fixed, on its feet.
FigureScene standing_figure(double torso_factor = 1);
/// Figure of 20 on its back in the air.
FigureScene lying_figure(double torso_factor = 1, double height = 0.3);

// Buildings and machines -------------------------------------------------------------------------------------------------------------------------

/// 30 planks of 10 kg on hinges, tied at both ends, in an arc; boxes of twice a plank's mass above it.
FigureScene bridge(int planks = 30, int boxes = 10, double box_factor = 2);
/// Links of 50 g and 0.1 m over a wall 0.36 m thick, a ball of 10 kg on the left, one of 5 kg on the right.
FigureScene rope_over_edge(int links = 30, double left_mass = 10, double right_mass = 5);
/// 10 kg, 1 x 2 x 0.04 m, on 1 to 3 hinges in one line, which leans by `lean` rad so that the door falls shut; opened by 1 rad.
FigureScene door(int hinges = 1, double lean = 0.2);
/// Crank 0.4, coupler 0.9, rocker 0.8, ground 1 m, bars of 1 kg/m, spatial hinges. `doubled`: hinges of the ground twice, 0.1 m apart. The plane is
/// turned by `R` from x z; `speed`: of the crank, rad/s.
FigureScene four_bar(bool doubled = false, double crank_angle = 1, double speed = 0, const Matrix3d& R = Matrix3d::Identity());
struct FourBarPose {
    double coupler, rocker;  ///< angles of the bars from x towards z
};
/// Closed form, on the branch where the rocker is to the left of the diagonal.
FourBarPose four_bar_pose(double crank_angle);

/// Four hinges and three bars beside the ground; links 0.6 m with a twist of 40 degrees and 0.877 m with 70. By the count of rows it could not move.
FigureScene bennett_loop(double angle = 1, double speed = 0);
/// Crank 0.2, rod 0.6 m; 1, 1.5 and 2 kg; the piston slides along x. crank_angle from x towards z.
FigureScene slider_crank(double crank_angle = 0.3, double speed = 60);
/// Where its piston is.
double piston_position(double crank_angle);

/// 1000 kg, 4 wheels on suspensions of 1.5 Hz and damping 0.4 of critical, motors of 30 rad/s; round bumps 0.1 m high across the way from 6 m on.
FigureScene car(double wheel_mass = 20, double motor_torque = 150, double steer_rate = 0);
/// Six links of 0.1 m and 0.05 kg in a row along x: hinges about z, y, y, x, y, x with servos.
FigureScene arm(double stiffness = 1e6, double damping = 8.3e3, double max_torque = infinity);
/// A wheel of `rotor_moment` on a free base of `base_moment`, with a motor; no gravity.
FigureScene rotor_on_base(double rotor_moment = 1e-3, double base_moment = 10, double speed = 1000, double max_torque = 1);

}  // namespace ingot_figures
