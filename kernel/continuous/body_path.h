// SPDX-License-Identifier: MIT
// The way of a body through a step, as far as it is known: what a search for its impacts goes by.
#pragma once

#include "../body/body_tiles.h"
#include "../shape/surface.h"
#include "../shape/placed_shape.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where a body is at every time from `from` to `until`: a parabola and a steady turn. Times are fractions of the step.
struct BodyPath {
    Vector r_CM;       ///< m, at `from`
    Matrix A;          ///< body to world, at `from`
    Vector v_CM, L;    ///< at `from`, in free fall
    Vector way, fall;  ///< m; r = r_CM + u (way + u fall), u = t - from
    Vector turn;       ///< rad in a whole step
    scalar from, until;
    scalar next;         ///< when it first meets something, or where its path has to be laid on; never: neither
    uint16_t next_slot;  ///< whom it meets; its own slot: nobody, the path ends
    bool fast;         ///< it may get beyond something within a step
    bool falls_free;   ///< nothing touches it on the way: its motion is known exactly at every time
    bool in_contact;         ///< it takes part in the contacts of the step, or waits for the next
};

inline constexpr scalar never = 2;

/// The least half extent of a shape; what holds no ball about its centre is infinitely thick. Units: m.
scalar least_half_extent(const Shape& shape);

/// The shape of a slot at time t.
PlacedShape place_on_path(const BodyPath& path, const Shape& shape, scalar t);

/// Before a step of h seconds: where every body begins, and who is fast, by v_CM and omega.
void begin_paths(const BodyView& bodies, const SurfaceView& surfaces, scalar h, BodyPath* paths);

/// The motion of a body at one time.
struct PathPoint {
    Vector r_CM, way;  ///< m; way: m in a whole step
    Vector turn;       ///< rad in a whole step
    Matrix A;
};

/// From one time on at most by this turn: what turns freely does so steadily for a short while only.
/// Returns: when the path ends, if it begins with that turn at `from`.
scalar end_of_path(const Vector& turn, scalar from);

/// The path from one point to another, as it turns in the mean of both, and what that leaves to the other's A. fall: m in a step, squared.
void lay_path(const PathPoint& begin, scalar from, const PathPoint& end, scalar until, const Vector& fall, BodyPath& path);

/// Whether a path is fast.
bool is_fast_path(const BodyPath& path, const Surface& surface);

/// A path that ends where the body is put: it stays there.
void end_path(BodyPath& path, const Vector& r_CM, const Matrix& A, scalar t);

} }  // namespace ingot
