// SPDX-License-Identifier: MIT
#include "conjugate_gradients.h"

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "block_rows.h"

namespace ingot { inline namespace INGOT_ABI {

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

} }  // namespace ingot
