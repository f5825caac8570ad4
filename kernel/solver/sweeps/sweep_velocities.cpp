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
    for (int row = 0; row < rows; ++row) {  // bound: 4: block_rows
        before.at[row] = load(block.row[row].j);
        const lane speed = (rows == 1 && block.central ? approach : row_speed(block.row[row].levers, approach, pair)) - load(block.row[row].target);
        w.at[row] = rows == 1 ? speed : select(is_used(block, row), speed, lane{});
    }
    const mask none[block_rows] = {};
    const Row4 j = solve_block<rows, true>(block.K, block.count, block.cached_inverse, w, before, none, limits::approach_slack, active);
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
                             lane active_threshold) {
    const Vec3<lane> n = load(block.n);
    const lane inv_M_A = load(block.inv_M_A), inv_M_B = load(block.inv_M_B);
    const BodyPairLanes before = pair;
    Change change{};
    const lane load_of_normals = solve_normals<rows, whole>(block, pair, n, active, change), limit = load(block.mu) * load_of_normals;
    if constexpr (rows > 1)  // one point has no lever to resist a torsion with
        solve_torsion<whole>(block.torsion, pair, n, inv_M_A, inv_M_B, limit, active, change);
    if constexpr (View::rolls) solve_rolling<whole>(solver.rolling[block_i], pair, block, load_of_normals, active, change);
    solve_friction<whole>(solver, block_i, block, pair, limit, active, change);
    const mask moves = change.fastest > active_threshold;
    pair.last[1] = select(both(moves, inv_M_A > lane{}), splat<lane>(sweep), pair.last[1]);
    pair.last[3] = select(both(moves, inv_M_B > lane{}), splat<lane>(sweep), pair.last[3]);
    if (!whole) pair = chosen(active, pair, before);
    store_if<whole>(block.change, visited, whole ? change.size : select(active, change.size, lane{}));
    store_if<whole>(block.fastest, visited, whole ? change.fastest : select(active, change.fastest, lane{}));
}

/// Solves what one visit names, but for the lanes whose bodies neither this sweep nor the one before has stirred.
template <int rows, class View>
INGOT_INLINE void visit_velocities(const View& solver, int block_i, ContactBlock& block, uint16_t lane_bits, int sweep_i, lane active_threshold) {
    const scalar sweep = static_cast<scalar>(sweep_i);
    const LaneQuad L_A = gather(solver.bodies, block.body_A, &SolverBody::L), L_B = gather(solver.bodies, block.body_B, &SolverBody::L);
    const mask visited = lanes_of(lane_bits);
    mask active = visited;
    if (sweep_i > 1) active = both(visited, max(L_A.at[3], L_B.at[3]) >= splat<lane>(sweep - 1));
    if (!any(active)) {
        store_if<false>(block.change, visited, lane{});
        store_if<false>(block.fastest, visited, lane{});
        return;
    }
    const LaneQuad v_A = gather(solver.bodies, block.body_A, &SolverBody::v_CM), v_B = gather(solver.bodies, block.body_B, &SolverBody::v_CM);
    BodyPairLanes pair = {vector_of(v_A), vector_of(L_A), vector_of(v_B), vector_of(L_B), {v_A.at[3], L_A.at[3], v_B.at[3], L_B.at[3]}};
    if (any(opposite(active)))
        solve_rows<rows, false>(solver, block_i, block, pair, visited, active, sweep, active_threshold);
    else
        solve_rows<rows, true>(solver, block_i, block, pair, visited, active, sweep, active_threshold);
    scatter_bodies(solver, block, lane_bits, pair, &SolverBody::v_CM, &SolverBody::L);
}

/// m/s; bodies that a visit changes by more are visited by the next sweep too.
INGOT_INLINE lane active_threshold_of(const SolverView& solver, const Visit& visit, const ContactBlock& block) {
    if (visit.island != no_island) return splat<lane>(limits::active_share * solver.islands[visit.island].settled);
    scalar of_lanes[lanes];
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        of_lanes[lane_i] = block.island[lane_i] == no_island ? 0 : limits::active_share * solver.islands[block.island[lane_i]].settled;
    return load(of_lanes);
}

/// Adds what a visit changed to the sums of its islands, lane by lane.
void add_lanes(const SolverView& solver, const Visit& visit, const ContactBlock& block) {
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        if ((visit.lane_bits >> lane_i & 1u) == 0 || block.island[lane_i] == no_island) continue;
        Island& island = solver.islands[block.island[lane_i]];
        island.sums[block.sum_i[lane_i]] += block.change[lane_i];
        island.residuals[lane_i] = max(island.residuals[lane_i], block.fastest[lane_i]);
    }
}

/// The same for a run of visits to one island, as vectors. Returns the visit after the run.
int add_run(const SolverView& solver, int begin) {
    const uint16_t island_i = solver.live[begin].island;
    Island& island = solver.islands[island_i];
    lane residual = load(island.residuals);
    int visit_i = begin;
    for (; visit_i < solver.live_count && solver.live[visit_i].island == island_i; ++visit_i) {  // bound: max_manifolds
        const ContactBlock& block = solver.blocks[solver.live[visit_i].block];
        scalar* const sums = island.sums + block.sum_i[0];
        store(sums, load(sums) + load(block.change));
        residual = max(residual, load(block.fastest));
    }
    store(island.residuals, residual);
    return visit_i;
}

/// Calls each(island) for the islands of the batch that are not settled.
template <class Each>
void for_live_islands(const SolverView& solver, const Each& each) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i)  // bound: max_bodies
        if (solver.islands[island_i].in_batch && solver.islands[island_i].sweeps_on) each(solver.islands[island_i]);
}

}  // namespace

template <class View>
void sweep_velocities(const View& solver, int sweep_i, bool up) {
    uint16_t island_before = no_island;
    lane active_threshold{};
    for (int visit_i = 0; visit_i < solver.live_count; ++visit_i) {  // bound: max_manifolds: a run has one visit or more
        const Visit visit = solver.live[up ? visit_i : solver.live_count - 1 - visit_i];
        ContactBlock& block = solver.blocks[visit.block];
        if (visit.island == no_island || visit.island != island_before) active_threshold = active_threshold_of(solver, visit, block);
        island_before = visit.island;
        if (block.rows == 1)
            visit_velocities<1>(solver, visit.block, block, visit.lane_bits, sweep_i, active_threshold);
        else
            visit_velocities<block_rows>(solver, visit.block, block, visit.lane_bits, sweep_i, active_threshold);
    }
}

// The linker takes the one that the scene calls.
template void sweep_velocities(const SolverView&, int, bool);
template void sweep_velocities(const RollingView&, int, bool);
template void sweep_velocities(const BeltView&, int, bool);
template void sweep_velocities(const RollingBeltView&, int, bool);

void measure_sweep(const SolverView& solver) {
    for_live_islands(solver, [](Island& island) {
        for (scalar& sum : island.sums) sum = 0;
        for (scalar& residual : island.residuals) residual = 0;
    });
    for (int visit_i = 0; visit_i < solver.live_count;) {  // bound: max_manifolds: a run has one visit or more
        const Visit& visit = solver.live[visit_i];
        if (visit.island != no_island) {
            visit_i = add_run(solver, visit_i);
        } else {
            add_lanes(solver, visit, solver.blocks[visit.block]);
            ++visit_i;
        }
    }
    for_live_islands(solver, [](Island& island) {
        const auto& sums = island.sums;
        island.size = ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
        island.residual = 0;
        for (const scalar residual : island.residuals) island.residual = residual > island.residual ? residual : island.residual;
    });
}

} }  // namespace ingot
