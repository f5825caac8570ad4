// SPDX-License-Identifier: MIT
// Friction at the middle of the points, along t_1 and t_2: one row each, solved as a pair on the cone |j| <= mu N.
//
//     u = t . (v_A - v_B at the middle) + belt;  J_A = r_A x t, J_B = -(r_B x t)
//
//     t_1, t_2  across n, and across each other
//     N         N s, what the normals carry
//     belt      m/s, how much faster the surface of A goes along t than A does, relative to that of B: see belts.h
//
// The middle is the mean of the points, of which those beyond the contact margin count less and less.
// Sources: the pair, row_pair.h; one friction of a manifold and not of each point: Bullet's and Bepu's contacts do the same.
#pragma once

#include "belts.h"
#include "row_pair.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

struct FrictionRows : RowPair {
    Levers levers[2];
    LaneRow reference[2];  ///< slow mean of j
    LaneRow given[2];      ///< N s, before the slip turns round in this substep: beside j until the substep ends
    LaneRow share;         ///< see reversal_share
    LaneRow shift[2];      ///< m/s, by how much the slip of the end of the substep differs from that of the rows: see refresh_blocks
    uint16_t sliding;      ///< bit per lane: it slid in the substep before
    bool turns_round;      ///< the slip of some lane turns round in this substep
};

/// Friction is drawn a tenth towards its slow mean, and the mean towards it. Where it slides, and while the manifold is young, the mean is friction
/// itself.
struct Smoothed {
    lane j, reference;
};
INGOT_INLINE Smoothed smoothed(lane j, lane reference, mask young) {
    const lane tenth = splat<lane>(limits::friction_smoothing);
    const lane drawn = j - tenth * (j - reference);
    return {select(young, j, drawn), select(young, j, reference + tenth * (drawn - reference))};
}

/// Two directions across n, made from the axis that n is furthest from: the same n gives the same two.
INGOT_INLINE void tangents(const Vec3<lane>& n, Vec3<lane>& t_1, Vec3<lane>& t_2) {
    const lane one = splat<lane>(1);
    const mask across_x = both(abs(n.x) <= abs(n.y), abs(n.x) <= abs(n.z)), across_y = both(opposite(across_x), abs(n.y) <= abs(n.z));
    const mask across_z = both(opposite(across_x), opposite(across_y));
    const Vec3<lane> axis = {select(across_x, one, lane{}), select(across_y, one, lane{}), select(across_z, one, lane{})};
    const Vec3<lane> t = cross(n, axis);
    t_1 = t * (one / sqrt(length_sq(t)));
    t_2 = cross(n, t_1);
}

/// Where friction takes hold, and how far the points are from there. rows: up to `most`. margin: m, contact_margin of the pair.
template <int most, class Contacts>
INGOT_INLINE void find_middle(Contacts& contacts, int rows, lane margin) {
    const lane one = splat<lane>(1), least_weight = splat<lane>(limits::least_point_weight);
    lane weight[block_rows], weights{};
    contacts.middle = Vec3<lane>{};
    contacts.radius = lane{};
    for (int row = 0; row < rows; ++row) {  // bound: 4: block_rows
        weight[row] = contacts.used[row] * max(lane{}, nearness(contacts.separation[row], margin)) + contacts.used[row] * least_weight;
        contacts.middle += contacts.P[row] * weight[row];
        weights = weights + weight[row];
    }
    const lane inv_weights = one / select(weights > lane{}, weights, one);
    contacts.middle = contacts.middle * inv_weights;
    if constexpr (most == 1) return;  // one point is its own middle but for rounding
    for (int row = 0; row < rows; ++row) contacts.radius = contacts.radius + weight[row] * sqrt(length_sq(contacts.P[row] - contacts.middle));
    const mask has_area = rows > 1 ? contacts.used[1] > lane{} : one < lane{};
    contacts.radius = select(has_area, contacts.radius * inv_weights, lane{});
}

template <class Surfaces>
struct Friction {
    static constexpr int number = 4;

    template <class View, class Contacts>
    static INGOT_INLINE void prepare(const View& solver, int block_i, const Contacts& contacts) {
        FrictionRows& friction = solver.blocks[block_i].friction;
        const mask there = contacts.used[0] > lane{};
        const auto& response = contacts.response;
        response.prepare_levers(friction.levers[0], contacts.middle, contacts.t_1, there);
        response.prepare_levers(friction.levers[1], contacts.middle, contacts.t_2, there);
        const lane K_11 = response.compliance(friction.levers[0], contacts.t_1, friction.levers[0], contacts.t_1, response.inv_M);
        const lane K_22 = response.compliance(friction.levers[1], contacts.t_2, friction.levers[1], contacts.t_2, response.inv_M);
        const lane K_12 = response.compliance(friction.levers[0], contacts.t_1, friction.levers[1], contacts.t_2, lane{});
        prepare_pair(friction, K_11, K_12, K_22, there);
        friction.sliding = 0;
        friction.turns_round = false;
        for (int axis = 0; axis < 2; ++axis) store(friction.shift[axis], lane{});
    }

    /// Impulses on record are vectors in the world: they become components along t_1 and t_2.
/// The slow mean of a new manifold is its friction itself: the mean on record is that of the manifold that had the record before.
    template <class View, class Kept>
    static void recall(const View& solver, int block_i, int lane_i, const Kept& kept) {
        auto& block = solver.blocks[block_i];
        const Vector t_1 = lane_of(block.t_1, lane_i), t_2 = lane_of(block.t_2, lane_i);
        const bool is_new = kept.record_i < 0 || age_of(kept.record) == 0;
        const Vector j = kept.record.j_friction, reference = is_new ? Vector{} : solver.friction_references[kept.record_i];
        block.friction.j[0][lane_i] = dot(j, t_1) * kept.share;
        block.friction.j[1][lane_i] = dot(j, t_2) * kept.share;
        block.friction.reference[0][lane_i] = dot(reference, t_1) * kept.share;
        block.friction.reference[1][lane_i] = dot(reference, t_2) * kept.share;
        Surfaces::recall(solver, block_i, lane_i, kept);
    }
    template <class View>
    static void remember(const View& solver, int block_i, int lane_i, int record_i, scalar part) {
        const auto& block = solver.blocks[block_i];
        const Vector t_1 = lane_of(block.t_1, lane_i), t_2 = lane_of(block.t_2, lane_i);
        // Of what presses nothing the sign of zero is up to its neighbours in the block: 0 is added, and it is +.
        solver.records[record_i].j_friction = (t_1 * block.friction.j[0][lane_i] + t_2 * block.friction.j[1][lane_i]) * part + Vector{};
        solver.friction_references[record_i] =
            (t_1 * block.friction.reference[0][lane_i] + t_2 * block.friction.reference[1][lane_i]) * part + Vector{};
    }

    template <class Visit, class Pair>
    static INGOT_INLINE void warm_start(Visit& at, Pair& pair, scalar) {
        auto& block = at.block;
        FrictionRows& friction = block.friction;
        const lane limit = load(block.mu) * at.load_of_normals, steps = load(block.substeps);
        const lane before_1 = load(friction.j[0]), before_2 = load(friction.j[1]);
        const lane reference_1 = load(friction.reference[0]), reference_2 = load(friction.reference[1]);
        const mask slides = is_on_cone(before_1 * before_1 + before_2 * before_2, limit);
        const mask young = either(slides, steps < splat<lane>(static_cast<scalar>(at.solver.effort.substeps)));
        friction.sliding = static_cast<uint16_t>((Visit::whole ? 0 : friction.sliding & ~unsigned{bits(at.active)}) |
                                                 bits(both(both(slides, limit > lane{}), at.active)));
        const Smoothed along_1 = smoothed(before_1, reference_1, young), along_2 = smoothed(before_2, reference_2, young);
        lane j_1 = along_1.j, j_2 = along_2.j;
        clamp_to_cone(j_1, j_2, limit);
        store_if<Visit::whole>(friction.j[0], at.active, j_1);
        store_if<Visit::whole>(friction.j[1], at.active, j_2);
        store_if<Visit::whole>(friction.j_sweep[0], at.active, j_1);
        store_if<Visit::whole>(friction.j_sweep[1], at.active, j_2);
        store_if<Visit::whole>(friction.reference[0], at.active, along_1.reference);
        store_if<Visit::whole>(friction.reference[1], at.active, along_2.reference);
        store_if<Visit::whole>(block.substeps, at.active, steps + splat<lane>(1));
        add_linear(pair, load(block.t_1) * j_1 + load(block.t_2) * j_2, at.inv_M_A, at.inv_M_B);
        add_angular(pair, friction.levers[0], j_1);
        add_angular(pair, friction.levers[1], j_2);
    }

    template <class Visit, class Pair>
    static INGOT_INLINE void solve(Visit& at, Pair& pair, Change& change) {
        FrictionRows& friction = at.block.friction;
        const Vec3<lane> t_1 = load(at.block.t_1), t_2 = load(at.block.t_2), slip = pair.linear_A - pair.linear_B;
        lane u_1 = row_speed(friction.levers[0], dot(t_1, slip), pair), u_2 = row_speed(friction.levers[1], dot(t_2, slip), pair);
        Surfaces::add(at, u_1, u_2);
        u_1 = u_1 + load(friction.shift[0]);
        u_2 = u_2 + load(friction.shift[1]);
        const auto [d_1, d_2] = solve_pair<Visit::whole>(friction, u_1, u_2, load(at.block.mu) * at.load_of_normals, at.active);
        add_linear(pair, t_1 * d_1 + t_2 * d_2, at.inv_M_A, at.inv_M_B);
        add_angular(pair, friction.levers[0], d_1);
        add_angular(pair, friction.levers[1], d_2);
        change.add(d_1, load(friction.K[0]));
        change.add(d_2, load(friction.K[1]));
    }

    template <class View, class Each>
    static INGOT_INLINE void for_rows(const View& solver, int block_i, const Each& each) {
        auto& block = solver.blocks[block_i];
        FrictionRows& of = block.friction;
        for (int axis = 0; axis < 2; ++axis) {
            const Levers& levers = of.levers[axis];
            each(SeenRow{number + axis, axis == 0 ? block.t_1 : block.t_2, &levers, levers.k_A, levers.k_B, of.j[axis], of.j_sweep[axis],
                         of.direction[axis]});
        }
    }
};

} }  // namespace ingot

#pragma GCC diagnostic pop
