// SPDX-License-Identifier: MIT
// solve_by_sweeps, for the files that compile it: see block_sweeps.h.
#pragma once

#include "block_sweeps.h"
#include "jointed_reactions.h"
#include "kinematic_contacts.h"
#include "swept_contacts.h"

namespace ingot { inline namespace INGOT_ABI {

template <bool notes_impulses, bool bounces, class View>
void solve_by_sweeps(View& view, const ContactStep& step, StepReport& report) {
    using Plain = PlainViewOf<View>;
    using Unread = typename WithoutReactions<Plain>::Type;
    using Contacts = SweptContacts<Unread, notes_impulses, bounces, sees_kinematic<View>>;
    using Jointed = If<Plain::articulates, SeesJoints<Contacts, Unread>, Contacts>;
    using Swept = If<tells_reactions<Plain>, SeesReactions<Jointed, Plain>, Jointed>;
    If<sees_kinematic<View>, SeesKinematic<Swept, View>, Swept> contacts(view);
    conduct_substeps(contacts, step, report);
}

/// The same, shared by several cores. View: none with joints.
template <bool notes_impulses, bool bounces, class View>
void sweep_together(View& view, const ContactStep& step, StepReport& report, const WorkTogether& work) {
    using Swept = SweptContacts<PlainViewOf<View>, notes_impulses, bounces, sees_kinematic<View>, WorkTogether>;
    If<sees_kinematic<View>, SeesKinematic<Swept, View>, Swept> contacts(view, work);
    conduct_substeps(contacts, step, report);
}

} }  // namespace ingot
