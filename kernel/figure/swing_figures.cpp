// SPDX-License-Identifier: MIT
#include "swing_figures.h"

#include "../base/limits.h"
#include "build_figures.h"
#include "factor_figures.h"
#include "joint_drives.h"
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

/// Of joints that have nothing but what they lock.
struct NoRows {
    static void begin(const FigureView&, scalar) {}
    static void factor(const FigureView& view, scalar h) { factor_figures(view, h); }
    static void list(const FigureView&, scalar) {}
    static void solve(const FigureView& view, scalar) { pass_impulses(view); }
    static void push(const FigureView&, scalar) {}
    static void keep(const FigureView&, int) {}
};

/// Of joints whose free directions may end.
struct WithRows {
    JointRowView& all;

    void begin(const FigureView& view, scalar) const { begin_joint_motions(view, all); }
    static void factor(const FigureView& view, scalar h) { factor_figures(view, h); }
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
    JointRowView& all;

    void begin(const FigureView& view, scalar h) const {
        begin_joint_motions(view, all);
        place_joints(view);
        factor_figures(view, h);
        respond_figures(view, all.responses);
        begin_drives(view, all);
    }
    void factor(const FigureView& view, scalar h) const {
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
            begin_solve(view, h);
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
    place_joints(view);
    joint_rows.factor(view, h);
    joint_rows.list(view, h);
    for_groups(view, [&](const auto& rows) { kick_rows(rows, h); });
    begin_solve(view, h);
    joint_rows.solve(view, h);
    end_solve(view, h);
    drift_figures(view, h);
    view.elapsed += h;
    push_figures(view, false);
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
        ask_for_doublings(view, view.h / static_cast<scalar>(substeps), doublings);
        joint_rows.keep(view, doublings);
        keep_figures(view, doublings);
    }
}

}  // namespace

void swing_figures(FigureView& view, int substeps) { swing(view, NoRows{}, substeps); }
void swing_figures(FigureView& view, JointRowView& rows, int substeps) { swing(view, WithRows{rows}, substeps); }
void swing_driven_figures(FigureView& view, JointRowView& rows, int substeps) {
    name_driven_balls(view, rows);
    swing(view, DrivenRows{rows}, substeps);
}

} }  // namespace ingot
