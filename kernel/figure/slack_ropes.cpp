// SPDX-License-Identifier: MIT
#include "slack_ropes.h"

#include "../base/figure_limits.h"
#include "../body/auxiliary.h"
#include "../body/kinematics.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

scalar length_of(const Vector& v) { return sqrt(length_sq(v)); }

/// m, that an anchor may go in h seconds.
scalar way_of(const BodyView& bodies, Index slot, const JointFrame& frame, const Vector& gravity, scalar h) {
    if (slot == no_body) return 0;
    const Place at = place_of(slot);
    const RotationTile& rotation = bodies.rotation[at.tile];
    const TranslationTile& translation = bodies.translation[at.tile];
    const scalar arm = length_of(frame.anchor), speed = length_of(lane_of(translation.v_CM, at.lane));
    if (!is_dynamic(bodies, slot)) return h * (speed + arm * length_of(lane_of(rotation.L, at.lane)));  // see kinematic_motion.h
    const Vector inv_I = lane_of(rotation.inv_I_ratio, at.lane) * rotation.inv_I_scale[at.lane];
    const scalar turning = max(inv_I.x, max(inv_I.y, inv_I.z));
    const scalar v = speed + arm * turning * length_of(lane_of(rotation.L, at.lane));
    const scalar a = length_of(gravity) + translation.inv_M[at.lane] * length_of(lane_of(translation.F_T, at.lane)) +
                     arm * turning * length_of(lane_of(rotation.tau_T, at.lane));
    return h * (v + h * a);
}

}  // namespace

void look_at_ropes(const BodyView& bodies, const JointLists& lists, TieRecord* ties, int joint_slots, const Vector& gravity, scalar unit, scalar h) {
    for (int joint_i = 0; joint_i < joint_slots; ++joint_i) {  // bound: max_joints
        const JointRecord& joint = lists.joints[joint_i];
        TieRecord& tie = ties[joint_i];
        if (!has_length(joint.kind)) continue;
        const scalar most = limits::reel_speed * unit * h;
        tie.begin = tie.reeled;
        tie.reeled = max(tie.reeled - most, min(tie.reeled + most, tie.length));
        if (joint.kind != JointKind::rope) continue;
        const Vector apart = anchor_in_world(bodies, joint.body_B, joint.frame_B) - anchor_in_world(bodies, joint.body_A, joint.frame_A);
        const scalar way = way_of(bodies, joint.body_A, joint.frame_A, gravity, h) + way_of(bodies, joint.body_B, joint.frame_B, gravity, h);
        tie.slack = length_of(apart) + way < min(tie.begin, tie.reeled) ? 1 : 0;
    }
}

} }  // namespace ingot
