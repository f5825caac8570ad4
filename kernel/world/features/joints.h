// SPDX-License-Identifier: MIT
// Joints, and the figures that they make of bodies.
#pragma once

#include "../../figure/swing_figures.h"
#include "../../constraint/jointed_view.h"
#include "../../island/islands.h"
#include "joint_entry.h"
#include "manifolds.h"

namespace ingot { inline namespace INGOT_ABI {

namespace features {

/// What a body answers with its figure.
template <class S, bool present>
struct ResponsePart {
    Spatial6Rows<1> responses[static_cast<unsigned>(S::max_bodies)] = {};
};
template <class S>
struct ResponsePart<S, false> {};

/// What figures and contacts share.
template <class S, bool present>
struct JointedContactPart : ResponsePart<S, true> {
    static constexpr unsigned local_capacity = static_cast<unsigned>(S::max_bodies) + 1;

    JointedBlock jointed_blocks[block_capacity_of<S>] = {};
    Index node_of_local[local_capacity] = {}, leader_of_local[local_capacity] = {};
    Index parted[static_cast<unsigned>(S::max_manifolds)] = {};
    uint8_t doublings_of_island[local_capacity] = {};

    JointedBodies jointed_bodies(const FigureView& figures) {
        JointedBodies jointed{};
        jointed.figures = figures;
        jointed.responses = this->responses;
        jointed.node_of = node_of_local;
        jointed.leader_of = leader_of_local;
        jointed.doublings_of = doublings_of_island;
        jointed.blocks = jointed_blocks;
        jointed.parted = parted;
        return jointed;
    }
};
template <class S>
struct JointedContactPart<S, false> {};

struct Figures : Feature {
    static constexpr uint32_t part = SnapshotPart::joints;
    template <class S>
    static constexpr bool named = has_joints<S>;

    template <class S>
    static constexpr unsigned node_capacity_of = static_cast<unsigned>(S::max_bodies < 2 * S::max_joints ? S::max_bodies : 2 * S::max_joints);
    /// A body that has ties alone is a figure.
    template <class S>
    static constexpr unsigned figure_capacity = has_ties<S> ? node_capacity_of<S> : static_cast<unsigned>(S::max_joints);

    template <class S, bool present>
    struct Memory : JointedContactPart<S, stacks<S>> {
        static constexpr unsigned joint_capacity = static_cast<unsigned>(S::max_joints);
        static constexpr unsigned body_capacity = static_cast<unsigned>(S::max_bodies);
        static constexpr unsigned node_capacity = node_capacity_of<S>;

        alignas(tile_alignment) FigureRow<1> figure_rows[node_capacity] = {};
        JointRecord joints[joint_capacity] = {};
        uint32_t joint_generation[joint_capacity] = {};  ///< odd while a joint lives in the slot
        FigureNode figure_nodes[node_capacity] = {};
        Figure trees[figure_capacity<S>] = {};
        FigureGroup figure_groups[figure_capacity<S>] = {};
        Index node_of[body_capacity] = {}, end_at[body_capacity] = {};
        Index first_end[body_capacity] = {}, next_end[2 * joint_capacity] = {};
        uint16_t jointed_lanes[tile_capacity<S>] = {};
        int32_t joint_slots_used = 0;

        JointLists joint_lists() { return {joints, first_end, next_end}; }
        FigureView figure_view(const BodyView& bodies) {
            FigureView view{};
            view.bodies = bodies;
            view.jointed = jointed_lanes;
            view.lists = joint_lists();
            view.nodes = figure_nodes;
            view.figures = trees;
            view.groups = figure_groups;
            view.rows = figure_rows;
            view.node_of = node_of;
            view.end_at = end_at;
            view.joint_slots = joint_slots_used;
            view.unit = S::length_unit;
            return view;
        }
        template <class Filters>
        JointFilters<Filters, S::max_shapes_of_body> with_joints(const Filters& filters) const {
            return {filters, const_cast<Memory*>(this)->joint_lists()};
        }
        bool joint_lives(int joint_i) const { return (joint_generation[joint_i] & 1u) != 0; }
    };
    template <class S>
    struct Memory<S, false> {
        template <class Filters>
        static Filters with_joints(const Filters& filters) {
            return filters;
        }
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::max_joints);
        // bound: the kinds of joints
        for (int kind = 1; kind <= static_cast<int>(JointKind::fixed); ++kind) each(S::joints::has(static_cast<JointKind>(kind)));
        if constexpr (has_wheels<S>) each(S::joints::has(JointKind::wheel));
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!has_wheels<S> || has_joint_drives<S>, "wheels are sprung, steered and held by drives: name WithDrives among the joints");
        static_assert(S::max_joints >= 0 && S::max_joints <= (index_max - 1) / 2, "a scene holds 0 to 32767 joints: set max_joints");
        static_assert(!has_joints<S> || S::translates, "bodies with joints move: set translates = true, or max_joints = 0");
        static_assert(!has_joints<S> || has_some_joint<S>(), "a scene with max_joints says which kinds it has: set joints");
        static_assert(!has_joints<S> || !stacks<S> || (!solves_pointwise<S> && !solves_directly<S>),
                      "joints of bodies that touch are solved by BlockSweeps: name it, or max_joints = 0");
        static_assert(!has_joints<S> || !collides<S>, "joints go with contacts with friction: set max_manifolds for max_contacts, or max_joints = 0");
        static_assert(!has_joints<S> || !S::rotation::as_printed, "Listing 1 has no joints: name another rotation, or max_joints = 0");
        static_assert(has_joints<S> || !has_some_joint<S>(), "a scene with joints says how many there may be: set max_joints");
        return true;
    }
    template <class S>
    static constexpr bool has_some_joint() {
        return has_trees<S>() || S::joints::has_ties;
    }
    /// Kinds that make trees.
    template <class S>
    static constexpr bool has_trees() {
        bool some = S::joints::has(JointKind::wheel);
        for (int kind = 1; kind <= static_cast<int>(JointKind::fixed); ++kind) some = some || S::joints::has(static_cast<JointKind>(kind));
        return some;
    }
    template <class S>
    static void take_out(Storage<S>& storage, int joint_i) {
        if (kind_of_joint(storage, joint_i) == storage.joints[joint_i].kind) storage.joint_lists().unlink(joint_i);
        storage.joints[joint_i] = {};
        if constexpr (has_joint_reactions<S>) storage.joint_reactions[joint_i] = {};
        if constexpr (has_joint_breaking<S>) write_record(storage.joint_breaking[joint_i], {});
        if constexpr (has_joint_limits<S>) storage.joint_limits[joint_i] = {};
        if constexpr (has_joint_rows<S>) storage.joint_angles[joint_i] = {};
        if constexpr (has_ties<S>) storage.joint_ties[joint_i] = {};
        if constexpr (has_targets<S>) storage.joint_targets[joint_i] = {};
        if constexpr (has_gears<S>) storage.joint_gears[joint_i] = {};
        if constexpr (has_joint_drives<S>)
            for (int i = 0; i < S::joints::drives_of_joint(); ++i) storage.drive_of(joint_i, i) = {};  // bound: 3
        ++storage.joint_generation[joint_i];
    }
    /// Of joints in the slots before joint_slots: those that close a loop, and have no room.
    template <class S>
    static int joints_without_room(Storage<S>& storage, int joint_slots) {
        FigureView figures = storage.all_figures();
        figures.joint_slots = joint_slots;
        auto loops = storage.loop_view();
        build_figures(figures, loops);
        return find_loops(figures, loops);
    }
    /// It begins as if it had just come, with the angle that it has.
    template <class S>
    static void forget_impulses(Storage<S>& storage, int joint_i) {
        JointRecord& joint = storage.joints[joint_i];
        joint.j = {};
        joint.resolved = joint.doublings = 0;
        if constexpr (has_joint_limits<S>)
            for (int i = 0; i < 2; ++i) storage.joint_limits[joint_i].j[i] = storage.joint_limits[joint_i].leave[i] = 0;
    }
    /// What does nothing bears nothing.
    template <class S>
    static void forget_reaction(Storage<S>& storage, int joint_i) {
        if constexpr (has_joint_reactions<S>) storage.joint_reactions[joint_i] = {};
        if constexpr (has_joint_drives<S>)
            for (int i = 0; i < S::joints::drives_of_joint(); ++i) storage.drive_of(joint_i, i).torque = 0;  // bound: 3
    }
    /// Gears of a joint go before it.
    template <class S>
    static void take_out_gears_of([[maybe_unused]] Storage<S>& storage, [[maybe_unused]] int joint_i) {
        if constexpr (has_gears<S>)
            for (int gear_i = 0; gear_i < storage.joint_slots_used; ++gear_i) {  // bound: max_joints
                const GearRecord& gear = storage.joint_gears[gear_i];
                const bool is_of_joint = gear.joint[0] == joint_i || gear.joint[1] == joint_i;
                if (kind_of_joint(storage, gear_i) == JointKind::gear && is_of_joint) take_out(storage, gear_i);
            }
    }
    /// Calls each(body_A, body_B) for the joints that hold two bodies together as things are: not slack ropes, nor what hangs on the world.
    template <class S, class Each>
    static void over_links(const Storage<S>& storage, const Each& each) {
        for (int joint_i = 0; joint_i < storage.joint_slots_used; ++joint_i) {  // bound: max_joints
            const JointRecord& joint = storage.joints[joint_i];
            if (joint.kind == JointKind::none || joint.body_A == no_body || joint.body_B == no_body) continue;
            if constexpr (has_ties<S>)
                if (storage.joint_ties[joint_i].slack != 0) continue;
            each(joint.body_A, joint.body_B);
        }
    }
    /// Bodies that are joined sleep and wake as one: those that have just come to rest too, whose islands are made once more, to last.
    template <class S>
    static void join_islands(Storage<S>& storage, bool all) {
        const BodyView bodies = storage.bodies();
        const RestView rest = storage.rest_view();
        over_links(storage, [&](Index A, Index B) {
            if (is_dynamic(bodies, A) && is_dynamic(bodies, B) && (all || rest.is_active(A) || rest.is_active(B))) join_bodies_of(rest, A, B);
        });
    }
    /// What sleeps wakes with what moves and has come to be joined to it: by a rope that was slack, or a gear that did nothing. After join_islands.
    template <class S>
    static void wake_joined([[maybe_unused]] Storage<S>& storage) {
        if constexpr (has_ties<S>) {
            const BodyView bodies = storage.bodies();
            const RestView rest = storage.rest_view();
            over_links(storage, [&](Index A, Index B) {
                if (!is_dynamic(bodies, A) || !is_dynamic(bodies, B) || rest.is_awake(A) == rest.is_awake(B)) return;
                wake_island(bodies, rest, storage.manifold_view(), rest.is_awake(A) ? B : A);
            });
        }
    }
    /// What is joined to a body that cannot move, or moves as it is told.
    template <class S>
    static void wake_hanging(Storage<S>& storage, int slot) {
        storage.joint_lists().for_ends(static_cast<Index>(slot), [&](int end) {
            const Index other = storage.joint_lists().partner_of(end);
            if (other == no_body || !is_dynamic(storage.bodies(), other)) return;
            wake_by(storage, [&](const ManifoldView& manifolds) { wake_island(storage.bodies(), storage.rest_view(), manifolds, other); });
        });
    }
    /// What hangs on a body that moves by itself does not come to rest.
    template <class S>
    static void keep_hanging_awake(Storage<S>& storage, scalar h) {
        const BodyView bodies = storage.bodies();
        // The time at rest is -h, and 0 after the step has been added: to bodies that can move.
        over_links(storage, [&](Index A, Index B) {
            if (shows_kinematic_motion(bodies, A) && is_dynamic(bodies, B)) storage.rest_time[B] = -h;
            if (shows_kinematic_motion(bodies, B) && is_dynamic(bodies, A)) storage.rest_time[A] = -h;
        });
    }
    /// A body takes its joints along.
    template <class S>
    static void before_removal(Storage<S>& storage, int slot) {
        for (int joint_i = 0; joint_i < storage.joint_slots_used; ++joint_i) {  // bound: max_joints
            const JointRecord& joint = storage.joints[joint_i];
            if (kind_of_joint(storage, joint_i) == JointKind::none || (joint.body_A != slot && joint.body_B != slot)) continue;
            take_out_gears_of(storage, joint_i);
            take_out(storage, joint_i);
        }
    }

    using OfEntry = JointEntry;
    static constexpr bool has_entries = true;
    template <class S>
    static constexpr int entry_capacity = S::max_joints;
    template <class S>
    static Index entry_count(const Storage<S>& storage) {
        return static_cast<Index>(storage.joint_slots_used);
    }
    template <class S>
    static void set_entry_count(Storage<S>& storage, Index count) {
        storage.joint_slots_used = count;
    }
};

}  // namespace features

} }  // namespace ingot
