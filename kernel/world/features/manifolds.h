// SPDX-License-Identifier: MIT
// Contacts with friction: pairs, manifolds, the memory of broad phase and solver; and impacts without friction.
#pragma once

#include "../../base/if.h"
#include "../../constraint/kinematic_view.h"
#include "../../impulse/find_contacts.h"
#include "../../narrow_phase/inner_edges.h"
#include "shapes.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

template <class S>
inline constexpr int pair_capacity = static_cast<int>(pairs_with_own<S>);

template <class S, bool present>
struct BodyPairPart {
    BodyPair body_pairs[static_cast<unsigned>(S::max_manifolds)] = {};
    BodyPair* by_bodies(BodyPair*) { return body_pairs; }
};
template <class S>
struct BodyPairPart<S, false> {
    static BodyPair* by_bodies(BodyPair* pairs) { return pairs; }
};

template <class S, bool present>
struct AnchorPart {
    ManifoldAnchors anchors[static_cast<unsigned>(S::max_manifolds)] = {};
    ManifoldAnchors* manifold_anchors() { return anchors; }
};
template <class S>
struct AnchorPart<S, false> {
    ManifoldAnchors* manifold_anchors() { return nullptr; }
};

/// Parts beside the first: each has a body of its own that stands for all that cannot move, and may leave a part of its last block.
template <class S>
inline constexpr unsigned more_parts_of = solves_in_parts<S> ? static_cast<unsigned>(tasks_max<typename S::workers>) - 1 : 0;

/// Manifolds of bodies with joints have blocks of their own: one more for what each kind leaves of its last.
template <class S>
inline constexpr unsigned block_capacity_of =
    (static_cast<unsigned>(S::max_manifolds) + lanes - 1) / lanes + (has_joints<S> && lanes > 1 ? 1 : 0) + more_parts_of<S>;

template <class S, bool sleeps>
struct BroadPhasePart : S::broad_phase::template AwakeMemory<shape_capacity<S>, pair_capacity<S>> {};
template <class S>
struct BroadPhasePart<S, false> : S::broad_phase::template Memory<shape_capacity<S>, pair_capacity<S>> {};

/// Where shapes may hide each other's edges: see inner_edges.h. Zero but within that stage.
template <class S, bool present>
struct InnerEdgePart {
    Index last_of_shape[static_cast<unsigned>(shape_capacity<S>)] = {};
};
template <class S>
struct InnerEdgePart<S, false> {};

/// What other traits add to contacts.
template <class S>
struct ManifoldTraitsPart : AnchorPart<S, S::recycles_manifolds>, BodyPairPart<S, has_compounds<S> && !S::sleeps>, BroadPhasePart<S, S::sleeps>,
                            S::solver::template Memory<S::max_bodies, S::max_manifolds, S::rolling_resistance, S::bounces> {};

/// Solver bodies: one stands for all that cannot move; and each contact with a kinematic body has one.
template <class S>
inline constexpr unsigned solver_body_capacity = static_cast<unsigned>(S::max_bodies) + 1 + more_parts_of<S> +
                                                 (S::kinematic_bodies ? static_cast<unsigned>(S::max_manifolds) : 0);

/// What a solver works in that solves manifolds as blocks. The sequential solver brings all it needs.
template <class S, bool present>
struct BlockPart : ManifoldTraitsPart<S> {
    ContactBlock blocks[block_capacity_of<S>] = {};
    SolverBody solver_bodies[solver_body_capacity<S>] = {};
    SolverBodyHistory histories[solver_body_capacity<S>] = {};
    Vector friction_references[static_cast<unsigned>(S::max_manifolds)] = {};
};
template <class S>
struct BlockPart<S, false> : ManifoldTraitsPart<S> {};

/// Between the two parts of blocks: after numbers of four bytes it leaves no gap.
template <class S>
struct ManifoldListPart : BlockPart<S, !S::solver::is_pointwise> {
    static constexpr unsigned manifold_capacity = static_cast<unsigned>(S::max_manifolds);

    BoundsTile bounds[shape_tile_capacity<S>] = {};
    BodyPair found_pairs[pair_capacity<S>] = {};
    BodyPair pairs[manifold_capacity] = {};
    ManifoldRecord records[manifold_capacity] = {};
};

/// The order in which blocks are visited.
template <class S, bool present>
struct BlockOrderPart : ManifoldListPart<S> {
    static constexpr unsigned manifold_capacity = static_cast<unsigned>(S::max_manifolds);
    static constexpr unsigned block_capacity = block_capacity_of<S>;
    static constexpr unsigned body_capacity = static_cast<unsigned>(S::max_bodies) + 1 + more_parts_of<S>;

    static constexpr unsigned visit_capacity = manifold_capacity + block_capacity;

    /// What touches has a manifold, and figures that touch nothing have a joint.
    static constexpr unsigned island_room = manifold_capacity + static_cast<unsigned>(S::max_joints);
    Island islands[body_capacity < island_room ? body_capacity : island_room] = {};
    uint32_t colours_of_body[solver_body_capacity<S>] = {};
    Index level_of_body[body_capacity] = {}, slot_of[body_capacity] = {}, island_of[body_capacity] = {}, batch_bodies[body_capacity] = {};
    Index local_of[static_cast<unsigned>(tile_capacity<S> * lanes)] = {};
    Index members[manifold_capacity] = {}, sorted[manifold_capacity] = {};
    uint8_t colour[manifold_capacity] = {};
    Index island_at[manifold_capacity] = {}, level[manifold_capacity] = {};
    Visit visits[visit_capacity] = {}, some_visits[visit_capacity] = {};

    auto solver_of(const BodyPair* pairs_of_bodies, ManifoldRecord* records_of_pairs, int count) {
        If<sweeps_balls_alone<S> && !has_joints<S> && !S::axis_locks, BallView, SolverView> view{};
        view.pairs = pairs_of_bodies;
        view.records = records_of_pairs;
        view.friction_references = this->friction_references;
        view.manifold_count = count;
        view.bodies = this->solver_bodies;
        view.histories = this->histories;
        view.slot_of = slot_of;
        view.local_of = local_of;
        view.level_of_body = level_of_body;
        view.colours_of_body = colours_of_body;
        view.island_of = island_of;
        view.islands = islands;
        view.island_at = island_at;
        view.level = level;
        view.blocks = this->blocks;
        view.visits = visits;
        view.some_visits = some_visits;
        view.members = members;
        view.sorted = sorted;
        view.colour = colour;
        view.batch_bodies = batch_bodies;
        view.lane_capacity = static_cast<int>(block_capacity * lanes);
        return view;
    }
};
template <class S>
struct BlockOrderPart<S, false> : ManifoldListPart<S> {};

template <class S, bool present>
struct ManifoldPart : BlockOrderPart<S, !S::solver::is_pointwise>, InnerEdgePart<S, hides_internal_edges<S>> {
    Index found_count = 0, pairs_lost = 0;
    Index manifold_count = 0, records_used = 0, first_free_record = 0;

    PairList pair_list() { return {this->found_pairs, pair_capacity<S>, &found_count, &pairs_lost}; }
    ManifoldView manifold_view() {
        return {this->pairs, &manifold_count, this->records, this->manifold_anchors(), &records_used, &first_free_record, S::max_manifolds};
    }
    auto solver() {
        auto view = this->solver_of(this->by_bodies(this->pairs), this->records, manifold_count);
        view.unit = S::length_unit;
        view.effort = S::effort;
        return view;
    }
};
template <class S>
struct ManifoldPart<S, false> {};

/// Impacts without friction, found anew in every step.
struct Impacts : Feature {
    template <class S>
    static constexpr bool named = collides<S>;

    template <class S, bool present>
    struct Memory {
        Contact contacts[static_cast<unsigned>(S::max_contacts)] = {};
        Index contact_count = 0;
    };
    template <class S>
    struct Memory<S, false> {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::max_contacts);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(S::max_contacts >= 0 && S::max_contacts <= index_max, "a scene holds 0 to 65535 contacts: set max_contacts");
        static_assert(!collides<S> || S::translates, "bodies that collide move: set translates = true, or max_contacts = 0");
        static_assert(!(collides<S> && stacks<S>),
                      "a scene has impacts without friction, max_contacts, or contacts with friction, max_manifolds: set one of them");
        static_assert(!collides<S> || S::solver::is_frictionless,
                      "max_contacts is the room of impacts without friction: say using solver = FrictionlessImpacts, or set max_manifolds");
        static_assert(!stacks<S> || !S::solver::is_frictionless,
                      "FrictionlessImpacts finds its contacts anew in every step: set max_contacts for max_manifolds, or name another solver");
        return true;
    }
    template <class S>
    static void forget_body(Storage<S>& storage, int) {
        storage.contact_count = 0;
    }
};

/// Contacts with friction.
struct Manifolds : Feature {
    static constexpr uint32_t part = SnapshotPart::manifolds;
    template <class S>
    static constexpr bool named = stacks<S>;
    template <class S, bool present>
    using Memory = ManifoldPart<S, present>;

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::max_manifolds);
        each(S::max_pairs);
        each(S::recycles_manifolds);
        if constexpr (!S::hides_internal_edges) each(S::hides_internal_edges);
        if constexpr (!S::holds_crowds) each("holds_no_crowds");  // a name: a second false would be taken for the first
        each(S::broad_phase::name);
        each(S::solver::name);
        if constexpr (solves_directly<S>) {
            each(S::solver::island_capacity);
            each(S::solver::entries_per_row);
        }
    }
    template <class S>
    static constexpr bool check() {
        static_assert(S::max_manifolds >= 0 && S::max_manifolds <= index_max - 1, "a scene holds 0 to 65534 manifolds: set max_manifolds");
        static_assert(!stacks<S> || (S::max_pairs >= 0 && S::max_pairs <= index_max && 2 * S::max_manifolds <= index_max + S::max_pairs),
                      "a scene holds up to 65535 pairs, twice max_manifolds unless it says otherwise: set max_pairs");
        static_assert(!stacks<S> || S::max_bodies <= index_max, "bodies with contacts are up to 65535: set max_bodies");
        static_assert(!stacks<S> || !S::rotation::as_printed, "Listing 1 has no contacts with friction: name another rotation, or max_contacts");
        static_assert(stacks<S> || has_joints<S> || S::length_unit == 1,
                      "length_unit is for contacts with friction and for joints: set max_manifolds or max_joints, or length_unit = 1");
        static_assert(!stacks<S> || S::translates, "bodies that touch move: set translates = true, or max_manifolds = 0");
        return check_solver<S>();
    }
    template <class S>
    static constexpr bool check_solver() {
        static_assert(S::bounces || !solves_directly<S>, "a solver that picks itself lets bodies bounce: name BlockSweeps, or set bounces = true");
        static_assert(!solves_directly<S> || stacks<S>, "HybridIslands is for contacts with friction: set max_manifolds, or name no solver");
        static_assert(!solves_pointwise<S> || stacks<S>, "SequentialImpulses is for contacts with friction: set max_manifolds, or name no solver");
        return true;
    }
    template <class S>
    static void forget_shape(Storage<S>& storage, int shape_slot) {
        invalidate_contacts(storage.manifold_view(), storage.pair_list(), storage.bounds, shape_slot);
    }

    /// The search for pairs begins anew: what is zero in storage is outside of every bound.
    struct OfManifold : NoNumbers {
        SavedManifold saved;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t parts) {
            saved.numbers(each, parts);
        }
        template <class S>
        void take(const Storage<S>& storage, const BodyPair& pair) {
            saved = {pair.body_A, pair.body_B, storage.records[pair.record], {}, {}};
            if constexpr (!solves_pointwise<S>)  // before the first step of a manifold it is what the record had before
                if (age_of(saved.record) > 0) saved.j_reference = storage.friction_references[pair.record];
            if constexpr (S::recycles_manifolds)  // what is not known is what the record had before
                if (storage.anchors[pair.record].margin > 0) saved.anchors = storage.anchors[pair.record];
        }
        template <class S>
        void put(Storage<S>& storage, Index record) const {
            storage.pairs[record] = {saved.body_A, saved.body_B, record};
            storage.records[record] = saved.record;
            storage.records[record].manifold.halvings = static_cast<uint16_t>(storage.surface_view().halvings(saved.body_A, saved.body_B));
            if constexpr (!solves_pointwise<S>) storage.friction_references[record] = saved.j_reference;
            if constexpr (S::recycles_manifolds) storage.anchors[record] = saved.anchors;
            storage.records_used = storage.manifold_count = static_cast<Index>(record + 1);
        }
        template <class S>
        bool is_valid(ManifoldContext& context) const {
            const int A = saved.body_A, B = saved.body_B, slots = static_cast<int>(context.slots_used) * S::max_shapes_of_body;
            context.key = BodyPair{saved.body_A, saved.body_B, no_record}.key();
            if (!ingot::is_valid(saved) || A >= B || B >= slots || context.key <= context.key_before) return false;
            return !has_compounds<S> || A / S::max_shapes_of_body != B / S::max_shapes_of_body;
        }
    };
};

/// Of each manifold, for how many steps sweeps have left it uneven: in scenes whose solver picks itself. The memory is the solver's.
struct Unsettled : Feature {
    static constexpr uint32_t part = SnapshotPart::direct;
    template <class S>
    static constexpr bool named = stacks<S> && solves_directly<S>;
    template <class S, bool>
    struct Memory {};

    struct OfManifold : NoNumbers {
        uint8_t steps;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("unsettled", steps);
        }
        template <class S>
        void take(const Storage<S>& storage, const BodyPair& pair) {
            steps = storage.unsettled[pair.record];
        }
        template <class S>
        void put(Storage<S>& storage, Index record) const {
            storage.unsettled[record] = steps;
        }
        template <class S>
        bool is_valid(const ManifoldContext&) const {
            return steps <= limits::unsettled_steps;
        }
    };
};

} } }  // namespace ingot::features
