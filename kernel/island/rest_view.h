// SPDX-License-Identifier: MIT
// Who sleeps, in scenes that name `sleeps`.
//
// A body is awake, or at rest: a body that can move is at rest when it sleeps, an immovable one when nothing was done to it in the last step. A body
// that comes to rest is settling for one more step, in which its bounds and manifolds are made for the place where it stays. Then its manifolds are
// put aside: no list of a step holds them until the island wakes. So the cost of a step depends on the bodies awake, not on those asleep.
#pragma once

#include "../body/body_tiles.h"
#include "../broad_phase/body_pairs.h"
#include "active_tiles.h"
#include "disjoint_sets.h"

namespace ingot { inline namespace INGOT_ABI {

/// Without its capacities.
struct RestView {
    uint16_t* awake;      ///< by tile, a bit a lane
    uint16_t* settling;   ///< by tile, a bit a lane: at rest since the last step
    ActiveTiles active;   ///< tiles with a bit in one of them
    scalar* rest_time;    ///< s, by slot: how long the body has been slow by now, up to Scene::sleep_time
    Index* parent;     ///< by slot: another body of the island, nearer to its root, which is its own parent. Holds while the island sleeps
    Index* next_body;  ///< by slot: the next of the island, in a ring
    uint8_t* marks;       ///< by slot, of roots: for the search at hand
    Index* aside;      ///< by slot, of roots: index + 1 of a record that is put aside; 0: none
    BodyPair* pairs_aside;     ///< by record: the shapes of a pair that is put aside; its `record` is index + 1 of the next of the island, in a ring
    Index* aside_count;     ///< records put aside
    int shapes_of_body;

    static bool has(const uint16_t* bits, int slot) {
        const Place at = place_of(slot);
        const unsigned of_tile = bits[at.tile];
        return (of_tile >> at.lane & 1u) != 0;
    }
    void wake(int slot) const {
        set(awake, slot);
        active.add(place_of(slot).tile);
    }
    /// The next step learns that the body stays where it is, or that the slot is empty.
    void settle(int slot) const {
        uint16_t& of_tile = awake[place_of(slot).tile];
        of_tile = static_cast<uint16_t>(of_tile & ~(1u << place_of(slot).lane));
        set(settling, slot);
        active.add(place_of(slot).tile);
    }

    bool is_awake(int slot) const { return has(awake, slot); }
    /// Awake, or settling.
    bool is_active(int slot) const { return has(awake, slot) || has(settling, slot); }

    /// The body of a shape's slot: the same slot, where each has one shape.
    INGOT_INLINE int body_of(int shape_slot) const { return shapes_of_body == 1 ? shape_slot : shape_slot / shapes_of_body; }

    DisjointSets islands() const { return {parent}; }
    /// The body that stands for the island.
    int root(int slot) const { return islands().root(slot); }
    /// The body of the slot is an island of its own.
    void make_alone(int slot) const {
        islands().make_set(slot);
        next_body[slot] = static_cast<Index>(slot);
        aside[slot] = 0;
    }

private:
    static void set(uint16_t* bits, int slot) {
        uint16_t& of_tile = bits[place_of(slot).tile];
        of_tile = static_cast<uint16_t>(of_tile | 1u << place_of(slot).lane);
    }
};

/// Calls each(slot) for every lane of a tile whose bit is set, in the order of slots.
template <class Each>
INGOT_INLINE void for_lanes(int tile_i, unsigned lane_bits, const Each& each) {
    int slot = tile_i * lanes;
    // bound: lanes: a bit a lane
    for (unsigned left = lane_bits; left != 0; left >>= 1, ++slot)
        if ((left & 1u) != 0) each(slot);
}
/// Calls each(slot) for every body that is awake, in the order of slots.
template <class Each>
INGOT_INLINE void for_awake(const RestView& rest, const Each& each) {
    rest.active.for_each([&](int tile_i) { for_lanes(tile_i, rest.awake[tile_i], each); });
}
/// The same for every body that is awake or settling.
template <class Each>
INGOT_INLINE void for_active(const RestView& rest, const Each& each) {
    rest.active.for_each([&](int tile_i) { for_lanes(tile_i, rest.awake[tile_i] | static_cast<unsigned>(rest.settling[tile_i]), each); });
}

} }  // namespace ingot
