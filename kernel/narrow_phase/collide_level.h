// SPDX-License-Identifier: MIT
// A body and a level: from the triangles near it to manifolds.
#pragma once

#include "level_patches.h"

namespace ingot { inline namespace INGOT_ABI {

/// World to the level's frame, whose tables are seen from the middle of the box that holds the level: see Level.
struct LevelFrame {
    const PlacedShape& level;
    Vector middle;  ///< m, of the box, in the level's frame

    LevelFrame(const PlacedShape& placed, const LevelTable& table) : level(placed), middle(table.middle()) {}
    Vector seen_point(const Vector& P) const { return transpose_times(level.A, P - level.r) + middle; }
    PlacedShape seen(const PlacedShape& body) const { return {body.shape, seen_point(body.r), transposed(level.A) * body.A, body.hull}; }
    Vector seen_direction(const Vector& d) const { return transpose_times(level.A, d); }
    Vector place(const Vector& P) const { return level.r + level.A * (P - middle); }
    /// A manifold of the level's frame becomes one of the world.
    void place(Manifold& manifold) const {
        manifold.n = level.A * manifold.n;
        for (int i = 0; i < manifold.count; ++i) manifold.points[i].P = place(manifold.points[i].P);  // bound: 4: Manifold::points_max
    }
};

/// How far a body reaches from its origin, m: up along the axes of the level, and below.
struct LevelReach {
    Vector above, below;
};
inline LevelReach reach_in_level(const PlacedShape& body) {
    const auto along = [&body](const Vector& axis) { return dot(axis, support_point(body, axis) - body.r); };
    const Vector above = {along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
    if (body.shape.kind != ShapeKind::hull) return {above, above};
    return {above, {along({-1, 0, 0}), along({0, -1, 0}), along({0, 0, -1})}};
}

/// Gathers what a body touches of a level. body: in the level's frame.
template <class Shapes>
void gather_patches(const LevelTable& table, const PlacedShape& body, scalar margin, LevelPatches& patches) {
    const Vector more = {margin, margin, margin};
    const LevelReach reach = reach_in_level(body);
    const Vector low = body.r - reach.below - more, high = body.r + reach.above + more;
    for_triangles_in(table, low, high, [&](const LevelTriangle& triangle) { patches.template add<Shapes>(triangle); });
}

/// m, how far apart surfaces of a level are one for a body: as for fixed boxes.
inline scalar flush_of(const PlacedShape& body, scalar unit) {
    return min(limits::flush_gap * unit, limits::flush_share * bounding_radius(body.shape));
}

/// What a body touches of a level: gathered by the constructor, one manifold a patch.
template <class Shapes>
class LevelTouch {
public:
    /// margin: m. flush: m, how far apart surfaces of the level are one; see flush_of.
    LevelTouch(const PlacedShape& body, const PlacedShape& level, scalar margin, scalar flush)
        : table_(*Shapes::level_of(level.shape)), frame_(level, table_), seen_(frame_.seen(body)),
          patches_(table_, {seen_, margin, flush, least_half_extent(body.shape, body.hull)}) {
        gather_patches<Shapes>(table_, seen_, margin, patches_);
    }
    LevelTouch(const LevelTouch&) = delete;
    LevelTouch& operator=(const LevelTouch&) = delete;

    int count() const { return patches_.count(); }
    /// The cosine between the normal of a patch, from the level to the body, and n, world.
    scalar along(int patch_i, const Vector& n) const { return dot(frame_.seen_direction(n), patches_.patch(patch_i).frame.n); }
    uint8_t material(int patch_i) const { return patches_.patch(patch_i).material; }
    bool has_materials() const { return table_.material_count > 0; }
    /// World; n from the level to the body.
    void write(int patch_i, const Manifold& before, Manifold& manifold) const {
        patches_.write(patch_i, before, manifold);
        frame_.place(manifold);
    }

private:
    const LevelTable& table_;
    const LevelFrame frame_;
    const PlacedShape seen_;
    LevelPatches patches_;
};

/// The manifold of one patch, for whoever asks for one pair alone: of the patches as they were gathered, that of the level's number.
template <class Shapes>
void collide_level(const PlacedShape& body, const PlacedShape& level, scalar margin, Manifold& manifold) {
    const LevelTouch<Shapes> touch(body, level, margin, limits::flush_share * bounding_radius(body.shape));
    const int patch_i = patch_number(level.shape);
    if (patch_i >= touch.count()) return no_points({}, manifold);
    touch.write(patch_i, Manifold{}, manifold);
}

} }  // namespace ingot
