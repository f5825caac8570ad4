// SPDX-License-Identifier: MIT
// Which impact comes next in a step, and which contacts take part in it. Those that do not are aside: Contact::aside.
#pragma once

#include "solve_impacts.h"

namespace ingot { inline namespace INGOT_ABI {

/// Gives contacts that were found their rows. Each waits for its impact, touches since `when`, or does neither.
template <bool sees_kinematic>
void take_in_new(const ImpactStep& step, const ContactView& contacts, scalar now);

/// Notes the places of new contacts, as their bodies meet. Needs: bodies as they were when the contacts were found.
void note_new_places(const ImpactStep& step, const ContactView& contacts);

/// The contact whose impact is next; -1: there is none.
int first_impact(const ContactView& contacts);

/// Finds what takes part in the impact of the contact `first`: contacts that meet at the same time and contacts that touch, if they hang together
/// with it through bodies that can move. Returns: whether the impact may bounce; not where a contact has had half of the impacts that it may have.
/// That counts in impacts_deferred, once.
bool gather_impact(const ImpactStep& step, const ContactView& contacts, int first, StepReport& report);

/// Gives contacts of the impact that touched before it what has held their bodies up until then.
template <class Left>
void hold_until(const ImpactStep& step, const ContactView& contacts, scalar now, Left& left, StepReport& report);

/// The slot of a body of a contact of the impact, A for side 0, if it can move and no contact of the impact before this one is of it; else -1.
int body_of_impact(const ImpactStep& step, const ContactView& contacts, int contact_i, int side);

/// The contacts of a body are to be found anew after an impact at the time `now`. One that has had all its impacts stays as it was in the last: from
/// then on it touches, and counts in impacts_deferred.
void forget_times(const ContactView& contacts, int slot, scalar now, StepReport& report);

/// Impacts that there was no work left for are held as if they touched.
void defer_impacts(const ContactView& contacts, StepReport& report);

} }  // namespace ingot
