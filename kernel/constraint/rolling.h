// SPDX-License-Identifier: MIT
// Rolling resistance: a torque about t_1 and t_2 against the turn of A relative to B, within a circle: |j| <= lever N.
//
//     u = t . (omega_A - omega_B), rad/s;  J_A = t, J_B = -t
//
//     lever  m. The load is carried not at the middle of the contact but up to `lever` ahead of it, which is the classical coefficient of
//            rolling friction. So a ball of radius R slows by (5/7) g lever / R, and rests up to tan(alpha) = lever / R
//     N      N s, what the normals carry
//
// Source: as a cone beside that of friction, Tasora and Anitescu, "A complementarity-based rolling friction model for rigid contacts",
// Meccanica 48 (2013). Of their three coefficients this is the rolling one; spin about n is resisted by areas alone, see torsion.h.
#pragma once

#include "row_pair.h"
#include "surface_materials.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// By block, beside the block: scenes without rolling resistance have none. Impulses in N m s.
struct RollingRows : RowPair {
    LaneRow lever;                 ///< m
    LaneRow k_A[2][3], k_B[2][3];  ///< inv_I_world t, and its opposite
    LaneRow size;                  ///< m; radius of gyration: what turns an angular velocity into a speed worth settling
};

struct Rolling {
    static constexpr int number = 7;

    template <class View, class Contacts>
    static INGOT_INLINE void prepare(const View& solver, int block_i, const Contacts& contacts) {
        RollingRows& rolling = solver.rolling[block_i];
        const Vec3<lane> t[2] = {contacts.t_1, contacts.t_2};
        Vec3<lane> k[2];
        for (int axis = 0; axis < 2; ++axis) {
            const Vec3<lane> k_A = contacts.response.spin_of_A(t[axis]), k_B = contacts.response.spin_of_B(t[axis]);
            store(rolling.k_A[axis], k_A);
            store(rolling.k_B[axis], k_B);
            k[axis] = k_A - k_B;
        }
        const Vec3<lane> none{};
        const lane K_11 = contacts.response.turn_compliance(k[0], none, t[0], t[0]), K_22 = contacts.response.turn_compliance(k[1], none, t[1], t[1]);
        const lane K_12 = contacts.response.turn_coupling(k[0], none, t[0], t[1]);
        const lane K_max = prepare_pair(rolling, K_11, K_12, K_22, K_11 > lane{});
        store(rolling.size, sqrt(contacts.response.inv_M / K_max));
    }

    template <class View, class Kept>
    static void recall(const View& solver, int block_i, int lane_i, const Kept& kept) {
        const auto& block = solver.blocks[block_i];
        RollingRows& rolling = solver.rolling[block_i];
        const RollingRecord record = kept.record_i < 0 ? RollingRecord{} : solver.rolling_records[kept.record_i];
        rolling.lever[lane_i] = record.lever;
        rolling.j[0][lane_i] = dot(record.j, lane_of(block.t_1, lane_i)) * kept.share;
        rolling.j[1][lane_i] = dot(record.j, lane_of(block.t_2, lane_i)) * kept.share;
    }
    template <class View>
    static void remember(const View& solver, int block_i, int lane_i, int record_i, scalar part) {
        const auto& block = solver.blocks[block_i];
        const RollingRows& rolling = solver.rolling[block_i];
        solver.rolling_records[record_i].j =
            (lane_of(block.t_1, lane_i) * rolling.j[0][lane_i] + lane_of(block.t_2, lane_i) * rolling.j[1][lane_i]) * part + Vector{};
    }

    template <class Visit, class Pair>
    static INGOT_INLINE void warm_start(Visit& at, Pair& pair, scalar) {
        RollingRows& rolling = at.solver.rolling[at.block_i];
        lane j[2] = {load(rolling.j[0]), load(rolling.j[1])};
        clamp_to_cone(j[0], j[1], load(rolling.lever) * at.load_of_normals);
        for (int axis = 0; axis < 2; ++axis) {
            store_if<Visit::whole>(rolling.j[axis], at.active, j[axis]);
            store_if<Visit::whole>(rolling.j_sweep[axis], at.active, j[axis]);
            add_torsion(pair, load(axis == 0 ? at.block.t_1 : at.block.t_2), j[axis], at.inv_M_A, at.inv_M_B);
        }
    }

    template <class Visit, class Pair>
    static INGOT_INLINE void solve(Visit& at, Pair& pair, Change& change) {
        RollingRows& rolling = at.solver.rolling[at.block_i];
        const lane u_1 = dot(pair.angular_A, load(rolling.k_A[0])) + dot(pair.angular_B, load(rolling.k_B[0]));
        const lane u_2 = dot(pair.angular_A, load(rolling.k_A[1])) + dot(pair.angular_B, load(rolling.k_B[1]));
        const auto [d_1, d_2] = solve_pair<Visit::whole>(rolling, u_1, u_2, load(rolling.lever) * at.load_of_normals, at.active);
        add_torsion(pair, load(at.block.t_1), d_1, at.inv_M_A, at.inv_M_B);
        add_torsion(pair, load(at.block.t_2), d_2, at.inv_M_A, at.inv_M_B);
        const lane spin_1 = d_1 * load(rolling.K[0]), spin_2 = d_2 * load(rolling.K[1]);
        change.size = change.size + (d_1 * spin_1 + d_2 * spin_2);
        change.fastest = max(change.fastest, max(abs(spin_1), abs(spin_2)) * load(rolling.size));
    }

    template <class View, class Each>
    static INGOT_INLINE void for_rows(const View& solver, int block_i, const Each& each) {
        auto& block = solver.blocks[block_i];
        RollingRows& of = solver.rolling[block_i];
        for (int axis = 0; axis < 2; ++axis)
            each(SeenRow{number + axis, axis == 0 ? block.t_1 : block.t_2, nullptr, of.k_A[axis], of.k_B[axis], of.j[axis], of.j_sweep[axis],
                         of.direction[axis]});
    }
};

} }  // namespace ingot

#pragma GCC diagnostic pop
