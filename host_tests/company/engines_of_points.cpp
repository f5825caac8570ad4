// SPDX-License-Identifier: MIT
// Worlds for small targets: contacts point by point, and impacts without friction.
#include "engine_world.h"

namespace company {

namespace {

struct Points : Roomy {
    using solver = ingot::SequentialImpulses;
    static constexpr bool bounces = false;
};
struct PointSleepers : Sleepy {
    using solver = ingot::SequentialImpulses;
    using rotation = ingot::LieMidpoint;
    using broad_phase = ingot::AllPairs;
    static constexpr bool bounces = false, recycles_manifolds = false, continuous = true;
    static constexpr int max_events = 4000;
};
struct Impacts : ingot::Scene {
    static constexpr int max_bodies = 760;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 8000;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};

}  // namespace

std::vector<Engine> engines_of_points() {
    return {engine<Points>("SequentialImpulses"), engine<PointSleepers>("SequentialSleepers"), engine<Impacts>("Impacts")};
}

}  // namespace company
