// SPDX-License-Identifier: MIT
// What a mover meets among all shapes: planes where it is, and the first thing on its way.
#pragma once

#include "../query/cast_ray.h"
#include "axis_touch.h"

namespace ingot { inline namespace INGOT_ABI {

/// A mover among shapes.
///
/// all: an EveryShape, or ShapesOfTree. sees(slot): what counts. stands(slot): it is fixed and stands still, so that it is one floor with others that
/// do.
template <class Shapes, class All, class Sees, class Stands>
class MoverSpace {
public:
    MoverSpace(const All& all, const Sees& sees, const Stands& stands, const MoverReach& asked)
        : all_(all), sees_(sees), stands_(stands), asked_(asked) {}

    /// All planes that bound the way from here, by the law of inner_edges.h, the nearest first.
    INGOT_NOINLINE void planes_at(const PlacedShape& capsule, MoverTouches& touches) const {
        touches.count = 0;
        gather(capsule, touches);
        drop_hidden(capsule, touches);
        for (int i = 0; i < touches.count; ++i) touches.touches[i].upright = upright_of(touches.touches[i]);  // bound: movers::touches_max
        touches.merge(asked_.up);
    }

    /// How far the way is free, and what ends it.
    INGOT_NOINLINE SlotHit cast(const PlacedShape& capsule, const Vector& way, const AxisCast& how) const {
        const PlacedShape wide = widened(capsule, max(how.stop, scalar(0)) + how.near);
        MovingBall ball = {capsule.r, way, bounding_radius(wide.shape), 1, &wide};
        SlotHit hit = {no_slot, 1, capsule.r + way, {}};
        look_along(all_, ball, [&](int slot) {
            if (!sees_(slot)) return;
            const PlacedShape B = placed(slot);
            const ShapeEntry entry = cast_on(capsule, way, ball.fraction, how, B);
            if (!entry.meets || (hit.slot != no_slot && !is_before(entry.fraction, slot, hit.fraction, hit.slot))) return;
            hit = {slot, entry.fraction, entry.P, entry.n};
            ball.fraction = entry.fraction;
        });
        return hit;
    }

    const MoverReach& asked() const { return asked_; }

private:
    static PlacedShape widened(const PlacedShape& capsule, scalar by) {
        PlacedShape wide = capsule;
        wide.shape.size.x += by;
        return wide;
    }
    PlacedShape placed(int slot) const { return placed_body<Shapes>(all_.bodies, all_.surfaces, slot); }

    static ShapeEntry cast_on(const PlacedShape& capsule, const Vector& way, scalar fraction_max, const AxisCast& how, const PlacedShape& B) {
        if constexpr (Shapes::has(ShapeKind::level))
            if (B.shape.kind == ShapeKind::level) return cast_axis_on_level(capsule, way, fraction_max, how, B, *Shapes::level_of(B.shape));
        if (B.shape.kind == ShapeKind::box && passes_box(capsule, way * fraction_max, B, max(how.stop, scalar(0)) + how.near))
            return {false, 1, {}, {}};
        return cast_axis(capsule, way, fraction_max, how, [&B](const PlacedShape& now) { return touch_of_shape(now, B, limits::unbounded); });
    }

    void gather(const PlacedShape& capsule, MoverTouches& touches) const {
        const PlacedShape wide = widened(capsule, asked_.reach);
        const MovingBall ball = {wide.r, {}, bounding_radius(wide.shape), 0, &wide};
        look_along(all_, ball, [&](int slot) {
            if (!sees_(slot)) return;
            const PlacedShape S = placed(slot);
            if constexpr (Shapes::has(ShapeKind::level))
                if (S.shape.kind == ShapeKind::level) return add_touches_of_level(capsule, S, *Shapes::level_of(S.shape), asked_, slot, touches);
            if (S.shape.kind == ShapeKind::box && passes_box(capsule, {}, S, asked_.reach)) return;
            const AxisTouch found = touch_of_shape(capsule, S, asked_.reach);
            if (!found.there) return;
            MoverTouch touch = {found.n, found.P, found.P, found.n, found.gap - asked_.skin, slot, found.face};
            if (!found.crosses) put_on_shape(S, capsule, asked_.flush, touch);
            touches.add(touch);
        });
    }

    /// True where some other part of the floor hides a contact of S with direction d at p.
    bool is_hidden(int S_slot, const Vector& p, const Vector& d) const {
        const PlacedShape about = {Sphere{asked_.flush}, p, identity_matrix<scalar>(), nullptr};
        const MovingBall ball = {p, {}, asked_.flush, 0, &about};
        bool hidden = false;
        look_along(all_, ball, [&](int slot) {
            if (hidden || slot == S_slot || !sees_(slot) || !stands_(slot)) return;
            const PlacedShape T = placed(slot);
            if constexpr (Shapes::has(ShapeKind::level))
                if (T.shape.kind == ShapeKind::level) return void(hidden = hidden_by_level_at(T, *Shapes::level_of(T.shape), p, d, asked_.flush));
            hidden = hidden_by_shape(T, p, d, asked_.flush);
        });
        return hidden;
    }
    void drop_hidden(const PlacedShape& capsule, MoverTouches& touches) const {
        const scalar radius = capsule.shape.size.x;
        int kept = 0;
        for (int i = 0; i < touches.count; ++i) {  // bound: movers::touches_max
            const MoverTouch& touch = touches.touches[i];
            // What its axis is in it has to leave, whoever is beside it.
            const bool deep = touch.gap + asked_.skin <= -radius;
            const auto hidden = [&](const Vector& p) { return is_hidden(touch.slot, p, touch.n); };
            if (!deep && stands_(touch.slot) && hidden(touch.P) && (!touch.face || hidden(touch.inner))) continue;
            touches.touches[kept++] = touch;
        }
        touches.count = kept;
    }

    /// Of an edge or a corner, the most upright of the faces that meet there and are open: the nose of a step is its tread.
    Vector upright_of(const MoverTouch& touch) const {
        const Vector& up = asked_.up;
        if (touch.face || !(dot(touch.n, up) > 0)) return touch.n;
        Vector best{};
        bool some = false;
        const auto consider = [&](const Vector& n) {
            if (some && !(dot(n, up) > dot(best, up))) return;
            if (stands_(touch.slot) && is_hidden(touch.slot, touch.P, n)) return;
            best = n;
            some = true;
        };
        const PlacedShape S = placed(touch.slot);
        if constexpr (Shapes::has(ShapeKind::level))
            if (S.shape.kind == ShapeKind::level) for_faces_of_level(S, *Shapes::level_of(S.shape), touch.P, asked_.flush, consider);
        for_faces_at(S, touch.P, asked_.flush, consider);
        return some ? best : touch.n;
    }

    const All& all_;
    const Sees& sees_;
    const Stands& stands_;
    const MoverReach asked_;
};
template <class Shapes, class All, class Sees, class Stands>
MoverSpace<Shapes, All, Sees, Stands> mover_space(const All& all, const Sees& sees, const Stands& stands, const MoverReach& asked) {
    return {all, sees, stands, asked};
}

} }  // namespace ingot
