// SPDX-License-Identifier: MIT
#include "sweep_blocks.h"

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "block_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

INGOT_INLINE Vec3<lane> gather_history(const SolverView& solver, const uint16_t* index, scalar (SolverBodyHistory::*part)[4]) {
    scalar rows[3][lanes];
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        for (int axis = 0; axis < 3; ++axis) rows[axis][lane_i] = (solver.histories[index[lane_i]].*part)[axis];
    return load(rows);
}

/// Points of a block that restitution throws back within the substep.
INGOT_INLINE void predict_bounces(ContactBlock& block, const SolverView& solver, const Vec3<lane>& n, const lane (&separation)[block_rows], scalar h) {
    const BodyPairLanes motion = gather_bodies(solver, block, &SolverBody::v_CM, &SolverBody::L);
    const BodyPairLanes forces = {gather_history(solver, block.body_A, &SolverBodyHistory::a), gather_history(solver, block.body_A, &SolverBodyHistory::tau),
                                  gather_history(solver, block.body_B, &SolverBodyHistory::a), gather_history(solver, block.body_B, &SolverBodyHistory::tau), {}};
    const lane approach = dot(n, motion.linear_A - motion.linear_B), pull = dot(n, forces.linear_A - forces.linear_B);
    const lane step = splat<lane>(h), half = splat<lane>(scalar(0.5)), two = splat<lane>(2), one = splat<lane>(1), e = load(block.e);
    for (int row = 0; row < block.rows; ++row) {
        const lane s = separation[row], speed = row_speed(block.row[row].levers, approach, motion), a = row_speed(block.row[row].levers, pull, forces);
        const mask meets = s + speed * step + a * step * step * half < lane{};
        const mask apart = s > lane{};
        const lane root = sqrt(greatest(speed * speed - two * a * s, lane{}));
        const lane divisor = root - speed;
        const lane when = select(both(apart, divisor > lane{}), least(two * s / select(divisor > lane{}, divisor, one), step), lane{});
        const lane impact = speed + a * when, leaving = -e * impact, rest = step - when;
        const lane rest_speed = greatest(splat<lane>(limits::bounce_speed_min), two * abs(a) * step);
        const mask bounces = both(both(meets, -impact > rest_speed), both(e > lane{}, load(block.B[Sym4::index(row, row)]) > lane{}));
        store(block.row[row].target, select(bounces, leaving + a * rest, load(block.row[row].target)));
        store(block.row[row].landing, select(bounces, leaving * rest + a * rest * rest * half, splat<lane>(limits::unbounded)));
    }
}

}  // namespace

void predict_contacts(const SolverView& solver, scalar h) {
    const lane inv_h = splat<lane>(1 / h);
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {
        ContactBlock& block = solver.blocks[block_i];
        const BodyPairLanes displaced = gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth);
        const Vec3<lane> n = load(block.n);
        const lane apart = dot(n, displaced.linear_A - displaced.linear_B);
        lane separation[block_rows];
        for (int row = 0; row < block.rows; ++row) {
            separation[row] = separation_now(block, row, apart, displaced);
            store(block.row[row].target, -greatest(separation[row] - splat<lane>(limits::touching_gap), lane{}) * inv_h);
        }
        if (any(load(block.e) > lane{})) predict_bounces(block, solver, n, separation, h);
    }
}

namespace {

/// What is given again of the normals' impulses: of bodies that were hit, no more than gravity explains; of points that bounce, nothing.
template <int rows>
INGOT_INLINE Row4 impulses_kept(const SolverView& solver, const ContactBlock& block, const BodyPairLanes& pair, scalar h) {
    Row4 kept;
    for (int row = 0; row < rows; ++row) kept.at[row] = load(block.row[row].j);
    if (solver.some_hit) {
        const mask hit = pair.last[1] + pair.last[3] > lane{};
        if (any(hit)) {
            const lane g = greatest(gather(solver.bodies, block.body_A, &SolverBody::dp).at[3], gather(solver.bodies, block.body_B, &SolverBody::dp).at[3]);
            const lane allowance = splat<lane>(2 * h) * g;
            for (int row = 0; row < rows; ++row) {
                const lane most = splat<lane>(2) * load(block.row[row].j_before) + allowance / load(block.K[Sym4::index(row, row)]);
                kept.at[row] = select(hit, least(kept.at[row], most), kept.at[row]);
            }
        }
    }
    if (any(load(block.e) > lane{}))
        for (int row = 0; row < rows; ++row) kept.at[row] = select(bounces(block.row[row]), lane{}, kept.at[row]);
    return kept;
}

/// Friction is drawn a tenth towards its slow mean, which follows it; where it slides, and while it is young, the mean is what it is.
struct Smoothed {
    lane j, reference;
};
INGOT_INLINE Smoothed smoothed(lane j, lane reference, mask young) {
    const lane tenth = splat<lane>(scalar(0.1));
    const lane drawn = j - tenth * (j - reference);
    return {select(young, j, drawn), select(young, j, reference + tenth * (drawn - reference))};
}

}  // namespace

namespace {

template <int rows, bool whole>
INGOT_INLINE void warm_start_visit(const SolverView& solver, ContactBlock& block, uint16_t lane_bits, scalar h) {
    const mask active = whole ? splat<lane>(1) > lane{} : mask_from_bits(lane_bits);
    const Vec3<lane> n = load(block.n);
    const lane inv_M_A = load(block.inv_M_A), inv_M_B = load(block.inv_M_B);
    BodyPairLanes pair = gather_bodies(solver, block, &SolverBody::v_CM, &SolverBody::L);

    const Row4 j = impulses_kept<rows>(solver, block, pair, h);
    for (int row = 0; row < rows; ++row) {
        store_if<whole>(block.row[row].j, active, j.at[row]);
        store_if<whole>(block.row[row].j_before, active, j.at[row]);
        add_angular(pair, block.row[row].levers, j.at[row]);
    }
    lane sum{};
    for (int row = 0; row < rows; ++row) sum = sum + j.at[row];
    add_linear(pair, n * sum, inv_M_A, inv_M_B);

    const lane limit = load(block.mu) * sum, steps = load(block.substeps);
    const lane before_1 = load(block.friction.j[0]), before_2 = load(block.friction.j[1]);
    const lane reference_1 = load(block.friction.reference[0]), reference_2 = load(block.friction.reference[1]);
    const mask slides = before_1 * before_1 + before_2 * before_2 >= splat<lane>(scalar(0.998)) * limit * limit;
    const mask young = either(slides, steps < splat<lane>(limits::substeps));
    const Smoothed along_1 = smoothed(before_1, reference_1, young), along_2 = smoothed(before_2, reference_2, young);
    lane j_1 = along_1.j, j_2 = along_2.j;
    cut_to_cone(j_1, j_2, limit);
    store_if<whole>(block.friction.j[0], active, j_1);
    store_if<whole>(block.friction.j[1], active, j_2);
    store_if<whole>(block.friction.reference[0], active, along_1.reference);
    store_if<whole>(block.friction.reference[1], active, along_2.reference);
    store_if<whole>(block.substeps, active, steps + splat<lane>(1));
    add_linear(pair, load(block.t_1) * j_1 + load(block.t_2) * j_2, inv_M_A, inv_M_B);
    add_angular(pair, block.friction.levers[0], j_1);
    add_angular(pair, block.friction.levers[1], j_2);
    if constexpr (rows > 1) {
        const lane twist = clamped(load(block.twist.j), limit * load(block.twist.radius));
        store_if<whole>(block.twist.j, active, twist);
        add_twist(pair, n, twist, inv_M_A, inv_M_B);
    }
    scatter_bodies(solver, block, lane_bits, pair, &SolverBody::v_CM, &SolverBody::L);
}

}  // namespace

void warm_start(const SolverView& solver, scalar h) {
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {
        const Visit visit = solver.visits[visit_i];
        ContactBlock& block = solver.blocks[visit.block];
        const bool whole = visit.lane_bits == all_lanes;
        if (block.rows == 1)
            whole ? warm_start_visit<1, true>(solver, block, visit.lane_bits, h) : warm_start_visit<1, false>(solver, block, visit.lane_bits, h);
        else
            whole ? warm_start_visit<block_rows, true>(solver, block, visit.lane_bits, h)
                  : warm_start_visit<block_rows, false>(solver, block, visit.lane_bits, h);
    }
}

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

SweepResult velocity_sweep(const SolverView& solver, bool up) {
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

namespace {

void copy4(scalar (&to)[4], const scalar (&from)[4]) {
    for (int i = 0; i < 4; ++i) to[i] = from[i];
}

/// P = beta P + (now - before); now += beta P. The fourth number, which is no coordinate, stays.
void go_on(scalar (&now)[4], const scalar (&before)[4], scalar (&P)[4], scalar beta) {
    const scalar fourth = now[3];
    for (int i = 0; i < 4; ++i) {
        P[i] = beta * P[i] + (now[i] - before[i]);
        now[i] = now[i] + beta * P[i];
    }
    now[3] = fourth;
}

}  // namespace

void begin_sweep(const SolverView& solver) {
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {
        ContactBlock& block = solver.blocks[block_i];
        for (int row = 0; row < block.rows; ++row) store(block.row[row].j_sweep, load(block.row[row].j));
        for (int axis = 0; axis < 2; ++axis) store(block.friction.j_sweep[axis], load(block.friction.j[axis]));
        if (block.rows > 1) store(block.twist.j_sweep, load(block.twist.j));
    }
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {
        copy4(solver.histories[body_i].v_sweep, solver.bodies[body_i].v_CM);
        copy4(solver.histories[body_i].L_sweep, solver.bodies[body_i].L);
    }
}

void extrapolate(const SolverView& solver, scalar beta) {
    const lane b = splat<lane>(beta);
    const auto go_on_lanes = [&](scalar (&j)[lanes], const scalar (&j_sweep)[lanes], scalar (&direction)[lanes]) {
        const lane now = load(j), along = b * load(direction) + (now - load(j_sweep));
        store(direction, along);
        store(j, now + b * along);
    };
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {
        ContactBlock& block = solver.blocks[block_i];
        for (int row = 0; row < block.rows; ++row) go_on_lanes(block.row[row].j, block.row[row].j_sweep, block.row[row].direction);
        for (int axis = 0; axis < 2; ++axis) go_on_lanes(block.friction.j[axis], block.friction.j_sweep[axis], block.friction.direction[axis]);
        if (block.rows > 1) go_on_lanes(block.twist.j, block.twist.j_sweep, block.twist.direction);
    }
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {
        SolverBody& body = solver.bodies[body_i];
        SolverBodyHistory& history = solver.histories[body_i];
        go_on(body.v_CM, history.v_sweep, history.P_v, beta);
        go_on(body.L, history.L_sweep, history.P_L, beta);
    }
}

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

void position_sweep(const SolverView& solver, scalar h) {
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
