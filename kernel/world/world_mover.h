// SPDX-License-Identifier: MIT
// The part of World that moves characters. See mover/mover.h.
#pragma once

#include "../mover/move_mover.h"
#include "world_queries.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls of World, see world.h.
template <class S>
class WorldMover : public WorldQueries<S> {
protected:
    using Base = WorldQueries<S>;
    using Base::storage_;
    using Base::shapes_only;
    using Base::translation_only;
    using Base::number_of_shape;
    using Base::id_of_shape;
    using Base::find;
    using Base::find_shape;
    using Base::sees;
    using Base::over_candidates;
    using Base::body_of;
    using Base::touched;

public:
    // Characters, in scenes with shapes. A Mover is no body: nothing pushes it, no other mover meets it, and snapshots do not have it. It meets what
    // its filter lets it meet, and no sensors. Bodies that move by themselves carry it and push it aside; those that forces move it pushes.
    // Cost: a move asks for what is near 3 times and casts twice where nothing is in the way, and up to 60 times each where it cannot get on, each as
    // dear as a cast_shape.

    /// Moves a character by a step of h seconds, after step(world, h): with the ground that it stands on, then by its input. See Mover and
    /// MoverInput.
    ///
    /// Standing, it goes over the ground at the speed it is told, up and down slopes and steps no less far across `up` than on the level; what is
    /// steeper than its slope, or higher than its step, is a wall. It sticks to ground that falls away by no more than `stick`. In the air gravity of
    /// the world counts. It keeps `skin` from all there is. Where it is put into something it leaves it, by its radius at once, and no further than
    /// what else is there lets it. Out of a level it comes to the outside: of a field from any depth, of a mesh where its capsule still touches a
    /// triangle; what is all behind a mesh meets nothing of it. Bodies in its way get as much as they need to go with it, at force_max at most; it
    /// does not weigh on what it stands on.
    /// Mover::r, v, ground and what is kept for the next step become what has come of it.
    /// Errors: those of check_mover and check_mover_input; bad_step; out_of_range (it would leave limits::position_max).
    Status move(Mover& mover, const MoverInput& input, scalar h) {
        static_assert(shapes_only() && translation_only());
        Status status = check_mover(mover, S::length_unit);
        if (status == Status::ok) status = check_mover_input(input);
        if (status == Status::ok && !is_finite(h)) status = Status::not_finite;
        if (status == Status::ok && !(h >= limits::step_min && h <= limits::step_max)) status = Status::bad_step;
        if (status != Status::ok) return status;
        Mover next = mover;
        MoverTouches touches;
        Vector wanted;
        in_space(next, [&](const auto& space, int& except) { move_in(space, except, input, h, next, touches, wanted); });
        status = check_vector(next.r, limits::position_max);
        if (status != Status::ok) return Status::out_of_range;
        // Ground that was put elsewhere, and took it along, may seem to move faster than the next call takes.
        const Vector fastest = Vector{1, 1, 1} * limits::speed_max;
        next.v = clamp(next.v, fastest);
        next.v_drift = clamp(next.v_drift, fastest);
        mover = next;
        push(mover, touches, wanted, h);
        return Status::ok;
    }

    /// The planes that bound the way of a mover where it is, the nearest first, into planes[0 .. 16): of what is within a quarter of its skin. Edges
    /// inside a floor of fixed shapes and levels have none; planes within 2 degrees are one.
    /// Returns: how many there are. Errors: those of check_mover.
    Result<int> collide_mover(const Mover& mover, MoverPlane (&planes)[movers::planes_max]) const {
        static_assert(shapes_only());
        const Status status = check_mover(mover, S::length_unit);
        if (status != Status::ok) return {status, 0};
        MoverTouches touches;
        in_space(mover, [&](const auto& space, int&) { space.planes_at(placed_mover(mover), touches); });
        for (int i = 0; i < touches.count; ++i) planes[i] = plane_of(touches.touches[i]);  // bound: movers::planes_max
        return {Status::ok, touches.count};
    }

    /// How far a mover gets along a way, m, straight: until something would come into its skin. What is in it from the begin is met when it would
    /// come further in. See QueryHit.
    /// Errors: those of check_mover and of cast_ray.
    Result<QueryHit> cast_mover(const Mover& mover, const Vector& way) const {
        static_assert(shapes_only());
        Status status = check_mover(mover, S::length_unit);
        if (status == Status::ok) status = check_way(mover.r, way);
        if (status != Status::ok) return {status, {}};
        const MoverLengths l = lengths_of(mover, S::length_unit);
        SlotHit hit{};
        in_space(mover, [&](const auto& space, int&) { hit = space.cast(placed_mover(mover), way, {l.skin - l.enter, l.enter / 2, l.near}); });
        return {Status::ok, {id_of_shape(hit.slot), hit.fraction, hit.P, hit.n, number_of_shape(hit.slot)}};
    }

private:
    /// ask(space, except): `except` is the slot of a body that is not looked at.
    template <class Ask>
    void in_space(const Mover& mover, const Ask& ask) const {
        int except = no_slot;
        QueryFilter filter;
        filter.filter = mover.filter;
        const auto seen = sees(filter, no_slot);
        const auto counts = [&](int slot) { return slot / S::max_shapes_of_body != except && seen(slot); };
        const auto stands = [this](int slot) { return stands_still(slot); };
        over_candidates([&](const auto& all) {
            ask(mover_space<ShapesOf<S>>(all, counts, stands, reach_of(mover, S::length_unit)), except);
            return 0;
        });
    }

    bool stands_still(int shape_slot) const {
        const int slot = shape_slot / S::max_shapes_of_body;
        if (is_dynamic(storage_.bodies(), slot)) return false;
        if constexpr (S::kinematic_bodies) return !moves(storage_.kinematic[slot]);
        return true;
    }
    /// m/s, of the surface of a shape at P.
    Vector velocity_at(int shape_slot, const Vector& P) const {
        const int slot = shape_slot / S::max_shapes_of_body;
        const BodyState state = read_state(storage_.bodies(), slot);
        const Vector belt = belt_velocity(shape_slot);
        if constexpr (S::kinematic_bodies) {
            const KinematicBody& body = storage_.kinematic[slot];
            if (ingot::is_kinematic(body)) return belt + point_velocity(body.v_CM, body.omega, P - state.r_CM);
        }
        if (!is_dynamic(storage_.bodies(), slot)) return belt;
        return belt + point_velocity(state.v_CM, omega_of(storage_.bodies(), slot), P - state.r_CM);
    }
    /// m/s, of a surface on its body.
    Vector belt_velocity([[maybe_unused]] int shape_slot) const {
        if constexpr (S::surface_velocities) {
            const Place at = place_of(shape_slot);
            return lane_of(storage_.shapes().rotation[at.tile].A, at.lane) * storage_.surface_velocities[shape_slot];
        }
        return {};
    }
    /// m/s, of a belt that it stands on, along that.
    Vector belt_below(const Mover& mover) const {
        const Result<int> shape_slot = find_shape(mover.ground.body, mover.ground.shape);
        if (mover.ground.footing != MoverFooting::walkable || !shape_slot.ok()) return {};
        const Vector belt = belt_velocity(shape_slot.value);
        return belt - mover.ground.n * dot(mover.ground.n, belt);
    }
    MoverPlane plane_of(const MoverTouch& touch) const {
        return {touch.n, touch.gap, limits::unbounded, velocity_at(touch.slot, touch.P), touch.P, touch.upright, id_of_shape(touch.slot),
                number_of_shape(touch.slot)};
    }

    /// The slot of the body that it stands on, where that is one that moves or may; no_slot: none.
    int carrier_of(const Mover& mover) const {
        if (mover.ground.footing != MoverFooting::walkable) return no_slot;
        const Result<int> slot = find(mover.ground.body);
        if (!slot.ok()) return no_slot;
        bool may_move = is_dynamic(storage_.bodies(), slot.value);
        if constexpr (S::kinematic_bodies) may_move = may_move || ingot::is_kinematic(storage_.kinematic[slot.value]);
        return may_move ? slot.value : no_slot;
    }

    template <class Space>
    void move_in(const Space& space, int& except, const MoverInput& input, scalar h, Mover& mover, MoverTouches& touches, Vector& wanted) const {
        const auto velocity = [this](int slot, const Vector& P) { return velocity_at(slot, P); };
        const MoverWalk<Space, decltype(velocity)> walk(space, velocity, mover, lengths_of(mover, S::length_unit));
        PlacedShape at = placed_mover(mover);
        const Vector &up = mover.up, across = input.v - up * dot(up, input.v);
        const bool stood = mover.ground.footing == MoverFooting::walkable;

        // With the ground.
        const int carrier = carrier_of(mover);
        const Vector belt = belt_below(mover);
        Vector to = mover.r;
        if (carrier != no_slot) {
            const BodyState state = read_state(storage_.bodies(), carrier);
            to = state.r_CM + state.A * mover.r_in_ground;
        }
        to += belt * h;
        const Vector v_ground = (to - mover.r) * (1 / h);
        // Who jumps flies along with what it leaves.
        const bool walks = stood && !(input.jump > 0);
        except = carrier;
        if (walks && !same(to, mover.r)) walk.carry(at, to);
        except = no_slot;

        // By itself.
        const PlacedShape begin = at;
        if (walks) {
            wanted = across + v_ground;
            walk.walk(at, across * h, mover.ground.n);
            mover.v_drift = {};
        } else {
            if (stood) mover.v_drift = v_ground - up * dot(up, v_ground);
            const scalar rises = input.jump > 0 ? input.jump + dot(up, stood ? v_ground : Vector{}) : dot(up, mover.v);
            const Vector g = storage_.gravity, g_across = g - up * dot(up, g);
            wanted = walk.held_by_slopes(at, across) + mover.v_drift + up * rises;
            walk.fly(at, wanted * h + g * (h * h / 2));
            mover.v_drift += g_across * h;
            wanted += g * h;
        }
        space.planes_at(at, touches);
        tell(walk, begin, at, touches, walks, v_ground, h, wanted, mover);
        // Who stands still on it keeps its place there as it was: rounding does not add up.
        const bool as_before = carrier != no_slot && same(begin.r, at.r) && !(length_sq(belt) > 0);
        if (!as_before || mover.ground.body != id_of_shape(carrier * S::max_shapes_of_body)) keep_place(mover);
    }

    /// What has come of it: velocity and ground.
    template <class Walk>
    void tell(const Walk& walk, const PlacedShape& begin, const PlacedShape& at, const MoverTouches& touches, bool walks, const Vector& v_ground,
              scalar h, const Vector& wanted, Mover& mover) const {
        const Vector& up = mover.up;
        mover.r = at.r;
        MoverFooting footing;
        const int ground_i = walk.ground_of(at.r, touches, !walks, footing);
        Vector v_here{};
        if (ground_i >= 0) v_here = velocity_at(touches.touches[ground_i].slot, touches.touches[ground_i].P);
        if (!walks) {
            const Vector left = walk.clipped(touches, wanted);
            // What it runs against turns none of its speed upwards.
            const scalar rises = min(dot(up, left), max(dot(up, wanted), dot(up, v_here)));
            mover.v = left + up * (rises - dot(up, left));
            mover.v_drift = walk.clipped(touches, mover.v_drift);
            mover.v_drift = mover.v_drift - up * dot(up, mover.v_drift);
            // On its way up it passes by.
            const bool leaves = ground_i >= 0 && dot(touches.touches[ground_i].upright, mover.v - v_here) > limits::edge_tilt * S::length_unit;
            if (footing == MoverFooting::walkable && leaves) footing = MoverFooting::none;
        } else {
            const Vector by = (at.r - begin.r) * (1 / h);
            mover.v = by - up * dot(up, by) + v_ground;
        }
        mover.ground = {};
        mover.ground.footing = footing;
        if (ground_i < 0 || footing == MoverFooting::none) return;
        const MoverTouch& ground = touches.touches[ground_i];
        mover.ground = {footing, id_of_shape(ground.slot), number_of_shape(ground.slot), ground.upright, ground.P, walks ? v_ground : v_here};
        if (footing == MoverFooting::walkable && !walks) {
            mover.v = mover.v - up * dot(up, mover.v - v_here);
            mover.v_drift = {};
        }
    }
    /// Where it is on what it stands on.
    void keep_place(Mover& mover) const {
        mover.r_in_ground = {};
        const int carrier = carrier_of(mover);
        if (carrier == no_slot) return;
        const BodyState state = read_state(storage_.bodies(), carrier);
        mover.r_in_ground = transpose_times(state.A, mover.r - state.r_CM);
    }
    static bool same(const Vector& a, const Vector& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

    /// What is in the way goes with it, as far as its force reaches: an impact without restitution (Fig. 4), by force_max h at most.
    void push(const Mover& mover, const MoverTouches& touches, const Vector& wanted, scalar h) {
        const BodyView bodies = storage_.bodies();
        for (int i = 0; i < touches.count; ++i) {  // bound: movers::planes_max
            const MoverTouch& touch = touches.touches[i];
            const int slot = touch.slot / S::max_shapes_of_body;
            if (!is_dynamic(bodies, slot) || dot(touch.upright, mover.up) >= limits::same_plane_cos) continue;
            (void)touched(slot, push_body(bodies, slot, wanted, touch.P, touch.n, mover.force_max * h));
        }
    }
};

} }  // namespace ingot
