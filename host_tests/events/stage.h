// SPDX-License-Identifier: MIT
// Scenes and bodies that the tests of filters, sensors and events share.
#pragma once

#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <string.h>

namespace events_stage {

using ingot::BodyDef;
using ingot::BodyFilter;
using ingot::BodyId;
using ingot::scalar;
using ingot::Shape;
using ingot::Status;
using ingot::StepReport;
using ingot::Vector;
using ingot::World;

inline constexpr scalar h = scalar(1) / 64;  // exact
inline constexpr scalar g = scalar(9.8125);  // exact

/// Names contacts and none of the rest.
struct Plain : ingot::Scene {
    static constexpr int max_bodies = 9;  // leaves lanes empty in tiles of 2, 4, 8 and 16
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 32;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::HalfSpace>;
};

inline BodyDef body(const Shape& shape, const Vector& r_CM, const Vector& v_CM = {}) {
    BodyDef def;
    def.mass = ingot::MassProperties{1, {1, 1, 1}, {}, ingot::identity_matrix<scalar>()};
    def.shape = shape;
    def.state.r_CM = r_CM;
    def.state.v_CM = v_CM;
    return def;
}
inline BodyDef ball(scalar radius, const Vector& r_CM, const Vector& v_CM = {}) { return body(ingot::Sphere{radius}, r_CM, v_CM); }
inline BodyDef fixed(const Shape& shape, const Vector& r_CM = {}) {
    BodyDef def = body(shape, r_CM);
    def.immovable = true;
    return def;
}
inline BodyDef ground() { return fixed(ingot::HalfSpace{{0, 0, 1}, 0}); }
inline BodyDef sensor(BodyDef def) {
    def.sensor = true;
    return def;
}
inline BodyDef filtered(BodyDef def, uint32_t category, uint32_t mask) {
    def.filter = {category, mask};
    return def;
}

template <class S>
bool same_bytes(const World<S>& a, const World<S>& b) {
    return memcmp(static_cast<const void*>(&a), static_cast<const void*>(&b), sizeof a) == 0;
}
template <class S>
void copy(World<S>& to, const World<S>& from) {
    memcpy(static_cast<void*>(&to), static_cast<const void*>(&from), sizeof to);
}

template <class S>
ingot::BodyState state_of(const World<S>& world, BodyId id) {
    return world.state(id).value;
}
template <class S>
bool same_motion(const World<S>& a, BodyId in_a, const World<S>& b, BodyId in_b) {
    const ingot::BodyState of_a = state_of(a, in_a), of_b = state_of(b, in_b);
    return memcmp(&of_a, &of_b, sizeof of_a) == 0;
}

}  // namespace events_stage
