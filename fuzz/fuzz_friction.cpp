// SPDX-License-Identifier: MIT
// Contacts with friction: see friction.h. The first byte chooses the scene: both broad phases, arrays that fill and arrays that do not, with and
// without filters, sensors, events, and renewal of manifolds. Hulls, compounds, direct solves, sleep and fast bodies: see fuzz_rooms.cpp.
//
// Compiled once for each lane count. INGOT_FUZZ_RUN names the function.
#include "friction.h"

namespace {

using fuzz::Bytes;
using fuzz::Friction;

/// Everything, in arrays that fill.
struct Crowd : ingot::Scene {
    static constexpr int max_bodies = 7;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 8;
    static constexpr int max_pairs = 12;
    static constexpr bool filters = true;
    static constexpr int max_overlaps = 3;
    static constexpr int max_events = 6;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
};
/// Everything, in arrays that never do: no event is lost.
struct Hall : Crowd {
    static constexpr int max_manifolds = 21, max_pairs = 21, max_overlaps = 21, max_events = 84;
};
struct TreeHall : Hall {
    using broad_phase = ingot::SortedTree;
};
/// What a snapshot can hold.
struct Yard : Crowd {
    static constexpr int max_events = 0;
    using broad_phase = ingot::SortedTree;
};
/// The least there is of contacts with friction, searched for anew in every step.
struct Bare : ingot::Scene {
    static constexpr int max_bodies = 5;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 10;
    static constexpr bool recycles_manifolds = false;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
/// The same with another method of rotation.
struct BareTops : Bare {
    static constexpr bool recycles_manifolds = true;
    using rotation = ingot::SymmetricTopSplitting<6>;
};

}  // namespace

uint64_t INGOT_FUZZ_RUN(const uint8_t* data, size_t size) {
    Bytes in(data, size);
    switch (in.byte() % 8u) {
        case 0: case 1: return Friction<Hall>().run(in);
        case 2: return Friction<TreeHall>().run(in);
        case 3: return Friction<Crowd>().run(in);
        case 4: case 5: return Friction<Yard>().run(in);
        case 6: return Friction<Bare>().run(in);
        default: return Friction<BareTops>().run(in);
    }
}
