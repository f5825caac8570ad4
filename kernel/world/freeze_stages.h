// SPDX-License-Identifier: MIT
// The adaptors of stages.h for bodies that a step has driven out of range.
#pragma once

#include "../constraint/forget_bad_impulses.h"
#include "stages.h"

namespace ingot { inline namespace INGOT_ABI {

/// A body that froze cannot move any more: pairs are searched for anew, without those of which neither can. The compliance of such a pair is zero.
template <class S>
void invalidate_frozen_bounds([[maybe_unused]] Step<S>& now) {
    if constexpr (S::sleeps)
        for_active(now.storage.rest_view(), [&now](int slot) {
            // bound: max_shapes_of_body
            for (int shape_slot = slot * S::max_shapes_of_body; shape_slot < (slot + 1) * S::max_shapes_of_body; ++shape_slot)
                if (is_frozen(now.bodies, slot)) invalidate_bounds(now.storage.bounds, shape_slot);
        });
    else if constexpr (stacks<S>)
        // bound: max_bodies max_shapes_of_body
        for (int slot = 0; slot < now.storage.slots_used * S::max_shapes_of_body; ++slot)
            if (is_frozen(now.bodies, slot / S::max_shapes_of_body)) invalidate_bounds(now.storage.bounds, slot);
}

/// What bodies that froze have left in records of contacts and figures is nothing to go on with, to tell, or to save.
template <class S>
void forget_bad_records([[maybe_unused]] Step<S>& now) {
    [[maybe_unused]] auto& storage = now.storage;
    if constexpr (stacks<S> && solves_pointwise<S>)
        forget_bad_impulses(storage.records, storage.records_used, nullptr, storage.sums_of_impulses());
    else if constexpr (stacks<S>)
        forget_bad_impulses(storage.records, storage.records_used, storage.friction_references, storage.sums_of_impulses());
    if constexpr (stacks<S> && S::rolling_resistance)
        for (int record_i = 0; record_i < storage.records_used; ++record_i)  // bound: max_manifolds
            if (!is_finite(storage.rolling_records[record_i].j)) storage.rolling_records[record_i].j = {};
    if constexpr (collides<S>)
        for (int contact_i = 0; contact_i < storage.contact_count; ++contact_i)  // bound: max_contacts
            if (!is_finite(storage.contacts[contact_i].j_total)) storage.contacts[contact_i].j_total = 0;
    if constexpr (swings_freely<S>)
        for (int slot = 0; slot < storage.slots_used; ++slot)  // bound: max_bodies
            if (!is_finite(storage.figure_memory[slot].torque)) storage.figure_memory[slot] = {};
}

/// Calls a stage for the bodies that a step may have changed: all, or the tiles of those that are active.
template <class S, class Stage>
INGOT_INLINE void over_active(Step<S>& now, const Stage& stage) {
    if constexpr (S::sleeps)
        over_active_tiles(now.bodies, now.storage.rest_view(), stage);
    else
        stage(now.bodies);
}

/// The forces of the step are over. Bodies that it drove out of range stand still from now on.
template <class S>
INGOT_INLINE void freeze_bad_bodies(Step<S>& now) {
    if constexpr (S::rotation::as_printed || flies_in_field<S>) mark_runaway_spins(now.bodies);
    int frozen = 0;
    over_active(now, [&frozen](const BodyView& some) {
        clear_forces(some);
        if (any_bad_bodies(some)) frozen += freeze_bad_bodies(some);
    });
    if (frozen == 0) return;
    count(now.report.bodies_frozen, frozen);
    invalidate_frozen_bounds(now);
    forget_bad_records(now);
}

} }  // namespace ingot
