// SPDX-License-Identifier: MIT
// Several shapes on one body: where they are when the body is somewhere, and how they move with it.
#include <gtest/gtest.h>
#include <ingot/body/auxiliary.h>
#include <ingot/collide/compound.h>

#include "collide/placed.h"
#include "stages/tiles.h"

namespace {

using namespace ingot_collide;
using ingot::lanes;
using ingot_stages::Tiles;

TEST(PlacedShapes, are_where_the_body_has_them_and_turn_with_it) {
    constexpr int bodies = 3, each = 3;
    RandomInput random(1451);
    Tiles tiles(bodies), shapes(bodies * each);
    std::vector<ingot::Surface> surfaces(bodies * each);
    std::vector<ingot::ShapePlace> places(bodies * each);
    for (int slot = 0; slot < bodies; ++slot) {
        ingot::BodyDef def = ingot_reference::definition(random.real(1, 4), random.moments(1));
        def.state = {to_vector(random.vector(3)), to_vector(random.vector(3)), to_matrix(random.rotation()), to_vector(random.vector(1))};
        tiles.write(slot, def);
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] = {to_vector(random.vector(1)), to_matrix(random.rotation())};
        if (i % each != 2) surfaces[i].shape = ingot::Sphere{1};  // the third place of each body is empty
    }
    const ingot::CompoundView compounds = {surfaces.data(), places.data(), shapes.view(), each};
    ingot::place_shapes(tiles.view(), compounds, 1);
    const double rounding = 32 * static_cast<double>(ingot::epsilon);
    for (int i = 0; i < bodies * each; ++i) {
        const ingot::BodyState shape = shapes.state(i), body = tiles.state(i / each);
        const ingot::scalar inv_M = shapes.translation(i).inv_M[i % lanes];
        if (i / each != 1 || i % each == 2) {  // of other bodies, or none
            EXPECT_EQ(inv_M, 0);
            EXPECT_EQ(exact(shape.r_CM), V::Zero());
            continue;
        }
        const ingot::ShapePlace& place = places[static_cast<std::size_t>(i)];
        EXPECT_EQ(inv_M, tiles.translation(1).inv_M[1 % lanes]);
        EXPECT_LE(static_cast<double>((exact(shape.r_CM) - exact(body.r_CM) - exact(body.A) * exact(place.r)).norm()), rounding * 4);
        EXPECT_LE(static_cast<double>((exact(shape.A) - exact(body.A) * exact(place.A)).norm()), rounding);
        EXPECT_EQ(exact(shape.v_CM), exact(body.v_CM));
        const V omega = exact(ingot::omega_of(tiles.view(), 1));
        EXPECT_GT(static_cast<double>(omega.norm()), 0.1);
        EXPECT_LE(static_cast<double>((exact(ingot::omega_of(shapes.view(), i)) - omega).norm()), rounding * static_cast<double>(omega.norm()));
    }
}

}  // namespace
