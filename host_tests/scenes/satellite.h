// SPDX-License-Identifier: MIT
#pragma once

#include <ingot/ingot.h>

namespace scenes {

/// A CubeSat of three units, 4 kg and 0.1 x 0.1 x 0.3405 m, that tumbles after it left its launcher. It only turns: the
/// world holds neither r_CM nor v_CM.
struct Satellite : ingot::Scene {
    static constexpr const char* name = "satellite";
    static constexpr const char* title = "a 3U CubeSat tumbles";
    static constexpr ingot::scalar h = ingot::scalar(1) / 60;  ///< s
    static constexpr int golden_steps = 1000;
    static constexpr int demo_steps = 216000;  ///< one hour
};

inline ingot::Status set_up(ingot::World<Satellite>& world) {
    using ingot::scalar;
    constexpr scalar M = 4;
    constexpr ingot::Vector half_extents = {scalar(0.05), scalar(0.05), scalar(0.17025)};
    constexpr ingot::MassDistribution solid = ingot::with_mass(ingot::solid_box(1, half_extents), M);

    ingot::BodyDef def;
    def.mass = {solid.M, {solid.I.xx, solid.I.yy, solid.I.zz}, {}, ingot::identity_matrix<scalar>()};
    def.state.L = ingot::angular_momentum_of_spin(def.state.A, def.mass.I_body, {scalar(1), scalar(0.5), scalar(0.25)});
    return world.add(def).status;
}

}  // namespace scenes
