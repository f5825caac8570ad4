// SPDX-License-Identifier: MIT
#pragma once

#include "../broad_phase/body_pairs.h"
#include "../math/sqrt.h"
#include "../shape/surface.h"
#include "manifold.h"
#include "manifold_anchors.h"

namespace ingot { inline namespace INGOT_ABI {

/// What a world keeps of two bodies that touch, for as long as they do: where, and with what impulses.
struct ManifoldRecord {
    Manifold manifold;
    scalar mu, e;                                        ///< of the pair
    scalar j[Manifold::points_max];                      ///< N s, of the normals in the last substep
    scalar j_before[Manifold::points_max];               ///< N s, in the one before
    Vector j_friction;                                   ///< N s, world
    scalar j_torsion;                                      ///< N m s
    uint16_t substeps;                                   ///< it has lived, up to 1000; and steady_bit
    Index next_free;                                  ///< index + 1 of the next free record; 0: none
};

/// Set in ManifoldRecord::substeps where nothing that touched accelerated in the step before.
inline constexpr uint16_t steady_bit = 0x8000;
inline int age_of(const ManifoldRecord& record) { return record.substeps & ~steady_bit; }
inline bool was_steady(const ManifoldRecord& record) { return (record.substeps & steady_bit) != 0; }

/// N s; with which its points pressed at the end of the last step.
inline scalar load_of(const ManifoldRecord& record) {
    scalar load = 0;
    for (int row = 0; row < record.manifold.count; ++row) load += record.j[row];  // bound: 4: Manifold::points_max
    return load;
}

/// The contacts of a world, without their capacity.
struct ManifoldView {
    BodyPair* pairs;              ///< that touch, sorted by slots; room for as many as records
    Index* count;
    ManifoldRecord* records;      ///< of the pairs, in no order
    ManifoldAnchors* anchors;     ///< by record; null where a scene renews none
    Index* records_used;       ///< records in use or free again; those beyond never were
    Index* first_free;         ///< index + 1
    int capacity;
};

/// After a search: found pairs that touched in the step before have their record, and records of pairs that are found no more are free.
/// Both lists are sorted; the work is one walk along them.
void match_records(const ManifoldView& manifolds, const PairList& found);

/// A record for a pair that begins to touch, all zero; no_record when there is none left.
Index take_record(const ManifoldView& manifolds);
/// The pair touches no more.
void give_back(const ManifoldView& manifolds, Index& record);

/// A body leaves its slot: nothing is kept of its contacts, and whoever takes the slot next is searched for anew.
void invalidate_contacts(const ManifoldView& manifolds, const PairList& found, BoundsTile* bounds, int slot);

/// Restitution of a pair is the greater of the two; friction their geometric mean. A, B: what has an e and a mu.
template <class Of_A, class Of_B>
INGOT_INLINE void mix_materials(const Of_A& A, const Of_B& B, ManifoldRecord& record) {
    record.e = A.e > B.e ? A.e : B.e;
    record.mu = sqrt(A.mu * B.mu);
}
INGOT_INLINE void mix_materials(const SurfaceView& surfaces, const BodyPair& pair, ManifoldRecord& record) {
    mix_materials(surfaces.surfaces[pair.body_A], surfaces.surfaces[pair.body_B], record);
}

/// Contacts that are held, of a shape whose surface has changed, take it as it is now.
void mix_materials_of(const SurfaceView& surfaces, const ManifoldView& manifolds, int shape_slot);

/// What was found, and zero where it has no point: equal worlds are equal bytes, and a snapshot holds nothing of the stack.
void keep_manifold(const Manifold& found, Manifold& kept);

/// Before the next manifold takes the place of the one on record: impulses of points whose features live on go with them; new points start from zero.
void carry_impulses(ManifoldRecord& record, const Manifold& next);

} }  // namespace ingot
