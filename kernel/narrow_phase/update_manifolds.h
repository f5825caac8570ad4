// SPDX-License-Identifier: MIT
// The narrow phase of a step: over all pairs that may touch.
#pragma once

#include "../base/workers.h"
#include "find_level_manifolds.h"

namespace ingot { inline namespace INGOT_ABI {

/// What became of a pair whose contact was looked at before the others' turn came: see look_ahead.
enum class PairOutcome : uint8_t {
    unknown,  ///< nothing was done
    none,     ///< it does not touch
    kept,     ///< its record holds the manifold of this step; of the first pair with a level, those of all its companions do
};
/// Of scenes that look at one pair after the other.
struct NoOutcomes {
    static constexpr PairOutcome of(int) { return PairOutcome::unknown; }
};
struct PairOutcomes {
    PairOutcome* by_pair;
    PairOutcome of(int pair_i) const { return by_pair[pair_i]; }
};

/// How the manifold of a pair is found that may touch. Writes to nothing but the record of the pair.
template <class Shapes, bool renews, class FastPairs>
struct PairUpdate {
    const BodyView& bodies;
    const SurfaceView& surfaces;
    const BoundsTile* bounds;
    scalar h;
    const ManifoldView& manifolds;
    const FastPairs& fast_pairs;

    scalar margin_of_pair(const BodyPair& pair, bool fast) const {
        return fast ? margin_of_fast(bodies, surfaces, pair) : margin_of(bodies, surfaces, bounds, pair, h);
    }
    /// True where the manifold of the step before was moved along.
    bool renew(const BodyPair& pair, bool has_record, bool fast, scalar margin) const {
        if constexpr (renews)
            return has_record && !fast && !is_led(fast_pairs, pair) &&
                   renew_manifold<Shapes>(bodies, surfaces, pair, margin, manifolds.anchors[pair.record], manifolds.records[pair.record].manifold);
        return false;
    }
    /// False for shapes that there is no test for.
    bool find(const BodyPair& pair, bool has_record, scalar margin, Manifold& found_now) const {
        found_now.halvings = static_cast<uint16_t>(surfaces.halvings(pair.body_A, pair.body_B));
        const Manifold& before = has_record ? manifolds.records[pair.record].manifold : no_manifold_before;
        const Margin search = {margin, limits::fast_margin * scale_of(surfaces.unit, found_now.halvings)};
        return find_manifold<Shapes>(bodies, surfaces, pair, search, before, found_now);
    }
    /// The record becomes that of this step.
    void keep(const BodyPair& pair, bool has_record, scalar margin, const Manifold& found_now) const {
        ManifoldRecord& record = manifolds.records[pair.record];
        if (has_record)
            carry_impulses(record, found_now);
        else
            mix_materials(surfaces, pair, record);
        keep_manifold(found_now, record.manifold);
        if (renews && worth_renewing(surfaces.surfaces[pair.body_A], surfaces.surfaces[pair.body_B]))
            anchor(frame_of(bodies, pair.body_A), frame_of(bodies, pair.body_B), found_now, margin, manifolds.anchors[pair.record]);
    }
};

/// For pairs [range.begin .. range.end) that need no room and tell nobody: what update_manifolds would do to them, noted in `outcomes`. Ranges may be
/// looked at side by side. Pairs with sensors and fast bodies are left to update_manifolds, and so are those that begin to touch or end.
template <class Shapes, bool renews, class Rules, class FastPairs>
void look_ahead(const PairUpdate<Shapes, renews, FastPairs>& update, const Rules& rules, const PairList& found, TaskRange range,
                const PairOutcomes& outcomes) {
    for (int pair_i = range.begin; pair_i < range.end; ++pair_i) {  // bound: pairs_with_own of scene.h
        const BodyPair& pair = found.pairs[pair_i];
        const bool has_record = pair.record != no_record;
        PairOutcome& outcome = outcomes.by_pair[pair_i];
        outcome = PairOutcome::unknown;
        if (pair.record == refused_record || rules.keeps(pair) || !rules.tells_nobody(pair)) continue;
        if (!bounds_overlap(update.bounds, pair.body_A, pair.body_B)) {
            outcome = PairOutcome::none;
            continue;
        }
        if (update.fast_pairs.has(pair) || is_led(update.fast_pairs, pair)) continue;
        const scalar margin = update.margin_of_pair(pair, false);
        if constexpr (Shapes::has(ShapeKind::level)) {
            if (is_with_level(update.surfaces, pair)) {
                StepReport nothing_is_lost;
                const LevelPairs<Shapes, renews> levels = {update.bodies, update.surfaces, found, update.manifolds, nothing_is_lost};
                if (is_first_of_level(update.surfaces, pair) && levels.update_ahead(found.pairs[pair_i], margin)) outcome = PairOutcome::kept;
                continue;
            }
        }
        if (update.renew(pair, has_record, false, margin)) {
            outcome = PairOutcome::kept;
            continue;
        }
        Manifold found_now;
        if (!update.find(pair, has_record, margin, found_now)) continue;
        if (found_now.count == 0) {
            outcome = PairOutcome::none;
        } else if (has_record) {
            update.keep(pair, true, margin, found_now);
            outcome = PairOutcome::kept;
        }
    }
}

/// Manifolds of all pairs of the last search, those of the step before renewed; manifolds.pairs are those that touch.
///
/// Pairs that the rules of the scene keep apart have none: see pair_rules.h.
/// Pairs with a fast body touch or have none.
/// Full: what finds no record is refused_record, and counted in contacts_lost; who it is to be is then chosen anew: see crowded_manifolds.h.
template <class Rules, class Shapes, bool renews, class FastPairs, class Outcomes = NoOutcomes>
void update_manifolds(const PairUpdate<Shapes, renews, FastPairs>& update, const Rules& rules, const PairList& found, StepReport& report,
                      const Outcomes& outcomes = {}) {
    const ManifoldView& manifolds = update.manifolds;
    const FastPairs& fast_pairs = update.fast_pairs;
    *manifolds.count = 0;
    // bound: max_pairs and the pairs of shapes of one body: pairs_with_own of scene.h
    for (int pair_i = 0; pair_i < *found.count; ++pair_i) {
        BodyPair& pair = found.pairs[pair_i];
        const bool has_record = pair.record != no_record;
        const PairOutcome outcome = outcomes.of(pair_i);
        if (outcome == PairOutcome::kept) {
            if (pair.record < refused_record) manifolds.pairs[(*manifolds.count)++] = pair;
            continue;
        }
        const auto overlap = [&] {
            if constexpr (Shapes::has(ShapeKind::level))  // one of its shapes stands for all of it
                if (is_with_level(update.surfaces, pair) && !is_first_of_level(update.surfaces, pair)) return false;
            return shapes_overlap<Shapes>(update.bodies, update.surfaces, pair);
        };
        if (outcome == PairOutcome::unknown && rules.keeps(pair)) {
            if (has_record)
                manifolds.pairs[(*manifolds.count)++] = pair;
            else if (bounds_overlap(update.bounds, pair.body_A, pair.body_B))
                (void)rules.may_touch(pair, overlap);  // a sensor notes who is in it
            continue;
        }
        if (outcome == PairOutcome::none || !bounds_overlap(update.bounds, pair.body_A, pair.body_B) || !rules.may_touch(pair, overlap)) {
            if (has_record) give_back(manifolds, pair.record);
            continue;
        }
        if (update_level_pair<Shapes, renews>(update.bodies, update.surfaces, update.bounds, update.h, fast_pairs, found, manifolds, report, pair))
            continue;
        const bool fast = fast_pairs.has(pair);
        const scalar margin = update.margin_of_pair(pair, fast);
        if (update.renew(pair, has_record, fast, margin)) {
            manifolds.pairs[(*manifolds.count)++] = pair;
            continue;
        }
        Manifold found_now;
        if (!update.find(pair, has_record, margin, found_now)) count(report.pairs_untested);
        if constexpr (FastPairs::leads_figures)
            if (!fast && fast_pairs.leads(pair)) fast_pairs.template find_on_way<Shapes>(pair, update.surfaces, found_now);
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
        update.keep(pair, has_record, margin, found_now);
        manifolds.pairs[(*manifolds.count)++] = pair;
    }
    count(report.contacts_lost, *found.lost);
}

} }  // namespace ingot
