// SPDX-License-Identifier: MIT
// Who sleeps, in scenes that name `sleeps`.
//
// A body is awake, or at rest: one that can move is at rest when it sleeps, one that cannot when nothing was done to it in the last step.
// What comes to rest is settling for one step more: its bounds and manifolds are made for the place where it stays, and then kept.
#pragma once

#include "../body/body_tiles.h"
#include "disjoint_sets.h"

namespace ingot { inline namespace INGOT_ABI {

/// Without its capacities.
struct RestView {
    uint16_t* awake;     ///< by tile, a bit a lane
    uint16_t* settling;   ///< by tile, a bit a lane: at rest since the last step
    scalar* rest_time;    ///< s, by slot: how long the body has been slow by now, up to Scene::sleep_time
    uint16_t* parent;    ///< by slot: another body of the island, nearer to its root, which is its own parent. Holds while the island sleeps
    uint8_t* marks;      ///< by slot, of roots: for the search at hand

    static bool has(const uint16_t* bits, int slot) {
        const Place at = place_of(slot);
        const unsigned of_tile = bits[at.tile];
        return (of_tile >> at.lane & 1u) != 0;
    }
    static void set(uint16_t* bits, int slot) {
        uint16_t& of_tile = bits[place_of(slot).tile];
        of_tile = static_cast<uint16_t>(of_tile | 1u << place_of(slot).lane);
    }
    static void clear(uint16_t* bits, int slot) {
        uint16_t& of_tile = bits[place_of(slot).tile];
        of_tile = static_cast<uint16_t>(of_tile & ~(1u << place_of(slot).lane));
    }

    bool is_awake(int slot) const { return has(awake, slot); }
    /// Awake, or settling.
    bool is_active(int slot) const { return has(awake, slot) || has(settling, slot); }
    bool tile_is_active(int tile_i) const { return (awake[tile_i] | settling[tile_i]) != 0; }

    DisjointSets islands() const { return {parent}; }
    /// The body that stands for the island.
    int root(int slot) const { return islands().root(slot); }
};

/// Does something for every slot whose bit is set, in the order of slots.
template <class Each>
INGOT_INLINE void for_slots(const uint16_t* bits, int tile_count, const Each& each) {
    for (int tile_i = 0; tile_i < tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        int slot = tile_i * lanes;
        for (unsigned left = bits[tile_i]; left != 0; left >>= 1, ++slot)  // bound: lanes: bits has a bit a lane
            if ((left & 1u) != 0) each(slot);
    }
}

} }  // namespace ingot
