// SPDX-License-Identifier: MIT
#include "sweep_positions.h"

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "block_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

template <int rows>
INGOT_INLINE void visit_positions(const SolverView& solver, ContactBlock& block, uint16_t lane_bits, scalar h) {
    const lane share = splat<lane>(limits::position_share), deepest = splat<lane>(-limits::push_speed_max * h);
    const lane settled = splat<lane>(-limits::settled_gap);
    const Vec3<lane> n = load(block.n);
    BodyPairLanes pair = gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth);
    const lane apart = dot(n, pair.linear_A - pair.linear_B);
    Row4 w;
    mask pulls[block_rows], off = splat<lane>(1) < lane{};
    for (int row = 0; row < rows; ++row) {
        const lane s = separation_now(block, row, apart, pair);
        const mask lands = bounces(block.row[row]), pressed = load(block.row[row].j) > lane{};
        const lane wanted = select(either(pressed, s < lane{}), greatest(s * share, deepest), s);
        pulls[row] = either(lands, pressed);
        w.at[row] = select(lands, s - load(block.row[row].landing), wanted);
        off = either(off, select(pulls[row], -abs(w.at[row]), w.at[row]) < settled);
    }
    if (!any(off)) return;
    const Row4 none = {};
    const mask active = mask_from_bits(lane_bits);
    const Row4 q = solve_block<rows, false>(block.K, block.B, block.held, w, none, pulls, limits::approach_slack * h, active);
    lane sum{};
    for (int row = 0; row < rows; ++row) {
        const lane push = select(off, q.at[row], lane{});
        turn_by_push(pair, block.row[row].levers, push);
        sum = sum + push;
    }
    add_linear(pair, n * sum, load(block.inv_M_A), load(block.inv_M_B));
    scatter_bodies(solver, block, lane_bits, pair, &SolverBody::dp, &SolverBody::dth);
}

}  // namespace

void sweep_positions(const SolverView& solver, scalar h) {
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {
        const Visit visit = solver.visits[visit_i];
        ContactBlock& block = solver.blocks[visit.block];
        if (block.rows == 1)
            visit_positions<1>(solver, block, visit.lane_bits, h);
        else
            visit_positions<block_rows>(solver, block, visit.lane_bits, h);
    }
}

} }  // namespace ingot
