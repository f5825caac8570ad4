// SPDX-License-Identifier: MIT
#pragma once

#include <ingot/ingot.h>

namespace scenes {

/// The handle that flips (Dzhanibekov): spun about the axis of its middle moment it turns over, again and again, though
/// nothing touches it.
///
/// A bar along y and a stem along x, two steel cylinders that meet at the middle of the bar: the middle moment belongs to
/// the axis of the stem or the bar, as their sizes decide; here it is the stem's.
struct THandle : ingot::Scene {
    static constexpr const char* name = "t_handle";
    static constexpr const char* title = "a T-handle flips";
    static constexpr ingot::scalar h = ingot::scalar(1) / 60;  ///< s
    static constexpr int golden_steps = 1000;
    static constexpr int demo_steps = 3600;  ///< one minute
};

/// The handle as its user models it: origin at the middle of the bar, bar along y, stem along +x.
inline ingot::MassDistribution t_handle_solid() {
    using ingot::scalar;
    constexpr scalar steel = 7850;  // kg m^-3
    constexpr scalar radius = scalar(0.01), bar_half = scalar(0.05), stem_half = scalar(0.03);
    // A quarter turn takes the cylinder's own axis z to y, another to x.
    constexpr ingot::Matrix z_to_y = {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    constexpr ingot::Matrix z_to_x = {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
    const ingot::MassDistribution bar = ingot::placed(ingot::solid_cylinder(steel, radius, bar_half), z_to_y, {});
    const ingot::MassDistribution stem =
        ingot::placed(ingot::solid_cylinder(steel, radius, stem_half), z_to_x, {radius + stem_half, 0, 0});
    return ingot::combined(bar, stem);
}

/// Principal axis, 0 1 2, of the middle moment.
inline int middle_axis(const ingot::Vector& I) {
    if ((I.x - I.y) * (I.x - I.z) <= 0) return 0;
    return (I.y - I.x) * (I.y - I.z) <= 0 ? 1 : 2;
}

inline ingot::Status set_up(ingot::World<THandle>& world) {
    using ingot::scalar;
    const ingot::Result<ingot::MassProperties> mass = ingot::principal(t_handle_solid());
    if (!mass.ok()) return mass.status;

    // 10 rad/s about the middle axis, a hundredth of it about the others: near enough to flip, and far enough for float to tell when.
    const int axis = middle_axis(mass.value.I_body);
    const scalar fast = 10, slow = scalar(0.1);
    const ingot::Vector omega_body = {axis == 0 ? fast : slow, axis == 1 ? fast : slow, axis == 2 ? fast : slow};

    ingot::BodyDef def;
    def.mass = mass.value;
    def.state.L = ingot::angular_momentum_of_spin(def.state.A, def.mass.I_body, omega_body);
    return world.add(def).status;
}

}  // namespace scenes
