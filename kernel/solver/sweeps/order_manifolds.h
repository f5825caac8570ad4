// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/jointed_view.h"

namespace ingot { inline namespace INGOT_ABI {

inline constexpr int contact_colours = 32;  ///< of a level; a contact that finds none free is by itself
inline constexpr Index unreached_level = index_max;  ///< of a body from which no contacts lead to the ground

/// The levels of all bodies: their distance from a body that cannot move, in contacts. The level of a manifold is the lower one of its two bodies'; 0
/// where no way leads to the ground.
/// Bound: limits::level_passes_max passes over the manifolds (a quality, not a condition).
/// Joints: JointedBodies, whose figures count as one body, or NoJointedBodies.
template <class Joints>
void find_levels(const SolverView& solver, const Joints& jointed);

/// Puts the manifolds of the batch in the order of the sweeps, and into blocks: by level (contacts from the ground up), and by colour
/// within a level (no two of a colour share a body that can move, so one vector instruction solves `lanes` of them, of whatever islands).
/// The order within an island depends neither on `lanes` nor on the other islands.
///
/// Sweeps that go up and down the levels carry the weight of a pile to the ground and back in one pass each.
/// Manifolds of bodies with joints come last among the blocks, from JointedBodies::first_block on, and in their places among the visits.
/// Needs: find_levels. Cost: sorting by counting.
template <class Joints>
void order_manifolds(SolverView& solver, Joints& jointed);

/// The manifolds of each island of the batch, as positions in the blocks, in the order of the sweeps.
void list_members(const SolverView& solver);

} }  // namespace ingot
