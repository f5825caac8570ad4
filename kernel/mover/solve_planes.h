// SPDX-License-Identifier: MIT
// How much of a way, or of a velocity, a few planes leave.
#pragma once

#include "mover.h"

namespace ingot { inline namespace INGOT_ABI {

/// The way nearest to the one that is wanted that passes no plane: n . way >= -gap for each, or, of planes that it is in, >= min(-gap, push_max).
/// Where no way keeps all of them, or only one that is 1024 times as long as all lengths that were given, one that passes them by as little as there
/// is to be, the nearest of these.
///
/// The point of a polyhedron that is nearest to another point is on one, two or three of its planes, so of all these the nearest that no other plane
/// forbids is the answer: it is exact, to the rounding of the sum (of double, planes are kept to 64 of them), and does not depend on the order of the
/// planes, to the bit. It is computed in double.
/// Units:  m, world.
/// Errors: not_finite, out_of_range (fewer than 0 or more than 16 planes, a way or a gap beyond 2 limits::position_max), bad_direction (a normal that
///         is not of unit length).
/// Cost:   697 candidates of 16 planes, about 150 operations in double each; of 3 planes 8. Where no way keeps all planes, up to 35 times as many (of
///         double 70).
Result<Vector> solve_planes(const Vector& way, const MoverPlane* planes, int count);

/// The velocity nearest to v with which nothing is entered: n . v >= n . (velocity of the surface) for each plane. As exact. See solve_planes.
/// Units:  m/s, world. Errors: those of solve_planes; out_of_range beyond limits::speed_max.
Result<Vector> clip_velocity(const Vector& v, const MoverPlane* planes, int count);

} }  // namespace ingot
