// SPDX-License-Identifier: MIT
#include "conjugate_gradients.h"

#include "../../base/limits.h"
#include "../../math/sqrt.h"
#include "../../constraint/block_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// P = beta P + (now - before); now += beta P; before = now. The fourth number, which is no coordinate, stays.
INGOT_INLINE void go_on(scalar (&now)[4], scalar (&before)[4], scalar (&P)[4], scalar beta) {
    scalar along[4], next[4];
    for (int i = 0; i < 4; ++i) along[i] = beta * P[i] + (now[i] - before[i]);
    for (int i = 0; i < 4; ++i) next[i] = now[i] + beta * along[i];
    next[3] = now[3];
    for (int i = 0; i < 4; ++i) P[i] = along[i];
    for (int i = 0; i < 4; ++i) now[i] = before[i] = next[i];
}

/// The same for the impulses of a row.
INGOT_INLINE void go_on(scalar (&j)[lanes], scalar (&j_sweep)[lanes], scalar (&direction)[lanes], lane beta) {
    const lane now = load(j), along = beta * load(direction) + (now - load(j_sweep)), next = now + beta * along;
    store(direction, along);
    store(j, next);
    store(j_sweep, next);
}

}  // namespace

void begin_sweeps(const SolverView& solver) {
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {  // bound: max_bodies + 1
        const SolverBody& body = solver.bodies[body_i];
        SolverBodyHistory& history = solver.histories[body_i];
        for (int i = 0; i < 4; ++i) history.v_sweep[i] = body.v_CM[i];
        for (int i = 0; i < 4; ++i) history.L_sweep[i] = body.L[i];
    }
}

template <class View>
void extrapolate(const View& solver, scalar beta) {
    const lane beta_of_rows = splat<lane>(beta);
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {  // bound: max_manifolds
        ContactBlock& block = solver.blocks[block_i];
        // bound: 4
        for (int row = 0; row < block.rows; ++row) go_on(block.row[row].j, block.row[row].j_sweep, block.row[row].direction, beta_of_rows);
        for (int axis = 0; axis < 2; ++axis)
            go_on(block.friction.j[axis], block.friction.j_sweep[axis], block.friction.direction[axis], beta_of_rows);
        if (block.rows > 1) go_on(block.torsion.j, block.torsion.j_sweep, block.torsion.direction, beta_of_rows);
        if constexpr (View::rolls) {
            RollingRows& rolling = solver.rolling[block_i];
            for (int axis = 0; axis < 2; ++axis) go_on(rolling.j[axis], rolling.j_sweep[axis], rolling.direction[axis], beta_of_rows);
        }
    }
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {
        SolverBody& body = solver.bodies[body_i];
        SolverBodyHistory& history = solver.histories[body_i];
        go_on(body.v_CM, history.v_sweep, history.P_v, beta);
        go_on(body.L, history.L_sweep, history.P_L, beta);
    }
}

// The linker takes the one that the scene calls. Belts have no impulses of their own.
template void extrapolate(const SolverView&, scalar);
template void extrapolate(const RollingView&, scalar);
template void extrapolate(const RollingBeltView&, scalar);

} }  // namespace ingot
