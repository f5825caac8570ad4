// SPDX-License-Identifier: MIT
// The impacts of a step without friction, one after another, each when it happens: those of the shapes of a scene.
#pragma once

#include "find_contacts.h"
#include "impact_times.h"

namespace ingot { inline namespace INGOT_ABI {

/// Finds the contacts of a body anew, once an impact at the time `now` has changed its way.
template <class Shapes>
[[gnu::noinline, gnu::cold]] void look_again(const ImpactStep& step, const ContactView& contacts, int slot, scalar now, StepReport& report) {
    forget_times(contacts, slot, now, report);
    const Index untested = report.pairs_untested;
    for (int other = next_touchable(step.bodies, step.surfaces, step.ways, slot, 0); other < step.surfaces.slot_count;
         other = next_touchable(step.bodies, step.surfaces, step.ways, slot, other + 1))  // bound: max_bodies
        if (other != slot) find_contact<Shapes>(step, contacts, slot < other ? slot : other, slot < other ? other : slot, now, true, report);
    report.pairs_untested = untested;  // they have been counted as the step began
}

/// Calls each(slot) for the bodies of the impact that can move, once.
template <class Each>
void for_bodies_of_impact(const ImpactStep& step, const ContactView& contacts, const Each& each) {
    for (int contact_i = 0; contact_i < *contacts.count; ++contact_i)  // bound: max_contacts
        for (int side = 0; side < 2; ++side) {
            const int slot = body_of_impact(step, contacts, contact_i, side);
            if (slot >= 0) each(slot);
        }
}

/// Resolves the impacts of a step in the order of their times. Contacts that touch after it press, or are left alone: solve_contact_forces.
///
/// The times are those at which shapes meet on their way (Fig. 4 is of the moment of the impact): a ball on a plane keeps its energy and its phase to
/// rounding at every rate. What touches at that time and hangs together with it is solved with it; what was held until then is held up to it first.
/// Bodies that do not hang together do not change each other's bits.
/// Bound: limits::impacts_in_step_max impacts of each contact; where one is in the second half of them, nothing bounces. After the last it is held:
///        its bodies do not pass the plane between them as it was then, so balls get no deeper into each other. Both count in impacts_deferred, as
///        does a contact that has had limits::impact_visits_max visits of solves, which later impacts leave out.
template <class Shapes, bool sees_kinematic, bool reads_places, class Left>
void follow_impacts(ImpactStep& step, const ContactView& contacts, Left& left, StepReport& report) {
    scalar now = 0;
    // bound: limits::impacts_in_step_max max_contacts: each turn but the last counts in Contact::impacts of one at least
    for (;;) {
        if constexpr (reads_places) note_new_places(step, contacts);
        take_in_new<sees_kinematic>(step, contacts, now);
        const int first = first_impact(contacts);
        if (first < 0 || !left.some()) break;
        now = contacts.contacts[first].when;
        const bool bounce = gather_impact(step, contacts, first, report);
        hold_until(step, contacts, now, left, report);
        solve_impacts(step, contacts, now, bounce, left, report);
        for_bodies_of_impact(step, contacts, [&step](int slot) { raise_ways(step, slot); });
        for_bodies_of_impact(step, contacts, [&](int slot) { look_again<Shapes>(step, contacts, slot, now, report); });
    }
    defer_impacts(contacts, report);
    report.contacts = *contacts.count;
}

} }  // namespace ingot
