// SPDX-License-Identifier: MIT
// A step of a mover among shapes.
#pragma once

#include "../math/trig.h"
#include "half_spaces.h"
#include "mover_space.h"

namespace ingot { inline namespace INGOT_ABI {

/// The lengths of a mover in its scene, m.
struct MoverLengths {
    scalar skin, step, stick, enter, near, still;
    scalar slope_cos;
};
/// Where the world is so large that its roundings are more than a still_share of the skin, they are what counts.
inline MoverLengths lengths_of(const Mover& mover, scalar unit) {
    const scalar skin = mover.skin * unit, rounding = 4 * epsilon * (abs(mover.r.x) + abs(mover.r.y) + abs(mover.r.z));
    const scalar still = skin * movers::still_share;
    return {skin, mover.step * unit, mover.stick * unit, skin * movers::enter_share, still / 4 + rounding, still + rounding,
            sin_cos(mover.slope).cos - 4 * epsilon};
}
inline MoverReach reach_of(const Mover& mover, scalar unit) {
    const scalar skin = mover.skin * unit;
    return {mover.up, skin, skin * (1 + movers::reach_share), min(limits::flush_gap * unit, skin * movers::flush_share)};
}

/// What a step is made of. space: a MoverSpace. velocity(slot, P): m/s, of a surface.
///
/// Not inlined: what is touched takes 2 KB of stack, which would add up where all of it became one function.
template <class Space, class Velocity>
class MoverWalk {
public:
    MoverWalk(const Space& space, const Velocity& velocity, const Mover& mover, const MoverLengths& lengths)
        : space_(space), velocity_(velocity), l_(lengths), up_(mover.up), to_foot_(mover.capsule.half_length + mover.capsule.radius),
          push_max_(mover.capsule.radius) {}

    /// Goes along with the ground, as far as nothing else is in the way.
    void carry(PlacedShape& at, const Vector& to) const {
        const SlotHit hit = space_.cast(at, to - at.r, forward());
        if (hit.slot == no_slot)
            at.r = to;
        else
            slide(at, to - at.r, nullptr);
    }

    /// Over the ground by `own`, m, across `up`: along the ground that it stands on, whose normal is n, or over a step, whichever gets further.
    void walk(PlacedShape& at, const Vector& own, const Vector& n) const {
        const scalar length = sqrt(length_sq(own)), upright = dot(n, up_);
        const scalar rise = upright >= l_.slope_cos ? -dot(n, own) / upright : scalar(0);
        const PlacedShape begin = at;
        slide(at, own + up_ * rise, &begin.r);
        (void)drop(at, l_.stick, begin.r);
        if (!(length > 0)) return;
        const Vector ahead = own * (1 / length);
        const scalar whole = length * (1 - limits::edge_tilt);
        scalar best = dot(at.r - begin.r, ahead);
        scalar height = l_.step;
        for (int lift_i = 0; lift_i < movers::lifts_max && best < whole; ++lift_i, height /= 2) {
            PlacedShape lifted = begin;
            const scalar free = height * (height > 0 ? space_.cast(begin, up_ * height, forward()).fraction : scalar(0));
            lifted.r += up_ * free;
            slide(lifted, own, &begin.r);
            const scalar got = dot(lifted.r - begin.r, ahead);
            if (!(got > best + length * limits::edge_tilt) || !drop(lifted, free + l_.stick, begin.r)) continue;
            if (dot(lifted.r - begin.r, up_) > l_.step + l_.skin) continue;
            best = got;
            at = lifted;
        }
    }

    /// Through the air by `way`, m.
    void fly(PlacedShape& at, const Vector& way) const { slide(at, way, nullptr); }

    /// What is left of a velocity across `up` where it touches what is too steep: this is as a wall, and is not climbed by running at it.
    INGOT_NOINLINE Vector held_by_slopes(const PlacedShape& at, const Vector& across) const {
        MoverTouches touches;
        space_.planes_at(at, touches);
        HalfSpaces walls;
        for (int i = 0; i < touches.count; ++i) {  // bound: movers::planes_max
            const MoverTouch& touch = touches.touches[i];
            if (touch.gap <= l_.still && dot(touch.n, up_) > 0 && !is_walkable(touch, at.r)) (void)add_as_wall(touch, 0, walls);
        }
        return nearest_in(walls, across, movers::far_of_move);
    }

    /// What is left of a velocity among what is touched.
    Vector clipped(const MoverTouches& touches, const Vector& v) const {
        HalfSpaces spaces;
        for (int i = 0; i < touches.count; ++i) {  // bound: movers::planes_max
            const MoverTouch& touch = touches.touches[i];
            if (touch.gap <= l_.still) spaces.add(touch.n, dot(touch.n, velocity_(touch.slot, touch.P)));
        }
        return nearest_in(spaces, v, movers::far_of_move);
    }

    /// The touch that it stands on best; -1: none.
    /// from: m, where its middle was or is: what is more than a step above its foot there is no ground. lands: it comes from the air, and what it
    /// touches with its side, however even, it slides off.
    int ground_of(const Vector& from, const MoverTouches& touches, bool lands, MoverFooting& footing) const {
        int best = -1;
        footing = MoverFooting::none;
        for (int i = 0; i < touches.count; ++i) {  // bound: movers::planes_max
            const MoverTouch& touch = touches.touches[i];
            const scalar support = dot(touch.n, up_);
            if (!(support >= movers::support_min)) continue;
            const bool stands = is_walkable(touch, from) && !(lands && support < l_.slope_cos / 2);
            const MoverFooting is = stands ? MoverFooting::walkable : MoverFooting::steep;
            const bool better = best < 0 || is > footing ||
                                (is == footing && dot(touch.upright, up_) > dot(touches.touches[best].upright, up_));
            if (!better) continue;
            best = i;
            footing = is;
        }
        return best;
    }

private:
    AxisCast forward(bool leaves = false) const {
        return {l_.skin - l_.enter, l_.enter / 2, l_.near, leaves ? space_.asked().flush : scalar(0)};
    }
    AxisCast down() const { return {l_.skin - l_.enter, 0, l_.near}; }

    /// Ground to walk on, no higher above its foot, where it is at `from`, than a step.
    bool is_walkable(const MoverTouch& touch, const Vector& from) const {
        return dot(touch.upright, up_) >= l_.slope_cos && dot(touch.n, up_) >= movers::support_min &&
               dot(touch.P - from, up_) + to_foot_ <= l_.step + l_.skin;
    }
    bool has_axis_in(const MoverTouch& touch) const { return touch.gap + l_.skin <= -push_max_; }
    /// The gap of what is on the skin, to roundings, is 0.
    scalar gap_of(const MoverTouch& touch) const { return abs(touch.gap) <= l_.still ? scalar(0) : touch.gap; }

    /// As if it were upright. False for what is all but level.
    bool add_as_wall(const MoverTouch& touch, scalar gap, HalfSpaces& spaces) const {
        const Vector across = touch.n - up_ * dot(touch.n, up_);
        const scalar part = sqrt(length_sq(across));
        if (!(part > movers::support_min)) return false;
        spaces.add(across * (1 / part), min(-gap / part, push_max_));
        return true;
    }

    /// What is left of a way by what is touched. walks_from: m, where it walks from: what is too steep, or too high from there, is a wall; null: it
    /// flies. leaves: it is in something. What its axis is in is no wall: out of a floor it goes up. But where other planes are in that way, out is
    /// as far as they let it go: it is not pressed into them.
    INGOT_NOINLINE Vector left_of(const PlacedShape& at, const Vector& way, const Vector* walks_from, bool& leaves) const {
        MoverTouches touches;
        space_.planes_at(at, touches);
        HalfSpaces all, beside, out;
        leaves = false;
        for (int i = 0; i < touches.count; ++i) {  // bound: movers::planes_max
            const MoverTouch& touch = touches.touches[i];
            const scalar gap = gap_of(touch), least = min(-gap, push_max_);
            const bool is_in = touch.gap < -l_.skin;
            const bool too_much = walks_from != nullptr && !has_axis_in(touch) && dot(touch.n, up_) > 0 && !is_walkable(touch, *walks_from);
            HalfSpaces& other = is_in ? out : beside;
            leaves = leaves || is_in;
            if (too_much && add_as_wall(touch, gap, all)) {
                (void)add_as_wall(touch, gap, other);
                continue;
            }
            all.add(touch.n, least);
            other.add(touch.n, least);
        }
        const Vector by = nearest_in(all, way, movers::far_of_move);
        if (out.count == 0 || allows(beside, by)) return by;
        return nearest_in(beside, nearest_in(out, way, movers::far_of_move), movers::far_of_move);
    }
    bool allows(const HalfSpaces& spaces, const Vector& by) const {
        bool allowed = true;
        for (int i = 0; i < spaces.count; ++i) allowed = allowed && dot(spaces.n[i], by) >= spaces.least[i] - l_.still;  // bound: movers::planes_max
        return allowed;
    }

    INGOT_NOINLINE void slide(PlacedShape& at, const Vector& way, const Vector* walks_from) const {
        Vector left = way;
        for (int i = 0; i < movers::slides_max; ++i) {
            bool leaves;
            const Vector by = left_of(at, left, walks_from, leaves);
            if (!(length_sq(by) > 0)) return;
            const SlotHit hit = space_.cast(at, by, forward(leaves));
            at.r += by * hit.fraction;
            if (hit.slot == no_slot) return;
            left = left * (1 - hit.fraction);
        }
    }

    INGOT_NOINLINE bool stands_at(const PlacedShape& at, const Vector& from) const {
        MoverTouches touches;
        space_.planes_at(at, touches);
        MoverFooting footing;
        (void)ground_of(from, touches, false, footing);
        return footing == MoverFooting::walkable;
    }

    /// Down onto ground that is no lower than `depth`, m; beside what is too steep, along that. False, and nothing changes, where there is none.
    ///
    /// A cast ends below the skin: so it does not end at walls beside it, which the skin touches. From there it is up again, by the plane that it
    /// met.
    INGOT_NOINLINE bool drop(PlacedShape& at, scalar depth, const Vector& from) const {
        if (!(depth > 0)) return stands_at(at, from);
        const SlotHit hit = space_.cast(at, up_ * (-depth - l_.enter), down());
        if (hit.slot == no_slot) return false;
        const scalar fall = (depth + l_.enter) * hit.fraction - l_.enter / max(dot(hit.n, up_), movers::support_min);
        PlacedShape low = at;
        if (fall > l_.still) low.r -= up_ * min(fall, depth);
        if (!stands_at(low, from)) {
            const Vector before = low.r;
            slide(low, up_ * -(depth - max(fall, scalar(0))), nullptr);
            const Vector by = low.r - before, aside = by - up_ * dot(up_, by);
            if (length_sq(aside) > l_.skin * l_.skin || !stands_at(low, from)) return false;
        }
        at = low;
        return true;
    }

    const Space& space_;
    const Velocity& velocity_;
    const MoverLengths l_;
    const Vector up_;
    const scalar to_foot_, push_max_;  ///< m; out of what closed about it it comes by no more at once
};

} }  // namespace ingot
