// SPDX-License-Identifier: MIT
// Contacts with friction where surfaces resist being rolled, or move by themselves. What is demanded: see friction.h. The first byte chooses the
// scene: both, each alone, with bodies of several shapes, hulls, sleep, sensors and events.
//
// Compiled once for each lane count. INGOT_FUZZ_RUN names the function.
#include "friction.h"
#include "hulls.h"

namespace {

using fuzz::Bytes;
using fuzz::Friction;
using fuzz::octahedron;

/// Both, and what a snapshot can hold; arrays that never fill.
struct Mill : ingot::Scene {
    static constexpr int max_bodies = 6;
    static constexpr bool translates = true, rolling_resistance = true, surface_velocities = true;
    static constexpr int max_manifolds = 15, max_pairs = 15;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
};
/// Of bodies of up to three shapes, each with a surface of its own.
struct Train : Mill {
    static constexpr int max_shapes_of_body = 3;
    static constexpr int max_manifolds = 40, max_pairs = 80;
    using broad_phase = ingot::SortedTree;
};
/// Balls that come to rest, in arrays that fill; saved.
struct Lawn : Mill {
    static constexpr bool surface_velocities = false;
    static constexpr int max_manifolds = 6, max_pairs = 10;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
};
/// Belts, searched for anew in every step.
struct Conveyor : Mill {
    static constexpr bool rolling_resistance = false, recycles_manifolds = false;
    using shapes = ingot::Shapes<ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
};
/// Both, and who is at rest sleeps; saved.
struct Dormitory : Mill {
    static constexpr bool sleeps = true;
    using broad_phase = ingot::SortedTree;
};
/// Everything that may be beside them.
struct Hall : Mill {
    static constexpr bool sleeps = true, filters = true;
    static constexpr int max_overlaps = 15, max_events = 60;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {octahedron.value.view()};
};

}  // namespace

uint64_t INGOT_FUZZ_RUN(const uint8_t* data, size_t size) {
    Bytes in(data, size);
    switch (in.byte() % 8u) {
        case 0: case 1: return Friction<Mill>().run(in);
        case 2: return Friction<Train>().run(in);
        case 3: return Friction<Lawn>().run(in);
        case 4: return Friction<Conveyor>().run(in);
        case 5: case 6: return Friction<Dormitory>().run(in);
        default: return Friction<Hall>().run(in);
    }
}
