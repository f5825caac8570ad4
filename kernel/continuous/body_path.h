// SPDX-License-Identifier: MIT
// The way of a body through a step, as far as it is known: what a search for its impacts goes by.
#pragma once

#include "../body/body_tiles.h"
#include "../shape/body_shapes.h"

namespace ingot { inline namespace INGOT_ABI {

/// What takes a body along its path, and so whether the motion at a time within it can be found.
enum class PathKind : uint8_t {
    free,       ///< it falls free
    on_fixed,   ///< what it touches cannot move or is kinematic: it can be solved again, for any part of its path
    in_pair,    ///< the same of it together with its partner
    in_island,  ///< the contacts of the step have moved it together with others, and it cannot be taken from them
    standing,   ///< it stays where it is, and waits for the next step
};

/// Where a body is at every time from `from` to `until`: a parabola and a steady turn. Times are fractions of the step.
/// The tiles of the body hold its motion at `until`.
struct BodyPath {
    Vector r_CM;        ///< m, at `from`
    Matrix A;           ///< body to world, at `from`
    Vector v_CM, L;     ///< at `from`
    Vector F_T, tau_T;  ///< N, N m; what acts on it beside contacts and gravity, all through the step
    Vector way, fall;   ///< m; r = r_CM + u (way + u fall), u = t - from
    Vector turn;        ///< rad in a whole step
    scalar from, until;
    scalar next;      ///< when it first meets something, or where its path has to be laid on; never: neither
    scalar due;       ///< followed: `next` as FollowedBodies has it in order
    Index next_slot;  ///< whom it meets; its own slot: nobody, the path ends
    Index partner;    ///< in_pair: the slot of the other
    Index place;      ///< followed: in FollowedBodies::queue
    Index next_stray;                ///< 1 + slot of the next of FollowedBodies; 0: none
    uint16_t version, next_version;  ///< how often it has been laid anew in this step; version of whom it meets, as that was found
    PathKind kind;
    uint8_t impacts;   ///< followed in this step
    bool fast;         ///< at the begin of the step: it may get beyond something in it, and has manifolds with what it touches alone
    bool is_followed;  ///< what it meets is looked for
    bool is_stray;     ///< it may be outside of the bounds that the step began with
    bool of_step;      ///< laid by the contacts of the step: those are all that it is solved with
    bool presses;      ///< in_pair: the two press on each other at its end
};

inline constexpr scalar never = 2;

/// Of a body with all its shapes.
struct BodyExtent {
    scalar least;   ///< m; the least half extent of any of them
    scalar radius;  ///< m; of the ball about the centre of mass that holds them all
    scalar reach;   ///< m; how far the surface gets by a turn of a radian, at most; of a ball about the centre of mass 0
};
BodyExtent extent_of(const BodyShapes& shapes, int slot);

/// The part of a turn, rad, that moves the surface of a body: none of a ball's, and of a capsule or a cylinder all but that about its axis.
Vector seen_turn(const BodyShapes& shapes, int slot, const Matrix& A, const Vector& turn);

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
/// The path of a body as the step begins: as if nothing acted on it any more. BodyPath::fast stays.
void begin_path(const BodyView& bodies, scalar h, int slot, BodyPath& path);

/// The motion of a body at one time.
struct PathPoint {
    Vector r_CM, way;  ///< m; way: m in a whole step
    Vector turn;       ///< rad in a whole step
    Matrix A;
};

/// When a path ends that begins at `from` with a turn, rad in a step. A body turns steadily for a short while only: by `most`, rad; or by a
/// path_parts_max-th of its turn, where there would be more parts than that.
scalar end_of_path(const Vector& turn, scalar from, scalar most);

/// The bodies that a step follows through their paths, as a heap: the one that meets something first comes first. And a list of those outside of the
/// bounds that the step began with.
struct FollowedBodies {
    BodyPath* paths;
    Index* queue;  ///< slots; room for max_bodies
    int count;
    Index first_stray;  ///< 1 + slot; 0: none

    void follow(int slot) {
        if (paths[slot].is_followed) return;
        paths[slot].is_followed = true;
        put(count++, slot);
        move(slot);
    }
    void add_stray(int slot) {
        if (paths[slot].is_stray) return;
        paths[slot].is_stray = true;
        paths[slot].next_stray = first_stray;
        first_stray = static_cast<Index>(slot + 1);
    }
    /// To its place, after it meets something else than before.
    void move(int slot);
    /// The first; -1: nothing comes within the step.
    int first() const { return count > 0 && paths[queue[0]].due <= 1 ? static_cast<int>(queue[0]) : -1; }

private:
    /// Of two that meet something at the same time the lower comes first.
    bool is_before(int slot_A, int slot_B) const {
        const scalar A = paths[slot_A].due, B = paths[slot_B].due;
        return A < B || (!(B < A) && slot_A < slot_B);
    }
    void put(int place, int slot) {
        queue[place] = static_cast<Index>(slot);
        paths[slot].place = static_cast<Index>(place);
    }
};

/// Whether a body that was to go by `begin`, m and rad in the step, may have left its bounds by going by `way` and `turn`: they have half of
/// limits::contact_margin to spare.
bool leaves_bounds(const PathPoint& begin, const Vector& way, const Vector& turn, const BodyExtent& extent, scalar unit);

/// Lays the path from one point to another: a parabola with this fall, m in a step squared, and the mean of both turns, put right so that it ends
/// with the A of the end.
void lay_path(const PathPoint& begin, scalar from, const PathPoint& end, scalar until, const Vector& fall, BodyPath& path);

/// Whether the path, as the step begins, is that of a kinematic body: it goes so, whoever it meets.
INGOT_INLINE bool is_kinematic_path(const BodyView& bodies, const BodyPath& path, int slot) {
    return !is_dynamic(bodies, slot) && length_sq(path.way) + length_sq(path.turn) > 0;
}
/// It turns by limits::kinematic_turn_max at most.
void begin_kinematic_path(BodyPath& path);

/// Whether a path is fast.
bool is_fast_path(const BodyPath& path, const BodyExtent& extent);

/// A path that ends where the body is put: it stands there.
void end_path(BodyPath& path, const Vector& r_CM, const Matrix& A, scalar t);

} }  // namespace ingot
