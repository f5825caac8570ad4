// SPDX-License-Identifier: MIT
// The step of a scene as a function of its own, in a unit of its own: the root of the call graph whose depth is computed,
// and what stack_probe.cpp calls. In a user's program, as in the scene's firmware, the compiler may melt it into its caller.
#include "../scenes/all_scenes.h"

extern "C" ingot::StepReport step_of_scene(ingot::World<scenes::INGOT_SCENE>& world);

extern "C" ingot::StepReport step_of_scene(ingot::World<scenes::INGOT_SCENE>& world) {
    return ingot::step(world, scenes::INGOT_SCENE::h);
}
