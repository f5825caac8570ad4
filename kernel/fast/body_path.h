// SPDX-License-Identifier: MIT
// The way of a body through a step, as far as it is known: what a search for its impacts goes by.
#pragma once

#include "../body/body_tiles.h"
#include "../collide/bounds.h"
#include "../collide/placed_shape.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where a body is at every time from `from` to the end of the step: a parabola and a steady turn. Times are fractions of the step.
struct BodyPath {
    Vector r_CM;       ///< m, at `from`
    Matrix A;          ///< body to world, at `from`
    Vector way, fall;  ///< m; r = r_CM + u (way + u fall), u = t - from
    Vector turn;       ///< rad in a whole step
    scalar from;
    scalar hit;        ///< when it first meets something; never: it does not
    uint16_t hit_slot;
    bool fast;         ///< it may get beyond something within a step
    bool falls_free;   ///< nothing touches it on the way: its motion is known exactly at every time
    bool held;         ///< it takes part in the contacts of the step
};

inline constexpr scalar never = 2;

/// The least half extent of a shape; what holds no ball about its centre is infinitely thick. Units: m.
scalar least_half_extent(const Shape& shape);

/// The shape of a slot at time t.
PlacedShape place_on_path(const BodyPath& path, const Shape& shape, scalar t);

/// Before a step of h seconds: where every body begins, and who is fast, by v_CM and omega.
void begin_paths(const BodyView& bodies, const SurfaceView& surfaces, scalar h, BodyPath* paths);

/// What a path is made of beside the body: gravity, and h of the whole step.
struct PathClock {
    Vector gravity;
    scalar h;
};

/// The path of a body that has reached the end of the step, from where it was at time `from` (r_CM and A of the path).
///
/// Free fall: back along the parabola and the turn of the end. Else the chord: as far as it went, turned as its omega says, of the begin (omega_begin)
/// and of the end in the mean, and what is missing to the end.
void lay_path(const BodyView& bodies, const Surface& surface, int slot, const Vector& omega_begin, const PathClock& clock, BodyPath& path);

/// A path that ends where the body is put: it stays there.
void end_path(BodyPath& path, const Vector& r_CM, const Matrix& A, scalar t);

} }  // namespace ingot
