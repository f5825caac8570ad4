// SPDX-License-Identifier: MIT
// Worlds that BlockSweeps solves, with one after the other of what a scene may name.
#include "engine_world.h"
#include "scenes/hulls.h"

namespace company {

namespace {

struct Materials : Roomy {
    static constexpr bool rolling_resistance = true, surface_velocities = true, recycles_manifolds = false, continuous = true;
    using broad_phase = ingot::AllPairs;
    using force_field = ingot::LinearDrag;
};
struct Sleepers : Sleepy {
    static constexpr bool filters = true, continuous = true;
    static constexpr int max_overlaps = 64, max_events = 4000;
};
struct FastBodies : Roomy {
    static constexpr bool continuous = true;
    static constexpr int max_events = 4000;
};
struct ManyShapes : scenes::Hulled<760, 3600> {
    static constexpr int max_shapes_of_body = 5;
    static constexpr int max_overlaps = 64, max_events = 4000;
    static constexpr bool filters = true, bounces = false, continuous = true;
    using broad_phase = ingot::SortedTree;
};

}  // namespace

std::vector<Engine> engines_of_sweeps() {
    return {engine<Roomy>("BlockSweeps"), engine<Materials>("Materials"), engine<Sleepers>("Sleepers"), engine<FastBodies>("FastBodies"),
            engine<ManyShapes>("ManyShapes")};
}

}  // namespace company
