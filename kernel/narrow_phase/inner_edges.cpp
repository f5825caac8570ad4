// SPDX-License-Identifier: MIT
#include "inner_edges.h"

#include "contact_patch.h"

namespace ingot { inline namespace INGOT_ABI {

FixedTouch FixedShapes::touch_of(const BodyPair& pair) const {
    const auto is_fixed = [this](int slot) {
        const Place at = place_of(slot);
        return !(shapes.translation[at.tile].inv_M[at.lane] > 0);
    };
    if (is_fixed(pair.body_B)) return {pair.body_B, pair.body_A, 1};
    return {is_fixed(pair.body_A) ? pair.body_A : -1, pair.body_B, -1};
}

PlacedShape FixedShapes::placed(int slot) const {
    const Shape& shape = surfaces.surfaces[slot].shape;
    const BodyFrame frame = frame_of(shapes, slot);
    return {shape, frame.r, frame.A, shape.kind == ShapeKind::hull ? hulls.hulls + static_cast<int>(shape.size.y) : nullptr};
}

bool FixedShapes::are_one_floor(int S, int T) const {
    const auto has_edges = [this](int slot) {
        const ShapeKind kind = surfaces.surfaces[slot].shape.kind;
        return kind == ShapeKind::box || kind == ShapeKind::hull;
    };
    if (!(has_edges(S) || has_edges(T)) || !bounds_overlap(bounds, S, T)) return false;
    if (velocities == nullptr) return true;
    const Vector v_S = frame_of(shapes, S).A * velocities[S], v_T = frame_of(shapes, T).A * velocities[T];
    return length_sq(v_S - v_T) <= limits::edge_tilt * limits::edge_tilt * length_sq(v_S);
}

HiddenPoints::HiddenPoints(const FixedNeighbours& neighbours, const FixedTouch& of)
    : neighbours_(neighbours), of_(of), S_(neighbours.all.placed(of.S)), body_(neighbours.all.placed(of.body)),
      flush_(limits::flush_gap * neighbours.all.surfaces.unit) {
    const scalar R_S = bounding_radius(S_.shape), R = bounding_radius(body_.shape);
    flush_ = min(flush_, limits::flush_share * (R_S > 0 ? min(R_S, R) : R));
}

unsigned HiddenPoints::hidden(const Manifold& manifold) const {
    Touch touches[Manifold::points_max];
    put_on_fixed(manifold, touches);
    const bool beside = is_beside(manifold, touches[0]);
    const unsigned every = (1u << manifold.count) - 1u;
    unsigned hidden = 0, hidden_inside = 0;
    (void)neighbours_.any(of_.S, [&](int T_slot) {
        if (beside) hidden = hidden_inside = every;
        const PlacedShape T = neighbours_.all.placed(T_slot);
        for (int i = 0; i < manifold.count; ++i) {  // bound: 4: Manifold::points_max
            if (hides(T, touches[i], touches[i].p)) hidden |= 1u << i;
            if (!touches[i].face || hides(T, touches[i], touches[i].inner)) hidden_inside |= 1u << i;
        }
        return (hidden & hidden_inside) == every;
    });
    return hidden & hidden_inside;
}

/// True where no other direction can separate: that of a manifold of shapes that are apart, but for two boxes, is that of their nearest points.
bool HiddenPoints::is_nearest(scalar least) const {
    return least > -flush_ && !(S_.shape.kind == ShapeKind::box && body_.shape.kind == ShapeKind::box);
}

/// Of points above a face, takes those that are above S and not hidden, if they separate by more than `best`.
bool HiddenPoints::take_open(int face_i, Manifold& above, scalar& best, Manifold& manifold) const {
    const Vector n = above.n;
    int kept = 0;
    scalar least = scalar_max;
    for (int i = 0; i < above.count; ++i) {  // bound: 4: Manifold::points_max
        ManifoldPoint point = above.points[i];
        const Touch touch = {point.P - n * (point.separation * scalar(0.5)), n, limits::edge_tilt, false, {}};
        if (!holds(touch.p) || neighbours_.any(of_.S, [&](int T) { return hides(neighbours_.all.placed(T), touch, touch.p); })) continue;
        least = min(least, point.separation);
        point.feature |= turned_feature | static_cast<uint32_t>(face_i) << 16;
        above.points[kept++] = point;
    }
    if (kept == 0 || !(least > best)) return false;
    best = least;
    above.count = static_cast<int8_t>(kept);
    above.halvings = manifold.halvings;
    above.n = n * of_.to_body;
    keep_manifold(above, manifold);
    return true;
}

/// Where the points are on S. A face that ends at the foot of a wall is open beside the wall, and one that ends in a lip is open at the lip: it is
/// asked for p, and for a place a little further inside.
void HiddenPoints::put_on_fixed(const Manifold& manifold, Touch (&touches)[Manifold::points_max]) const {
    const Vector d = manifold.n * of_.to_body;
    const scalar tilt = is_side_of_body(body_, d) ? limits::face_tilt : limits::edge_tilt;
    Vector middle{};
    for (int i = 0; i < manifold.count; ++i) {  // bound: 4: Manifold::points_max
        const ManifoldPoint& point = manifold.points[i];
        touches[i] = {point.P - d * (point.separation * scalar(0.5)), d, tilt, S_.shape.kind == ShapeKind::half_space, {}};
        if (S_.shape.kind == ShapeKind::box) put_on_box(S_, touches[i]);
        if (S_.shape.kind == ShapeKind::hull) put_on_hull(S_, touches[i]);
        middle += touches[i].p * (1 / static_cast<scalar>(manifold.count));
    }
    const bool is_line = manifold.count <= 2;  // an edge may lie all along the foot of a wall
    if (is_line) middle = middle_below();
    for (int i = 0; i < manifold.count; ++i) {
        Vector inwards = middle - touches[i].p;
        inwards = inwards - d * dot(d, inwards);
        const scalar way = sqrt(length_sq(inwards)), most = 4 * flush_;
        touches[i].inner = touches[i].p + inwards * (way > most && !is_line ? most / way : scalar(1));
    }
}

/// Where a single point is drawn to: the way there stays on the face.
Vector HiddenPoints::middle_below() const {
    if (S_.shape.kind == ShapeKind::half_space) return body_.r;
    return S_.shape.kind == ShapeKind::box ? S_.r + S_.A * clamp(transpose_times(S_.A, body_.r - S_.r), S_.shape.size) : S_.r;
}

/// The one point of a cylinder that passes an edge beside a face may be on the face and not below the cylinder: whoever is there hides it.
bool HiddenPoints::is_beside(const Manifold& manifold, const Touch& touch) const {
    return manifold.count == 1 && touch.face && body_.shape.kind == ShapeKind::cylinder && is_beside_face(manifold.points[0].feature) &&
           !is_below_axis(body_, touch.p, touch.d);
}

bool HiddenPoints::holds(const Vector& p) const {
    // bound: 2 limits::hull_vertices_max - 4
    for (int face_i = 0; face_i < face_count(S_); ++face_i) {
        const FaceOfFixed face = face_of(S_, face_i);
        if (dot(face.n, p - S_.r) > face.offset + flush_) return false;
    }
    return true;
}

bool HiddenPoints::hides(const PlacedShape& T, const Touch& touch, const Vector& p) const {
    if (T.shape.kind == ShapeKind::box) return hidden_by_box(T, touch, p, flush_);
    if (T.shape.kind == ShapeKind::hull) return hidden_by_hull(T, touch, p, flush_);
    return T.shape.kind == ShapeKind::half_space && hidden_by_half_space(T, touch, p, flush_);
}

bool chain_fixed_touches(const FixedShapes& all, Index* last_of_shape, const ManifoldView& manifolds) {
    bool some = false;
    // bound: max_manifolds
    for (int i = 0; i < *manifolds.count; ++i) {
        const FixedTouch touch = all.touch_of(manifolds.pairs[i]);
        if (touch.S < 0) continue;
        Index& last = last_of_shape[touch.body];
        manifolds.records[manifolds.pairs[i].record].next_free = last;
        some = some || last != 0;
        last = static_cast<Index>(i + 1);
    }
    return some;
}

void forget_fixed_touches(Index* last_of_shape, const ManifoldView& manifolds) {
    // bound: max_manifolds
    for (int i = 0; i < *manifolds.count; ++i) last_of_shape[manifolds.pairs[i].body_A] = last_of_shape[manifolds.pairs[i].body_B] = 0;
}

void end_fixed_chains(const FixedShapes& all, const PairList& found, Index* last_of_shape, const ManifoldView& manifolds) {
    int kept = 0, found_i = 0;
    // bound: max_manifolds
    for (int i = 0; i < *manifolds.count; ++i) {
        const BodyPair pair = manifolds.pairs[i];
        const FixedTouch touch = all.touch_of(pair);
        if (touch.S >= 0) {
            last_of_shape[touch.body] = 0;
            manifolds.records[pair.record].next_free = 0;
        }
        if (manifolds.records[pair.record].manifold.count > 0) {
            manifolds.pairs[kept++] = pair;
            continue;
        }
        // bound: pairs_with_own of scene.h: over the whole walk: both lists are sorted, and whoever touches was found
        while (found_i < *found.count - 1 && found.pairs[found_i].key() != pair.key()) ++found_i;
        give_back(manifolds, found.pairs[found_i].record);
    }
    *manifolds.count = static_cast<Index>(kept);
}

void drop_points(unsigned hidden, ManifoldRecord& record) {
    Manifold left;
    left.n = record.manifold.n;
    left.halvings = record.manifold.halvings;
    left.count = 0;
    for (int i = 0; i < record.manifold.count; ++i)  // bound: 4: Manifold::points_max
        if ((hidden >> i & 1u) == 0) left.points[left.count++] = record.manifold.points[i];
    carry_impulses(record, left);
    keep_manifold(left, record.manifold);
}

} }  // namespace ingot
