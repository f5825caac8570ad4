// SPDX-License-Identifier: MIT
// How deep the stack goes in step(), by the paint: nothing but steps runs while the paint lies.
//
//     satellite stack_bytes 240
#include "../scenes/all_scenes.h"
#include <ingot/platform/console.h>
#include <ingot/platform/stack_watermark.h>

extern "C" ingot::StepReport step_of_scene(ingot::World<scenes::INGOT_SCENE>& world);

static ingot::World<scenes::INGOT_SCENE> world;

/// A scene may say which reports are sound; else they are clean.
template <class S>
static auto went_well(const ingot::StepReport& report, int) -> decltype(S::went_well(report)) {
    return S::went_well(report);
}
template <class S>
static bool went_well(const ingot::StepReport& report, long) {
    return report.clean();
}

int main() {
    using namespace ingot::platform;
    using S = scenes::INGOT_SCENE;
    if (set_up(world) != ingot::Status::ok) return 1;

    bool well = true;
    const uint32_t depth = stack_depth_bytes();
    stack_paint();
    for (int step_i = 0; step_i < S::golden_steps; ++step_i) well = went_well<S>(step_of_scene(world), 0) && well;
    const uint32_t stack_bytes = stack_deepest_bytes() - depth;

    console_write(S::name);
    console_write(" stack_bytes ");
    console_write_u64(stack_bytes);
    console_write("\n");
    return well ? 0 : 1;
}
