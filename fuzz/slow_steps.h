// SPDX-License-Identifier: MIT
// Comes before the machines by -include, with INGOT_FUZZ_SLOW: a step of a scene that is slower than all before it is news to libFuzzer, like a
// branch that nobody took. So the corpus grows towards slow steps. host_tests/budgets/worst_steps counts the instructions of what was found.
#pragma once

#include <ingot/ingot.h>
#include <string.h>

namespace fuzz {

inline constexpr int scenes_max = 32, levels = 256;
/// Of each scene, the levels that a step has reached. libFuzzer finds it by the name of the section, and nobody else reads it. A target has one
/// machine, so there is one.
__attribute__((section("__libfuzzer_extra_counters"), used)) static uint8_t levels_reached[scenes_max * levels];
inline int scene_count = 0;
template <class S>
const int index_of_scene = scene_count++ % scenes_max;

/// A level is an eighth of an octave, wide enough for the noise of the clock.
inline int level_of(uint64_t cycles) {
    const int octave = 63 - __builtin_clzll(cycles | 8);
    return (octave * 8 + static_cast<int>(cycles >> (octave - 3) & 7u)) % levels;
}

/// A step as it is; before it, the same steps of a copy, of which the fastest tells the cycles.
template <class S>
ingot::StepReport timed_step(ingot::World<S>& world, ingot::scalar h) {
    static ingot::World<S> copy;
    uint64_t cycles = ~uint64_t{0};
    for (int try_i = 0; try_i < 3; ++try_i) {
        memcpy(static_cast<void*>(&copy), &world, sizeof world);
        const uint64_t begin = __builtin_readcyclecounter();
        (void)ingot::step(copy, h);
        const uint64_t now = __builtin_readcyclecounter() - begin;
        cycles = now < cycles ? now : cycles;
    }
    levels_reached[index_of_scene<S> * levels + level_of(cycles)] = 1;
    return ingot::step(world, h);
}

}  // namespace fuzz

#define INGOT_FUZZ_STEP fuzz::timed_step
