// SPDX-License-Identifier: MIT
#pragma once

#include "../narrow_phase/manifold_record.h"
#include "rest_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Joins the bodies of all manifolds of the step. Two bodies that can move and have a manifold belong to one island, whether they touch already or
/// may only meet within the step. Immovable bodies join nothing. Islands that sleep keep their trees; one that meets a settling body takes it in.
///
/// Needs:  manifolds after update_manifolds. The root of an island is its lowest slot, whatever the order of manifolds.
/// Cost:   near-linear in bodies that are active and their manifolds: union-find with halved paths.
/// Source: Tarjan and van Leeuwen 1984, path halving; without ranks, so logarithmic at worst in the mean, and never recursive.
void join_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds);

/// Two bodies that hang together by something else than a manifold: after join_islands.
void join_bodies_of(const RestView& rest, int slot_A, int slot_B);

/// The same for all bodies, whether they are active or not: after a snapshot.
void join_all_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds);

} }  // namespace ingot
