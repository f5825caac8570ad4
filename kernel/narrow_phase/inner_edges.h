// SPDX-License-Identifier: MIT
// Edges inside a floor of several fixed shapes: contacts that the neighbours of a shape make impossible are dropped.
//
// A contact at p along d is real only if d is in the normal cone, at p, of the union of all that is fixed; where shapes share p that is the
// intersection of their cones. So a contact with S stays if every other fixed T that reaches p has d in its cone as well. T is any other fixed
// shape that the same body has a manifold with: one that reaches p is as near to the body as p is.
#pragma once

#include "find_manifolds.h"
#include "normal_cone.h"

namespace ingot { inline namespace INGOT_ABI {

/// Who touches whom, in a manifold with a fixed shape.
struct FixedTouch {
    int S, body;     ///< shape slots; S is -1 where neither is fixed
    scalar to_body;  ///< +1 or -1: times n it is d
};

/// Who stands still, and how the surfaces of what stands still move.
struct FixedShapes {
    BodyView shapes;  ///< as bodies
    SurfaceView surfaces;
    const BoundsTile* bounds;
    HullTable hulls;
    const Vector* velocities;  ///< m/s, of belts, in the shape's axes, by shape slot; null where there are none

    FixedTouch touch_of(const BodyPair& pair) const;
    PlacedShape placed(int slot) const;
    /// They are near each other, one of them has edges, and they move alike: who passes from a belt to what moves otherwise feels the edge.
    bool are_one_floor(int S, int T) const;
};

/// The manifolds of one body with fixed shapes: a chain through their records, whose next_free is free while they are not.
struct FixedNeighbours {
    const FixedShapes& all;
    const ManifoldView& manifolds;
    int first;  ///< 1 + its place in the list; 0: none

    /// True where each(slot) is, for one of the shapes that are one floor with S.
    template <class Each>
    bool any(int S, const Each& each) const {
        // bound: max_manifolds: each is in one chain
        for (int k = first; k != 0; k = manifolds.records[manifolds.pairs[k - 1].record].next_free) {
            const int T = all.touch_of(manifolds.pairs[k - 1]).S;
            if (T != S && all.are_one_floor(S, T) && each(T)) return true;
        }
        return false;
    }
};

/// One manifold with a fixed shape S, while its neighbours are asked.
class HiddenPoints {
public:
    HiddenPoints(const FixedNeighbours& neighbours, const FixedTouch& of);

    /// Bits of the points that neighbours hide.
    unsigned hidden(const Manifold& manifold) const;

    /// Where all points are hidden, another direction may be open that separated less: the best of the faces of S that are not covered. The points
    /// are those that the body has above the plane of the face, as far as they are above S; its origin has to be above it too, or it would be pushed
    /// through S.
    /// False where there are none. Directions of nearest points are the only ones; those of separating axes, and of what overlaps, are not.
    /// Cost: up to a face of S, a half space each.
    template <class Shapes>
    bool turn_to_face(Manifold& manifold) const {
        const Vector d = manifold.n * of_.to_body;
        const scalar least_before = least_separation(manifold);
        const scalar margin = max(least_before, 0) + limits::contact_margin * neighbours_.all.surfaces.unit;
        if (is_nearest(least_before)) return false;
        scalar best = least_before > -flush_ ? -flush_ : -scalar_max;
        bool turned = false;
        // bound: 2 limits::hull_vertices_max - 4
        for (int face_i = 0; face_i < face_count(S_); ++face_i) {
            const FaceOfFixed face = face_of(S_, face_i);
            if (dot(face.n, d) < -limits::edge_tilt || !(dot(face.n, body_.r - S_.r) > face.offset)) continue;
            Manifold above;
            above.n = {};
            above.count = 0;
            const PlacedShape plane = {HalfSpace{face.n, 0}, S_.r + face.n * face.offset, identity_matrix<scalar>(), nullptr};
            (void)collide_with_half_space<Shapes>(body_, plane, margin, above, &no_manifold_before);
            turned = take_open(face_i, above, best, manifold) || turned;
        }
        return turned;
    }

private:
    static constexpr uint32_t turned_feature = 0xff000000u;  ///< of no other manifold

    bool is_nearest(scalar least) const;
    bool take_open(int face_i, Manifold& above, scalar& best, Manifold& manifold) const;
    void put_on_fixed(const Manifold& manifold, Touch (&touches)[Manifold::points_max]) const;
    Vector middle_below() const;
    bool is_beside(const Manifold& manifold, const Touch& touch) const;
    bool holds(const Vector& p) const;
    bool hides(const PlacedShape& T, const Touch& touch, const Vector& p) const;

    const FixedNeighbours& neighbours_;
    const FixedTouch of_;
    const PlacedShape S_, body_;
    scalar flush_;
};

/// Chains the manifolds of each body with fixed shapes. True where some body has more than one.
bool chain_fixed_touches(const FixedShapes& all, Index* last_of_shape, const ManifoldView& manifolds);

/// Undoes chains of one.
void forget_fixed_touches(Index* last_of_shape, const ManifoldView& manifolds);
/// Undoes the chains, and ends manifolds that have no points left.
void end_fixed_chains(const FixedShapes& all, const PairList& found, Index* last_of_shape, const ManifoldView& manifolds);

/// Takes points out of a manifold; their impulses go with them.
void drop_points(unsigned hidden, ManifoldRecord& record);

/// Drops the points that other fixed shapes hide; a manifold without points ends.
///
/// A manifold that has lost points is searched for anew in the next step: what is moved along is what was found, and all of it is asked again.
/// last_of_shape: by shape slot, zero before and after: 1 + the place in the list of the last manifold of that shape with a fixed one.
/// Cost: two looks at each manifold; of a body on k fixed shapes, k^2 tests of bounds.
template <class Shapes>
void drop_hidden_points(const FixedShapes& all, const PairList& found, Index* last_of_shape, const ManifoldView& manifolds) {
    if constexpr (!Shapes::has(ShapeKind::box) && !Shapes::has(ShapeKind::hull)) return;  // nothing has edges, nothing that asks for them is linked
    if (!chain_fixed_touches(all, last_of_shape, manifolds)) return forget_fixed_touches(last_of_shape, manifolds);
    // bound: max_manifolds
    for (int i = 0; i < *manifolds.count; ++i) {
        const FixedTouch touch = all.touch_of(manifolds.pairs[i]);
        if (touch.S < 0) continue;
        if constexpr (Shapes::has(ShapeKind::level))
            if (all.surfaces.surfaces[touch.S].shape.kind == ShapeKind::level) continue;  // see level_seams.h
        ManifoldRecord& record = manifolds.records[manifolds.pairs[i].record];
        const FixedNeighbours neighbours{all, manifolds, last_of_shape[touch.body]};
        if (neighbours.first == i + 1 && record.next_free == 0) continue;
        const HiddenPoints points(neighbours, touch);
        const unsigned hidden = points.hidden(record.manifold);
        if (hidden == 0) continue;
        Manifold turned = record.manifold;
        if (hidden == (1u << record.manifold.count) - 1u && points.turn_to_face<Shapes>(turned)) {
            carry_impulses(record, turned);
            keep_manifold(turned, record.manifold);
        } else {
            drop_points(hidden, record);
        }
        if (manifolds.anchors != nullptr) manifolds.anchors[manifolds.pairs[i].record].margin = 0;
    }
    end_fixed_chains(all, found, last_of_shape, manifolds);
}

} }  // namespace ingot
