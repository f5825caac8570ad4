// SPDX-License-Identifier: MIT
// The sequential solver as conduct_substeps asks for it, for solve_sequentially.cpp and sequential_materials.cpp.
#pragma once

#include "../../base/limits.h"
#include "move_point_bodies.h"
#include "solve_sequentially.h"
#include "sweep_points.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

const ManifoldRecord& record_of_member(const PointView& solver, int member_i) {
    return solver.records[solver.pairs[solver.members[member_i]].record];
}

/// Whether nothing of the island accelerated in the step before, and no chain of its contacts is long.
[[maybe_unused]] bool begins_steady(const PointView& solver) {
    bool steady = solver.member_count <= limits::steady_levels;
    for (int i = 0; i < solver.member_count; ++i) steady = steady && was_steady(record_of_member(solver, i));  // bound: max_manifolds
    return steady;
}

/// What the last sweep of a substep left.
struct SweptPoints {
    int sweeps;
    scalar residual;  ///< m/s
};

/// Up to sweeps_max sweeps joined by nonlinear conjugate gradients, until no speed changes by more than limits::settled_speed_of_points and
/// `rounding`, m/s.
template <class View>
SweptPoints solve_point_velocities(const View& solver, int sweeps_max, scalar rounding) {
    scalar size_before = 0;
    for (int sweep_i = 1;; ++sweep_i) {  // bound: limits::sweeps_of_points: left at the latest then
        const SweepOfPoints sweep = sweep_point_velocities(solver, sweep_i % 2 != 0, limits::ignored_speed * solver.unit + rounding);
        const bool settled = sweep.fastest <= limits::settled_speed_of_points * solver.unit + rounding;
        if (sweep_i == sweeps_max || settled) return {sweep_i, sweep.fastest};
        const bool shrinks = sweep_i > 1 && sweep.size <= size_before;
        go_on_along(solver, shrinks ? sweep.size / size_before : 0);
        size_before = sweep.size;
    }
}

/// The impulses of the substep are part of the sums of the step, which began as zero.
[[maybe_unused]] void add_to_sum(const ManifoldRecord& record, ImpulseSum& sum) {
    for (int point_i = 0; point_i < record.manifold.count; ++point_i) sum.j[point_i] += record.j[point_i];  // bound: 4: Manifold::points_max
    sum.friction += record.j_friction;
}

/// Notes which manifolds carry an impulse at the end of a substep, and how much; `first`: the first of the step.
[[maybe_unused]] void note_impulses_of_points(const PointView& solver, const StepNotes& notes, bool first) {
    for (int i = 0; i < solver.member_count; ++i) {
        const ManifoldRecord& record = record_of_member(solver, i);
        if (notes.sums != nullptr) add_to_sum(record, notes.sums[solver.pairs[solver.members[i]].record]);
        if (notes.impacts == nullptr) continue;
        ImpactNote& note = notes.impacts[solver.members[i]];
        bool carried = !first && note.carried;
        // bound: 4: Manifold::points_max
        for (int point_i = 0; point_i < record.manifold.count; ++point_i) carried = carried || record.j[point_i] > 0;
        note.carried = carried;
    }
}

/// As conduct_substeps asks for it.
template <class View, bool notes_impulses>
struct SequentialContacts {
    explicit SequentialContacts(View& of) : view(of) {}

    void begin(const ContactStep& step, StepReport&) {
        take_in_bodies(view, step.bodies, step.gravity, step.h);
        join_bodies(view);
    }
    bool next_batch(const ContactStep& step) {
        if (!next_island(view)) return false;
        begins_steady_ = spares_substeps(view.effort) && begins_steady(view);
        substeps_ = begins_steady_ ? limits::steady_substeps : view.effort.substeps;
        begin_contacts(view, static_cast<scalar>(view.effort.substeps / substeps_), step.h / static_cast<scalar>(substeps_));
        substeps_left_ = substeps_;
        given_again_ = false;
        steady_ = is_first_ = true;
        swept_ = {};
        return true;
    }
    int substeps() const { return substeps_; }

    /// Its bodies keep the inertia of the step: those that spin fast and bounce gain energy by it, see solver/README.md.
    void refresh(const BodyView&, scalar) {}
    void predict([[maybe_unused]] scalar h, const StepNotes&, StepReport&) {
        if constexpr (View::bounces)
            if (predict_point_bounces(view, h)) given_again_ = false;
    }
    void kick(scalar h) { rounding_ = 4 * epsilon * (given_again_ ? kick_again(view) : kick_bodies(view, h)); }
    void warm_start(scalar h) {
        if (!given_again_) ingot::warm_start(view);
        some_reverse_ = !begins_steady_ && begin_point_reversals(view, h);
    }
    void solve_velocities(const ContactStep&, scalar, StepReport&) {
        const int share = share_of_substep(view.sweeps_of_step - swept_.sweeps, 0, substeps_left_);
        const SweptPoints swept = solve_point_velocities(view, share < limits::sweeps_of_points ? share : limits::sweeps_of_points, rounding_);
        swept_ = {swept_.sweeps + swept.sweeps, swept.residual};
    }
    void note_impulses([[maybe_unused]] const StepNotes& notes) {
        if constexpr (notes_impulses) note_impulses_of_points(view, notes, is_first_);
        is_first_ = false;
    }
    void drift(const BodyView&, scalar h) {
        if (some_reverse_) end_point_reversals(view, h);
        const SubstepOfPoints substep = drift_bodies(view, h);
        given_again_ = !substep.some_hit;
        steady_ = steady_ && substep.steady;
        --substeps_left_;
    }
    void solve_positions(const ContactStep&, scalar h) { sweep_point_positions(view, h); }

    void end_batch(const ContactStep& step, StepReport& report) {
        end_contacts(view, static_cast<scalar>(substeps_) / static_cast<scalar>(view.effort.substeps), steady_);
        const scalar least = limits::unsettled_speed * view.unit + rounding_;
        note_sweeps(report, swept_.sweeps, swept_.residual, max(least, fall_speed_of(step, substeps_)));
    }

protected:
    /// m/s, what the sweeps of the substep left.
    scalar residual() const { return swept_.residual; }
    /// The next substep begins with half of the impulses of this one.
    void halve_impulses() {
        end_contacts(view, scalar(0.5), false);
        given_again_ = false;
    }

private:
    View& view;
    int substeps_ = 0, substeps_left_ = 0;
    bool given_again_ = false, begins_steady_ = false, some_reverse_ = false, steady_ = true, is_first_ = true;
    scalar rounding_ = 0;
    SweptPoints swept_ = {};
};

}  // namespace

template <bool notes_impulses, class View>
void solve_sequentially(View& solver, const ContactStep& step, StepReport& report) {
    SequentialContacts<View, notes_impulses> contacts(solver);
    conduct_substeps(contacts, step, report);
}

} }  // namespace ingot
