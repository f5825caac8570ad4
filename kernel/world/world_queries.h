// SPDX-License-Identifier: MIT
// The part of World that asks what is where.
#pragma once

#include "../query/cast_ray.h"
#include "../query/cast_shape.h"
#include "../query/check_query.h"
#include "../query/find_nearest.h"
#include "../query/find_overlaps.h"
#include "world_contacts.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls of World, see world.h.
template <class S>
class WorldQueries : public WorldContacts<S> {
protected:
    using Base = WorldContacts<S>;
    using Base::storage_;
    using Base::shapes_only;
    using Base::number_of_shape;
    using Base::id_of_shape;
    using Base::find;

public:
    // Queries, of bodies where they are now: they change nothing, and may be asked between any two calls.
    // Which bodies count says the filter; with except, a body that is gone answers stale_id.
    // Cost: all bodies' bounding balls, `lanes` at once, and the shapes of those that come near.

    /// The first body on the way of a ray from a point, m. See QueryHit.
    /// Errors: not_finite, out_of_range (beyond limits::position_max), bad_direction (a way shorter than limits::size_min).
    Result<QueryHit> cast_ray(const Vector& from, const Vector& way, const QueryFilter& filter = {}) const {
        static_assert(shapes_only());
        const Result<int> except = slot_of_exception(filter);
        const Status status = except.ok() ? check_way(from, way) : except.status;
        if (status != Status::ok) return {status, {}};
        const SlotHit hit = ingot::cast_ray<ShapesOf<S>>(storage_.shapes(), storage_.surface_view(), from, way, sees(filter, except.value));
        return {Status::ok, {id_of_shape(hit.slot), hit.fraction, hit.P, hit.n, number_of_shape(hit.slot)}};
    }

    /// The first body on the way of a shape that does not turn, m; it stops short of it by limits::cast_gap. See QueryHit.
    /// Errors: those of cast_ray, of check_shape and check_rotation; bad_shape (none, a half space, a hull without its form).
    Result<QueryHit> cast_shape(const PlacedShape& shape, const Vector& way, const QueryFilter& filter = {}) const {
        static_assert(shapes_only());
        const Result<int> except = slot_of_exception(filter);
        Status status = except.ok() ? check_query_shape(shape) : except.status;
        if (status == Status::ok) status = check_way(shape.r, way);
        if (status != Status::ok) return {status, {}};
        const PlacedShape moving = {shape.shape, shape.r, nearest_rotation(shape.A), shape.hull};
        const SlotHit hit = ingot::cast_shape<ShapesOf<S>>(storage_.shapes(), storage_.surface_view(), moving, way, sees(filter, except.value));
        return {Status::ok, {id_of_shape(hit.slot), hit.fraction, hit.P, hit.n, number_of_shape(hit.slot)}};
    }

    /// All bodies that a shape overlaps or touches, in the order of slots, into found[0 .. capacity).
    /// Returns: how many there are. More than capacity: those of the lowest slots are kept.
    /// Errors:  those of cast_shape; out_of_range (a capacity below zero).
    Result<int> find_overlaps(const PlacedShape& shape, BodyId* found, int capacity, const QueryFilter& filter = {}) const {
        static_assert(shapes_only());
        const Result<int> except = slot_of_exception(filter);
        Status status = except.ok() ? check_query_shape(shape) : except.status;
        if (status == Status::ok && capacity < 0) status = Status::out_of_range;
        if (status != Status::ok) return {status, 0};
        int count = 0;
        [[maybe_unused]] int last = no_slot;
        const PlacedShape still = {shape.shape, shape.r, nearest_rotation(shape.A), shape.hull};
        ingot::find_overlaps<ShapesOf<S>>(storage_.shapes(), storage_.surface_view(), still, sees(filter, except.value), [&](int slot) {
            if constexpr (has_compounds<S>) {
                if (slot / S::max_shapes_of_body == last) return;  // by another of its shapes
                last = slot / S::max_shapes_of_body;
            }
            if (count < capacity) found[count] = id_of_shape(slot);
            ++count;
        });
        return {Status::ok, count};
    }

    /// The body whose surface is nearest to a point, no further away than `within`, m. See QueryNearest.
    /// Errors: not_finite, out_of_range (beyond limits::position_max; within below zero).
    Result<QueryNearest> find_nearest(const Vector& point, scalar within, const QueryFilter& filter = {}) const {
        static_assert(shapes_only());
        const Result<int> except = slot_of_exception(filter);
        Status status = except.ok() ? check_vector(point, limits::position_max) : except.status;
        if (status == Status::ok && !is_finite(within)) status = Status::not_finite;
        if (status == Status::ok && !(within >= 0 && within <= limits::position_max)) status = Status::out_of_range;
        if (status != Status::ok) return {status, {}};
        const SlotNearest nearest =
            ingot::find_nearest<ShapesOf<S>>(storage_.shapes(), storage_.surface_view(), point, within, sees(filter, except.value));
        return {Status::ok, {id_of_shape(nearest.slot), nearest.distance, nearest.P, nearest.n, number_of_shape(nearest.slot)}};
    }

private:
    /// The slot that a query leaves out.
    Result<int> slot_of_exception(const QueryFilter& filter) const {
        return filter.except.generation == 0 ? Result<int>{Status::ok, no_slot} : find(filter.except);
    }
    /// Which bodies a query looks at, slot by slot.
    auto sees(const QueryFilter& filter, int except) const {
        return [this, filter, except](int slot) {
            if (slot / S::max_shapes_of_body == except || !meet(filter.filter, storage_.filter_view().of(slot))) return false;
            if constexpr (has_sensors<S>) return filter.sensors || storage_.is_sensor[slot] == 0;
            return true;
        };
    }
};

} }  // namespace ingot
