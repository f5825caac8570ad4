// SPDX-License-Identifier: MIT
// A ball rolls through a gate. The gate is a sensor: it touches nothing, and tells who enters and leaves, each once.
#include <ingot/ingot.h>

#include <cmath>
#include <cstdio>

struct Lane : ingot::Scene {
    static constexpr int max_bodies = 3, max_manifolds = 8, max_overlaps = 2, max_events = 8;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
static ingot::World<Lane> world;

int main() {
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    ingot::BodyDef gate;
    gate.immovable = gate.sensor = true;
    gate.shape = ingot::Box{{0.25f, 2, 2}};
    gate.state.r_CM = {3, 0, 0};
    ingot::BodyDef ball;
    const ingot::scalar radius = 0.25f, speed = 2;
    ball.mass = ingot::principal(ingot::solid_sphere(500, radius)).value;
    ball.shape = ingot::Sphere{radius};
    ball.state = ingot::body_state(ball.mass, {{0, 0, radius}}, {{speed, 0, 0}, {0, speed / radius, 0}});  // it rolls, and does not slip

    bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok && world.add(ground).ok();
    const ingot::BodyId gate_id = world.add(gate).value, ball_id = world.add(ball).value;
    int entered = 0, left = 0;
    double enter_time = 0, leave_time = 0;
    for (int step_i = 0; good && step_i < 180; ++step_i) {
        good = ingot::step(world, 1.0f / 60).clean();
        for (const ingot::Event& event : world.events()) {
            if (event.A != gate_id || event.B != ball_id) continue;
            if (event.kind == ingot::EventKind::enter) {
                ++entered;
                enter_time = step_i / 60.0;
            }
            if (event.kind == ingot::EventKind::leave) {
                ++left;
                leave_time = step_i / 60.0;
            }
        }
    }
    // It touches the gate from 2.5 m to 3.5 m: a step is the grain of what is told.
    std::printf("trigger: entered after %.3f s, left after %.3f s\n", enter_time, leave_time);
    const bool on_time = std::fabs(enter_time - 2.5 / 2) < 0.034 && std::fabs(leave_time - 3.5 / 2) < 0.034;
    return good && entered == 1 && left == 1 && on_time ? 0 : 1;
}
