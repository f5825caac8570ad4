// SPDX-License-Identifier: MIT
// A marble rolls down two slopes into a cup. Down the first it gets as fast as a ball that rolls without slipping does: v^2 = 10/7 g (height).
#include <ingot/ingot.h>

#include <cmath>
#include <cstdio>

struct Run : ingot::Scene {
    static constexpr int max_bodies = 4, max_manifolds = 8, max_overlaps = 1;
    static constexpr bool translates = true;
    static constexpr ingot::scalar length_unit = 0.05f;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box>;
};
static ingot::World<Run> world;

int main() {
    // Boards 1 m long that slope by 0.2 rad, the second the other way; their upper faces are what the marble rolls on.
    const ingot::scalar slope = 0.2f, s = std::sin(slope), c = std::cos(slope), radius = 0.01f;
    ingot::BodyDef board;
    board.immovable = true;
    board.shape = ingot::Box{{0.5f, 0.05f, 0.01f}};
    board.friction = 0.6f;
    board.state.A = ingot::axis_angle({0, 1, 0}, slope);
    board.state.r_CM = {0, 0, 1};
    bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok && world.add(board).ok();
    board.state.A = ingot::axis_angle({0, 1, 0}, -slope);
    board.state.r_CM = {0.9f, 0, 0.8f};
    good = good && world.add(board).ok();
    ingot::BodyDef cup;
    cup.immovable = cup.sensor = true;
    cup.shape = ingot::Box{{0.3f, 0.2f, 0.1f}};
    cup.state.r_CM = {0, 0, 0.3f};
    good = good && world.add(cup).ok();

    ingot::BodyDef marble;
    marble.mass = ingot::principal(ingot::solid_sphere(2500, radius)).value;
    marble.shape = ingot::Sphere{radius};
    marble.friction = 0.6f;
    marble.state.r_CM = ingot::Vector{0, 0, 1} + ingot::Vector{-0.45f * c, 0, 0.45f * s} + ingot::Vector{s, 0, c} * (0.01f + radius);
    const ingot::Result<ingot::BodyId> id = world.add(marble);
    good = good && id.ok();

    double speed = 0, due = 0;
    int step_i = 0;
    for (; good && world.overlap_count() == 0 && step_i < 1200; ++step_i) {
        good = ingot::step(world, 1.0f / 240).status == ingot::Status::ok;
        const ingot::BodyState now = world.state(id.value).value;
        if (due == 0 && now.r_CM.x > 0.4f) {  // still on the first board
            due = std::sqrt(10.0 / 7 * 9.81 * static_cast<double>(marble.state.r_CM.z - now.r_CM.z));
            speed = std::sqrt(static_cast<double>(ingot::length_sq(now.v_CM)));
        }
    }
    std::printf("marble run: %.4f m/s after the first board, %.4f of an ideal ball; in the cup after %.2f s\n", speed, due, step_i / 240.0);
    return good && world.overlap_count() == 1 && std::fabs(speed - due) < 0.005 * due ? 0 : 1;
}
