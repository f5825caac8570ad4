// SPDX-License-Identifier: MIT
// The numbers of a joint in a snapshot.
#pragma once

#include "../../joint/check_joint.h"
#include "../../joint/check_drive.h"
#include "../../joint/check_limits.h"
#include "../../joint/check_target.h"
#include "../../joint/check_tie.h"
#include "../../joint/reactions.h"
#include "feature.h"
#include "gear_numbers.h"

namespace ingot { inline namespace INGOT_ABI {

namespace features {

/// Bits of a snapshot's parts, of what joints may have.
struct JointPart {
    static constexpr uint32_t limits = 1u << 31, drives = 1u << 21, reactions = 1u << 23;
    static constexpr uint32_t ties = SnapshotPart::pointwise;  // of scenes with joints no bit is left, and this one they have not
    static constexpr uint32_t gears = SnapshotPart::direct;    // the same
};

/// Of a joint that does nothing for now too; none: nothing is in the slot.
template <class S>
JointKind kind_of_joint(const Storage<S>& storage, int joint_i) {
    const JointKind kind = storage.joints[joint_i].kind;
    if constexpr (has_joint_breaking<S>)
        if (kind == JointKind::none) return storage.joint_breaking[joint_i].kind;
    return kind;
}
template <class S>
constexpr int drives_of_joint() {
    return has_joint_drives<S> ? S::joints::drives_of_joint() : 0;
}

/// Of every slot that holds or held a joint.
struct JointEntry : NoNumbers {
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
            each("joint.target_low", drives[i].target_low);
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
        kind = static_cast<uint8_t>(kind_of_joint(storage, joint_i));
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
                if (i < drives_of_joint<S>()) drives[i] = storage.drive_of(joint_i, i);
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
        for (int i = 0; i < drives_of_joint<S>(); ++i)  // bound: 3
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
        for (int i = 0; i < drives_of_joint<S>(); ++i)  // bound: 3
            if (!ingot::is_valid(drive_read(i))) return false;
        return S::joints::has(read.kind) && ingot::is_valid(read, static_cast<int>(context.shape_slots) / S::max_shapes_of_body);
    }
};

}  // namespace features

} }  // namespace ingot
