// SPDX-License-Identifier: MIT
// The part of World that asks what is where.
#pragma once

#include "../query/cast_ray.h"
#include "../query/cast_shape.h"
#include "../query/check_query.h"
#include "../query/find_nearest.h"
#include "../query/find_overlaps.h"
#include "../query/first_few.h"
#include "world_reads.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls of World, see world.h.
template <class S>
class WorldQueries : public WorldReads<S> {
protected:
    using Base = WorldReads<S>;
    using Base::storage_;
    using Base::shapes_only;
    using Base::number_of_shape;
    using Base::id_of_shape;
    using Base::find;

public:
    // Queries, of bodies where they are now: they change nothing, and may be asked between any two calls.
    // Which bodies count says the filter; with except, a body that is gone answers stale_id.
    // Of two that are met at the same place, or are as near, the answer is the one of the lower slot, then the lower shape.
    // Cost: all bodies' bounding balls, `lanes` at once, and the shapes of those that come near. With broad_phase = QueryTree it is O(log bodies)
    // for each shape whose box comes near, from the first step on, and the answers are the same to the bit; a step there takes a look at where each
    // body that is awake is by now, and add, set_state and edits of shapes O(log bodies) more. Thousands of instructions, on x86-64 with 4 lanes, in
    // a heap of 100, 1000 and 10000 bodies (target host_costs_table): a ray 5, 43, 424, by the tree 3, 5, 9; a ball that is cast 14, 61, 458, by the
    // tree 10, 15, 23; overlaps of a ball 6, 42, 399, by the tree 3, 5, 6; what is nearest 5, 36, 349, by the tree 4, 6, 8.

    /// The first body on the way of a ray from a point, m. See QueryHit.
    /// Errors: not_finite, out_of_range (beyond limits::position_max), bad_direction (a way shorter than limits::size_min).
    Result<QueryHit> cast_ray(const Vector& from, const Vector& way, const QueryFilter& filter = {}) const {
        static_assert(shapes_only());
        const Result<int> except = slot_of_exception(filter);
        const Status status = except.ok() ? check_way(from, way) : except.status;
        if (status != Status::ok) return {status, {}};
        const SlotHit hit = over_candidates(
            [&](const auto& all) { return ingot::cast_ray<ShapesOf<S>>(all, from, way, sees(filter, except.value)); });
        return {Status::ok, {id_of_shape(hit.slot), hit.fraction, hit.P, hit.n, number_of_shape(hit.slot)}};
    }

    /// The first body on the way of a shape that does not turn, m; it stops short of it by limits::cast_gap. Triangles of levels are met from
    /// outside, and from behind they are not there. See QueryHit.
    /// Errors: those of cast_ray, of check_shape and check_rotation; bad_shape (none, a half space, a hull without its form).
    Result<QueryHit> cast_shape(const PlacedShape& shape, const Vector& way, const QueryFilter& filter = {}) const {
        static_assert(shapes_only());
        const Result<int> except = slot_of_exception(filter);
        Status status = except.ok() ? check_query_shape(shape) : except.status;
        if (status == Status::ok) status = check_way(shape.r, way);
        if (status != Status::ok) return {status, {}};
        const PlacedShape moving = {shape.shape, shape.r, nearest_rotation(shape.A), shape.hull};
        const SlotHit hit = over_candidates(
            [&](const auto& all) { return ingot::cast_shape<ShapesOf<S>>(all, moving, way, sees(filter, except.value)); });
        return {Status::ok, {id_of_shape(hit.slot), hit.fraction, hit.P, hit.n, number_of_shape(hit.slot)}};
    }

    /// All bodies on the way of a ray, each where it is met first, in the order in which they are met, into found[0 .. capacity). See cast_ray.
    /// Returns: how many there are. More than capacity: those that are met first are kept.
    /// Errors:  those of cast_ray; out_of_range (a capacity below zero).
    Result<int> cast_ray_all(const Vector& from, const Vector& way, QueryHit* found, int capacity, const QueryFilter& filter = {}) const {
        static_assert(shapes_only());
        const Result<int> except = slot_of_exception(filter);
        Status status = except.ok() ? check_way(from, way) : except.status;
        if (status == Status::ok && capacity < 0) status = Status::out_of_range;
        if (status != Status::ok) return {status, 0};
        return {Status::ok, list_hits({from, way, 0, 1, nullptr}, found, capacity, sees(filter, except.value),
                                      [&](const EveryShape& all, int slot, SlotHit& hit) {
                                          return cast_ray_on_slot<ShapesOf<S>>(all, from, way, slot, hit);
                                      })};
    }

    /// The same of a shape that does not turn: see cast_shape.
    /// Errors: those of cast_shape; out_of_range (a capacity below zero).
    Result<int> cast_shape_all(const PlacedShape& shape, const Vector& way, QueryHit* found, int capacity, const QueryFilter& filter = {}) const {
        static_assert(shapes_only());
        const Result<int> except = slot_of_exception(filter);
        Status status = except.ok() ? check_query_shape(shape) : except.status;
        if (status == Status::ok) status = check_way(shape.r, way);
        if (status == Status::ok && capacity < 0) status = Status::out_of_range;
        if (status != Status::ok) return {status, 0};
        const PlacedShape moving = {shape.shape, shape.r, nearest_rotation(shape.A), shape.hull};
        return {Status::ok, list_hits({moving.r, way, bounding_radius(moving.shape), 1, &moving}, found, capacity, sees(filter, except.value),
                                      [&](const EveryShape& all, int slot, SlotHit& hit) {
                                          return cast_shape_on_slot<ShapesOf<S>>(all, moving, way, slot, 1, hit);
                                      })};
    }

    /// All bodies that a shape overlaps or touches, in the order of slots, into found[0 .. capacity). Of levels their triangles count, from either
    /// side, and not what lies below them.
    /// Returns: how many there are. More than capacity: those of the lowest slots are kept.
    /// Errors:  those of cast_shape; out_of_range (a capacity below zero).
    Result<int> find_overlaps(const PlacedShape& shape, BodyId* found, int capacity, const QueryFilter& filter = {}) const {
        static_assert(shapes_only());
        const Result<int> except = slot_of_exception(filter);
        Status status = except.ok() ? check_query_shape(shape) : except.status;
        if (status == Status::ok && capacity < 0) status = Status::out_of_range;
        if (status != Status::ok) return {status, 0};
        const PlacedShape still = {shape.shape, shape.r, nearest_rotation(shape.A), shape.hull};
        if constexpr (queries_by_tree<S>)
            return {Status::ok, list_in_any_order(still, found, capacity, sees(filter, except.value))};
        else
            return {Status::ok, list_in_order(still, found, capacity, sees(filter, except.value))};
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
        const SlotNearest nearest = over_candidates(
            [&](const auto& all) { return ingot::find_nearest<ShapesOf<S>>(all, point, within, sees(filter, except.value)); });
        return {Status::ok, {id_of_shape(nearest.slot), nearest.distance, nearest.P, nearest.n, number_of_shape(nearest.slot)}};
    }

protected:
    /// Asks of all shapes, or of the tree, where there is one.
    template <class Ask>
    auto over_candidates(const Ask& ask) const {
        const EveryShape all = {storage_.shapes(), storage_.surface_view()};
        if constexpr (queries_by_tree<S>) {
            const SortedTreeView tree = storage_.query_tree();
            if (*tree.used > 0) return ask(ShapesOfTree{all, tree});
        }
        return ask(all);
    }

private:
    /// Bodies that are met along a way, once each: of several shapes the first that is met counts. Returns how many.
    template <class Sees, class Hits>
    int list_hits(const MovingBall& ball, QueryHit* found, int capacity, const Sees& sees, const Hits& hits) const {
        FirstFew<QueryHit, IsMetBefore> first(found, capacity);
        int count = 0;
        over_candidates([&](const auto& all) {
            look_along(all, ball, [&](int slot) {
                SlotHit hit, other;
                if (!sees(slot) || !hits(all, slot, hit)) return;
                const int begin = slot / S::max_shapes_of_body * S::max_shapes_of_body;
                // bound: max_shapes_of_body
                for (int of_body = begin; of_body < begin + S::max_shapes_of_body; ++of_body) {
                    if (of_body == slot || storage_.surfaces[of_body].shape.kind == ShapeKind::none || !sees(of_body) || !hits(all, of_body, other))
                        continue;
                    if (of_body < slot) return;  // told by that one
                    if (other.fraction < hit.fraction) hit = other;
                }
                first.add({id_of_shape(hit.slot), hit.fraction, hit.P, hit.n, number_of_shape(hit.slot)});
                ++count;
            });
        });
        first.sort();
        return count;
    }

    // Bodies that a shape overlaps, once each. They return how many.

    template <class Sees>
    int list_in_order(const PlacedShape& shape, BodyId* found, int capacity, const Sees& sees) const {
        int count = 0;
        [[maybe_unused]] int last = no_slot;
        ingot::find_overlaps<ShapesOf<S>>(EveryShape{storage_.shapes(), storage_.surface_view()}, shape, sees, [&](int slot) {
            if constexpr (has_compounds<S>) {
                if (slot / S::max_shapes_of_body == last) return;  // by another of its shapes
                last = slot / S::max_shapes_of_body;
            }
            if (count < capacity) found[count] = id_of_shape(slot);
            ++count;
        });
        return count;
    }
    template <class Sees>
    int list_in_any_order(const PlacedShape& shape, BodyId* found, int capacity, const Sees& sees) const {
        FirstFew<BodyId, HasLowerSlot> lowest(found, capacity);
        int count = 0;
        over_candidates([&](const auto& all) {
            ingot::find_overlaps<ShapesOf<S>>(all, shape, sees, [&](int slot) {
                // bound: max_shapes_of_body: a body is counted by the first of its shapes that overlaps
                for (int before = slot / S::max_shapes_of_body * S::max_shapes_of_body; before < slot; ++before)
                    if (storage_.surfaces[before].shape.kind != ShapeKind::none && sees(before) && overlaps_slot<ShapesOf<S>>(all, shape, before))
                        return;
                lowest.add(id_of_shape(slot));
                ++count;
            });
        });
        lowest.sort();
        return count;
    }

    /// The slot that a query leaves out.
    Result<int> slot_of_exception(const QueryFilter& filter) const {
        return filter.except.generation == 0 ? Result<int>{Status::ok, no_slot} : find(filter.except);
    }

protected:
    /// Of a level one of its shapes stands for all of it.
    bool is_first_of_level(int shape_slot) const {
        const Shape& shape = storage_.surfaces[shape_slot].shape;
        return shape.kind != ShapeKind::level || patch_number(shape) == 0;
    }
    /// Which bodies a query looks at, slot by slot.
    auto sees(const QueryFilter& filter, int except) const {
        return [this, filter, except](int slot) {
            if (slot / S::max_shapes_of_body == except || !meet(filter.filter, storage_.filter_view().of(slot))) return false;
            if constexpr (has_levels<S>)
                if (!is_first_of_level(slot)) return false;
            if constexpr (has_sensors<S>) return filter.sensors || storage_.is_sensor[slot] == 0;
            return true;
        };
    }
};

} }  // namespace ingot
