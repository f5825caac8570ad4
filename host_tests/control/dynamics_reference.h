// SPDX-License-Identifier: MIT
// The equations of motion of a tree of bodies, in double with Eigen: no spatial numbers, no passes up and down, and no kernel.
//
// Places and orientations of all bodies are functions of time, by joint coordinates q(t); their first and second derivatives at t = 0 follow by the
// product rule, matrix by matrix. So velocities and accelerations are exact; a partial velocity is what a rate of 1 makes of a body. Torques by
// d'Alembert: tau_i = sum over bodies of (M a - F) . v_i + (I alpha + w x I w - T) . w_i. Source: Kane, Levinson, "Dynamics", 1985, chapters 3, 4, 6.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ingot_control {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

enum class RefKind { ball, hinge, slider, universal, fixed, wheel };

inline int directions_of(RefKind kind) {
    switch (kind) {
        case RefKind::ball:
        case RefKind::wheel: return 3;
        case RefKind::universal: return 2;
        case RefKind::fixed: return 0;
        default: return 1;
    }
}

inline Matrix3d cross_matrix(const Vector3d& w) {
    Matrix3d m;
    m << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
    return m;
}

/// A value, and how fast and how more and more it changes.
template <class M>
struct Changing {
    M at, rate, second;
};
using Turn = Changing<Matrix3d>;
using Way = Changing<Vector3d>;

inline Turn operator*(const Turn& a, const Turn& b) {
    return {a.at * b.at, a.rate * b.at + a.at * b.rate, a.second * b.at + 2 * a.rate * b.rate + a.at * b.second};
}
inline Way operator*(const Turn& a, const Way& b) {
    return {a.at * b.at, a.rate * b.at + a.at * b.rate, a.second * b.at + 2 * a.rate * b.rate + a.at * b.second};
}
inline Way operator+(const Way& a, const Way& b) { return {a.at + b.at, a.rate + b.rate, a.second + b.second}; }
inline Way operator-(const Way& a, const Way& b) { return {a.at - b.at, a.rate - b.rate, a.second - b.second}; }
inline Turn transposed(const Turn& a) { return {a.at.transpose(), a.rate.transpose(), a.second.transpose()}; }
inline Turn still(const Matrix3d& A) { return {A, Matrix3d::Zero(), Matrix3d::Zero()}; }
inline Way still(const Vector3d& r) { return {r, Vector3d::Zero(), Vector3d::Zero()}; }

/// About a unit axis that stays, by an angle.
inline Turn turn_about(const Vector3d& n, const Changing<double>& angle) {
    const Matrix3d N = cross_matrix(n);
    const double s = std::sin(angle.at), c = std::cos(angle.at);
    const Matrix3d first = c * N + s * N * N, second = -s * N + c * N * N;
    return {Matrix3d::Identity() + s * N + (1 - c) * N * N, first * angle.rate, first * angle.second + second * angle.rate * angle.rate};
}
/// From an orientation on, with a spin and its change in the axes in front of it.
inline Turn turn_with(const Matrix3d& A, const Vector3d& w, const Vector3d& change) {
    const Matrix3d W = cross_matrix(w);
    return {A, W * A, (cross_matrix(change) + W * W) * A};
}

struct RefPose {
    Way r;
    Turn A;

    Vector3d spin() const { return axial(A.rate * A.at.transpose()); }
    Vector3d change_of_spin() const { return axial(A.second * A.at.transpose()); }

private:
    static Vector3d axial(const Matrix3d& m) { return Vector3d(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)) / 2; }
};

/// Of one number of the figure: where it is, how fast it goes, and with what acceleration. Of the turns of a ball joint `at` is not looked at.
using RefCoordinate = Changing<double>;

struct RefBody {
    double M = 1;
    Vector3d I_body = Vector3d::Ones();
    int parent = -1;                        ///< below zero: the ground; or, where the figure floats, nothing
    RefKind kind = RefKind::fixed;          ///< of the joint to it
    bool is_A = false;                      ///< the body is A of it, and its parent B
    Vector3d anchor_A, anchor_B;            ///< from the centre of mass, in the axes of the body, or of the ground
    Vector3d axis_A, axis_B;                ///< of A in its axes; of B in those of A, where the coordinates are 0
    Matrix3d start = Matrix3d::Identity();  ///< of B in the axes of A, there; of a ball joint as it is
    int first = 0;                          ///< of its coordinates
    Vector3d weight = Vector3d::Zero(), F = Vector3d::Zero(), T = Vector3d::Zero();  ///< N, N, N m: on it, world
};

/// What a tree is: parents before children.
struct RefFigure {
    std::vector<RefBody> bodies;
    bool floats = false;  ///< the first six coordinates are of body 0: its place, then its turns, and root is where it is
    RefPose root;         ///< the ground, or body 0 with `rate` and `second` of no coordinate
    int count = 0;

    std::size_t size() const { return bodies.size(); }

    std::vector<RefPose> poses(const std::vector<RefCoordinate>& q) const;

    /// Each number with the size of what it was summed from.
    struct Torques {
        VectorXd value, size;
    };
    Torques torques(const std::vector<RefCoordinate>& q) const;
    MatrixXd mass_matrix(const std::vector<RefCoordinate>& q) const;
    /// What a force at a point of a body and a torque do along each coordinate.
    VectorXd transposed_jacobian(const std::vector<RefCoordinate>& q, std::size_t body_i, const Vector3d& P, const Vector3d& F,
                                 const Vector3d& T) const;

private:
    Matrix3d inertia(std::size_t i, const std::vector<RefPose>& now) const;
    std::vector<RefPose> partial_poses(std::vector<RefCoordinate> q, int k) const;
    RefPose pose_of_root(const std::vector<RefCoordinate>& q) const;
};

/// Of a symmetric, positive definite matrix.
MatrixXd inverse_of(MatrixXd M);

}  // namespace ingot_control
