// SPDX-License-Identifier: MIT
// Which impact comes next in a step, and what takes part in it.
#pragma once

#include "solve_impacts.h"

namespace ingot { inline namespace INGOT_ABI {

/// Contacts that were found get their rows. Each waits for its impact, or touches since `when`, or neither.
template <bool sees_kinematic>
void take_in_new(const ImpactStep& step, const ContactView& contacts, scalar now, StepReport& report);

/// Notes where they are when each is as it was found. Needs: bodies as they were then.
void note_new_places(const ImpactStep& step, const ContactView& contacts);

/// The contact whose impact is next; -1: there is none.
int first_impact(const ContactView& contacts);

/// Contacts of this impact are not aside: those at the same time, and those that touch, that hang together with it through bodies that can move.
/// Returns: whether it may bounce.
bool gather_impact(const ImpactStep& step, const ContactView& contacts, int first);

/// Contacts of the impact that touched before it have held each other up to its time.
template <class Left>
void hold_until(const ImpactStep& step, const ContactView& contacts, scalar now, Left& left, StepReport& report);

/// One of the two bodies of a contact of the impact, if it can move and no contact before this one has named it; else -1.
int body_of_impact(const ImpactStep& step, const ContactView& contacts, int contact_i, int side);

/// The contacts of a body are to be found anew.
void forget_times(const ContactView& contacts, int slot);

/// Impacts that there was no work left for are held as if they touched.
void defer_impacts(const ContactView& contacts, StepReport& report);

} }  // namespace ingot
