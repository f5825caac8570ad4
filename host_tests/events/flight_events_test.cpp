// SPDX-License-Identifier: MIT
// What is told of bodies that meet others, or pass a sensor, within a step.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <cmath>
#include <cstdlib>

#include "reference/brief_types.h"

namespace {

using ingot::BodyDef;
using ingot::BodyId;
using ingot::Event;
using ingot::EventKind;
using ingot::scalar;

constexpr double eps = static_cast<double>(ingot::epsilon);
constexpr scalar h = scalar(1) / 60;

template <class Solver, bool asleep, int shapes_of_body>
struct Range : ingot::Scene {
    static constexpr int max_bodies = 4, max_manifolds = 16, max_events = 16, max_overlaps = 4, max_shapes_of_body = shapes_of_body;
    static constexpr bool translates = true, continuous = true, sleeps = asleep, filters = true;
    using solver = Solver;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::Cylinder>;
};

template <class S>
class Flight : public ::testing::Test {};
using Ranges = ingot_reference::BriefTypes<3, Range<ingot::BlockSweeps, true, 2>, Range<ingot::HybridIslands<4>, true, 1>,
                                           Range<ingot::SequentialImpulses, false, 1>, Range<ingot::BlockSweeps, false, 1>,
                                           Range<ingot::SequentialImpulses, true, 2>>;
TYPED_TEST_SUITE(Flight, Ranges);

constexpr scalar radius = scalar(0.02), face = scalar(-0.01);

/// A plate across x, a sensor before it and one, by its filter, for nobody; and what flies towards them along x.
template <class S>
struct Shot {
    ingot::World<S>& world;
    BodyId plate, sensor, shot;

    Shot(ingot::World<S>& of, const ingot::Shape& shape, scalar speed, scalar phase, scalar e) : world(of) {
        world = {};
        BodyDef def;
        def.immovable = true;
        def.restitution = e;
        def.shape = ingot::Box{{-face, 2, 2}};
        plate = world.add(def).value;
        def.sensor = true;
        def.shape = ingot::Box{{scalar(0.01), 1, 1}};
        def.state.r_CM = {scalar(-0.25), 0, 0};
        sensor = world.add(def).value;
        def.filter = {2, 2};
        EXPECT_TRUE(world.add(def).ok());
        BodyDef flying;
        flying.shape = shape;
        flying.restitution = e;
        flying.mass = ingot::principal(ingot::solid_sphere(1000, radius)).value;
        flying.state.r_CM = {scalar(-0.5) - (1 + phase) * speed * h, scalar(0.25), scalar(0.5)};
        flying.state.v_CM = {speed, 0, 0};
        shot = world.add(flying).value;
    }
};

/// From 3 to 800 m/s, in ten phases of a step: it enters the sensor once; what it hits is told once, with the speed that it had
/// and a point on the face, half-way across a gap of impact_gap_max at most; and that it left, if it is thrown back. Speeds are rounded by one step's
/// sums, places by those of 30 m.
TYPED_TEST(Flight, is_told_once_with_its_speed_and_place) {
    static ingot::World<TypeParam> world;
    for (const scalar e : {scalar(0), scalar(0.5)}) {
        for (const double speed : {3.0, 10.0, 50.0, 100.0, 200.0, 800.0}) {
            for (int phase_i = 0; phase_i < 10; ++phase_i) {
                for (const bool is_ball : {true, false}) {
                    SCOPED_TRACE(::testing::Message() << speed << " m/s, phase " << phase_i << ", e " << e << (is_ball ? ", ball" : ", cube"));
                    const ingot::Shape shape = is_ball ? ingot::Shape(ingot::Sphere{radius}) : ingot::Shape(ingot::Box{{radius, radius, radius}});
                    Shot<TypeParam> range(world, shape, static_cast<scalar>(speed), static_cast<scalar>(phase_i) / 10, e);
                    int begins = 0, hits = 0, ends = 0, enters = 0, leaves = 0;
                    for (int step_i = 0; step_i < 40; ++step_i) {
                        ASSERT_EQ(ingot::step(world, h).events_lost, 0);
                        for (const Event& event : world.events()) {
                            begins += event.kind == EventKind::begin;
                            hits += event.kind == EventKind::hit;
                            ends += event.kind == EventKind::end;
                            enters += event.kind == EventKind::enter;
                            leaves += event.kind == EventKind::leave;
                            const bool meets = event.kind == EventKind::begin || event.kind == EventKind::hit;
                            EXPECT_EQ(event.A, event.kind == EventKind::enter || event.kind == EventKind::leave ? range.sensor : range.plate);
                            EXPECT_EQ(event.B, range.shot);
                            if (!meets) continue;
                            EXPECT_NEAR(static_cast<double>(event.speed), speed, 64 * eps * speed);
                            EXPECT_NEAR(static_cast<double>(event.P.x), static_cast<double>(face),
                                        static_cast<double>(ingot::limits::impact_gap_max) / 2 + 8 * eps * 30);
                            EXPECT_LE(std::abs(static_cast<double>(event.P.y) - 0.25), is_ball ? 8 * eps : static_cast<double>(radius) + 8 * eps);
                            EXPECT_NEAR(static_cast<double>(event.n.x), 1, 4 * eps) << "from the shot to the plate";
                        }
                    }
                    EXPECT_EQ(begins, 1);
                    EXPECT_EQ(hits, 1);
                    EXPECT_EQ(ends, e > 0 ? 1 : 0);
                    // On its way back too: 0.24 m at its speed and 0.24 m at half of it later. Whoever is in it in two steps has entered once.
                    const bool returns = e > 0, stays = returns && 0.72 / speed < 3 * static_cast<double>(h);
                    EXPECT_GE(enters, returns && !stays ? 2 : 1);
                    EXPECT_LE(enters, returns ? 2 : 1);
                    EXPECT_EQ(leaves, enters);
                }
            }
        }
    }
}

/// What flies by a sensor is not told to be in it; nor what is thrown back before it would have come there.
TYPED_TEST(Flight, past_a_sensor_or_not_as_far_is_not_told) {
    static ingot::World<TypeParam> world;
    for (const double speed : {100.0, 800.0}) {
        for (const bool beyond : {false, true}) {
            Shot<TypeParam> range(world, ingot::Sphere{radius}, static_cast<scalar>(speed), 0, scalar(0.5));
            ingot::BodyState state = world.state(range.sensor).value;
            state.r_CM = beyond ? ingot::Vector{scalar(0.5), 0, 0} : ingot::Vector{scalar(-0.25), scalar(0.25) + 1 + radius + scalar(0.001), 0};
            ASSERT_EQ(world.set_state(range.sensor, state), ingot::Status::ok);
            for (int step_i = 0; step_i < 20; ++step_i) {
                (void)ingot::step(world, h);
                for (const Event& event : world.events()) EXPECT_TRUE(event.kind != EventKind::enter && event.kind != EventKind::leave);
            }
        }
    }
}

template <class Search>
struct Gate : ingot::Scene {
    static constexpr int max_bodies = 24, max_manifolds = 8, max_pairs = 64, max_overlaps = 3;
    static constexpr bool translates = true, continuous = true;
    using broad_phase = Search;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box>;
};

/// A shot passes twelve sensors in a step, of which three have room: those that were added first, however they lie and whoever finds them.
template <class Search>
void expect_first_are_told() {
    static ingot::World<Gate<Search>> world;
    world = {};
    BodyDef flying;
    flying.shape = ingot::Sphere{radius};
    flying.mass = ingot::principal(ingot::solid_sphere(1000, radius)).value;
    flying.state.v_CM = {60 * scalar(6.5), 0, 0};
    ASSERT_TRUE(world.add(flying).ok());
    BodyId first[3];
    for (int i = 0; i < 12; ++i) {
        BodyDef def;
        def.immovable = def.sensor = true;
        def.shape = ingot::Box{{scalar(0.1), 1, 1}};
        def.state.r_CM = {scalar(1 + i * 5 % 12) / 2, 0, 0};
        const BodyId id = world.add(def).value;
        if (i < 3) first[i] = id;
    }
    EXPECT_EQ(ingot::step(world, h).overlaps_lost, 9);
    ASSERT_EQ(world.overlap_count(), 3);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(world.overlap(i).value.sensor, first[i]) << i;
}

TEST(FlightOfAShot, through_more_sensors_than_have_room_tells_of_the_first) {
    expect_first_are_told<ingot::AllPairs>();
    expect_first_are_told<ingot::SortedTree>();
    expect_first_are_told<ingot::QueryTree>();
}

struct Salvo : ingot::Scene {
    static constexpr int max_bodies = 9, max_manifolds = 16, max_events = 32;
    static constexpr bool translates = true, continuous = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box>;
};

/// Of many that hit within one step, and are gone again at its end, each is told with what it had.
TEST(FlightOfASalvo, is_told_shot_by_shot) {
    static ingot::World<Salvo> world;
    for (int run_i = 0; run_i < 8; ++run_i) {
        world = {};
        BodyDef def;
        def.immovable = true;
        def.restitution = scalar(0.5);
        def.shape = ingot::Box{{-face, 2, 2}};
        if (run_i % 2 == 0) {
            ASSERT_TRUE(world.add(def).ok());
        }
        double speed_of[Salvo::max_bodies] = {}, y_of[Salvo::max_bodies] = {};
        for (int i = 0; i < 8; ++i) {
            const int turn = (3 * i + run_i) % 8;
            const auto speed = static_cast<scalar>(60 + 15 * turn), y = scalar(0.25) * static_cast<scalar>(i) - 1;
            BodyDef flying;
            flying.shape = ingot::Sphere{radius};
            flying.restitution = scalar(0.5);
            flying.mass = ingot::principal(ingot::solid_sphere(1000, radius)).value;
            flying.state.r_CM = {face - radius - scalar(0.1) * static_cast<scalar>(turn + 1) / 2 - speed * h, y, 0};
            flying.state.v_CM = {speed, 0, 0};
            const int slot = world.add(flying).value.slot;
            speed_of[slot] = static_cast<double>(speed);
            y_of[slot] = static_cast<double>(y);
        }
        if (run_i % 2 != 0) {
            ASSERT_TRUE(world.add(def).ok());
        }
        for (int step_i = 0; step_i < 2; ++step_i) {
            ASSERT_EQ(ingot::step(world, h).events_lost, 0);
            int hits = 0;
            for (const Event& event : world.events()) {
                if (event.kind != EventKind::hit) continue;
                ++hits;
                const int shot = speed_of[event.A.slot] != 0 ? event.A.slot : event.B.slot;
                EXPECT_NEAR(static_cast<double>(event.speed), speed_of[shot], 64 * eps * speed_of[shot]) << run_i << ", slot " << shot;
                EXPECT_NEAR(static_cast<double>(event.P.y), y_of[shot], 8 * eps) << run_i << ", slot " << shot;
            }
            EXPECT_EQ(hits, step_i == 0 ? 0 : 8) << run_i;
        }
    }
}

}  // namespace
