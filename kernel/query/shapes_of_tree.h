// SPDX-License-Identifier: MIT
// Which bodies a query has to look at closely: told by the tree of the broad phase, the nearest box first.
#pragma once

#include "../broad_phase/bound_shape.h"
#include "../broad_phase/tree_walk.h"
#include "candidates.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// Where a query looks: the shapes of a world, through a tree whose boxes hold them. See QueryTree.
struct ShapesOfTree : EveryShape {
    SortedTreeView tree;
};

/// Boxes: one, or some of a leaf.
template <class T>
struct Boxes {
    Vec3<T> low, high;
};
INGOT_INLINE Boxes<scalar> boxes_of(const TreeBox& box) { return {box.low, box.high}; }
INGOT_INLINE Boxes<lane> boxes_of(const TreeLeaf& leaf, int first) {
    return {{load(leaf.low[0] + first), load(leaf.low[1] + first), load(leaf.low[2] + first)},
            {load(leaf.high[0] + first), load(leaf.high[1] + first), load(leaf.high[2] + first)}};
}
template <class T>
INGOT_INLINE Vec3<T> each_of(const Vector& v) {
    return {splat<T>(v.x), splat<T>(v.y), splat<T>(v.z)};
}

/// How far along the way of a moving box it meets others: by the planes of their sides, axis by axis.
///
/// The moving box is a point, and the others are larger by its half extents; and by roundings of the way, so that no shape that is met is left out. A
/// way that is all but square to an axis is taken for one with a least rise along it, within these.
/// Source: Kay and Kajiya, "Ray tracing complex scenes", 1986.
class BoxesOnWay {
public:
    INGOT_INLINE explicit BoxesOnWay(const MovingBall& ball) : ball_(ball) {
        const scalar length = abs(ball.way.x) + abs(ball.way.y) + abs(ball.way.z);
        const scalar slack = 16 * epsilon * (abs(ball.from.x) + abs(ball.from.y) + abs(ball.from.z) + length + ball.radius) + 2 * least_rise;
        Vector half = {slack, slack, slack};
        if (ball.shape != nullptr) half = half + bounding::reach_of({ball.shape->shape, ball.radius, 0, 0}, ball.shape->A) * (1 + limits::flatness);
        to_low_ = ball.from + half;
        to_high_ = ball.from - half;
        inv_way_ = {inverse(ball.way.x), inverse(ball.way.y), inverse(ball.way.z)};
    }
    /// The fraction of the way; 2 for a box that is not met at all, and an empty one.
    template <class T>
    INGOT_INLINE T met_at(const Boxes<T>& boxes) const {
        const Vec3<T> inv_way = each_of<T>(inv_way_), low = boxes.low - each_of<T>(to_low_), high = boxes.high - each_of<T>(to_high_);
        const Vec3<T> a = {low.x * inv_way.x, low.y * inv_way.y, low.z * inv_way.z}, b = {high.x * inv_way.x, high.y * inv_way.y, high.z * inv_way.z};
        const Vec3<T> enters = min(a, b), leaves = max(a, b);
        const T enter = max(max(enters.x, enters.y), max(enters.z, T{})), leave = min(min(leaves.x, leaves.y), min(leaves.z, splat<T>(1)));
        return select(both(enter <= leave, boxes.low.x <= boxes.high.x), enter, splat<T>(2));
    }
    scalar limit() const { return ball_.fraction; }

private:
    static constexpr scalar least_rise = limits::size_min / 8;  ///< m; a quotient by it of the largest side there is, trees::no_place, is finite
    static scalar inverse(const scalar& rise) { return 1 / (abs(rise) > least_rise ? rise : rise < 0 ? -least_rise : least_rise); }

    const MovingBall& ball_;
    Vector to_low_, to_high_, inv_way_;
};

/// How far boxes are from a point: squares of distances, m^2.
class BoxesAbout {
public:
    INGOT_INLINE BoxesAbout(const Vector& point, const scalar& distance)
        : point_(point), size_(abs(point.x) + abs(point.y) + abs(point.z)), distance_(distance) {}
    template <class T>
    INGOT_INLINE T met_at(const Boxes<T>& boxes) const {
        const Vec3<T> p = each_of<T>(point_), none = {T{}, T{}, T{}}, most = each_of<T>({far_away, far_away, far_away});
        return length_sq(min(max(max(boxes.low - p, p - boxes.high), none), most));
    }
    scalar limit() const {
        const scalar reach = distance_ > 0 ? distance_ : scalar(0), more = reach + 16 * epsilon * (size_ + reach);
        return more * more;
    }

private:
    static constexpr scalar far_away = 1024 * limits::position_max;  ///< m: beyond every distance that is asked for; its square is finite
    Vector point_;
    scalar size_;
    const scalar& distance_;
};

/// Calls look(slot) for the shapes of a leaf whose boxes are met no later than at boxes.limit(); near ones first.
template <class BoxesThere, class Look>
INGOT_INLINE void look_in_leaf(const TreeLeaf& leaf, const BoxesThere& boxes, const Look& look) {
    scalar at[leaf_bodies];
    unsigned found = 0;
    for (int first = 0; first < leaf_bodies; first += lanes) {
        const lane met = boxes.met_at(boxes_of(leaf, first));
        store(at + first, met);
        found |= static_cast<unsigned>(bits(met <= splat<lane>(boxes.limit()))) << first;
    }
    // bound: leaf_bodies: each turn takes one of them
    while (found != 0) {
        int nearest = 0;
        scalar least = scalar_max;
        for (int i = 0; i < leaf_bodies; ++i)
            if ((found >> i & 1u) != 0 && at[i] < least) {
                nearest = i;
                least = at[i];
            }
        if (!(least <= boxes.limit())) return;
        found &= ~(1u << nearest);
        look(static_cast<int>(leaf.slot[nearest]));
    }
}

/// Calls look(slot) for the shapes whose boxes are met no later than at boxes.limit(), which `look` may lower; near boxes first.
/// Cost: O(log shapes) for each shape whose box is met.
template <class BoxesThere, class Look>
INGOT_INLINE void look_in_order(const SortedTreeView& tree, const BoxesThere& boxes, const Look& look) {
    struct Waiting {
        int box_i;
        scalar at;
    };
    Waiting waiting[trees::levels_max];  // on the way down the farther of two waits: one a level
    int count = 0;
    Waiting next = {1, boxes.met_at(boxes_of(tree.boxes[1]))};
    // bound: 2 leaf_places: each box once
    for (;;) {
        if (next.at <= boxes.limit()) {
            if (next.box_i < tree.leaf_places) {
                const int box_i = 2 * next.box_i;
                const scalar left = boxes.met_at(boxes_of(tree.boxes[box_i])), right = boxes.met_at(boxes_of(tree.boxes[box_i + 1]));
                const int right_first = right < left ? 1 : 0;
                const scalar far = max(left, right);
                if (far <= boxes.limit()) waiting[count++] = {box_i + 1 - right_first, far};
                next = {box_i + right_first, min(left, right)};
                continue;
            }
            look_in_leaf(tree.leaves[next.box_i - tree.leaf_places], boxes, look);
        }
        if (count == 0) return;
        next = waiting[--count];
    }
}

/// A shape of the tree, seen from a point; one of which nothing is left has no slot to be looked at.
struct SeenShape {
    bool there, everywhere;
    Vector c;  ///< m
    scalar radius;
};
INGOT_INLINE SeenShape seen_from(const ShapesOfTree& all, const Vector& from, int slot) {
    const Surface& surface = all.surfaces.surfaces[slot];
    const Place at = place_of(slot);
    const ShapeKind kind = surface.shape.kind;
    return {kind != ShapeKind::none, kind == ShapeKind::half_space, lane_of(all.bodies.translation[at.tile].r_CM, at.lane) - from,
            surface.bounding_radius};
}

/// As look_along of all shapes, but for the order.
template <class Look>
INGOT_INLINE void look_along(const ShapesOfTree& all, const MovingBall& ball, const Look& look) {
    const WayOfBall way(ball.way);
    look_in_order(all.tree, BoxesOnWay(ball), [&](int slot) {
        const SeenShape seen = seen_from(all, ball.from, slot);
        if (seen.everywhere || (seen.there && way.may_touch(seen.c, seen.radius, ball))) look(slot);
    });
}

/// As look_about of all shapes, but for the order.
template <class Look>
INGOT_INLINE void look_about(const ShapesOfTree& all, const Vector& point, const scalar& distance, const Look& look) {
    look_in_order(all.tree, BoxesAbout(point, distance), [&](int slot) {
        const SeenShape seen = seen_from(all, point, slot);
        if (seen.everywhere || (seen.there && may_come_within(seen.c, seen.radius, distance))) look(slot);
    });
}

} }  // namespace ingot

#pragma GCC diagnostic pop
