// SPDX-License-Identifier: MIT
// The adaptors of stages.h for arrays that are full: who is kept, and what becomes of the others. A step that has room for all it meets passes by.
#pragma once

#include "../continuous/fast_pairs.h"
#include "../impulse/find_contacts.h"
#include "../impulse/hold_apart.h"
#include "../narrow_phase/crowded_manifolds.h"
#include "kinematic_stages.h"

namespace ingot { inline namespace INGOT_ABI {

template <class S>
void place_shapes(Step<S>& now);

template <class S>
constexpr PairsOfInterest pairs_of_interest() {
    return {S::max_shapes_of_body, S::sleeps};
}

/// After a search that found more pairs than there is room for.
template <class S>
[[gnu::noinline, gnu::cold]] void choose_pairs(Step<S>& now) {
    auto& storage = now.storage;
    keep_urgent_pairs(storage.search_view(), storage.tree_of_bounds(), pairs_of_interest<S>(), {storage.pairs, storage.manifold_count},
                      storage.pair_list());
}

/// The step has done with those that found no room.
inline void forget_refused(const PairList& found) {
    // bound: pairs_with_own of scene.h
    for (int pair_i = 0; pair_i < *found.count; ++pair_i)
        if (found.pairs[pair_i].record == refused_record) found.pairs[pair_i].record = no_record;
}

/// Both are asleep and stay where they are.
template <class S>
bool rests([[maybe_unused]] Storage<S>& storage, [[maybe_unused]] const BodyPair& pair) {
    if constexpr (S::sleeps) {
        const RestView rest = storage.rest_view();
        return !rest.is_active(rest.body_of(pair.body_A)) && !rest.is_active(rest.body_of(pair.body_B));
    }
    return false;
}

/// Calls each(pair, manifold) for all that touch, or are about to, and have no record: those that the list holds, and those that it does not.
template <class S, class Fast, class Each>
[[gnu::cold]] void for_refused(Step<S>& now, const SurfaceView& surfaces, const Fast& fast_pairs, const Each& each) {
    auto& storage = now.storage;
    const PairList found = storage.pair_list();
    const auto meet = [&](const BodyPair& pair) {
        Manifold manifold;
        scalar margin = 0;
        find_refused<ShapesOf<S>>(storage.shapes(), surfaces, storage.bounds, now.h, fast_pairs, pair, manifold, margin);
        if (manifold.count != 0 && !(fast_pairs.has(pair) && fast_pairs.meets_hard(pair, manifold))) each(pair, manifold);
    };
    // bound: pairs_with_own of scene.h
    for (int pair_i = 0; pair_i < *found.count; ++pair_i)
        if (found.pairs[pair_i].record == refused_record) meet(found.pairs[pair_i]);
    if (*found.lost == 0) return;
    for_near_pairs(storage.search_view(), storage.tree_of_bounds(), pairs_of_interest<S>(), [&](int A, int B) {
        const BodyPair pair = {static_cast<Index>(A), static_cast<Index>(B), refused_record};
        if (place_in(found.pairs, *found.count, pair.key()) >= 0 || !storage.can_meet(A, B) || !bounds_overlap(storage.bounds, A, B)) return;
        if (!rests(storage, pair)) meet(pair);
    });
}

/// Who meets what sleeps wakes it, as it does by a manifold.
template <class S, class Fast>
[[gnu::cold]] void wake_refused([[maybe_unused]] Step<S>& now, [[maybe_unused]] const SurfaceView& surfaces,
                                [[maybe_unused]] const Fast& fast_pairs) {
    if constexpr (S::sleeps) {
        auto& storage = now.storage;
        for_refused(now, surfaces, fast_pairs, [&](const BodyPair& pair, const Manifold&) {
            const RestView rest = storage.rest_view();
            const int A = rest.body_of(pair.body_A), B = rest.body_of(pair.body_B);
            if (rest.is_awake(A) == rest.is_awake(B)) return;
            const int met = rest.is_awake(A) ? B : A;
            if (is_dynamic(now.bodies, met)) wake_by(storage, [&](const ManifoldView& manifolds) { wake_island(now.bodies, rest, manifolds, met); });
        });
    }
}

template <class S>
HeldStep held_step(const Step<S>& now, bool is_over) {
    return {now.bodies, now.h, limits::push_speed_max * S::length_unit * now.h, is_over};
}

/// Of two bodies that have been moved.
template <class S>
void place_shapes_of([[maybe_unused]] Step<S>& now, [[maybe_unused]] int A, [[maybe_unused]] int B) {
    if constexpr (has_compounds<S>) {
        place_shapes(now.bodies, now.storage.compound_view(), A);
        place_shapes(now.bodies, now.storage.compound_view(), B);
    }
}

/// Bodies whose contacts have no room do not fall through each other: see hold_apart.h. They stay awake.
template <class S>
struct HoldRefused {
    Step<S>& now;
    bool is_over;
    bool on_fixed;  ///< now those that meet what cannot move, now the others

    void operator()(const BodyPair& pair, const Manifold& manifold) const {
        auto& storage = now.storage;
        const int A = pair.body_A / S::max_shapes_of_body, B = pair.body_B / S::max_shapes_of_body;
        if (meets_fixed(now.bodies, A, B) != on_fixed) return;
        TouchPoints points;
        points.n = manifold.n;
        points.count = manifold.count;
        points.mu = sqrt(storage.surfaces[pair.body_A].mu * storage.surfaces[pair.body_B].mu);
        for (int i = 0; i < manifold.count; ++i) {  // bound: 4: Manifold::points_max
            points.P[i] = manifold.points[i].P;
            points.separation[i] = manifold.points[i].separation;
        }
        const scalar separation = hold_apart(held_step(now, is_over), A, B, points);
        place_shapes_of(now, A, B);
        if constexpr (S::sleeps)
            if (separation < limits::touching_gap * scale_of(S::length_unit, manifold.halvings)) storage.rest_time[A] = storage.rest_time[B] = 0;
    }
};

/// What meets what cannot move is seen to last: it is at rest then.
template <class S, class Fast>
[[gnu::cold]] void hold_all_refused(Step<S>& now, const SurfaceView& surfaces, const Fast& fast_pairs, bool is_over) {
    for_refused(now, surfaces, fast_pairs, HoldRefused<S>{now, is_over, false});
    for_refused(now, surfaces, fast_pairs, HoldRefused<S>{now, is_over, true});
}

/// Where update_manifolds has refused some, or pairs are lost: those that matter most have records, and the others are stopped.
template <class S, class Fast>
[[gnu::noinline, gnu::cold]] void choose_manifolds(Step<S>& now, [[maybe_unused]] const SurfaceView& surfaces,
                                                   [[maybe_unused]] const Fast& fast_pairs) {
    auto& storage = now.storage;
    if constexpr (!can_be_crowded<S>) {
        forget_refused(storage.pair_list());
    } else {
        const CrowdBodies crowd = {now.bodies, surfaces, now.h, S::max_shapes_of_body};
        keep_urgent_manifolds<ShapesOf<S>, renews_manifolds<S>>(
            crowd, storage.shapes(), storage.bounds, storage.pair_list(), storage.manifold_view(),
            [&](const BodyPair& pair) { return rests(storage, pair); }, fast_pairs, now.report.contacts_lost);
        wake_refused(now, surfaces, fast_pairs);
        hold_all_refused(now, surfaces, fast_pairs, false);
    }
}

/// Nothing has been pushed into what cannot move: bodies that may have come to it are put back on it, whether or not their contact has a record.
/// Joints and impacts within the step take bodies where nobody expected them.
template <class S, class Fast>
[[gnu::cold]] void free_of_fixed(Step<S>& now, const SurfaceView& surfaces, const Fast& fast_pairs) {
    auto& storage = now.storage;
    const PairList found = storage.pair_list();
    // bound: pairs_with_own of scene.h
    for (int pair_i = 0; pair_i < *found.count; ++pair_i) {
        const BodyPair& pair = found.pairs[pair_i];
        const int A = pair.body_A / S::max_shapes_of_body, B = pair.body_B / S::max_shapes_of_body;
        if (!meets_fixed(now.bodies, A, B) || rests(storage, pair)) continue;
        Manifold manifold;
        scalar margin = 0;
        find_refused<ShapesOf<S>>(storage.shapes(), surfaces, storage.bounds, now.h, fast_pairs, pair, manifold, margin);
        if (manifold.count == 0) continue;
        const scalar slack = limits::touching_gap * scale_of(S::length_unit, manifold.halvings);
        push_out(held_step(now, true), A, B, manifold.n, -least_separation(manifold) - slack);
        place_shapes_of(now, A, B);
    }
}

/// False where contacts_lost counts those of a fast body on its way, and no others.
template <class S>
bool has_refused(Step<S>& now) {
    const PairList found = now.storage.pair_list();
    bool refused = *found.lost != 0;
    // bound: pairs_with_own of scene.h
    for (int pair_i = 0; pair_i < *found.count && !refused; ++pair_i) refused = found.pairs[pair_i].record == refused_record;
    return refused;
}

/// After bodies have been moved: see hold_apart.h.
template <class S, class Fast>
[[gnu::noinline, gnu::cold]] void hold_refused(Step<S>& now, const SurfaceView& surfaces, const Fast& fast_pairs) {
    place_shapes(now);
    if (has_refused(now)) as_kinematic_bodies_moved(now, [&] { hold_all_refused(now, surfaces, fast_pairs, true); });
    free_of_fixed(now, surfaces, fast_pairs);
    forget_refused(now.storage.pair_list());
}

/// Of scenes of impacts without friction: one of a pair that has more points than the array holds of it.
template <class S>
void hold_lost_pair(Step<S>& now, int slot_A, int slot_B) {
    const SurfaceView surfaces = now.storage.surface_view();
    Contact found[TouchPoints::points_max];
    Index found_count = 0, lost = 0;
    StepReport of_pair;
    ContactSink sink{{found, &found_count, TouchPoints::points_max}, slot_A, slot_B, 0, &lost};
    collide_pair<typename S::shapes>(placed(now.bodies, surfaces, slot_A), placed(now.bodies, surfaces, slot_B), sink, of_pair);
    if (found_count > kept_contacts(now.storage.contact_view(), slot_A, slot_B))
        (void)hold_apart({now.bodies, now.h, 0, true}, slot_A, slot_B, touch_points(now.bodies, found, found_count));
}

/// What has no room is held as after the step before, which is now.
/// Cost: as find_contacts, twice, and a look at the array for each pair that touches.
template <class S>
[[gnu::noinline, gnu::cold]] void hold_lost_contacts(Step<S>& now) {
    const SurfaceView surfaces = now.storage.surface_view();
    for (int pass_i = 0; pass_i < 2; ++pass_i)
        for (int slot_A = 0; slot_A < surfaces.slot_count; ++slot_A) {  // bound: max_bodies
            // bound: max_bodies: next_touchable returns no less than what it is given
            for (int slot_B = next_touchable(now.bodies, surfaces, {}, slot_A, slot_A + 1); slot_B < surfaces.slot_count;
                 slot_B = next_touchable(now.bodies, surfaces, {}, slot_A, slot_B + 1)) {
                if (meets_fixed(now.bodies, slot_A, slot_B) != (pass_i == 1)) continue;
                const bool swap = surfaces.surfaces[slot_A].shape.kind == ShapeKind::half_space;
                hold_lost_pair(now, swap ? slot_B : slot_A, swap ? slot_A : slot_B);
            }
        }
}

} }  // namespace ingot
