// SPDX-License-Identifier: MIT
// A bridge of twelve planks on hinges, held at both ends, which closes a loop. A ball fifty times as heavy as a plank rolls over it, and no hinge
// gives by a tenth of a millimetre.
#include <ingot/ingot.h>

#include <cmath>
#include <cstdio>

struct Gorge : ingot::Scene {
    static constexpr int planks = 12;
    static constexpr int max_bodies = planks + 1, max_manifolds = 30, max_joints = planks + 1, max_loops = 1;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box>;
    using joints = ingot::Joints<ingot::HingeJoint>;
};
static ingot::World<Gorge> world;

int main() {
    using ingot::scalar;
    bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok;
    // The planks lie along a parabola that hangs through by 1 m over 10 m.
    const auto sag = [](scalar x) { return x * x / 25 - 1; };
    ingot::BodyId before{};
    for (int i = 0; i <= Gorge::planks; ++i) {
        const scalar x_0 = 10 * static_cast<scalar>(i) / Gorge::planks - 5, x_1 = x_0 + scalar(10) / Gorge::planks;
        ingot::BodyId plank{};
        if (i < Gorge::planks) {
            const scalar dx = x_1 - x_0, dz = sag(x_1) - sag(x_0), length = std::sqrt(dx * dx + dz * dz);
            const ingot::Vector half_extents = {length / 2 - 0.03f, 0.8f, 0.05f};
            ingot::BodyDef def;
            def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, half_extents), 20)).value;
            def.shape = ingot::Box{half_extents};
            def.state.r_CM = {(x_0 + x_1) / 2, 0, (sag(x_0) + sag(x_1)) / 2};
            def.state.A = ingot::axis_angle({0, 1, 0}, -std::atan2(dz, dx));
            plank = world.add(def).value;
        }
        ingot::JointDef hinge;  // to the plank before, or to the rock: the null id
        hinge.body_A = before;
        hinge.body_B = plank;
        hinge.joint = ingot::HingeJoint{};
        hinge.P = {x_0, 0, sag(x_0)};
        hinge.axis = {0, 1, 0};
        good = good && world.add_joint(hinge).ok();
        before = plank;
    }
    ingot::BodyDef ball;
    ball.mass = ingot::principal(ingot::with_mass(ingot::solid_sphere(1, 0.4f), 1000)).value;
    ball.shape = ingot::Sphere{0.4f};
    ball.state.r_CM = {-4.2f, 0, 0.4f};
    const ingot::Result<ingot::BodyId> id = world.add(ball);
    good = good && id.ok();

    double gap = 0, furthest = 0;
    for (int step_i = 0; good && step_i < 600; ++step_i) {
        good = ingot::step(world, 1.0f / 60).status == ingot::Status::ok;
        for (int slot = 0; slot <= Gorge::planks; ++slot) gap = std::fmax(gap, static_cast<double>(world.joint_gap(world.joint_at(slot)).value));
        furthest = std::fmax(furthest, static_cast<double>(world.state(id.value).value.r_CM.x));
    }
    const ingot::scalar height = world.state(id.value).value.r_CM.z;
    std::printf("bridge: the ball came as far as x = %.2f m; gaps up to %.4f mm\n", furthest, gap * 1000);
    return good && gap < 1e-4 && furthest > 1 && height > -3 ? 0 : 1;
}
