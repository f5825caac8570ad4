// SPDX-License-Identifier: MIT
#include "sweep_joint_rows.h"

#include "../../figure/joint_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Null: the island is settled, or its body has gone bad.
Island* live_island(const SolverView& solver, const JointedBodies& jointed, const JointRow& row) {
    const Index body_i = solver.local_of[jointed.figures.nodes[row.node].slot];
    if (body_i == 0) return nullptr;
    Island& island = solver.islands[solver.island_of[body_i]];
    return island.in_batch && island.sweeps_on ? &island : nullptr;
}

}  // namespace

void sweep_joint_rows(const SolverView& solver, const JointedBodies& jointed, const JointRowView& rows, bool up) {
    for (int i = 0; i < rows.count; ++i) {  // bound: limits_of_joint max_joints
        JointRow& row = rows.list[up ? i : rows.count - 1 - i];
        if (live_island(solver, jointed, row) != nullptr) row.change = visit_joint_row(jointed.figures, rows, row);
    }
}

void measure_joint_rows(const SolverView& solver, const JointedBodies& jointed, const JointRowView& rows) {
    for (int i = 0; i < rows.count; ++i) {
        const JointRow& row = rows.list[i];
        Island* const island = live_island(solver, jointed, row);
        if (island == nullptr || !(row.K > 0)) continue;
        island->size += row.change * row.change / row.K;
        const scalar unit = unit_of_travel(jointed.figures.nodes[row.node].kind, row.direction_i, solver.unit);
        island->residual = max(island->residual, abs(row.change) * (solver.unit / unit));
    }
}

void extrapolate_joint_rows(const SolverView& solver, const JointedBodies& jointed, const JointRowView& rows) {
    for (int i = 0; i < rows.count; ++i) {
        JointRow& row = rows.list[i];
        const Island* const island = live_island(solver, jointed, row);
        if (island == nullptr) continue;
        row.direction = island->beta * row.direction + (row.j - row.j_sweep);
        row.j = row.j_sweep = row.j + island->beta * row.direction;
    }
    give_joint_rows(jointed.figures, rows);
}

void excuse_driven(const SolverView& solver, const JointedBodies& jointed, const JointRowView& rows) {
    for (int i = 0; i < rows.count; ++i) {  // bound: rows_of_joint max_joints
        const Index body_i = solver.local_of[jointed.figures.nodes[rows.list[i].node].slot];
        if (rows.list[i].is_drive && body_i != 0) solver.islands[solver.island_of[body_i]].at_bound = false;
    }
}

bool are_joint_rows_live(const SolverView& solver, const JointedBodies& jointed, const JointRowView& rows) {
    bool live = false;
    for (int i = 0; i < rows.count; ++i) live = live || live_island(solver, jointed, rows.list[i]) != nullptr;
    return live;
}

} }  // namespace ingot
