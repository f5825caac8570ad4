// SPDX-License-Identifier: MIT
// Rows of two bodies, read and applied.
#pragma once

#include "point_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Velocities or displacements: `kind` of the calls below.
using MotionOfBody = PointMotion PointBody::*;

/// The two bodies of a manifold.
struct PointPair {
    PointBody &A, &B;
};

/// Motion of A against B as the point P sees it.
struct RelativeVelocity {
    Vector linear, angular;
};
RelativeVelocity relative_motion(const PointPair& pair, MotionOfBody kind, const Vector& P);

/// A gets an impulse at P and a moment, B the opposite. Units: N s and N m s for velocities; kg m and kg m^2 for displacements.
void push_pair(const PointPair& pair, MotionOfBody kind, const Vector& P, const Vector& impulse, const Vector& moment);

/// Speed at P along the unit vector n that a unit impulse along n at P gives, kg^-1.
scalar compliance_at(const PointPair& pair, const Vector& P, const Vector& n);
/// Sum of the same along two directions across n.
scalar compliance_across(const PointPair& pair, const Vector& P, const Vector& n);
/// Spin about n that a unit moment about n gives, kg^-1 m^-2.
scalar compliance_about(const PointPair& pair, const Vector& n);

} }  // namespace ingot
