// SPDX-License-Identifier: MIT
// Comes before the machines of fuzz/, by -include: their steps become steps that are counted. Nothing else of them is another than what the fuzzers
// run.
#pragma once

#include <ingot/ingot.h>
#include <ingot/platform/clock.h>

/// Prints what a step took. `scene` is the signature of the function that took it, which names the scene.
void print_step(const char* scene, uint64_t ticks, int contacts);

/// A step as it is, between two readings of the clock. Refused steps are not printed.
template <class S>
ingot::StepReport counted_step(ingot::World<S>& world, ingot::scalar h) {
    const uint64_t begin = ingot::platform::clock_ticks();
    const ingot::StepReport report = ingot::step(world, h);
    const uint64_t ticks = ingot::platform::clock_ticks() - begin;
    if (report.status == ingot::Status::ok) print_step(__PRETTY_FUNCTION__, ticks, report.contacts);
    return report;
}

#define INGOT_FUZZ_STEP counted_step
