// SPDX-License-Identifier: MIT
#include "note_impulses.h"

namespace ingot { inline namespace INGOT_ABI {

void clear_impulse_notes(const SolverView& solver, const StepNotes& notes) {
    for (int position = 0; position < solver.lane_count; ++position) {  // bound: max_manifolds, rounded up to whole blocks
        const Index manifold_i = manifold_at(solver, position);
        if (is_spare(manifold_i)) continue;
        if (notes.impacts != nullptr) notes.impacts[manifold_i].carried = false;
        if (notes.sums != nullptr) notes.sums[solver.pairs[manifold_i].record] = {};
    }
}

void add_to_sum(const SolverView& solver, const ContactBlock& block, int lane_i, ImpulseSum* sums) {
    ImpulseSum& sum = sums[solver.pairs[block.manifold[lane_i]].record];
    for (int row = 0; row < block.rows; ++row)  // bound: 4: block_rows
        if (static_cast<scalar>(row) < block.count[lane_i]) sum.j[row] += block.row[row].j[lane_i];
    sum.friction += lane_of(block.t_1, lane_i) * block.friction.j[0][lane_i] + lane_of(block.t_2, lane_i) * block.friction.j[1][lane_i];
}

void note_impulses(const SolverView& solver, const StepNotes& notes) {
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {  // bound: max_manifolds, rounded up to whole blocks
        const ContactBlock& block = solver.blocks[block_i];
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            if (is_spare(block.manifold[lane_i])) continue;
            bool carried = false;
            for (int row = 0; row < block.rows; ++row) carried = carried || block.row[row].j[lane_i] > 0;  // bound: 4: block_rows
            if (carried && notes.impacts != nullptr) notes.impacts[block.manifold[lane_i]].carried = true;
            if (notes.sums != nullptr) add_to_sum(solver, block, lane_i, notes.sums);
        }
    }
}

} }  // namespace ingot
