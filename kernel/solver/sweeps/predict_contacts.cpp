// SPDX-License-Identifier: MIT
#include "predict_contacts.h"

#include "../../base/limits.h"
#include "../../math/sqrt.h"
#include "../../constraint/block_bodies.h"
#include "../../constraint/row_flight.h"

namespace ingot { inline namespace INGOT_ABI {

void predict_contacts(const SolverView& solver, scalar h) {
    const lane inv_h = splat<lane>(1 / h);
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {  // bound: max_manifolds, rounded up to whole blocks
        ContactBlock& block = solver.blocks[block_i];
        const BodyPairLanes displaced = gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth);
        const Vec3<lane> n = load(block.n);
        const lane apart = dot(n, displaced.linear_A - displaced.linear_B);
        const lane gap = scale_of(solver, block) * splat<lane>(limits::touching_gap);
        for (int row = 0; row < block.rows; ++row)  // bound: 4: block_rows
            store(block.row[row].target, resting_target(separation_now(block, row, apart, displaced), gap, inv_h));
    }
}

} }  // namespace ingot
