// SPDX-License-Identifier: MIT
#include "prepare_materials.h"

#include "../math/sqrt.h"
#include "block_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Of what can move; zero for the rest.
Sym3<lane> inv_I_of(const SolverView& solver, const BodyView& bodies, const uint16_t* locals) {
    scalar rows[6][lanes] = {};
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        if (locals[lane_i] == 0) continue;
        const Place at = place_of(solver.slot_of[locals[lane_i]]);
        set_lane(rows, lane_i, lane_of(bodies.translation[at.tile].inv_I_world, at.lane));
    }
    return {load(rows[0]), load(rows[1]), load(rows[2]), load(rows[3]), load(rows[4]), load(rows[5])};
}

void prepare_compliance(RollingRows& rolling, const ContactBlock& block, const Sym3<lane>& inv_I_A, const Sym3<lane>& inv_I_B) {
    const Vec3<lane> t[2] = {load(block.t_1), load(block.t_2)};
    Vec3<lane> k[2];
    for (int axis = 0; axis < 2; ++axis) {
        const Vec3<lane> k_A = inv_I_A * t[axis], k_B = inv_I_B * -t[axis];
        store(rolling.k_A[axis], k_A);
        store(rolling.k_B[axis], k_B);
        k[axis] = k_A - k_B;
    }
    const lane K_11 = dot(k[0], t[0]), K_22 = dot(k[1], t[1]), K_12 = dot(k[0], t[1]);
    const lane K_max = prepare_pair(rolling, K_11, K_12, K_22, K_11 > lane{});
    store(rolling.size, sqrt((load(block.inv_M_A) + load(block.inv_M_B)) / K_max));
}

}  // namespace

void prepare_rolling(const SolverView& solver, const BodyView& bodies, RollingRows* rolling, const RollingRecord* records) {
    const scalar share = shares_of_substep(solver);
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {  // bound: max_manifolds, rounded up to whole blocks
        const ContactBlock& block = solver.blocks[block_i];
        RollingRows& rows = rolling[block_i];
        prepare_compliance(rows, block, inv_I_of(solver, bodies, block.body_A), inv_I_of(solver, bodies, block.body_B));
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            const uint16_t manifold_i = block.manifold[lane_i];
            const RollingRecord record = manifold_i == no_manifold ? RollingRecord{} : records[solver.pairs[manifold_i].record];
            rows.lever[lane_i] = record.lever;
            rows.j[0][lane_i] = dot(record.j, lane_of(block.t_1, lane_i)) * share;
            rows.j[1][lane_i] = dot(record.j, lane_of(block.t_2, lane_i)) * share;
        }
    }
}

void prepare_belts(const SolverView& solver, BeltRows* belts, const Vector* velocities) {
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {
        const ContactBlock& block = solver.blocks[block_i];
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            const uint16_t manifold_i = block.manifold[lane_i];
            const Vector v = manifold_i == no_manifold ? Vector{} : velocities[solver.pairs[manifold_i].record];
            belts[block_i].speed[0][lane_i] = dot(v, lane_of(block.t_1, lane_i));
            belts[block_i].speed[1][lane_i] = dot(v, lane_of(block.t_2, lane_i));
        }
    }
}

void remember_rolling(const SolverView& solver, const RollingRows* rolling, RollingRecord* records) {
    const scalar part = 1 / shares_of_substep(solver);
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {
        const ContactBlock& block = solver.blocks[block_i];
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            const uint16_t manifold_i = block.manifold[lane_i];
            if (manifold_i == no_manifold || solver.islands[block.island[lane_i]].begins_again) continue;
            const RollingRows& rows = rolling[block_i];
            records[solver.pairs[manifold_i].record].j =
                (lane_of(block.t_1, lane_i) * rows.j[0][lane_i] + lane_of(block.t_2, lane_i) * rows.j[1][lane_i]) * part;
        }
    }
}

} }  // namespace ingot
