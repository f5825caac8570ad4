// SPDX-License-Identifier: MIT
// The part of World that changes what a body is: mass, kind, surfaces and shapes.
#pragma once

#include "../narrow_phase/find_level_manifolds.h"
#include "world_touching.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls of World, see world.h.
template <class S>
class WorldEdits : public WorldTouching<S> {
protected:
    using Base = WorldTouching<S>;
    using Base::storage_;
    using Base::shapes_only;
    using Base::sensors_only;
    using Base::compounds_only;
    using Base::touched;
    using Base::moved;
    using Base::find;
    using Base::find_shape;

public:
    // Edits, between any two steps. They wake the body and what touches it, and count from the next step on, as if the body had been added so: with
    // the same id, place and motion. Where mass, friction or restitution change, contacts go on with the impulses that they had; where shape, kind or
    // sensor change, the contacts of the body are found anew, and what World::contacts told of them is gone. Joints stay, whatever changes: where
    // neither body of one can move any more it does nothing, until one can again; what they are apart by then they draw together in a step, and
    // whole turns that a hinge made meanwhile are not counted.
    // Errors: frozen (all that is of mass and kind); of a shape that the body has not: out_of_range.

    /// Mass and moments of a body that can move, about its centre and axes as they are: r_CM and A_principal are not looked at. v_CM and omega stay.
    /// Errors: those of check_mass_properties, immovable.
    Status set_mass(BodyId id, const MassProperties& mass) {
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        const Status status = write_mass(storage_.bodies(), slot.value, mass);
        if (status == Status::ok) move_shapes(slot.value);
        return moved(slot.value, status);
    }
    /// Principal moments, kg m^2, to the rounding of a division; 0 for an immovable body.
    Result<Vector> inertia(BodyId id) const {
        const Result<int> slot = find(id);
        if (!slot.ok()) return {slot.status, {}};
        return {Status::ok, moments_of_slot(storage_.bodies(), slot.value)};
    }

    /// An immovable or kinematic body may move from now on, and begins at rest. One that can move gets this mass, as by set_mass.
    /// Errors: those of check_mass_properties, bad_shape (a half space cannot move), no_room (its joints would close a loop: see add_joint).
    Status set_movable(BodyId id, const MassProperties& mass) {
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        if (is_dynamic(storage_.bodies(), slot.value)) return set_mass(id, mass);
        Status status = ingot::is_frozen(storage_.bodies(), slot.value) ? Status::frozen : check_mass_properties(mass);
        if (status == Status::ok && has_ground(slot.value)) status = Status::bad_shape;
        const auto change = [&] { write_moments(storage_.bodies(), slot.value, mass); };
        if (status == Status::ok && !has_room_for_joints(slot.value, change)) status = Status::no_room;
        if (status != Status::ok) return status;
        leave_contacts(slot.value);
        change();
        forget_kinematic(slot.value);
        begin_joints(slot.value);
        return come_back(slot.value);
    }
    /// A body stands still from now on, wherever it is, and nothing moves it. One that does so already: ok, and nothing changes.
    /// Errors: no_room (what hangs between it and what cannot move would close a loop: see add_joint).
    Status set_immovable(BodyId id) {
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        if (ingot::is_frozen(storage_.bodies(), slot.value)) return Status::frozen;
        if (!is_dynamic(storage_.bodies(), slot.value)) {
            forget_kinematic(slot.value);
            return Status::ok;
        }
        const auto change = [&] { stop_body(storage_.bodies(), slot.value); };
        if (!has_room_for_joints(slot.value, change)) return Status::no_room;
        leave_contacts(slot.value);
        change();
        begin_joints(slot.value);
        if constexpr (S::body_forces) features::BodyForces::forget_body(storage_, slot.value);
        return come_back(slot.value);
    }
    /// False for immovable, kinematic and frozen bodies, and for ids of none.
    bool is_movable(BodyId id) const {
        const Result<int> slot = find(id);
        return slot.ok() && is_dynamic(storage_.bodies(), slot.value);
    }

    // Surfaces, of a body or of one of its several shapes.

    /// See BodyDef. Errors: not_finite, bad_friction.
    Status set_friction(BodyId id, scalar mu, int shape_i = 0) {
        static_assert(shapes_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        const Status status = shape_slot.ok() ? check_friction(mu) : shape_slot.status;
        // -0 becomes +0: one value, one set of bits
        if (status == Status::ok) set_surfaces(shape_slot.value, [&](Surface& surface) { surface.mu = mu + scalar(0); });
        return status;
    }
    /// The coefficient, as it is now. Errors: those of ids, out_of_range.
    Result<scalar> friction(BodyId id, int shape_i = 0) const {
        static_assert(shapes_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return {shape_slot.status, 0};
        return {Status::ok, storage_.surfaces[shape_slot.value].mu};
    }

    /// See BodyDef. Errors: not_finite, bad_restitution, not_in_scene (one above 0 where bounces = false).
    Status set_restitution(BodyId id, scalar e, int shape_i = 0) {
        static_assert(shapes_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        Status status = shape_slot.ok() ? check_restitution(e) : shape_slot.status;
        if (status == Status::ok && !S::bounces && e > 0) status = Status::not_in_scene;
        if (status == Status::ok) set_surfaces(shape_slot.value, [&](Surface& surface) { surface.e = e + scalar(0); });
        return status;
    }
    /// As it is now, 0 to 1. Errors: those of ids, out_of_range.
    Result<scalar> restitution(BodyId id, int shape_i = 0) const {
        static_assert(shapes_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return {shape_slot.status, 0};
        return {Status::ok, storage_.surfaces[shape_slot.value].e};
    }

    /// Another shape, or one of another size, in the place of that one; mass stays. A body of one shape may have none, and get one.
    /// Errors: those of check_shape, not_in_scene, bad_shape (a half space that can move, a hull that is none of the scene's, none for one of
    ///         several, a level).
    Status set_shape(BodyId id, const Shape& shape, int shape_i = 0) {
        static_assert(shapes_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        if (shape_i < 0 || shape_i >= S::max_shapes_of_body) return Status::out_of_range;
        if (has_compounds<S> && !find_shape(id, shape_i).ok()) return Status::out_of_range;
        const Status status = check_new_shape(slot.value, shape);
        if (status != Status::ok) return status;
        leave_contacts(slot.value);
        const int shape_slot = slot.value * S::max_shapes_of_body + shape_i;
        write_shape_of(storage_.surfaces[shape_slot], shape);
        features::Surfaces::measure<S>(storage_.surfaces[shape_slot]);
        if constexpr (has_compounds<S>)
            storage_.surfaces[shape_slot].bounding_radius = radius_about_body(shape, storage_.shape_places[shape_slot]);
        return come_back(slot.value);
    }
    /// As it is now, in its own frame: see placed_shape for where it is. Errors: those of ids, out_of_range.
    Result<Shape> shape(BodyId id, int shape_i = 0) const {
        static_assert(shapes_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return {shape_slot.status, {}};
        return {Status::ok, storage_.surfaces[shape_slot.value].shape};
    }

    /// Where a shape of a body of several lies: m from the centre of mass, and the shape's axes in those of the body. From the frame of the user it
    /// is place_in_body(part, mass). Mass stays.
    /// Errors: not_finite, out_of_range (beyond limits::position_max), not_a_rotation, bad_shape (a level).
    Status set_shape_place(BodyId id, const ShapePlace& place, int shape_i) {
        static_assert(compounds_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return shape_slot.status;
        if (is_of_level(shape_slot.value)) return Status::bad_shape;
        Status status = check_vector(place.r, limits::position_max);
        if (status == Status::ok) status = check_rotation(place.A);
        if (status != Status::ok) return status;
        const int slot = shape_slot.value / S::max_shapes_of_body;
        leave_contacts(slot);
        storage_.shape_places[shape_slot.value] = {place.r + Vector{}, nearest_rotation(place.A)};
        Surface& surface = storage_.surfaces[shape_slot.value];
        surface.bounding_radius = radius_about_body(surface.shape, storage_.shape_places[shape_slot.value]);
        return come_back(slot);
    }
    /// Where it is in the body, in m. Errors: those of ids, out_of_range.
    Result<ShapePlace> shape_place(BodyId id, int shape_i) const {
        static_assert(compounds_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return {shape_slot.status, {}};
        return {Status::ok, storage_.shape_places[shape_slot.value]};
    }

    /// A shape notes who is in it and touches nothing, or is solid again: see BodyDef. Errors: bad_shape (a level).
    Status set_sensor(BodyId id, bool sensor, int shape_i = 0) {
        static_assert(sensors_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return shape_slot.status;
        if (is_of_level(shape_slot.value)) return Status::bad_shape;
        const int slot = shape_slot.value / S::max_shapes_of_body;
        leave_contacts(slot);
        storage_.is_sensor[shape_slot.value] = sensor ? 1 : 0;
        return come_back(slot);
    }
    /// As it is now. Errors: those of ids, out_of_range.
    Result<bool> is_sensor(BodyId id, int shape_i = 0) const {
        static_assert(sensors_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return {shape_slot.status, false};
        return {Status::ok, storage_.is_sensor[shape_slot.value] != 0};
    }

protected:
    /// Shapes of what cannot move.
    bool has_ground(int slot) const {
        bool has = false;
        if constexpr (has_shapes<S>)
            // bound: max_shapes_of_body
            for (int shape_i = 0; shape_i < S::max_shapes_of_body; ++shape_i)
                has = has || is_ground(storage_.surfaces[slot * S::max_shapes_of_body + shape_i].shape.kind);
        return has;
    }

private:
    void forget_kinematic([[maybe_unused]] int slot) {
        if constexpr (S::kinematic_bodies) storage_.kinematic[slot] = {};
    }
    Status check_new_shape(int slot, const Shape& shape) const {
        const Status status = check_shape(shape);
        if (status != Status::ok) return status;
        if (shape.kind == ShapeKind::none) return has_compounds<S> ? Status::bad_shape : Status::ok;
        if (!S::shapes::has(shape.kind)) return Status::not_in_scene;
        if constexpr (has_levels<S>) {
            const Shape& before = storage_.surfaces[slot * S::max_shapes_of_body].shape;
            if (shape.kind == ShapeKind::level || before.kind == ShapeKind::level) return Status::bad_shape;
        }
        if (shape.kind == ShapeKind::half_space && is_dynamic(storage_.bodies(), slot)) return Status::bad_shape;
        if constexpr (S::kinematic_bodies)
            if (shape.kind == ShapeKind::half_space && ingot::is_kinematic(storage_.kinematic[slot])) return Status::bad_shape;
        return ShapesOf<S>::names_its_hull(shape) ? Status::ok : Status::bad_shape;
    }

    /// Whether its joints can be held when it can move, or when it cannot any more. The change is made to see that, and taken back.
    /// Cost: of a body with joints, a look at all joints.
    template <class Change>
    bool has_room_for_joints([[maybe_unused]] int slot, [[maybe_unused]] const Change& change) {
        if constexpr (has_joints<S>) {
            if (storage_.joint_lists().first_end[slot] == 0) return true;
            RotationTile& rotation = storage_.bodies().rotation[place_of(slot).tile];
            TranslationTile& translation = storage_.bodies().translation[place_of(slot).tile];
            const RotationTile rotation_now = rotation;
            const TranslationTile translation_now = translation;
            change();
            const int lost = features::Figures::joints_without_room(storage_, storage_.joint_slots_used);
            rotation = rotation_now;
            translation = translation_now;
            return lost == 0;
        } else {
            return true;
        }
    }
    /// What they gave was another body's; what hangs on it wakes.
    void begin_joints([[maybe_unused]] int slot) {
        if constexpr (has_joints<S>) {
            storage_.joint_lists().for_ends(static_cast<Index>(slot), [&](int end) {
                features::Figures::forget_impulses(storage_, end / 2);
                features::Figures::forget_reaction(storage_, end / 2);
            });
            if constexpr (S::sleeps) features::Figures::wake_hanging(storage_, slot);
        }
    }
    /// Nothing is known of its contacts any more, as if it left: what it touches wakes.
    void leave_contacts(int slot) {
        if constexpr (S::sleeps) features::Sleep::before_removal(storage_, slot);
        if constexpr (stacks<S>)
            // bound: max_shapes_of_body
            for (int shape_slot = slot * S::max_shapes_of_body; shape_slot < (slot + 1) * S::max_shapes_of_body; ++shape_slot) {
                features::Manifolds::forget_shape(storage_, shape_slot);
                if constexpr (S::sleeps) features::Sleep::forget_shape(storage_, shape_slot);
            }
        if constexpr (collides<S>) features::Impacts::forget_body(storage_, slot);
    }
    /// As if it was added.
    Status come_back(int slot) {
        move_shapes(slot);
        storage_.hold_shapes(slot);
        if constexpr (S::compensated_sums) features::CompensatedSums::forget_body(storage_, slot);
        if constexpr (S::sleeps) begin_awake(storage_.rest_view(), slot);
        return Status::ok;
    }
    void move_shapes([[maybe_unused]] int slot) {
        if constexpr (has_compounds<S>) place_shapes(storage_.bodies(), storage_.compound_view(), slot);
    }
    /// Of a shape, or of all that a level takes. Contacts that are held take friction and restitution as they are now.
    template <class Set>
    void set_surfaces(int shape_slot, const Set& set) {
        storage_.over_shapes_of(shape_slot, [&](int one) {
            set(storage_.surfaces[one]);
            (void)touched(one / S::max_shapes_of_body, Status::ok);
            if constexpr (stacks<S>) mix_materials_of(storage_.surface_view(), storage_.manifold_view(), one);
            if constexpr (has_levels<S>) mix_level_materials_of<ShapesOf<S>>(storage_.surface_view(), storage_.manifold_view(), one);
        });
    }
    bool is_of_level([[maybe_unused]] int shape_slot) const {
        if constexpr (has_levels<S>) return storage_.surfaces[shape_slot].shape.kind == ShapeKind::level;
        return false;
    }
};

} }  // namespace ingot
