// SPDX-License-Identifier: MIT
#include "warm_start.h"

#include "../../base/limits.h"
#include "../../math/sqrt.h"
#include "../../constraint/block_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// What is given again of the normals' impulses: of bodies that were hit, no more than gravity explains; of points that bounce, nothing.
template <int rows>
INGOT_INLINE Row4 impulses_kept(const SolverView& solver, const ContactBlock& block, const BodyPairLanes& pair, scalar h) {
    Row4 kept;
    for (int row = 0; row < rows; ++row) kept.at[row] = load(block.row[row].j);  // bound: 4: block_rows
    if (solver.some_hit) {
        const mask hit = pair.last[1] + pair.last[3] > lane{};
        if (any(hit)) {
            const lane g =
                max(gather(solver.bodies, block.body_A, &SolverBody::dp).at[3], gather(solver.bodies, block.body_B, &SolverBody::dp).at[3]);
            const lane allowance = splat<lane>(2 * h) * g;
            for (int row = 0; row < rows; ++row) {
                const lane most = splat<lane>(2) * load(block.row[row].j_before) + allowance / load(block.K[Sym4::index(row, row)]);
                kept.at[row] = select(hit, min(kept.at[row], most), kept.at[row]);
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

template <bool whole>
INGOT_INLINE void start_rolling(RollingRows& rolling, BodyPairLanes& pair, const ContactBlock& block, lane load_of_normals, mask active) {
    lane j[2] = {load(rolling.j[0]), load(rolling.j[1])};
    clamp_to_cone(j[0], j[1], load(rolling.lever) * load_of_normals);
    for (int axis = 0; axis < 2; ++axis) {
        store_if<whole>(rolling.j[axis], active, j[axis]);
        store_if<whole>(rolling.j_sweep[axis], active, j[axis]);
        add_torsion(pair, load(axis == 0 ? block.t_1 : block.t_2), j[axis], load(block.inv_M_A), load(block.inv_M_B));
    }
}

template <int rows, bool whole, class View>
INGOT_INLINE void warm_start_visit(const View& solver, [[maybe_unused]] int block_i, ContactBlock& block, uint16_t lane_bits, scalar h) {
    const mask active = lanes_of(lane_bits);
    const Vec3<lane> n = load(block.n);
    const lane inv_M_A = load(block.inv_M_A), inv_M_B = load(block.inv_M_B);
    BodyPairLanes pair = gather_bodies(solver, block, &SolverBody::v_CM, &SolverBody::L);

    const Row4 j = impulses_kept<rows>(solver, block, pair, h);
    for (int row = 0; row < rows; ++row) {
        store_if<whole>(block.row[row].j, active, j.at[row]);
        store_if<whole>(block.row[row].j_before, active, j.at[row]);
        store_if<whole>(block.row[row].j_sweep, active, j.at[row]);
        if (rows > 1 || !block.central) add_angular(pair, block.row[row].levers, j.at[row]);
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
    clamp_to_cone(j_1, j_2, limit);
    store_if<whole>(block.friction.j[0], active, j_1);
    store_if<whole>(block.friction.j[1], active, j_2);
    store_if<whole>(block.friction.j_sweep[0], active, j_1);
    store_if<whole>(block.friction.j_sweep[1], active, j_2);
    store_if<whole>(block.friction.reference[0], active, along_1.reference);
    store_if<whole>(block.friction.reference[1], active, along_2.reference);
    store_if<whole>(block.substeps, active, steps + splat<lane>(1));
    add_linear(pair, load(block.t_1) * j_1 + load(block.t_2) * j_2, inv_M_A, inv_M_B);
    add_angular(pair, block.friction.levers[0], j_1);
    add_angular(pair, block.friction.levers[1], j_2);
    if constexpr (rows > 1) {
        const lane torsion = clamp(load(block.torsion.j), limit * load(block.torsion.radius));
        store_if<whole>(block.torsion.j, active, torsion);
        store_if<whole>(block.torsion.j_sweep, active, torsion);
        add_torsion(pair, n, torsion, inv_M_A, inv_M_B);
    }
    if constexpr (View::rolls) start_rolling<whole>(solver.rolling[block_i], pair, block, sum, active);
    scatter_bodies(solver, block, lane_bits, pair, &SolverBody::v_CM, &SolverBody::L);
}

}  // namespace

template <class View>
void warm_start(const View& solver, scalar h) {
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {  // bound: max_manifolds
        const Visit visit = solver.visits[visit_i];
        ContactBlock& block = solver.blocks[visit.block];
        const bool whole = is_all(visit.lane_bits);
        if (block.rows == 1)
            whole ? warm_start_visit<1, true>(solver, visit.block, block, visit.lane_bits, h)
                  : warm_start_visit<1, false>(solver, visit.block, block, visit.lane_bits, h);
        else
            whole ? warm_start_visit<block_rows, true>(solver, visit.block, block, visit.lane_bits, h)
                  : warm_start_visit<block_rows, false>(solver, visit.block, block, visit.lane_bits, h);
    }
}

// The linker takes the one that the scene calls. Belts have no impulses of their own.
template void warm_start(const SolverView&, scalar);
template void warm_start(const RollingView&, scalar);
template void warm_start(const RollingBeltView&, scalar);

} }  // namespace ingot
