// SPDX-License-Identifier: MIT
// Everything the many-body solver works on, without its capacities.
#pragma once

#include "../base/limits.h"
#include "../narrow_phase/manifold_record.h"
#include "contact_block.h"

namespace ingot { inline namespace INGOT_ABI {

/// Lanes of one block that are solved together: they share no body that can move.
struct Visit {
    uint16_t block, lane_bits;
    uint16_t first;  ///< of its first manifold: how many of the same colour come before
};

struct SolverView {
    static constexpr bool rolls = false, has_belts = false;  ///< see material_view.h

    const BodyPair* pairs;     ///< that touch, sorted by slots
    ManifoldRecord* records;   ///< of the pairs
    int manifold_count;

    ContactBlock* blocks;      ///< room for manifold capacity / lanes, rounded up
    Visit* visits;             ///< room for manifold capacity + blocks
    uint16_t* order;           ///< of manifolds, by level and colour: what each lane of each block holds, or no_manifold
    uint16_t* level;           ///< by manifold
    uint16_t *other_order, *level_order;  ///< for sorting

    SolverBody* bodies;        ///< [0] stands for all that cannot move and for spare lanes
    SolverBodyHistory* histories;
    uint16_t* slot_of;         ///< by solver body
    uint16_t* local_of;        ///< by body slot, of bodies with a manifold; 0: immovable, or gone bad
    uint16_t* level_of_body;   ///< by solver body
    uint32_t* colours_of_body; ///< by solver body, within the level at hand
    int body_count;            ///< solver bodies in use, [0] included
    int visit_count, block_count;
    int central_count;         ///< manifolds whose normals go through both centres of mass
    int level_count;           ///< the longest way to the ground, in contacts
    int lane_count, lane_capacity;  ///< of all blocks
    scalar speed_max;          ///< m/s, of the bodies in this substep, up to limits::rounding_speed_max
    bool some_hit;             ///< a body was hit in the substep before
    int substeps;              ///< of this step: limits::substeps, or limits::steady_substeps
    bool steady;               ///< nothing that touches has accelerated in this step
};

/// True for a body that is solved in this step. What local_of says of others is of an earlier one.
inline bool is_taken_in(const SolverView& solver, int slot) {
    const int local = solver.local_of[slot];
    return local != 0 && local < solver.body_count && solver.slot_of[local] == slot;
}

/// Impulses are kept as they are in a step of limits::substeps substeps; a longer one has so many times as much.
inline scalar shares_of_substep(const SolverView& solver) { return static_cast<scalar>(limits::substeps / solver.substeps); }

} }  // namespace ingot
