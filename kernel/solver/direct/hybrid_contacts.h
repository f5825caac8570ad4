// SPDX-License-Identifier: MIT
#pragma once

#include "../sweeps/swept_contacts.h"
#include "choose_islands.h"
#include "island_rows.h"
#include "solve_directly.h"

namespace ingot { inline namespace INGOT_ABI {

/// The sweeps with chosen islands solved directly, as conduct_substeps asks for them.
template <class View, bool notes_impulses, bool bounces>
struct HybridContacts : SweptContacts<PlainViewOf<View>, notes_impulses, bounces> {
    using Swept = SweptContacts<PlainViewOf<View>, notes_impulses, bounces>;

    HybridContacts(View& of, const DirectOf<View>& direct_view) : Swept(of), direct(direct_view), whole(of) {
        direct.unit = static_cast<wide_scalar>(of.unit);
    }

    void begin(const ContactStep& step, StepReport& report) {
        Swept::begin(step, report);
        choose_islands(this->view, direct, report);
    }
    bool next_batch(const ContactStep& step) {
        if (!Swept::next_batch(step)) return false;
        begin_direct_batch(this->view, direct);
        return true;
    }
    void refresh(const BodyView& bodies, scalar h) {
        Swept::refresh(bodies, h);
        if (this->view.some_turn) direct.loaded_island = -1;  // its rows are those of the substep before
    }
    void drift(const BodyView& bodies, scalar h) {
        Swept::drift(bodies, h);
        if (this->view.some_turn) direct.loaded_island = -1;  // its rows were made of the inertia before
    }
    void kick(scalar h) {
        Swept::kick(h);
        if (direct.some_chosen) keep_free_motion(this->view, direct);
    }
    void warm_start(scalar h) {
        Swept::warm_start(h);
        if (!direct.some_chosen || !this->some_reverse) return;
        add_to_free_motion(this->view, direct);
        direct.loaded_island = -1;  // its circles of friction are less wide now
    }
    void solve_velocities(const ContactStep& step, scalar h, StepReport& report) {
        plan_sweeps(this->view);
        if (direct.some_chosen) solve_before_sweeps(whole, direct, step.bodies, h);
        ingot::solve_velocities(this->view);
        if (direct.some_chosen) solve_after_sweeps(whole, direct, step.bodies, h, report);
        this->stay_passive(step.bodies, h);
        this->end_velocities(step.bodies, h);
        if (this->some_reverse) direct.loaded_island = -1;  // and are as wide as before
    }
    void solve_positions(const ContactStep& step, scalar h) {
        if (!direct.some_chosen) return Swept::solve_positions(step, h);
        place_islands(whole, direct, step.bodies, h);
        select_live(this->view);
        sweep_positions(of_points(this->view), this->view.live, this->view.live_count, h);
    }
    void end_batch(const ContactStep& step, StepReport& report) {
        Swept::end_batch(step, report);
        note_unsettled(this->view, direct);
    }

private:
    DirectOf<View> direct;
    View& whole;  ///< with kinematic bodies, where the scene has some
};

} }  // namespace ingot
