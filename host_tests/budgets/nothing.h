// SPDX-License-Identifier: MIT
// A scene of nothing, in the place of scenes/all_scenes.h: firmware/scene_main.cpp built with it is start-up, console and
// measuring code, to the instruction what every scene's firmware has. A scene costs what its firmware has beyond that.
#pragma once

#include <stdint.h>

/// Kept as a call, as a scene's own functions are: else the compiler sees through it, and takes the measuring code along.
#define BUDGETS_OPAQUE inline __attribute__((noipa))

namespace ingot {

using scalar = float;

enum class Status : uint8_t { ok };

struct StepReport {
    uint32_t trouble;
    bool clean() const { return trouble == 0; }
};

template <class S>
struct World {
    uint64_t state_hash() const { return hash(); }
    static BUDGETS_OPAQUE uint64_t hash() { return 0; }
};

template <class S>
BUDGETS_OPAQUE StepReport step(World<S>&, scalar) {
    return {0};
}

}  // namespace ingot

namespace scenes {

struct Nothing {
    static constexpr const char* name = "nothing";
    static constexpr ingot::scalar h = ingot::scalar(1) / 60;
    static constexpr int golden_steps = 1000;
};

BUDGETS_OPAQUE ingot::Status set_up(ingot::World<Nothing>&) { return ingot::Status::ok; }

}  // namespace scenes
