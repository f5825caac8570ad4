// SPDX-License-Identifier: MIT
// Thirty dominoes stand in a row; the first is pushed, and all of them fall, one after the other.
#include <ingot/ingot.h>

#include <cstdio>

struct Row : ingot::Scene {
    static constexpr int dominoes = 30;
    static constexpr int max_bodies = dominoes + 1, max_manifolds = 120;
    static constexpr bool translates = true;
    static constexpr ingot::scalar length_unit = 0.05f;  // things of centimetres
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
static ingot::World<Row> world;

int main() {
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    const ingot::Vector half_extents = {0.004f, 0.012f, 0.024f};
    ingot::BodyDef domino;
    domino.mass = ingot::principal(ingot::solid_box(1200, half_extents)).value;
    domino.shape = ingot::Box{half_extents};
    domino.friction = 0.3f;

    bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok && world.add(ground).ok();
    ingot::BodyId row[Row::dominoes];
    for (int i = 0; i < Row::dominoes; ++i) {
        domino.state.r_CM = {0.02f * static_cast<ingot::scalar>(i), 0, half_extents.z};
        row[i] = world.add(domino).value;
    }
    const ingot::scalar weight = world.mass(row[0]).value;
    good = good && world.apply_impulse(row[0], {0.15f * weight, 0, 0}, {0, 0, 0.046f}) == ingot::Status::ok;

    double fell_at[Row::dominoes] = {};
    int fallen = 0;
    for (int step_i = 0; good && step_i < 480; ++step_i) {
        good = ingot::step(world, 1.0f / 240).status == ingot::Status::ok;
        // A domino has fallen when its long axis is nearer to the ground than to upright; the next falls later.
        while (fallen < Row::dominoes && world.state(row[fallen]).value.A.c2.z < 0.7f) fell_at[fallen++] = (step_i + 1) / 240.0;
    }
    std::printf("dominoes: %d of %d fell, the last after %.2f s\n", fallen, Row::dominoes, fell_at[Row::dominoes - 1]);
    return good && fallen == Row::dominoes ? 0 : 1;
}
