// SPDX-License-Identifier: MIT
// A level takes several slots of shapes, and is one body: who senses it is told of it once, under its id, be it slow or fast.
#include <algorithm>
#include <memory>
#include <vector>

#include "level/small_levels.h"
#include "reference/draws.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"
#include "stage.h"

using namespace events_stage;

namespace {

/// Shapes of one body are as many as it has: so a level takes four slots of bodies, or two.
template <int shapes_of_body>
struct OverHills : ingot::Scene {
    static constexpr int max_bodies = 16, max_manifolds = 48, max_shapes_of_body = shapes_of_body;
    static constexpr int max_overlaps = 32, max_events = 64;
    static constexpr bool translates = true, continuous = true;
    static constexpr ingot::LevelTable levels[] = {level_test::hill.value.view()};
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::Level>;
};

struct Sensed {
    BodyId sensor, visitor;
    bool operator==(const Sensed& other) const { return sensor == other.sensor && visitor == other.visitor; }
};

/// How many steps had the level in a sensor, slow or in flight.
struct Met {
    int slow, fast;
};

template <int shapes_of_body>
void expect_told_once(uint64_t seed, Met& met) {
    using Hills = World<OverHills<shapes_of_body>>;
    ingot_reference::RandomInput random(seed);
    const auto world = std::make_unique<Hills>();
    const bool level_first = random.integer(0, 1) == 0, is_fast = random.integer(0, 1) == 0;
    BodyId level{};
    const auto add_level = [&] {
        const auto added = world->add_level({});
        ASSERT_TRUE(added.ok());
        level = added.value;
    };
    if (level_first) add_level();
    for (int i = 0; i < 3; ++i) {
        const auto size = static_cast<scalar>(random.real(0.05, 0.4));
        const Vector r = {static_cast<scalar>(random.real(0, 3)), static_cast<scalar>(random.real(0, 1)), static_cast<scalar>(random.real(0.3, 2))};
        const Vector v = {0, 0, static_cast<scalar>(is_fast ? -random.real(50, 300) : -random.real(0.1, 3))};
        BodyDef def = body(random.integer(0, 1) == 0 ? Shape(ingot::Sphere{size}) : Shape(ingot::Box{{size, size, size}}), r, v);
        ASSERT_TRUE(world->add(i < 2 ? sensor(def) : def).ok());
    }
    if (!level_first) add_level();

    std::vector<Sensed> in;
    for (int step_i = 0; step_i < 40; ++step_i) {
        ASSERT_EQ(ingot::step(*world, h).overlaps_lost, 0);
        for (const ingot::Event& event : world->events()) {
            const Sensed pair = {event.A, event.B};
            const auto place = std::find(in.begin(), in.end(), pair);
            if (event.kind == ingot::EventKind::enter) {
                ASSERT_EQ(place, in.end()) << "entered twice";
                in.push_back(pair);
            } else if (event.kind == ingot::EventKind::leave) {
                ASSERT_NE(place, in.end()) << "left without having entered";
                in.erase(place);
            }
        }
        ASSERT_EQ(world->overlap_count(), static_cast<int>(in.size()));
        for (int i = 0; i < world->overlap_count(); ++i) {
            const ingot::OverlapInfo overlap = world->overlap(i).value;
            ASSERT_NE(std::find(in.begin(), in.end(), Sensed{overlap.sensor, overlap.visitor}), in.end());
            ASSERT_EQ(world->body_at(overlap.visitor.slot), overlap.visitor);
            if (overlap.visitor == level) ++(is_fast ? met.fast : met.slow);
        }
    }
}

template <int shapes_of_body>
void expect_all_told_once() {
    Met met{};
    const int count = ingot_reference::draws(64);
    for (int i = 0; i < count; ++i) ASSERT_NO_FATAL_FAILURE(expect_told_once<shapes_of_body>(static_cast<uint64_t>(i) + 1, met)) << "seed " << i + 1;
    EXPECT_GT(met.slow, count / 4);
    EXPECT_GT(met.fast, count / 8);
}

TEST(SensorsOnLevels, are_told_of_a_level_once) { expect_all_told_once<1>(); }
TEST(SensorsOnLevels, are_told_of_a_level_once_among_bodies_of_several_shapes) { expect_all_told_once<3>(); }

}  // namespace
