// SPDX-License-Identifier: MIT
// Pairs of shapes with a body that is fast and has joints. It cannot be taken from its figure within the step, so what it will meet has a manifold
// from the begin of the step on, whose rows let it come as far as the plane of the impact and stop all of the figure there.
#pragma once

#include "../body/kinematic_motion.h"
#include "../joint/joint_lists.h"
#include "../math/sqrt.h"
#include "fast_pairs.h"
#include "time_of_impact.h"

namespace ingot { inline namespace INGOT_ABI {

/// FastPairs of scenes with joints.
struct FastPairsOfFigures : FastPairs {
    static constexpr bool leads_figures = true;
    JointLists lists;
    Vector gravity;

    bool is_jointed(int slot) const { return lists.first_end[slot] != 0; }
    /// Bodies with joints are not fast by themselves, and kinematic ones have manifolds with them as others have.
    bool has(const BodyPair& pair) const {
        const int A = shapes.body_of({pair.body_A}), B = shapes.body_of({pair.body_B});
        if ((is_jointed(A) && !is_dynamic(bodies, B)) || (is_jointed(B) && !is_dynamic(bodies, A))) return false;
        return FastPairs::has(pair);
    }
    /// Whether bodies, one of them with joints, are fast to each other.
    bool leads(const BodyPair& pair) const {
        const int A = shapes.body_of({pair.body_A}), B = shapes.body_of({pair.body_B});
        if (shows_kinematic_motion(bodies, A) || shows_kinematic_motion(bodies, B) || (!is_jointed(A) && !is_jointed(B))) return false;
        scalar least = limits::unbounded, turning = 0;
        const int slots[] = {A, B};
        for (const int slot : slots) {
            const BodyExtent extent = extent_of(shapes, slot);
            const scalar angle = sqrt(length_sq(omega_of(bodies, slot))) * h;
            turning += (angle < 2 ? angle : scalar(2)) * extent.reach;
            if (is_dynamic(bodies, slot)) least = min(least, extent.least);
        }
        return sqrt(length_sq(v_CM_of(bodies, A) - v_CM_of(bodies, B))) * h + turning > limits::fast_share * least;
    }
    /// What is near has the manifold that was found. What is further has none where bodies pass by each other, going on as they do; else one of where
    /// they meet, if what is met cannot move: points are where they will be on the body, and as far away as it goes until then. Of two that move the
    /// manifold stays as it was found.
    template <class Shapes>
    void find_on_way(const BodyPair& pair, const SurfaceView& surfaces, Manifold& found) const {
        const scalar scale = scale_of(surfaces.unit, found.halvings), near = margin_at(scale, surfaces.unit, surfaces.fall);
        if (found.count == 0 || !(least_separation(found) > near)) return;
        const ShapeSlot A = {pair.body_A}, B = {pair.body_B};
        const BodyPath path_A = path_ahead(shapes.body_of(A)), path_B = path_ahead(shapes.body_of(B));
        const ShapeOnPath on_A = shape_on_path(shapes, A, path_A), on_B = shape_on_path(shapes, B, path_B);
        const bool A_is_flat = on_A.shape.kind == ShapeKind::half_space;
        const TimeOfImpact first =
            A_is_flat ? time_of_impact(on_B, on_A, {surfaces.unit, 0, 1, 0}) : time_of_impact(on_A, on_B, {surfaces.unit, 0, 1, 0});
        if (!(first.t <= 1)) {
            found.count = 0;
            return;
        }
        if (is_dynamic(bodies, shapes.body_of(A)) && is_dynamic(bodies, shapes.body_of(B))) return;
        const Manifold none = {};
        Manifold met = found;
        const Margin margin = {near, limits::fast_margin * scale};
        if (!collide_placed<Shapes>(placed_at(on_A, first.t), placed_at(on_B, first.t), margin, none, met) || met.count == 0) return;
        take_back(path_A, path_B, first.t, met);
        found = met;
    }

private:
    /// Where it goes if it goes on as it does.
    BodyPath path_ahead(int slot) const {
        BodyPath path = {};
        begin_path(bodies, h, slot, path);
        if (is_dynamic(bodies, slot)) path.fall = gravity * (h * h / 2);
        return path;
    }
    static PlacedShape placed_at(const ShapeOnPath& of, scalar t) {
        const PathFrame at = frame_on_path(of.path, t);
        return place_on_body(of.shape, of.place, of.hull, at.r_CM, at.A);
    }
    /// Points of time t become those of the begin, so that the way until t, and its turn about the levers of t, closes what they are apart.
    static void take_back(const BodyPath& A, const BodyPath& B, scalar t, Manifold& met) {
        const auto way = [t](const BodyPath& path) { return (path.way + path.fall * t) * t; };
        const Vector by = way(A) + way(B);     // one of them stands
        for (int i = 0; i < met.count; ++i) {  // bound: 4: Manifold::points_max
            ManifoldPoint& point = met.points[i];
            const Vector on_A = way(A) + cross(A.turn, point.P - A.r_CM - way(A)) * t, on_B = way(B) + cross(B.turn, point.P - B.r_CM - way(B)) * t;
            point.separation -= dot(met.n, on_A - on_B);
            point.P = point.P - by;
        }
    }
};

} }  // namespace ingot
