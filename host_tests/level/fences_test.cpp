// SPDX-License-Identifier: MIT
// Bodies across fences: thin walls, roofs and blades whose tops are within them. Wherever a contact is told to be, there is the body, and there is
// the ground.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "ground.h"
#include "reference/draws.h"

namespace {

using namespace level_test;

/// Along y: a wall with a flat top, or two triangles a side that lean on a ridge, as sharp as can be; 2 m high.
Ground fence_of(Random& random, bool flat) {
    Soup soup;
    const int thick = between(random, 8, 60), high = 512, drop = between(random, 10, 400);
    if (flat) {
        add_box(soup, {1000 - thick / 2, 0, 0}, {1000 + thick / 2, 2048, high}, 0);
    } else {
        for (const int x : {1000, 1000 - thick, 1000 + thick})
            for (const int y : {0, 2048}) soup.points.push_back(lattice_point(x, y, x == 1000 ? high : high - drop));
        soup.faces = {{0, 1, 3, 0}, {0, 3, 2, 0}, {0, 4, 5, 0}, {0, 5, 1, 0}};
    }
    Ground ground;
    take_mesh(soup, 1.0 / 256, ground);
    return ground;
}

/// A point of a contact is half-way between the two surfaces, along its normal: so it is no further from either than half of what they are apart, or
/// deep in each other; whatever of a fence is in whatever body.
TEST(Fences, are_met_where_they_are) {
    int met = 0, deep = 0;
    for (int draw = 0; draw < ingot_reference::draws(2400); ++draw) {
        Random random(static_cast<uint64_t>(70000 + draw));
        const Ground ground = fence_of(random, draw % 3 == 0);
        auto& world = empty_world<OnLevel>();
        const BodyId level = add_level(world, ground.view);
        ASSERT_EQ(world.set_gravity({}), Status::ok);
        const auto size = static_cast<scalar>(within(random, 0.1, 0.4));
        constexpr Goer kinds[] = {Goer::box, Goer::pebble, Goer::coin, Goer::roller, Goer::ball};
        BodyDef def = goer(random, kinds[draw % 5], size, 0);
        const double reach = draw % 5 == 1 ? 1 : static_cast<double>(size);  // the pebble has a size of its own
        def.state.A = any_rotation(random);
        def.state.r_CM = {static_cast<scalar>(1000.0 / 256 + within(random, -0.5, 0.5) * reach), 4,
                          static_cast<scalar>(2 + within(random, 0.1, 1.2) * reach)};
        const BodyId id = world.add(def).value;
        (void)ingot::step(world, scalar(1) / 240);
        // The body by itself, where it was, and the ground by itself.
        static World<Slab> alone;
        std::memset(static_cast<void*>(&alone), 0, sizeof alone);
        def.state.v_CM = def.state.L = {};
        ASSERT_TRUE(alone.add(def).ok());
        static World<OnLevel> bare;
        std::memset(static_cast<void*>(&bare), 0, sizeof bare);
        ASSERT_TRUE(bare.add_level({}).ok());
        for (const ingot::ContactInfo& contact : world.contacts_of(id)) {
            for (int i = 0; i < contact.point_count; ++i) {
                const Vector P = contact.points[i].P;
                const double s = static_cast<double>(contact.points[i].separation);
                const double to_body = static_cast<double>(alone.find_nearest(P, 100).value.distance);
                const double to_ground = std::abs(static_cast<double>(bare.find_nearest(P, 100).value.distance));
                // Of flat faces points count that are off the nearest by some of the tolerances of faces, along them.
                const double tolerance = 0.02 * reach;
                ASSERT_LE(to_body, std::abs(s) / 2 + tolerance) << draw << ", separation " << s;
                ASSERT_LE(to_ground, std::abs(s) / 2 + tolerance) << draw << ", separation " << s;
                ASSERT_TRUE(contact.A == level || contact.B == level);
                ++met;
                deep += s < -0.05 * reach ? 1 : 0;
            }
        }
    }
    EXPECT_GT(met, ingot_reference::draws(2400));
    EXPECT_GT(deep, ingot_reference::draws(2400) / 4);
}

}  // namespace
