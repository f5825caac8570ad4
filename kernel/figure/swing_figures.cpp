// SPDX-License-Identifier: MIT
#include "swing_figures.h"

#include "../base/limits.h"
#include "build_figures.h"
#include "close_loops.h"
#include "factor_figures.h"
#include "joint_drives.h"
#include "factor_loops.h"
#include "find_loops.h"
#include "joint_motions.h"
#include "joint_rows.h"
#include "keep_figures.h"
#include "move_figures.h"
#include "respond_figures.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Forces of h seconds.
template <unsigned width>
void kick_rows(const FigureRows<width>& rows, scalar h) {
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

/// Figures as they are now. Those of a scene with loops are factored as the batch begins, and again after each drift: pushes meet them as they are
/// then. The others are factored as each substep begins.
void factor_now(const FigureView& view, const NoLoops& loops, scalar h) {
    place_joints(view);
    factor_figures(view, loops, h);
}
void factor_now(const FigureView& view, const LoopView& loops, scalar h) {
    place_joints(view);
    place_loops(view, loops);
    factor_figures(view, loops, h);
    factor_loops(view, loops);
}

/// Of joints that have nothing but what they lock.
struct NoRows {
    static constexpr bool closes = false;
    static constexpr NoLoops loops = {};
    static void begin(const FigureView&, scalar) {}
    static void factor(const FigureView& view, scalar h) { factor_now(view, loops, h); }
    static void list(const FigureView&, scalar) {}
    static void solve(const FigureView& view, scalar) { pass_impulses(view); }
    static void push(const FigureView&, scalar) {}
    static void keep(const FigureView&, int) {}
};

/// Of joints some of which close loops.
struct WithLoops {
    static constexpr bool closes = true;
    const LoopView& loops;

    void begin(const FigureView& view, scalar h) const {
        load_loops(view, loops);
        factor_now(view, loops, h);
    }
    static void list(const FigureView&, scalar) {}
    void solve(const FigureView& view, scalar) const { solve_loops(view, loops); }
    static void push(const FigureView&, scalar) {}
    void keep(const FigureView& view, int doublings) const { keep_loops(view, loops, doublings); }
};

/// Of joints whose free directions may end.
struct WithRows {
    static constexpr bool closes = false;
    static constexpr NoLoops loops = {};
    JointRowView& all;

    void begin(const FigureView& view, scalar) const { begin_joint_motions(view, all); }
    static void factor(const FigureView& view, scalar h) { factor_now(view, loops, h); }
    void list(const FigureView& view, scalar h) const {
        respond_figures(view, all.responses);
        list_joint_rows(view, all, h);
    }
    void solve(const FigureView& view, scalar h) const {
        aim_joint_rows(view, all, h);
        begin_passing(view);
        pass_impulses(view);
        if (all.count == 0) return;
        settle_joint_rows(view, all, limits::settled_speed);
        begin_passing(view);  // from the impulses alone: what a figure gets depends on no rounding of the sweeps
        pass_impulses(view);
        note_joint_rows(view, all, h);
    }
    void push(const FigureView& view, scalar h) const { push_joint_rows(view, all, h, h); }
    void keep(const FigureView& view, int doublings) const { keep_joint_motions(view, all, doublings); }
};

/// Of joints that may have drives as well.
struct DrivenRows {
    static constexpr bool closes = false;
    static constexpr NoLoops loops = {};
    JointRowView& all;

    void begin(const FigureView& view, scalar h) const {
        begin_joint_motions(view, all);
        factor_now(view, loops, h);
        respond_figures(view, all.responses);
        begin_drives(view, all);
    }
    void factor(const FigureView& view, scalar h) const {
        place_joints(view);
        prepare_drives(view, all, h);
        factor_driven_figures(view, all, h);
    }
    void list(const FigureView& view, scalar h) const {
        respond_figures(view, all.responses);
        list_driven_rows(view, all, h);
    }
    void solve(const FigureView& view, scalar h) const {
        solve_once(view, h);
        for (int round = 1; round < limits::drive_rounds && saturate_drives(view, all); ++round) {
            factor_driven_figures(view, all, h);
            respond_figures(view, all.responses);
            begin_solve(view, loops, h);
            solve_once(view, h);
        }
        note_driven_rows(view, all, h);
    }
    void push(const FigureView& view, scalar h) const { push_joint_rows(view, all, h, h); }
    void keep(const FigureView& view, int doublings) const {
        keep_joint_motions(view, all, doublings);
        keep_drives(view, all, doublings);
    }

private:
    void solve_once(const FigureView& view, scalar h) const {
        aim_driven_rows(view, all, h);
        begin_passing(view);
        pass_impulses(view);
        settle_joint_rows(view, all, limits::settled_speed);
        begin_passing(view);  // see WithRows
        pass_impulses(view);
    }
};

template <class Rows>
void swing_substep(FigureView& view, const Rows& joint_rows, scalar h) {
    constexpr bool closes = Rows::closes;
    if constexpr (!closes) joint_rows.factor(view, h);
    joint_rows.list(view, h);
    for_groups(view, [&](const auto& rows) { kick_rows(rows, h); });
    begin_solve(view, joint_rows.loops, h);
    joint_rows.solve(view, h);
    end_solve(view, h);
    drift_figures(view, h);
    view.elapsed += h;
    if constexpr (closes) factor_now(view, joint_rows.loops, h);
    push_figures(view, joint_rows.loops, false);
    joint_rows.push(view, h);
}

template <class Rows>
void swing(FigureView& view, const Rows& joint_rows, int substeps) {
    for (int doublings = 0; doublings <= limits::doublings_max; ++doublings) {
        group_figures(view, doublings);
        if (view.group_count == 0) continue;
        const int count = substeps << doublings;
        view.elapsed = 0;
        joint_rows.begin(view, view.h / static_cast<scalar>(count));
        for (int substep_i = 0; substep_i < count; ++substep_i)  // bound: Effort::substeps_max, times eight
            swing_substep(view, joint_rows, view.h / static_cast<scalar>(count));
        ask_for_doublings(view, joint_rows.loops, view.h / static_cast<scalar>(substeps), doublings);
        joint_rows.keep(view, doublings);
        keep_figures(view, doublings);
    }
}

}  // namespace

void swing_figures(FigureView& view, const NoLoops&, int substeps) { swing(view, NoRows{}, substeps); }
void swing_figures(FigureView& view, const LoopView& loops, int substeps) { swing(view, WithLoops{loops}, substeps); }
void swing_figures(FigureView& view, JointRowView& rows, int substeps) { swing(view, WithRows{rows}, substeps); }
void swing_driven_figures(FigureView& view, JointRowView& rows, int substeps) {
    name_driven_balls(view, rows);
    swing(view, DrivenRows{rows}, substeps);
}

} }  // namespace ingot
