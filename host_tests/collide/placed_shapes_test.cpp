// SPDX-License-Identifier: MIT
// Several shapes on one body: where they are when the body is somewhere, and how they move with it.
#include <gtest/gtest.h>
#include <ingot/body/auxiliary.h>
#include <ingot/shape/compound.h>
#include <ingot/narrow_phase/nearest_points.h>
#include <ingot/events/contact_events.h>

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

/// Events of shape slots become those of bodies, and say which of their shapes.
TEST(PlacedShapes, have_events_of_their_bodies) {
    constexpr int each = 3;
    ingot::Event events[4] = {};
    ingot::Index count = 0, lost = 0;
    for (int i = 0; i < 4; ++i) {
        events[i].A.slot = static_cast<ingot::Index>(5 + i), events[i].A.generation = 7;
        events[i].B.slot = static_cast<ingot::Index>(13 + i);
        ++count;
    }
    ingot::name_bodies<each>({events, &count, 4, &lost});
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(events[i].A.slot, (5 + i) / each);
        EXPECT_EQ(events[i].shape_A, (5 + i) % each);
        EXPECT_EQ(events[i].B.slot, (13 + i) / each);
        EXPECT_EQ(events[i].shape_B, (13 + i) % each);
        EXPECT_EQ(events[i].A.generation, 7);
    }
}

/// overlap() asks for no distance beyond 0; closest_points() stops early only where the distance is beyond what is enough.
TEST(Overlap, of_round_and_edged_shapes_is_that_of_the_oracle) {
    RandomInput random(1452);
    int overlapping = 0, apart = 0, within = 0;
    for (int i = 0; i < 600; ++i) {
        const auto any = [&]() -> ingot::Shape {
            const auto length = [&] { return static_cast<scalar>(random.real(0.2, 1)); };
            const scalar a = length(), b = length(), c = length();
            if (i % 3 == 0) return ingot::Sphere{a};
            if (i % 3 == 1) return ingot::Capsule{a, b};
            return ingot::Box{{a, b, c}};
        };
        const ingot::Shape shape_A = any(),
                           shape_B = ingot::Capsule{static_cast<scalar>(random.real(0.2, 1)), static_cast<scalar>(random.real(0.2, 1))};
        const Eigen::Matrix3d turn_A = random.rotation(), turn_B = random.rotation();
        const PlacedShape A = placed(shape_A, Eigen::Vector3d::Zero(), turn_A), B = placed(shape_B, random.vector(2), turn_B);
        const double exact_s = static_cast<double>(ingot_oracle::signed_distance(oracle_of(A), oracle_of(B)));
        if (std::abs(exact_s) < 1e-4) continue;
        EXPECT_EQ(ingot::overlap(A, B), exact_s < 0) << i;
        ++(exact_s < 0 ? overlapping : apart);
        const double enough = random.real(0, 2);
        const ingot::Nearest nearest = ingot::closest_points(A, B, static_cast<scalar>(enough));
        EXPECT_EQ(nearest.overlap, exact_s < 0) << i;
        if (exact_s > 0 && exact_s < enough) {
            ++within;
            EXPECT_NEAR(static_cast<double>(nearest.distance), exact_s,
                        (static_cast<double>(ingot::limits::nearest_accuracy) + 64 * static_cast<double>(ingot::epsilon)) * 4)
                << i;
        }
    }
    EXPECT_GT(overlapping, 50);
    EXPECT_GT(apart, 50);
    EXPECT_GT(within, 30);
}

}  // namespace
