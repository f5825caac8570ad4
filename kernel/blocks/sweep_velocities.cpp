// SPDX-License-Identifier: MIT
#include "sweep_velocities.h"

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "block_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Solves the rows of one visit: normals, twist, friction; the lanes of it are stored.
template <int rows, bool whole>
INGOT_INLINE void visit_velocities(const SolverView& solver, ContactBlock& block, uint16_t lane_bits, lane& residual) {
    const mask active = whole ? splat<lane>(1) > lane{} : mask_from_bits(lane_bits);
    const Vec3<lane> n = load(block.n);
    const lane inv_M_A = load(block.inv_M_A), inv_M_B = load(block.inv_M_B);
    BodyPairLanes pair = gather_bodies(solver, block, &SolverBody::v_CM, &SolverBody::L);

    const lane approach = dot(n, pair.linear_A - pair.linear_B);
    Row4 before, w;
    for (int row = 0; row < rows; ++row) {
        before.at[row] = load(block.row[row].j);
        w.at[row] = row_speed(block.row[row].levers, approach, pair) - load(block.row[row].target);
    }
    const mask none[block_rows] = {};
    const Row4 j = solve_block<rows, true>(block.K, block.B, block.held, w, before, none, limits::approach_slack, active);
    lane total{}, given{}, change{}, fastest{};
    for (int row = 0; row < rows; ++row) {
        const lane d = j.at[row] - before.at[row], speed = d * load(block.K[Sym4::index(row, row)]);
        add_angular(pair, block.row[row].levers, d);
        given = given + d;
        total = total + j.at[row];
        change = change + d * speed;
        fastest = greatest(fastest, abs(speed));
        store_if<whole>(block.row[row].j, active, j.at[row]);
    }
    add_linear(pair, n * given, inv_M_A, inv_M_B);

    const lane limit = load(block.mu) * total;
    if constexpr (rows > 1) {  // one point has no lever to resist a twist with
        const lane spin = dot(pair.angular_A, load(block.twist.k_A)) + dot(pair.angular_B, load(block.twist.k_B));
        const lane twist_before = load(block.twist.j);
        const lane twist = clamped(twist_before - spin * load(block.twist.inv_K), limit * load(block.twist.radius));
        const lane twisted = twist - twist_before;
        add_twist(pair, n, twisted, inv_M_A, inv_M_B);
        store_if<whole>(block.twist.j, active, twist);
        change = change + twisted * twisted * load(block.twist.K);
        fastest = greatest(fastest, abs(twisted * load(block.twist.K)) * load(block.twist.radius));
    }

    const Vec3<lane> t_1 = load(block.t_1), t_2 = load(block.t_2), slip = pair.linear_A - pair.linear_B;
    const lane u_1 = row_speed(block.friction.levers[0], dot(t_1, slip), pair), u_2 = row_speed(block.friction.levers[1], dot(t_2, slip), pair);
    const lane i11 = load(block.friction.inv_K[0]), i12 = load(block.friction.inv_K[1]), i22 = load(block.friction.inv_K[2]);
    const lane j_1 = load(block.friction.j[0]), j_2 = load(block.friction.j[1]);
    lane next_1 = j_1 - (i11 * u_1 + i12 * u_2), next_2 = j_2 - (i12 * u_1 + i22 * u_2);
    cut_to_cone(next_1, next_2, limit);
    const lane d_1 = next_1 - j_1, d_2 = next_2 - j_2;
    add_linear(pair, t_1 * d_1 + t_2 * d_2, inv_M_A, inv_M_B);
    add_angular(pair, block.friction.levers[0], d_1);
    add_angular(pair, block.friction.levers[1], d_2);
    store_if<whole>(block.friction.j[0], active, next_1);
    store_if<whole>(block.friction.j[1], active, next_2);
    const lane speed_1 = d_1 * load(block.friction.K[0]), speed_2 = d_2 * load(block.friction.K[1]);
    change = change + (d_1 * speed_1 + d_2 * speed_2);
    fastest = greatest(fastest, greatest(abs(speed_1), abs(speed_2)));
    residual = greatest(residual, select(active, fastest, residual));
    store_if<whole>(block.change, active, change);
    scatter_bodies(solver, block, lane_bits, pair, &SolverBody::v_CM, &SolverBody::L);
}

/// The sum does not depend on lanes: the k-th manifold is added to the k mod 8-th of eight sums.
scalar sum_of_changes(const SolverView& solver) {
    scalar sums[8] = {};
    unsigned manifold = 0;
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {
        const Visit visit = solver.visits[visit_i];
        const scalar* const change = solver.blocks[visit.block].change;
        for (unsigned lane_i = 0, left = visit.lane_bits; left != 0; ++lane_i, left >>= 1)
            if ((left & 1u) != 0 && solver.blocks[visit.block].manifold[lane_i] != no_manifold) sums[manifold++ % 8] += change[lane_i];
    }
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

}  // namespace

SweepResult sweep_velocities(const SolverView& solver, bool up) {
    lane residual{};
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {
        const Visit visit = solver.visits[up ? visit_i : solver.visit_count - 1 - visit_i];
        ContactBlock& block = solver.blocks[visit.block];
        const bool whole = visit.lane_bits == all_lanes;
        if (block.rows == 1)
            whole ? visit_velocities<1, true>(solver, block, visit.lane_bits, residual) : visit_velocities<1, false>(solver, block, visit.lane_bits, residual);
        else
            whole ? visit_velocities<block_rows, true>(solver, block, visit.lane_bits, residual)
                  : visit_velocities<block_rows, false>(solver, block, visit.lane_bits, residual);
    }
    scalar of_lanes[lanes], largest = 0;
    store(of_lanes, residual);
    for (const scalar one : of_lanes) largest = one > largest ? one : largest;
    return {sum_of_changes(solver), largest};
}

} }  // namespace ingot
