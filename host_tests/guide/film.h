// SPDX-License-Identifier: MIT
// What an example did, step by step, for a picture of it.
#pragma once

#include <ingot/ingot.h>

#include <vector>

namespace film {

struct Thing {
    ingot::PlacedShape shape;
    bool moves, has_shape;
};
struct Moment {
    double time;  ///< s
    std::vector<Thing> things;
};

/// Of the world that was stepped first, in the order of slots: before the first step, and after each.
inline std::vector<Moment> moments;
inline const void* world_of_film = nullptr;

template <class S>
void note(const ingot::World<S>& world, double time) {
    Moment moment = {time, {}};
    for (int slot = 0; slot < ingot::World<S>::max_bodies; ++slot) {
        const ingot::BodyId id = world.body_at(slot);
        if (!world.is_alive(id)) continue;
        const ingot::BodyState state = world.state(id).value;
        Thing thing = {{{}, state.r_CM, state.A, nullptr}, true, false};
        if constexpr (ingot::has_shapes<ingot::SceneOf<S>>) {
            const ingot::Result<ingot::PlacedShape> shape = world.placed_shape(id);
            if (shape.ok()) thing.shape = shape.value;
            thing.has_shape = shape.ok();
            thing.moves = world.is_movable(id);
        }
        moment.things.push_back(thing);
    }
    moments.push_back(moment);
}

}  // namespace film

namespace ingot {

/// The examples' step: see pictures.cpp.
template <class S>
StepReport filmed_step(World<S>& world, scalar h) {
    if (film::moments.empty()) {
        film::world_of_film = &world;
        film::note(world, 0);
    }
    const StepReport report = step(world, h);
    if (&world == film::world_of_film) film::note(world, film::moments.back().time + static_cast<double>(h));
    return report;
}

}  // namespace ingot
