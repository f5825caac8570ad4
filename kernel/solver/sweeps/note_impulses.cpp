// SPDX-License-Identifier: MIT
#include "note_impulses.h"

namespace ingot { inline namespace INGOT_ABI {

void clear_impulse_notes(const SolverView& solver, ImpactNote* notes) {
    for (int position = 0; position < solver.lane_count; ++position)  // bound: max_manifolds, rounded up to whole blocks
        if (manifold_at(solver, position) != no_manifold) notes[manifold_at(solver, position)].carried = false;
}

void note_impulses(const SolverView& solver, ImpactNote* notes) {
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {  // bound: max_manifolds, rounded up to whole blocks
        const ContactBlock& block = solver.blocks[block_i];
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            if (block.manifold[lane_i] == no_manifold) continue;
            bool carried = false;
            for (int row = 0; row < block.rows; ++row) carried = carried || block.row[row].j[lane_i] > 0;  // bound: 4: block_rows
            if (carried) notes[block.manifold[lane_i]].carried = true;
        }
    }
}

} }  // namespace ingot
