// SPDX-License-Identifier: MIT
// Fast bodies that are followed within a step, together with all that a scene can name beside: hulls, bodies of several shapes, sleep, filters,
// sensors and events, rolling resistance, belts, and every solver. What is demanded: see friction.h. The first byte chooses the scene.
//
// Compiled once for each lane count. INGOT_FUZZ_RUN names the function.
#include "friction.h"
#include "hulls.h"

namespace {

using fuzz::Bytes;
using fuzz::Friction;
using fuzz::octahedron;
using fuzz::sliver;

/// Every shape.
struct Range : ingot::Scene {
    static constexpr int max_bodies = 6;
    static constexpr bool translates = true, continuous = true;
    static constexpr int max_manifolds = 15, max_pairs = 15;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {octahedron.value.view(), sliver.value.view()};
};
/// Of bodies of up to three shapes, through a tree.
struct Foundry : Range {
    static constexpr int max_shapes_of_body = 3;
    static constexpr int max_manifolds = 40, max_pairs = 80;
    using broad_phase = ingot::SortedTree;
};
/// The same with islands that are solved directly, in arrays that fill.
struct Smithy : Foundry {
    static constexpr int max_manifolds = 12, max_pairs = 20;
    using solver = ingot::HybridIslands<12, 18>;
};
/// Who is at rest sleeps; with filters, sensors and events.
struct Barracks : Range {
    static constexpr bool sleeps = true, filters = true;
    static constexpr int max_overlaps = 15, max_events = 60;
    using broad_phase = ingot::SortedTree;
};
/// Sleep that is saved, of bodies of several shapes.
struct Depot : Range {
    static constexpr bool sleeps = true;
    static constexpr int max_shapes_of_body = 2;
    static constexpr int max_manifolds = 40, max_pairs = 80;
};
/// Surfaces that resist being rolled, and that move.
struct Mill : Range {
    static constexpr bool rolling_resistance = true, surface_velocities = true;
};
/// Solved point by point.
struct Shelf : Range {
    static constexpr bool bounces = false;
    using solver = ingot::SequentialImpulses;
};
/// The same with all that it can have beside.
struct Bay : Range {
    static constexpr bool rolling_resistance = true, surface_velocities = true, sleeps = true;
    static constexpr int max_shapes_of_body = 2;
    static constexpr int max_manifolds = 40, max_pairs = 80;
    using solver = ingot::SequentialImpulses;
};

}  // namespace

uint64_t INGOT_FUZZ_RUN(const uint8_t* data, size_t size) {
    Bytes in(data, size);
    switch (in.byte() % 8u) {
        case 0: return Friction<Range>().run(in);
        case 1: return Friction<Foundry>().run(in);
        case 2: return Friction<Smithy>().run(in);
        case 3: return Friction<Barracks>().run(in);
        case 4: return Friction<Depot>().run(in);
        case 5: return Friction<Mill>().run(in);
        case 6: return Friction<Shelf>().run(in);
        default: return Friction<Bay>().run(in);
    }
}
