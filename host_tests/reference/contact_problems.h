// SPDX-License-Identifier: MIT
// Contact problems with closed-form solutions: bodies, points, stacks.
#pragma once

#include <vector>

#include "contact_reference.h"

namespace ingot_reference {

/// A solid ball: I = 2/5 M R^2.
inline ContactBody solid_ball(double M, double R, const Vector3d& r_CM) {
    ContactBody body;
    body.inv_M = 1 / M;
    body.inv_I_world = Matrix3d::Identity() / (0.4 * M * R * R);
    body.r_CM = r_CM;
    return body;
}

/// A solid box along the world's axes: I_x = M (b^2 + c^2) / 3 with half extents a, b, c.
inline ContactBody solid_box_along_axes(double M, const Vector3d& half, const Vector3d& r_CM) {
    const Vector3d sq = half.cwiseProduct(half);
    ContactBody body;
    body.inv_M = 1 / M;
    body.inv_I_world = (M / 3 * Vector3d(sq(1) + sq(2), sq(2) + sq(0), sq(0) + sq(1))).cwiseInverse().asDiagonal();
    body.r_CM = r_CM;
    return body;
}

/// n from B to A.
inline ContactPoint point_between(int body_A, int body_B, const Vector3d& r_P, const Vector3d& n, double mu) {
    ContactPoint point;
    point.body_A = body_A;
    point.body_B = body_B;
    point.r_P = r_P;
    point.n = n;
    point.mu = mu;
    return point;
}

/// Equal boxes of these masses, bottom first, on immovable ground, four corners an interface. Body 0 is the ground, body i + 1
/// the box i, which stands on points 4 i to 4 i + 3.
inline ContactProblem stack_of_boxes(const std::vector<double>& masses, const Vector3d& half, double mu) {
    ContactProblem problem;
    problem.bodies.emplace_back();
    for (std::size_t box_i = 0; box_i < masses.size(); ++box_i) {
        const double floor = 2 * half.z() * static_cast<double>(box_i);
        problem.bodies.push_back(solid_box_along_axes(masses[box_i], half, {0, 0, floor + half.z()}));
        const int body_i = static_cast<int>(box_i) + 1;
        for (const double x : {-half.x(), half.x()})
            for (const double y : {-half.y(), half.y()})
                problem.points.push_back(point_between(body_i, body_i - 1, {x, y, floor}, Vector3d::UnitZ(), mu));
    }
    return problem;
}

/// What a step does before its contacts: v_CM += acceleration h for all that moves.
inline void fall(ContactProblem& problem, const Vector3d& acceleration, double h) {
    problem.h = h;
    for (ContactBody& body : problem.bodies)
        if (body.inv_M > 0) body.v_CM += h * acceleration;
}

}  // namespace ingot_reference
