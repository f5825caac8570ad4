// SPDX-License-Identifier: MIT
// A satellite turns about its middle axis, and flips over again and again, as a wing nut in orbit does. Prints each flip.
#include <ingot.h>

static ingot::World<ingot::Scene> world;  // the least scene: one body that turns
static ingot::BodyId satellite;
static bool good = true;

void setup() {
    Serial.begin(115200);
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, {0.05f, 0.1f, 0.17f}), 4)).value;  // 4 kg
    def.state = ingot::body_state(def.mass, {}, {{}, {0.001f, 1, 0.001f}});                            // rad/s
    const ingot::Result<ingot::BodyId> id = world.add(def);
    good = id.ok();
    satellite = id.value;
}

void loop() {
    static long step_i = 0;
    static float side = 1;
    good = good && ingot::step(world, 1.0f / 60).clean();
    const ingot::BodyState now = world.state(satellite).value;
    const float along = ingot::dot(now.A.c1, now.L);  // the middle axis and L: it flips where this changes its sign
    if (along * side < 0) {
        side = -side;
        Serial.print(good ? "a flip, at s: " : "something is wrong, at s: ");
        Serial.println(step_i / 60);
    }
    ++step_i;
}
