// SPDX-License-Identifier: MIT
// The program of the README.
#include <ingot/ingot.h>
#include <ingot/platform/clock.h>
#include <ingot/platform/console.h>
#include <ingot/platform/fixed_step.h>

struct Crates : ingot::Scene {
    static constexpr int  max_bodies   = 11;
    static constexpr bool translates   = true;
    static constexpr int  max_contacts = 44;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
static ingot::World<Crates> world;

int main() {
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};

    const ingot::scalar half = ingot::scalar(0.5);
    const ingot::Vector half_extents = {half, half, half};
    ingot::BodyDef crate;
    crate.mass = ingot::principal(ingot::solid_box(200, half_extents)).value;   // 200 kg/m^3
    crate.shape = ingot::Box{half_extents};
    crate.restitution = half;
    crate.state.r_CM = {0, 0, 2};

    bool good = world.set_gravity({0, 0, ingot::scalar(-9.81)}) == ingot::Status::ok;
    good = good && world.add(ground).ok();
    const ingot::Result<ingot::BodyId> id = world.add(crate);
    good = good && id.ok();
    for (int step_i = 0; good && step_i < 600; ++step_i) good = ingot::step(world, ingot::scalar(1) / 60).clean();
    good = good && world.state(id.value).value.r_CM.z > ingot::scalar(0.4);
    ingot::platform::console_write(good ? "the crate has landed\n" : "something is wrong\n");
    return good ? 0 : 1;
}
