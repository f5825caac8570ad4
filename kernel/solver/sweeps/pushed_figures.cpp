// SPDX-License-Identifier: MIT
#include "pushed_figures.h"

#include "figure_shares.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Places in Island::sums, beside three energies. pushed_at: m/s, of the fastest kinematic body that pushes the island; -1: none does.
enum : int { pushed_at = 3, allowed = 4 };

/// J, that a push at v can give a body in a step of h seconds: see pushed_figures.h.
scalar given_by_push(const SolverView& solver, const JointedBodies& jointed, int body_i, scalar v, scalar h) {
    const scalar M = 1 / solver.bodies[body_i].v_CM[3], thrown = 2 * M * v * v;
    if (!jointed.has_joints(static_cast<Index>(body_i))) return thrown;
    const Vector I = at_node(jointed.figures, jointed.node_of[body_i], [](const auto& rows, const auto& at, int row_i) {
        return read(at, rows[row_i].I_body);
    });
    return thrown + limits::pushed_rod * v / h * sqrt(M * (I.x + I.y + I.z));
}

/// Belts give energy: islands on them are no candidates.
template <class View>
void forget_belts(const View& solver) {
    if constexpr (View::has_belts)
        // bound: max_manifolds, rounded up to whole blocks
        for (int position = 0; position < solver.block_count * lanes; ++position) {
            const ContactBlock& block = solver.blocks[position / lanes];
            const int lane_i = position % lanes;
            if (!is_spare(block.manifold[lane_i]) && is_on_belt(solver, position / lanes, lane_i))
                solver.islands[block.island[lane_i]].sums[pushed_at] = -1;
        }
}

/// Whether some island with joints touches a kinematic body.
bool note_pushes(const SolverView& solver, const JointedBodies& jointed) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i) solver.islands[island_i].sums[pushed_at] = -1;  // bound: max_bodies
    bool some = false;
    // bound: max_manifolds, rounded up to whole blocks
    for (int position = 0; position < solver.block_count * lanes; ++position) {
        const ContactBlock& block = solver.blocks[position / lanes];
        const int lane_i = position % lanes, last = solver.body_count - 1;
        if (is_spare(block.manifold[lane_i])) continue;
        const Index kinematic = block.body_A[lane_i] > last ? block.body_A[lane_i] : block.body_B[lane_i];
        Island& island = solver.islands[block.island[lane_i]];
        if (kinematic <= last || !island.in_batch || jointed.doublings_of[block.island[lane_i]] == 0) continue;
        island.sums[pushed_at] = max(island.sums[pushed_at], sqrt(length_sq(three_of(solver.bodies[kinematic].v_CM))));
        some = true;
    }
    return some;
}

/// Those that have more than they may, by what their bodies would have alone, are candidates. What they may have is in sums[allowed].
bool find_beyond_allowed(const SolverView& solver, const JointedBodies& jointed, const BodyView& bodies, scalar h) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i)  // bound: max_bodies
        solver.islands[island_i].sums[0] = solver.islands[island_i].sums[1] = solver.islands[island_i].sums[allowed] = 0;
    for_bodies(solver, [&](int body_i) {
        Island& island = solver.islands[solver.island_of[body_i]];
        if (island.sums[pushed_at] < 0) return;
        const SolverBody& body = solver.bodies[body_i];
        island.sums[0] += energy_of(solver, bodies, body_i, three_of(body.v_CM), three_of(body.L));
        island.sums[1] += energy_alone(solver, bodies, body_i, h);
        island.sums[allowed] += given_by_push(solver, jointed, body_i, island.sums[pushed_at], jointed.figures.h);
    });
    bool some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        island.beta = 1;
        if (island.sums[pushed_at] < 0) continue;
        island.sums[allowed] = max(island.sums[1], island.sums[allowed]);
        if (island.sums[0] <= island.sums[allowed]) continue;
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
    forget_belts(solver);
    // The second takes back what roundings of the first leave, where impulses had grown to millions of times what they should be.
    for (int round = 0; round < 2 && find_beyond_allowed(solver, solver.jointed, bodies, h); ++round)
        give_found_shares<WorkFrom::alone>(whole, bodies, h, [](const Island& island, const ThreeEnergies& energies) {
            return energies.share_up_to(island.sums[allowed]);
        });
}

#define INGOT_VIEW(View) template void hold_pushed_figures(View&, const BodyView&, scalar)
INGOT_JOINTED_VIEWS(INGOT_VIEW);
#undef INGOT_VIEW

} }  // namespace ingot
