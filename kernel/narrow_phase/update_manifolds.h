// SPDX-License-Identifier: MIT
// The narrow phase of a step: over all pairs that may touch.
#pragma once

#include "find_level_manifolds.h"

namespace ingot { inline namespace INGOT_ABI {

/// Manifolds of all pairs of the last search, those of the step before renewed; manifolds.pairs are those that touch.
///
/// Pairs that the rules of the scene keep apart have none: see pair_rules.h.
/// Pairs with a fast body touch or have none.
/// Full: what finds no record is refused_record, and counted in contacts_lost; who it is to be is then chosen anew: see crowded_manifolds.h.
template <class Shapes, bool renews, class Rules, class FastPairs = NoFastPairs>
void update_manifolds(const BodyView& bodies, const SurfaceView& surfaces, const BoundsTile* bounds, scalar h, const Rules& rules,
                      const PairList& found, const ManifoldView& manifolds, StepReport& report, const FastPairs& fast_pairs = {}) {
    *manifolds.count = 0;
    // bound: max_pairs and the pairs of shapes of one body: pairs_with_own of scene.h
    for (int pair_i = 0; pair_i < *found.count; ++pair_i) {
        BodyPair& pair = found.pairs[pair_i];
        const bool has_record = pair.record != no_record;
        const auto overlap = [&] { return shapes_overlap<Shapes>(bodies, surfaces, pair); };
        if (rules.keeps(pair)) {
            if (has_record)
                manifolds.pairs[(*manifolds.count)++] = pair;
            else if (bounds_overlap(bounds, pair.body_A, pair.body_B))
                (void)rules.may_touch(pair, overlap);  // a sensor notes who is in it
            continue;
        }
        if (!bounds_overlap(bounds, pair.body_A, pair.body_B) || !rules.may_touch(pair, overlap)) {
            if (has_record) give_back(manifolds, pair.record);
            continue;
        }
        if (update_level_pair<Shapes, renews>(bodies, surfaces, bounds, h, fast_pairs, found, manifolds, report, pair)) continue;
        const bool fast = fast_pairs.has(pair);
        const scalar margin = fast ? margin_of_fast(bodies, surfaces, pair) : margin_of(bodies, surfaces, bounds, pair, h);
        if constexpr (renews) {
            if (has_record && !fast && !is_led(fast_pairs, pair) &&
                renew_manifold<Shapes>(bodies, surfaces, pair, margin, manifolds.anchors[pair.record], manifolds.records[pair.record].manifold)) {
                manifolds.pairs[(*manifolds.count)++] = pair;
                continue;
            }
        }
        Manifold found_now;
        found_now.halvings = static_cast<uint16_t>(surfaces.halvings(pair.body_A, pair.body_B));
        const Manifold& before = has_record ? manifolds.records[pair.record].manifold : no_manifold_before;
        const Margin search = {margin, limits::fast_margin * scale_of(surfaces.unit, found_now.halvings)};
        if (!find_manifold<Shapes>(bodies, surfaces, pair, search, before, found_now)) count(report.pairs_untested);
        if constexpr (FastPairs::leads_figures)
            if (!fast && fast_pairs.leads(pair)) fast_pairs.template find_on_way<Shapes>(pair, surfaces, found_now);
        if (found_now.count == 0) {
            if (has_record) give_back(manifolds, pair.record);
            continue;
        }
        if (!has_record) pair.record = take_record(manifolds);
        if (pair.record == no_record) {
            count(report.contacts_lost);
            pair.record = refused_record;
            continue;
        }
        ManifoldRecord& record = manifolds.records[pair.record];
        if (has_record)
            carry_impulses(record, found_now);
        else
            mix_materials(surfaces, pair, record);
        keep_manifold(found_now, record.manifold);
        if (renews && worth_renewing(surfaces.surfaces[pair.body_A], surfaces.surfaces[pair.body_B]))
            anchor(frame_of(bodies, pair.body_A), frame_of(bodies, pair.body_B), found_now, margin, manifolds.anchors[pair.record]);
        manifolds.pairs[(*manifolds.count)++] = pair;
    }
    count(report.contacts_lost, *found.lost);
}

} }  // namespace ingot
