// SPDX-License-Identifier: MIT
// A crate falls on the ground, tilted, and comes to rest. Prints its height in millimetres, ten times a second.
#include <ingot.h>

struct Yard : ingot::Scene {
    static constexpr int max_bodies = 2, max_manifolds = 2;
    static constexpr bool translates = true;
    static constexpr bool bounces = false, recycles_manifolds = false, hides_internal_edges = false, holds_crowds = false;  // for less flash
    using solver = ingot::SequentialImpulses;
    using rotation = ingot::LieMidpoint;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
static ingot::World<Yard> world;  // all the memory there is: sizeof(world) bytes
static ingot::BodyId crate;
static bool good = true;

void setup() {
    Serial.begin(115200);
    good = ingot::check_floating_point() == ingot::Status::ok;  // else this board's unit rounds otherwise, and bits are its own

    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    const ingot::Vector half_extents = {0.5f, 0.5f, 0.5f};
    ingot::BodyDef box;
    box.mass = ingot::principal(ingot::solid_box(200, half_extents)).value;  // 200 kg/m^3
    box.shape = ingot::Box{half_extents};
    box.state.r_CM = {0, 0, 3};
    box.state.A = ingot::axis_angle({1, 0, 0}, 0.3f);

    good = good && world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok && world.add(ground).ok();
    const ingot::Result<ingot::BodyId> id = world.add(box);
    good = good && id.ok();
    crate = id.value;
}

void loop() {
    static int step_i = 0;
    good = good && ingot::step(world, 1.0f / 60).clean();
    if (++step_i % 6 == 0) {
        Serial.print(good ? "height, mm: " : "something is wrong: ");
        Serial.println(static_cast<long>(world.state(crate).value.r_CM.z * 1000));
    }
    delay(16);
}
