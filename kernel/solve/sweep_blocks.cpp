// SPDX-License-Identifier: MIT
#include "sweep_blocks.h"

#include "../base/limits.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

INGOT_INLINE Sym4 load_sym4(const scalar (&rows)[10][lanes]) {
    Sym4 m;
    for (int entry = 0; entry < 10; ++entry) m.at[entry] = load(rows[entry]);
    return m;
}
INGOT_INLINE Row4 load_row4(const scalar (&rows)[block_rows][lanes]) {
    Row4 r;
    for (int row = 0; row < block_rows; ++row) r.at[row] = load(rows[row]);
    return r;
}

/// The two bodies of each lane of a block while it is visited.
struct Pair {
    Vec3<lane> v_A, L_A, v_B, L_B;
};

INGOT_INLINE Pair gather_pair(const SolverView& solver, const ContactBlock& block, scalar (SolverBody::*linear)[4], scalar (SolverBody::*angular)[4]) {
    return {gather(solver.bodies, block.body_A, linear), gather(solver.bodies, block.body_A, angular),
            gather(solver.bodies, block.body_B, linear), gather(solver.bodies, block.body_B, angular)};
}

/// Writes back the lanes of the visit. The body that stands for all immovable ones is written with the zeros it had.
INGOT_INLINE void scatter_pair(const SolverView& solver, const ContactBlock& block, uint16_t lane_bits, const Pair& pair,
                               scalar (SolverBody::*linear)[4], scalar (SolverBody::*angular)[4]) {
    if (lane_bits == all_lanes) {
        scatter(solver.bodies, block.body_A, linear, pair.v_A);
        scatter(solver.bodies, block.body_A, angular, pair.L_A);
        scatter(solver.bodies, block.body_B, linear, pair.v_B);
        scatter(solver.bodies, block.body_B, angular, pair.L_B);
        return;
    }
    scatter_some(solver.bodies, block.body_A, lane_bits, linear, pair.v_A);
    scatter_some(solver.bodies, block.body_A, lane_bits, angular, pair.L_A);
    scatter_some(solver.bodies, block.body_B, lane_bits, linear, pair.v_B);
    scatter_some(solver.bodies, block.body_B, lane_bits, angular, pair.L_B);
}

/// Speed of A against B along a row: direction . (v_A - v_B) + L_A.k_A - L_B.k_B.
INGOT_INLINE lane angular_speed(const Levers& levers, const Pair& pair) {
    return dot(pair.L_A, load(levers.k_A)) + dot(pair.L_B, load(levers.k_B));
}

INGOT_INLINE void add_linear(Pair& pair, const Vec3<lane>& impulse, lane inv_M_A, lane inv_M_B) {
    pair.v_A += impulse * inv_M_A;
    pair.v_B -= impulse * inv_M_B;
}

INGOT_INLINE void add_angular(Pair& pair, const Levers& levers, lane j) {
    pair.L_A += load(levers.J_A) * j;
    pair.L_B += load(levers.J_B) * j;
}

/// Length of the friction impulse cut to the cone.
INGOT_INLINE void cut_to_cone(lane& j_1, lane& j_2, lane limit) {
    const lane length_sq_of = j_1 * j_1 + j_2 * j_2;
    const mask slides = length_sq_of > limit * limit;
    if (!any(slides)) return;
    const lane cut = select(slides, limit / sqrt(select(slides, length_sq_of, splat<lane>(1))), splat<lane>(1));
    j_1 = j_1 * cut;
    j_2 = j_2 * cut;
}

INGOT_INLINE Vec3<lane> gather_history(const SolverView& solver, const uint16_t* index, scalar (SolverBodyHistory::*part)[4]) {
    scalar rows[3][lanes];
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        for (int axis = 0; axis < 3; ++axis) rows[axis][lane_i] = (solver.histories[index[lane_i]].*part)[axis];
    return load(rows);
}

INGOT_INLINE lane row_speed(const Levers& levers, const Vec3<lane>& direction, const Pair& pair) {
    return dot(direction, pair.v_A - pair.v_B) + angular_speed(levers, pair);
}

INGOT_INLINE lane sum_of(const Row4& row) { return (row.at[0] + row.at[1]) + (row.at[2] + row.at[3]); }

INGOT_INLINE lane clamped(lane x, lane limit) { return least(greatest(x, -limit), limit); }

/// Where a point is now: its separation at the begin of the step, and what displacements have made of it.
INGOT_INLINE lane separation_now(const ContactBlock& block, int row, const Vec3<lane>& n, const Pair& displaced) {
    return load(block.separation[row]) + dot(n, displaced.v_A - displaced.v_B) + dot(displaced.L_A, load(block.normal[row].J_A)) +
           dot(displaced.L_B, load(block.normal[row].J_B));
}

/// Points of a block that restitution throws back within the substep.
INGOT_INLINE void predict_bounces(ContactBlock& block, const SolverView& solver, const Vec3<lane>& n, const lane (&separation)[block_rows], scalar h) {
    const Pair motion = gather_pair(solver, block, &SolverBody::v_CM, &SolverBody::L);
    const Pair forces = {gather_history(solver, block.body_A, &SolverBodyHistory::a), gather_history(solver, block.body_A, &SolverBodyHistory::tau),
                         gather_history(solver, block.body_B, &SolverBodyHistory::a), gather_history(solver, block.body_B, &SolverBodyHistory::tau)};
    const lane step = splat<lane>(h), half = splat<lane>(scalar(0.5)), two = splat<lane>(2), one = splat<lane>(1), e = load(block.e);
    for (int row = 0; row < block_rows; ++row) {
        const lane s = separation[row], speed = row_speed(block.normal[row], n, motion), a = row_speed(block.normal[row], n, forces);
        const mask meets = s + speed * step + a * step * step * half < lane{};
        const mask apart = s > lane{};
        const lane root = sqrt(greatest(speed * speed - two * a * s, lane{}));
        const lane divisor = root - speed;
        const lane when = select(both(apart, divisor > lane{}), least(two * s / select(divisor > lane{}, divisor, one), step), lane{});
        const lane impact = speed + a * when, leaving = -e * impact, rest = step - when;
        const lane rest_speed = greatest(splat<lane>(limits::bounce_speed_min), two * abs(a) * step);
        const mask bounces = both(both(meets, -impact > rest_speed), both(e > lane{}, load(block.B[Sym4::index(row, row)]) > lane{}));
        store(block.target[row], select(bounces, leaving + a * rest, load(block.target[row])));
        store(block.position[row], select(bounces, leaving * rest + a * rest * rest * half, lane{}));
        store(block.bounces[row], select(bounces, one, lane{}));
    }
}

}  // namespace

void predict_contacts(const SolverView& solver, scalar h) {
    const lane inv_h = splat<lane>(1 / h);
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {
        ContactBlock& block = solver.blocks[block_i];
        const Pair displaced = gather_pair(solver, block, &SolverBody::dp, &SolverBody::dth);
        const Vec3<lane> n = load(block.n);
        lane separation[block_rows];
        for (int row = 0; row < block_rows; ++row) {
            separation[row] = separation_now(block, row, n, displaced);
            store(block.target[row], -greatest(separation[row] - splat<lane>(limits::touching_gap), lane{}) * inv_h);
        }
        if (any(load(block.e) > lane{})) predict_bounces(block, solver, n, separation, h);
    }
}

void warm_start(const SolverView& solver, scalar h) {
    const lane tenth = splat<lane>(scalar(0.1)), two = splat<lane>(2);
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {
        const Visit visit = solver.visits[visit_i];
        ContactBlock& block = solver.blocks[visit.block];
        const mask active = mask_from_bits(visit.lane_bits);
        const Vec3<lane> n = load(block.n);
        Pair pair = gather_pair(solver, block, &SolverBody::v_CM, &SolverBody::L);

        // Of bodies that were hit, no more than gravity explains.
        scalar hit_rows[lanes], g_rows[lanes];
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            const uint16_t A = block.body_A[lane_i], B = block.body_B[lane_i];
            hit_rows[lane_i] = solver.bodies[A].dth[3] + solver.bodies[B].dth[3];
            const scalar g_A = solver.histories[A].a[3], g_B = solver.histories[B].a[3];
            g_rows[lane_i] = g_A > g_B ? g_A : g_B;
        }
        const mask hit = load(hit_rows) > lane{};
        const lane allowance = two * splat<lane>(h) * load(g_rows);
        lane sum{};
        for (int row = 0; row < block_rows; ++row) {
            const lane j = load(block.j[row]), K = load(block.K[Sym4::index(row, row)]);
            const lane most = two * load(block.j_before[row]) + allowance / K;
            const lane kept = select(load(block.bounces[row]) > lane{}, lane{}, select(hit, least(j, most), j));
            store(block.j[row], select(active, kept, j));
            store(block.j_before[row], select(active, kept, load(block.j_before[row])));
            sum = sum + kept;
            add_angular(pair, block.normal[row], kept);
        }
        add_linear(pair, n * sum, load(block.inv_M_A), load(block.inv_M_B));

        lane t_1 = load(block.j_friction[0]), t_2 = load(block.j_friction[1]);
        lane ref_1 = load(block.j_reference[0]), ref_2 = load(block.j_reference[1]);
        const lane limit = load(block.mu) * sum;
        const mask slides = t_1 * t_1 + t_2 * t_2 >= splat<lane>(scalar(0.998)) * limit * limit;
        const lane steps = load(block.steps);
        const mask young = either(slides, steps < splat<lane>(4));
        t_1 = t_1 - tenth * (t_1 - ref_1);
        t_2 = t_2 - tenth * (t_2 - ref_2);
        ref_1 = select(young, load(block.j_friction[0]), ref_1 + tenth * (t_1 - ref_1));
        ref_2 = select(young, load(block.j_friction[1]), ref_2 + tenth * (t_2 - ref_2));
        t_1 = select(young, load(block.j_friction[0]), t_1);
        t_2 = select(young, load(block.j_friction[1]), t_2);
        cut_to_cone(t_1, t_2, limit);
        const lane twist = clamped(load(block.j_twist), limit * load(block.twist_radius));
        store(block.j_friction[0], select(active, t_1, load(block.j_friction[0])));
        store(block.j_friction[1], select(active, t_2, load(block.j_friction[1])));
        store(block.j_reference[0], select(active, ref_1, load(block.j_reference[0])));
        store(block.j_reference[1], select(active, ref_2, load(block.j_reference[1])));
        store(block.j_twist, select(active, twist, load(block.j_twist)));
        store(block.steps, select(active, steps + splat<lane>(1), steps));
        add_linear(pair, load(block.t_1) * t_1 + load(block.t_2) * t_2, load(block.inv_M_A), load(block.inv_M_B));
        add_angular(pair, block.friction[0], t_1);
        add_angular(pair, block.friction[1], t_2);
        pair.L_A += n * select(load(block.inv_M_A) > lane{}, twist, lane{});
        pair.L_B -= n * select(load(block.inv_M_B) > lane{}, twist, lane{});
        scatter_pair(solver, block, visit.lane_bits, pair, &SolverBody::v_CM, &SolverBody::L);
    }
}

namespace {

/// Solves the rows of one visit; the lanes of it are stored.
INGOT_INLINE void visit_velocities(const SolverView& solver, ContactBlock& block, uint16_t lane_bits) {
    const mask active = mask_from_bits(lane_bits);
    const Vec3<lane> n = load(block.n);
    const lane inv_M_A = load(block.inv_M_A), inv_M_B = load(block.inv_M_B);
    Pair pair = gather_pair(solver, block, &SolverBody::v_CM, &SolverBody::L);

    const Sym4 K = load_sym4(block.K), B = load_sym4(block.B);
    const lane approach = dot(n, pair.v_A - pair.v_B);
    const Row4 before = load_row4(block.j);
    Row4 w;
    for (int row = 0; row < block_rows; ++row) {
        const lane u = approach + angular_speed(block.normal[row], pair) - load(block.target[row]);
        w.at[row] = select(B(row, row) > lane{}, u, lane{});
    }
    const mask none[block_rows] = {};
    const Row4 j = solve_block(K, B, w, before, none);
    lane total{}, given{}, change{};
    for (int row = 0; row < block_rows; ++row) {
        const lane d = j.at[row] - before.at[row];
        add_angular(pair, block.normal[row], d);
        given = given + d;
        total = total + j.at[row];
        change = change + d * d * K(row, row);
        store(block.j[row], select(active, j.at[row], before.at[row]));
    }
    add_linear(pair, n * given, inv_M_A, inv_M_B);

    const lane limit = load(block.mu) * total;
    const mask turns_A = inv_M_A > lane{}, turns_B = inv_M_B > lane{};
    const lane spin = dot(pair.L_A, load(block.k_twist_A)) + dot(pair.L_B, load(block.k_twist_B));
    const lane twist_before = load(block.j_twist), inv_K_twist = load(block.inv_K_twist);
    const lane twist = clamped(twist_before - spin * inv_K_twist, limit * load(block.twist_radius));
    const lane twisted = twist - twist_before;
    pair.L_A += n * select(turns_A, twisted, lane{});
    pair.L_B -= n * select(turns_B, twisted, lane{});
    store(block.j_twist, select(active, twist, twist_before));
    change = change + select(inv_K_twist > lane{}, twisted * twisted / select(inv_K_twist > lane{}, inv_K_twist, splat<lane>(1)), lane{});

    const Vec3<lane> t_1 = load(block.t_1), t_2 = load(block.t_2);
    const lane u_1 = row_speed(block.friction[0], t_1, pair), u_2 = row_speed(block.friction[1], t_2, pair);
    const lane i11 = load(block.inv_K_friction[0]), i12 = load(block.inv_K_friction[1]), i22 = load(block.inv_K_friction[2]);
    const lane j_1 = load(block.j_friction[0]), j_2 = load(block.j_friction[1]);
    lane next_1 = j_1 - (i11 * u_1 + i12 * u_2), next_2 = j_2 - (i12 * u_1 + i22 * u_2);
    cut_to_cone(next_1, next_2, limit);
    const lane d_1 = next_1 - j_1, d_2 = next_2 - j_2;
    add_linear(pair, t_1 * d_1 + t_2 * d_2, inv_M_A, inv_M_B);
    add_angular(pair, block.friction[0], d_1);
    add_angular(pair, block.friction[1], d_2);
    store(block.j_friction[0], select(active, next_1, j_1));
    store(block.j_friction[1], select(active, next_2, j_2));
    const lane det = i11 * i22 - i12 * i12;
    const lane inv_det = select(det > lane{}, splat<lane>(1) / select(det > lane{}, det, splat<lane>(1)), lane{});
    change = change + (d_1 * d_1 * i22 + d_2 * d_2 * i11) * inv_det;
    store(block.change, select(active, change, load(block.change)));
    scatter_pair(solver, block, lane_bits, pair, &SolverBody::v_CM, &SolverBody::L);
}

/// The sum does not depend on lanes: position p is added to the p mod 8-th of eight sums.
scalar sum_of_changes(const SolverView& solver) {
    scalar sums[8] = {};
    for (int position = 0; position < solver.manifold_count; ++position) {
        scalar& sum = sums[position % 8];
        sum = sum + solver.blocks[position / lanes].change[position % lanes];
    }
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

}  // namespace

scalar velocity_sweep(const SolverView& solver, bool up) {
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {
        const Visit visit = solver.visits[up ? visit_i : solver.visit_count - 1 - visit_i];
        visit_velocities(solver, solver.blocks[visit.block], visit.lane_bits);
    }
    return sum_of_changes(solver);
}

namespace {

/// Impulses of a block as conjugate gradients see them: four normals, the pair, the twist.
INGOT_INLINE void load_impulses(const ContactBlock& block, lane (&j)[7]) {
    for (int row = 0; row < block_rows; ++row) j[row] = load(block.j[row]);
    j[4] = load(block.j_friction[0]);
    j[5] = load(block.j_friction[1]);
    j[6] = load(block.j_twist);
}
INGOT_INLINE void store_impulses(ContactBlock& block, const lane (&j)[7]) {
    for (int row = 0; row < block_rows; ++row) store(block.j[row], j[row]);
    store(block.j_friction[0], j[4]);
    store(block.j_friction[1], j[5]);
    store(block.j_twist, j[6]);
}

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
        lane j[7];
        load_impulses(block, j);
        for (int row = 0; row < 7; ++row) store(block.j_sweep[row], j[row]);
    }
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {
        copy4(solver.histories[body_i].v_sweep, solver.bodies[body_i].v_CM);
        copy4(solver.histories[body_i].L_sweep, solver.bodies[body_i].L);
    }
}

void extrapolate(const SolverView& solver, scalar beta) {
    const lane b = splat<lane>(beta);
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {
        ContactBlock& block = solver.blocks[block_i];
        lane j[7];
        load_impulses(block, j);
        for (int row = 0; row < 7; ++row) {
            const lane direction = b * load(block.direction[row]) + (j[row] - load(block.j_sweep[row]));
            store(block.direction[row], direction);
            j[row] = j[row] + b * direction;
        }
        store_impulses(block, j);
    }
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {
        SolverBody& body = solver.bodies[body_i];
        SolverBodyHistory& history = solver.histories[body_i];
        go_on(body.v_CM, history.v_sweep, history.P_v, beta);
        go_on(body.L, history.L_sweep, history.P_L, beta);
    }
}

void position_sweep(const SolverView& solver, scalar h) {
    const lane share = splat<lane>(limits::position_share), deepest = splat<lane>(-limits::push_speed_max * h);
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {
        const Visit visit = solver.visits[visit_i];
        ContactBlock& block = solver.blocks[visit.block];
        const Vec3<lane> n = load(block.n);
        Pair displaced = gather_pair(solver, block, &SolverBody::dp, &SolverBody::dth);
        Row4 w;
        mask pulls[block_rows], off = splat<lane>(1) < lane{};
        for (int row = 0; row < block_rows; ++row) {
            const lane s = separation_now(block, row, n, displaced);
            const mask bounces = load(block.bounces[row]) > lane{}, pressed = load(block.j[row]) > lane{};
            const lane wanted = select(either(pressed, s < lane{}), greatest(s * share, deepest), s);
            w.at[row] = select(bounces, s - load(block.position[row]), wanted);
            pulls[row] = either(bounces, pressed);
            w.at[row] = select(load(block.B[Sym4::index(row, row)]) > lane{}, w.at[row], lane{});
            off = either(off, either(pulls[row], w.at[row] < lane{}));
        }
        if (!any(off)) continue;
        const Row4 before = {};
        Row4 q = solve_block(load_sym4(block.K), load_sym4(block.B), w, before, pulls);
        for (int row = 0; row < block_rows; ++row) {
            q.at[row] = select(off, q.at[row], lane{});
            displaced.L_A += load(block.normal[row].k_A) * q.at[row];
            displaced.L_B += load(block.normal[row].k_B) * q.at[row];
        }
        add_linear(displaced, n * sum_of(q), load(block.inv_M_A), load(block.inv_M_B));
        scatter_pair(solver, block, visit.lane_bits, displaced, &SolverBody::dp, &SolverBody::dth);
    }
}

} }  // namespace ingot
