// SPDX-License-Identifier: MIT
// A belt carries a crate. Friction brings it up to the speed of the belt, v = mu g t, and there it stays: it has slipped by v^2 / (2 mu g).
#include <ingot/ingot.h>

#include <cmath>
#include <cstdio>

struct Plant : ingot::Scene {
    static constexpr int max_bodies = 2, max_manifolds = 4;
    static constexpr bool translates = true, surface_velocities = true;
    using shapes = ingot::Shapes<ingot::Box>;
};
static ingot::World<Plant> world;

int main() {
    const ingot::scalar speed = 1.5f, mu = 0.4f, g = 9.81f;
    ingot::BodyDef belt;
    belt.immovable = true;
    belt.shape = ingot::Box{{20, 1, 0.1f}};
    belt.state.r_CM = {0, 0, -0.1f};
    belt.friction = mu;
    ingot::BodyDef crate;
    const ingot::Vector half_extents = {0.3f, 0.3f, 0.1f};
    crate.mass = ingot::principal(ingot::solid_box(200, half_extents)).value;
    crate.shape = ingot::Box{half_extents};
    crate.friction = mu;
    crate.state.r_CM = {0, 0, 0.1f};

    bool good = world.set_gravity({0, 0, -g}) == ingot::Status::ok;
    const ingot::BodyId belt_id = world.add(belt).value, crate_id = world.add(crate).value;
    good = good && world.set_surface_velocity(belt_id, {speed, 0, 0}) == ingot::Status::ok;
    for (int step_i = 0; good && step_i < 300; ++step_i) good = ingot::step(world, 1.0f / 60).clean();
    const ingot::BodyState now = world.state(crate_id).value;
    const double way = 5 * 1.5 - 1.5 * 1.5 / (2 * 0.4 * 9.81), error = static_cast<double>(now.r_CM.x) - way;
    std::printf("conveyor: %.4f m in 5 s, off by %.1f mm; %.5f m/s\n", static_cast<double>(now.r_CM.x), error * 1000,
                static_cast<double>(now.v_CM.x));
    return good && std::fabs(error) < 0.01 && std::fabs(static_cast<double>(now.v_CM.x - speed)) < 1e-3 ? 0 : 1;
}
