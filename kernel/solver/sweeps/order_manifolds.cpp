// SPDX-License-Identifier: MIT
#include "order_manifolds.h"

#include "../../base/limits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

Index local_A(const SolverView& solver, int manifold_i) { return solver.local_of[solver.pairs[manifold_i].body_A]; }
Index local_B(const SolverView& solver, int manifold_i) { return solver.local_of[solver.pairs[manifold_i].body_B]; }

/// Makes the levels of a manifold's bodies differ by at most one; true if that changed one.
bool relax(const SolverView& solver, int manifold_i) {
    Index& A = solver.level_of_body[local_A(solver, manifold_i)];
    Index& B = solver.level_of_body[local_B(solver, manifold_i)];
    if (A != unreached_level && A + 1 < B) {
        B = static_cast<Index>(A + 1);
        return true;
    }
    if (B != unreached_level && B + 1 < A) {
        A = static_cast<Index>(B + 1);
        return true;
    }
    return false;
}

bool is_in_batch(const SolverView& solver, int manifold_i) {
    const Index island_i = solver.island_at[manifold_i];
    return island_i != no_island && solver.islands[island_i].in_batch;
}

/// The manifolds of the batch from the ground up; returns how many. Stable, by counting: levels are fewer than bodies, so the bodies' array
/// of colours serves as counters before it holds colours.
int sort_by_level(const SolverView& solver) {
    uint32_t* const first = solver.colours_of_body;
    for (int level_i = 0; level_i < solver.body_count; ++level_i) first[level_i] = 0;  // bound: max_bodies + 1
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i)  // bound: max_manifolds
        if (is_in_batch(solver, manifold_i)) ++first[solver.level[manifold_i]];
    uint32_t sum = 0;
    for (int level_i = 0; level_i < solver.body_count; ++level_i) {
        const uint32_t count = first[level_i];
        first[level_i] = sum;
        sum += count;
    }
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i)
        if (is_in_batch(solver, manifold_i)) solver.sorted[first[solver.level[manifold_i]]++] = static_cast<Index>(manifold_i);
    return static_cast<int>(sum);
}

constexpr int colours = 32;

int lowest_free(uint32_t used) {
    for (int colour = 0; colour < colours; ++colour)
        if ((used >> colour & 1u) == 0) return colour;
    return colours;
}

void add_spare_lane(SolverView& solver) {
    const int position = solver.lane_count++, lane_i = position % lanes;
    ContactBlock& block = solver.blocks[position / lanes];
    block.manifold[lane_i] = no_manifold;
    block.island[lane_i] = no_island;
    block.sum_i[lane_i] = 0;
}

/// Begins a new block for the next colour, if room is left for all manifolds that are still to come. No block then holds two colours, and a visit
/// solves `lanes` manifolds. The order of the manifolds is the same either way.
void begin_block(SolverView& solver, int still_to_come) {
    const int pad = (lanes - solver.lane_count % lanes) % lanes;
    if (solver.lane_count + pad + still_to_come > solver.lane_capacity) return;
    for (int lane_i = 0; lane_i < pad; ++lane_i) add_spare_lane(solver);  // bound: lanes - 1
}

/// A manifold takes a lane. The k-th of an island and a colour is added to the k mod 8-th of the island's sums.
void take_lane(const SolverView& solver, ContactBlock& block, int lane_i, Index manifold_i, Index group) {
    const Index island_i = solver.island_at[manifold_i];
    Island& island = solver.islands[island_i];
    const unsigned k = island.group == group ? static_cast<unsigned>(island.in_group) : 0;
    island.group = group;
    island.in_group = static_cast<Index>(k + 1);
    block.manifold[lane_i] = manifold_i;
    block.island[lane_i] = island_i;
    block.sum_i[lane_i] = static_cast<uint8_t>(k % Island::sum_count);
}

/// Adds manifolds [0 .. count), which share no body that can move, to the blocks. Groups are numbered from 1 on.
void add_visits(SolverView& solver, const Index* manifolds, int count, Index& group) {
    ++group;
    for (int i = 0; i < count;) {  // bound: max_manifolds: taken is 1 or more, for a block has room for one
        const int block_i = solver.lane_count / lanes, first_lane = solver.lane_count % lanes;
        const int room = lanes - first_lane, taken = count - i < room ? count - i : room;
        const unsigned bits = ((1u << taken) - 1u) << first_lane;
        solver.visits[solver.visit_count++] = {static_cast<Index>(block_i), static_cast<uint16_t>(bits), no_island};
        ContactBlock& block = solver.blocks[block_i];
        for (int k = 0; k < taken; ++k) take_lane(solver, block, first_lane + k, manifolds[i + k], group);  // bound: lanes
        solver.lane_count += taken;
        i += taken;
    }
}

/// Colours the manifolds sorted[begin .. end) of one level and adds them colour by colour.
void color_level(SolverView& solver, int begin, int end, int batch_count, Index& group) {
    Index count[colours + 1] = {};
    for (int i = begin; i < end; ++i) {  // bound: max_manifolds: part of sorted
        solver.colours_of_body[local_A(solver, solver.sorted[i])] = 0;
        solver.colours_of_body[local_B(solver, solver.sorted[i])] = 0;
    }
    for (int i = begin; i < end; ++i) {
        const Index manifold_i = solver.sorted[i];
        const Index A = local_A(solver, manifold_i), B = local_B(solver, manifold_i);
        const int colour = lowest_free((A != 0 ? solver.colours_of_body[A] : 0) | (B != 0 ? solver.colours_of_body[B] : 0));
        if (colour < colours) {
            solver.colours_of_body[A] |= 1u << colour;
            solver.colours_of_body[B] |= 1u << colour;
        }
        solver.colour[manifold_i] = static_cast<uint8_t>(colour);
        ++count[colour];
    }
    int place[colours + 1], sum = begin;
    for (int colour = 0; colour <= colours; ++colour) {
        place[colour] = sum;
        sum += count[colour];
    }
    Index* const by_colour = solver.members;  // not listed yet
    for (int i = begin; i < end; ++i) {
        const Index manifold_i = solver.sorted[i];
        by_colour[place[solver.colour[manifold_i]]++] = manifold_i;
    }
    int position = begin;
    for (int colour = 0; colour < colours; ++colour) {
        if (count[colour] == 0) continue;
        begin_block(solver, batch_count - position);
        add_visits(solver, by_colour + position, count[colour], group);
        position += count[colour];
    }
    // bound: max_manifolds: part of sorted
    for (; position < end; ++position) add_visits(solver, by_colour + position, 1, group);  // a body with more: one at a time
}

/// Lanes without a manifold join the only visit of their block, because a visit with all lanes stores whole vectors. They write the zeros of the body
/// that cannot move.
void take_spare_lanes_along(SolverView& solver, Visit& visit) {
    const ContactBlock& block = solver.blocks[visit.block];
    unsigned spare = 0;
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        if (block.manifold[lane_i] == no_manifold) spare |= 1u << lane_i;
    if ((visit.lane_bits | spare) == all_lanes) visit.lane_bits = all_lanes;
}

/// Tells whether a visit can be summed as one vector.
void name_island(const SolverView& solver, Visit& visit) {
    const ContactBlock& block = solver.blocks[visit.block];
    if (visit.lane_bits != all_lanes || block.sum_i[0] % lanes != 0) return;
    for (int lane_i = 1; lane_i < lanes; ++lane_i)
        if (block.island[lane_i] != block.island[0] && block.island[lane_i] != no_island) return;
    visit.island = block.island[0];
}

}  // namespace

void find_levels(const SolverView& solver) {
    for (int body_i = 0; body_i < solver.body_count; ++body_i) solver.level_of_body[body_i] = unreached_level;
    solver.level_of_body[0] = 0;
    bool changed = true;
    for (int pass_i = 0; pass_i < limits::level_passes_max && changed; ++pass_i) {
        changed = false;
        for (int step_i = 0; step_i < solver.manifold_count; ++step_i)
            changed = relax(solver, pass_i % 2 == 0 ? step_i : solver.manifold_count - 1 - step_i) || changed;
    }
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {
        const Index A = solver.level_of_body[local_A(solver, manifold_i)], B = solver.level_of_body[local_B(solver, manifold_i)];
        const Index level = A < B ? A : B;
        solver.level[manifold_i] = level == unreached_level ? Index(0) : level;
    }
}

void order_manifolds(SolverView& solver) {
    const int batch_count = sort_by_level(solver);
    solver.visit_count = 0;
    solver.lane_count = 0;
    Index group = 0;
    int begin = 0;
    while (begin < batch_count) {  // bound: max_manifolds: begin becomes end, which is after it
        const Index level = solver.level[solver.sorted[begin]];
        int end = begin + 1;
        while (end < batch_count && solver.level[solver.sorted[end]] == level) ++end;  // bound: max_manifolds: ++end
        color_level(solver, begin, end, batch_count, group);
        begin = end;
    }
    while (solver.lane_count % lanes != 0) add_spare_lane(solver);  // bound: max_manifolds, rounded up to whole blocks
    solver.block_count = solver.lane_count / lanes;
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {  // bound: max_manifolds
        take_spare_lanes_along(solver, solver.visits[visit_i]);
        name_island(solver, solver.visits[visit_i]);
    }
}

void list_members(const SolverView& solver) {
    Index sum = 0;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        if (!island.in_batch) continue;
        island.member_begin = sum;
        island.member_count = 0;
        sum = static_cast<Index>(sum + island.manifold_count);
    }
    for (int position = 0; position < solver.lane_count; ++position) {  // bound: max_manifolds, rounded up to whole blocks
        const Index island_i = solver.blocks[position / lanes].island[position % lanes];
        if (island_i == no_island) continue;
        Island& island = solver.islands[island_i];
        solver.members[island.member_begin + island.member_count++] = static_cast<Index>(position);
    }
}

} }  // namespace ingot
