// SPDX-License-Identifier: MIT
#include "passive_bounces.h"

#include "../../constraint/block_bodies.h"
#include "../../constraint/contact.h"
#include "../../constraint/jointed_view.h"
#include "../../constraint/locked_view.h"
#include "../../constraint/row_flight.h"
#include "plan_islands.h"
#include "sequence_impacts.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// The motion about an impact: before it, after it, and what forces change it by in a second.
struct AboutImpact {
    BodyPairLanes before, after, forces;
    scalar now, h;       ///< s
    bool is_solved_last;  ///< velocities are those of the end of the substep; else of its begin, as if forces came later

    /// s, for which forces have acted after the impact, in what targets say.
    lane after_impact(lane when) const { return is_solved_last ? splat<lane>(h) - when : -(splat<lane>(now) + when); }
    /// s, of forces to add to the sum of both slips.
    lane shift() const { return splat<lane>(is_solved_last ? -h : 2 * now); }
};

lane seen_speed(const SeenRow& row, const BodyPairLanes& pair) {
    const lane turning = dot(pair.angular_A, load(row.k_A)) + dot(pair.angular_B, load(row.k_B));
    return row.levers == nullptr ? turning : turning + dot(load(row.d), pair.linear_A - pair.linear_B);
}

mask bounced_lanes(const ContactBlock& block) {
    mask bounced = splat<lane>(1) < lane{};
    for (int row = 0; row < block.rows; ++row) bounced = either(bounced, bounces(block.row[row]));  // bound: 4: block_rows
    return bounced;
}

/// Islands of blocks at hand have left the batch, while others are solved again.
template <class View>
bool some_stand([[maybe_unused]] const View& solver) {
    if constexpr (View::articulates)
        return solver.jointed.some_stand;
    else
        return false;
}

/// Those of the lanes whose islands may be swept again: what has no sweeps left keeps its bounces.
template <class View>
mask lanes_with_sweeps(const View& solver, const ContactBlock& block, mask some) {
    if (solver.sweeps_of_step == no_budget && !some_stand(solver)) return some;
    unsigned with = bits(some);
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        if (block.island[lane_i] == no_island) continue;
        const Island& island = solver.islands[block.island[lane_i]];
        if (spare_sweeps(solver, island) + 1 < 1 || (some_stand(solver) && !island.in_batch)) with &= ~(1u << lane_i);
    }
    return mask_from_bits(static_cast<uint16_t>(with));
}

/// What belts add to the slip of a friction row.
template <class View>
lane belt_speed([[maybe_unused]] const View& solver, [[maybe_unused]] int block_i, [[maybe_unused]] int axis) {
    if constexpr (View::has_belts)
        if (axis >= 0 && axis < 2) return load(solver.belts[block_i].speed[axis]);
    return lane{};
}

/// Lowers the bounces of a block's manifolds that gain. Returns the lanes.
template <class View>
mask lower_bounces_of(const View& solver, int block_i, const AboutImpact& about, mask lanes_asked) {
    ContactBlock& block = solver.blocks[block_i];
    const int rows = View::points_max == 1 ? 1 : block.rows;
    const lane half = splat<lane>(scalar(0.5)), step = splat<lane>(about.h);
    const Vec3<lane> n = load(block.n);
    const BodyPairLanes displaced = gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth);
    const lane apart = dot(n, displaced.linear_A - displaced.linear_B);
    const lane approach = dot(n, about.before.linear_A - about.before.linear_B), pull = dot(n, about.forces.linear_A - about.forces.linear_B);
    const lane parting = dot(n, about.after.linear_A - about.after.linear_B);
    lane work{}, size{}, slope{}, leaving[block_rows], rest[block_rows], a[block_rows], left_deep[block_rows];
    mask bounced[block_rows];
    for (int row = 0; row < rows; ++row) {  // bound: 4: block_rows
        const RowFlight<lane> begin = {separation_now(block, row, apart, displaced), row_speed(block.row[row].levers, approach, about.before),
                                       row_speed(block.row[row].levers, pull, about.forces)};
        const RowFlight<lane> from = flight_from(begin, splat<lane>(about.now));
        const RowImpact<lane> impact = impact_of(from, step - splat<lane>(about.now), solver.unit);
        const lane j = load(block.row[row].j);
        left_deep[row] = overlap_left(begin.s, step, solver.unit);
        bounced[row] = both(both(bounces_off(impact, load(block.e)), is_used(block, row)), j > lane{});
        a[row] = from.a;
        rest[row] = about.after_impact(impact.when);
        leaving[row] = load(block.row[row].target) - a[row] * rest[row];
        const lane left = row_speed(block.row[row].levers, parting, about.after) - a[row] * rest[row];  // as the sweeps left it
        work = work + select(bounced[row], j * (impact.speed + left) * half, lane{});
        size = size + select(bounced[row], j * abs(impact.speed), lane{});
        const lane spread = leaving[row] - impact.speed;
        const lane felt = j * leaving[row] * leaving[row] / select(spread > lane{}, spread, step);
        slope = slope + select(both(bounced[row], spread > lane{}), felt, lane{});
    }
    ContactConstraint<View>::Given::for_rows(solver, block_i, [&](const SeenRow& row) {
        if (row.number < friction_row) return;
        const lane belt = belt_speed(solver, block_i, row.number - friction_row);
        const lane both_slips = seen_speed(row, about.before) + seen_speed(row, about.after) + seen_speed(row, about.forces) * about.shift();
        work = work + load(row.j) * (both_slips * half + belt);
    });
    const mask gains = both(lanes_asked, both(work > splat<lane>(8 * epsilon) * size, slope > lane{}));
    if (!any(gains)) return gains;
    const lane part = max(splat<lane>(1) - work * splat<lane>(scalar(1.125)) / select(gains, slope, splat<lane>(1)), lane{});
    for (int row = 0; row < rows; ++row) {
        const mask lower = both(gains, bounced[row]);
        const lane speed = leaving[row] * part;
        store(block.row[row].target, select(lower, speed + a[row] * rest[row], load(block.row[row].target)));
        if (!about.is_solved_last) continue;
        const lane way = speed * rest[row] + a[row] * rest[row] * rest[row] * half;
        store(block.row[row].landing, select(lower, way + left_deep[row], load(block.row[row].landing)));
    }
    return gains;
}

}  // namespace

template <class View>
bool lower_bounces(const View& solver, scalar h) {
    if (!solver.some_bounce) return false;
    bool some = false;
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {  // bound: max_manifolds, rounded up to whole blocks
        ContactBlock& block = solver.blocks[block_i];
        const mask bounced = lanes_with_sweeps(solver, block, bounced_lanes(block));
        if (!any(bounced)) continue;
        const AboutImpact about = {gather_histories(solver, block, &SolverBodyHistory::v_begin, &SolverBodyHistory::L_begin),
                                   gather_bodies(solver, block, &SolverBody::v_CM, &SolverBody::L),
                                   gather_histories(solver, block, &SolverBodyHistory::a, &SolverBodyHistory::tau), 0, h, true};
        const mask lowered = lower_bounces_of(solver, block_i, about, bounced);
        if (!any(lowered)) continue;
        for (unsigned lane_i = 0, left = bits(lowered); left != 0; ++lane_i, left >>= 1) {  // bound: lanes
            if ((left & 1u) == 0 || block.island[lane_i] == no_island) continue;
            if (sweep_again(solver, solver.islands[block.island[lane_i]])) some = true;
        }
    }
    return some;
}

template <class View>
void take_back_bounces(const View& solver, scalar h) {
    if (!solver.some_bounce) return;
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {  // bound: max_manifolds
        const Visit& visit = solver.visits[visit_i];
        const ContactBlock& block = solver.blocks[visit.block];
        const mask bounced = both(both(bounced_lanes(block), lanes_of(visit.lane_bits)), opposite(leaning_lanes(solver, block)));
        if (!any(bounced)) continue;
        const BodyPairLanes begin = gather_histories(solver, block, &SolverBodyHistory::v_begin, &SolverBodyHistory::L_begin);
        const BlockFlight flight = flight_of(solver, block, begin);
        auto displaced = held_pair(solver, block, gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth));
        const lane inv_M_A = load(block.inv_M_A), inv_M_B = load(block.inv_M_B), one = splat<lane>(1);
        lane sum{}, weighted{};
        ContactConstraint<View>::Given::for_rows(solver, visit.block, [&](const SeenRow& row) {
            const lane j = load(row.j);
            lane when = select(sum > lane{}, weighted / select(sum > lane{}, sum, one), lane{});  // of friction: the mean of its normals
            if (row.number < block_rows) {
                const RowImpact<lane> impact = impact_of(flight.row[row.number], splat<lane>(h), solver.unit);
                when = select(bounces(block.row[row.number]), impact.when, lane{});
                sum = sum + j;
                weighted = weighted + j * when;
            }
            push_along(displaced, row, select(bounced, -j * when, lane{}), inv_M_A, inv_M_B);
        });
        scatter_bodies(solver, block, bits(bounced), displaced, &SolverBody::dp, &SolverBody::dth);
    }
}

template <class View>
bool lower_impact(const View& solver, int block_i, int lane_i, scalar now, scalar h) {
    const ContactBlock& block = solver.blocks[block_i];
    const AboutImpact about = {gather_histories(solver, block, &SolverBodyHistory::v_sweep, &SolverBodyHistory::L_sweep),
                               gather_bodies(solver, block, &SolverBody::v_CM, &SolverBody::L),
                               gather_histories(solver, block, &SolverBodyHistory::a, &SolverBodyHistory::tau), now, h, false};
    return any(lower_bounces_of(solver, block_i, about, mask_from_bits(static_cast<uint16_t>(1u << lane_i))));
}

// The linker takes the one that the scene calls.
#define INGOT_VIEW(View)                                  \
    template bool lower_bounces(const View&, scalar); \
    template void take_back_bounces(const View&, scalar); \
    template bool lower_impact(const View&, int, int, scalar, scalar)
INGOT_VIEW(SolverView);
INGOT_VIEW(JointedView);
INGOT_VIEW(LoopedView);
INGOT_VIEW(JointedMaterialView);
INGOT_VIEW(LoopedMaterialView);
INGOT_VIEW(BallView);
INGOT_VIEW(RollingView);
INGOT_VIEW(BeltView);
INGOT_VIEW(RollingBeltView);
#undef INGOT_VIEW
template void take_back_bounces(const LockedView&, scalar);

} }  // namespace ingot

#pragma GCC diagnostic pop
