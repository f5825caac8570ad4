// SPDX-License-Identifier: MIT
#include "gaining_figures.h"

#include "figure_shares.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Places in Island::sums.
enum : int { gained_at = 0, driven_at = 1 };

/// Islands with drives may gain in sweeps that settle, too. Those are candidates that have more than their bodies would have alone and what their
/// drives give, by the energy of all of their mass at limits::gaining_speed: so who speeds up by an engine is none. True: there are some.
template <class View, class Rows>
bool add_driven(const View& solver, const Rows& rows, const BodyView& bodies, scalar h) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i)  // bound: max_bodies
        solver.islands[island_i].sums[gained_at] = solver.islands[island_i].sums[driven_at] = 0;
    bool some = false;
    for (int i = 0; i < rows.count; ++i) {  // bound: rows_of_joint max_joints
        Island& island = island_of_node(solver, node_of(rows, rows.list[i]));
        if (!rows.list[i].is_drive || !island.in_batch) continue;
        island.sums[driven_at] = 1;
        some = true;
    }
    if (!some) return false;
    const scalar speed_sq = limits::gaining_speed * limits::gaining_speed * solver.unit * solver.unit;
    for_bodies(solver, [&](int body_i) {
        Island& island = solver.islands[solver.island_of[body_i]];
        if (island.sums[driven_at] == 0) return;
        const SolverBody& body = solver.bodies[body_i];
        island.sums[gained_at] += energy_of(solver, bodies, body_i, three_of(body.v_CM), three_of(body.L)) - energy_alone(solver, bodies, body_i, h) -
                               speed_sq / (2 * body.v_CM[3]);
    });
    some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        island.sums[driven_at] = island.sums[gained_at] > 0 && !is_candidate(island) ? scalar(1) : scalar(0);
        if (island.sums[driven_at] == 0) continue;
        island.beta = scalar(0.5);
        some = true;
    }
    if (!some) return false;
    add_work<WorkFrom::alone>(solver, rows, 0);
    some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        if (island.sums[driven_at] == 0) continue;
        if (!(island.sums[gained_at] > island.sums[work_at])) island.beta = 1;
        some = some || is_candidate(island);
    }
    return some;
}

template <class Whole>
bool find_candidates(Whole& whole, [[maybe_unused]] const BodyView& bodies, [[maybe_unused]] scalar h) {
    auto& solver = without_rows(whole);
    bool some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        const bool unsettled = island.in_batch && island.at_bound && island.residual > limits::gaining_residual * solver.unit;
        island.beta = unsettled && solver.jointed.doublings_of[island_i] != 0 ? scalar(0.5) : scalar(1);
        some = some || is_candidate(island);
    }
    if constexpr (Whole::has_drives) some = add_driven(solver, whole.joint_rows, bodies, h) || some;
    if (!some) return false;
    // bound: max_manifolds, rounded up to whole blocks
    for (int position = 0; position < solver.block_count * lanes; ++position) {
        const ContactBlock& block = solver.blocks[position / lanes];
        const int lane_i = position % lanes, last = solver.body_count - 1;
        if (is_spare(block.manifold[lane_i])) continue;
        if (block.body_A[lane_i] > last || block.body_B[lane_i] > last || is_on_belt(solver, position / lanes, lane_i))
            solver.islands[block.island[lane_i]].beta = 1;
    }
    some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) some = some || is_candidate(solver.islands[island_i]);  // bound: max_bodies
    return some;
}

}  // namespace

template <class Whole>
void hold_gaining_figures(Whole& whole, const BodyView& bodies, scalar h) {
    if (!find_candidates(whole, bodies, h)) return;
    give_found_shares<WorkFrom::all>(whole, bodies, h, [](const Island&, const ThreeEnergies& energies) { return energies.share(); });
}

#define INGOT_VIEW(View) template void hold_gaining_figures(View&, const BodyView&, scalar)
INGOT_JOINTED_VIEWS(INGOT_VIEW);
#undef INGOT_VIEW

} }  // namespace ingot
