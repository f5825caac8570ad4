// SPDX-License-Identifier: MIT
// The adaptors of stages.h for what forces and impacts without friction do before bodies move.
#pragma once

#include "../impulse/impacts_in_step.h"
#include "crowd_stages.h"
#include "lock_stages.h"

namespace ingot { inline namespace INGOT_ABI {

/// What takes motion away looks at what impacts have left of it.
template <class S>
INGOT_INLINE void damp(Step<S>& now) {
    features::All::over_named<S>([&now](auto feature) { decltype(feature)::damp(now.storage, now.h); });
}

/// What features add to the forces that the user has summed since the last step (Eqs. 14, 16).
template <class S>
INGOT_INLINE void sum_forces(Step<S>& now) {
    features::All::over_named<S>([&now](auto feature) { decltype(feature)::sum_forces(now.storage, now.h); });
    if constexpr (!collides<S>) damp(now);
}

/// The step as impacts without friction see it. Where bodies do not fly on parabolas, impacts are of what touches as it begins.
template <class S>
ImpactStep impact_step_of(const Step<S>& now) {
    ImpactStep step = {now.bodies, now.storage.surface_view(), now.storage.gravity, flies_in_field<S> || S::rotation::as_printed ? 0 : now.h,
                       limits::rest_speed_factor * now.h * sqrt(length_sq(now.storage.gravity))};
    step.ways = ways_in(step);
    return step;
}

/// Impacts without friction, in scenes with max_contacts (Fig. 4).
template <class S>
void resolve_impacts([[maybe_unused]] Step<S>& now) {
    if constexpr (collides<S>) {
        const ContactView contacts = now.storage.contact_view();
        ImpactStep step = impact_step_of(now);
        refresh_inv_I_world(now.bodies);  // Eq. 20
        restrict_inertia(now);
        find_contacts<typename S::shapes>(step, contacts, now.report);
        if constexpr (can_be_crowded<S>)
            if (now.report.contacts_lost != 0) hold_lost_contacts(now);
        follow_impacts<typename S::shapes, S::kinematic_bodies, S::reads_contacts>(step, contacts, now.visits_left, now.report);
        damp(now);
    }
}

} }  // namespace ingot
