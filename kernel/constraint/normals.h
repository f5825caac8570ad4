// SPDX-License-Identifier: MIT
// The points of a manifold push the bodies apart, and never pull: up to four normals as one complementarity problem.
//
//     0 <= j,   u + K (j - j_0) - target >= 0,   and one of the two zero in each row
//
//     u       speed along n at a point: J_A = r_AP x n, J_B = -(r_BP x n); negative where A approaches B
//     j       N s, the impulse at the point; j_0 what it is before the visit
//     K       4x4, compliance of the rows: four points of a plane have rank 3
//     target  m/s; a point may approach by what room it has left, or has to leave as fast as it bounces (row_flight.h)
//
// Positions are the mirror image, with displacements for speeds and overlaps for targets: see push.
// Sources: block_solve.h; Moreau 1966 and Hecker 1997, Fig. 4, for one row.
#pragma once

#include "block_solve.h"
#include "laws.h"
#include "solver_body.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// One normal of each lane's manifold.
struct NormalRow {
    Levers levers;
    LaneRow separation;          ///< m, at the begin of the step
    LaneRow target;              ///< m/s, that A may approach B with in the substep, at least
    LaneRow landing;             ///< m, of a point that bounces: its separation at the end of the substep; limits::unbounded: it does not
    LaneRow j;                   ///< N s
    LaneRow j_before;            ///< of the substep before
    LaneRow j_sweep, direction;  ///< conjugate gradients: before the sweep, and the direction so far
};

/// True where a manifold has that point.
template <class Block>
INGOT_INLINE mask is_used(const Block& block, int row) {
    return load(block.count) > splat<lane>(static_cast<scalar>(row));
}

/// Of rows of blocks with so many: a manifold of one point has that one, unless joints hold its bodies fast. Who shares the block is no matter.
template <int rows, bool articulates>
inline constexpr bool always_used = rows == 1 && !articulates;

INGOT_INLINE mask bounces(const NormalRow& row) { return load(row.landing) < splat<lane>(limits::unbounded); }

/// Where a point is now: its separation at the begin of the step, and what displacements have made of it.
template <class Block>
INGOT_INLINE lane separation_now(const Block& block, int row, lane linear_displacement, const BodyPairLanes& displaced) {
    return load(block.row[row].separation) + row_displacement(block.row[row].levers, linear_displacement, displaced);
}

/// What is to be taken back of each row, and which rows may also be drawn together.
struct Pushes {
    Row4 w;                   ///< m
    mask pulls[block_rows];   ///< pressed points, and those that land at a place of their own
    mask off, lands;          ///< a row is where it should not be; a row lands
};

struct Normals {
    /// Levers, compliance and its inverse; and which manifolds are central: one normal, through the centres of both bodies that move.
    template <class View, class Contacts>
    static INGOT_INLINE void prepare(const View& solver, int block_i, Contacts& contacts) {
        auto& block = solver.blocks[block_i];
        constexpr int fewest = View::locks_axes ? View::points_max : 1;  // see fewest_rows
        contacts.central = has_one_row(solver, block) ? prepare_rows<fewest>(block, contacts) : prepare_rows<View::points_max>(block, contacts);
    }

    template <class View, class Kept>
    static void recall(const View& solver, int block_i, int lane_i, const Kept& kept) {
        auto& block = solver.blocks[block_i];
        for (int row = 0; row < block.rows; ++row) {  // bound: 4: block_rows
            block.row[row].j[lane_i] = kept.record.j[row] * kept.share;
            block.row[row].j_before[lane_i] = kept.record.j_before[row] * kept.share;
        }
    }
    template <class View>
    static void remember(const View& solver, int block_i, int lane_i, int record_i, scalar part) {
        const auto& block = solver.blocks[block_i];
        auto& record = solver.records[record_i];
        // Of balls that met: what is read of the contact is along the normal that they had then. Contacts that move along keep that of the begin.
        if (record.manifold.count == 1 && (block.moving >> lane_i & 1u) == 0) record.manifold.n = lane_of(block.n, lane_i);
        for (int row = 0; row < record.manifold.count; ++row) {  // bound: 4: Manifold::points_max
            const bool bounced = block.row[row].landing[lane_i] < limits::unbounded;  // an impact is over: it is not given again
            record.j[row] = bounced ? scalar(0) : block.row[row].j[lane_i] * part;
            record.j_before[row] = block.row[row].j_before[lane_i] * part;
        }
    }

    /// Gives the impulses again: to bodies that were hit no more than gravity explains, to points that bounce nothing.
    template <class Visit, class Pair>
    static INGOT_INLINE void warm_start(Visit& at, Pair& pair, scalar h) {
        const Row4 j = impulses_kept<Visit::rows>(at.solver, at.block, pair, h);
        for (int row = 0; row < Visit::rows; ++row) {  // bound: 4: block_rows
            NormalRow& to = at.block.row[row];
            store_if<Visit::whole>(to.j, at.active, j.at[row]);
            store_if<Visit::whole>(to.j_before, at.active, j.at[row]);
            store_if<Visit::whole>(to.j_sweep, at.active, j.at[row]);
            if (Visit::rows > 1 || !at.block.central) add_angular(pair, to.levers, j.at[row]);
        }
        lane sum{};
        for (int row = 0; row < Visit::rows; ++row) sum = sum + j.at[row];
        add_linear(pair, at.n * sum, at.inv_M_A, at.inv_M_B);
        at.load_of_normals = sum;
    }

    template <class Visit, class Pair>
    static INGOT_INLINE void solve(Visit& at, Pair& pair, Change& change) {
        constexpr int rows = Visit::rows;
        auto& block = at.block;
        const lane approach = dot(at.n, pair.linear_A - pair.linear_B);
        Row4 before, w;
        for (int row = 0; row < rows; ++row) {
            before.at[row] = load(block.row[row].j);
            const lane speed =
                (rows == 1 && block.central ? approach : row_speed(block.row[row].levers, approach, pair)) - load(block.row[row].target);
            w.at[row] = always_used<rows, Visit::articulates> ? speed : select(is_used(block, row), speed, lane{});
        }
        const mask none[block_rows] = {};
        const scalar slack = limits::approach_slack * at.solver.unit;
        const Row4 j = solve_block<rows, true>(block.K, block.count, block.cached_inverse, w, before, none, slack, at.active);
        lane total{}, given{};
        for (int row = 0; row < rows; ++row) {
            const lane d = j.at[row] - before.at[row];
            if (rows > 1 || !block.central) add_angular(pair, block.row[row].levers, d);
            given = given + d;
            total = total + j.at[row];
            change.add(d, load(block.K[Sym4::index(row, row)]));
            store_if<Visit::whole>(block.row[row].j, at.active, j.at[row]);
        }
        add_linear(pair, at.n * given, at.inv_M_A, at.inv_M_B);
        at.load_of_normals = total;
    }

    /// The position sweep: what is off, of displacements dp and dth.
    template <int rows, bool articulates, class Block>
    static INGOT_INLINE Pushes pushes_due(const Block& block, const Vec3<lane>& n, const BodyPairLanes& displaced, scalar h, scalar unit) {
        const lane deepest = splat<lane>(-limits::push_speed_max * h * unit), settled = splat<lane>(-limits::settled_gap * unit);
        const lane apart = dot(n, displaced.linear_A - displaced.linear_B), inv_M = load(block.inv_M_A) + load(block.inv_M_B);
        Pushes due;
        due.off = due.lands = splat<lane>(1) < lane{};
        for (int row = 0; row < rows; ++row) {
            const lane s = separation_now(block, row, apart, displaced);
            const mask lands = bounces(block.row[row]), pressed = presses(load(block.row[row].j), inv_M, splat<lane>(unit));
            const lane w = select(lands, s - load(block.row[row].landing), position_target(s, pressed, deepest));
            due.w.at[row] = always_used<rows, articulates> ? w : select(is_used(block, row), w, lane{});
            due.pulls[row] = either(lands, pressed);
            due.lands = either(due.lands, lands);
            due.off = either(due.off, select(due.pulls[row], -abs(due.w.at[row]), due.w.at[row]) < settled);
        }
        return due;
    }
    /// Solves for the pushes. At rest hardly a row is off, and this is not called.
    template <int rows, class Block>
    static INGOT_RARE Row4 push(Block& block, const Pushes& due, scalar slack, mask active) {
        const Row4 none = {};
        return solve_block<rows, false>(block.K, block.count, block.cached_inverse, due.w, none, due.pulls, slack, active);
    }

    /// Numbers 0 .. 3.
    template <class View, class Each>
    static INGOT_INLINE void for_rows(const View& solver, int block_i, const Each& each) {
        auto& block = solver.blocks[block_i];
        for (int row = 0; row < View::points_max && row < block.rows; ++row) {
            NormalRow& of = block.row[row];
            each(SeenRow{row, block.n, &of.levers, of.levers.k_A, of.levers.k_B, of.j, of.j_sweep, of.direction});
        }
    }

private:
    template <int rows, class Block, class Contacts>
    static INGOT_INLINE mask prepare_rows(Block& block, const Contacts& contacts) {
        const lane one = splat<lane>(1);
        const mask alone = rows > 1 ? contacts.used[1] == lane{} : one > lane{};
        const mask central = both(alone, is_central(contacts));
        block.central = rows == 1 && !any(opposite(central));
        mask there[block_rows];
        for (int row = 0; row < rows; ++row) {  // bound: 4: block_rows
            there[row] = contacts.used[row] > lane{};
            NormalRow& to = block.row[row];
            contacts.response.prepare_levers(to.levers, contacts.P[row], contacts.n, both(there[row], opposite(central)));
            store(to.separation, contacts.separation[row]);
            store(to.target, lane{});
            store(to.landing, splat<lane>(limits::unbounded));
            store(to.direction, lane{});
        }
        prepare_compliance<rows>(block, contacts, there);
        return both(central, there[0]);
    }

    /// True where the normal has no lever, to the rounding of P.
    template <class Contacts>
    static INGOT_INLINE mask is_central(const Contacts& contacts) {
        const Vec3<lane> P = contacts.P[0], n = contacts.n;
        const lane rounding = splat<lane>(8 * epsilon) * (abs(P.x) + abs(P.y) + abs(P.z));
        const auto passes = [&](const auto& body) {
            const Vec3<lane> J = cross(P - body.r_CM, n);
            return either(opposite(body.moves), both(both(abs(J.x) <= rounding, abs(J.y) <= rounding), abs(J.z) <= rounding));
        };
        return both(passes(contacts.response.A), passes(contacts.response.B));
    }

    template <int rows, class Block, class Contacts>
    static INGOT_INLINE void prepare_compliance(Block& block, const Contacts& contacts, const mask (&there)[block_rows]) {
        const lane one = splat<lane>(1);
        Sym4 K;
        for (int row = 0; row < rows; ++row)
            for (int c = row; c < rows; ++c)
                K(row, c) = select(both(there[row], there[c]),
                                   contacts.response.compliance(block.row[row].levers, contacts.n, block.row[c].levers, contacts.n,
                                                                 contacts.response.inv_M),
                                   row == c ? one : lane{});
        lane count{};
        for (int row = 0; row < rows; ++row) count = count + contacts.used[row];
        const Sym4 all = inverse_of_used<rows>(K, count);
        store(block.count, count);
        for (int row = 0; row < rows; ++row) {
            for (int c = row; c < rows; ++c) {
                store(block.K[Sym4::index(row, c)], K(row, c));
                store(block.cached_inverse[Sym4::index(row, c)], all(row, c));
            }
        }
    }

    template <int rows, class View, class Block>
    static INGOT_INLINE Row4 impulses_kept(const View& solver, const Block& block, const BodyPairLanes& pair, scalar h) {
        Row4 kept;
        for (int row = 0; row < rows; ++row) kept.at[row] = load(block.row[row].j);
        if constexpr (View::articulates)  // what joints hold fast carries nothing
            for (int row = 0; row < rows; ++row) kept.at[row] = select(is_used(block, row), kept.at[row], lane{});
        if (solver.some_hit) {
            const mask hit = pair.last[1] + pair.last[3] > lane{};
            if (any(hit)) {
                const lane g =
                    max(gather(solver.bodies, block.body_A, &SolverBody::dp).at[3], gather(solver.bodies, block.body_B, &SolverBody::dp).at[3]);
                const lane allowance = splat<lane>(2 * h) * g;
                for (int row = 0; row < rows; ++row) {
                    const lane cut =
                        impulse_after_impact(kept.at[row], load(block.row[row].j_before), allowance, load(block.K[Sym4::index(row, row)]));
                    kept.at[row] = select(hit, cut, kept.at[row]);
                }
            }
        }
        if (any(load(block.e) > lane{}))
            for (int row = 0; row < rows; ++row) kept.at[row] = select(bounces(block.row[row]), lane{}, kept.at[row]);
        return kept;
    }
};

} }  // namespace ingot

#pragma GCC diagnostic pop
