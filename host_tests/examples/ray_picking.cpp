// SPDX-License-Identifier: MIT
// A click picks the crate under it: a ray through the pixel, and a push where it meets the crate. A crate behind another is not met, and what is off
// the crates picks the ground, or nothing.
#include <ingot/ingot.h>

#include <cstdio>

struct Yard : ingot::Scene {
    static constexpr int max_bodies = 4, max_manifolds = 8;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
static ingot::World<Yard> world;

/// The way of the ray through a pixel of 320 x 240, of a camera at height 2 m that looks along y, 90 degrees wide.
static ingot::Vector way_through(int column, int row) {
    return {static_cast<ingot::scalar>(column - 160) * 0.5f, 80, static_cast<ingot::scalar>(120 - row) * 0.5f};
}

int main() {
    const ingot::Vector eye = {0, -6, 2}, half_extents = {0.5f, 0.5f, 0.5f};
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    ingot::BodyDef crate;
    crate.mass = ingot::principal(ingot::solid_box(200, half_extents)).value;
    crate.shape = ingot::Box{half_extents};
    bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok;
    const ingot::BodyId ground_id = world.add(ground).value;
    crate.state.r_CM = {0, 0, 0.5f};
    const ingot::BodyId front = world.add(crate).value;
    crate.state.r_CM = {0, 4, 0.5f};
    const ingot::BodyId behind = world.add(crate).value;
    crate.state.r_CM = {2, 0, 0.5f};
    const ingot::BodyId aside = world.add(crate).value;

    const auto pick = [&](int column, int row) { return world.cast_ray(eye, way_through(column, row)).value; };
    const ingot::QueryHit middle = pick(160, 165), right = pick(210, 165), floor = pick(60, 165), sky = pick(160, 20);
    good = good && middle.body == front && right.body == aside && floor.body == ground_id && !sky.found();
    // What is in front may be left out: then the one behind is there.
    ingot::QueryFilter through;
    through.except = front;
    good = good && world.cast_ray(eye, way_through(160, 150), through).value.body == behind;

    good = good && world.apply_impulse(front, middle.n * -300, middle.P) == ingot::Status::ok;
    for (int step_i = 0; good && step_i < 60; ++step_i) good = ingot::step(world, 1.0f / 60).clean();
    const ingot::scalar gone = world.state(front).value.r_CM.y;
    std::printf("ray picking: met the crate at height %.3f m, pushed it by %.3f m\n", static_cast<double>(middle.P.z), static_cast<double>(gone));
    return good && middle.P.z > 0 && middle.P.z < 1 && gone > 0.1f && gone < 1 ? 0 : 1;
}
