// SPDX-License-Identifier: MIT
// Worlds whose islands may be solved directly.
#include "engine_world.h"

namespace company {

namespace {

struct Hybrid : Roomy {
    using solver = ingot::HybridIslands<>;
};
struct HybridSleepers : Sleepy {
    using solver = ingot::HybridIslands<>;
    static constexpr int max_events = 4000;
    using broad_phase = ingot::AllPairs;
};
struct HybridFast : Roomy {
    using solver = ingot::HybridIslands<20, 10>;
    static constexpr bool continuous = true, recycles_manifolds = false;
};

}  // namespace

std::vector<Engine> engines_of_islands() {
    return {engine<Hybrid>("HybridIslands"), engine<HybridSleepers>("HybridSleepers"), engine<HybridFast>("HybridFast")};
}

}  // namespace company
