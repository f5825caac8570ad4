// SPDX-License-Identifier: MIT
// Several cores: base/workers.h. It changes no bit of a world, so it is no part of its signature: what four cores have saved, one loads.
#pragma once

#include "../../constraint/impact_note.h"
#include "../../narrow_phase/update_manifolds.h"
#include "../../solver/sweeps/solver_parts.h"
#include "../../solver/sweeps/work_together.h"
#include "manifolds.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

template <class S, bool present>
struct PartNotePart {
    ImpactNote part_notes[static_cast<unsigned>(S::max_manifolds)] = {};
    Index manifold_of_part[static_cast<unsigned>(S::max_manifolds)] = {};

    void show_notes(PartRoom& room) {
        room.notes = part_notes;
        room.manifold_of = manifold_of_part;
    }
};
template <class S>
struct PartNotePart<S, false> {
    static void show_notes(PartRoom&) {}
};
template <class S, bool present>
struct PartShapePairPart {
    BodyPair part_shape_pairs[static_cast<unsigned>(S::max_manifolds)] = {};
    void show_shape_pairs(PartRoom& room) { room.shape_pairs = part_shape_pairs; }
};
template <class S>
struct PartShapePairPart<S, false> {
    static void show_shape_pairs(PartRoom&) {}
};

/// Where contacts are solved in parts.
template <class S, bool present>
struct PartRoomPart : PartNotePart<S, has_events<S>>, PartShapePairPart<S, has_compounds<S> && !S::sleeps> {
    BodyPair part_pairs[static_cast<unsigned>(S::max_manifolds)] = {};
    Index ends_of_visits[static_cast<unsigned>(S::max_manifolds)] = {}, ends_of_live[static_cast<unsigned>(S::max_manifolds)] = {};

    WorkTogether work_together() { return {runner_of<typename S::workers>(), ends_of_visits, ends_of_live}; }
    PartRoom part_room() {
        PartRoom room = {part_pairs, nullptr, nullptr, nullptr};
        this->show_notes(room);
        this->show_shape_pairs(room);
        return room;
    }
};
template <class S>
struct PartRoomPart<S, false> {};

/// Where pairs are looked at before their turn.
template <class S, bool present>
struct PairOutcomePart {
    PairOutcome pair_outcomes[static_cast<unsigned>(pair_capacity<S>)] = {};
};
template <class S>
struct PairOutcomePart<S, false> {};

struct SharedWork : Feature {
    template <class S>
    static constexpr bool named = shares_work<S>;

    template <class S, bool present>
    struct Memory : PartRoomPart<S, solves_in_parts<S>>, PairOutcomePart<S, stacks<S>> {};
    template <class S>
    struct Memory<S, false> {};

    template <class S>
    static constexpr bool check() {
        static_assert(S::workers::workers >= 1 && S::workers::workers <= workers_max, "a step is shared by 1 to 16 workers: see base/workers.h");
        static_assert(!solves_in_parts<S> || S::max_bodies + tasks_max<typename S::workers> <= index_max - 1,
                      "with several workers a scene holds up to 65534 bodies less 4 for each: lower max_bodies");
        return true;
    }
};

} } }  // namespace ingot::features
