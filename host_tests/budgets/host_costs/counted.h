// SPDX-License-Identifier: MIT
// Steps of a world that are counted.
#pragma once

#include <ingot/ingot.h>
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstdlib>

#include "scenes/contact/stacks.h"

namespace host_costs {

inline void expect(bool good, const char* what) {
    if (good) return;
    std::fprintf(stderr, "host_costs: %s\n", what);
    std::exit(1);
}

template <class S>
ingot::BodyId add(ingot::World<S>& world, scenes::PlacedBody body) {
    body.def.friction = body.mu;
    const ingot::Result<ingot::BodyId> id = world.add(body.def);
    expect(id.ok(), "a body was refused");
    return id.value;
}
template <class S>
__attribute__((noinline)) ingot::StepReport one_step(ingot::World<S>& world) {
    return ingot::step(world, ingot::scalar(1) / 60);
}

template <class S>
void measure(ingot::World<S>& world, int settling, int measured) {
    for (int step_i = 0; step_i < settling; ++step_i) (void)one_step(world);
    CALLGRIND_START_INSTRUMENTATION;
    (void)one_step(world);
    for (int step_i = 0; step_i < measured; ++step_i) {
        CALLGRIND_TOGGLE_COLLECT;
        const ingot::StepReport report = one_step(world);
        CALLGRIND_TOGGLE_COLLECT;
        CALLGRIND_DUMP_STATS;
        expect(report.status == ingot::Status::ok && report.contacts_lost == 0, "the world is too small");
    }
    CALLGRIND_STOP_INSTRUMENTATION;
}

}  // namespace host_costs
