// SPDX-License-Identifier: MIT
// Prints what crowds that have too little room come to: the same whatever the lane count.
#include "capacity/crowd.h"

#include <cstdio>

namespace {

template <class S>
void print(const char* name, const crowd::Plan& plan) {
    crowd::Crowd<S> crowd(plan);
    int lost = 0;
    for (int step_i = 0; step_i < crowd.steps(); ++step_i) lost += crowd.step().contacts_lost;
    std::printf("%s %d %016llx\n", name, lost, static_cast<unsigned long long>(crowd.world().state_hash()));
}

}  // namespace

int main() {
    using namespace crowd;
    for (const int rate : {30, 240})
        for (const bool on_tiles : {false, true}) {
            const Plan plan = {static_cast<unsigned>(rate), 40, rate, on_tiles, 2};
            print<Tight<24, 200>>("manifolds", plan);
            print<Tight<24, 30, ingot::SortedTree>>("pairs", plan);
            print<Tight<24, 30, ingot::AllPairs, ingot::SequentialImpulses>>("points", plan);
            print<Tight<24, 60, ingot::SortedTree, ingot::HybridIslands<>, true>>("islands", plan);
        }
    print<TightImpacts<24>>("impacts", {5, 32, 60, false, 2});
    return 0;
}
