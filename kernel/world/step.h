// SPDX-License-Identifier: MIT
// The step is the table of contents of the kernel, and the only place where a scene's features are asked for.
#pragma once

#include "../motion/integrate_L.h"
#include "../motion/integrate_r.h"
#include "../motion/integrate_v.h"
#include "../impulse/contact_rows.h"
#include "../impulse/solve_contact_forces.h"
#include "../narrow_phase/find_manifolds.h"
#include "../continuous/follow_fast_bodies.h"
#include "../impulse/solve_impacts.h"
#include "../solver/sweeps/move_bodies.h"
#include "../solver/sequential/move_point_bodies.h"
#include "world.h"

namespace ingot { inline namespace INGOT_ABI {

/// The lists of the step before, for events to be told from what has changed since.
template <class S>
void keep_lists(Storage<S>& storage) {
    copy_list(storage.touching_list(), storage.touching_list_before());
    if constexpr (has_sensors<S>) copy_list(storage.overlap_list(), storage.overlap_list_before());
}

/// Ends, then begins, then hits, each in the order of slots: when the array is full, those that come later in this order are lost.
template <class S>
void emit_events(Storage<S>& storage, StepReport& report) {
    const EventList events = storage.begin_events(report);
    const uint16_t tag = storage.world_tag;
    const ManifoldView manifolds = storage.manifold_view();
    const PairOfBodiesList before = storage.touching_list_before(), touching = storage.touching_list();
    find_touching(manifolds, storage.notes, storage.generation_of_shapes(storage.generation), before, touching);

    emit_missing(before, touching, EventKind::end, tag, events);
    if constexpr (has_sensors<S>) emit_missing(storage.overlap_list_before(), storage.overlap_list(), EventKind::leave, tag, events);
    emit_begins(manifolds, storage.notes, before, touching, tag, events);
    if constexpr (has_sensors<S>) emit_missing(storage.overlap_list(), storage.overlap_list_before(), EventKind::enter, tag, events);
    emit_hits(manifolds, storage.notes, S::hit_speed, before, touching, tag, events);
    if constexpr (has_compounds<S>) name_bodies<S::max_shapes_of_body>(events);
}

/// A body that froze cannot move any more: pairs are searched for anew, without those of which neither can. The compliance of such a pair is zero.
template <class S>
void invalidate_frozen_bounds(Storage<S>& storage) {
    for (int slot = 0; slot < storage.slots_used * S::max_shapes_of_body; ++slot)
        if (is_frozen(storage.bodies(), slot / S::max_shapes_of_body)) invalidate_bounds(storage.bounds, slot);
}

/// A step in which nothing moves: it leaves the world as it was.
template <class S>
StepReport pass_at_rest(Storage<S>& storage, scalar h, StepReport& report) {
    if constexpr (has_events<S>) (void)storage.begin_events(report);
    (void)storage.h_changes_to(h);
    count(report.contacts, storage.manifold_count);
    count(report.contacts_lost, storage.pairs_lost);
    ++storage.steps;
    return report;
}

template <class S>
bool refresh_bounds_of(Storage<S>& storage, const BodyView& bodies, scalar h) {
    if constexpr (S::sleeps)
        return refresh_active_bounds(bodies, storage.surface_view(), h, storage.rest_view(), storage.bounds);
    else
        return refresh_bounds(bodies, storage.surface_view(), h, storage.bounds);
}

/// Bounds of the step, and the pairs that may touch in it.
///
/// As a rule they are those of the last search, by fat AABBs, and some more. Where these have no room, pairs are searched for in every step, by its
/// bounds alone: so what is lost does not depend on when fat AABBs were made, which a snapshot does not hold.
template <class S>
INGOT_INLINE void find_pairs_of_step(Storage<S>& storage, const BodyView& shapes, const PairList& pairs, const ManifoldView& manifolds, scalar h) {
    const bool left = refresh_bounds_of(storage, shapes, h);
    if (left) storage.find_pairs(shapes, storage.bounds, pairs);
    const bool crowded = *pairs.lost > 0;
    if (crowded) {
        shrink_bounds(shapes, storage.bounds);
        storage.find_pairs(shapes, storage.bounds, pairs);
    }
    if (!left && !crowded) return;
    if constexpr (has_compounds<S>) drop_pairs_of_one_body<S::max_shapes_of_body>(pairs);
    match_records(manifolds, pairs);
}

/// Islands of the step, those awake that can meet what moves, and the pairs that are to be solved.
template <class S>
void wake_what_is_met(Storage<S>& storage, const BodyView& bodies, const ManifoldView& manifolds) {
    const RestView rest = storage.rest_view();
    join_islands(bodies, rest, manifolds);
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) rest.settling[tile_i] = 0;
    wake_met_islands(bodies, rest, manifolds);
    list_awake_pairs(bodies, rest, manifolds, storage.awake_pairs, storage.awake_pair_count);
}

/// Calls a stage for the bodies that move: all, or those that are awake.
template <class S, class Stage>
INGOT_INLINE void over_moving(Storage<S>& storage, const BodyView& bodies, const Stage& stage) {
    if constexpr (S::sleeps)
        over_awake_bodies(bodies, storage.rest_view(), stage);
    else
        stage(bodies);
}

/// The pairs that are too fast for a step.
template <class S>
auto fast_pairs_of([[maybe_unused]] Storage<S>& storage, [[maybe_unused]] scalar h) {
    if constexpr (S::continuous)
        return FastPairs{storage.bodies(), storage.surface_view(), storage.paths, h};
    else
        return NoFastPairs{};
}

template <class S>
void follow_fast_bodies(Storage<S>& storage, const SolverView& solver, scalar h, StepReport& report) {
    const auto meets = [&storage](int slot_A, int slot_B) { return storage.can_meet(slot_A, slot_B); };
    const ContinuousCollision<decltype(meets)> flights = {storage.bodies(), storage.surface_view(), solver,
                                                          storage.paths,    {storage.gravity, h},   meets};
    follow_fast_bodies<ShapesOf<S>, typename S::rotation, has_events<S>>(flights, report);
}

/// Advances a world by h seconds.
///
/// Needs:   limits::step_min <= h <= limits::step_max; anything else, NaN included, is answered with bad_step and changes
///          nothing. A constant h is best: time is then a count of steps and does not drift.
/// Bound:   every loop is bounded by a capacity of the scene or a number in base/limits.h.
template <class S>
StepReport step(World<S>& world, scalar h) {
    StepReport report{};
    report.status = check_step(h);
    if (report.status != Status::ok) return report;

    auto& storage = world.storage_;
    const BodyView bodies = storage.bodies();

    if constexpr (collides<S>) {
        const ContactView contacts = storage.contact_view();
        const scalar rest_speed = limits::rest_speed_factor * h * sqrt(length_sq(storage.gravity));
        find_contacts<typename S::shapes>(bodies, storage.surface_view(), contacts, report);
        refresh_inv_I_world(bodies);                                      // Eq. 20
        prepare_contact_rows(contacts, bodies);
        solve_impacts(contacts, bodies, rest_speed, report);              // Fig. 4
    }

    if constexpr (has_field<S> && !flies_in_field<S>)
        add_field_forces(bodies, storage.forcing(storage.gravity_or_none()), S::rotation::as_printed ? 0 : h / 2);

    if constexpr (S::rotation::as_printed) {                              // Listing 1: every right-hand side is of step n
        if constexpr (S::translates) {
            drift_r(bodies, h);
            integrate_v(bodies, h, storage.gravity);                      // Eq. 14
        }
        integrate_A_listing1(bodies, h);                                  // Eqs. 20, 18, 10, then Eq. 1
        integrate_L(bodies, h);                                           // Eq. 16
    } else if constexpr (flies_in_field<S>) {                             // kicks and free flights
        const FlightClock clock{storage.steps, storage.h_changes_to(h)};
        const auto forcing = storage.forcing(storage.gravity_or_none());
        count(report.spins_clamped, S::flight::template fly<typename S::rotation>(bodies, forcing, h, clock));
    } else if constexpr (stacks<S>) {
        if constexpr (S::sleeps)
            if (all_at_rest(storage.rest_view(), storage.bounds, bodies.tile_count)) return pass_at_rest(storage, h, report);
        if constexpr (has_events<S>) keep_lists(storage);
        const PairList pairs = storage.pair_list();
        const ManifoldView manifolds = storage.manifold_view();
        if constexpr (has_compounds<S>) storage.place_all_shapes();
        const BodyView shapes = storage.shapes();
        find_pairs_of_step(storage, shapes, pairs, manifolds, h);
        if constexpr (S::continuous) begin_paths(bodies, storage.surface_view(), h, storage.paths);
        update_manifolds<ShapesOf<S>, S::recycles_manifolds>(shapes, storage.surface_view(), storage.bounds, h, storage.pair_rules(report), pairs,
                                                           manifolds, report, fast_pairs_of(storage, h));
        if constexpr (has_compounds<S>) name_bodies<S::max_shapes_of_body>(manifolds, storage.body_pairs);
        if constexpr (S::sleeps) wake_what_is_met(storage, bodies, manifolds);
        [[maybe_unused]] const ManifoldView moving = storage.moving_manifolds();
        if constexpr (has_events<S>) note_approaches(bodies, storage.gravity, h, moving, storage.notes);
        over_moving(storage, bodies, [](const BodyView& some) { refresh_inv_I_world(some); });   // Eq. 20
        auto solver = storage.contact_solver();
        if constexpr (S::sleeps) {
            solver.pairs = moving.pairs;
            solver.manifold_count = *moving.count;
        }
        storage.template solve_contacts<has_events<S>, S::bounces>(solver, bodies, storage.gravity, h, storage.impact_notes(), report);
        if constexpr (S::sleeps)
            if (*moving.count == 0) report.sweeps = 0;  // over none: a world that was loaded asleep tells what the one that was saved tells
        if constexpr (S::sleeps && has_events<S>) spread_notes(manifolds, moving.pairs, *moving.count, storage.notes);
        if constexpr (has_events<S>) emit_events(storage, report);

        over_moving(storage, bodies, [&](const BodyView& some) {
            integrate_L(some, h);
            integrate_v(some, h, storage.gravity);
        });
        write_contact_motion(solver, bodies, storage.gravity, h);
        const FlightClock clock{storage.steps, storage.h_changes_to(h), h / 2};
        over_moving(storage, bodies, [&](const BodyView& some) {
            count(report.spins_clamped, S::rotation::integrate_A(some, h, clock));
            integrate_r(some, h, storage.gravity);
        });
        turn_by_corrections(solver, bodies, h);
        if constexpr (S::sleeps)
            fall_asleep(bodies, storage.surface_view(), storage.gravity, h, {S::sleep_speed, S::sleep_time}, storage.rest_view());
        if constexpr (S::continuous) follow_fast_bodies<S>(storage, solver, h, report);
    } else {
        integrate_L(bodies, h);
        if constexpr (S::translates) integrate_v(bodies, h, storage.gravity);
        if constexpr (collides<S>) solve_contact_forces(storage.contact_view(), bodies, h, report);

        const FlightClock clock{storage.steps, storage.h_changes_to(h), h / 2};
        count(report.spins_clamped, S::rotation::integrate_A(bodies, h, clock));
        if constexpr (S::translates) integrate_r(bodies, h, storage.gravity);
    }

    if constexpr (S::rotation::as_printed || flies_in_field<S>) mark_runaway_spins(bodies);
    clear_forces(bodies);
    if (any_bad_bodies(bodies)) {
        const int frozen = freeze_bad_bodies(bodies);
        count(report.bodies_frozen, frozen);
        if constexpr (stacks<S>)
            if (frozen > 0) invalidate_frozen_bounds(storage);
    }
    if constexpr (has_compounds<S>) storage.place_all_shapes();          // for queries
    if constexpr (has_field<S>) storage.advance_time(h);
    ++storage.steps;
    return report;
}

} }  // namespace ingot
