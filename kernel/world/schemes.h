// SPDX-License-Identifier: MIT
// Schemes: how a scene's bodies get from one state to the next. Each has one verb, advance.
#pragma once

#include "../impulse/solve_contact_forces.h"
#include "../motion/body_forces.h"
#include "../motion/compensated_sums.h"
#include "../motion/integrate_L.h"
#include "../motion/integrate_r.h"
#include "../motion/integrate_v.h"
#include "../solver/sequential/move_point_bodies.h"
#include "shared_stages.h"
#include "stages.h"

namespace ingot { inline namespace INGOT_ABI {

/// over_moving without bodies that figures have moved.
template <class S, class Stage>
INGOT_INLINE void over_flying(Step<S>& now, const Stage& stage) {
    [[maybe_unused]] const auto reported = [&](const BodyView& some) { stage(some, now.report); };
    if constexpr (!has_joints<S>) {
        over_moving(now, stage);
    } else if constexpr (S::sleeps) {
        const RestView rest = now.storage.rest_view();
        rest.active.for_each([&](int tile_i) {
            if (rest.awake[tile_i] == 0) return;
            over_others(now.bodies, tile_i, now.storage.jointed_lanes[tile_i] | sleepers_of(now.bodies, rest, tile_i), reported);
        });
    } else {
        // bound: max_bodies / lanes, rounded up
        for (int tile_i = 0; tile_i < now.bodies.tile_count; ++tile_i) over_others(now.bodies, tile_i, now.storage.jointed_lanes[tile_i], reported);
    }
}

/// The sums of the bodies of a view, in scenes with compensated_sums.
template <class S>
INGOT_INLINE SumView sums_of(Step<S>& now, const BodyView& some) {
    const uint16_t* awake = nullptr;
    if constexpr (S::sleeps) awake = now.storage.rest_view().awake;
    return now.storage.sums(static_cast<int>(some.rotation - now.bodies.rotation), awake);
}

/// Forces change the motion: L (Eq. 16) and v_CM (Eq. 14).
template <class S>
INGOT_INLINE void kick(Step<S>& now) {
    over_flying(now, [&now](const BodyView& some, StepReport&) {
        if constexpr (S::compensated_sums) {
            integrate_L_in_sums(some, sums_of(now, some), now.h);
            if constexpr (S::translates) integrate_v_in_sums(some, sums_of(now, some), now.h, now.storage.gravity);
            return;
        }
        integrate_L(some, now.h);
        if constexpr (S::translates) integrate_v(some, now.h, now.storage.gravity);
    });
}

/// The motion changes the places: A by the scene's rotation, r_CM (Eq. 1).
template <class S>
INGOT_INLINE void drift(Step<S>& now) {
    move_kinematic_bodies(now);
    stop_locked_turns(now);
    const FlightClock clock{now.storage.steps, now.storage.energy_unit(now.h), now.h / 2};
    over_flying(now, [&now, &clock](const BodyView& some, StepReport& report) {
        if constexpr (stacks<S>)
            count(report.spins_clamped, turn_beside_contacts<typename S::rotation>(some, now.h, clock));
        else
            count(report.spins_clamped, S::rotation::integrate_A(some, now.h, clock));
        if constexpr (S::translates && S::compensated_sums)
            integrate_r_in_sums(some, sums_of(now, some), now.h, now.storage.gravity);
        else if constexpr (S::translates)
            integrate_r(some, now.h, now.storage.gravity);
    });
    turn_with_locks(now);
}

/// Listing 1: every right-hand side is of step n.
struct AsPrinted {
    template <class S>
    static void advance(Step<S>& now) {
        move_kinematic_bodies(now);
        if constexpr (S::translates) {
            drift_r(now.bodies, now.h);
            integrate_v(now.bodies, now.h, now.storage.gravity);          // Eq. 14
        }
        integrate_A_listing1(now.bodies, now.h);                          // Eqs. 20, 18, 10, then Eq. 1
        integrate_L(now.bodies, now.h);                                   // Eq. 16
    }
};

/// Half of what turns with its body, as that stands now.
template <class S>
INGOT_INLINE void push_half_in_body([[maybe_unused]] Step<S>& now) {
    if constexpr (halves_body_forces<S>) push_in_body(now.bodies, now.storage.body_forces, now.h / 2);
}

/// Bodies that touch nothing.
struct FreeFlight {
    template <class S>
    static void advance(Step<S>& now) {
        kick(now);
        push_half_in_body(now);
        drift(now);
        push_half_in_body(now);
        if constexpr (halves_body_forces<S>) clear_forces_in_body(now.storage.body_forces, now.bodies.tile_count);
    }
};

/// Figures that touch nothing, in scenes that name EnergyMomentum: first of all, and the substeps get the others.
template <class S>
INGOT_INLINE void swing_freely([[maybe_unused]] Step<S>& now) {
    if constexpr (swings_freely<S>) {
        auto& storage = now.storage;
        // bound: max_bodies / lanes, rounded up
        for (int tile_i = 0; tile_i < now.bodies.tile_count; ++tile_i) {
            storage.moved_lanes[tile_i] = 0;
            storage.left_lanes[tile_i] = 0xffff;
            if constexpr (S::sleeps) storage.left_lanes[tile_i] = storage.awake[tile_i];
        }
        if constexpr (stacks<S>) storage.mark_touching(storage.moving_manifolds(), now.bodies.tile_count);
        FigureView figures = storage.figures(now.h);
        build_figures(figures);
        swing_freely(figures, storage.energy_momentum_view(), storage.reactions(), now.report);
    }
}
/// Bodies that have been moved so are no concern of kick and drift.
template <class S>
INGOT_INLINE void leave_swung([[maybe_unused]] Step<S>& now) {
    if constexpr (swings_freely<S>)
        // bound: max_bodies / lanes, rounded up
        for (int tile_i = 0; tile_i < now.bodies.tile_count; ++tile_i)
            now.storage.jointed_lanes[tile_i] = static_cast<uint16_t>(now.storage.jointed_lanes[tile_i] | now.storage.moved_lanes[tile_i]);
}

/// Bodies that touch nothing, some of them joined.
struct JointedFlight {
    template <class S>
    static void advance(Step<S>& now) {
        swing_freely(now);
        FigureView figures = now.storage.figures(now.h);
        auto loops = now.storage.loop_view();
        build_figures(figures, loops);
        if constexpr (has_loops<S>) count(now.report.joints_lost, find_loops(figures, loops));
        if constexpr (has_joint_rows<S>) {
            auto rows = now.storage.joint_row_view();
            if constexpr (has_loops<S>) rows.loops = &loops;
            swing_figures(figures, rows, now.storage.reactions(), S::effort.substeps);
        } else if constexpr (!has_loops<S> && S::joints::are_hinges) {
            NoLoopsOfHinges no_loops;
            swing_figures(figures, no_loops, now.storage.reactions(), S::effort.substeps);
        } else {
            swing_figures(figures, loops, now.storage.reactions(), S::effort.substeps);
        }
        leave_swung(now);
        kick(now);
        drift(now);
    }
};

/// The same after impacts without friction: contacts that stay carry what forces press into them.
struct ImpulsiveMotion {
    template <class S>
    static void advance(Step<S>& now) {
        kick(now);
        now.visits_left.add(S::work_budget / 4);  // kept for what presses
        solve_contact_forces(now.storage.contact_view(), now.bodies, now.h, now.visits_left, now.report);
        drift(now);
    }
};

/// Kicks by a field and free flights, as the scene's flight has them.
struct FieldFlight {
    template <class S>
    static void advance(Step<S>& now) {
        auto& storage = now.storage;
        const FlightClock clock{storage.steps, storage.energy_unit(now.h)};
        const auto forcing = storage.forcing(storage.gravity_or_none());
        count(now.report.spins_clamped, S::flight::template fly<typename S::rotation>(now.bodies, forcing, now.h, clock));
    }
};

/// Contacts with friction. The solver finds the motion at the end of the step and the mean forces that lead to it; then all bodies fly by the same
/// rules, those that touch under these forces.
struct ConstrainedMotion {
    template <class S>
    static void advance(Step<S>& now) {
        over_moving(now, [](const BodyView& some, StepReport&) { refresh_inv_I_world(some); });  // Eq. 20
        restrict_inertia(now);
        swing_freely(now);
        solve_contacts(now);
        leave_swung(now);
        kick(now);
        write_contact_motion(now);
        drift(now);
        turn_by_corrections(now);
    }

private:
    template <class S>
    static void solve_contacts(Step<S>& now) {
        auto& storage = now.storage;
        const ManifoldView moving = storage.moving_manifolds();
        now.solver = storage.contact_solver();
        now.solver.pairs = moving.pairs;
        now.solver.manifold_count = *moving.count;
        now.solver.sweeps_of_step = sweeps_within(S::work_budget, *moving.count);
        storage.clear_impulse_sums(moving);
        const ContactStep step{now.bodies, storage.gravity, now.h, {storage.impact_notes(), storage.sums_of_impulses()}};
        if (solve_side_by_side(now, step)) return;
        storage.template solve_contacts<has_events<S> || S::reads_contacts, S::bounces>(now.solver, step, now.report);
    }
};

template <class S>
constexpr auto scheme_of_scene() {
    if constexpr (S::rotation::as_printed)
        return AsPrinted{};
    else if constexpr (flies_in_field<S>)
        return FieldFlight{};
    else if constexpr (stacks<S>)
        return ConstrainedMotion{};
    else if constexpr (collides<S>)
        return ImpulsiveMotion{};
    else if constexpr (has_joints<S>)
        return JointedFlight{};
    else
        return FreeFlight{};
}
template <class S>
using SchemeOf = decltype(scheme_of_scene<S>());

/// From this state to the next, by the scheme of the scene. Joints that have borne more than they can are broken then.
template <class S>
INGOT_INLINE void advance(Step<S>& now) {
    SchemeOf<S>::advance(now);
    break_joints(now);
}

} }  // namespace ingot
