// SPDX-License-Identifier: MIT
#pragma once

#include "../conduct_substeps.h"
#include "../../constraint/prepare_blocks.h"
#include "../../constraint/refresh_blocks.h"
#include "conjugate_gradients.h"
#include "diverged_islands.h"
#include "gaining_figures.h"
#include "gaining_islands.h"
#include "jointed_visits.h"
#include "move_bodies.h"
#include "note_impulses.h"
#include "order_manifolds.h"
#include "passive_bounces.h"
#include "plan_islands.h"
#include "predict_contacts.h"
#include "pushed_figures.h"
#include "sequence_impacts.h"
#include "slip_reversals.h"
#include "solve_velocities.h"
#include "sweep_joint_rows.h"
#include "sweep_positions.h"
#include "turning_bodies.h"
#include "warm_start.h"
#include "work_together.h"

namespace ingot { inline namespace INGOT_ABI {

/// The sweeps as conduct_substeps asks for them. View: SolverView, or a MaterialView. Events, restitution, rolling resistance and belts are compiled
/// in only where a scene names them. Whole: the same, or with rows of joints. is_pushed: by kinematic bodies. Work: WorkAlone, or WorkTogether.
template <class Whole, bool notes_impulses, bool bounces, bool is_pushed = false, class Work = WorkAlone>
struct SweptContacts {
    using View = typename WithoutRows<Whole>::Type;

    explicit SweptContacts(Whole& of, const Work& of_solve = {}) : whole(of), view(of), work(of_solve) {}

    void begin(const ContactStep& step, StepReport&) {
        view.step_h = step.h;
        take_in_bodies(view, step.bodies, step.gravity, step.h);
        auto&& jointed = jointed_of(view);
        take_in_figures(view, jointed, step.bodies, step.gravity, step.h);
        hold_bodies(view, step.bodies);
        if constexpr (View::articulates) lead_machines(view, jointed, view.loops);
        find_levels(view, jointed);
        plan_islands(view, jointed, step.bodies, step.h);
        plan_i_ = 0;
    }
    bool next_batch(const ContactStep& step) {
        auto&& jointed = jointed_of(view);
        while (plan_i_ < (View::articulates ? sweep_plans_of_jointed : sweep_plans))  // bound: sweep_plans_of_jointed
            if (begin_batch(view, jointed, static_cast<SweepPlan>(plan_i_++), step.bodies, step.gravity)) {
                prepare(step);
                return true;
            }
        return false;
    }
    int substeps() const { return view.substeps; }

    void refresh(const BodyView& bodies, scalar h) {
        if (!view.some_turn) return;
        work.over_blocks(view, [&](auto& part) { note_turning_speeds(with_locks(part), first_jointed_block(part), h); });
        mark_hit_bodies(view, first_jointed_block(view));
        work.over_bodies(with_locks(view), [&](auto& part) { turn_half_way(part, bodies, h); });
        work.over_blocks(view, [&](auto& part) { refresh_blocks(part, bodies, h); });
    }
    void predict(scalar h, [[maybe_unused]] const StepNotes& notes, [[maybe_unused]] StepReport& report) {
        work.over_blocks(view, [&](auto& part) { predict_contacts(part, h); });
        if (view.some_turn) shift_targets(view);
        if constexpr (bounces) {
            predict_bounces(view, h);
            sequence_impacts<notes_impulses>(view, h, notes, report);
        }
    }
    void kick(scalar h) { kick_bodies(view, h); }
    void warm_start(scalar h) {
        work.over_visits(view, [&of = without_belts(view), h](const Visit* visits, int count) { ingot::warm_start(of, visits, count, h); });
        some_reverse = is_small_moving(view.plan) && begin_reversals(without_locks(with_belts(view)), h);
    }
    void solve_velocities(const ContactStep& step, scalar h, StepReport&) {
        sweep_passively(step.bodies, h);
        end_velocities(step.bodies, h);
    }
    void note_impulses([[maybe_unused]] const StepNotes& notes) {
        if constexpr (notes_impulses) ingot::note_impulses(view, notes);
    }
    void drift(const BodyView& bodies, scalar h) {
        [[maybe_unused]] const bool turned = view.some_turn;
        drift_all(with_locks(view), bodies, h);
        if constexpr (moves_contacts<View>)
            if (turned) separate_turned(view, bodies);
        --view.substeps_left;
    }
    void solve_positions(const ContactStep&, scalar h) {
        work.over_visits(view, [&of = of_points(view), h](const Visit* visits, int count) { sweep_positions(of, visits, count, h); });
    }
    void end_batch(const ContactStep& step, StepReport& report) {
        ingot::end_batch(view, jointed_of(view), fall_speed_of(step, view.substeps), report);
        work.over_blocks(without_locks(without_belts(view)), [](const auto& part) { remember_impulses(part); });
    }

protected:
    Whole& whole;
    View& view;
    Work work;
    bool some_reverse = false;  ///< the slip of some contact turns round in this substep

    void sweep() { ingot::solve_velocities(whole, work); }
    void solve_again() {
        begin_rows_again(without_locks(without_belts(view)));
        sweep();
    }
    /// Sweeps, and again where sweeps that did not settle give energy, and where bounces do: each time these are lower.
    void sweep_passively(const BodyView& bodies, scalar h) {
        plan_sweeps(view);
        if constexpr (View::articulates) settle_jointed_sooner(view, h);
        sweep();
        stay_passive(bodies, h);
    }
    void stay_passive(const BodyView& bodies, scalar h) {
        if (some_reverse && take_back_reversals(view)) solve_again();
        if constexpr (View::articulates) hold_gaining_figures(whole, bodies, h);
        if constexpr (View::articulates && is_pushed) hold_pushed_figures(whole, bodies, h);
        if constexpr (View::articulates) excuse_jointed(view);
        // Belts do give energy.
        if (!gives_energy(view))
            for (int round = 0; round < limits::gaining_rounds && find_gaining_islands(view, bodies, h); ++round) solve_again();
        if constexpr (bounces)
            for (int round = 0; round < limits::bounce_rounds && lower_bounces(without_locks(view), h); ++round) solve_again();
    }
    /// What follows on the last of all sweeps.
    void end_velocities(const BodyView& bodies, scalar h) {
        if constexpr (bounces) take_back_bounces(view, h);
        if constexpr (!View::has_belts || View::locks_axes)
            if (!gives_energy(view)) hold_diverged_islands(without_locks(view), bodies, h);
        if (some_reverse) end_reversals(with_locks(view), h);
    }

private:
    template <class Bodies>
    void drift_all(Bodies& all, const BodyView& bodies, scalar h) {
        if constexpr (Work::is_shared) {
            work.over_bodies(all, [&](Bodies& part) { drift_some_bodies(part, bodies, h); });
            tell_unsteady_bodies(all);
        } else {
            drift_bodies(all, bodies, h);
        }
    }
    void prepare(const ContactStep& step) {
        if constexpr (View::articulates) begin_jointed_batch(view);
        hold_bodies(view, step.bodies);
        work.begin_batch(view);
        work.over_blocks(view, [&](auto& part) { prepare_blocks(part, step.bodies); });
        count_central_manifolds(view);
        const scalar h = step.h / static_cast<scalar>(view.substeps);
        work.over_bodies(with_locks(view), [&](auto& part) { find_turning_bodies(part, step.bodies, h); });
        if constexpr (notes_impulses) clear_impulse_notes(view, step.notes);
        if constexpr (bounces)
            if (find_impact_chains(view)) list_members(view);
    }

    int plan_i_ = 0;
};

} }  // namespace ingot
