// SPDX-License-Identifier: MIT
#include "gaining_figures.h"

#include "figure_shares.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

bool find_candidates(const SolverView& solver, const JointedBodies& jointed) {
    bool some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        const bool unsettled = island.in_batch && island.at_bound && island.residual > limits::gaining_residual * solver.unit;
        island.beta = unsettled && jointed.doublings_of[island_i] != 0 ? scalar(0.5) : scalar(1);
        some = some || is_candidate(island);
    }
    if (!some) return false;
    // bound: max_manifolds, rounded up to whole blocks
    for (int position = 0; position < solver.block_count * lanes; ++position) {
        const ContactBlock& block = solver.blocks[position / lanes];
        const int lane_i = position % lanes, last = solver.body_count - 1;
        if (block.manifold[lane_i] != no_manifold && (block.body_A[lane_i] > last || block.body_B[lane_i] > last))
            solver.islands[block.island[lane_i]].beta = 1;
    }
    some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) some = some || is_candidate(solver.islands[island_i]);
    return some;
}

}  // namespace

template <class Whole>
void hold_gaining_figures(Whole& whole, const BodyView& bodies, scalar h) {
    auto& solver = without_rows(whole);
    if (!find_candidates(solver, solver.jointed)) return;
    give_found_shares(whole, bodies, h, [](const Island&, const ThreeEnergies& energies) { return energies.share(); });
}

// The linker takes the one that the scene calls. Belts give energy.
template void hold_gaining_figures(JointedView&, const BodyView&, scalar);
template void hold_gaining_figures(LoopedView&, const BodyView&, scalar);
template void hold_gaining_figures(RowedView&, const BodyView&, scalar);
template void hold_gaining_figures(DrivenView&, const BodyView&, scalar);
template void hold_gaining_figures(LoopedRowedView&, const BodyView&, scalar);

} }  // namespace ingot
