// SPDX-License-Identifier: MIT
// What a step leaves out where bodies are at rest.
#pragma once

#include "../constraint/impact_note.h"
#include "../narrow_phase/manifold_record.h"
#include "../broad_phase/body_bounds.h"
#include "../island/awake_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// True when a step has nothing to do for any body. The first step after a snapshot makes all bounds, for whoever wakes later.
bool all_at_rest(const RestView& rest, const BoundsTile* bounds, int tile_count);

/// The rules of the scene for pairs; and the manifold of two bodies at rest is kept as it is, or there still is none.
template <class Rules>
struct RulesOfRest : Rules {
    RestView rest;

    bool keeps(const BodyPair& pair) const { return !rest.is_active(pair.body_A) && !rest.is_active(pair.body_B); }
};

/// refresh_bounds for bodies that stir, and after a snapshot for all; the others have theirs.
bool refresh_active_bounds(const BodyView& bodies, const SurfaceView& surfaces, scalar h, const RestView& rest, BoundsTile* bounds);

/// Notes of the pairs that a step has solved, from the order of those to that of all manifolds, in place. The others have nothing to tell.
void spread_notes(const ManifoldView& manifolds, const BodyPair* awake_pairs, int awake_count, ImpactNote* notes);

} }  // namespace ingot
