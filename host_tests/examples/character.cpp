// SPDX-License-Identifier: MIT
// A character walks up six stairs, over a landing and down a ramp, as fast as on the flat. It is no body; a kinematic one goes with it, which a ball
// on the landing feels.
#include <ingot/ingot.h>

#include <cmath>
#include <cstdio>

struct House : ingot::Scene {
    static constexpr int max_bodies = 12, max_manifolds = 24;
    static constexpr bool translates = true, kinematic_bodies = true, filters = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::HalfSpace>;
};
static ingot::World<House> world;

static bool add_fixed(const ingot::Shape& shape, const ingot::Vector& r, const ingot::Matrix& A = ingot::identity_matrix<ingot::scalar>()) {
    ingot::BodyDef def;
    def.immovable = true;
    def.shape = shape;
    def.state.r_CM = r;
    def.state.A = A;
    return world.add(def).ok();
}

int main() {
    constexpr ingot::scalar rise = 0.17f, high = 6 * rise, speed = 2;
    bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok && add_fixed(ingot::HalfSpace{{0, 0, 1}, 0}, {});
    for (int i = 1; i <= 6; ++i) {  // each stair goes on below those above it; the last is the landing
        const ingot::scalar begin = 2 + 0.28f * static_cast<ingot::scalar>(i), half = (7 - begin) / 2;
        good = good && add_fixed(ingot::Box{{half, 1, rise / 2}}, {begin + half, 0, rise * (static_cast<ingot::scalar>(i) - 0.5f)});
    }
    const ingot::scalar slope = std::atan(high / 3), length = std::hypot(high, ingot::scalar(3)) / 2, thick = 0.1f;
    const ingot::Matrix A = ingot::axis_angle({0, 1, 0}, slope);
    good = good && add_fixed(ingot::Box{{length, 1, thick}}, ingot::Vector{8.5f, 0, high / 2} - A.c2 * thick, A);

    ingot::BodyDef ball;
    ball.mass = ingot::principal(ingot::solid_sphere(100, 0.2f)).value;
    ball.shape = ingot::Sphere{0.2f};
    ball.state.r_CM = {5.5f, 0.35f, high + 0.2f};
    const ingot::BodyId kicked = world.add(ball).value;

    ingot::Mover walker;
    walker.r = {0, 0, 0.91f};
    walker.filter = {1, 2};  // it is of the first kind, and meets the second: not the body that goes with it
    ingot::BodyDef shadow;
    shadow.kinematic = true;
    shadow.shape = walker.capsule;
    shadow.filter = {4, 8};
    shadow.state.r_CM = walker.r;
    const ingot::BodyId body = world.add(shadow).value;
    const ingot::BodyFilter of_others = {2 | 8, 1 | 2 | 4};
    for (int slot = 0; slot < House::max_bodies; ++slot) {
        const ingot::BodyId id = world.body_at(slot);
        if (world.is_alive(id) && id != body) good = good && world.set_filter(id, of_others) == ingot::Status::ok;
    }

    const ingot::scalar h = 1.0f / 60;
    for (int step_i = 0; good && step_i < 330; ++step_i) {
        good = world.move_to(body, walker.r, ingot::identity_matrix<ingot::scalar>()) == ingot::Status::ok;
        good = good && ingot::step(world, h).clean() && world.move(walker, {{speed, 0, 0}}, h) == ingot::Status::ok;
    }
    const ingot::Vector rolled = world.state(kicked).value.r_CM;
    std::printf("character: %.2f m in 5.5 s, over stairs of %.2f m; the ball is at %.1f, %.1f, %.1f\n", static_cast<double>(walker.r.x),
                static_cast<double>(high), static_cast<double>(rolled.x), static_cast<double>(rolled.y), static_cast<double>(rolled.z));
    const bool stands = walker.ground.footing == ingot::MoverFooting::walkable && std::fabs(walker.r.z - 0.91f) < 1e-3f;
    return good && stands && std::fabs(walker.r.x - 11) < 0.05f && rolled.x > 5.6f ? 0 : 1;
}
