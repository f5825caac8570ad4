// SPDX-License-Identifier: MIT
// The features there are. Their order is that of their memory in a world, of their numbers in a snapshot, and of their places in a signature: a new
// one comes last, and what does not name it stays as it was, to the byte.
#pragma once

#include "axis_locks.h"
#include "body_traits.h"
#include "compensated_sums.h"
#include "contact_effort.h"
#include "figure_motion.h"
#include "gravity_shares.h"
#include "joint_drives.h"
#include "joint_limits.h"
#include "joint_loops.h"
#include "joint_reactions.h"
#include "joint_ties.h"
#include "joints.h"
#include "kinematic_bodies.h"
#include "materials.h"
#include "levels.h"
#include "motion.h"
#include "reads_contacts.h"
#include "sensors_and_events.h"
#include "shapes.h"
#include "shared_work.h"
#include "sleep.h"
#include "work_budget.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

using All = FeatureList<Rotation, Translation, Compensation, EnergyReturn, FieldOfForce, Surfaces, Compounds, Impacts, Manifolds, Unsettled,
                        RollingResistance, Belts, Filters, Sensors, Continuous, Events, ToldEvents, Sleep, GravityShares, TouchAside, SteadyField,
                         UserData, BodyForces, BodyDamping, ReadsContacts, CompensatedSums, KinematicBodies, WorkBudget, ContactEffort, Figures,
                         MovingJoints, LimitedJoints, DrivenJoints, LoopJoints, FigureMotion, ReadReactions, BreakableJoints, TiedJoints,
                         DrawnBodies, LockedAxes, Levels, GearedJoints, SharedWork>;

static_assert(All::bits_differ(SnapshotPart::doubles | SnapshotPart::anchors));  // of a snapshot's parts

}  // namespace features

/// Turns a scene that contradicts itself into a sentence.
template <class S>
constexpr bool check_scene() {
    bool sound = true;
    features::All::over_all([&sound](auto feature) { sound = decltype(feature)::template check<S>() && sound; });
    return sound;
}

} }  // namespace ingot
