// SPDX-License-Identifier: MIT
// Bodies with locks, and what is to be seen of them.
#pragma once

#include "laws/thrown_bodies.h"

#include <cstring>

namespace locked_bodies {

using namespace thrown_bodies;
using ingot::AxisLocks;
using ingot::BodyId;
using ingot::BodyState;
using ingot::Matrix;
using ingot::Status;
using ingot::World;
using ingot_reference::to_matrix;
using ingot_reference::to_vector;

inline bool same(scalar a, scalar b) { return std::memcmp(&a, &b, sizeof a) == 0; }
inline scalar axis_of(const Vector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
inline Vector row_of(const Matrix& A, int axis) { return {axis_of(A.c0, axis), axis_of(A.c1, axis), axis_of(A.c2, axis)}; }
inline bool same(const Vector& a, const Vector& b) { return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z); }
inline bool is_locked(unsigned locks, int bit) { return (locks >> bit & 1u) != 0; }
inline int free_turns(unsigned locks) { return !is_locked(locks, 3) + !is_locked(locks, 4) + !is_locked(locks, 5); }

/// Locked coordinates of `now` are those of `before`; nothing moves along them. With one free turn the row of its axis stays, with none all of A.
template <class S>
testing::AssertionResult is_held(const World<S>& world, BodyId id, const BodyState& before) {
    const unsigned locks = world.locks(id).value;
    const BodyState now = world.state(id).value;
    const Vector omega = world.omega(id).value;
    for (int axis = 0; axis < 3; ++axis) {
        if (is_locked(locks, axis) && (!same(axis_of(now.r_CM, axis), axis_of(before.r_CM, axis)) || axis_of(now.v_CM, axis) != 0))
            return testing::AssertionFailure() << "moves along axis " << axis << " with locks " << locks;
        if (is_locked(locks, 3 + axis) && axis_of(omega, axis) != 0)
            return testing::AssertionFailure() << "turns about axis " << axis << " with locks " << locks;
        if (free_turns(locks) == 1 && !is_locked(locks, 3 + axis) && !same(row_of(now.A, axis), row_of(before.A, axis)))
            return testing::AssertionFailure() << "its axis " << axis << " turns with locks " << locks;
        if (free_turns(locks) == 0 && !same(row_of(now.A, axis), row_of(before.A, axis)))
            return testing::AssertionFailure() << "turns with locks " << locks;
    }
    return testing::AssertionSuccess();
}

/// (I_FF)^-1 among zeros, by Eigen.
inline Matrix3d restricted_inverse(const Matrix3d& I, unsigned locks) {
    std::vector<int> free;
    for (int axis = 0; axis < 3; ++axis)
        if (!is_locked(locks, 3 + axis)) free.push_back(axis);
    Eigen::MatrixXd E = Eigen::MatrixXd::Zero(3, static_cast<int>(free.size()));
    for (size_t i = 0; i < free.size(); ++i) E(free[i], static_cast<int>(i)) = 1;
    return free.empty() ? Matrix3d(Matrix3d::Zero()) : Matrix3d(E * (E.transpose() * I * E).fullPivLu().inverse() * E.transpose());
}

inline BodyDef any_body(RandomInput& random, unsigned locks) {
    const double M = std::exp(random.real(-4, 4));
    BodyDef def = ingot_reference::definition(M, random.moments(M));
    def.state.A = to_matrix(random.rotation());
    def.state.r_CM = to_vector(random.vector(10));
    def.locks = static_cast<std::uint8_t>(locks);
    return def;
}
inline Matrix3d inertia_of(const BodyDef& def) {
    const Matrix3d A = to_eigen(def.state.A);
    return A * to_eigen(def.mass.I_body).asDiagonal() * A.transpose();
}

}  // namespace locked_bodies
