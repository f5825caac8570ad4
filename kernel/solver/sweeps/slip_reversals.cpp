// SPDX-License-Identifier: MIT
#include "slip_reversals.h"

#include "../../constraint/block_bodies.h"
#include "../../constraint/contact.h"
#include "../../constraint/jointed_view.h"
#include "../../constraint/locked_view.h"
#include "../../constraint/row_flight.h"
#include "plan_islands.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// m/s, of surfaces against each other.
struct Slip {
    lane u[2];  ///< along t_1 and t_2
};
template <class View>
Slip slip_of(const View& solver, int block_i, const BodyPairLanes& pair) {
    const ContactBlock& block = solver.blocks[block_i];
    const Vec3<lane> between = pair.linear_A - pair.linear_B;
    Slip slip = {{row_speed(block.friction.levers[0], dot(load(block.t_1), between), pair),
                  row_speed(block.friction.levers[1], dot(load(block.t_2), between), pair)}};
    if constexpr (View::has_belts)
        for (int axis = 0; axis < 2; ++axis) slip.u[axis] = slip.u[axis] + load(solver.belts[block_i].speed[axis]);
    return slip;
}
lane product(const Slip& a, const Slip& b) { return a.u[0] * b.u[0] + a.u[1] * b.u[1]; }

lane load_of_normals(const ContactBlock& block) {
    lane N{};
    for (int row = 0; row < block.rows; ++row) N = N + load(block.row[row].j);  // bound: 4: block_rows
    return N;
}

/// Lanes with an impact in this substep, or in the one before: there friction does not go on as before.
mask hit_lanes(const SolverView& solver, const ContactBlock& block, const BodyPairLanes& now, scalar h) {
    mask hit = now.last[1] + now.last[3] > lane{};
    const lane pull = max(gather(solver.bodies, block.body_A, &SolverBody::dp).at[3], gather(solver.bodies, block.body_B, &SolverBody::dp).at[3]);
    const lane approach = dot(load(block.n), now.linear_A - now.linear_B), allowance = splat<lane>(2 * h) * pull;
    for (int row = 0; row < block.rows; ++row) {  // bound: 4: block_rows
        const lane u = row_speed(block.row[row].levers, approach, now);
        hit = either(hit, both(is_used(block, row), is_impact(u, load(block.row[row].target), allowance)));
    }
    return hit;
}

/// Of one block, of which a lane slides. Kept out of begin_reversals, which looks at every block.
template <class View>
INGOT_RARE bool begin_reversals_of(const View& solver, int block_i, scalar h) {
    ContactBlock& block = solver.blocks[block_i];
    FrictionRows& friction = block.friction;
    const Slip before = slip_of(solver, block_i, gather_histories(solver, block, &SolverBodyHistory::v_begin, &SolverBodyHistory::L_begin));
    const BodyPairLanes now = gather_bodies(solver, block, &SolverBody::v_CM, &SolverBody::L);
    const Slip after = slip_of(solver, block_i, now);
    const lane before_sq = product(before, before), one = splat<lane>(1), mu = load(block.mu);
    const lane j[2] = {load(friction.j[0]), load(friction.j[1])}, limit = mu * load_of_normals(block);
    const lane share = select(mask_from_bits(friction.sliding), reversal_share(before_sq, product(before, after), splat<lane>(solver.unit)), lane{});
    mask turns = share > lane{};
    if (!any(turns)) return false;
    turns = both(turns, opposite(hit_lanes(solver, block, now, h)));
    if (!any(turns)) return false;
    const lane against = select(turns, -share * limit / sqrt(select(turns, before_sq, one)), lane{});
    for (int axis = 0; axis < 2; ++axis) {
        const lane given = against * before.u[axis], left = j[axis] - given;
        store(friction.given[axis], given);
        store(friction.j[axis], left);
        store(friction.j_sweep[axis], left);
    }
    const lane share_of_turning = select(turns, share, lane{});
    store(friction.share, share_of_turning);
    store(block.mu, mu * (one - share_of_turning));
    friction.turns_round = true;
    return true;
}

/// Friction of the pair of each lane, as its record has it: that of the block is less while its slip turns round.
lane friction_of_records(const SolverView& solver, const ContactBlock& block) {
    scalar mu[lanes];
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        mu[lane_i] = is_spare(block.manifold[lane_i]) ? 0 : solver.records[solver.pairs[block.manifold[lane_i]].record].mu;
    return load(mu);
}

/// Of one block: see take_back_reversals. In lanes whose normals carry less than was foreseen, friction has one circle again.
bool take_back_reversals_of(const SolverView& solver, ContactBlock& block) {
    FrictionRows& friction = block.friction;
    const lane mu = friction_of_records(solver, block), share = load(friction.share);
    const lane given[2] = {load(friction.given[0]), load(friction.given[1])};
    const lane most = share * mu * load_of_normals(block) * splat<lane>(1 + limits::load_foreseen);
    const mask lost = given[0] * given[0] + given[1] * given[1] > most * most;
    if (!any(lost)) return false;
    for (int axis = 0; axis < 2; ++axis) {
        const lane j = load(friction.j[axis]), whole = select(lost, j + given[axis], j);
        store(friction.j[axis], whole);
        store(friction.j_sweep[axis], select(lost, whole, load(friction.j_sweep[axis])));
        store(friction.given[axis], select(lost, lane{}, given[axis]));
    }
    store(friction.share, select(lost, lane{}, share));
    store(block.mu, select(lost, mu, load(block.mu)));
    bool again = false;
    const uint16_t lost_lanes = bits(lost);
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        if ((lost_lanes >> lane_i & 1u) != 0 && sweep_again(solver, solver.islands[block.island[lane_i]])) again = true;
    return again;
}

/// Of one block: see end_reversals. Only bodies with no other contact are displaced: see displacement_of_reversal.
template <class View>
void end_reversals_of(const View& solver, ContactBlock& block, scalar h) {
    FrictionRows& friction = block.friction;
    friction.turns_round = false;
    store(block.mu, friction_of_records(solver, block));
    uint16_t alone = 0;
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        if (friction.share[lane_i] > 0 && solver.islands[block.island[lane_i]].manifold_count == 1)
            alone = static_cast<uint16_t>(alone | 1u << lane_i);
    auto displaced = held_pair(solver, block, gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth));
    const lane inv_M_A = load(block.inv_M_A), inv_M_B = load(block.inv_M_B), share = load(friction.share);
    for (int axis = 0; axis < 2; ++axis) {
        const lane given = load(friction.given[axis]), j = load(friction.j[axis]) + given;
        store(friction.j[axis], j);
        const lane q = displacement_of_reversal(given, j, share, splat<lane>(h));
        add_linear(displaced, load(axis == 0 ? block.t_1 : block.t_2) * q, inv_M_A, inv_M_B);
    }
    if (alone != 0) scatter_bodies(solver, block, alone, displaced, &SolverBody::dp, &SolverBody::dth);
}

}  // namespace

template <class View>
bool begin_reversals(const View& solver, scalar h) {
    bool some = false;
    for (int block_i = 0; block_i < solver.block_count; ++block_i)  // bound: max_manifolds, rounded up to whole blocks
        if (solver.blocks[block_i].friction.sliding != 0 && begin_reversals_of(solver, block_i, h)) some = true;
    return some;
}

bool take_back_reversals(const SolverView& solver) {
    bool again = false;
    for (int block_i = 0; block_i < solver.block_count; ++block_i)
        if (solver.blocks[block_i].friction.turns_round && take_back_reversals_of(solver, solver.blocks[block_i])) again = true;
    return again;
}

template <class View>
void end_reversals(const View& solver, scalar h) {
    for (int block_i = 0; block_i < solver.block_count; ++block_i)
        if (solver.blocks[block_i].friction.turns_round) end_reversals_of(solver, solver.blocks[block_i], h);
}

// The linker takes the one that the scene calls. Resistance to being rolled has no part in it.
template void end_reversals(const SolverView&, scalar);
template void end_reversals(const LockedView&, scalar);
template bool begin_reversals(const SolverView&, scalar);
template bool begin_reversals(const BeltView&, scalar);
template bool begin_reversals(const RollingBeltView&, scalar);
template bool begin_reversals(const JointedMaterialView&, scalar);
template bool begin_reversals(const LoopedMaterialView&, scalar);

} }  // namespace ingot

#pragma GCC diagnostic pop
