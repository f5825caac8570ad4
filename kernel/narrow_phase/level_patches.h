// SPDX-License-Identifier: MIT
// What a body touches of a level: triangle after triangle, gathered by planes.
//
// Triangles are not listed: each is asked for its points, those that neighbours make impossible are left out (level_cone.h), and the others go to the
// patch of their plane. So it is no matter into how many triangles a plane is cut. A body has up to four patches of a level: floor and walls.
// Features name places on the body, none on a triangle: impulses live on across edges.
#pragma once

#include "collide_kinds.h"
#include "contact_patch.h"
#include "level_cone.h"
#include "plane_between.h"
#include "triangle_hull.h"

namespace ingot { inline namespace INGOT_ABI {

/// Points of one plane, in the level's frame.
struct LevelPatch {
    static constexpr int room = 16;
    ContactFrame frame;  ///< its origin is on the level
    Candidate points[room];
    int count;
    scalar least;      ///< m, the separation of the deepest
    uint8_t material;  ///< of its triangles, where the level has materials; else of the first
};

/// A body above a level, in the level's frame.
struct BodyOnLevel {
    const PlacedShape& body;
    scalar margin;       ///< m, as in collide_pairs.h
    scalar flush;        ///< m, how far apart surfaces are one
    scalar half_extent;  ///< m, the least of the body
};

/// The patches of one body.
class LevelPatches {
public:
    LevelPatches(const LevelTable& level, const BodyOnLevel& on) : level_(level), on_(on), count_(0) {}

    /// Adds what the body touches of a triangle.
    template <class Shapes>
    void add(const LevelTriangle& triangle) {
        TriangleFace face;
        material_ = triangle.material;
        added_ = false;
        if (!face_of_triangle(triangle, face)) return;
        if (only_balls<Shapes> || on_.body.shape.kind == ShapeKind::sphere) return add_ball(triangle, face);
        if constexpr (!only_balls<Shapes>) add_solid<Shapes>(triangle, face);
    }

    int count() const { return count_; }
    /// The one of a number as a manifold, its normal from the level to the body; its features are places on the body.
    void write(int patch_i, const Manifold& before, Manifold& manifold) const;
    const LevelPatch& patch(int patch_i) const { return patches_[patch_i]; }

private:
    template <class Shapes>
    static constexpr bool only_balls = !Shapes::has(ShapeKind::capsule) && !Shapes::has(ShapeKind::box) && !Shapes::has(ShapeKind::cylinder) &&
                                       !Shapes::has(ShapeKind::hull);

    template <class Shapes>
    void add_solid(const LevelTriangle& triangle, const TriangleFace& face) {
        if (!reaches(face)) return;
        const Manifold& above = above_plane<Shapes>(face);
        bool stands = stands_inside(face, above);
        scalar overlap = 0;
        if (ends_below(triangle, face)) {
            stands = (is_above(face) && lies_across(triangle, face, above)) || stands;
            bool of_side = false;
            if (!stands && add_round(triangle, face, of_side)) return;
            if (!of_side) {
                const TriangleHull hull(face, on_.half_extent);
                Manifold beside;
                (void)collide_pair<WithHulls<Shapes>>(on_.body, hull.placed(), on_.margin, beside, nullptr);
                if (add_beside(triangle, face, beside, stands)) return;
                overlap = beside.count > 0 ? -least_separation(beside) : scalar(0);
            }
        }
        if (is_above(face)) add_inside(triangle, face, above);
        if (overlap > on_.flush && !added_) add_poking(triangle, face, overlap);
    }
    template <class Shapes>
    struct WithHulls : Shapes {
        static constexpr bool has(ShapeKind kind) { return kind == ShapeKind::hull || Shapes::has(kind); }
    };

    /// What the body has above the plane of a triangle, or in it: of triangles of one plane it is asked once.
    template <class Shapes>
    const Manifold& above_plane(const TriangleFace& face) {
        if (!is_in_plane(face)) {
            plane_ = {HalfSpace{face.n, 0}, face.corners[0], identity_matrix<scalar>(), nullptr};
            above_ = {};
            (void)collide_with_half_space<Shapes>(on_.body, plane_, on_.margin, above_, nullptr);
        }
        return above_;
    }
    bool is_in_plane(const TriangleFace& face) const;
    void add_ball(const LevelTriangle& triangle, const TriangleFace& face);
    bool reaches(const TriangleFace& face) const;
    bool is_solid() const { return !level_.is_mesh(); }
    bool is_above(const TriangleFace& face) const;
    bool is_behind(const TriangleFace& face, scalar separation) const;
    bool is_in_the_air() const;
    bool is_above_field() const;
    bool is_before_mesh() const;
    bool stands_inside(const TriangleFace& face, const Manifold& above) const;
    bool lies_across(const LevelTriangle& triangle, const TriangleFace& face, const Manifold& above);
    bool add_round(const LevelTriangle& triangle, const TriangleFace& face, bool& of_side);
    bool ends_below(const LevelTriangle& triangle, const TriangleFace& face) const;
    bool is_open(const LevelTriangle& triangle, const TriangleTouch& touch, const Vector& d, scalar tilt) const;
    bool is_bare(const LevelTriangle& triangle, const TriangleFace& face, const Vector& p, scalar separation) const;
    bool add_beside(const LevelTriangle& triangle, const TriangleFace& face, const Manifold& found, bool stands);
    void add_inside(const LevelTriangle& triangle, const TriangleFace& face, const Manifold& found);
    void add_above(const LevelTriangle& triangle, const TriangleFace& face, const Vector& on_body);
    void add_poking(const LevelTriangle& triangle, const TriangleFace& face, scalar overlap);
    /// A place P of the level within the body, which is out of it `depth` (m) along d, unit.
    struct Poking {
        Vector P, d;
        scalar depth;
    };
    void see_poking_corner(const LevelTriangle& triangle, const TriangleFace& face, int corner, Poking& least) const;
    void see_poking_edge(const LevelTriangle& triangle, const TriangleFace& face, int edge, Poking& least) const;
    void add_point(const Vector& n, const Vector& P, scalar separation);
    LevelPatch* patch_for(const Vector& n, const Vector& surface, scalar separation);
    uint32_t feature_of(const Vector& P) const;

    const LevelTable& level_;
    BodyOnLevel on_;
    LevelPatch patches_[level_patches];
    int count_;
    uint8_t material_ = 0;     ///< of the triangle at hand
    PlacedShape plane_ = {};  ///< of the last triangle but those in the same; none: no normal
    Manifold above_;
    bool added_ = false;  ///< the triangle at hand has a point
};

} }  // namespace ingot
