// SPDX-License-Identifier: MIT
#include "conjugate_gradients.h"

#include "../../constraint/block_bodies.h"
#include "../../constraint/contact.h"
#include "../../constraint/jointed_view.h"

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

/// The same for the impulses of a row, in the lanes that are live; `whole`: in all.
template <bool whole>
INGOT_INLINE void go_on(LaneRow& j, LaneRow& j_sweep, LaneRow& direction, lane beta, mask live) {
    const lane now = load(j), along = beta * load(direction) + (now - load(j_sweep)), next = now + beta * along;
    store_if<whole>(direction, live, along);
    store_if<whole>(j, live, next);
    store_if<whole>(j_sweep, live, next);
}

template <bool whole, class View>
INGOT_INLINE void extrapolate_visit(const View& solver, const Visit& visit, lane beta) {
    const mask live = lanes_of(visit.lane_bits);
    ContactConstraint<View>::Given::for_rows(solver, visit.block,
                                             [&](const SeenRow& row) { go_on<whole>(row.j, row.j_sweep, row.direction, beta, live); });
}

lane beta_of(const SolverView& solver, const Visit& visit) {
    if (has_one_island(visit)) return splat<lane>(solver.islands[visit.island].beta);
    const ContactBlock& block = solver.blocks[visit.block];
    scalar of_lanes[lanes];
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        of_lanes[lane_i] = block.island[lane_i] == no_island ? 0 : solver.islands[block.island[lane_i]].beta;
    return load(of_lanes);
}

}  // namespace

void begin_sweeps(const SolverView& solver) {
    for_bodies(solver, [&](int body_i) {
        const SolverBody& body = solver.bodies[body_i];
        SolverBodyHistory& history = solver.histories[body_i];
        for (int i = 0; i < 4; ++i) history.v_sweep[i] = body.v_CM[i];
        for (int i = 0; i < 4; ++i) history.L_sweep[i] = body.L[i];
    });
}

template <class View>
void begin_rows_again(const View& solver) {
    for (int block_i = 0; block_i < solver.block_count; ++block_i)  // bound: max_manifolds, rounded up to whole blocks
        ContactConstraint<View>::Given::for_rows(solver, block_i, [](const SeenRow& row) { row.j_sweep = row.j; });
}

template <class View>
void extrapolate(const View& solver) {
    Index island_before = no_island;
    lane beta{};
    for (int visit_i = 0; visit_i < solver.live_count; ++visit_i) {  // bound: max_manifolds: a run has one visit or more
        const Visit visit = solver.live[visit_i];
        if (!has_one_island(visit) || visit.island != island_before) beta = beta_of(solver, visit);
        island_before = visit.island;
        if (is_all(visit.lane_bits))
            extrapolate_visit<true>(solver, visit, beta);
        else
            extrapolate_visit<false>(solver, visit, beta);
    }
    const Island* island = nullptr;
    island_before = no_island;
    for_bodies(solver, [&](int body_i) {
        if (solver.island_of[body_i] != island_before) island = &solver.islands[island_before = solver.island_of[body_i]];
        if (!island->sweeps_on) return;
        if constexpr (View::articulates)
            if (solver.jointed.has_joints(static_cast<Index>(body_i))) return;  // its figure tells it, before each visit
        SolverBody& body = solver.bodies[body_i];
        SolverBodyHistory& history = solver.histories[body_i];
        go_on(body.v_CM, history.v_sweep, history.P_v, island->beta);
        go_on(body.L, history.L_sweep, history.P_L, island->beta);
    });
}

// The linker takes the one that the scene calls. Belts have no impulses of their own.
#define INGOT_VIEW(View)                         \
    template void begin_rows_again(const View&); \
    template void extrapolate(const View&)
INGOT_VIEW(JointedView);
INGOT_VIEW(LoopedView);
INGOT_VIEW(JointedMaterialView);
INGOT_VIEW(LoopedMaterialView);
INGOT_VIEW(SolverView);
INGOT_VIEW(BallView);
INGOT_VIEW(RollingView);
INGOT_VIEW(RollingBeltView);
#undef INGOT_VIEW

} }  // namespace ingot
