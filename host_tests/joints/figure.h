// SPDX-License-Identifier: MIT
// A figure: bodies and what joins them, described in double with Eigen. It knows nothing of the kernel; scenes are made of it (figure_scenes.h), and
// the reference moves it (constrained_reference.h).
//
// SI units, world axes, z up; rotations are right-handed. A joint joins body A, the parent or the world, to body B. All angles and travels are of B
// against A and zero at the start, whatever the pose there.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace ingot_figures {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Quaterniond = Eigen::Quaternion<double, Eigen::DontAlign>;  ///< the same for a test that is compiled for wider registers

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double pi = 3.14159265358979323846;
inline constexpr int the_world = -1;  ///< as body_A: what does not move

enum class FigureShape { none, sphere, capsule, box };

/// A rigid body with a solid about its centre of mass, along its principal axes.
struct FigureBody {
    double M = 1;                             ///< kg; 0: nothing moves it
    Vector3d I_body = Vector3d::Ones();       ///< kg m^2, principal moments about the centre of mass
    Vector3d r_CM = Vector3d::Zero();         ///< m
    Matrix3d A = Matrix3d::Identity();        ///< body to world
    Vector3d v_CM = Vector3d::Zero();         ///< m/s
    Vector3d omega = Vector3d::Zero();        ///< rad/s, world axes
    FigureShape shape = FigureShape::none;    ///< none: it touches nothing
    Vector3d half_extent = Vector3d::Zero();  ///< m; box; sphere: radius in x; capsule along body z: radius in x, half of its straight part in z
    double restitution = 0, friction = 0;
};

enum class FigureJointKind {
    ball,       ///< one point in common
    hinge,      ///< a point and axis_A in common
    slider,     ///< no turning; the anchor of B moves along axis_A, which is fixed in A
    universal,  ///< a point in common; axis_A, fixed in A, stays square to axis_B, fixed in B
    fixed,      ///< nothing free
    wheel,      ///< the anchor of B moves along axis_A (suspension, fixed in A); B spins about axis_B (axle, fixed in B), which A holds and steers
    distance,   ///< the anchors stay least to most apart; a rod where the two are equal, a rope where least is 0
    parallel,   ///< axis_A in common, no point
    gear,       ///< rate of joint gear_1 + gear_ratio times rate of joint gear_2 = 0
};

/// Drives a free direction to a speed, with what force it takes up to a limit.
struct FigureMotor {
    double speed = 0;       ///< rad/s or m/s
    double max_torque = 0;  ///< N m or N; 0: there is no motor
};

/// Torque (or force) on a free direction: -stiffness (x - target) - damping (rate - target_rate), cut at max_torque.
struct FigureDrive {
    double stiffness = 0;  ///< N m/rad or N/m
    double damping = 0;    ///< N m s/rad or N s/m
    double target = 0, target_rate = 0;
    double max_torque = infinity;
    bool exists() const { return stiffness != 0 || damping != 0; }
};

struct FigureJoint {
    FigureJointKind kind = FigureJointKind::ball;
    int body_A = the_world, body_B = 0;
    Vector3d anchor = Vector3d::Zero();    ///< m, world, at the start: of both bodies, but for a distance of A alone
    Vector3d anchor_B = Vector3d::Zero();  ///< a distance: of B
    Vector3d axis_A = Vector3d::UnitZ();   ///< unit, world, at the start; ball: middle of the cone, fixed in A
    Vector3d axis_B = Vector3d::UnitZ();   ///< unit, world, at the start; ball: what stays in the cone, fixed in B
    double least = 0, most = infinity;     ///< m, a distance
    double lower = -infinity;              ///< rad or m: hinge angle, slider and suspension travel, first angle of a universal joint (about axis_A)
    double upper = infinity;
    double cone = infinity;          ///< rad, ball: largest angle between axis_A and axis_B
    double twist_lower = -infinity;  ///< rad, ball: turn of B about axis_B against A, after the swing of the axes is taken off; 0 at the start
    double twist_upper = infinity;
    double restitution = 0;            ///< of all limits
    FigureMotor motor;                 ///< of hinge angle, slider travel, wheel spin
    FigureDrive servo;                 ///< of the same; ball: of the rotation vector of B against A, in which target is not looked at
    FigureDrive suspension;            ///< wheel: of its travel
    double steer = 0, steer_rate = 0;  ///< wheel: the axle is turned about axis_A by steer + steer_rate t
    int gear_1 = 0, gear_2 = 0;        ///< gear: joints that it couples, hinges, sliders or wheels (their spin)
    double gear_ratio = 1;
    double break_force = infinity, break_torque = infinity;  ///< N, N m: a reaction beyond ends the joint
    bool enabled = true;                                     ///< false: it does nothing

    bool is_rod() const { return kind == FigureJointKind::distance && least == most; }
};

struct FigureScene {
    std::string name;
    Vector3d g{0, 0, -9.81};  ///< m/s^2
    std::vector<FigureBody> bodies;
    std::vector<FigureJoint> joints;

    int add(const FigureBody& body) {
        bodies.push_back(body);
        return static_cast<int>(bodies.size()) - 1;
    }
    int join(const FigureJoint& joint) {
        joints.push_back(joint);
        return static_cast<int>(joints.size()) - 1;
    }
    const FigureBody& body(int body_i) const { return bodies[static_cast<std::size_t>(body_i)]; }
    FigureBody& body(int body_i) { return bodies[static_cast<std::size_t>(body_i)]; }
    const FigureJoint& joint(int joint_i) const { return joints[static_cast<std::size_t>(joint_i)]; }
    FigureJoint& joint(int joint_i) { return joints[static_cast<std::size_t>(joint_i)]; }
    int body_count() const { return static_cast<int>(bodies.size()); }
    int joint_count() const { return static_cast<int>(joints.size()); }
};

/// Where a body is and how it moves.
struct BodyMotion {
    Vector3d r_CM = Vector3d::Zero();
    Quaterniond q = Quaterniond::Identity();  ///< body to world
    Vector3d v_CM = Vector3d::Zero();
    Vector3d omega = Vector3d::Zero();  ///< rad/s, world axes

    Matrix3d A() const { return q.toRotationMatrix(); }
};

/// All bodies of a scene at one time.
struct FigureState {
    double t = 0;  ///< s
    std::vector<BodyMotion> bodies;

    const BodyMotion& body(int body_i) const { return bodies[static_cast<std::size_t>(body_i)]; }
    BodyMotion& body(int body_i) { return bodies[static_cast<std::size_t>(body_i)]; }
};

/// The state in which a scene begins.
inline FigureState start_of(const FigureScene& scene) {
    FigureState state;
    for (const FigureBody& body : scene.bodies) state.bodies.push_back({body.r_CM, Quaterniond(body.A).normalized(), body.v_CM, body.omega});
    return state;
}

/// A unit vector square to n.
inline Vector3d square_to(const Vector3d& n) {
    Eigen::Index least = 0;
    n.cwiseAbs().minCoeff(&least);
    return n.cross(Vector3d::Unit(least)).normalized();
}

/// The least rotation that takes unit vector a to b; they must not be opposite.
inline Quaterniond least_turn(const Vector3d& a, const Vector3d& b) {
    const Vector3d n = a.cross(b);
    return Quaterniond(1 + a.dot(b), n.x(), n.y(), n.z()).normalized();
}

/// The rotation by an angle about a unit axis.
inline Matrix3d turn_about(const Vector3d& axis, double angle) { return Eigen::AngleAxisd(angle, axis).toRotationMatrix(); }

/// The rotation by |phi| about phi.
inline Quaterniond rotation_by(const Vector3d& phi) {
    const double angle = phi.norm(), half = angle / 2;
    const double s = angle > 1e-4 ? std::sin(half) / angle : 0.5 - angle * angle / 48;
    return {std::cos(half), s * phi.x(), s * phi.y(), s * phi.z()};
}

/// The vector phi of a rotation, |phi| <= pi.
inline Vector3d rotation_vector(const Quaterniond& q) {
    const double sign = q.w() < 0 ? -1 : 1, length = q.vec().norm();
    if (length < 1e-8) return 2 * sign * q.vec();
    return 2 * std::atan2(length, sign * q.w()) / length * sign * q.vec();
}

}  // namespace ingot_figures
