// SPDX-License-Identifier: MIT
// Who changes a body calls wake_touching: a body that something is done to wakes.
//
// The manifolds of an island come back as it wakes. They are put behind those of the step, out of order; World sorts them in: see sort_in_tail.
#pragma once

#include "../narrow_phase/manifold_record.h"
#include "../island/rest_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// A body comes into its slot: awake, an island of its own.
void begin_awake(const RestView& rest, int slot);

/// Wakes the whole island of a body that can move. A body that is awake already only begins its time of rest anew.
/// Cost: O(bodies and manifolds of the island).
void wake_island(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot);

/// Something was done to the body of the slot: its island wakes. Of an immovable body every island wakes that has a manifold with it, now or in the
/// next step.
/// Cost: that of wake_island; O(manifolds) more for a body that cannot move.
void wake_touching(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot);

/// As wake_touching, of a body that leaves its slot.
void wake_touching_and_leave(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot);

/// For a change that all bodies feel.
void wake_all(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds);

/// Wakes every island that has a manifold with a body that is awake. No manifold then has one body awake and the other asleep. So no body that moves
/// can meet one that sleeps in this step, however it is hit meanwhile.
void wake_met_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds);

/// The pairs that a step has to solve: those with a body that moves, in their order, by the slots of bodies.
void list_awake_pairs(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, BodyPair* awake_pairs, Index& count);

} }  // namespace ingot
