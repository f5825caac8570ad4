// SPDX-License-Identifier: MIT
// Joints, and the figures that they make of bodies.
#pragma once

#include "../../figure/swing_figures.h"
#include "../../joint/check_joint.h"
#include "../../joint/check_drive.h"
#include "../../joint/check_limits.h"
#include "../../joint/check_target.h"
#include "../../joint/check_tie.h"
#include "../../joint/reactions.h"
#include "../../constraint/jointed_view.h"
#include "../../island/islands.h"
#include "gear_numbers.h"
#include "manifolds.h"

namespace ingot { inline namespace INGOT_ABI {

namespace features {

/// Bits of a snapshot's parts, of what joints may have.
struct JointPart {
    static constexpr uint32_t limits = 1u << 31, drives = 1u << 21, reactions = 1u << 23;
    static constexpr uint32_t ties = SnapshotPart::pointwise;  // of scenes with joints no bit is left, and this one they have not
    static constexpr uint32_t gears = SnapshotPart::direct;    // the same
};

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
    /// Of a joint that does nothing for now too; none: nothing is in the slot.
    template <class S>
    static JointKind kind_of(const Storage<S>& storage, int joint_i) {
        const JointKind kind = storage.joints[joint_i].kind;
        if constexpr (has_joint_breaking<S>)
            if (kind == JointKind::none) return storage.joint_breaking[joint_i].kind;
        return kind;
    }
    template <class S>
    static void take_out(Storage<S>& storage, int joint_i) {
        if (kind_of(storage, joint_i) == storage.joints[joint_i].kind) storage.joint_lists().unlink(joint_i);
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
                if (kind_of(storage, gear_i) == JointKind::gear && (gear.joint[0] == joint_i || gear.joint[1] == joint_i)) take_out(storage, gear_i);
            }
    }
    /// Bodies that are joined sleep and wake as one: those that have just come to rest too, whose islands are made once more, to last.
    template <class S>
    static void join_islands(Storage<S>& storage, bool all) {
        const BodyView bodies = storage.bodies();
        const RestView rest = storage.rest_view();
        for (int joint_i = 0; joint_i < storage.joint_slots_used; ++joint_i) {  // bound: max_joints
            const JointRecord& joint = storage.joints[joint_i];
            if (joint.kind == JointKind::none || joint.body_A == no_body || joint.body_B == no_body) continue;
            if (!is_dynamic(bodies, joint.body_A) || !is_dynamic(bodies, joint.body_B)) continue;
            if constexpr (has_ties<S>)
                if (storage.joint_ties[joint_i].slack != 0) continue;
            if (all || rest.is_active(joint.body_A) || rest.is_active(joint.body_B)) join_bodies_of(rest, joint.body_A, joint.body_B);
        }
    }
    /// What sleeps wakes with what moves and has come to be joined to it: by a rope that was slack, or a gear that did nothing. After join_islands.
    template <class S>
    static void wake_joined([[maybe_unused]] Storage<S>& storage) {
        if constexpr (has_ties<S>) {
            const BodyView bodies = storage.bodies();
            const RestView rest = storage.rest_view();
            for (int joint_i = 0; joint_i < storage.joint_slots_used; ++joint_i) {  // bound: max_joints
                const JointRecord& joint = storage.joints[joint_i];
                if (joint.kind == JointKind::none || storage.joint_ties[joint_i].slack != 0) continue;
                if (joint.body_A == no_body || joint.body_B == no_body) continue;
                if (!is_dynamic(bodies, joint.body_A) || !is_dynamic(bodies, joint.body_B)) continue;
                if (rest.is_awake(joint.body_A) == rest.is_awake(joint.body_B)) continue;
                wake_island(bodies, rest, storage.manifold_view(), rest.is_awake(joint.body_A) ? joint.body_B : joint.body_A);
            }
        }
    }
    /// A body takes its joints along.
    template <class S>
    static void before_removal(Storage<S>& storage, int slot) {
        for (int joint_i = 0; joint_i < storage.joint_slots_used; ++joint_i) {  // bound: max_joints
            const JointRecord& joint = storage.joints[joint_i];
            if (kind_of(storage, joint_i) == JointKind::none || (joint.body_A != slot && joint.body_B != slot)) continue;
            take_out_gears_of(storage, joint_i);
            take_out(storage, joint_i);
        }
    }

    /// Of every slot that holds or held a joint.
    struct OfEntry : NoNumbers {
        uint32_t generation;
        uint8_t kind;
        JointRecord joint;
        LimitRecord limit;
        AngleRecord angle;
        uint32_t turns;
        DriveRecord drives[3];
        uint8_t drive_kind[3];
        JointReaction reaction;
        BreakRecord breaking;
        uint8_t phase;
        TieRecord tie;
        TargetRecord target;
        GearNumbers gear;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t parts) {
            each("joint.generation", generation);
            each("joint.kind", kind);
            each("joint.body_A", joint.body_A);
            each("joint.body_B", joint.body_B);
            JointFrame* const frames[] = {&joint.frame_A, &joint.frame_B};
            for (JointFrame* const frame : frames) {
                each("joint.anchor", frame->anchor);
                each("joint.axis", frame->axis);
                each("joint.side", frame->side);
            }
            each("joint.j", joint.j);
            each("joint.resolved", joint.resolved);
            each("joint.doublings", joint.doublings);
            each("joint.bodies_meet", joint.bodies_meet);
            if ((parts & JointPart::limits) != 0) numbers_of_limits(each);
            if ((parts & (JointPart::limits | JointPart::drives)) != 0) {
                each("joint.angle", angle.angle);
                each("joint.turns", turns);
            }
            if ((parts & JointPart::drives) != 0) numbers_of_drives(each);
            if ((parts & JointPart::reactions) != 0) {
                each("joint.reaction.force", reaction.force);
                each("joint.reaction.torque", reaction.torque);
                each("joint.strength.force", breaking.strength.force);
                each("joint.strength.torque", breaking.strength.torque);
                each("joint.phase", phase);
            }
            if ((parts & JointPart::ties) != 0) {
                each("joint.length", tie.length);
                each("joint.reeled", tie.reeled);
                each("joint.slack", tie.slack);
                numbers_of_target(each);
            }
            if ((parts & JointPart::gears) != 0) gear.numbers(each);
        }
        template <class Each>
        constexpr void numbers_of_target(Each& each) {
            each("joint.hertz", target.hertz);
            each("joint.damping_ratio", target.damping_ratio);
            each("joint.max_force", target.max_force);
            each("joint.max_torque", target.max_torque);
            each("joint.target_velocity", target.velocity);
            each("joint.target_spin", target.spin);
            each("joint.target_force", target.force);
            each("joint.target_torque", target.torque);
        }
        template <class Each>
        constexpr void numbers_of_limits(Each& each) {
            for (JointRange& range : limit.limits.range) {
                each("joint.lower", range.lower);
                each("joint.upper", range.upper);
            }
            each("joint.restitution", limit.limits.restitution);
            for (int i = 0; i < 2; ++i) {
                each("joint.limit_j", limit.j[i]);
                each("joint.limit_leave", limit.leave[i]);
            }
        }
        template <class Each>
        constexpr void numbers_of_drives(Each& each) {
            for (int i = 0; i < 3; ++i) {
                JointDrive& drive = drives[i].drive;
                each("joint.drive", drive_kind[i]);
                each("joint.stiffness", drive.stiffness);
                each("joint.damping", drive.damping);
                each("joint.target", drive.target);
                each("joint.target_rate", drive.target_rate);
                each("joint.feedforward", drive.feedforward);
                each("joint.max_torque", drive.max_torque);
                each("joint.torque", drives[i].torque);
            }
        }
        template <class S>
        void take(const Storage<S>& storage, int joint_i) {
            generation = storage.joint_generation[joint_i];
            joint = storage.joints[joint_i];
            kind = static_cast<uint8_t>(kind_of(storage, joint_i));
            if constexpr (has_joint_reactions<S>) reaction = storage.joint_reactions[joint_i];
            if constexpr (has_joint_breaking<S>) {
                breaking = storage.joint_breaking[joint_i];
                phase = static_cast<uint8_t>(breaking.phase);
            }
            if constexpr (has_joint_limits<S>) limit = storage.joint_limits[joint_i];
            if constexpr (has_ties<S>) tie = storage.joint_ties[joint_i];
            if constexpr (has_targets<S>) target = storage.joint_targets[joint_i];
            if constexpr (has_gears<S>) gear.take(storage.joint_gears[joint_i]);
            if constexpr (has_joint_rows<S>) {
                angle = storage.joint_angles[joint_i];
                turns = static_cast<uint32_t>(angle.turns);
            }
            for (int i = 0; i < 3; ++i) {
                drives[i] = {};
                if constexpr (has_joint_drives<S>)
                    if (i < drives_of<S>()) drives[i] = storage.drive_of(joint_i, i);
                drive_kind[i] = static_cast<uint8_t>(drives[i].drive.kind);
            }
        }
        template <class S>
        void put(Storage<S>& storage, int joint_i) const {
            storage.joint_generation[joint_i] = generation;
            storage.joints[joint_i] = joint;
            storage.joints[joint_i].kind = static_cast<JointKind>(kind);
            if constexpr (has_joint_reactions<S>) storage.joint_reactions[joint_i] = reaction;
            if constexpr (has_joint_breaking<S>) {
                const JointKind kept = phase == 0 ? JointKind::none : static_cast<JointKind>(kind);
                write_record(storage.joint_breaking[joint_i], {breaking.strength, kept, static_cast<JointPhase>(phase)});
                if (phase != 0) {
                    storage.joints[joint_i].kind = JointKind::none;
                    return put_beside(storage, joint_i);
                }
            }
            if (kind != 0) storage.joint_lists().link(joint_i);
            put_beside(storage, joint_i);
        }
        /// Without breaking all of its numbers are those of a joint that works and is as strong as can be.
        template <class S>
        bool is_valid_reaction() const {
            if (!is_finite(reaction.force) || !is_finite(reaction.torque) || check_strength(breaking.strength) != Status::ok) return false;
            return phase <= static_cast<uint8_t>(has_joint_breaking<S> && (generation & 1u) != 0 ? JointPhase::breaks : JointPhase::works);
        }
        template <class S>
        void put_beside(Storage<S>& storage, int joint_i) const {
            if constexpr (has_joint_limits<S>) storage.joint_limits[joint_i] = limit;
            if constexpr (has_targets<S>) storage.joint_targets[joint_i] = target;
            if constexpr (has_gears<S>) storage.joint_gears[joint_i] = gear.read();
            if constexpr (has_ties<S>) storage.joint_ties[joint_i] = {tie.length, tie.reeled, tie.reeled, tie.slack};
            if constexpr (has_joint_rows<S>) storage.joint_angles[joint_i] = {angle.angle, static_cast<int32_t>(turns)};
            for (int i = 0; i < drives_of<S>(); ++i)  // bound: 3
                if constexpr (has_joint_drives<S>) storage.drive_of(joint_i, i) = drive_read(i);
        }
        DriveRecord drive_read(int direction_i) const {
            DriveRecord record = drives[direction_i];
            record.drive.kind = static_cast<DriveKind>(drive_kind[direction_i]);
            return record;
        }
        template <class S>
        bool is_valid(const EntryContext& context) const {
            JointRecord read = joint;
            read.kind = static_cast<JointKind>(kind);
            if constexpr (has_joint_reactions<S>)
                if (!is_valid_reaction<S>()) return false;
            if ((generation & 1u) == 0) return kind == 0;
            if constexpr (has_joint_limits<S>)
                if (!ingot::is_valid(limit, read.kind)) return false;
            if constexpr (has_joint_limits<S> && has_servos<S>)
                if (is_servo(read.kind) && limits_something(limit.limits)) return false;
            if (has_ties<S> && !ingot::is_valid(tie, read.kind, S::length_unit)) return false;
            if (has_targets<S> && !ingot::is_valid(target)) return false;
            if (has_gears<S> && !ingot::is_valid(gear.read(), read.kind, S::max_joints)) return false;
            if (has_joint_rows<S> && !ingot::is_valid(angle)) return false;
            for (int i = 0; i < drives_of<S>(); ++i)  // bound: 3
                if (!ingot::is_valid(drive_read(i))) return false;
            return S::joints::has(read.kind) && ingot::is_valid(read, static_cast<int>(context.shape_slots) / S::max_shapes_of_body);
        }
    };
    template <class S>
    static constexpr int drives_of() {
        return has_joint_drives<S> ? S::joints::drives_of_joint() : 0;
    }
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
