// SPDX-License-Identifier: MIT
#include "manifold_record.h"

namespace ingot { inline namespace INGOT_ABI {

void match_records(const ManifoldView& manifolds, const PairList& found) {
    int found_i = 0;
    for (int held_i = 0; held_i < *manifolds.count; ++held_i) {  // bound: max_manifolds
        BodyPair& held = manifolds.pairs[held_i];
        // bound: pairs_with_own of scene.h: over the whole walk: found_i only grows
        while (found_i < *found.count && found.pairs[found_i].key() < held.key()) ++found_i;
        if (found_i < *found.count && found.pairs[found_i].key() == held.key())
            found.pairs[found_i].record = held.record;
        else
            give_back(manifolds, held.record);
    }
}

Index take_record(const ManifoldView& manifolds) {
    Index record = no_record;
    if (*manifolds.first_free != 0) {
        record = static_cast<Index>(*manifolds.first_free - 1);
        *manifolds.first_free = manifolds.records[record].next_free;
    } else if (*manifolds.records_used < manifolds.capacity) {
        record = (*manifolds.records_used)++;
    } else {
        return no_record;
    }
    manifolds.records[record] = {};
    if (manifolds.anchors != nullptr) manifolds.anchors[record] = {};  // balls keep none, and those of another pair are none of a snapshot's
    return record;
}

void give_back(const ManifoldView& manifolds, Index& record) {
    manifolds.records[record].next_free = *manifolds.first_free;
    *manifolds.first_free = static_cast<Index>(record + 1);
    record = no_record;
}

void invalidate_contacts(const ManifoldView& manifolds, const PairList& found, BoundsTile* bounds, int slot) {
    // bound: max_pairs and the pairs of shapes of one body: pairs_with_own of scene.h
    for (int pair_i = 0; pair_i < *found.count; ++pair_i) {
        BodyPair& pair = found.pairs[pair_i];
        if (pair.body_A == slot || pair.body_B == slot) pair.record = no_record;
    }
    // Records are given back from the list of those that touch: after a snapshot was loaded, nothing has been searched for yet.
    int kept = 0;
    for (int pair_i = 0; pair_i < *manifolds.count; ++pair_i) {
        BodyPair pair = manifolds.pairs[pair_i];
        if (pair.body_A == slot || pair.body_B == slot)
            give_back(manifolds, pair.record);
        else
            manifolds.pairs[kept++] = pair;
    }
    *manifolds.count = static_cast<Index>(kept);
    invalidate_bounds(bounds, slot);
}

void mix_materials_of(const SurfaceView& surfaces, const ManifoldView& manifolds, int shape_slot) {
    for (int pair_i = 0; pair_i < *manifolds.count; ++pair_i) {  // bound: max_manifolds
        const BodyPair& pair = manifolds.pairs[pair_i];
        if (pair.body_A == shape_slot || pair.body_B == shape_slot) mix_materials(surfaces, pair, manifolds.records[pair.record]);
    }
}

void keep_manifold(const Manifold& found, Manifold& kept) {
    kept.n = found.n;
    kept.count = found.count;
    kept.halvings = found.halvings;
    // bound: 4: Manifold::points_max
    for (int point_i = 0; point_i < Manifold::points_max; ++point_i) {
        const ManifoldPoint point = point_i < found.count ? found.points[point_i] : ManifoldPoint{};
        kept.points[point_i].P = point.P;  // by members: with doubles a point has a gap, which would take bytes of the stack along
        kept.points[point_i].separation = point.separation;
        kept.points[point_i].feature = point.feature;
    }
}

void carry_impulses(ManifoldRecord& record, const Manifold& next) {
    const Manifold& before = record.manifold;
    bool same = next.count == before.count;
    // bound: 4: Manifold::points_max
    for (int point_i = 0; point_i < before.count; ++point_i) same = same && before.points[point_i].feature == next.points[point_i].feature;
    if (same) return;
    scalar j[Manifold::points_max] = {}, j_before[Manifold::points_max] = {};
    // bound: 4: Manifold::points_max
    for (int point_i = 0; point_i < next.count; ++point_i) {
        for (int old_i = 0; old_i < before.count; ++old_i) {
            if (before.points[old_i].feature != next.points[point_i].feature) continue;
            j[point_i] = record.j[old_i];
            j_before[point_i] = record.j_before[old_i];
        }
    }
    for (int point_i = 0; point_i < Manifold::points_max; ++point_i) {
        record.j[point_i] = j[point_i];
        record.j_before[point_i] = j_before[point_i];
    }
}

} }  // namespace ingot
