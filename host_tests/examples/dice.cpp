// SPDX-License-Identifier: MIT
// Twelve dice are thrown. When they sleep, each lies flat on a face, and the face on top is read from the columns of A.
#include <ingot/ingot.h>

#include <cstdio>

struct Throw : ingot::Scene {
    static constexpr int dice = 12;
    static constexpr int max_bodies = dice + 1, max_manifolds = 60;
    static constexpr bool translates = true, sleeps = true;
    static constexpr ingot::scalar length_unit = 0.02f;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
static ingot::World<Throw> world;

/// Opposite faces sum up to seven: 1 and 6 along x, 2 and 5 along y, 3 and 4 along z. 0: the die stands on an edge.
static int top_face(const ingot::Matrix& A) {
    const ingot::scalar up[3] = {A.c0.z, A.c1.z, A.c2.z};
    for (int axis = 0; axis < 3; ++axis) {
        if (up[axis] > 0.999f) return 1 + axis;
        if (up[axis] < -0.999f) return 6 - axis;
    }
    return 0;
}

int main() {
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    ingot::BodyDef die;
    const ingot::Vector half_extents = {0.008f, 0.008f, 0.008f};
    die.mass = ingot::principal(ingot::solid_box(1200, half_extents)).value;
    die.shape = ingot::Box{half_extents};
    die.restitution = 0.4f;
    bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok && world.add(ground).ok();
    ingot::BodyId ids[Throw::dice];
    for (int i = 0; i < Throw::dice; ++i) {
        const ingot::scalar k = static_cast<ingot::scalar>(i);
        const ingot::UserPose pose = {{0.05f * k, 0, 0.2f}, ingot::axis_angle({0.6f, 0, 0.8f}, 0.7f * k)};
        die.state = ingot::body_state(die.mass, pose, {{0.1f, 0.6f, 0}, {30 + 3 * k, 20 - 5 * k, 10}});
        ids[i] = world.add(die).value;
    }
    int step_i = 0;
    for (; good && step_i < 2400 && (step_i == 0 || world.awake_count() > 0); ++step_i)
        good = ingot::step(world, 1.0f / 240).status == ingot::Status::ok;
    int faces[7] = {};
    for (const ingot::BodyId id : ids) ++faces[top_face(world.state(id).value.A)];
    std::printf("dice: at rest after %.2f s; ones to sixes: %d %d %d %d %d %d\n", step_i / 240.0, faces[1], faces[2], faces[3], faces[4], faces[5],
                faces[6]);
    return good && world.awake_count() == 0 && faces[0] == 0 ? 0 : 1;
}
