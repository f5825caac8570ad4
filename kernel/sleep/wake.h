// SPDX-License-Identifier: MIT
#pragma once

#include "../narrow_phase/manifold_record.h"
#include "../island/rest_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// A body comes into its slot: awake, an island of its own.
void begin_awake(const RestView& rest, int slot);

/// Wakes one body, and no other of its island. A rotation that keeps the energy of its flight begins a new flight.
void wake_body(const BodyView& bodies, const RestView& rest, int slot);

/// Wakes the island of a body that can move; one that is awake is only taken for fast once.
/// Cost: O(bodies) when it sleeps.
void wake_island(const BodyView& bodies, const RestView& rest, int slot);

/// Something was done to the body of the slot: its island wakes; if it cannot move, all that have a manifold with it do, and in the next
/// step what has one then.
/// Cost: O(bodies), and O(manifolds) for a body that cannot move; O(bodies manifolds) at worst, where many islands lie on it.
void wake_touching(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot);

/// As stir, of a body that leaves its slot.
void wake_touching_and_leave(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot);

/// For a change that all bodies feel.
void wake_all(const BodyView& bodies, const RestView& rest);

/// Wakes every island that has a manifold with what is awake. So in the step at hand nothing that moves can meet what sleeps, however it is hit
/// meanwhile: no manifold has one body awake and the other asleep.
void wake_met_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds);

/// The pairs of which a body moves, in their order: those that a step has to solve.
void list_awake_pairs(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, BodyPair* awake_pairs, uint16_t& count);

} }  // namespace ingot
