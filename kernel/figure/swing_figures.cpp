// SPDX-License-Identifier: MIT
#include "swing_figures.h"

#include "../base/limits.h"
#include "build_figures.h"
#include "factor_figures.h"
#include "keep_figures.h"
#include "move_figures.h"

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

void swing_substep(FigureView& view, scalar h) {
    place_joints(view);
    factor_figures(view, h);
    for_groups(view, [&](const auto& rows) { kick_rows(rows, h); });
    begin_solve(view, h);
    pass_impulses(view);
    end_solve(view, h);
    drift_figures(view, h);
    view.elapsed += h;
    push_figures(view, false);
}

}  // namespace

void swing_figures(FigureView& view, int substeps) {
    for (int doublings = 0; doublings <= limits::doublings_max; ++doublings) {
        group_figures(view, doublings);
        if (view.group_count == 0) continue;
        const int count = substeps << doublings;
        view.elapsed = 0;
        for (int substep_i = 0; substep_i < count; ++substep_i)  // bound: Effort::substeps_max, times eight
            swing_substep(view, view.h / static_cast<scalar>(count));
        ask_for_doublings(view, view.h / static_cast<scalar>(substeps), doublings);
        keep_figures(view, doublings);
    }
}

} }  // namespace ingot
