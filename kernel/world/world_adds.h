// SPDX-License-Identifier: MIT
// The part of World by which bodies come and go.
#pragma once

#include "world_mover.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls of World, see world.h.
template <class S>
class WorldAdds : public WorldMover<S> {
    static constexpr int max_bodies = S::max_bodies;

protected:
    using Base = WorldMover<S>;
    using Base::storage_;
    using Base::compounds_only;
    using Base::levels_only;
    using Base::lives;
    using Base::id_of;
    using Base::find;

public:
    using Base::remove;  // of a joint

    // Bodies.

    /// Adds a body in the lowest free slot.
    /// Errors: no_room, and what BodyDef's parts may have wrong: see check_mass_properties, check_state, check_shape;
    ///         bad_restitution; bad_friction; immovable (one that has a velocity, or is kinematic too); not_in_scene (a shape the scene does not
    ///         name, a filter, a sensor or a restitution where it names none, a kinematic body, a place or velocity where it does not translate);
    ///         bad_shape (a half space that can move, or is kinematic; a hull that is none of the scene's; a level: see add_level).
    /// Cost:   O(1), or O(max_bodies) after removals.
    Result<BodyId> add(const BodyDef& def) {
        const Status status = is_level(def.shape) ? Status::bad_shape : check_add(def);
        if (status != Status::ok) return {status, {}};
        const int slot = free_slot();
        if (slot == max_bodies) return {Status::no_room, {}};

        write_slot(slot, def);
        write_shape(slot, 0, def, {{}, identity_matrix<scalar>()});
        if constexpr (has_compounds<S>) place_shapes(storage_.bodies(), storage_.compound_view(), slot);
        storage_.hold_shapes(slot);
        return {Status::ok, id_of(slot)};
    }

    /// Adds a body of several shapes: see shape/compound.h. The definition has no shape of its own; its restitution, friction and sensor are
    /// not looked at.
    /// Errors: those of add, for the definition and each shape; out_of_range (fewer than one; a place beyond limits::position_max), no_room (more
    ///         than max_shapes_of_body), bad_shape (one that is none; a definition with a shape), not_a_rotation (an A, or mass.A_principal).
    Result<BodyId> add(const BodyDef& def, const ShapeDef* shapes, int shape_count) {
        static_assert(compounds_only());
        Status status = check_mass_frame(def.mass);
        if (def.shape.kind != ShapeKind::none) status = Status::bad_shape;
        if (shapes == nullptr || shape_count < 1) status = Status::out_of_range;
        if (shape_count > S::max_shapes_of_body) status = Status::no_room;
        // bound: max_shapes_of_body: more are refused before
        for (int shape_i = 0; shape_i < shape_count && status == Status::ok; ++shape_i) {
            status = check_place(shapes[shape_i], def.mass);
            if (status == Status::ok) status = is_level(shapes[shape_i].shape) ? Status::bad_shape : check_add(with_shape(def, shapes[shape_i]));
        }
        if (status != Status::ok) return {status, {}};
        const int slot = free_slot();
        if (slot == max_bodies) return {Status::no_room, {}};

        write_slot(slot, def);
        for (int shape_i = 0; shape_i < shape_count; ++shape_i) {
            const ShapePlace place = place_in_body(shapes[shape_i], def.mass);
            write_shape(slot, shape_i, with_shape(def, shapes[shape_i]), {place.r + Vector{}, nearest_rotation(place.A)});
        }
        place_shapes(storage_.bodies(), storage_.compound_view(), slot);
        storage_.hold_shapes(slot);
        return {Status::ok, id_of(slot)};
    }
    /// The same, of an array.
    template <unsigned N>
    Result<BodyId> add(const BodyDef& def, const ShapeDef (&shapes)[N]) { return add(def, shapes, static_cast<int>(N)); }

    /// Puts a level of the scene into the world: ground that no force moves. The id is that of a body, whose r_CM is the middle of the box that holds
    /// the level, and whose A its axes. It takes level_patches slots of shapes, one behind the other: so many bodies of max_bodies where each has
    /// one shape.
    /// Errors: bad_shape (a number that is none of the scene's), those of check_state, bad_restitution, bad_friction (of its own, or of a material),
    ///         not_finite; not_in_scene (a filter or a restitution where the scene names none); no_room.
    Result<BodyId> add_level(const LevelDef& def) {
        static_assert(levels_only());
        if (def.number < 0 || def.number >= levels_of<S>.count) return {Status::bad_shape, {}};
        BodyDef body = body_of_level(levels_of<S>.levels[def.number], def);
        const Status status = check_level_add(levels_of<S>.levels[def.number], body);
        if (status != Status::ok) return {status, {}};
        const int slot = free_slots_for_level();
        if (slot == max_bodies) return {Status::no_room, {}};
        const int32_t hint = storage_.free_hint;
        for (int patch_i = 0; patch_i < level_patches; ++patch_i) {
            if (patch_i % S::max_shapes_of_body == 0) write_slot(slot + patch_i / S::max_shapes_of_body, body);
            body.shape.offset = static_cast<scalar>(def.number * level_patches + patch_i);
            write_shape(slot + patch_i / S::max_shapes_of_body, patch_i % S::max_shapes_of_body, body, {{}, identity_matrix<scalar>()});
        }
        if (hint < slot && free_slot_from(hint) < slot) storage_.free_hint = hint;
        for (int k = 0; k < bodies_of_level<S>; ++k) {  // bound: level_patches
            if constexpr (has_compounds<S>) place_shapes(storage_.bodies(), storage_.compound_view(), slot + k);
            storage_.hold_shapes(slot + k);
        }
        return {Status::ok, id_of(slot)};
    }

    /// Takes a body out. Its id, and every copy of it, is stale from now on.
    Status remove(BodyId id) {
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        storage_.over_bodies_of(slot.value, [this](int of_body) { free_slot_of(of_body); });
        return Status::ok;
    }

private:
    /// As it is, and with each of its materials.
    Status check_level_add(const LevelTable& level, const BodyDef& def) const {
        Status status = check_add(def);
        if (level.material_count < 0 || level.material_count > LevelMaterial::count_max) return Status::bad_shape;
        if (level.material_count > 0 && level.materials == nullptr) return Status::bad_shape;
        for (int i = 0; i < level.material_count && status == Status::ok; ++i) {  // bound: LevelMaterial::count_max
            BodyDef of_material = def;
            of_material.friction = level.materials[i].friction;
            of_material.restitution = level.materials[i].restitution;
            status = check_add(of_material);
        }
        return status;
    }
    void free_slot_of(int slot) {
        features::All::over_named<S>([&](auto feature) { decltype(feature)::before_removal(storage_, slot); });
        ++storage_.generation[slot];
        if (slot < storage_.free_hint) storage_.free_hint = slot;
        set_identity_body(storage_.bodies(), slot);
        storage_.set_generation_of_shapes(slot, storage_.generation[slot]);
        // bound: max_shapes_of_body
        for (int shape_slot = slot * S::max_shapes_of_body; shape_slot < (slot + 1) * S::max_shapes_of_body; ++shape_slot)
            features::All::over_named<S>([&](auto feature) { decltype(feature)::forget_shape(storage_, shape_slot); });
        features::All::over_named<S>([&](auto feature) { decltype(feature)::forget_body(storage_, slot); });
    }

    /// All that World::add asks of a body of one shape.
    Status check_add(const BodyDef& def) const {
        Status status = Status::ok;
        if constexpr (has_shapes<S>) status = check_surface(def);
        if (status == Status::ok) status = check_definition(as_placed(def), S::translates, has_shapes<S> && S::shapes::has(def.shape.kind));
        if (status == Status::ok && !ShapesOf<S>::names_its_hull(def.shape)) status = Status::bad_shape;
        features::All::over_checking_definitions([&](auto feature) {
            const Status of_feature = decltype(feature)::template check_def<S>(def);
            if (of_feature != Status::ok) status = of_feature;
        });
        if constexpr (has_shapes<S> && !S::bounces)
            if (def.restitution > 0) status = Status::not_in_scene;
        return status;
    }

    /// What the tiles hold of a definition: a kinematic body stands still between two steps.
    static decltype(auto) as_placed(const BodyDef& def) {
        if constexpr (S::kinematic_bodies)
            return def.kinematic ? features::KinematicBodies::standing(def) : def;
        else
            return (def);
    }

    void write_slot(int slot, const BodyDef& def) {
        if (slot == storage_.slots_used) begin_slot();
        storage_.free_hint = slot + 1;
        ++storage_.generation[slot];
        write_body(storage_.bodies(), slot, as_placed(def));
        storage_.set_generation_of_shapes(slot, storage_.generation[slot]);
        features::All::over_named<S>([&](auto feature) { decltype(feature)::begin_body(storage_, slot, def); });
    }
    void write_shape(int slot, int shape_i, const BodyDef& def, const ShapePlace& place) {
        const int shape_slot = slot * S::max_shapes_of_body + shape_i;
        features::All::over_named<S>([&](auto feature) { decltype(feature)::begin_shape(storage_, shape_slot, def, place); });
    }

    bool is_free(int slot) const { return ingot::is_free(storage_.generation[slot]); }
    int free_slot_from(int slot) const {
        if constexpr (max_bodies == 1)
            return slot == 0 && is_free(0) ? 0 : 1;
        else
            return next_free(storage_.generation, slot, max_bodies);
    }
    /// The lowest slot that is free and whose generation is not used up; max_bodies if there is none.
    int free_slot() const { return free_slot_from(storage_.free_hint); }
    /// The first of so many that a level takes.
    int free_slots_for_level() const {
        int first = free_slot();
        // bound: max_bodies
        for (int slot = first; slot < first + bodies_of_level<S> && first < max_bodies; ++slot)
            if (slot >= max_bodies)
                first = max_bodies;
            else if (!is_free(slot))
                slot = first = free_slot_from(slot + 1), --slot;
        return first;
    }
    static bool is_level([[maybe_unused]] const Shape& shape) { return has_levels<S> && shape.kind == ShapeKind::level; }

    /// Takes a new slot into use. With the first lane of a tile all its lanes become the identity body.
    void begin_slot() {
        const int slot = storage_.slots_used++;
        if constexpr (has_compounds<S>) begin_shape_slots(slot);
        if (slot % lanes != 0) return;
        for (int lane_i = 0; lane_i < lanes; ++lane_i) set_identity_body(storage_.bodies(), slot + lane_i);
        if constexpr (S::sleeps && !has_compounds<S>) empty_bounds(storage_, slot, slot + lanes - 1);
    }
    /// The same for the slots of its shapes.
    void begin_shape_slots(int slot) {
        const int first = slot * S::max_shapes_of_body, last = first + S::max_shapes_of_body - 1;
        // bound: max_shapes_of_body and lanes
        for (int shape_slot = first; shape_slot <= last / lanes * lanes + lanes - 1; ++shape_slot) set_identity_body(storage_.shapes(), shape_slot);
        if constexpr (S::sleeps) empty_bounds(storage_, first, last / lanes * lanes + lanes - 1);
    }
};

} }  // namespace ingot
