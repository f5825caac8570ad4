// SPDX-License-Identifier: MIT
#include "note_impulses.h"

namespace ingot { inline namespace INGOT_ABI {

void clear_impulse_notes(const SolverView& solver, ImpactNote* notes) {
    // bound: max_manifolds
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) notes[manifold_i].carried = false;
}

void note_impulses(const SolverView& solver, ImpactNote* notes) {
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {  // bound: max_manifolds
        const ContactBlock& block = solver.blocks[block_i];
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            if (block.manifold[lane_i] == no_manifold) continue;
            bool carried = false;
            for (int row = 0; row < block.rows; ++row) carried = carried || block.row[row].j[lane_i] > 0;  // bound: 4
            if (carried) notes[block.manifold[lane_i]].carried = true;
        }
    }
}

} }  // namespace ingot
