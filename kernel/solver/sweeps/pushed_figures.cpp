// SPDX-License-Identifier: MIT
#include "pushed_figures.h"

#include "figure_shares.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Places in Island::sums, beside three energies. pushed_at: m^2/s^2, of the fastest kinematic body that pushes the island; -1: none does.
enum : int { pushed_at = 3, allowed = 4 };

/// Whether some island with joints touches a kinematic body.
bool note_pushes(const SolverView& solver, const JointedBodies& jointed) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        solver.islands[island_i].beta = 1;
        solver.islands[island_i].sums[pushed_at] = -1;
    }
    bool some = false;
    // bound: max_manifolds, rounded up to whole blocks
    for (int position = 0; position < solver.block_count * lanes; ++position) {
        const ContactBlock& block = solver.blocks[position / lanes];
        const int lane_i = position % lanes, last = solver.body_count - 1;
        if (block.manifold[lane_i] == no_manifold) continue;
        const Index kinematic = block.body_A[lane_i] > last ? block.body_A[lane_i] : block.body_B[lane_i];
        Island& island = solver.islands[block.island[lane_i]];
        if (kinematic <= last || !island.in_batch || jointed.doublings_of[block.island[lane_i]] == 0) continue;
        island.sums[pushed_at] = max(island.sums[pushed_at], length_sq(three_of(solver.bodies[kinematic].v_CM)));
        some = true;
    }
    return some;
}

template <class Rows>
void excuse_driven_from_pushes(const SolverView& solver, const JointedBodies& jointed, const Rows& rows) {
    for (int i = 0; i < rows.count; ++i) {  // bound: rows_of_joint max_joints
        const Index body_i = solver.local_of[jointed.figures.nodes[node_of(rows, rows.list[i])].slot];
        if (rows.list[i].is_drive && body_i != 0) solver.islands[solver.island_of[body_i]].sums[pushed_at] = -1;
    }
}

/// Those that have more than they may, by what their bodies would have alone, are candidates. What they may have is in sums[allowed].
bool find_beyond_allowed(const SolverView& solver, const BodyView& bodies, scalar h) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i)  // bound: max_bodies
        solver.islands[island_i].sums[0] = solver.islands[island_i].sums[1] = solver.islands[island_i].sums[allowed] = 0;
    for_bodies(solver, [&](int body_i) {
        Island& island = solver.islands[solver.island_of[body_i]];
        if (island.sums[pushed_at] < 0) return;
        const SolverBody& body = solver.bodies[body_i];
        const SolverBodyHistory& history = solver.histories[body_i];
        island.sums[0] += energy_of(solver, bodies, body_i, three_of(body.v_CM), three_of(body.L));
        island.sums[1] += energy_of(solver, bodies, body_i, three_of(history.v_begin) + three_of(history.a) * h,
                                    three_of(history.L_begin) + three_of(history.tau) * h);
        island.sums[allowed] += limits::pushed_lever_sq / 2 * island.sums[pushed_at] / body.v_CM[3];
    });
    bool some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        if (island.sums[pushed_at] < 0 || island.sums[0] <= max(island.sums[1], island.sums[allowed])) continue;
        island.beta = scalar(0.5);
        some = true;
    }
    return some;
}

}  // namespace

template <class Whole>
void hold_pushed_figures(Whole& whole, const BodyView& bodies, scalar h) {
    auto& solver = without_rows(whole);
    if (!note_pushes(solver, solver.jointed)) return;
    if constexpr (Whole::has_drives) excuse_driven_from_pushes(solver, solver.jointed, whole.joint_rows);
    if (!find_beyond_allowed(solver, bodies, h)) return;
    give_found_shares(whole, bodies, h,
                      [](const Island& island, const ThreeEnergies& energies) { return energies.share_up_to(island.sums[allowed]); });
}

// The linker takes the one that the scene calls.
template void hold_pushed_figures(JointedView&, const BodyView&, scalar);
template void hold_pushed_figures(LoopedView&, const BodyView&, scalar);
template void hold_pushed_figures(RowedView&, const BodyView&, scalar);
template void hold_pushed_figures(DrivenView&, const BodyView&, scalar);
template void hold_pushed_figures(LoopedRowedView&, const BodyView&, scalar);

} }  // namespace ingot
