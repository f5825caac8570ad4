// SPDX-License-Identifier: MIT
// The part of World that tells where things are, for whoever draws them or looks for a fault.
#pragma once

#include "../broad_phase/bound_shape.h"
#include "world_contacts.h"

namespace ingot { inline namespace INGOT_ABI {

/// A box along the world axes, m. Empty: low above high.
struct BoundsInfo {
    Vector low{}, high{};  ///< a corner
};

/// Where a joint is on both of its bodies; of the world, where it is in the world.
struct JointPlace {
    JointKind kind{};  ///< which
    BodyId A{}, B{};            ///< the null id: the world
    Vector P_A{}, P_B{};        ///< m, world: apart by what a joint gives, or by the length of a rod or a rope
    Vector axis_A{}, axis_B{};  ///< unit, world: see JointDef
};

/// Calls of World, see world.h.
template <class S>
class WorldReads : public WorldContacts<S> {
protected:
    using Base = WorldContacts<S>;
    using Base::storage_;
    using Base::shapes_only;
    using Base::sleep_only;
    using Base::sleeps_in;
    using Base::joints_only;
    using Base::id_of;
    using Base::find;
    using Base::find_shape;

public:
    /// A shape of a body where it is now, as queries take it. Errors: those of ids, out_of_range (a shape that the body has not).
    Result<PlacedShape> placed_shape(BodyId id, int shape_i = 0) const {
        static_assert(shapes_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return {shape_slot.status, {}};
        const BodyState state = read_state(storage_.bodies(), id.slot);
        const Shape& shape = storage_.surfaces[shape_slot.value].shape;
        const ShapePlace* place = nullptr;
        if constexpr (has_compounds<S>) place = storage_.shape_places + shape_slot.value;
        return {Status::ok, place_on_body(shape, place, ShapesOf<S>::hull_of(shape), state.r_CM, state.A)};
    }

    /// The box of a shape by which the last step looked for pairs: it holds the shape, the way it may take, and a skin. Bounds of a half space, and
    /// of what is in a step no more, go on to limits::unbounded; empty before the first step that knows the shape. In scenes with max_manifolds.
    /// Errors: those of placed_shape.
    Result<BoundsInfo> search_bounds(BodyId id, int shape_i = 0) const {
        static_assert(stacks<S>, "bounds are of contacts with friction: set max_manifolds");
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return {shape_slot.status, {}};
        const Place at = place_of(shape_slot.value);
        const BoundsTile& tile = storage_.bounds[at.tile];
        if (is_blank(tile)) return {Status::ok, {bounding::nowhere, -bounding::nowhere}};
        return {Status::ok, {lane_of(tile.fat_low, at.lane), lane_of(tile.fat_high, at.lane)}};
    }

    /// The body that stands for the island of a body, as the last step found it: the one of the lowest slot. Two bodies are of one island when theirs
    /// is the same. In scenes with sleeps. Errors: those of ids, immovable, frozen.
    /// Cost: the depth of a union-find, logarithmic in the mean.
    Result<BodyId> island_of(BodyId id) const {
        static_assert(sleep_only());
        const Result<int> slot = this->find_movable(id);
        if (!slot.ok()) return {slot.status, {}};
        int root = slot.value;
        while (storage_.parent[root] != root) root = storage_.parent[root];  // bound: max_bodies: a parent is never higher
        return {Status::ok, id_of(root)};
    }

    /// Where a joint is. Errors: those of ids.
    Result<JointPlace> joint_place(JointId id) const {
        static_assert(joints_only());
        const Result<int> joint = find(id);
        if (!joint.ok()) return {joint.status, {}};
        const JointRecord& record = storage_.joints[joint.value];
        const BodyView bodies = storage_.bodies();
        const auto id_of_side = [this](Index slot) { return slot == no_body ? BodyId{} : id_of(slot); };
        const auto in_world = [&](Index slot, const Vector& axis) { return slot == no_body ? axis : read_state(bodies, slot).A * axis; };
        JointPlace place;
        place.kind = this->kind_of(joint.value);
        place.A = id_of_side(record.body_A);
        place.B = id_of_side(record.body_B);
        place.P_A = anchor_in_world(bodies, record.body_A, record.frame_A);
        place.P_B = anchor_in_world(bodies, record.body_B, record.frame_B);
        place.axis_A = in_world(record.body_A, record.frame_A.axis);
        place.axis_B = in_world(record.body_B, record.frame_B.axis);
        return {Status::ok, place};
    }
};

} }  // namespace ingot
