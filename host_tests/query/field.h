// SPDX-License-Identifier: MIT
// Bodies of all shapes at random places, and what the tests know of them.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "query/solids.h"

namespace query_field {

using ingot::BodyDef;
using ingot::BodyId;
using ingot::PlacedShape;
using ingot::QueryFilter;
using ingot::QueryHit;
using ingot::QueryNearest;
using ingot::Result;
using ingot::scalar;
using ingot::Shape;
using ingot::ShapeKind;
using ingot::Status;
using ingot::Vector;
using ingot::World;
using ingot_collide::exact;
using ingot_reference::RandomInput;
using ingot_reference::to_matrix;
using ingot_reference::to_vector;
using query_oracle::Real;
using query_oracle::V;

struct Field : ingot::Scene {
    static constexpr int max_bodies = 101;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 4;
    static constexpr bool filters = true;
    static constexpr int max_overlaps = 2;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
};

/// Places up to 10 m from the origin, sizes up to 2 m: some thirty roundings of their sum.
inline constexpr double place = 10;
inline constexpr double tolerance = 32 * 12 * static_cast<double>(ingot::epsilon);

inline scalar size(RandomInput& random) { return static_cast<scalar>(random.real(0.2, 2)); }

inline Shape any_shape(RandomInput& random, int kinds = 4) {
    switch (random.integer(0, kinds - 1)) {
        case 0: return ingot::Sphere{size(random)};
        case 1: return ingot::Capsule{size(random), size(random)};
        case 2: return ingot::Box{{size(random), size(random), size(random)}};
        default: return ingot::Cylinder{size(random), size(random)};
    }
}

inline PlacedShape any_placed(RandomInput& random, double where, int kinds = 4) {
    const Shape shape = any_shape(random, kinds);
    return {shape, to_vector(random.vector(where)), to_matrix(random.rotation()), nullptr};
}

inline BodyDef body_of(const PlacedShape& placed) {
    BodyDef def;
    def.mass = {1, {1, 1, 1}, {}, ingot::identity_matrix<scalar>()};
    def.shape = placed.shape;
    def.state.r_CM = placed.r;
    def.state.A = placed.A;
    def.immovable = placed.shape.kind == ShapeKind::half_space;
    return def;
}

/// A body as the world has it, which makes rotations orthonormal.
template <class S>
PlacedShape placed_in(const World<S>& world, BodyId id, const Shape& shape) {
    const ingot::BodyState state = world.state(id).value;
    return {shape, state.r_CM, state.A, nullptr};
}

struct Bodies {
    std::vector<BodyId> ids;
    std::vector<PlacedShape> placed;
};

template <class S>
BodyId put(World<S>& world, const PlacedShape& placed, Bodies& bodies) {
    const BodyId id = world.add(body_of(placed)).value;
    bodies.ids.push_back(id);
    bodies.placed.push_back(placed_in(world, id, placed.shape));
    return id;
}

/// Bodies with gaps between their slots, one without a shape among them.
template <class S>
std::unique_ptr<World<S>> field_of(RandomInput& random, int count, Bodies& bodies, int kinds = 4) {
    auto world = std::make_unique<World<S>>();
    std::vector<BodyId> leaving;
    for (int i = 0; i < count; ++i) {
        if (i % 7 == 3) leaving.push_back(world->add(body_of(any_placed(random, place / 2, kinds))).value);
        if (i == 5) {
            BodyDef none = body_of(any_placed(random, 1));
            none.shape = {};
            (void)world->add(none);
        }
        put(*world, any_placed(random, place, kinds), bodies);
    }
    for (const BodyId id : leaving) (void)world->remove(id);
    return world;
}

inline int index_of(const Bodies& bodies, BodyId id) {
    for (std::size_t i = 0; i < bodies.ids.size(); ++i)
        if (bodies.ids[i] == id) return static_cast<int>(i);
    return -1;
}

}  // namespace query_field
