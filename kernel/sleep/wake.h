// SPDX-License-Identifier: MIT
// Whatever is done to a body that is not the one at hand goes through wake_touching: what it does to wakes.
//
// Waking brings the manifolds of the island back: they are put behind those of the step, out of order. World sorts them in: see sort_in_tail.
#pragma once

#include "../narrow_phase/manifold_record.h"
#include "../island/rest_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// A body comes into its slot: awake, an island of its own.
void begin_awake(const RestView& rest, int slot);

/// Wakes the island of a body that can move, all of it; one that is awake is only taken for fast once.
/// Cost: O(bodies and manifolds of the island).
void wake_island(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot);

/// Something was done to the body of the slot: its island wakes; if it cannot move, all that have a manifold with it do, and in the next
/// step what has one then.
/// Cost: that of wake_island; O(manifolds) more for a body that cannot move.
void wake_touching(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot);

/// As wake_touching, of a body that leaves its slot.
void wake_touching_and_leave(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot);

/// For a change that all bodies feel.
void wake_all(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds);

/// Wakes every island that has a manifold with what is awake. So in the step at hand nothing that moves can meet what sleeps, however it is hit
/// meanwhile: no manifold has one body awake and the other asleep.
void wake_met_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds);

/// The pairs of which a body moves, in their order, by the slots of bodies: those that a step has to solve.
void list_awake_pairs(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, BodyPair* awake_pairs, uint16_t& count);

} }  // namespace ingot
