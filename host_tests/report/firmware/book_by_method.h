// SPDX-License-Identifier: MIT
// A scene in the place of scenes/all_scenes.h: the body of the reference case `book`, I = (1, 2, 3), turned by the method that
// INGOT_REPORT_ROTATION names. firmware/scene_main.cpp built with it is what one satellite costs with that method.
#pragma once

#include <ingot/ingot.h>

namespace scenes {

struct Book : ingot::Scene {
    static constexpr const char* name = "book";
    static constexpr ingot::scalar h = ingot::scalar(1) / 60;  ///< s
    static constexpr int golden_steps = 1000;
    using rotation = ingot::INGOT_REPORT_ROTATION;
};

inline ingot::Status set_up(ingot::World<Book>& world) {
    ingot::BodyDef def{};
    def.mass = {1, {1, 2, 3}, {}, ingot::identity_matrix<ingot::scalar>()};
    def.state.A = ingot::identity_matrix<ingot::scalar>();
    def.state.L = {ingot::scalar(0.5), 2, ingot::scalar(2.25)};
    return world.add(def).status;
}

}  // namespace scenes
