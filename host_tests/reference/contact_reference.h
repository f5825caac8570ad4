// SPDX-License-Identifier: MIT
// The contact problem of one step, solved exactly, in double with Eigen. It shares no code with the kernel.
//
// Given the free velocities v (forces already applied), find impulses p at the contact points so that, with the relative
// velocity u = v_A(P) - v_B(P) - drive after them and its normal part measured from the bound of the point,
//
//     Signorini:  u_n >= 0,  p_n >= 0,  u_n p_n = 0
//     Coulomb:    |p_t| <= mu p_n;  where u_t is not 0:  p_t = -mu p_n u_t / |u_t|     (circular cone, largest dissipation)
//
// The bound is v_n_target, less separation / h where the surfaces are still apart (they may use up the gap in the step). Where
// bodies touch at more points than hold them up (a box on four corners) impulses are not unique; velocities are, and they are
// what is to be compared.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace ingot_reference {

using Vector3d = Eigen::Vector3d;
using Matrix3d = Eigen::Matrix3d;

/// A body that contacts act on. One that nothing moves has inv_M = 0 and inv_I_world = 0.
struct ContactBody {
    double inv_M = 0;                         ///< kg^-1
    Matrix3d inv_I_world = Matrix3d::Zero();  ///< kg^-1 m^-2, symmetric
    Vector3d r_CM = Vector3d::Zero();         ///< m
    Vector3d v_CM = Vector3d::Zero();         ///< m/s
    Vector3d omega = Vector3d::Zero();        ///< rad/s
};

/// One point where two bodies touch, or are about to.
struct ContactPoint {
    int body_A = 0, body_B = 0;
    Vector3d r_P = Vector3d::Zero();        ///< m, world
    Vector3d n = Vector3d::UnitZ();         ///< unit normal, from B to A
    double separation = 0;                  ///< m; not positive: touching
    double mu = 0;                          ///< Coulomb friction at this point
    double v_n_target = 0;                  ///< m/s; least n.(v_A - v_B): -e times the one before an impact
    Vector3d v_t_drive = Vector3d::Zero();  ///< m/s; velocity of the belt on B, less that of the belt on A
};

/// Friction of several points lumped into one, as solvers of many bodies do: a force pair at r_P and a twist about n, both
/// bounded by the sum of the normal impulses of `points`, whose own mu is then 0.
struct FrictionPatch {
    int body_A = 0, body_B = 0;
    Vector3d r_P = Vector3d::Zero();
    Vector3d n = Vector3d::UnitZ();
    double mu = 0;
    double mu_twist = 0;  ///< m; twist impulse, N m s, <= mu_twist * sum of normal impulses
    Vector3d v_t_drive = Vector3d::Zero();
    std::vector<int> points;
};

struct ContactProblem {
    std::vector<ContactBody> bodies;
    std::vector<ContactPoint> points;
    std::vector<FrictionPatch> patches;
    double h = 0;  ///< s, for points with a gap; 0: an impact, gaps do not close

    /// Least normal velocity of a point: v_n_target, or, apart, what lets the gap close and no more.
    double bound(const ContactPoint& point) const;
};

/// Impulses, and where the bodies end up by them.
struct ContactSolution {
    std::vector<Vector3d> v_CM, omega;
    std::vector<Vector3d> impulse;        ///< N s, world, of each point, on A
    std::vector<Vector3d> patch_impulse;  ///< N s, world, of each patch, on A
    std::vector<double> patch_twist;      ///< N m s, about n, on A
    double residual = 0;                  ///< m/s, see contact_residual
    int iterations = 0;                   ///< linear systems solved
    bool converged = false;               ///< residual within the tolerance, or the rounding of the impulses
};

/// By how much impulses and velocities miss the laws, each in m/s (an impulse counts times the inverse mass it meets at its
/// point) and each the worst over all points.
struct ContactDefects {
    double penetration = 0;      ///< a point closes faster than its bound
    double pull = 0;             ///< a normal impulse is negative
    double complementarity = 0;  ///< sqrt(u_n p_n): a point pushes and separates
    double cone = 0;             ///< friction beyond mu p_n
    double slip = 0;             ///< u_t not against p_t, or slip with friction to spare
    double momentum = 0;         ///< velocities are not those that the impulses make
    double worst() const;
};

/// Without friction (mu is not looked at): the convex quadratic program of the normal impulses by an active set, exact to
/// rounding; every pivot lowers the kinetic energy metric of Gauss's principle. converged = false: bounds that contradict each
/// other (a body crushed between two that nothing moves).
ContactSolution solve_contacts_without_friction(const ContactProblem& problem);

/// With friction: augmented Lagrangian on the bodies, whose inner systems are solved by a semi-smooth Newton method on the
/// laws of Alart and Curnier (Comput. Methods Appl. Mech. Eng. 92, 1991). Multiplier updates remove the penalty altogether,
/// so the laws hold to `tolerance`, m/s, however many redundant points there are. `guess`: impulses to start from, of the same
/// points, such as those of the step before; they decide how long it takes, and which of many equivalent impulses come out.
ContactSolution solve_contacts(const ContactProblem& problem, double tolerance = 1e-11, const ContactSolution* guess = nullptr);

/// For impulses from anywhere: the laws checked one by one. The velocities and impulses of `solution` are looked at, no more.
ContactDefects contact_defects(const ContactProblem& problem, const ContactSolution& solution);

/// One number for the same: the largest change, m/s, that one projection onto the law of a point would make there.
double contact_residual(const ContactProblem& problem, const ContactSolution& solution);

/// Velocities that the impulses in `solution` make of the free ones.
void apply_impulses(const ContactProblem& problem, ContactSolution& solution);

/// How far apart two solutions are, m/s: sqrt(2 T / M) of the difference in velocities, T its kinetic energy, M the mass of
/// all bodies that move.
double velocity_distance(const ContactProblem& problem, const ContactSolution& a, const ContactSolution& b);

}  // namespace ingot_reference
