// SPDX-License-Identifier: MIT
#pragma once

#include "../joint/joint_lists.h"
#include "../joint/tie_record.h"

namespace ingot { inline namespace INGOT_ABI {

/// Before a step of h seconds: rods and ropes are reeled in or out, by limits::reel_speed at most, and ropes that cannot come to their ends in it are
/// slack: they are left out of the step, so their bodies move as if there were none. Speeds and forces are those of the begin of the step; a body
/// that a contact throws further comes to the end of its rope a step late. unit: m, of length.
void look_at_ropes(const BodyView& bodies, const JointLists& lists, TieRecord* ties, int joint_slots, const Vector& gravity, scalar unit, scalar h);

} }  // namespace ingot
