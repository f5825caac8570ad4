// SPDX-License-Identifier: MIT
// The way of a body through a step, as far as it is known: what a search for its impacts goes by.
#pragma once

#include "../body/body_tiles.h"
#include "../shape/body_shapes.h"

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
    Index next_slot;  ///< whom it meets; its own slot: nobody, the path ends
    uint8_t impacts;   ///< followed in this step
    bool fast;         ///< it may get beyond something within a step
    bool falls_free;   ///< nothing touches it on the way: its motion is known exactly at every time
    Index next_fast, next_stray;  ///< 1 + slot of the next of FastBodies; 0: none
    bool is_listed;          ///< among the fast
    bool is_stray;           ///< it may be outside of the bounds that the step began with
    bool in_contact;         ///< it takes part in the contacts of the step, or waits for the next
};

inline constexpr scalar never = 2;


/// Of a body with all its shapes.
struct BodyExtent {
    scalar least;   ///< m; the least half extent of any of them
    scalar radius;  ///< m; of the ball about the centre of mass that holds them all
};
BodyExtent extent_of(const BodyShapes& shapes, int slot);

/// A shape on the path of its body.
struct ShapeOnPath {
    const BodyPath& path;
    Shape shape;
    const ShapePlace* place;  ///< on the body; null: the body's frame is the shape's own
    const ConvexHull* hull;   ///< of a hull; else null
    scalar radius;            ///< m; of the ball about the body's centre of mass that holds the shape; 0: a half space
};
INGOT_INLINE ShapeOnPath shape_on_path(const BodyShapes& shapes, ShapeSlot shape, const BodyPath& path) {
    const Surface& surface = shapes.surface(shape);
    return {path, surface.shape, shapes.place(shape), shapes.hull(shape), surface.bounding_radius};
}

/// Where the centre of mass of a body and its axes are at time t.
struct PathFrame {
    Vector r_CM;  ///< m
    Matrix A;     ///< body to world
};
PathFrame frame_on_path(const BodyPath& path, scalar t);

/// Before a step of h seconds: whether a body is fast, by v_CM and omega.
bool begins_fast(const BodyView& bodies, const BodyShapes& shapes, scalar h, int slot);
/// The same of one that shows the motion of a kinematic body.
bool kinematic_begins_fast(const BodyView& bodies, const BodyShapes& shapes, scalar h, int slot);
/// And where it begins. Whether it is fast stays as it is known.
void begin_path(const BodyView& bodies, scalar h, int slot, BodyPath& path);

/// The motion of a body at one time.
struct PathPoint {
    Vector r_CM, way;  ///< m; way: m in a whole step
    Vector turn;       ///< rad in a whole step
    Matrix A;
};

/// From one time on at most by this turn: what turns freely does so steadily for a short while only.
/// Returns: when the path ends, if it begins with that turn at `from`.
scalar end_of_path(const Vector& turn, scalar from);

/// Lists of the bodies that a step has to look at again and again, through their paths.
struct FastBodies {
    Index first_fast, first_stray;  ///< 1 + slot; 0: none. Who was fast stays in its list

    void add_fast(BodyPath* paths, int slot) {
        if (paths[slot].is_listed) return;
        paths[slot].is_listed = true;
        paths[slot].next_fast = first_fast;
        first_fast = static_cast<Index>(slot + 1);
    }
    void add_stray(BodyPath* paths, int slot) {
        if (paths[slot].is_stray) return;
        paths[slot].is_stray = true;
        paths[slot].next_stray = first_stray;
        first_stray = static_cast<Index>(slot + 1);
    }
};

/// Whether a body that was to go by `begin`, m and rad in the step, may have left its bounds by going by `way` and `turn`: they have half of
/// limits::contact_margin to spare.
bool leaves_bounds(const PathPoint& begin, const Vector& way, const Vector& turn, const BodyExtent& extent, scalar unit);

/// The path from one point to another, as it turns in the mean of both, and what that leaves to the other's A. fall: m in a step, squared.
void lay_path(const PathPoint& begin, scalar from, const PathPoint& end, scalar until, const Vector& fall, BodyPath& path);

/// The path of a kinematic body as the step begins is what it goes, whoever it meets.
INGOT_INLINE bool is_kinematic_path(const BodyView& bodies, const BodyPath& path, int slot) {
    return !is_dynamic(bodies, slot) && length_sq(path.way) + length_sq(path.turn) > 0;
}
/// It turns by limits::kinematic_turn_max at most.
void begin_kinematic_path(BodyPath& path);

/// Whether a path is fast.
bool is_fast_path(const BodyPath& path, const BodyExtent& extent);

/// A path that ends where the body is put: it stays there.
void end_path(BodyPath& path, const Vector& r_CM, const Matrix& A, scalar t);

} }  // namespace ingot
