// SPDX-License-Identifier: MIT
// A level takes several slots of shapes, and is one body: who senses it is told of it once, under its id, be it slow or fast, small or large, alone
// or with others beside it, at any rate.
#include <algorithm>
#include <memory>
#include <vector>

#include "level/small_levels.h"
#include "reference/draws.h"
#include "reference/kernel_types.h"
#include "reference/powers_of_two.h"
#include "reference/random_input.h"
#include "stage.h"

using namespace events_stage;

namespace {

using ingot_reference::power_of_two;

template <int k>
constexpr auto hill_of_size() {
    return ingot::height_field_of<4, 2>(level_test::hill_samples, power_of_two(k), power_of_two(k), power_of_two(k - 6));
}
template <int k>
inline constexpr auto hill = hill_of_size<k>();

/// Shapes of one body are as many as it has: so a level takes four slots of bodies, or two.
template <int shapes_of_body>
struct OverHills : ingot::Scene {
    static constexpr int max_bodies = 24, max_manifolds = 96, max_shapes_of_body = shapes_of_body;
    static constexpr int max_overlaps = 64, max_events = 128;
    static constexpr bool translates = true, continuous = true;
    static constexpr ingot::LevelTable levels[] = {hill<-6>.value.view(), hill<-3>.value.view(), hill<0>.value.view(), hill<3>.value.view(),
                                                   hill<6>.value.view()};
    static constexpr double sizes[] = {0.015625, 0.125, 1, 8, 64};
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::Level>;
};

struct Sensed {
    BodyId sensor, visitor;
    bool operator==(const Sensed& other) const { return sensor == other.sensor && visitor == other.visitor; }
};

/// How many steps had a level in a sensor, slow or in flight.
struct Met {
    int slow, fast;
};

/// A level somewhere, turned, and two sensors and a body above it that go down: in all of the run, or by a length of the level's cells and more in a
/// step. Some of them meet the level beside it, too.
template <class S>
void add_hill(World<S>& world, ingot_reference::RandomInput& random, double dt, bool is_fast, std::vector<BodyId>& levels) {
    using ingot_reference::to_vector;
    ingot::LevelDef level;
    level.number = random.integer(0, 4);
    const double size = S::sizes[level.number];
    const Eigen::Matrix3d A = random.rotation();
    const Eigen::Vector3d place = random.vector(4 * size) + Eigen::Vector3d(0, levels.empty() ? 0 : 2000, 0);
    level.r = to_vector(place);
    level.A = ingot_reference::to_matrix(A);
    ingot::LevelDef beside = level;
    beside.r = to_vector(place + 3 * size * A.col(0));
    const bool level_first = random.integer(0, 1) == 0, has_two = random.integer(0, 1) == 0;
    const auto add_levels = [&] {
        for (int i = 0; i < (has_two ? 2 : 1); ++i) {
            const auto added = world.add_level(i == 0 ? level : beside);
            ASSERT_TRUE(added.ok());
            levels.push_back(added.value);
        }
    };
    if (level_first) add_levels();
    for (int i = 0; i < 3; ++i) {
        const auto half = static_cast<scalar>(size * random.real(0.05, 0.4));
        const Eigen::Vector3d above = size * Eigen::Vector3d(random.real(0, has_two ? 6 : 3), random.real(0, 1), random.real(0.3, 2));
        const double speed = is_fast ? random.real(0.8, 4.7) * size / dt : random.real(0.05, 2) * size / (40 * dt);
        const Shape shape = random.integer(0, 1) == 0 ? Shape(ingot::Sphere{half}) : Shape(ingot::Box{{half, half, half}});
        BodyDef def = body(shape, to_vector(place + A * above), to_vector(-speed * A.col(2)));
        def.state.A = level.A;
        ASSERT_TRUE(world.add(i < 2 ? sensor(def) : def).ok());
    }
    if (!level_first) add_levels();
}

template <int shapes_of_body>
void expect_told_once(uint64_t seed, Met& met) {
    using Hills = World<OverHills<shapes_of_body>>;
    ingot_reference::RandomInput random(seed);
    const auto world = std::make_unique<Hills>();
    constexpr double rates[] = {30, 60, 120, 240, 1000};
    const double dt = 1 / rates[random.integer(0, 4)];
    const bool is_fast = random.integer(0, 1) == 0;
    std::vector<BodyId> levels;
    for (int hill_i = random.integer(0, 1); hill_i < 2; ++hill_i) ASSERT_NO_FATAL_FAILURE(add_hill(*world, random, dt, is_fast, levels));

    std::vector<Sensed> in;
    for (int step_i = 0; step_i < 40; ++step_i) {
        ASSERT_EQ(ingot::step(*world, static_cast<scalar>(dt)).overlaps_lost, 0);
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
            if (std::find(levels.begin(), levels.end(), overlap.visitor) != levels.end()) ++(is_fast ? met.fast : met.slow);
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
