// SPDX-License-Identifier: MIT
// The adaptors between step() and the stages: one a line of step(), in its order. Here, and in schemes.h, a scene is asked what it names; a stage
// whose feature it does not name is empty. Stages themselves work on views and know no scene.
#pragma once

#include "../motion/integrate_L.h"
#include "../narrow_phase/level_seams.h"
#include "../narrow_phase/update_manifolds.h"
#include "fast_stages.h"
#include "impact_stages.h"
#include "kinematic_stages.h"
#include "lock_stages.h"

namespace ingot { inline namespace INGOT_ABI {

/// False for an h that is no step: nothing changes then.
template <class S>
bool accepts_step(Step<S>& now) {
    now.report.status = check_step(now.h);
    return now.report.status == Status::ok;
}

/// Another field is felt by all bodies. Its numbers are compared, not who asked for them: to read them wakes nobody.
template <class S>
void notice_field([[maybe_unused]] Step<S>& now) {
    if constexpr (has_field<S> && S::sleeps) {
        auto& storage = now.storage;
        if (features::SteadyField::changed(storage))
            wake_by(storage, [&](const ManifoldView& manifolds) { wake_all(now.bodies, storage.rest_view(), manifolds); });
        storage.field_changed = 0;
        INGOT_COPY_BYTES(static_cast<void*>(&storage.field_before), static_cast<const void*>(&storage.field), sizeof storage.field);
    }
}

/// True where nothing moves, kinematic bodies included: the step is counted, and leaves the world as it was.
template <class S>
bool passes_asleep([[maybe_unused]] Step<S>& now) {
    begin_kinematic_motion(now);
    if constexpr (has_joint_breaking<S>) features::BreakableJoints::begin_step(now.storage);
    if constexpr (S::sleeps) {
        auto& storage = now.storage;
        notice_field(now);
        // Pairs that were lost are searched for again, without those that rest by now.
        if (storage.rest_view().active.any() || storage.bounds_are_made == 0 || storage.pairs_lost != 0) return false;
        if constexpr (has_events<S>) (void)storage.begin_events(now.report);
        (void)storage.energy_unit(now.h);
        count(now.report.contacts, storage.aside_count);
        if constexpr (has_field<S>) storage.advance_time(now.h);
        ++storage.steps;
        return true;
    }
    return false;
}

/// Shapes of bodies that have several go where their bodies are.
template <class S>
void place_shapes([[maybe_unused]] Step<S>& now) {
    if constexpr (has_compounds<S> && S::sleeps)
        now.storage.place_active_shapes();
    else if constexpr (has_compounds<S>)
        now.storage.place_all_shapes();
}

/// Calls each(slot) for the bodies that are looked at in a step: all, or those that are awake or settling.
template <class S, class Each>
INGOT_INLINE void over_active_bodies(Step<S>& now, const Each& each) {
    if constexpr (S::sleeps)
        for_active(now.storage.rest_view(), each);
    else
        EveryBody{now.storage.slots_used}.for_each(each);
}

/// The surfaces of the step, which know how far gravity moves a body in it. Fields, and shares of gravity, may move it further: then any way counts.
template <class S>
SurfaceView surfaces_of(const Step<S>& now) {
    SurfaceView surfaces = now.storage.surface_view();
    surfaces.fall = has_field<S> || S::gravity_shares ? limits::unbounded : sqrt(length_sq(now.storage.gravity)) * now.h * now.h;
    return surfaces;
}
template <class S>
SearchView search_of(const Step<S>& now) {
    SearchView search = now.storage.search_view();
    search.surfaces = surfaces_of(now);
    return search;
}

/// Bounds of the shapes that are looked at, where several cores work: true then.
template <class S>
bool bound_side_by_side([[maybe_unused]] Step<S>& now, [[maybe_unused]] const SearchView& search) {
    if constexpr (shares_work<S>) {
        constexpr int least = (limits::bodies_of_task + lanes - 1) / lanes;
        over_ranges<typename S::workers>(S::sleeps ? now.bodies.tile_count : search.shapes.tile_count, least, [&](int, const TaskRange& tiles) {
            if constexpr (S::sleeps)
                bound_active_shapes(search, now.storage.rest_view(), now.h, tiles);
            else
                bound_shapes(search, now.h, tiles);
        });
    }
    return shares_work<S>;
}
/// The search where none do.
template <class S>
bool search_all(Step<S>& now, const SearchView& search, const PairList& pairs) {
    const If<has_only_balls<S>, BallSearchView, SearchView> shapes{search};
    return now.storage.search(shapes, now.h, pairs, bound_side_by_side(now, search));
}

/// The search in scenes whose bodies sleep: it looks at what is active, and the first one after a world began or was loaded at all. True when the
/// list has changed.
template <class S>
bool search_awake(Step<S>& now, const PairList& pairs) {
    auto& storage = now.storage;
    const SearchView search = search_of(now);
    const RestView rest = storage.rest_view();
    bool changed = *pairs.lost > 0;
    if (storage.bounds_are_made == 0) {
        make_all_bounds(search, rest, storage.sensor_marks(), now.h);
        storage.find_pairs(search, pairs);
        storage.bounds_are_made = 1;
        changed = true;
    } else if (const int due = refresh_active_bounds(search, rest, now.h, storage.due_shapes(), bound_side_by_side(now, search)); due > 0) {
        if (!changed) storage.find_due_pairs(search, due, pairs);
        changed = true;
    }
    if (*pairs.lost > 0) {
        shrink_bounds(search.shapes, search.bounds);
        storage.find_pairs(search, pairs);
    }
    return changed;
}

/// Bounds of the step, and the pairs that may touch in it.
///
/// As a rule they are those of the last search, by fat AABBs, and some more. Where these have no room, pairs are searched for in every step, by its
/// bounds alone: so what is lost does not depend on when fat AABBs were made, which a snapshot does not hold.
template <class S>
void find_pairs([[maybe_unused]] Step<S>& now) {
    if constexpr (stacks<S>) {
        auto& storage = now.storage;
        const PairList pairs = storage.pair_list();
        bool changed = false;
        if constexpr (S::sleeps)
            changed = search_awake(now, pairs);
        else
            changed = search_all(now, search_of(now), pairs);
        if (!changed) return;
        if (can_be_crowded<S> && *pairs.lost != 0) choose_pairs(now);
        if constexpr (has_compounds<S>) drop_pairs_of_one_body<S::max_shapes_of_body>(pairs);
        match_records(storage.manifold_view(), pairs);
    }
}

/// Which bodies begin the step fast; and which pairs are too fast for it.
template <class S>
auto find_fast_pairs([[maybe_unused]] Step<S>& now) {
    if constexpr (S::continuous) {
        auto& storage = now.storage;
        const BodyShapes shapes = storage.body_shapes();
        over_active_bodies(
            now, [&](int slot) { storage.paths[slot].fast = begins_fast(now.bodies, shapes, now.h, slot) && !has_joints_of(storage, slot); });
        find_fast_kinematic(now, shapes);
        return fast_pairs_of(now, shapes);
    } else {
        return NoFastPairs{};
    }
}

/// As they were found.
template <class S>
auto known_fast_pairs([[maybe_unused]] Step<S>& now) {
    if constexpr (S::continuous && has_joints<S>)
        return fast_pairs_of(now, now.storage.body_shapes());
    else if constexpr (S::continuous)
        return FastPairs{now.bodies, now.storage.body_shapes(), now.storage.paths, now.h};
    else
        return NoFastPairs{};
}

/// The narrow phase: several cores look at most of the pairs before their turn comes.
template <class S, class Update>
void update_manifolds(Step<S>& now, const Update& update) {
    auto& storage = now.storage;
    const auto rules = storage.pair_rules(now.report);
    const PairList found = storage.pair_list();
    if constexpr (shares_work<S>) {
        const PairOutcomes outcomes{storage.pair_outcomes};
        over_ranges<typename S::workers>(*found.count, limits::pairs_of_task,
                                         [&](int, const TaskRange& range) { look_ahead(update, rules, found, range, outcomes); });
        update_manifolds(update, rules, found, now.report, outcomes);
    } else {
        update_manifolds(update, rules, found, now.report);
    }
}

/// Manifolds of the pairs that touch, or are near enough to; sensors note who is in them.
template <class S>
void find_manifolds([[maybe_unused]] Step<S>& now) {
    if constexpr (stacks<S>) {
        auto& storage = now.storage;
        const ManifoldView manifolds = storage.manifold_view();
        if constexpr (has_events<S> && has_sensors<S>) copy_list(storage.overlap_list(), storage.overlap_list_before());
        const SurfaceView surfaces = surfaces_of(now);
        const auto fast_pairs = find_fast_pairs(now);
        const BodyView shapes = storage.shapes();
        const PairUpdate<ShapesOf<S>, renews_manifolds<S>, decltype(fast_pairs)> update = {shapes, surfaces,  storage.bounds,
                                                                                           now.h,  manifolds, fast_pairs};
        update_manifolds(now, update);
        if (now.report.contacts_lost != 0) choose_manifolds(now, surfaces, fast_pairs);
        if constexpr (hides_internal_edges<S>)
            beside_moving_floors(now, [&] {
                drop_hidden_points<ShapesOf<S>>(
                    {storage.shapes(), storage.surface_view(), storage.bounds, hulls_of<S>, storage.velocities_of_shapes()}, storage.pair_list(),
                    storage.last_of_shape, manifolds);
                if constexpr (has_levels<S>)
                    drop_points_at_seams<ShapesOf<S>>(
                        {storage.shapes(), storage.surface_view(), storage.bounds, hulls_of<S>, storage.velocities_of_shapes()}, storage.pair_list(),
                        storage.last_of_shape, manifolds);
            });
        if constexpr (S::continuous) leave_to_flights(fast_pairs, storage.pair_list(), manifolds);
        count(now.report.contacts, *manifolds.count);
        count(now.report.pairs_lost, storage.pairs_lost);
        if constexpr (S::sleeps)
            count(now.report.contacts, storage.aside_count);
        else if constexpr (has_compounds<S>)
            name_bodies<S::max_shapes_of_body>(manifolds, storage.body_pairs);
    }
}

/// Rods and ropes become as long as they were told to be; ropes that stay slack are nothing to the step, and gears of joints that do nothing.
template <class S>
INGOT_INLINE void look_at_ropes([[maybe_unused]] Step<S>& now) {
    if constexpr (has_ties<S>) {
        auto& storage = now.storage;
        look_at_ropes(now.bodies, storage.joint_lists(), storage.joint_ties, storage.joint_slots_used, storage.gravity, S::length_unit, now.h);
        if constexpr (has_joint_reactions<S>)
            for (int joint_i = 0; joint_i < storage.joint_slots_used; ++joint_i)  // bound: max_joints
                if (storage.joint_ties[joint_i].slack != 0) storage.joint_reactions[joint_i] = {};
        if constexpr (has_gears<S>)
            look_at_gears(now.bodies, storage.joint_lists(), storage.joint_gears, storage.joint_ties, storage.joint_slots_used);
    }
}

/// Islands of the step; those that sleep and can meet what moves wake, and the pairs that are to be solved are listed.
template <class S>
void wake_islands([[maybe_unused]] Step<S>& now) {
    look_at_ropes(now);  // of those that hold nothing, no one wakes
    if constexpr (S::sleeps) {
        auto& storage = now.storage;
        const RestView rest = storage.rest_view();
        const ManifoldView manifolds = storage.manifold_view();
        const int in_step = *manifolds.count;
        join_islands(now.bodies, rest, manifolds);
        if constexpr (has_joints<S>) features::Figures::join_islands(storage, false);
        if constexpr (has_joints<S>) features::Figures::wake_joined(storage);
        wake_met_islands(now.bodies, rest, manifolds);
        wake_in_the_way(now);
        sort_in_woken(storage, in_step);
        if (end_settling(storage.search_view(), rest, storage.sensor_marks())) drop_resting_pairs(storage.search_view(), storage.pair_list());
        list_awake_pairs(now.bodies, rest, manifolds, storage.awake_pairs, storage.awake_pair_count);
        keep_carried_awake(now);
    }
}

/// How fast points approach before contacts change it: events tell it.
template <class S>
void note_approaches([[maybe_unused]] Step<S>& now) {
    if constexpr (has_events<S>) note_approaches(now.bodies, now.storage.gravity, now.h, now.storage.moving_manifolds(), now.storage.notes);
}

/// What found no room in the arrays of contacts falls through nothing. No stage moves a body after it: what is locked has its bits.
template <class S>
void hold_what_has_no_room([[maybe_unused]] Step<S>& now) {
    if constexpr (stacks<S> && can_be_crowded<S>)
        if (now.report.contacts_lost != 0) hold_refused(now, surfaces_of(now), known_fast_pairs(now));
    hold_locks(now);
}

/// Joints that have borne more than they can.
template <class S>
void break_joints([[maybe_unused]] Step<S>& now) {
    if constexpr (has_joint_breaking<S>) features::BreakableJoints::break_joints(now.storage);
}

/// Islands of which all was at rest for long enough sleep from now on.
template <class S>
void fall_asleep([[maybe_unused]] Step<S>& now) {
    if constexpr (S::sleeps && has_joint_drives<S>) features::DrivenJoints::keep_awake(now.storage);
    if constexpr (S::sleeps && has_targets<S>) features::DrawnBodies::keep_awake(now.storage);
    if constexpr (S::sleeps)
        fall_asleep(now.bodies, now.storage.surface_view(), now.storage.gravity, now.h, {S::sleep_speed * S::length_unit, S::sleep_time},
                    now.storage.rest_view(), now.storage.pull_of_bodies());
}

/// Those that met in flight touch in this step.
template <class S>
auto list_flights([[maybe_unused]] Step<S>& now, [[maybe_unused]] const PairOfBodiesList& touching) {
    if constexpr (S::continuous) {
        list_flights(now.flights, now.storage.generation_of_shapes(now.storage.generation), touching);
        return now.flights;
    } else {
        return NoFlightImpacts{};
    }
}

/// Ends, then begins, then hits, each in the order of slots: when the array is full, those that come later in this order are lost.
template <class S>
void tell_events([[maybe_unused]] Step<S>& now) {
    if constexpr (has_events<S>) {
        auto& storage = now.storage;
        const EventList events = storage.begin_events(now.report);
        const uint16_t tag = storage.world_tag;
        const ManifoldView manifolds = storage.manifold_view();
        const PairOfBodiesList before = storage.touching_list_before(), touching = storage.touching_list();
        copy_list(touching, before);
        if constexpr (S::sleeps) spread_notes(manifolds, storage.awake_pairs, storage.awake_pair_count, storage.notes);
        find_touching(manifolds, S::length_unit, storage.notes, storage.generation_of_shapes(storage.generation), before, touching);
        auto flights = list_flights(now, touching);
        const ContactsOfStep<decltype(flights)> contacts = {manifolds, storage.notes, flights};
        emit_missing(before, touching, EventKind::end, tag, events);
        if constexpr (has_sensors<S>) emit_missing(storage.overlap_list_before(), storage.overlap_list(), EventKind::leave, tag, events);
        emit_begins(contacts, before, touching, tag, events);
        if constexpr (has_sensors<S>) emit_missing(storage.overlap_list(), storage.overlap_list_before(), EventKind::enter, tag, events);
        emit_hits(contacts, S::hit_speed, before, touching, tag, events);
        if constexpr (has_compounds<S>) name_bodies<S::max_shapes_of_body>(events);
        if constexpr (has_levels<S>) features::Levels::name_bodies(storage, events);
    }
}

/// What rests is put aside: no step looks at it until it wakes.
template <class S>
void put_aside([[maybe_unused]] Step<S>& now) {
    if constexpr (S::sleeps) put_aside(now.storage);
}

/// Time has passed, and queries find shapes where their bodies are now.
template <class S>
void finish_step(Step<S>& now) {
    place_shapes(now);
    now.storage.hold_moved_shapes();
    if constexpr (has_field<S>) now.storage.advance_time(now.h);
    ++now.storage.steps;
}

} }  // namespace ingot
