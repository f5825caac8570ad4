// SPDX-License-Identifier: MIT
#include "sweep_velocities.h"

#include "../../base/limits.h"
#include "../../constraint/block_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// What a visit changes: impulses squared times compliance, and the largest speed, of each lane.
struct Change {
    lane size, fastest;

    INGOT_INLINE void add(lane d, lane K) {
        const lane speed = d * K;
        size = size + d * speed;
        fastest = max(fastest, abs(speed));
    }
};

/// Returns the sum of the normals' impulses, which bounds torsion and friction.
template <int rows, bool whole>
INGOT_INLINE lane solve_normals(ContactBlock& block, BodyPairLanes& pair, const Vec3<lane>& n, mask active, Change& change) {
    const lane approach = dot(n, pair.linear_A - pair.linear_B);
    Row4 before, w;
    // bound: 4: block_rows
    for (int row = 0; row < rows; ++row) {
        before.at[row] = load(block.row[row].j);
        const lane speed = (rows == 1 && block.central ? approach : row_speed(block.row[row].levers, approach, pair)) - load(block.row[row].target);
        w.at[row] = rows == 1 ? speed : select(is_used(block, row), speed, lane{});
    }
    const mask none[block_rows] = {};
    const Row4 j = solve_block<rows, true>(block.K, block.B, block.cached_inverse, w, before, none, limits::approach_slack, active);
    lane total{}, given{};
    for (int row = 0; row < rows; ++row) {
        const lane d = j.at[row] - before.at[row];
        if (rows > 1 || !block.central) add_angular(pair, block.row[row].levers, d);
        given = given + d;
        total = total + j.at[row];
        change.add(d, load(block.K[Sym4::index(row, row)]));
        store_if<whole>(block.row[row].j, active, j.at[row]);
    }
    add_linear(pair, n * given, load(block.inv_M_A), load(block.inv_M_B));
    return total;
}

template <bool whole>
INGOT_INLINE void solve_torsion(TorsionRow& torsion, BodyPairLanes& pair, const Vec3<lane>& n, lane inv_M_A, lane inv_M_B, lane limit, mask active,
                              Change& change) {
    const lane spin = dot(pair.angular_A, load(torsion.k_A)) + dot(pair.angular_B, load(torsion.k_B));
    const lane before = load(torsion.j), radius = load(torsion.radius), K = load(torsion.K);
    const lane j = clamp(before - spin * load(torsion.inv_K), limit * radius), d = j - before;
    add_torsion(pair, n, d, inv_M_A, inv_M_B);
    store_if<whole>(torsion.j, active, j);
    change.size = change.size + d * d * K;
    change.fastest = max(change.fastest, abs(d * K) * radius);
}

template <bool whole>
INGOT_INLINE void solve_rolling(RollingRows& rolling, BodyPairLanes& pair, const ContactBlock& block, lane load_of_normals, mask active,
                                Change& change) {
    const lane u_1 = dot(pair.angular_A, load(rolling.k_A[0])) + dot(pair.angular_B, load(rolling.k_B[0]));
    const lane u_2 = dot(pair.angular_A, load(rolling.k_A[1])) + dot(pair.angular_B, load(rolling.k_B[1]));
    const auto [d_1, d_2] = solve_pair<whole>(rolling, u_1, u_2, load(rolling.lever) * load_of_normals, active);
    const lane inv_M_A = load(block.inv_M_A), inv_M_B = load(block.inv_M_B);
    add_torsion(pair, load(block.t_1), d_1, inv_M_A, inv_M_B);
    add_torsion(pair, load(block.t_2), d_2, inv_M_A, inv_M_B);
    const lane spin_1 = d_1 * load(rolling.K[0]), spin_2 = d_2 * load(rolling.K[1]);
    change.size = change.size + (d_1 * spin_1 + d_2 * spin_2);
    change.fastest = max(change.fastest, max(abs(spin_1), abs(spin_2)) * load(rolling.size));
}

template <bool whole, class View>
INGOT_INLINE void solve_friction([[maybe_unused]] const View& solver, [[maybe_unused]] int block_i, ContactBlock& block, BodyPairLanes& pair,
                                 lane limit, mask active, Change& change) {
    FrictionPair& friction = block.friction;
    const Vec3<lane> t_1 = load(block.t_1), t_2 = load(block.t_2), slip = pair.linear_A - pair.linear_B;
    lane u_1 = row_speed(friction.levers[0], dot(t_1, slip), pair), u_2 = row_speed(friction.levers[1], dot(t_2, slip), pair);
    if constexpr (View::has_belts) {
        u_1 = u_1 + load(solver.belts[block_i].speed[0]);
        u_2 = u_2 + load(solver.belts[block_i].speed[1]);
    }
    const auto [d_1, d_2] = solve_pair<whole>(friction, u_1, u_2, limit, active);
    add_linear(pair, t_1 * d_1 + t_2 * d_2, load(block.inv_M_A), load(block.inv_M_B));
    add_angular(pair, friction.levers[0], d_1);
    add_angular(pair, friction.levers[1], d_2);
    change.add(d_1, load(friction.K[0]));
    change.add(d_2, load(friction.K[1]));
}

INGOT_INLINE BodyPairLanes chosen(mask m, const BodyPairLanes& a, const BodyPairLanes& b) {
    BodyPairLanes pair = {select(m, a.linear_A, b.linear_A), select(m, a.angular_A, b.angular_A), select(m, a.linear_B, b.linear_B),
                          select(m, a.angular_B, b.angular_B), {}};
    for (int i = 0; i < 4; ++i) pair.last[i] = select(m, a.last[i], b.last[i]);
    return pair;
}

/// Normals, torsion, rolling resistance, friction of the active lanes. `whole`: of all.
template <int rows, bool whole, class View>
INGOT_INLINE void solve_rows(const View& solver, int block_i, ContactBlock& block, BodyPairLanes& pair, mask visited, mask active, scalar sweep,
                             scalar active_threshold, lane& residual) {
    const Vec3<lane> n = load(block.n);
    const lane inv_M_A = load(block.inv_M_A), inv_M_B = load(block.inv_M_B);
    const BodyPairLanes before = pair;
    Change change{};
    const lane load_of_normals = solve_normals<rows, whole>(block, pair, n, active, change), limit = load(block.mu) * load_of_normals;
    if constexpr (rows > 1)  // one point has no lever to resist a torsion with
        solve_torsion<whole>(block.torsion, pair, n, inv_M_A, inv_M_B, limit, active, change);
    if constexpr (View::rolls) solve_rolling<whole>(solver.rolling[block_i], pair, block, load_of_normals, active, change);
    solve_friction<whole>(solver, block_i, block, pair, limit, active, change);
    const mask moves = change.fastest > splat<lane>(active_threshold);
    pair.last[1] = select(both(moves, inv_M_A > lane{}), splat<lane>(sweep), pair.last[1]);
    pair.last[3] = select(both(moves, inv_M_B > lane{}), splat<lane>(sweep), pair.last[3]);
    if (!whole) pair = chosen(active, pair, before);
    residual = max(residual, whole ? change.fastest : select(active, change.fastest, residual));
    store_if<whole>(block.change, visited, whole ? change.size : select(active, change.size, lane{}));
}

/// Solves what one visit names, but for the lanes whose bodies neither this sweep nor the one before has stirred.
template <int rows, class View>
INGOT_INLINE void visit_velocities(const View& solver, int block_i, ContactBlock& block, uint16_t lane_bits, int sweep_i, scalar active_threshold,
                                   lane& residual) {
    const scalar sweep = static_cast<scalar>(sweep_i);
    const LaneQuad L_A = gather(solver.bodies, block.body_A, &SolverBody::L), L_B = gather(solver.bodies, block.body_B, &SolverBody::L);
    const mask visited = lanes_of(lane_bits);
    mask active = visited;
    if (sweep_i > 1) active = both(visited, max(L_A.at[3], L_B.at[3]) >= splat<lane>(sweep - 1));
    if (!any(active)) return store_if<false>(block.change, visited, lane{});
    const LaneQuad v_A = gather(solver.bodies, block.body_A, &SolverBody::v_CM), v_B = gather(solver.bodies, block.body_B, &SolverBody::v_CM);
    BodyPairLanes pair = {vector_of(v_A), vector_of(L_A), vector_of(v_B), vector_of(L_B), {v_A.at[3], L_A.at[3], v_B.at[3], L_B.at[3]}};
    if (any(opposite(active)))
        solve_rows<rows, false>(solver, block_i, block, pair, visited, active, sweep, active_threshold, residual);
    else
        solve_rows<rows, true>(solver, block_i, block, pair, visited, active, sweep, active_threshold, residual);
    scatter_bodies(solver, block, lane_bits, pair, &SolverBody::v_CM, &SolverBody::L);
}

}  // namespace

template <class View>
scalar sweep_velocities(const View& solver, int sweep_i, bool up, scalar active_threshold) {
    lane residual{};
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {  // bound: max_manifolds
        const Visit visit = solver.visits[up ? visit_i : solver.visit_count - 1 - visit_i];
        ContactBlock& block = solver.blocks[visit.block];
        if (block.rows == 1)
            visit_velocities<1>(solver, visit.block, block, visit.lane_bits, sweep_i, active_threshold, residual);
        else
            visit_velocities<block_rows>(solver, visit.block, block, visit.lane_bits, sweep_i, active_threshold, residual);
    }
    scalar of_lanes[lanes], largest = 0;
    store(of_lanes, residual);
    for (const scalar one : of_lanes) largest = one > largest ? one : largest;
    return largest;
}

// The linker takes the one that the scene calls.
template scalar sweep_velocities(const SolverView&, int, bool, scalar);
template scalar sweep_velocities(const RollingView&, int, bool, scalar);
template scalar sweep_velocities(const BeltView&, int, bool, scalar);
template scalar sweep_velocities(const RollingBeltView&, int, bool, scalar);

/// The sum does not depend on lanes: the k-th manifold of a colour is added to the k mod 8-th of eight sums.
scalar sum_of_changes(const SolverView& solver) {
    scalar sums[8] = {};
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {
        const Visit visit = solver.visits[visit_i];
        const scalar* const change = solver.blocks[visit.block].change;
        if (is_all(visit.lane_bits) && visit.first % lanes == 0) {
            scalar* const to = sums + visit.first % 8;
            store(to, load(to) + load(change));
            continue;
        }
        unsigned k = visit.first;
        // bound: lanes: lane_bits has a bit a lane
        for (unsigned lane_i = 0, left = visit.lane_bits; left != 0; ++lane_i, left >>= 1)
            if ((left & 1u) != 0) sums[k++ % 8] += change[lane_i];
    }
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

} }  // namespace ingot
