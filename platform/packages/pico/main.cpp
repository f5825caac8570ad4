// SPDX-License-Identifier: MIT
// A crate falls and comes to rest. The RP2040 has no floating-point unit, and there ingot brings its own arithmetic; the RP2350 has one.
#include <ingot/ingot.h>

#include <pico/stdlib.h>
#include <stdio.h>

struct Yard : ingot::Scene {
    static constexpr int max_bodies = 2, max_manifolds = 2;
    static constexpr bool translates = true;
    using solver = ingot::SequentialImpulses;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
static ingot::World<Yard> world;

int main() {
    stdio_init_all();
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    ingot::BodyDef crate;
    crate.mass = ingot::principal(ingot::solid_box(200, {0.5f, 0.5f, 0.5f})).value;
    crate.shape = ingot::Box{{0.5f, 0.5f, 0.5f}};
    crate.state.r_CM = {0, 0, 3};
    bool good = ingot::check_floating_point() == ingot::Status::ok;
    good = good && world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok && world.add(ground).ok();
    const ingot::Result<ingot::BodyId> id = world.add(crate);
    good = good && id.ok();
    for (int step_i = 1; good && step_i <= 180; ++step_i) {
        good = ingot::step(world, 1.0f / 60).clean();
        if (step_i % 30 == 0) printf("height, mm: %d\n", static_cast<int>(world.state(id.value).value.r_CM.z * 1000));
        sleep_ms(16);
    }
    return good ? 0 : 1;
}
