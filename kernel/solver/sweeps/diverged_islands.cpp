// SPDX-License-Identifier: MIT
#include "diverged_islands.h"

#include "../../base/limits.h"
#include "../../constraint/contact.h"
#include "../../constraint/jointed_view.h"
#include "../../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Marked by beta, which sweeps to come set anew.
bool has_diverged(const Island& island) { return island.beta > 0; }
const Island& island_of(const SolverView& solver, int body_i) { return solver.islands[solver.island_of[body_i]]; }

/// A speed of the centre of mass and one of a spin with as much energy, m/s.
class Speeds {
public:
    Speeds(const SolverView& solver, const BodyView& bodies, int body_i) : solver_(solver), body_i_(body_i) {
        const Place at = place_of(solver.slot_of[body_i]);
        inv_I_world_ = lane_of(bodies.translation[at.tile].inv_I_world, at.lane);
    }
    scalar now() const { return of(three_of(body().v_CM), three_of(body().L)); }
    scalar without_contacts(scalar h) const {
        const SolverBodyHistory& history = solver_.histories[body_i_];
        return of(three_of(history.v_begin) + three_of(history.a) * h, three_of(history.L_begin) + three_of(history.tau) * h);
    }

private:
    const SolverBody& body() const { return solver_.bodies[body_i_]; }
    scalar of(const Vector& v, const Vector& L) const { return sqrt(length_sq(v)) + sqrt(max(dot(L, inv_I_world_ * L) * body().v_CM[3], 0)); }

    const SolverView& solver_;
    int body_i_;
    SymmetricMatrix inv_I_world_;
};

/// Of each island the greatest mass and the greatest inverse mass, in size and size_before; those that hang on kinematic bodies are no candidates.
bool find_crushing(const SolverView& solver) {
    bool some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        const bool is_candidate = island.in_batch && island.at_bound && island.residual > limits::gaining_residual * solver.unit;
        island.beta = is_candidate ? scalar(1) : scalar(0);
        island.size = island.size_before = 0;
        some = some || is_candidate;
    }
    if (!some) return false;
    for_bodies(solver, [&](int body_i) {
        Island& island = solver.islands[solver.island_of[body_i]];
        const scalar inv_M = solver.bodies[body_i].v_CM[3];
        island.size = max(island.size, 1 / inv_M);
        island.size_before = max(island.size_before, inv_M);
    });
    some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {
        Island& island = solver.islands[island_i];
        if (!(island.size * island.size_before > limits::crushing_ratio)) island.beta = 0;
        some = some || has_diverged(island);
    }
    // bound: max_manifolds, rounded up to whole blocks
    for (int position = 0; some && position < solver.block_count * lanes; ++position) {
        const ContactBlock& block = solver.blocks[position / lanes];
        const int lane_i = position % lanes, last = solver.body_count - 1;
        if (!is_spare(block.manifold[lane_i]) && (block.body_A[lane_i] > last || block.body_B[lane_i] > last))
            solver.islands[block.island[lane_i]].beta = 0;
    }
    return some;
}

/// How fast the fastest of heavy bodies would be without contacts, in size_before. Heavy: as uneven contacts are.
bool find_diverged(const SolverView& solver, const BodyView& bodies, scalar h) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        solver.islands[island_i].size_before = 0;
        solver.islands[island_i].size = 0;
    }
    for_bodies(solver, [&](int body_i) {  // the greatest mass
        Island& island = solver.islands[solver.island_of[body_i]];
        if (has_diverged(island)) island.size = max(island.size, 1 / solver.bodies[body_i].v_CM[3]);
    });
    for_bodies(solver, [&](int body_i) {
        Island& island = solver.islands[solver.island_of[body_i]];
        if (!has_diverged(island) || island.size * solver.bodies[body_i].v_CM[3] > limits::heavy_ratio) return;
        island.size_before = max(island.size_before, Speeds(solver, bodies, body_i).without_contacts(h));
    });
    bool some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {
        Island& island = solver.islands[island_i];
        if (island.residual <= limits::crushing_share * island.size_before) island.beta = 0;
        some = some || has_diverged(island);
    }
    return some;
}

}  // namespace

template <class View>
void hold_diverged_islands(const View& solver, const BodyView& bodies, scalar h) {
    if (!find_crushing(solver) || !find_diverged(solver, bodies, h)) return;
    for_bodies(solver, [&](int body_i) {
        const Island& island = island_of(solver, body_i);
        if (!has_diverged(island)) return;
        SolverBody& body = solver.bodies[body_i];
        const Speeds speeds(solver, bodies, body_i);
        const scalar now = speeds.now(), most = max(island.size_before, speeds.without_contacts(h));
        if (now <= most) return;
        const scalar share = most / now;
        for (int i = 0; i < 3; ++i) body.v_CM[i] *= share;
        for (int i = 0; i < 3; ++i) body.L[i] *= share;
    });
    // bound: max_manifolds, rounded up to whole blocks
    for (int position = 0; position < solver.block_count * lanes; ++position) {
        const ContactBlock& block = solver.blocks[position / lanes];
        const int lane_i = position % lanes;
        if (is_spare(block.manifold[lane_i]) || !has_diverged(solver.islands[block.island[lane_i]])) continue;
        ContactConstraint<View>::Given::for_rows(solver, position / lanes, [lane_i](const SeenRow& row) { row.j[lane_i] = 0; });
    }
}

// The linker takes the one that the scene calls. Belts give speed.
template void hold_diverged_islands(const JointedView&, const BodyView&, scalar);
template void hold_diverged_islands(const LoopedView&, const BodyView&, scalar);
template void hold_diverged_islands(const SolverView&, const BodyView&, scalar);
template void hold_diverged_islands(const BallView&, const BodyView&, scalar);
template void hold_diverged_islands(const RollingView&, const BodyView&, scalar);
template void hold_diverged_islands(const RollingBeltView&, const BodyView&, scalar);  // which stand still

} }  // namespace ingot
