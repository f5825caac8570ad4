// SPDX-License-Identifier: MIT
// A pinball table: it slopes, so gravity is turned instead. A ball rolls down to a flipper, a kinematic body that turns about one of its ends, and is
// shot back to the top of the table.
#include <ingot/ingot.h>

#include <cmath>
#include <cstdio>

struct Table : ingot::Scene {
    static constexpr int max_bodies = 3, max_manifolds = 8;
    static constexpr bool translates = true, kinematic_bodies = true;
    static constexpr ingot::scalar length_unit = 0.05f;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::HalfSpace>;
};
static ingot::World<Table> world;

/// A flipper 8 cm long whose hinge is at the origin, at an angle to the x axis. A capsule lies along z: its columns are turned to lie along x.
static ingot::UserPose flipper_at(ingot::scalar angle) {
    const ingot::Matrix turned = ingot::axis_angle({0, 0, 1}, angle) * ingot::axis_angle({0, 1, 0}, 1.5707964f);
    return {turned * ingot::Vector{0, 0, 0.04f} + ingot::Vector{0, 0, 0.0135f}, turned};
}

int main() {
    bool good = world.set_gravity({0, -1.1f, -9.75f}) == ingot::Status::ok;  // 6.5 degrees
    ingot::BodyDef floor;
    floor.immovable = true;
    floor.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    good = good && world.add(floor).ok();
    ingot::BodyDef flipper;
    flipper.kinematic = true;
    flipper.shape = ingot::Capsule{0.01f, 0.03f};
    flipper.state.r_CM = flipper_at(-0.4f).r;
    flipper.state.A = flipper_at(-0.4f).A;
    const ingot::BodyId flipper_id = world.add(flipper).value;
    ingot::BodyDef ball;
    ball.mass = ingot::principal(ingot::solid_sphere(7800, 0.0135f)).value;
    ball.shape = ingot::Sphere{0.0135f};
    ball.friction = 0.1f;
    ball.state.r_CM = {0.05f, 0.3f, 0.0135f};
    const ingot::Result<ingot::BodyId> id = world.add(ball);
    good = good && id.ok();

    // The button is pressed when the ball is near; the flipper then turns by 1 rad in 40 ms.
    ingot::scalar angle = -0.4f, top = -1;
    bool pressed = false;
    for (int step_i = 0; good && step_i < 720; ++step_i) {
        const ingot::Vector r = world.state(id.value).value.r_CM;
        pressed = pressed || r.y < 0.03f;
        if (pressed) angle = ingot::min(angle + 25.0f / 240, 0.6f);
        good = world.move_to(flipper_id, flipper_at(angle).r, flipper_at(angle).A) == ingot::Status::ok;
        good = good && ingot::step(world, 1.0f / 240).status == ingot::Status::ok;
        if (pressed) top = ingot::max(top, world.state(id.value).value.r_CM.y);
    }
    std::printf("pinball: rolled from 0.3 m down to the flipper, shot up to %.2f m\n", static_cast<double>(top));
    return good && pressed && top > 0.6f ? 0 : 1;
}
