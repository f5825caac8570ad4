// SPDX-License-Identifier: MIT
// Torsion: an area of contact resists a turn about n.
//
//     u + K (j - j_0) = 0, cut to |j| <= mu N radius
//
//     u       rad/s, n . (omega_A - omega_B); J_A = n, J_B = -n
//     N       N s, what the normals carry
//     radius  m, mean distance of the points from where friction takes hold. One point has none, and no torsion
//
// Source: as Coulomb friction spread over the area, apart from its slip: Trinkle, Tzitzouris and Pang, "Dynamic multi-rigid-body systems
// with concurrent distributed contacts", 2001, have both in one ellipsoid.
#pragma once

#include "laws.h"
#include "rows.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

struct TorsionRow {
    LaneRow k_A[3], k_B[3];  ///< inv_I_world n, and its opposite
    LaneRow K, inv_K, radius;
    LaneRow j, j_sweep, direction;  ///< N m s
};

struct Torsion {
    static constexpr int number = 6;

    template <class View, class Contacts>
    static INGOT_INLINE void prepare(const View& solver, int block_i, const Contacts& contacts) {
        TorsionRow& torsion = solver.blocks[block_i].torsion;
        const lane one = splat<lane>(1);
        const Vec3<lane> k_A = contacts.response.spin_of_A(contacts.n), k_B = contacts.response.spin_of_B(contacts.n);
        const lane K = contacts.response.turn_compliance(k_A, k_B, contacts.n, contacts.n);
        const mask turns = both(contacts.used[0] > lane{}, K > lane{});
        store(torsion.k_A, k_A);
        store(torsion.k_B, k_B);
        store(torsion.K, K);
        store(torsion.inv_K, select(turns, one / select(turns, K, one), lane{}));
        store(torsion.radius, contacts.radius);
        store(torsion.direction, lane{});
    }

    template <class View, class Kept>
    static void recall(const View& solver, int block_i, int lane_i, const Kept& kept) {
        solver.blocks[block_i].torsion.j[lane_i] = kept.record.manifold.count > 1 ? kept.record.j_torsion * kept.share : 0;
    }
    template <class View>
    static void remember(const View& solver, int block_i, int lane_i, int record_i, scalar part) {
        solver.records[record_i].j_torsion = solver.blocks[block_i].torsion.j[lane_i] * part + 0;  // +0: see Friction::remember
    }

    template <class Visit, class Pair>
    static INGOT_INLINE void warm_start(Visit& at, Pair& pair, scalar) {
        if constexpr (Visit::rows > 1) {
            TorsionRow& torsion = at.block.torsion;
            const lane j = clamp(load(torsion.j), load(at.block.mu) * at.load_of_normals * load(torsion.radius));
            store_if<Visit::whole>(torsion.j, at.active, j);
            store_if<Visit::whole>(torsion.j_sweep, at.active, j);
            add_torsion(pair, at.n, j, at.inv_M_A, at.inv_M_B);
        }
    }

    template <class Visit, class Pair>
    static INGOT_INLINE void solve(Visit& at, Pair& pair, Change& change) {
        if constexpr (Visit::rows > 1) {  // one point has no lever to resist a torsion with
            TorsionRow& torsion = at.block.torsion;
            const lane spin = dot(pair.angular_A, load(torsion.k_A)) + dot(pair.angular_B, load(torsion.k_B));
            const lane before = load(torsion.j), radius = load(torsion.radius), K = load(torsion.K);
            const lane j = clamp(before - spin * load(torsion.inv_K), load(at.block.mu) * at.load_of_normals * radius), d = j - before;
            add_torsion(pair, at.n, d, at.inv_M_A, at.inv_M_B);
            store_if<Visit::whole>(torsion.j, at.active, j);
            change.size = change.size + d * d * K;
            change.fastest = max(change.fastest, abs(d * K) * radius);
        }
    }

    template <class View, class Each>
    static INGOT_INLINE void for_rows(const View& solver, int block_i, const Each& each) {
        auto& block = solver.blocks[block_i];
        if (block.rows == 1) return;
        TorsionRow& of = block.torsion;
        each(SeenRow{number, block.n, nullptr, of.k_A, of.k_B, of.j, of.j_sweep, of.direction});
    }
};

} }  // namespace ingot

#pragma GCC diagnostic pop
