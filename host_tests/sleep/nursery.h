// SPDX-License-Identifier: MIT
// Worlds in which anything may happen to bodies that sleep in part.
#pragma once

#include "sleep/sleepers.h"

namespace ingot_sleep {

/// Small numbers that depend on the seed alone.
class Dice {
public:
    explicit Dice(uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 1) {}
    int below(int n) {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<int>((state_ >> 33) % static_cast<uint64_t>(n));
    }
    scalar between(scalar low, scalar high) { return low + (high - low) * static_cast<scalar>(below(1024)) / 1024; }

private:
    uint64_t state_;
};

/// Boxes and balls on a floor, all of whose lives are short: few slots, so that tiles mix who sleeps with who does not.
template <class Method, class BroadPhase = ingot::AllPairs>
struct Nursery : ingot::Scene {
    static constexpr int max_bodies = 13, max_manifolds = 30, max_overlaps = 20;
    static constexpr bool translates = true, filters = true, sleeps = true;
    static constexpr scalar sleep_time = scalar(0.1);
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using rotation = Method;
    using broad_phase = BroadPhase;
};
/// Bodies of two shapes too.
template <class BroadPhase>
struct Compounds : Nursery<ingot::MoserVeselov, BroadPhase> {
    static constexpr int max_shapes_of_body = 2, max_manifolds = 50;
};
/// With room for few pairs, so that some are lost.
template <class BroadPhase>
struct Crowd : Nursery<ingot::MoserVeselov, BroadPhase> {
    static constexpr int max_pairs = 14;
};

template <class S>
void begin(ingot::World<S>& world) {
    std::memset(static_cast<void*>(&world), 0, sizeof world);
    ASSERT_EQ(world.set_gravity(OnEarth::gravity), Status::ok);
    ingot::BodyDef floor = flat_ground(0).def;
    floor.friction = scalar(0.5);
    ASSERT_TRUE(world.add(floor).ok());
}

template <class S>
BodyId anyone(const ingot::World<S>& world, Dice& dice) {
    return world.body_at(dice.below(S::max_bodies));
}

/// A stick with a ball at its end, or an L of two boxes.
template <class S>
void add_parts(ingot::World<S>& world, Dice& dice, scalar x, scalar y) {
    const ingot::ShapeDef boxes[] = {{ingot::Box{{scalar(0.3), scalar(0.2), scalar(0.1)}}, {}},
                                     {ingot::Box{{scalar(0.1), scalar(0.2), scalar(0.3)}}, {scalar(-0.2), 0, scalar(0.4)}}};
    const ingot::ShapeDef club[] = {{ingot::Box{{scalar(0.1), scalar(0.1), scalar(0.3)}}, {}}, {ingot::Sphere{scalar(0.2)}, {0, 0, scalar(0.4)}}};
    const ingot::ShapeDef(&parts)[2] = dice.below(2) == 0 ? boxes : club;
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::solid_of_shapes(10, parts)).value;
    def.state = ingot::body_state(def.mass, {{x, y, 1}});
    def.immovable = dice.below(8) == 0;
    (void)world.add(def, parts);
}

/// One random call, of all that there are.
template <class S>
void live(ingot::World<S>& world, Dice& dice) {
    const BodyId one = anyone(world, dice);
    const scalar x = dice.between(-2, 2), y = dice.between(-2, 2);
    switch (dice.below(60)) {
        case 0:
        case 1:
        case 2: {
            if constexpr (S::max_shapes_of_body > 1) {
                if (dice.below(2) == 0) {
                    add_parts(world, dice, x, y);
                    break;
                }
            }
            PlacedBody body =
                dice.below(3) == 0 ? solid_ball(1, scalar(0.3), {x, y, 1}, 0) : solid_box(1, {scalar(0.3), scalar(0.4), scalar(0.25)}, {x, y, 1}, 0);
            body.def.friction = scalar(0.5);
            body.def.sensor = dice.below(6) == 0;
            body.def.immovable = body.def.sensor || dice.below(8) == 0;
            (void)world.add(body.def);
            break;
        }
        case 3:
            if (one.slot != 0) (void)world.remove(one);
            break;
        case 4: (void)world.apply_impulse(one, {x, y, 1}, {x, y, scalar(0.3)}); break;
        case 5: (void)world.add_torque(one, {x, y, 0}); break;
        case 6: (void)world.set_filter(one, {1u, dice.below(2) == 0 ? 1u : 3u}); break;
        case 7: {
            const ingot::Result<BodyState> state = world.state(one);
            if (!state.ok() || one.slot == 0) break;
            BodyState moved = state.value;
            moved.r_CM.x += scalar(0.05);
            (void)world.set_state(one, moved);
            break;
        }
        case 8: (void)world.wake(one); break;
        case 9: (void)world.sleep(one); break;
        case 10: (void)world.set_gravity({0, 0, dice.below(4) == 0 ? scalar(-5) : scalar(-9.81)}); break;
        default:
            for (int step_i = 0; step_i < 4; ++step_i) ASSERT_EQ(ingot::step(world, h).status, Status::ok);
    }
}

}  // namespace ingot_sleep
