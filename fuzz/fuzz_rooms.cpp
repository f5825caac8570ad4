// SPDX-License-Identifier: MIT
// Contacts with friction in scenes that name more than fuzz_friction.cpp: hulls, bodies of several shapes, direct solves, sleep, fast bodies that are
// followed, alone and in pairs; fuzz_fast.cpp has them together. What is demanded: see friction.h. The first byte chooses the scene.
//
// Compiled once for each lane count. INGOT_FUZZ_RUN names the function.
#include "friction.h"
#include "hulls.h"

namespace {

using fuzz::Bytes;
using fuzz::Friction;
using fuzz::octahedron;
using fuzz::sliver;
using ingot::scalar;
using ingot::Vector;

/// A hull whose origin is its centre; the body may have any mass.
constexpr Vector wedge_points[6] = {{scalar(-0.5), scalar(-0.5), scalar(-0.25)},
                                    {scalar(0.5), scalar(-0.5), scalar(-0.25)},
                                    {scalar(-0.5), scalar(0.5), scalar(-0.25)},
                                    {scalar(0.5), scalar(0.5), scalar(-0.25)},
                                    {scalar(-0.5), 0, scalar(0.5)},
                                    {scalar(0.5), 0, scalar(0.5)}};
constexpr auto wedge = ingot::convex_hull(wedge_points);
static_assert(wedge.ok());

/// Every shape; arrays that never fill, for one shape a body.
struct Room : ingot::Scene {
    static constexpr int max_bodies = 7;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 21, max_pairs = 21;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {wedge.value.view(), octahedron.value.view(), sliver.value.view()};
};
/// Hulls on each other, solved directly, and saved.
struct Quarry : Room {
    using solver = ingot::HybridIslands<12, 18>;
};
/// The same with events and sensors, and islands that are too large to be solved.
struct Hall : Room {
    using solver = ingot::HybridIslands<3, 6>;
    static constexpr bool filters = true;
    static constexpr int max_overlaps = 21, max_events = 84;
};
/// Bodies of up to three shapes, swept or solved directly.
struct Shed : Room {
    static constexpr int max_shapes_of_body = 3;
    static constexpr int max_manifolds = 40, max_pairs = 80;
    using broad_phase = ingot::SortedTree;
};
struct SolvedShed : Shed {
    using solver = ingot::HybridIslands<12, 18>;
};
/// Who is at rest sleeps.
struct Dormitory : Room {
    static constexpr bool sleeps = true;
    using solver = ingot::HybridIslands<12, 18>;
};
struct SweptDormitory : Room {
    static constexpr bool sleeps = true, filters = true;
    static constexpr int max_overlaps = 21, max_events = 84;
    using broad_phase = ingot::SortedTree;
};
/// Fast bodies are followed.
struct Range : ingot::Scene {
    static constexpr int max_bodies = 6;
    static constexpr bool translates = true, continuous = true;
    static constexpr int max_manifolds = 15, max_pairs = 15;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
};
struct SolvedRange : Range {
    using solver = ingot::HybridIslands<12, 18>;
    static constexpr bool filters = true;
};

}  // namespace

uint64_t INGOT_FUZZ_RUN(const uint8_t* data, size_t size) {
    Bytes in(data, size);
    switch (in.byte() % 8u) {
        case 0: return Friction<Quarry>().run(in);
        case 1: return Friction<Hall>().run(in);
        case 2: return Friction<Shed>().run(in);
        case 3: return Friction<SolvedShed>().run(in);
        case 4: return Friction<Dormitory>().run(in);
        case 5: return Friction<SweptDormitory>().run(in);
        case 6: return Friction<Range>().run(in);
        default: return Friction<SolvedRange>().run(in);
    }
}
