// SPDX-License-Identifier: MIT
#include "sweep_joint_rows.h"

#include "../../figure/joint_rows.h"
#include "../../figure/moving_joint.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Null: the island is settled.
template <class Rows>
Island* live_island(const SolverView& solver, const JointedBodies& jointed, const Rows& rows, const JointRow& row) {
    Island& island = solver.islands[solver.island_of[solver.local_of[jointed.figures.nodes[node_of(rows, row)].slot]]];
    return island.in_batch && island.sweeps_on ? &island : nullptr;
}

/// A row of a ball joint's drive, or of a servo, that is visited with its first: see visit_joint_row.
bool goes_with_first(const FigureView& view, const JointRowView&, const JointRow& row) {
    return row.is_drive && row.direction_i > 0 && is_ball(view.nodes[row.node].kind);
}
bool goes_with_first(const FigureView& view, const LoopedRowView& rows, const JointRow& row) {
    const JointRowView& of_trees = rows;
    return row.closes ? row.direction_i > 0 && locks_nothing(rows.loops->joints[row.node]) : goes_with_first(view, of_trees, row);
}

}  // namespace

template <class Rows>
void sweep_joint_rows(const SolverView& solver, const JointedBodies& jointed, const Rows& rows, bool up) {
    JointRow* due = nullptr;
    const Island* island_due = nullptr;
    const auto visit_due = [&](bool is_last) {
        if (due != nullptr) due->change = visit_joint_row(jointed.figures, rows, *due, Rows::closes && is_last);
    };
    for (int i = 0; i < rows.count; ++i) {  // bound: limits_of_joint max_joints
        JointRow& row = rows.list[up ? i : rows.count - 1 - i];
        if (!(row.K > 0 || row.closes) || goes_with_first(jointed.figures, rows, row)) continue;
        const Island* const island = live_island(solver, jointed, rows, row);
        if (island == nullptr) continue;
        visit_due(island != island_due);
        due = &row;
        island_due = island;
    }
    visit_due(true);
}

template <class Rows>
void measure_joint_rows(const SolverView& solver, const JointedBodies& jointed, const Rows& rows) {
    for (int i = 0; i < rows.count; ++i) {
        const JointRow& row = rows.list[i];
        if (!(row.K > 0)) continue;
        Island* const island = live_island(solver, jointed, rows, row);
        if (island == nullptr) continue;
        island->size += row.change * row.change / row.K;
        const scalar unit = unit_of_travel(kind_of(jointed.figures, rows, row), row.direction_i, solver.unit);
        island->residual = max(island->residual, abs(row.change) * (solver.unit / unit));
    }
}

template <class Rows>
void extrapolate_joint_rows(const SolverView& solver, const JointedBodies& jointed, const Rows& rows) {
    for (int i = 0; i < rows.count; ++i) {
        JointRow& row = rows.list[i];
        if (!(row.K > 0)) continue;
        const Island* const island = live_island(solver, jointed, rows, row);
        if (island == nullptr) continue;
        row.direction = island->beta * row.direction + (row.j - row.j_sweep);
        const scalar more = island->beta * row.direction;
        row.j = row.j_sweep = row.j + more;
        if (more != 0) at_joint(jointed.figures, rows, row, [&](const auto& joint) { joint.add_drive(row.along * more); });
    }
}

template <class Rows>
bool are_joint_rows_live(const SolverView& solver, const JointedBodies& jointed, const Rows& rows) {
    bool live = false;
    for (int i = 0; i < rows.count; ++i) live = live || live_island(solver, jointed, rows, rows.list[i]) != nullptr;
    return live;
}

// The linker takes the one that the scene calls.
#define INGOT_ROWS(Rows)                                                                              \
    template void sweep_joint_rows(const SolverView&, const JointedBodies&, const Rows&, bool);       \
    template void measure_joint_rows(const SolverView&, const JointedBodies&, const Rows&);           \
    template void extrapolate_joint_rows(const SolverView&, const JointedBodies&, const Rows&);       \
    template bool are_joint_rows_live(const SolverView&, const JointedBodies&, const Rows&)
INGOT_ROWS(JointRowView);
INGOT_ROWS(DrivenRowView);
INGOT_ROWS(LoopedRowView);
#undef INGOT_ROWS

} }  // namespace ingot
