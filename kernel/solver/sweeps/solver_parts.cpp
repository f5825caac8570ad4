// SPDX-License-Identifier: MIT
#include "solver_parts.h"

#include "../../base/workers.h"
#include "../../island/disjoint_sets.h"
#include "move_bodies.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr Index slot_of_none = index_max;  ///< of bodies: contacts go with fewer

bool moves(const BodyView& bodies, int slot) { return bodies.translation[place_of(slot).tile].inv_M[place_of(slot).lane] > 0; }

/// What the walks note, in arrays that solving fills anew: by the slots of bodies, and of an island by that of its root.
struct Notes {
    const SolverView& whole;

    DisjointSets islands() const { return {whole.island_of}; }
    Index& contacts(int root) const { return whole.level_of_body[root]; }
    uint32_t& part_after(int root) const { return whole.colours_of_body[root]; }  ///< 1 + its part; 0: none yet
    bool counts(int slot) const { return whole.batch_bodies[slot] != 0; }         ///< the body can move, and no part has it yet
    Index& root_at(int manifold_i) const { return whole.island_at[manifold_i]; }

    void begin(const BodyView& bodies, int slot) const {
        const bool can_move = moves(bodies, slot);
        islands().make_set(slot);
        contacts(slot) = 0;
        part_after(slot) = 0;
        whole.batch_bodies[slot] = can_move ? 1 : 0;
        if (!can_move) whole.local_of[slot] = 0;  // of no part's bodies
    }
    void count(int slot, int part_i, SolverPart* parts) const {
        parts[part_i].body_count += whole.batch_bodies[slot];
        whole.batch_bodies[slot] = 0;
    }
};

/// Islands by union-find, and how many contacts each has.
void join_bodies(const Notes& notes, const BodyView& bodies) {
    const SolverView& whole = notes.whole;
    for (int manifold_i = 0; manifold_i < whole.manifold_count; ++manifold_i) {  // bound: max_manifolds
        notes.begin(bodies, whole.pairs[manifold_i].body_A);
        notes.begin(bodies, whole.pairs[manifold_i].body_B);
    }
    for (int manifold_i = 0; manifold_i < whole.manifold_count; ++manifold_i) {
        const BodyPair& pair = whole.pairs[manifold_i];
        if (notes.counts(pair.body_A) && notes.counts(pair.body_B)) notes.islands().join(pair.body_A, pair.body_B);
    }
    for (int manifold_i = 0; manifold_i < whole.manifold_count; ++manifold_i) {
        const BodyPair& pair = whole.pairs[manifold_i];
        const int root = notes.islands().root(notes.counts(pair.body_A) ? pair.body_A : pair.body_B);
        notes.root_at(manifold_i) = static_cast<Index>(root);
        ++notes.contacts(root);
    }
}

/// Islands in the order of their first contacts fill one part after the other.
int fill_parts(const Notes& notes, int most, SolverPart* parts) {
    const SolverView& whole = notes.whole;
    const int share = (whole.manifold_count + most - 1) / most;
    int part_i = 0;
    parts[0] = {};
    for (int manifold_i = 0; manifold_i < whole.manifold_count; ++manifold_i) {
        const int root = notes.root_at(manifold_i);
        if (notes.part_after(root) == 0) {
            if (parts[part_i].pair_count >= share && part_i + 1 < most) parts[++part_i] = {};
            notes.part_after(root) = static_cast<uint32_t>(part_i) + 1;
            parts[part_i].pair_count += notes.contacts(root);
            ++parts[part_i].island_count;
        }
        const int of_root = static_cast<int>(notes.part_after(root)) - 1;
        notes.count(whole.pairs[manifold_i].body_A, of_root, parts);
        notes.count(whole.pairs[manifold_i].body_B, of_root, parts);
    }
    return part_i + 1;
}

/// Each part begins where the one before ends. Blocks that the contacts do not need by themselves are shared: they part colours.
void place_parts(SolverPart* parts, int count, int manifold_count, int block_capacity, bool has_kinematic) {
    int blocks_left = block_capacity;
    for (int i = 0; i < count; ++i) blocks_left -= (parts[i].pair_count + lanes - 1) / lanes;  // bound: tasks_max
    int more_before = 0;
    for (int i = 0; i < count; ++i) {
        SolverPart& part = parts[i];
        if (i > 0) {
            const SolverPart& before = parts[i - 1];
            part.pair_begin = before.pair_begin + before.pair_count;
            part.body_begin = before.body_begin + before.body_count + 1;
            part.block_begin = before.block_begin + before.block_count;
            part.island_begin = before.island_begin + before.island_count;
        }
        part.kinematic_before = has_kinematic ? part.pair_begin : 0;
        const long long contacts_until = part.pair_begin + part.pair_count;
        const int more_until = static_cast<int>(contacts_until * blocks_left / manifold_count);
        part.block_count = (part.pair_count + lanes - 1) / lanes + more_until - more_before;
        more_before = more_until;
    }
}

/// Contacts keep their order within a part.
void sort_contacts(const Notes& notes, const ImpactNote* impacts, const PartRoom& room, const SolverPart* parts, int count) {
    int next[tasks_of_worker * workers_max];
    for (int i = 0; i < count; ++i) next[i] = parts[i].pair_begin;
    const SolverView& whole = notes.whole;
    for (int manifold_i = 0; manifold_i < whole.manifold_count; ++manifold_i) {
        const int to = next[notes.part_after(notes.root_at(manifold_i)) - 1]++;
        room.pairs[to] = whole.pairs[manifold_i];
        if (room.shape_pairs != nullptr) room.shape_pairs[to] = whole.shape_pairs[manifold_i];
        if (impacts == nullptr) continue;
        room.manifold_of[to] = static_cast<Index>(manifold_i);
        write_note(room.notes[to], impacts[manifold_i]);
    }
}

/// Those with most contacts first: who is done early takes another.
void sort_parts(SolverPart* parts, int count) {
    for (int i = 1; i < count; ++i) {
        const SolverPart part = parts[i];
        int to = i;
        for (; to > 0 && parts[to - 1].pair_count < part.pair_count; --to) parts[to] = parts[to - 1];  // bound: tasks_max
        parts[to] = part;
    }
}

}  // namespace

int cut_into_parts(const SolverView& whole, const BodyView& bodies, int most, const PartRoom& room, const ImpactNote* notes, bool has_kinematic,
                   SolverPart* parts) {
    if (most < 2) return 1;
    const Notes walks{whole};
    join_bodies(walks, bodies);
    const int count = fill_parts(walks, most, parts);
    if (count < 2) return 1;
    place_parts(parts, count, whole.manifold_count, whole.lane_capacity / lanes, has_kinematic);
    sort_contacts(walks, notes, room, parts, count);
    sort_parts(parts, count);
    return count;
}

void give_back_notes(const SolverPart& part, const PartRoom& room, ImpactNote* notes) {
    // bound: max_manifolds
    for (int i = part.pair_begin; i < part.pair_begin + part.pair_count; ++i) write_note(notes[room.manifold_of[i]], room.notes[i]);
}

void add_report(StepReport& report, const StepReport& of_part) {
    count(report.impact_waves, of_part.impact_waves);
    count(report.impacts_deferred, of_part.impacts_deferred);
    count(report.sweeps_unfinished, of_part.sweeps_unfinished);
    if (of_part.sweeps > report.sweeps) report.sweeps = of_part.sweeps;
    if (of_part.residual > report.residual) report.residual = of_part.residual;
}

void find_bodies_of_part(SolverView& whole, const SolverView& of_part, const SolverPart& part) {
    const int end = part.body_begin + part.body_count + 1;
    if (end > whole.body_count) whole.body_count = end;
    for (int body_i = 0; body_i <= part.body_count; ++body_i) {  // bound: max_bodies + 1
        Index& slot = of_part.slot_of[body_i];
        if (body_i == 0 || body_i >= of_part.body_count)
            slot = slot_of_none;  // one that cannot move, or that has gone bad
        else
            whole.local_of[slot] = static_cast<Index>(part.body_begin + body_i);
    }
}

} }  // namespace ingot
