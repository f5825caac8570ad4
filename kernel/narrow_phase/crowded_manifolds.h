// SPDX-License-Identifier: MIT
// Where more pairs touch than there are records: those that matter most have one.
#pragma once

#include "../broad_phase/crowd.h"
#include "find_manifolds.h"

namespace ingot { inline namespace INGOT_ABI {

/// Who can move, by shape: of compounds the body that it lies on.
struct CrowdBodies {
    BodyView bodies;
    SurfaceView surfaces;
    scalar h;
    int shapes_of_body;

    int body_of(int shape_slot) const { return shape_slot / shapes_of_body; }
    /// How urgent a contact is: who meets what cannot move, and touches it within the step, comes first; then by how deep it will be at its end.
    /// carries: it has borne something in the step before.
    Index rank_of_contact(const BodyPair& pair, const Manifold& manifold, bool carries) const;
};

inline bool has_free_record(const ManifoldView& manifolds) { return *manifolds.first_free != 0 || *manifolds.records_used < manifolds.capacity; }

/// The records of the step as a heap. Ranks stand in next_free, which is free while a record is not, until close().
class FullRecords {
public:
    template <class Kept>
    FullRecords(const CrowdBodies& crowd, const ManifoldView& manifolds, const PairList& found, const Kept& kept)
        : manifolds_(manifolds), found_(found) {
        for (int i = 0; i < *manifolds.count; ++i) {  // bound: max_manifolds
            const BodyPair& pair = manifolds.pairs[i];
            ManifoldRecord& record = manifolds.records[pair.record];
            record.next_free = kept(pair) ? rank_of_kept : crowd.rank_of_contact(pair, record.manifold, load_of(record) > 0);
        }
        heap().make();
    }

    /// Takes the record of the pair that gives way, if there is one that is less urgent. False: the pair stays refused.
    bool make_room(const BodyPair& pair, Index rank) const;
    /// The pair has a record, and its rank in it.
    void take_place(const BodyPair& pair) const { heap().replace_top(pair); }
    /// The list is sorted again.
    void close() const;

private:
    struct RankOnRecord {
        const ManifoldRecord* records;
        Index operator()(const BodyPair& pair) const { return records[pair.record].next_free; }
    };
    FullList<RankOnRecord> heap() const { return {manifolds_.pairs, *manifolds_.count, {manifolds_.records}}; }

    ManifoldView manifolds_;
    PairList found_;
};

/// The manifold of a pair that was refused, as update_manifolds found it.
template <class Shapes, class FastPairs>
void find_refused(const BodyView& shapes, const SurfaceView& surfaces, const BoundsTile* bounds, scalar h, const FastPairs& fast_pairs,
                  const BodyPair& pair, Manifold& manifold, scalar& margin) {
    margin = fast_pairs.has(pair) ? margin_of_fast(shapes, surfaces, pair) : margin_of(shapes, surfaces, bounds, pair, h);
    manifold.halvings = static_cast<uint16_t>(surfaces.halvings(pair.body_A, pair.body_B));
    const Margin search = {margin, limits::fast_margin * scale_of(surfaces.unit, manifold.halvings)};
    (void)find_manifold<Shapes>(shapes, surfaces, pair, search, no_manifold_before, manifold);
}

/// After update_manifolds refused some: records go to those that are most urgent of all that touch, and the others are refused_record. What has been
/// held, and still is, keeps what it knows. kept(pair): it does not give way.
///
/// refused: how many; less those that find a record that another pair has given back.
/// Cost: the manifold of each that was refused, and a place in a heap.
template <class Shapes, bool renews, class Kept, class FastPairs>
[[gnu::cold]] void keep_urgent_manifolds(const CrowdBodies& crowd, const BodyView& shapes, const BoundsTile* bounds, const PairList& found,
                                         const ManifoldView& manifolds, const Kept& kept, const FastPairs& fast_pairs, Index& refused) {
    const auto begin = [&](BodyPair& pair, const Manifold& manifold, scalar margin) {
        begin_record<renews>(shapes, crowd.surfaces, pair, manifold, margin, manifolds);
    };
    const auto find = [&](const BodyPair& pair, Manifold& manifold, scalar& margin) {
        find_refused<Shapes>(shapes, crowd.surfaces, bounds, crowd.h, fast_pairs, pair, manifold, margin);
    };
    // Records that were given back after the first was refused.
    // bound: pairs_with_own of scene.h
    for (int pair_i = 0; pair_i < *found.count && has_free_record(manifolds); ++pair_i) {
        BodyPair& pair = found.pairs[pair_i];
        if (pair.record != refused_record) continue;
        Manifold manifold;
        scalar margin = 0;
        find(pair, manifold, margin);
        pair.record = take_record(manifolds);
        begin(pair, manifold, margin);
        manifolds.pairs[(*manifolds.count)++] = pair;
        --refused;
    }
    const FullRecords full(crowd, manifolds, found, kept);
    // bound: pairs_with_own of scene.h
    for (int pair_i = 0; pair_i < *found.count; ++pair_i) {
        BodyPair& pair = found.pairs[pair_i];
        if (pair.record != refused_record) continue;
        Manifold manifold;
        scalar margin = 0;
        find(pair, manifold, margin);
        const Index rank = crowd.rank_of_contact(pair, manifold, false);
        if (!full.make_room(pair, rank)) continue;
        pair.record = take_record(manifolds);
        begin(pair, manifold, margin);
        manifolds.records[pair.record].next_free = rank;
        full.take_place(pair);
    }
    full.close();
}

} }  // namespace ingot
