// SPDX-License-Identifier: MIT
#include <ingot/ingot.h>

struct Everything : ingot::Scene {
    static constexpr int max_bodies = 100, max_contacts = 50;
    using solver = ingot::FrictionlessImpacts;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};

extern ingot::World<Everything> the_world;
ingot::World<Everything> the_world;
