// SPDX-License-Identifier: MIT
#include "order_manifolds.h"

#include "../../base/limits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// The solver bodies of a manifold; of a figure the one that stands for all of it.
struct LocalPair {
    Index A, B;
};
template <class Joints>
LocalPair locals_of(const SolverView& solver, const Joints& jointed, int manifold_i) {
    const BodyPair& pair = solver.pairs[manifold_i];
    return {leader_of(jointed, solver.local_of[pair.body_A]), leader_of(jointed, solver.local_of[pair.body_B])};
}

/// Makes the levels of a manifold's bodies differ by at most one; true if that changed one.
template <class Joints>
bool relax(const SolverView& solver, const Joints& jointed, int manifold_i) {
    const LocalPair pair = locals_of(solver, jointed, manifold_i);
    Index& A = solver.level_of_body[pair.A];
    Index& B = solver.level_of_body[pair.B];
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

int lowest_free(uint32_t used) {
    for (int colour = 0; colour < contact_colours; ++colour)
        if ((used >> colour & 1u) == 0) return colour;
    return contact_colours;
}

/// Where the manifolds of free bodies go: block after block.
struct FreeLanes {
    SolverView& solver;

    int& count() const { return solver.lane_count; }
    int taken() const { return solver.lane_count; }
    int capacity() const { return solver.lane_capacity; }
    Index block_of(int position) const { return static_cast<Index>(position / lanes); }
};
/// And those of bodies with joints: from the end of the room, block before block.
struct JointedLanes {
    SolverView& solver;
    JointedBodies& jointed;

    int& count() const { return jointed.lane_count; }
    int taken() const { return solver.lane_count + jointed.lane_count; }
    int capacity() const { return solver.lane_capacity - lanes; }  // each kind may leave a part of its last block
    Index block_of(int position) const { return static_cast<Index>(solver.lane_capacity / lanes - 1 - position / lanes); }
};
/// Free ones where there are others too.
struct FreeLanesBeside : FreeLanes {
    JointedBodies& jointed;

    int taken() const { return solver.lane_count + jointed.lane_count; }
    int capacity() const { return solver.lane_capacity - lanes; }
};

template <class Lanes>
void add_spare_lane(const Lanes& to) {
    const int position = to.count()++, lane_i = position % lanes;
    ContactBlock& block = to.solver.blocks[to.block_of(position)];
    block.manifold[lane_i] = no_manifold;
    block.island[lane_i] = no_island;
    block.sum_i[lane_i] = 0;
}
template <class Lanes>
void fill_block(const Lanes& to) {
    while (to.count() % lanes != 0) add_spare_lane(to);  // bound: lanes
}

/// Begins a new block for the next colour, if room is left for all manifolds that are still to come. No block then holds two colours, and a visit
/// solves `lanes` manifolds. The order of the manifolds is the same either way.
template <class Lanes>
void begin_block(const Lanes& to, int still_to_come) {
    const int pad = (lanes - to.count() % lanes) % lanes;
    if (to.taken() + pad + still_to_come > to.capacity()) return;
    for (int lane_i = 0; lane_i < pad; ++lane_i) add_spare_lane(to);  // bound: lanes - 1
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
template <class Lanes>
void add_visits(const Lanes& to, const Index* manifolds, int count, Index& group) {
    SolverView& solver = to.solver;
    ++group;
    for (int i = 0; i < count;) {  // bound: max_manifolds: taken is 1 or more, for a block has room for one
        const Index block_i = to.block_of(to.count());
        const int first_lane = to.count() % lanes;
        const int room = lanes - first_lane, taken = count - i < room ? count - i : room;
        const unsigned bits = ((1u << taken) - 1u) << first_lane;
        solver.visits[solver.visit_count++] = {block_i, static_cast<uint16_t>(bits), no_island};
        ContactBlock& block = solver.blocks[block_i];
        for (int k = 0; k < taken; ++k) take_lane(solver, block, first_lane + k, manifolds[i + k], group);  // bound: lanes
        to.count() += taken;
        i += taken;
    }
}

/// Those of one colour. still_to_come: manifolds, with these, that need room; 0: no new block is begun.
void add_color(SolverView& solver, NoJointedBodies&, Index* manifolds, int count, int still_to_come, Index& group) {
    const FreeLanes to{solver};
    if (still_to_come > 0) begin_block(to, still_to_come);
    add_visits(to, manifolds, count, group);
}

bool has_jointed_body(const SolverView& solver, const JointedBodies& jointed, Index manifold_i) {
    const BodyPair& pair = solver.pairs[manifold_i];
    const Index A = solver.local_of[pair.body_A], B = solver.local_of[pair.body_B];
    return (A != 0 && jointed.has_joints(A)) || (B != 0 && jointed.has_joints(B));
}
/// The free ones first; returns how many there are. Stable.
int part_free(const SolverView& solver, const JointedBodies& jointed, Index* manifolds, int count) {
    int free = 0;
    for (int i = 0; i < count; ++i)  // bound: max_manifolds
        if (!has_jointed_body(solver, jointed, manifolds[i])) jointed.parted[free++] = manifolds[i];
    int next = free;
    for (int i = 0; i < count; ++i)
        if (has_jointed_body(solver, jointed, manifolds[i])) jointed.parted[next++] = manifolds[i];
    for (int i = 0; i < count; ++i) manifolds[i] = jointed.parted[i];
    return free;
}
void add_color(SolverView& solver, JointedBodies& jointed, Index* manifolds, int count, int still_to_come, Index& group) {
    const int free = part_free(solver, jointed, manifolds, count);
    const FreeLanesBeside free_lanes{{solver}, jointed};
    const JointedLanes jointed_lanes{solver, jointed};
    if (free > 0 && still_to_come > 0) begin_block(free_lanes, still_to_come);
    if (free > 0) add_visits(free_lanes, manifolds, free, group);
    if (free < count && still_to_come > 0) begin_block(jointed_lanes, still_to_come - free);
    if (free < count) add_visits(jointed_lanes, manifolds + free, count - free, group);
}

/// Gives the manifolds sorted[begin .. end) of one level their colours, and counts those of each.
template <class Joints>
void color_level(const SolverView& solver, const Joints& jointed, int begin, int end, Index (&count)[contact_colours + 1]) {
    for (int i = begin; i < end; ++i) {  // bound: max_manifolds: part of sorted
        const LocalPair pair = locals_of(solver, jointed, solver.sorted[i]);
        solver.colours_of_body[pair.A] = 0;
        solver.colours_of_body[pair.B] = 0;
    }
    for (int i = begin; i < end; ++i) {
        const Index manifold_i = solver.sorted[i];
        const auto [A, B] = locals_of(solver, jointed, manifold_i);
        const int colour = lowest_free((A != 0 ? solver.colours_of_body[A] : 0) | (B != 0 ? solver.colours_of_body[B] : 0));
        if (colour < contact_colours) {
            solver.colours_of_body[A] |= 1u << colour;
            solver.colours_of_body[B] |= 1u << colour;
        }
        solver.colour[manifold_i] = static_cast<uint8_t>(colour);
        ++count[colour];
    }
}

/// Adds the manifolds sorted[begin .. end) of one level colour by colour.
template <class Joints>
void add_level(SolverView& solver, Joints& jointed, int begin, int end, int batch_count, Index& group) {
    Index count[contact_colours + 1] = {};
    color_level(solver, jointed, begin, end, count);
    int place[contact_colours + 1], sum = begin;
    for (int colour = 0; colour <= contact_colours; ++colour) {
        place[colour] = sum;
        sum += count[colour];
    }
    Index* const by_colour = solver.members;  // not listed yet
    for (int i = begin; i < end; ++i) {
        const Index manifold_i = solver.sorted[i];
        by_colour[place[solver.colour[manifold_i]]++] = manifold_i;
    }
    int position = begin;
    for (int colour = 0; colour < contact_colours; ++colour) {
        if (count[colour] == 0) continue;
        add_color(solver, jointed, by_colour + position, count[colour], batch_count - position, group);
        position += count[colour];
    }
    // bound: max_manifolds: part of sorted
    for (; position < end; ++position) add_color(solver, jointed, by_colour + position, 1, 0, group);  // a body with more: one at a time
}

/// Lanes without a manifold join the only visit of their block, because a visit with all lanes stores whole vectors. Their bodies are the one that
/// cannot move.
void take_spare_lanes_along(SolverView& solver, Visit& visit) {
    const ContactBlock& block = solver.blocks[visit.block];
    unsigned spare = 0;
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        if (is_spare(block.manifold[lane_i])) spare |= 1u << lane_i;
    if ((visit.lane_bits | spare) == all_lanes) visit.lane_bits = all_lanes;
}

/// Tells whether a visit can be summed as one vector.
void name_island(const SolverView& solver, Visit& visit) {
    const ContactBlock& block = solver.blocks[visit.block];
    if (lanes > 1 && (visit.lane_bits != all_lanes || block.sum_i[0] % lanes != 0)) return;
    for (int lane_i = 1; lane_i < lanes; ++lane_i)
        if (block.island[lane_i] != block.island[0] && block.island[lane_i] != no_island) return;
    visit.island = block.island[0];
}

void begin_jointed(NoJointedBodies&) {}
void begin_jointed(JointedBodies& jointed) { jointed.lane_count = 0; }

void swap_lists(ContactBlock& a, ContactBlock& b) {
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        const Index manifold = a.manifold[lane_i], island = a.island[lane_i];
        const uint8_t sum_i = a.sum_i[lane_i];
        a.manifold[lane_i] = b.manifold[lane_i];
        a.island[lane_i] = b.island[lane_i];
        a.sum_i[lane_i] = b.sum_i[lane_i];
        b.manifold[lane_i] = manifold;
        b.island[lane_i] = island;
        b.sum_i[lane_i] = sum_i;
    }
}

/// Blocks of bodies with joints come behind the others, in the order in which they were filled.
void move_jointed_behind(SolverView&, NoJointedBodies&) {}
void move_jointed_behind(SolverView& solver, JointedBodies& jointed) {
    fill_block(JointedLanes{solver, jointed});
    const int room = solver.lane_capacity / lanes, count = jointed.lane_count / lanes, shift = room - count - solver.block_count;
    jointed.first_block = solver.block_count;
    for (int a = room - count, b = room - 1; a < b; ++a, --b) swap_lists(solver.blocks[a], solver.blocks[b]);  // bound: max_manifolds
    for (int block_i = jointed.first_block; block_i < jointed.first_block + count && shift > 0; ++block_i)  // bound: max_manifolds
        swap_lists(solver.blocks[block_i], solver.blocks[block_i + shift]);
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {
        Visit& visit = solver.visits[visit_i];
        if (visit.block >= jointed.first_block) visit.block = static_cast<Index>(jointed.first_block + (room - 1 - visit.block));
    }
    solver.block_count += count;
    solver.lane_count = solver.block_count * lanes;
}

}  // namespace

template <class Joints>
void find_levels(const SolverView& solver, const Joints& jointed) {
    for (int body_i = 0; body_i < solver.body_count; ++body_i) solver.level_of_body[body_i] = unreached_level;
    solver.level_of_body[0] = 0;
    bool changed = true;
    for (int pass_i = 0; pass_i < limits::level_passes_max && changed; ++pass_i) {
        changed = false;
        for (int step_i = 0; step_i < solver.manifold_count; ++step_i)
            changed = relax(solver, jointed, pass_i % 2 == 0 ? step_i : solver.manifold_count - 1 - step_i) || changed;
    }
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {
        const LocalPair pair = locals_of(solver, jointed, manifold_i);
        const Index A = solver.level_of_body[pair.A], B = solver.level_of_body[pair.B];
        const Index level = A < B ? A : B;
        solver.level[manifold_i] = level == unreached_level ? Index(0) : level;
    }
}

template <class Joints>
void order_manifolds(SolverView& solver, Joints& jointed) {
    const int batch_count = sort_by_level(solver);
    begin_jointed(jointed);
    solver.visit_count = 0;
    solver.lane_count = 0;
    Index group = 0;
    int begin = 0;
    while (begin < batch_count) {  // bound: max_manifolds: begin becomes end, which is after it
        const Index level = solver.level[solver.sorted[begin]];
        int end = begin + 1;
        while (end < batch_count && solver.level[solver.sorted[end]] == level) ++end;  // bound: max_manifolds: ++end
        add_level(solver, jointed, begin, end, batch_count, group);
        begin = end;
    }
    fill_block(FreeLanes{solver});
    solver.block_count = solver.lane_count / lanes;
    move_jointed_behind(solver, jointed);
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {  // bound: max_manifolds
        take_spare_lanes_along(solver, solver.visits[visit_i]);
        name_island(solver, solver.visits[visit_i]);
    }
}

// The linker takes the one that the scene calls.
template void find_levels(const SolverView&, const NoJointedBodies&);
template void find_levels(const SolverView&, const JointedBodies&);
template void order_manifolds(SolverView&, NoJointedBodies&);
template void order_manifolds(SolverView&, JointedBodies&);

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
