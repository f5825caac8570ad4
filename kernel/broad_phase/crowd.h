// SPDX-License-Identifier: MIT
// Where an array is full: which pairs are kept, and who else is near. Nothing here runs in a step that has room.
//
// What is kept is what matters most, by a rank that knows neither slots nor the order in which pairs are found: who meets what cannot move comes
// first, then who is deepest, or is going to be, beside its size. Of two that are alike the one with the lower key is kept.
#pragma once

#include "../base/sort_in_tail.h"
#include "all_pairs.h"
#include "near_shapes.h"

namespace ingot { inline namespace INGOT_ABI {

/// More is kept rather than less. urgency: of its lesser bounding radius, -1 .. 1; first: before all that are not.
inline Index rank_of(bool first, scalar urgency) {
    constexpr scalar steps = 16383;
    const scalar within = urgency > -1 ? (urgency < 1 ? urgency : scalar(1)) : scalar(-1);
    return static_cast<Index>((first ? 32768 : 0) + static_cast<int>((within + 1) * steps));
}
/// Of what must not give way.
inline constexpr Index rank_of_kept = 65535;

/// The lesser bounding radius of two shapes, m; a half space has none.
inline scalar lesser_radius(const SurfaceView& surfaces, const BodyPair& pair) {
    const scalar R_A = surfaces.surfaces[pair.body_A].bounding_radius, R_B = surfaces.surfaces[pair.body_B].bounding_radius;
    return R_A == 0 ? R_B : R_B == 0 || R_A < R_B ? R_A : R_B;
}

/// A full list as a heap: the pair that gives way first is on top. rank(pair) is what it counts.
/// Source: as sort_by_key.
template <class Rank>
struct FullList {
    BodyPair* pairs;
    int count;
    Rank rank;

    bool gives_way(const BodyPair& a, const BodyPair& b) const {
        const Index rank_a = rank(a), rank_b = rank(b);
        return rank_a < rank_b || (rank_a == rank_b && a.key() > b.key());
    }
    void sift(int parent) const {
        // bound: log2 of the count: child more than doubles each turn
        for (int child = 2 * parent + 1; child < count; parent = child, child = 2 * parent + 1) {
            if (child + 1 < count && gives_way(pairs[child + 1], pairs[child])) ++child;
            if (!gives_way(pairs[child], pairs[parent])) return;
            const BodyPair above = pairs[parent];
            pairs[parent] = pairs[child];
            pairs[child] = above;
        }
    }
    void make() const {
        // bound: max_pairs, max_manifolds
        for (int parent = count / 2 - 1; parent >= 0; --parent) sift(parent);
    }
    void replace_top(const BodyPair& pair) const {
        pairs[0] = pair;
        sift(0);
    }
};

/// Where a pair stands in a list that is sorted by key; -1: nowhere.
int place_in(const BodyPair* pairs, int count, PairKey key);

/// Shapes behind a slot whose fat AABBs overlap its own: the lowest of them.
struct NextNeighbours {
    static constexpr int room = 64;
    int count = 0;
    Index slots[room];

    bool is_full() const { return count == room; }
    void note(int slot);
};

template <class Tree>
NextNeighbours next_neighbours(const SearchView& search, [[maybe_unused]] const Tree& tree, int slot, int after) {
    NextNeighbours next;
    const TreeBox box = trees::box_of(search.bounds, slot);
    if constexpr (is_tree<Tree>) {
        for_near_shapes(tree, box, [&](int other) {
            if (other > after) next.note(other);
        });
    } else {
        // bound: max_bodies max_shapes_of_body, rounded up to whole tiles
        for (int other = after + 1; other < search.shapes.tile_count * lanes && !next.is_full(); ++other)
            if (trees::overlap(box, trees::box_of(search.bounds, other))) next.note(other);
    }
    return next;
}

/// Who is left out of a search.
struct PairsOfInterest {
    int shapes_of_body;
    bool sleeps;  ///< only what is searched for has pairs

    bool has(const SearchView& search, int A, int B) const {
        if (!search.moves(A) && !search.moves(B)) return false;
        if (shapes_of_body > 1 && A / shapes_of_body == B / shapes_of_body) return false;
        return !sleeps || search.has(A, SearchFlag::searched) || search.has(B, SearchFlag::searched);
    }
};

/// Calls each(A, B) for every pair of shapes whose fat AABBs overlap, A < B, in the order of slots, whatever the search.
/// Cost: that of a search, and for a shape with very many neighbours one for each NextNeighbours::room of them.
template <class Tree, class Each>
void for_near_pairs(const SearchView& search, const Tree& tree, const PairsOfInterest& of_interest, const Each& each) {
    // bound: max_bodies max_shapes_of_body, rounded up to whole tiles
    for (int A = 0; A < search.shapes.tile_count * lanes; ++A) {
        const TreeBox box = trees::box_of(search.bounds, A);
        if (!(box.low.x <= box.high.x)) continue;
        bool more = true;
        // bound: max_bodies max_shapes_of_body / NextNeighbours::room: after grows each turn
        for (int after = A; more;) {
            const NextNeighbours next = next_neighbours(search, tree, A, after);
            // bound: NextNeighbours::room
            for (int i = 0; i < next.count; ++i)
                if (of_interest.has(search, A, next.slots[i])) each(A, static_cast<int>(next.slots[i]));
            more = next.is_full();
            if (more) after = next.slots[NextNeighbours::room - 1];
        }
    }
}

/// Pairs that were held in the step before, sorted by key.
struct HeldPairs {
    const BodyPair* pairs;
    int count;
};

/// After a search that found more pairs than there is room for: the list holds those that matter most, sorted, without records; the others are lost.
/// Those that are held give way to what is deeper by limits::crowd_patience alone.
template <class Tree>
void keep_urgent_pairs(const SearchView& search, const Tree& tree, const PairsOfInterest& of_interest, const HeldPairs& held, const PairList& list);

} }  // namespace ingot
