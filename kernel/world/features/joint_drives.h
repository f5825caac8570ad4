// SPDX-License-Identifier: MIT
// Joints that are driven.
#pragma once

#include "../../figure/joint_row.h"
#include "../../joint/check_drive.h"
#include "joints.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

/// Its numbers stand with those of joints.
struct DrivenJoints : Feature {
    static constexpr uint32_t part = JointPart::drives;
    template <class S>
    static constexpr bool named = has_joint_drives<S>;

    template <class S, bool present>
    struct Memory {
        static constexpr unsigned drive_capacity = static_cast<unsigned>(S::max_joints) * static_cast<unsigned>(S::joints::drives_of_joint());

        DriveRecord joint_drives[drive_capacity] = {};
        DriveMotion drive_motions[drive_capacity] = {};

        void show_drives(DrivenRowView& view) {
            view.drives = joint_drives;
            view.drive_motions = drive_motions;
            view.drives_of_joint = S::joints::drives_of_joint();
        }
        DriveRecord& drive_of(int joint_i, int direction_i) { return joint_drives[joint_i * S::joints::drives_of_joint() + direction_i]; }
        const DriveRecord& drive_of(int joint_i, int direction_i) const { return const_cast<Memory*>(this)->drive_of(joint_i, direction_i); }
    };
    template <class S>
    struct Memory<S, false> {};

    /// What is driven to a target that moves does not rest.
    template <class S>
    static void keep_awake(Storage<S>& storage) {
        for (int joint_i = 0; joint_i < storage.joint_slots_used; ++joint_i) {  // bound: max_joints
            const JointRecord& joint = storage.joints[joint_i];
            bool moves = false;
            for (int i = 0; i < driven_directions(joint.kind); ++i) {  // bound: 3
                const JointDrive& drive = storage.drive_of(joint_i, i).drive;
                moves = moves || (drive.kind != DriveKind::none && drive.target_rate != 0);
            }
            if (!moves) continue;
            if (joint.body_A != no_body) storage.rest_view().rest_time[joint.body_A] = 0;
            if (joint.body_B != no_body) storage.rest_view().rest_time[joint.body_B] = 0;
        }
    }

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        if constexpr (S::joints::has_drives) each(S::joints::has_drives);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!S::joints::has_drives || S::joints::drives_of_joint() > 0, "no kind of this scene's joints can be driven: drop WithDrives");
        return true;
    }
};

} } }  // namespace ingot::features
