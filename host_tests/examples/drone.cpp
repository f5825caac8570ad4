// SPDX-License-Identifier: MIT
// A drone with four rotors flies from the ground to a point and holds it. The controller knows what a gyroscope, an accelerometer and a position
// fix tell, and what it sets is the thrust of each rotor, in the axes of the body.
#include <ingot/ingot.h>

#include <cmath>
#include <cstdio>

struct Sky : ingot::Scene {
    static constexpr bool translates = true, body_forces = true, damping = true;
};
static ingot::World<Sky> world;

int main() {
    using ingot::scalar;
    using ingot::Vector;
    const scalar g = 9.81f, arm = 0.15f, h = 1.0f / 250;
    ingot::BodyDef drone;
    drone.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, {0.15f, 0.15f, 0.03f}), 1)).value;
    bool good = world.set_gravity({0, 0, -g}) == ingot::Status::ok;
    const ingot::BodyId id = world.add(drone).value;
    good = good && world.set_damping(id, {0.1f, 0.2f}) == ingot::Status::ok;  // of the air
    const Vector goal = {2, -1, 3}, I = world.inertia(id).value;
    const Vector rotors[4] = {{arm, 0, 0}, {0, arm, 0}, {-arm, 0, 0}, {0, -arm, 0}};

    for (int step_i = 0; good && step_i < 2500; ++step_i) {
        const ingot::BodyState now = world.state(id).value;
        // The force that would bring it there as a spring of 1.5 rad/s at critical damping does, and the axis that it has to lie along.
        Vector F = (goal - now.r_CM) * (1.5f * 1.5f) - now.v_CM * 3 + Vector{0, 0, g};
        const scalar tilt_max = 0.5f * F.z, aside = std::sqrt(F.x * F.x + F.y * F.y);
        if (aside > tilt_max) F = {F.x * tilt_max / aside, F.y * tilt_max / aside, F.z};
        const Vector wanted = F * (1 / std::sqrt(ingot::length_sq(F)));
        // A torque that turns the thrust to that axis, 12 rad/s, critically damped, in body axes.
        const Vector turn = ingot::transpose_times(now.A, ingot::cross(now.A.c2, wanted)),
                     omega = ingot::transpose_times(now.A, world.omega(id).value);
        const scalar thrust = ingot::max(ingot::dot(F, now.A.c2), 0.1f), tau_x = I.x * (144 * turn.x - 24 * omega.x),
                     tau_y = I.y * (144 * turn.y - 24 * omega.y);
        const scalar share[4] = {-tau_y / (2 * arm), tau_x / (2 * arm), tau_y / (2 * arm), -tau_x / (2 * arm)};
        for (int rotor = 0; good && rotor < 4; ++rotor)  // a rotor only pushes
            good = world.add_body_force(id, {0, 0, ingot::max(thrust / 4 + share[rotor], scalar(0))}, rotors[rotor]) == ingot::Status::ok;
        good = good && ingot::step(world, h).clean();
    }
    const ingot::BodyState end = world.state(id).value;
    const double off = std::sqrt(static_cast<double>(ingot::length_sq(end.r_CM - goal)));
    std::printf("drone: %.2f mm off its goal after 10 s, upright to %.1e\n", off * 1000, 1 - static_cast<double>(end.A.c2.z));
    return good && off < 0.005 && end.A.c2.z > 0.9999f ? 0 : 1;
}
