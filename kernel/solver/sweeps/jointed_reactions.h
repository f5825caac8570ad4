// SPDX-License-Identifier: MIT
// What joints bear, through a batch and its substeps.
#pragma once

#include "jointed_contacts.h"

namespace ingot { inline namespace INGOT_ABI {

/// Contacts: SeesJoints. Whole: ReactingViewOf.
template <class Contacts, class Whole>
struct SeesReactions : Contacts {
    explicit SeesReactions(Whole& of) : Contacts(of), reacting(of) {}

    bool next_batch(const ContactStep& step) {
        if (!Contacts::next_batch(step)) return false;
        begin_reactions(figures(), reacting.loops, reacting.reactions);
        return true;
    }
    void solve_velocities(const ContactStep& step, scalar h, StepReport& report) {
        Contacts::solve_velocities(step, h, report);
        note_reactions(figures(), reacting.loops, reacting.reactions);
    }
    void end_batch(const ContactStep& step, StepReport& report) {
        Contacts::end_batch(step, report);
        if (is_of_joints(reacting.plan)) keep_reactions(figures(), reacting.loops, reacting.reactions, doublings_of(reacting.plan));
    }

private:
    Whole& reacting;

    const FigureView& figures() const { return reacting.jointed.figures; }
};

} }  // namespace ingot
