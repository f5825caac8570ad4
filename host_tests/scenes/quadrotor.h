// SPDX-License-Identifier: MIT
// A quadrotor that turns itself upright from any attitude, by the torques of its rotors: a law on rotations, without angles that could fail.
#pragma once

#include <ingot/ingot.h>

namespace scenes {

struct Quadrotor : ingot::Scene {
    static constexpr bool body_forces = true;  // rotors push in the axes of the body, and turn with it over a step
};

/// kg m^2, about the axes of the body: Mellinger, Kumar 2011.
inline constexpr ingot::Vector quadrotor_moments = {ingot::scalar(8.2e-3), ingot::scalar(8.2e-3), ingot::scalar(14.9e-3)};

/// Half of what separates two rotations, as a vector in the axes of A: sin of the angle, about the axis, for A against `wanted`.
inline ingot::Vector attitude_error(const ingot::Matrix& A, const ingot::Matrix& wanted) {
    const ingot::Matrix E = ingot::transposed(wanted) * A;
    return ingot::Vector{E.c1.z - E.c2.y, E.c2.x - E.c0.z, E.c0.y - E.c1.x} * ingot::scalar(0.5);
}

/// N m, in the axes of the body: drives it to an attitude at which it rests; frequency: rad/s; damping: 1/s. The gyroscopic term is cancelled.
/// Source: Lee, Leok, McClamroch, "Geometric tracking control of a quadrotor UAV on SE(3)", 2010, Eqs. 10, 11, 16.
inline ingot::Vector attitude_torque(const ingot::Matrix& A, const ingot::Vector& omega_body, const ingot::Matrix& wanted, ingot::scalar frequency,
                                     ingot::scalar damping) {
    const ingot::Vector L = ingot::scaled(quadrotor_moments, omega_body), turn_back = attitude_error(A, wanted) * -(frequency * frequency);
    return ingot::scaled(quadrotor_moments, turn_back - omega_body * damping) + ingot::cross(omega_body, L);
}

/// For the next step.
inline ingot::Status hold_attitude(ingot::World<Quadrotor>& world, ingot::BodyId id, const ingot::Matrix& wanted) {
    const ingot::Matrix A = world.state(id).value.A;
    const ingot::Vector omega_body = ingot::transpose_times(A, world.omega(id).value);
    return world.add_body_torque(id, attitude_torque(A, omega_body, wanted, 10, 16));
}

}  // namespace scenes
