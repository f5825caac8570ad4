// SPDX-License-Identifier: MIT
#include "order_manifolds.h"

#include "../../base/limits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

uint16_t local_A(const SolverView& solver, int manifold_i) { return solver.local_of[solver.pairs[manifold_i].body_A]; }
uint16_t local_B(const SolverView& solver, int manifold_i) { return solver.local_of[solver.pairs[manifold_i].body_B]; }

/// Makes the levels of a manifold's bodies differ by at most one; true if that changed one.
bool relax(SolverView& solver, int manifold_i) {
    uint16_t& A = solver.level_of_body[local_A(solver, manifold_i)];
    uint16_t& B = solver.level_of_body[local_B(solver, manifold_i)];
    if (A != unreached_level && A + 1 < B) {
        B = static_cast<uint16_t>(A + 1);
        return true;
    }
    if (B != unreached_level && B + 1 < A) {
        A = static_cast<uint16_t>(B + 1);
        return true;
    }
    return false;
}

/// Distances from the ground, by passes forward and backward over the manifolds; what hangs free of it is level 0 with the ground.
void find_levels(SolverView& solver) {
    // bound: max_bodies + 1
    for (int body_i = 0; body_i < solver.body_count; ++body_i) solver.level_of_body[body_i] = unreached_level;
    solver.level_of_body[0] = 0;
    bool changed = true;
    for (int pass_i = 0; pass_i < limits::level_passes_max && changed; ++pass_i) {
        changed = false;
        // bound: max_manifolds
        for (int step_i = 0; step_i < solver.manifold_count; ++step_i)
            changed = relax(solver, pass_i % 2 == 0 ? step_i : solver.manifold_count - 1 - step_i) || changed;
    }
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {
        const uint16_t A = solver.level_of_body[local_A(solver, manifold_i)], B = solver.level_of_body[local_B(solver, manifold_i)];
        const uint16_t level = A < B ? A : B;
        solver.level[manifold_i] = level == unreached_level ? 0 : level;
    }
}

/// Stable, by counting: levels are fewer than bodies, so the bodies' array of colours serves as counters before it holds colours.
void sort_by_level(SolverView& solver) {
    uint32_t* const first = solver.colours_of_body;
    for (int level_i = 0; level_i < solver.body_count; ++level_i) first[level_i] = 0;
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) ++first[solver.level[manifold_i]];
    uint32_t sum = 0;
    for (int level_i = 0; level_i < solver.body_count; ++level_i) {
        const uint32_t count = first[level_i];
        first[level_i] = sum;
        sum += count;
    }
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i)
        solver.other_order[first[solver.level[manifold_i]]++] = static_cast<uint16_t>(manifold_i);
}

constexpr int colours = 32;

int lowest_free(uint32_t used) {
    for (int colour = 0; colour < colours; ++colour)
        if ((used >> colour & 1u) == 0) return colour;
    return colours;
}

/// Lets the next colour begin in a block of its own, if room is left for all manifolds that are still to come: `lanes` manifolds to a visit then,
/// and none that shares its block with another colour. The order of the manifolds is the same either way.
void begin_block(SolverView& solver, int still_to_come) {
    const int pad = (lanes - solver.lane_count % lanes) % lanes;
    if (solver.lane_count + pad + still_to_come > solver.lane_capacity) return;
    for (int lane_i = 0; lane_i < pad; ++lane_i) solver.order[solver.lane_count++] = no_manifold;  // bound: lanes - 1
}

/// Adds manifolds from_order[0 .. count), which share no body that can move, to the blocks.
void add_visits(SolverView& solver, const uint16_t* from_order, int count) {
    // bound: max_manifolds: the loop in it takes one or more: a block has room for one
    for (int i = 0; i < count;) {
        const int block = solver.lane_count / lanes, first_lane = solver.lane_count % lanes;
        const int room = lanes - first_lane, taken = count - i < room ? count - i : room;
        const unsigned bits = ((1u << taken) - 1u) << first_lane;
        solver.visits[solver.visit_count++] = {static_cast<uint16_t>(block), static_cast<uint16_t>(bits), static_cast<uint16_t>(i)};
        // bound: lanes: taken is at most the room of a block
        for (int end = i + taken; i < end; ++i) solver.order[solver.lane_count++] = from_order[i];
    }
}

/// Colours the manifolds other_order[begin .. end) of one level and writes them to order[] colour by colour.
void color_level(SolverView& solver, int begin, int end) {
    uint16_t count[colours + 1] = {};
    // bound: max_manifolds: part of other_order
    for (int i = begin; i < end; ++i) {
        solver.colours_of_body[local_A(solver, solver.other_order[i])] = 0;
        solver.colours_of_body[local_B(solver, solver.other_order[i])] = 0;
    }
    for (int i = begin; i < end; ++i) {
        const uint16_t manifold_i = solver.other_order[i];
        const uint16_t A = local_A(solver, manifold_i), B = local_B(solver, manifold_i);
        const int colour = lowest_free((A != 0 ? solver.colours_of_body[A] : 0) | (B != 0 ? solver.colours_of_body[B] : 0));
        if (colour < colours) {
            solver.colours_of_body[A] |= 1u << colour;
            solver.colours_of_body[B] |= 1u << colour;
        }
        solver.level[manifold_i] = static_cast<uint16_t>(colour);  // its level is known from its place by now
        ++count[colour];
    }
    int place[colours + 1], sum = begin;
    for (int colour = 0; colour <= colours; ++colour) {
        place[colour] = sum;
        sum += count[colour];
    }
    uint16_t* const by_colour = solver.level_order;
    for (int i = begin; i < end; ++i) {
        const uint16_t manifold_i = solver.other_order[i];
        by_colour[place[solver.level[manifold_i]]++] = manifold_i;
    }
    int position = begin;
    for (int colour = 0; colour < colours; ++colour) {
        if (count[colour] == 0) continue;
        begin_block(solver, solver.manifold_count - position);
        add_visits(solver, by_colour + position, count[colour]);
        position += count[colour];
    }
    // bound: max_manifolds: ++position
    for (; position < end; ++position) add_visits(solver, by_colour + position, 1);  // a body with more: one at a time
}

/// A visit with all lanes stores whole vectors: the lanes of a block that hold no manifold join the only visit it has. They write the zeros
/// of the body that cannot move.
void take_spare_lanes_along(SolverView& solver) {
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {  // bound: max_manifolds
        Visit& visit = solver.visits[visit_i];
        unsigned spare = 0;
        for (int lane_i = 0; lane_i < lanes; ++lane_i)
            if (solver.order[visit.block * lanes + lane_i] == no_manifold) spare |= 1u << lane_i;
        if ((visit.lane_bits | spare) == all_lanes) visit.lane_bits = all_lanes;
    }
}

}  // namespace

void order_manifolds(SolverView& solver) {
    find_levels(solver);
    sort_by_level(solver);
    solver.visit_count = 0;
    solver.lane_count = 0;
    solver.level_count = 0;
    int begin = 0;
    // bound: max_manifolds: begin becomes end, which is after it
    while (begin < solver.manifold_count) {
        const uint16_t level = solver.level[solver.other_order[begin]];
        int end = begin + 1;
        // bound: max_manifolds: ++end
        while (end < solver.manifold_count && solver.level[solver.other_order[end]] == level) ++end;
        solver.level_count = level + 1;
        color_level(solver, begin, end);
        begin = end;
    }
    // bound: lanes - 1: lane_count grows by one
    while (solver.lane_count % lanes != 0) solver.order[solver.lane_count++] = no_manifold;
    solver.block_count = solver.lane_count / lanes;
    take_spare_lanes_along(solver);
}

} }  // namespace ingot
