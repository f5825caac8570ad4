// SPDX-License-Identifier: MIT
// A crate falls on the ground, comes to rest on it to a tenth of a millimetre, and falls asleep: from then on it costs nothing.
#include <ingot/ingot.h>

#include <cstdio>

struct Yard : ingot::Scene {
    static constexpr int max_bodies = 2, max_manifolds = 4;
    static constexpr bool translates = true, sleeps = true;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
static ingot::World<Yard> world;

int main() {
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    const ingot::Vector half_extents = {0.5f, 0.5f, 0.5f};
    ingot::BodyDef crate;
    crate.mass = ingot::principal(ingot::solid_box(200, half_extents)).value;  // 200 kg/m^3
    crate.shape = ingot::Box{half_extents};
    crate.state.r_CM = {0, 0, 3};
    crate.state.A = ingot::axis_angle({1, 0, 0}, 0.3f);

    bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok && world.add(ground).ok();
    const ingot::Result<ingot::BodyId> id = world.add(crate);
    good = good && id.ok();
    int step_i = 0;
    while (good && !world.is_asleep(id.value) && step_i < 600) {
        good = ingot::step(world, 1.0f / 60).clean();
        ++step_i;
    }
    const ingot::scalar z = world.state(id.value).value.r_CM.z;
    std::printf("crate: asleep after %.2f s, its middle %.5f m above the ground\n", step_i / 60.0, static_cast<double>(z));
    return good && world.is_asleep(id.value) && z > 0.4999f && z < 0.5001f ? 0 : 1;
}
