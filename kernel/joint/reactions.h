// SPDX-License-Identifier: MIT
// What joints bear, and what they break at. In scenes that name WithReactions or WithBreaking among their joints.
#pragma once

#include "../base/status.h"
#include "joints.h"

namespace ingot { inline namespace INGOT_ABI {

/// What the locked directions of a joint gave to B, and against it to A, or to the world: the mean of the last step, world axes, about the anchor of
/// B. Without what drives and limits gave along free directions. Where joints of a loop say the same, as two hinges of one door do, how they share
/// it is not determined.
struct JointReaction {
    Vector force{};   ///< N
    Vector torque{};  ///< N m
};

/// What a joint bears at most: with more of either, as the mean of a step, it breaks at the end of that step.
struct JointStrength {
    scalar force = unlimited;   ///< N; 0 or more
    scalar torque = unlimited;  ///< N m; 0 or more
};

/// A joint that broke in the last step, and what it bore in it.
struct JointBreak {
    JointId joint{};           ///< until it is removed, or enabled again
    JointReaction reaction{};  ///< more than its JointStrength
};

/// Of impulses, N s and N m s, of a step of h seconds; nothing of bodies that have gone bad.
inline JointReaction mean_of_step(const JointReaction& impulses, scalar h) {
    const JointReaction mean = {impulses.force * (1 / h), impulses.torque * (1 / h)};
    return is_finite(mean.force) && is_finite(mean.torque) ? mean : JointReaction{};
}

/// Errors: not_finite, out_of_range (less than 0).
inline Status check_strength(const JointStrength& strength) {
    if (!is_finite(strength.force) || !is_finite(strength.torque)) return Status::not_finite;
    return strength.force >= 0 && strength.torque >= 0 ? Status::ok : Status::out_of_range;
}

inline bool breaks_under(const JointReaction& reaction, const JointStrength& strength) {
    return length_sq(reaction.force) > strength.force * strength.force || length_sq(reaction.torque) > strength.torque * strength.torque;
}

enum class JointPhase : uint8_t { works, disabled, broken, breaks };

/// What a world keeps of a joint that may break. Written by members: it has a gap. Of one that does nothing, JointRecord::kind is none.
struct BreakRecord {
    JointStrength strength{0, 0};  ///< zeros of what holds no joint: a world is all zero as it begins
    JointKind kind{};    ///< of one that does nothing
    JointPhase phase{};  ///< breaks: it broke in the last step
};
INGOT_INLINE void write_record(BreakRecord& to, const BreakRecord& record) {
    to.strength = record.strength;
    to.kind = record.kind;
    to.phase = record.phase;
}

} }  // namespace ingot
