// SPDX-License-Identifier: MIT
// What bodies are to each other: surfaces, several shapes of one body, and filters.
#pragma once

#include "../edit_bodies.h"
#include "motion.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

template <class S>
inline constexpr int shape_tile_capacity = (shape_capacity<S> + lanes - 1) / lanes;

struct Surfaces : Feature {
    static constexpr uint32_t part = 32;
    template <class S>
    static constexpr bool named = has_shapes<S>;

    template <class S, bool present>
    struct Memory {
        Surface surfaces[static_cast<unsigned>(shape_capacity<S>)] = {};
    };
    template <class S>
    struct Memory<S, false> {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        // bound: the kinds of shapes
        for (int kind = 0; kind <= static_cast<int>(ShapeKind::half_space); ++kind) each(S::shapes::has(static_cast<ShapeKind>(kind)));
        each(S::bounces);
        each(scalar(S::length_unit));
        each(hulls_of<S>.count);
        for (int form = 0; form < hulls_of<S>.count; ++form)  // bound: hulls of the scene
            // bound: limits::hull_vertices_max
            for (int vertex_i = 0; vertex_i < hulls_of<S>.hulls[form].vertex_count; ++vertex_i) each(hulls_of<S>.hulls[form].vertices[vertex_i]);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!S::shapes::has(ShapeKind::hull) || stacks<S>, "hulls are for contacts with friction: set max_manifolds, or name no Hull");
        static_assert(!S::shapes::has(ShapeKind::hull) || hulls_of<S>.count > 0, "a scene with Hull among its shapes says which: set hulls");
        static_assert(S::shapes::has(ShapeKind::hull) || hulls_of<S>.count == 0, "a scene with hulls has Hull among its shapes: set shapes");
        static_assert(S::length_unit >= scalar(1e-5) && S::length_unit <= scalar(1e5), "a typical thing is 1e-5 to 1e5 m large: set length_unit");
        static_assert(are_hulls<S>(), "one of the hulls is none: ask convex_hull for the status");
        static_assert(!has_shapes<S> || has_some_shape<S>(), "bodies that touch have shapes: set shapes, or neither max_manifolds nor max_contacts");
        static_assert(S::bounces || stacks<S>, "impacts without friction bounce: set max_manifolds, or bounces = true");
        return true;
    }
    template <class S>
    static constexpr bool has_some_shape() {
        bool some = false;
        for (int kind = 0; kind <= static_cast<int>(ShapeKind::half_space); ++kind) some = some || S::shapes::has(static_cast<ShapeKind>(kind));
        return some;
    }
    template <class S>
    static void begin_shape(Storage<S>& storage, int shape_slot, const BodyDef& def, const ShapePlace&) {
        write_surface(storage.surfaces[shape_slot], def);
        measure<S>(storage.surfaces[shape_slot]);
    }
    /// Its gaps too, which an assignment may leave as the stack was: equal worlds are equal bytes.
    static void clear(Surface& surface) { INGOT_CLEAR_BYTES(static_cast<void*>(&surface), sizeof surface); }
    /// What the lengths of its contacts are.
    template <class S>
    static void measure(Surface& surface) {
        surface.halvings = halvings_of(least_half_extent(surface.shape, ShapesOf<S>::hull_of(surface.shape)), S::length_unit);
    }
    template <class S>
    static void forget_shape(Storage<S>& storage, int shape_slot) {
        clear(storage.surfaces[shape_slot]);
    }

    struct OfShape : NoNumbers {
        SavedSurface saved;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            saved.numbers(each);
        }
        template <class S>
        void take(const Storage<S>& storage, int shape_slot) {
            const Surface& surface = storage.surfaces[shape_slot];
            saved = {static_cast<uint8_t>(surface.shape.kind), surface.shape.size, surface.shape.offset, surface.e, surface.mu};
            if constexpr (has_levels<S>)
                if (surface.shape.kind == ShapeKind::level) saved.size = name_of(*ShapesOf<S>::level_of(surface.shape));
        }
        template <class S>
        void put(Storage<S>& storage, int shape_slot) const {
            const Shape shape = shape_in_scene<S>();
            Surface& surface = storage.surfaces[shape_slot];
            clear(surface);
            write_shape_of(surface, shape);
            surface.e = saved.e;
            surface.mu = saved.mu;
            measure<S>(surface);
        }
        template <class S>
        bool is_valid(const SavedBody& body) const {
            if constexpr (has_levels<S>)
                if (saved.kind == static_cast<uint8_t>(ShapeKind::level) && (body.inv_I_scale > 0 || !names_level_of<S>())) return false;
            const Shape shape = shape_in_scene<S>();
            const bool in_scene = S::shapes::has(shape.kind) || (shape.kind == ShapeKind::none && !has_compounds<S>);
            return in_scene && ShapesOf<S>::names_its_hull(shape) && ingot::is_valid(saved, body.inv_I_scale > 0) && (S::bounces || saved.e == 0);
        }

    private:
        /// A level is saved under the sum of its tables, in the place of its half extents, which are in them.
        static Vector name_of(const LevelTable& level) {
            return {static_cast<scalar>(level.checksum & 0xffffu), static_cast<scalar>(level.checksum >> 16), 0};
        }
        template <class S>
        bool names_level_of() const {
            if (!(saved.offset >= 0 && saved.offset < static_cast<scalar>(levels_of<S>.count * level_patches))) return false;
            const Vector name = name_of(*ShapesOf<S>::level_of(shape_of(saved)));
            return saved.size.x == name.x && saved.size.y == name.y && saved.size.z == 0;
        }
        template <class S>
        Shape shape_in_scene() const {
            Shape shape = shape_of(saved);
            if constexpr (has_levels<S>)
                if (shape.kind == ShapeKind::level) shape.size = half_extents_of(*ShapesOf<S>::level_of(shape));
            return shape;
        }
    };
};

/// Bodies of several shapes. Shapes as bodies are derived, and always where their bodies are.
struct Compounds : Feature {
    static constexpr uint32_t part = 1024;
    template <class S>
    static constexpr bool named = has_compounds<S>;

    template <class S, bool present>
    struct Memory {
        RotationTile shape_rotation[shape_tile_capacity<S>] = {};
        TranslationTile shape_translation[shape_tile_capacity<S>] = {};
        ShapePlace shape_places[static_cast<unsigned>(shape_capacity<S>)] = {};
        uint32_t shape_generation[static_cast<unsigned>(shape_capacity<S>)] = {};  ///< of the body

        BodyView shape_view(const BodyView&, int slots_used) {
            return {shape_rotation, shape_translation, nullptr, nullptr, (slots_used * S::max_shapes_of_body + lanes - 1) / lanes};
        }
        const ShapePlace* places_of_shapes() const { return shape_places; }
        const uint32_t* generation_of_shapes(const uint32_t*) const { return shape_generation; }
        void set_generation_of_shapes(int slot, uint32_t generation) {
            for (int shape_i = 0; shape_i < S::max_shapes_of_body; ++shape_i) shape_generation[slot * S::max_shapes_of_body + shape_i] = generation;
        }
    };
    template <class S>
    struct Memory<S, false> {
        static BodyView shape_view(const BodyView& bodies, int) { return bodies; }
        static constexpr const ShapePlace* places_of_shapes() { return nullptr; }
        static const uint32_t* generation_of_shapes(const uint32_t* of_bodies) { return of_bodies; }
        static void set_generation_of_shapes(int, uint32_t) {}
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::max_shapes_of_body);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(S::max_shapes_of_body >= 1 && S::max_shapes_of_body <= 255, "a body has 1 to 255 shapes: set max_shapes_of_body");
        static_assert(!has_compounds<S> || stacks<S>,
                      "several shapes of a body are for contacts with friction: set max_manifolds, or max_shapes_of_body = 1");
        static_assert(!has_compounds<S> || (S::max_bodies <= index_max && S::max_shapes_of_body <= index_max / S::max_bodies),
                      "a scene holds up to 65535 shapes, max_shapes_of_body for each body: lower it, or max_bodies");
        static_assert(
            !has_compounds<S> || pairs_with_own<S> <= index_max,
            "a scene holds up to 65535 pairs of shapes, those within each body among them: lower max_pairs, max_bodies or max_shapes_of_body");
        return true;
    }
    template <class S>
    static void begin_shape(Storage<S>& storage, int shape_slot, const BodyDef& def, const ShapePlace& place) {
        storage.surfaces[shape_slot].bounding_radius = radius_about_body(def.shape, place);
        storage.shape_places[shape_slot] = place;
    }
    template <class S>
    static void forget_shape(Storage<S>& storage, int shape_slot) {
        storage.shape_places[shape_slot] = {};
        set_identity_body(storage.shapes(), shape_slot);
    }
    template <class S>
    static void begin_load(Storage<S>& storage) {
        // bound: max_bodies max_shapes_of_body, rounded up to whole tiles
        for (int shape_slot = 0; shape_slot < storage.shapes().tile_count * lanes; ++shape_slot) set_identity_body(storage.shapes(), shape_slot);
    }
    template <class S>
    static void finish_load(Storage<S>& storage) {
        for (int slot = 0; slot < storage.slots_used; ++slot) storage.set_generation_of_shapes(slot, storage.generation[slot]);  // bound: max_bodies
        storage.place_all_shapes();
    }

    struct OfShape : NoNumbers {
        ShapePlace place;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("shape.r", place.r);
            each("shape.A", place.A);
        }
        template <class S>
        void take(const Storage<S>& storage, int shape_slot) {
            place = storage.shape_places[shape_slot];
        }
        template <class S>
        void put(Storage<S>& storage, int shape_slot) const {
            Surface& surface = storage.surfaces[shape_slot];
            surface.bounding_radius = radius_about_body(surface.shape, place);
            storage.shape_places[shape_slot] = place;
        }
        template <class S>
        bool is_valid(const SavedBody&) const {
            return check_vector(place.r, limits::position_max) == Status::ok && is_kept_rotation(place.A);
        }
    };
};

struct Filters : Feature {
    static constexpr uint32_t part = 256;
    template <class S>
    static constexpr bool named = S::filters;

    template <class S, bool present>
    struct Memory {
        BodyFilter filters[static_cast<unsigned>(S::max_bodies)] = {};
        FilterView<S::max_shapes_of_body> filter_view() const { return {filters}; }
    };
    template <class S>
    struct Memory<S, false> {
        static constexpr NoFilters filter_view() { return {}; }
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::filters);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!S::filters || stacks<S>, "filters are for contacts with friction: set max_manifolds, or filters = false");
        return true;
    }
    static constexpr bool checks_definitions = true;
    template <class S>
    static Status check_def(const BodyDef& def) {
        const bool plain = def.filter.category == meets_all.category && def.filter.mask == meets_all.mask;
        return has_shapes<S> && !S::filters && !plain ? Status::not_in_scene : Status::ok;
    }
    template <class S>
    static void begin_body(Storage<S>& storage, int slot, const BodyDef& def) {
        storage.filters[slot] = def.filter;
    }

    struct OfBody : NoNumbers {
        BodyFilter filter;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("filter.category", filter.category);
            each("filter.mask", filter.mask);
        }
        template <class S>
        void take(const Storage<S>& storage, int slot) {
            filter = storage.filters[slot];
        }
        template <class S>
        void put(Storage<S>& storage, int slot) const {
            storage.filters[slot] = filter;
        }
    };
};

} } }  // namespace ingot::features
