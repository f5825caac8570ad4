// SPDX-License-Identifier: MIT
// Which joints a body has.
#pragma once

#include "../body/body_tiles.h"
#include "joint_record.h"

namespace ingot { inline namespace INGOT_ABI {

/// m, world. slot: of the body of the frame; no_body: the world.
inline Vector anchor_in_world(const BodyView& bodies, Index slot, const JointFrame& frame) {
    if (slot == no_body) return frame.anchor;
    return r_CM_of(bodies, slot) + lane_of(bodies.rotation[place_of(slot).tile].A, place_of(slot).lane) * frame.anchor;
}

/// The same point in the axes of the body.
inline Vector anchor_on(const BodyView& bodies, Index slot, const Vector& P) {
    if (slot == no_body) return P + Vector{};
    return transpose_times(lane_of(bodies.rotation[place_of(slot).tile].A, place_of(slot).lane), P - r_CM_of(bodies, slot)) + Vector{};
}

/// The ends of joints at each body, a list in the order of joints: end 2 i is A of joint i, end 2 i + 1 its B. All zero: no joints.
struct JointLists {
    JointRecord* joints;
    Index* first_end;  ///< by slot: end + 1; 0: none
    Index* next_end;   ///< by end: the same

    Index body_of(int end) const { return end % 2 == 0 ? joints[end / 2].body_A : joints[end / 2].body_B; }
    Index partner_of(int end) const { return body_of(end ^ 1); }

    /// Calls each(end) for the joints of a body.
    template <class Each>
    INGOT_INLINE void for_ends(Index slot, const Each& each) const {
        // bound: max_joints: a list of ends of different joints
        for (Index end = first_end[slot]; end != 0; end = next_end[end - 1]) each(end - 1);
    }

    /// A joint comes, whose record is there; or is about to go.
    void link(int joint_i) const {
        for (int end = 2 * joint_i; end < 2 * joint_i + 2; ++end) {  // bound: 2
            Index* at = head_of(end);
            if (at == nullptr) continue;
            while (*at != 0 && *at - 1 < end) at = &next_end[*at - 1];  // bound: max_joints
            next_end[end] = *at;
            *at = static_cast<Index>(end + 1);
        }
    }
    void unlink(int joint_i) const {
        for (int end = 2 * joint_i; end < 2 * joint_i + 2; ++end) {  // bound: 2
            Index* at = head_of(end);
            if (at == nullptr) continue;
            while (*at != end + 1) at = &next_end[*at - 1];  // bound: max_joints: it is in the list
            *at = next_end[end];
            next_end[end] = 0;
        }
    }

    /// Whether a joint between the two keeps them from touching.
    bool keeps_apart(Index slot_A, Index slot_B) const {
        bool apart = false;
        for_ends(slot_A, [&](int end) { apart = apart || (partner_of(end) == slot_B && joints[end / 2].bodies_meet == 0); });
        return apart;
    }

private:
    Index* head_of(int end) const { return body_of(end) == no_body ? nullptr : &first_end[body_of(end)]; }
};

/// Filters of a scene, and those of joints.
template <class Filters, int shapes_of_body>
struct JointFilters {
    Filters filters;
    JointLists lists;

    auto of(int slot) const { return filters.of(slot); }
    bool let_meet(int slot_A, int slot_B) const {
        return filters.let_meet(slot_A, slot_B) &&
               !lists.keeps_apart(static_cast<Index>(slot_A / shapes_of_body), static_cast<Index>(slot_B / shapes_of_body));
    }
};

} }  // namespace ingot
