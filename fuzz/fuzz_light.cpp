// SPDX-License-Identifier: MIT
// Contacts with friction that are solved point by point, by SequentialImpulses, with what a scene may name beside it. What is demanded: see
// friction.h. The first byte chooses the scene.
//
// Compiled once for each lane count. INGOT_FUZZ_RUN names the function.
#include "friction.h"
#include "hulls.h"

namespace {

using fuzz::Bytes;
using fuzz::Friction;
using fuzz::octahedron;
using fuzz::sliver;

/// Every shape, and what a snapshot can hold; arrays that never fill.
struct Shelf : ingot::Scene {
    static constexpr int max_bodies = 6;
    static constexpr bool translates = true, bounces = false;
    static constexpr int max_manifolds = 15, max_pairs = 15;
    using solver = ingot::SequentialImpulses;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {octahedron.value.view(), sliver.value.view()};
};
/// Bodies of up to three shapes, with filters, sensors and events.
struct Rack : Shelf {
    static constexpr int max_shapes_of_body = 3;
    static constexpr int max_manifolds = 40, max_pairs = 80;
    static constexpr bool filters = true;
    static constexpr int max_overlaps = 15, max_events = 160;
    using broad_phase = ingot::SortedTree;
};
/// Who is at rest sleeps; with filters, sensors and events.
struct Dormitory : Shelf {
    static constexpr bool sleeps = true, filters = true;
    static constexpr int max_overlaps = 15, max_events = 60;
};
/// Sleep that is saved.
struct Cellar : Shelf {
    static constexpr bool sleeps = true;
    using broad_phase = ingot::SortedTree;
};
/// Arrays that fill, of which events are lost.
struct Crowd : Shelf {
    static constexpr int max_manifolds = 5, max_pairs = 8;
    static constexpr bool filters = true;
    static constexpr int max_overlaps = 3, max_events = 6;
};
/// The least there is, searched for anew in every step, with another method of rotation.
struct Bare : ingot::Scene {
    static constexpr int max_bodies = 5;
    static constexpr bool translates = true, bounces = false, recycles_manifolds = false;
    static constexpr int max_manifolds = 10;
    using solver = ingot::SequentialImpulses;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using rotation = ingot::SymmetricTopSplitting<6>;
};

}  // namespace

uint64_t INGOT_FUZZ_RUN(const uint8_t* data, size_t size) {
    Bytes in(data, size);
    switch (in.byte() % 8u) {
        case 0: case 1: return Friction<Shelf>().run(in);
        case 2: case 3: return Friction<Rack>().run(in);
        case 4: return Friction<Dormitory>().run(in);
        case 5: return Friction<Cellar>().run(in);
        case 6: return Friction<Crowd>().run(in);
        default: return Friction<Bare>().run(in);
    }
}
