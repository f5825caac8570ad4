// SPDX-License-Identifier: MIT
// A robot on one broad wheel balances, is pushed, and comes back to where it stood. Its motor turns the wheel against the body, by four numbers: the
// tilt, how fast it tilts, how far it has rolled, how fast it rolls.
#include <ingot/ingot.h>

#include <cmath>
#include <cstdio>

struct Floor : ingot::Scene {
    static constexpr int max_bodies = 3, max_manifolds = 4, max_joints = 1;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
    using joints = ingot::Joints<ingot::HingeJoint>;
};
static ingot::World<Floor> world;

int main() {
    using ingot::scalar;
    const scalar radius = 0.1f, h = 1.0f / 250;
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    ground.friction = 1;
    ingot::BodyDef wheel;
    wheel.mass = ingot::principal(ingot::with_mass(ingot::solid_cylinder(1, radius, 0.2f), 1)).value;
    wheel.shape = ingot::Cylinder{radius, 0.2f};
    wheel.friction = 1;
    wheel.state.A = ingot::axis_angle({1, 0, 0}, -1.5707964f);  // its axis, z, along y
    wheel.state.r_CM = {0, 0, radius};
    ingot::BodyDef body;
    body.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, {0.05f, 0.15f, 0.25f}), 5)).value;
    body.shape = ingot::Box{{0.05f, 0.15f, 0.25f}};
    body.state.r_CM = {0, 0, radius + 0.4f};

    bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok && world.add(ground).ok();
    const ingot::BodyId wheel_id = world.add(wheel).value, body_id = world.add(body).value;
    ingot::JointDef axle;
    axle.body_A = wheel_id;
    axle.body_B = body_id;
    axle.joint = ingot::HingeJoint{};
    axle.P = {0, 0, radius};
    axle.axis = {0, 1, 0};
    good = good && world.add_joint(axle).ok();

    double worst_tilt = 0;
    for (int step_i = 0; good && step_i < 2500; ++step_i) {
        if (step_i == 250) good = world.apply_central_impulse(body_id, {2, 0, 0}) == ingot::Status::ok;  // 0.4 m/s of its 5 kg
        const ingot::BodyState of_body = world.state(body_id).value, of_wheel = world.state(wheel_id).value;
        const scalar tilt = of_body.A.c2.x, rate = world.omega(body_id).value.y;  // sin of the tilt is near enough
        const scalar torque = 20 * tilt + 4 * rate + 0.8f * of_wheel.r_CM.x + 1.6f * of_wheel.v_CM.x;
        good = good && world.add_torque(wheel_id, {0, torque, 0}) == ingot::Status::ok &&
               world.add_torque(body_id, {0, -torque, 0}) == ingot::Status::ok;
        good = good && ingot::step(world, h).status == ingot::Status::ok;
        worst_tilt = std::fmax(worst_tilt, std::fabs(static_cast<double>(tilt)));
    }
    const double x = static_cast<double>(world.state(wheel_id).value.r_CM.x), tilt = static_cast<double>(world.state(body_id).value.A.c2.x);
    std::printf("balancing robot: tilted by %.1f degrees when it was pushed; after 10 s %.2f degrees, %.1f mm from where it stood\n",
                worst_tilt * 57.3, tilt * 57.3, x * 1000);
    return good && worst_tilt > 0.02 && worst_tilt < 0.5 && std::fabs(tilt) < 0.005 && std::fabs(x) < 0.05 ? 0 : 1;
}
