// SPDX-License-Identifier: MIT
// The step is the table of contents of the kernel: a line a stage, and no branch. What a stage asks of a scene stands in stages.h and schemes.h.
#pragma once

#include "freeze_stages.h"
#include "schemes.h"
#include "stages.h"

namespace ingot { inline namespace INGOT_ABI {

/// Advances a world by h seconds.
///
/// Needs:   limits::step_min <= h <= limits::step_max; anything else, NaN included, is answered with bad_step and changes
///          nothing. A constant h is best: time is then a count of steps and does not drift.
/// Bound:   every loop is bounded by a capacity of the scene or a number in base/limits.h.
template <class S>
StepReport step(World<S>& world, scalar h) {
    StepReport report;
    const BodyView bodies = world.storage_.bodies();
    Step<S> now{world.storage_, h, bodies, report};
    if (!accepts_step(now) || passes_asleep(now)) return report;

    place_shapes(now);               // of bodies that have several
    find_pairs(now);                 // broad phase
    find_manifolds(now);             // narrow phase; sensors note who is in them
    wake_islands(now);
    sum_forces(now);                 // Eqs. 14, 16, and the field
    resolve_impacts(now);            // Fig. 4, without friction
    note_approaches(now);            // events: how fast they meet
    begin_paths(now);                // of bodies that may be fast
    advance(now);                    // contacts with friction; Eqs. 10, 18, 20; Eq. 1
    follow_fast_bodies(now);         // impacts within the step
    hold_what_has_no_room(now);      // where arrays are full; and where axes are locked
    fall_asleep(now);
    tell_events(now);
    put_aside(now);                  // what rests: no step looks at it until it wakes
    freeze_bad_bodies(now);
    finish_step(now);
    return report;
}

} }  // namespace ingot
