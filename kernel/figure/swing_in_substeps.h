// SPDX-License-Identifier: MIT
// swing_figures, for the files that compile it: see swing_figures.h.
#pragma once

#include "../base/figure_limits.h"
#include "build_figures.h"
#include "close_loops.h"
#include "factor_figures.h"
#include "factor_loops.h"
#include "find_loops.h"
#include "joint_drives.h"
#include "joint_motions.h"
#include "joint_rows.h"
#include "keep_figures.h"
#include "move_figures.h"
#include "moving_joint.h"
#include "respond_figures.h"
#include "swing_figures.h"
#include "target_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Forces of h seconds.
template <unsigned width, class Kinds>
void kick_rows(const FigureRows<width, Kinds>& rows, scalar h) {
    const BodyView& bodies = rows.view.bodies;
    const auto h_lane = splat<typename AllLanes<width>::T>(h);
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        FigureRow<width>& row = rows[row_i];
        const auto a = rows.gathered(row_i, [&](const FigureNode& node) {
            const Place at = place_of(node.slot);
            return lane_of(bodies.translation[at.tile].F_T, at.lane) * bodies.translation[at.tile].inv_M[at.lane] + rows.view.gravity;
        });
        const auto tau = rows.gathered(row_i, [&](const FigureNode& node) {
            const Place at = place_of(node.slot);
            return lane_of(bodies.rotation[at.tile].tau_T, at.lane);
        });
        write(rows.all, row.v, read(rows.all, row.v) + a * h_lane);
        write(rows.all, row.L, read(rows.all, row.L) + tau * h_lane);
    }
}

// What joints have beside what they lock, and what a batch does for it: `begin` it, `factor` figures, `list` rows as a substep begins, `solve` it,
// `push` what is off its place after the drift, and `keep` what the joints remember. Figures are factored as each substep begins; those of a scene
// with loops as the batch begins, and again after each drift: pushes meet them as they are then.

/// Loops: NoLoops, or NoLoopsOfHinges.
template <class Loops>
struct NothingBeside {
    using Kinds = typename Loops::Kinds;
    static constexpr bool closes = false;
    static constexpr bool is_driven() { return false; }
    static constexpr Loops loops = {};
    static void begin(const FigureView&, scalar) {}
    static void factor(const FigureView& view, scalar h) {
        place_joints<Kinds>(view);
        factor_figures(view, loops, h);
    }
    static void list(const FigureView&, scalar) {}
    static void solve(const FigureView& view, scalar) { pass_impulses<Kinds>(view); }
    static void push(const FigureView&, scalar) {}
    static void keep(const FigureView&, int) {}
};

/// Some joints close loops.
struct LoopsBeside {
    using Kinds = AnyKinds;
    static constexpr bool closes = true;
    static constexpr bool is_driven() { return false; }
    const LoopView& loops;

    void begin(const FigureView& view, scalar h) const {
        load_loops(view, loops, h);
        factor(view, h);
    }
    void factor(const FigureView& view, scalar h) const {
        place_joints(view);
        place_loops(view, loops);
        factor_figures(view, loops, h);
        factor_loops(view, loops);
    }
    static void list(const FigureView&, scalar) {}
    void solve(const FigureView& view, scalar) const {
        solve_loops(view, loops);
        note_targets(view, loops);
    }
    static void push(const FigureView&, scalar) {}
    void keep(const FigureView& view, int doublings) const { keep_loops(view, loops, doublings); }
};

/// Free directions may end, and may be driven. Rows: JointRowView, or DrivenRowView.
template <class Rows>
struct RowsBeside {
    using Kinds = AnyKinds;
    static constexpr bool closes = false;
    static constexpr bool is_driven() { return Rows::has_drives; }
    static constexpr NoLoops loops = {};
    Rows& all;

    void begin(const FigureView& view, [[maybe_unused]] scalar h) const {
        begin_joint_motions(view, all);
        if constexpr (Rows::has_drives) {
            place_joints(view);
            place_carriages(view);
            factor_figures(view, loops, h);
            respond_figures(view, all.responses);
            begin_drives(view, all);
        }
    }
    void factor(const FigureView& view, scalar h) const {
        place_joints(view);
        if constexpr (Rows::has_drives) {
            place_carriages(view);
            prepare_drives(view, all, h);
            factor_figures(view, all, h);
        } else {
            factor_figures(view, loops, h);
        }
    }
    void list(const FigureView& view, scalar h) const {
        respond_figures(view, all.responses);
        list_joint_rows(view, all, h);
    }
    void solve(const FigureView& view, scalar h) const {
        solve_once(view, h);
        if constexpr (Rows::has_drives)
            for (int round = 1; round < limits::drive_rounds && saturate_drives(view, all); ++round) {
                factor_figures(view, all, h);
                respond_figures(view, all.responses);
                begin_solve(view, loops, h);
                solve_once(view, h);
            }
        note_joint_rows(view, all, h);
    }
    void push(const FigureView& view, scalar h) const { push_joint_rows(view, all, h, h); }
    void keep(const FigureView& view, int doublings) const {
        keep_joint_motions(view, all, doublings);
        if constexpr (Rows::has_drives) keep_drives(view, all, doublings);
    }

private:
    void solve_once(const FigureView& view, scalar h) const {
        aim_joint_rows(view, all, h);
        begin_passing(view);
        pass_impulses(view);
        if (all.count == 0) return;
        settle_joint_rows(view, all, limits::settled_speed);
        begin_passing(view);  // from the impulses alone: what a figure gets depends on no rounding of the sweeps
        pass_impulses(view);
    }
};

/// Rows stand where their machine is settled.
void stand_with_machines(const FigureView& view, const LoopedRowView& all) {
    for (int i = 0; i < all.count; ++i) {  // bound: rows_of_joint max_joints
        const LoopFigure* const of = all.loops->of_node(view, node_of(all, all.list[i]));
        all.list[i].stands = of != nullptr && of->is_settled;
    }
}
/// Machines with a drive that has given way are solved again.
void reopen_driven(const FigureView& view, const LoopedRowView& all) {
    for (int i = 0; i < all.count; ++i) {
        LoopFigure* const of = all.loops->of_node(view, node_of(all, all.list[i]));
        if (of != nullptr && all.list[i].gave_way) of->is_settled = false;
    }
}

/// Both: loops are closed, and their joints may end and be driven as others.
struct LoopedRowsBeside {
    using Kinds = AnyKinds;
    static constexpr bool closes = true;
    const LoopView& loops;
    LoopedRowView& all;

    bool is_driven() const { return all.drives_of_joint > 0; }
    void begin(const FigureView& view, scalar h) const {
        load_loops(view, loops, h);
        begin_joint_motions(view, all);
        factor(view, h);
        begin_drives(view, all);
    }
    void factor(const FigureView& view, scalar h) const {
        place(view);
        factor_figures(view, loops, h);
        factor_loops(view, loops);
        respond_figures(view, all.responses);
    }
    void list(const FigureView& view, scalar h) const {
        if (is_driven()) {
            place(view);
            prepare_drives(view, all, h);
            factor_with_drives(view, h);
            factor_loops(view, loops);
        }
        list_joint_rows(view, all, h);
    }
    void solve(const FigureView& view, scalar h) const {
        open_machines(view, loops);
        solve_machines(view, h);
        for (int round = 1; round < limits::drive_rounds && saturate_drives(view, all); ++round) {
            reopen_driven(view, all);
            factor_with_drives(view, h);
            factor_open_loops(view, loops);
            clear_solve(view);
            solve_machines(view, h);
        }
        end_loops(view, loops);
        note_joint_rows(view, all, h);
        note_targets(view, loops);
    }
    void push(const FigureView& view, scalar h) const { push_joint_rows(view, all, h, h); }
    void keep(const FigureView& view, int doublings) const {
        keep_joint_motions(view, all, doublings);
        keep_drives(view, all, doublings);
        keep_loops(view, loops, doublings);
    }

private:
    void place(const FigureView& view) const {
        place_joints(view);
        if (is_driven()) place_carriages(view);
        place_loops(view, loops);
        place_free_rows(view, loops);
    }
    void factor_with_drives(const FigureView& view, scalar h) const {
        factor_figures(view, all, h);
        respond_figures(view, all.responses);
    }
    /// Until no rope comes to its end or is let go. Machines that are settled come to the same again.
    void solve_machines(const FigureView& view, scalar h) const {
        bool again = true;
        for (int round = 0; again; ++round) {  // bound: see settle_rows
            stand_with_machines(view, all);
            aim_joint_rows(view, all, h);
            pass_looped(view, loops);
            if (all.count > 0) {
                settle_joint_rows(view, all, limits::settled_speed);
                give_joint_rows(view, all);  // from the impulses alone: what a figure gets depends on no rounding of the sweeps
                pass_looped(view, loops);
            }
            close_all_loops(view, loops);
            again = settle_rows(view, loops, round);
        }
    }
};

template <class Beside, class Reactions>
void swing_substep(FigureView& view, const Beside& beside, Reactions reactions, scalar h) {
    if constexpr (!Beside::closes) beside.factor(view, h);
    beside.list(view, h);
    for_groups<typename Beside::Kinds>(view, [&](const auto& rows) { kick_rows(rows, h); });
    begin_flight_solve(view, beside.loops, h, beside.is_driven());
    beside.solve(view, h);
    end_solve<typename Beside::Kinds>(view, h);
    note_reactions(view, beside.loops, reactions);
    drift_figures<typename Beside::Kinds>(view, h);
    view.elapsed += h;
    if constexpr (Beside::closes) beside.factor(view, h);
    push_figures(view, beside.loops, false);
    beside.push(view, h);
}

template <class Beside, class Reactions>
void swing(FigureView& view, const Beside& beside, Reactions reactions, int substeps) {
    for (int doublings = 0; doublings <= limits::doublings_max; ++doublings) {
        group_figures(view, doublings);
        if (view.group_count == 0) continue;
        const int count = substeps << doublings;
        const scalar h = view.h / static_cast<scalar>(count);
        view.elapsed = 0;
        begin_reactions(view, beside.loops, reactions);
        beside.begin(view, h);
        // bound: Effort::substeps_max, times eight
        for (int substep_i = 0; substep_i < count; ++substep_i) swing_substep(view, beside, reactions, h);
        ask_for_doublings(view, beside.loops, view.h / static_cast<scalar>(substeps), doublings);
        beside.keep(view, doublings);
        keep_reactions(view, beside.loops, reactions, doublings);
        keep_figures(view, doublings);
    }
}

[[maybe_unused]] NothingBeside<NoLoops> beside_of(const FigureView&, const NoLoops&) { return {}; }
[[maybe_unused]] NothingBeside<NoLoopsOfHinges> beside_of(const FigureView&, const NoLoopsOfHinges&) { return {}; }
[[maybe_unused]] LoopsBeside beside_of(const FigureView&, const LoopView& loops) { return {loops}; }
[[maybe_unused]] RowsBeside<JointRowView> beside_of(const FigureView&, JointRowView& rows) { return {rows}; }
[[maybe_unused]] RowsBeside<DrivenRowView> beside_of(const FigureView& view, DrivenRowView& rows) {
    name_driven_kinds(view, rows);
    return {rows};
}
[[maybe_unused]] LoopedRowsBeside beside_of(const FigureView& view, LoopedRowView& rows) {
    name_driven_kinds(view, rows);
    return {*rows.loops, rows};
}

}  // namespace

template <class Beside, class Reactions>
void swing_figures(FigureView& view, Beside& beside, Reactions reactions, int substeps) {
    swing(view, beside_of(view, beside), reactions, substeps);
}

} }  // namespace ingot
