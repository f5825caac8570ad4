// SPDX-License-Identifier: MIT
#include "predict_contacts.h"

#include "../../constraint/row_flight.h"
#include "sequence_impacts.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Points that bounce within the substep leave with what gravity gives them after the impact, from where they meet; those that do not meet
/// are left alone, unless their bodies are part of a heap that presses on them.
void predict_bounces_of(ContactBlock& block, const SolverView& solver, scalar h) {
    const BlockFlight flight = flight_of(solver, block);
    const lane step = splat<lane>(h), e = load(block.e);
    const mask leans = leaning_lanes(solver, block);
    for (int row = 0; row < block.rows; ++row) {  // bound: 4: block_rows
        const RowFlight<lane>& from = flight.row[row];
        const RowImpact<lane> impact = impact_of(from, step, solver.unit);
        const mask bounces = both(bounces_off(impact, e), is_used(block, row)), flies = both(opposite(impact.meets), e > lane{});
        const RowLanding<lane> landing = landing_of(from, impact, e, step, solver.unit);
        const lane resting = load(block.row[row].target);
        const lane flying = select(leans, flying_target(from, resting, step), no_bound(from, step));
        store(block.row[row].target, select(bounces, landing.speed, select(flies, flying, resting)));
        store(block.row[row].landing, select(bounces, landing.s, splat<lane>(limits::unbounded)));
    }
}

}  // namespace

void predict_bounces(const SolverView& solver, scalar h) {
    if (!solver.some_bounce) return;
    for (int block_i = 0; block_i < solver.block_count; ++block_i)  // bound: max_manifolds
        if (any(load(solver.blocks[block_i].e) > lane{})) predict_bounces_of(solver.blocks[block_i], solver, h);
}

} }  // namespace ingot
