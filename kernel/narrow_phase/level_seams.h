// SPDX-License-Identifier: MIT
// Seams between levels, and between levels and fixed boxes, hulls and half spaces: by the law of inner_edges.h.
#pragma once

#include "collide_level.h"
#include "inner_edges.h"

namespace ingot { inline namespace INGOT_ABI {

/// One manifold with a fixed shape S, while its neighbours are asked; S or the neighbour is a level.
template <class Shapes>
class SeamPoints {
public:
    SeamPoints(const FixedNeighbours& neighbours, const FixedTouch& of)
        : neighbours_(neighbours), of_(of), S_(neighbours.all.placed(of.S)), body_(neighbours.all.placed(of.body)),
          flush_(flush_of(body_, neighbours.all.surfaces.unit)) {}

    /// Bits of the points that neighbours hide.
    unsigned hidden(const Manifold& manifold) const {
        if (!any_neighbour([](const PlacedShape&) { return true; })) return 0;
        const Vector d = manifold.n * of_.to_body;
        Vector middle{};
        Touch touches[Manifold::points_max];
        for (int i = 0; i < manifold.count; ++i) {  // bound: 4: Manifold::points_max
            touches[i] = touch_of(manifold.points[i], d);
            middle += touches[i].p * (1 / static_cast<scalar>(manifold.count));
        }
        unsigned hidden = 0;
        for (int i = 0; i < manifold.count; ++i) {
            Touch& touch = touches[i];
            Vector inwards = (manifold.count <= 2 ? touch.inner : middle) - touch.p;
            inwards = inwards - d * dot(d, inwards);
            const scalar way = sqrt(length_sq(inwards)), most = 4 * flush_;
            touch.inner = touch.p + inwards * (way > most ? most / way : scalar(1));
            if (is_hidden(touch, touch.p) && (!touch.face || is_hidden(touch, touch.inner))) hidden |= 1u << i;
        }
        return hidden;
    }

private:
    /// False for kinds that the scene does not name: what is for them is not linked.
    template <ShapeKind kind>
    static bool is_kind([[maybe_unused]] const PlacedShape& placed) {
        if constexpr (!Shapes::has(kind)) return false;
        return placed.shape.kind == kind;
    }
    /// Where a point is on S; whether d is the normal of a face there, and then a place on that face below the body.
    Touch touch_of(const ManifoldPoint& point, const Vector& d) const {
        Touch touch = {point.P - d * (point.separation * scalar(0.5)), d, is_side_of_body(body_, d) ? limits::face_tilt : limits::edge_tilt,
                       S_.shape.kind == ShapeKind::half_space, {}};
        touch.inner = S_.shape.kind == ShapeKind::half_space ? body_.r : S_.r;
        if (is_kind<ShapeKind::box>(S_)) {
            put_on_box(S_, touch);
            touch.inner = S_.r + S_.A * clamp(transpose_times(S_.A, body_.r - S_.r), S_.shape.size);
        }
        if (is_kind<ShapeKind::hull>(S_)) {
            Touch below_body = touch;
            below_body.p = body_.r;
            put_on_hull(S_, below_body);
            put_on_hull(S_, touch);
            touch.inner = below_body.p;
        }
        if (S_.shape.kind == ShapeKind::level) put_on_level(touch, max(point.separation, scalar(0)));
        return touch;
    }
    /// Of the triangles near by: is d the normal of one; or else, on which edge or corner does the point belong: a direction that was searched for
    /// has points that are off by millimetres, and by more the further apart they are. gap: m.
    void put_on_level(Touch& touch, scalar gap) const {
        const LevelTable& table = *Shapes::level_of(S_.shape);
        const LevelFrame frame(S_, table);
        const scalar near = 8 * (flush_ + gap);
        const Vector p = frame.seen_point(touch.p), d = frame.seen_direction(touch.d), reach = {near, near, near};
        scalar least = near * near, least_of_face = near * near;
        for_triangles_in(table, p - reach, p + reach, [&](const LevelTriangle& triangle) {
            TriangleFace face;
            if (!face_of_triangle(triangle, face)) return;
            const scalar rise = dot(face.n, d), away = length_sq(p - nearest_on_triangle(face, p, flush_).p);
            if (rise > 0 && length_sq(d - face.n * rise) <= touch.tilt * touch.tilt && away < least_of_face) {
                least_of_face = away;
                touch.face = true;
                touch.inner = frame.place(nearest_on_triangle(face, frame.seen_point(body_.r), 0).p);
            }
            const Vector on = put_on_triangle(face, p, d, touch.tilt).p;
            if (touch.face || !(length_sq(p - on) < least)) return;
            least = length_sq(p - on);
            touch.p = frame.place(on);
        });
    }

    bool is_hidden(const Touch& touch, const Vector& p) const {
        return any_neighbour([&](const PlacedShape& T) { return hides(T, touch, p); });
    }
    /// True where each(T) is, for one of the shapes that may be one floor with S by a level.
    template <class Each>
    bool any_neighbour(const Each& each) const {
        const ManifoldView& manifolds = neighbours_.manifolds;
        // bound: max_manifolds: each is in one chain
        for (int k = neighbours_.first; k != 0; k = manifolds.records[manifolds.pairs[k - 1].record].next_free) {
            const int T_slot = neighbours_.all.touch_of(manifolds.pairs[k - 1]).S;
            if (T_slot != of_.S && are_joined(T_slot) && each(neighbours_.all.placed(T_slot))) return true;
        }
        return false;
    }
    bool are_joined(int T_slot) const {
        const Shape& T = neighbours_.all.surfaces.surfaces[T_slot].shape;
        const ShapeKind kind = T.kind;
        if (S_.shape.kind == ShapeKind::level && kind == ShapeKind::level && of_.S - patch_number(S_.shape) == T_slot - patch_number(T))
            return false;  // patches of one level have been told apart by their own triangles
        if (S_.shape.kind == ShapeKind::level && is_ground(kind)) return bounds_overlap(neighbours_.all.bounds, of_.S, T_slot);
        return (S_.shape.kind == ShapeKind::level || kind == ShapeKind::level) && neighbours_.all.are_one_floor(of_.S, T_slot);
    }
    bool hides(const PlacedShape& T, const Touch& touch, const Vector& p) const {
        if (T.shape.kind == ShapeKind::level) return is_hidden_by_level(T, touch, p);
        if (is_kind<ShapeKind::box>(T)) return hidden_by_box(T, touch, p, flush_);
        if (is_kind<ShapeKind::hull>(T)) return hidden_by_hull(T, touch, p, flush_);
        return is_kind<ShapeKind::half_space>(T) && hidden_by_half_space(T, touch, p, flush_);
    }
    bool is_hidden_by_level(const PlacedShape& T, const Touch& touch, const Vector& p) const {
        const LevelTable& table = *Shapes::level_of(T.shape);
        const LevelFrame frame(T, table);
        return hidden_by_level(table, frame.seen_point(p), frame.seen_direction(touch.d), touch.tilt, flush_);
    }

    const FixedNeighbours& neighbours_;
    const FixedTouch of_;
    const PlacedShape S_, body_;
    scalar flush_;
};

/// Drops the points that other fixed shapes hide, where one of the two is a level. See drop_hidden_points.
template <class Shapes>
void drop_points_at_seams(const FixedShapes& all, const PairList& found, Index* last_of_shape, const ManifoldView& manifolds) {
    if (!chain_fixed_touches(all, last_of_shape, manifolds)) return forget_fixed_touches(last_of_shape, manifolds);
    // bound: max_manifolds
    for (int i = 0; i < *manifolds.count; ++i) {
        const FixedTouch touch = all.touch_of(manifolds.pairs[i]);
        if (touch.S < 0) continue;
        ManifoldRecord& record = manifolds.records[manifolds.pairs[i].record];
        const FixedNeighbours neighbours{all, manifolds, last_of_shape[touch.body]};
        if (record.manifold.count == 0 || (neighbours.first == i + 1 && record.next_free == 0)) continue;
        const unsigned hidden = SeamPoints<Shapes>(neighbours, touch).hidden(record.manifold);
        if (hidden == 0) continue;
        drop_points(hidden, record);
        if (manifolds.anchors != nullptr) manifolds.anchors[manifolds.pairs[i].record].margin = 0;
    }
    end_fixed_chains(all, found, last_of_shape, manifolds);
}

} }  // namespace ingot
