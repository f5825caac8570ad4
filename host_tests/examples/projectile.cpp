// SPDX-License-Identifier: MIT
// A bullet of 1 cm at 400 m/s goes 6.7 m in a step, and does not pass a plate of 2 mm; one that misses it lands where the parabola ends.
#include <ingot/ingot.h>

#include <cmath>
#include <cstdio>

struct Range : ingot::Scene {
    static constexpr int max_bodies = 4, max_manifolds = 8;
    static constexpr bool translates = true, continuous = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
static ingot::World<Range> world;

int main() {
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    ingot::BodyDef plate;
    plate.immovable = true;
    plate.shape = ingot::Box{{0.001f, 1, 1}};
    plate.state.r_CM = {50, 0, 1};
    ingot::BodyDef bullet;
    bullet.mass = ingot::principal(ingot::solid_sphere(11000, 0.005f)).value;
    bullet.shape = ingot::Sphere{0.005f};
    bullet.state.r_CM = {0, 0, 1.5f};
    bullet.state.v_CM = {400, 0, 0};
    bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok && world.add(ground).ok() && world.add(plate).ok();
    const ingot::BodyId stopped = world.add(bullet).value;
    bullet.state.r_CM = {0, 3, 1.5f};
    bullet.state.v_CM = {40, 0, 30};
    const ingot::BodyId free = world.add(bullet).value;

    ingot::scalar furthest = 0;
    ingot::Vector landed = {};
    for (int step_i = 0; good && step_i < 600 && landed.x == 0; ++step_i) {
        const ingot::BodyState before = world.state(free).value;
        good = ingot::step(world, 1.0f / 60).status == ingot::Status::ok;
        furthest = ingot::max(furthest, world.state(stopped).value.r_CM.x);
        // Where it meets the ground, on the way from the last step's place: the parabola within the step is a tenth of a millimetre off the chord.
        const ingot::scalar fall = before.r_CM.z + before.v_CM.z / 60 - 0.005f;
        if (fall < 0) landed = before.r_CM + before.v_CM * ((before.r_CM.z - 0.005f) / -before.v_CM.z);
    }
    const double h = 1.495, v = 30, g = 9.81, range = 40 * (v + std::sqrt(v * v + 2 * g * h)) / g;
    std::printf("projectile: stopped at %.4f m of 50; landed at %.3f m, the parabola ends at %.3f m\n", static_cast<double>(furthest),
                static_cast<double>(landed.x), range);
    return good && furthest < 50 && furthest > 49.9f && std::fabs(static_cast<double>(landed.x) - range) < 0.05 ? 0 : 1;
}
