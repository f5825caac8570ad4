// SPDX-License-Identifier: MIT
// A crowd of chance: heaps, towers and what rolls, in many islands, with whatever a scene names put to use.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "level/small_levels.h"
#include "scenes/contact/placed_body.h"
#include "scenes/contact/stacks.h"
#include "scenes/random.h"

namespace cores_test {

using ingot::scalar;
using ingot::Vector;

struct Crowded : ingot::Scene {
    static constexpr int max_bodies = 420;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 1800;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
    using broad_phase = ingot::SortedTree;
};

enum class Lie { apart, in_one_heap };

template <class S>
class Crowd {
public:
    explicit Crowd(uint64_t seed, Lie lie = Lie::apart) : lie_(lie), random_(seed) {
        expect(world.set_gravity({0, 0, -scenes::standard_gravity}));
        add(scenes::half_space({0, 0, 1}, 0, scalar(0.5)));
        const int groups = 12 + static_cast<int>(8 * (1 + random_.symmetric()));
        const scalar pitch = lie == Lie::apart ? scalar(9) : scalar(1.6);
        for (int group_i = 0; group_i < groups; ++group_i) add_group({scalar(group_i % 5) * pitch, scalar(group_i / 5) * pitch, 0});
        if (lie == Lie::in_one_heap) add_pit();
        if constexpr (ingot::has_levels<S>) add_levels();
        if constexpr (S::max_joints > 0) join();
    }

    /// Before step step_i: somebody is hit, something that moves by itself goes on.
    void edit(int step_i) {
        const ingot::BodyId id = loose_[static_cast<std::size_t>(step_i * 37) % loose_.size()];
        if (step_i % 7 == 3) (void)world.apply_central_impulse(id, random_.symmetric_vector() * 20);
        if (step_i == 31) (void)world.add_central_force(id, {0, 0, scalar(1e30)});  // it goes out of range
        if constexpr (S::kinematic_bodies)
            for (std::size_t i = 0; i < moved_.size(); ++i)
                if (step_i % 16 == 0)
                    expect(world.set_velocity(moved_[i], {0, 0, step_i % 32 == 0 ? scalar(0.5) : scalar(-0.5)}, {0, 0, scalar(i % 3)}));
        if constexpr (S::continuous)
            if (step_i % 20 == 10 && lie_ == Lie::apart) (void)world.apply_central_impulse(id, {random_.symmetric() * 3000, 0, -200});
    }

    ingot::World<S> world = {};

private:
    static void expect(ingot::Status status) { ASSERT_EQ(ingot::name(status), std::string(ingot::name(ingot::Status::ok))); }

    ingot::BodyId add(const scenes::PlacedBody& body) {
        ingot::BodyDef def = body.def;
        def.friction = body.mu;
        if (!S::bounces) def.restitution = 0;
        if (!S::shapes::has(def.shape.kind)) def.shape = ingot::Sphere{scalar(0.4)};
        const auto id = world.add(def);
        expect(id.status);
        if (!def.immovable) loose_.push_back(id.value);
        if constexpr (S::rolling_resistance)
            if (def.shape.kind == ingot::ShapeKind::sphere) expect(world.set_rolling_resistance(id.value, scalar(0.01)));
        if constexpr (S::surface_velocities)
            if (def.immovable && def.shape.kind == ingot::ShapeKind::box) expect(world.set_surface_velocity(id.value, {1, 0, 0}));
        return id.value;
    }

    /// One of: a tower, a heap, a lift or belt with a heap on it, what rolls.
    void add_group(const Vector& place) {
        const int kind = static_cast<int>(2 * (1 + random_.symmetric()));
        const scalar mu = scalar(0.5), e = scalar(0.25) * (1 + random_.symmetric());
        if (kind == 2) add_floor(place + Vector{0, 0, scalar(0.25)});
        const int count = 6 + static_cast<int>(8 * (1 + random_.symmetric()));
        for (int i = 0; i < count; ++i) {
            const scalar size = scalar(0.3) + scalar(0.1) * random_.symmetric();
            Vector at = place + Vector{0, 0, scalar(0.6) + scalar(0.62) * scalar(i)};
            if (kind != 0) at = at + Vector{random_.symmetric() * scalar(0.6), random_.symmetric() * scalar(0.6), 0};
            if (kind == 3) at = place + Vector{scalar(i % 4) - scalar(1.5), scalar(i / 4) - 2, scalar(0.5)};
            scenes::PlacedBody body = kind == 0 ? scenes::solid_box(1, {scalar(0.3), scalar(0.3), scalar(0.3)}, at - Vector{0, 0, scalar(0.3)}, mu)
                                                : shape_of_chance(size, at, mu, e);
            if (kind == 3) body.move({3 * random_.symmetric(), random_.symmetric(), 0}, random_.symmetric_vector() * 5);
            add(body);
        }
    }
    scenes::PlacedBody shape_of_chance(scalar size, const Vector& at, scalar mu, scalar e) {
        const int kind = static_cast<int>(2 * (1 + random_.symmetric()));
        scenes::PlacedBody body = kind == 0 ? scenes::solid_ball(1, size, at, mu, e) : scenes::solid_box(2, {size, size, size / 2}, at, mu, e);
        if (kind == 2) body.def.shape = ingot::Capsule{size / 2, size};
        if (kind == 3) body.def.shape = ingot::Cylinder{size, size / 2};
        return body;
    }
    void add_floor(const Vector& at) {
        scenes::PlacedBody floor = scenes::fixed_box({3, 3, scalar(0.25)}, at, scalar(0.5));
        if (S::shapes::has(ingot::ShapeKind::box)) {
            const ingot::BodyId id = add(floor);
            if constexpr (S::kinematic_bodies) {
                expect(world.set_kinematic(id));
                moved_.push_back(id);
            }
        }
        if constexpr (S::max_overlaps > 0) {
            floor.def.sensor = true;
            floor.def.state.r_CM.z += 1;
            ingot::BodyDef def = floor.def;
            expect(world.add(def).status);
        }
        if constexpr (S::max_shapes_of_body > 1) {
            ingot::ShapeDef parts[2];
            parts[0].shape = ingot::Box{{scalar(0.5), scalar(0.2), scalar(0.2)}};
            parts[1].shape = ingot::Sphere{scalar(0.3)};
            parts[1].r = {scalar(0.6), 0, 0};
            ingot::BodyDef def = scenes::solid_box(1, {scalar(0.5), scalar(0.2), scalar(0.2)}, at + Vector{0, 0, 8}, scalar(0.5)).def;
            def.shape = {};
            expect(world.add(def, parts, 2).status);
        }
    }
    /// Around the groups: they stay one heap.
    void add_pit() {
        const scalar out = 5, middle = scalar(3.2);
        for (const scalar side : {-out, out}) {
            add(scenes::fixed_box({scalar(0.5), out + 1, 8}, {middle + side, middle, 8}, scalar(0.5)));
            add(scenes::fixed_box({out + 1, scalar(0.5), 8}, {middle, middle + side, 8}, scalar(0.5)));
        }
    }
    void add_levels() {
        for (int i = 0; i < 4; ++i) {
            ingot::LevelDef def;
            def.number = 1;
            def.r = {scalar(9 * i) - 2, -1, 0};
            expect(world.add_level(def).status);
        }
    }
    void join() {
        for (std::size_t i = 0; i + 1 < loose_.size() && world.joint_count() < S::max_joints; i += 5) {
            const auto a = world.state(loose_[i]), b = world.state(loose_[i + 1]);
            if (!a.ok() || !b.ok()) continue;
            ingot::JointDef joint;
            joint.body_A = loose_[i];
            joint.body_B = loose_[i + 1];
            joint.joint = ingot::BallJoint{};
            joint.P = (a.value.r_CM + b.value.r_CM) * scalar(0.5);
            (void)world.add_joint(joint);
        }
    }

    Lie lie_;
    scenes::Random random_;
    std::vector<ingot::BodyId> loose_ = {}, moved_ = {};
};

}  // namespace cores_test
