// SPDX-License-Identifier: MIT
// What a search for pairs knows of the shapes of a world. Where bodies sleep, only shapes that are searched for have pairs in the list: those of
// active bodies, and sensors. Pairs of two that rest are in no list; their manifolds are put aside (see island/rest_view.h).
#pragma once

#include "../base/workers.h"
#include "body_pairs.h"

namespace ingot { inline namespace INGOT_ABI {

/// What is known of a shape.
struct SearchFlag {
    enum : uint8_t {
        searched = 1,  ///< its pairs are in the list
        due = 2,       ///< it is new, woke, or left its fat AABB: the search at hand finds its pairs
        moved = 4,     ///< it is no more where the tree was built for
    };
};

/// The shapes of a world, without their capacity.
struct SearchView {
    static constexpr bool only_balls = false;

    BodyView shapes;
    SurfaceView surfaces;
    BoundsTile* bounds;
    uint8_t* flags;  ///< by shape slot

    /// A shape has the inv_M of its body; its inertia is none of it.
    bool moves(int slot) const { return shapes.translation[place_of(slot).tile].inv_M[place_of(slot).lane] > 0; }
    bool has(int slot, int flag) const { return (flags[slot] & flag) != 0; }
    void set(int slot, int flag) const { flags[slot] = static_cast<uint8_t>(flags[slot] | flag); }
    void clear(int slot, int flag) const { flags[slot] = static_cast<uint8_t>(flags[slot] & ~flag); }
};

/// Of a world that has balls, half spaces, and nothing else: how others are bounded is not linked.
struct BallSearchView : SearchView {
    static constexpr bool only_balls = true;
};

/// Bounds in this step of the shapes of some tiles, beside others: where several cores work, all are bounded before a search looks at them.
void bound_shapes(const SearchView& search, scalar h, const TaskRange& tiles);

/// Bounds of all shapes, where nothing sleeps. Those that left their fat AABB have a new one, and are due: due[0 .. count).
/// bounded: they have been by bound_shapes.
/// Returns: how many. Cost: as refresh_bounds.
int refresh_bounds_and_due(const SearchView& search, scalar h, uint32_t* due, bool bounded);

/// Bounds of one shape in this step, as refresh_bounds.
void bound_shape(const SearchView& search, scalar h, int slot);
/// The same. True when it has left its fat AABB.
bool refresh_bounds_of(const SearchView& search, scalar h, int slot);
/// True when it has, once it has been bounded.
bool has_left_bounds(const SearchView& search, int slot);
/// Of a slot that holds no shape yet: such bounds overlap nothing.
void empty_bounds(BoundsTile* bounds, int slot);
/// A new fat AABB around its bounds.
void fatten_bounds_of(const SearchView& search, int slot);

} }  // namespace ingot
