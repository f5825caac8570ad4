// SPDX-License-Identifier: MIT
// Wherever a number of a snapshot is another, and the checksum is that of what is there: it is refused, and the world that it was for stays as it is
// to the bit; or it is a world, which can be saved and loaded again, steps, and has no number in it that is none. In scenes of all but joints.
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "scenes/hulls.h"
#include "scenes/random.h"
#include "snapshot/life.h"

namespace {

using namespace life;
using Bytes = std::vector<uint8_t>;

struct AllSorts : ingot::Scene {
    static constexpr int max_bodies = 6, max_manifolds = 20, max_overlaps = 3, max_events = 7, max_shapes_of_body = 2;
    static constexpr bool translates = true, filters = true, gravity_shares = true, body_forces = true, damping = true, kinematic_bodies = true;
    static constexpr bool user_data = true, rolling_resistance = true, surface_velocities = true, reads_contacts = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {scenes::cube_hull.hull.value.view()};
};
struct Sleeping : AllSorts {
    static constexpr bool sleeps = true, continuous = true, axis_locks = true;
};
struct Chosen : AllSorts {
    using solver = ingot::HybridIslands<6>;
    static constexpr bool compensated_sums = true;
};
struct ByPoints : AllSorts {
    using solver = ingot::SequentialImpulses;
    static constexpr bool continuous = true;
};

/// A floor that is a belt, a platform that goes to a pose, and what lies, rolls and turns on them.
template <class S>
void fill(World<S>& world, int steps) {
    clear(world);
    ASSERT_EQ(world.set_gravity({0, 0, -10}), Status::ok);
    const BodyId floor = world.add(ground()).value;
    ASSERT_EQ(world.set_surface_velocity(floor, {scalar(0.125), 0, 0}), Status::ok);
    BodyDef platform;
    platform.kinematic = true;
    platform.state.r_CM = {4, 0, scalar(0.5)};
    platform.shape = ingot::Box{{1, 1, scalar(0.25)}};
    const BodyId moved = world.add(platform).value;
    const BodyDef on_it = plain_body({4, 0, scalar(1.25)}, ingot::hull_of<S>(0));
    BodyDef fallen = plain_body({0, 0, scalar(0.5)}, ingot::Capsule{scalar(0.5), scalar(0.5)});
    fallen.state.v_CM = {1, 0, 0};
    ASSERT_TRUE(world.add(on_it).ok());
    const BodyId rolling = world.add(fallen).value;
    ASSERT_EQ(world.set_rolling_resistance(rolling, scalar(0.01)), Status::ok);
    ASSERT_EQ(world.set_damping(rolling, {scalar(0.5), scalar(0.25)}), Status::ok);
    ASSERT_EQ(world.set_gravity_share(rolling, scalar(0.75)), Status::ok);
    ASSERT_EQ(world.set_user_data(rolling, 77), Status::ok);
    if constexpr (S::axis_locks) {
        ASSERT_EQ(world.set_locks(rolling, ingot::AxisLocks::rotate_x | ingot::AxisLocks::translate_y), Status::ok);
    }
    ingot::ShapeDef parts[2];
    parts[0].shape = ingot::Sphere{scalar(0.5)};
    parts[1].shape = ingot::Box{{scalar(0.25), scalar(0.25), scalar(0.5)}};
    parts[1].r = {scalar(0.5), 0, 0};
    BodyDef of_two = plain_body({-3, 0, scalar(0.75)});
    of_two.shape = {};
    ASSERT_TRUE(world.add(of_two, parts).ok());
    BodyDef sensor = plain_body({0, 0, 1}, ingot::Box{{2, 2, 2}});
    sensor.immovable = sensor.sensor = true;
    ASSERT_TRUE(world.add(sensor).ok());
    ASSERT_EQ(world.move_to(moved, {4, scalar(0.25), scalar(0.5)}, ingot::axis_angle({0, 0, 1}, scalar(0.25))), Status::ok);
    for (int step_i = 0; step_i < steps; ++step_i) (void)ingot::step(world, h);
    ASSERT_EQ(world.add_body_force(rolling, {1, 2, 3}, {0, 0, scalar(0.25)}), Status::ok);
    ASSERT_EQ(world.move_to(moved, {4, scalar(0.5), scalar(0.5)}, ingot::axis_angle({0, 0, 1}, scalar(0.5))), Status::ok);
}

template <class S>
bool is_whole(const World<S>& world) {
    bool whole = ingot::is_finite(world.kinetic_energy());
    for (int slot = 0; slot < S::max_bodies; ++slot) {
        const BodyState state = world.state(world.body_at(slot)).value;
        whole = whole && ingot::is_finite(state.r_CM) && ingot::is_finite(state.v_CM) && ingot::is_finite(state.A) && ingot::is_finite(state.L);
    }
    return whole;
}

template <class S>
struct AnyNumber : testing::Test {};
using AllScenes = testing::Types<AllSorts, Sleeping, Chosen, ByPoints>;
TYPED_TEST_SUITE(AnyNumber, AllScenes);

TYPED_TEST(AnyNumber, is_refused_or_makes_a_world) {
    constexpr size_t first = 32, checksum = ingot::snapshot_checksum_size;  // what comes before is told by its own tests
    const scalar reals[] = {std::numeric_limits<scalar>::quiet_NaN(), std::numeric_limits<scalar>::infinity(), scalar(-1), 0, 2, scalar(1e25)};
    const uint64_t wholes[] = {~uint64_t{0}, 0, 1, 2, 6, 255};
    const auto world = std::make_unique<World<TypeParam>>(), other = std::make_unique<World<TypeParam>>();
    scenes::Random random(12);
    int refused = 0, accepted = 0;
    for (const int steps : {0, 1, 40}) {
        fill(*world, steps);
        clear(*other);
        const Bytes sound = saved(*world);
        ASSERT_EQ(ingot::load_snapshot(*other, sound.data(), sound.size()), Status::ok);
        ASSERT_EQ(saved(*other), sound) << "as it is";
        copy(*other, *world);
        const auto further = [&random] { return INGOT_TEST_BRIEF ? static_cast<size_t>(100 + 99 * random.symmetric()) : size_t{1}; };
        for (size_t at = first; at + sizeof(scalar) <= sound.size() - checksum; at += further())
            for (int value_i = 0; value_i < 12; ++value_i) {
                Bytes bytes = sound;
                if (value_i < 6) {
                    ingot::ScalarBits bits;
                    memcpy(&bits, &reals[value_i], sizeof bits);
                    for (size_t i = 0; i < sizeof bits; ++i) bytes[at + i] = static_cast<uint8_t>(bits >> (8 * i));
                } else {
                    const size_t size = size_t{1} << at % 3;
                    for (size_t i = 0; i < size; ++i) bytes[at + i] = static_cast<uint8_t>(wholes[value_i - 6] >> (8 * i));
                }
                const uint64_t sum = ingot::snapshot_checksum(bytes.data(), bytes.size() - checksum);
                for (size_t i = 0; i < checksum; ++i) bytes[bytes.size() - checksum + i] = static_cast<uint8_t>(sum >> (8 * i));
                const Status status = ingot::load_snapshot(*other, bytes.data(), bytes.size());
                if (status != Status::ok) {
                    ++refused;
                    ASSERT_EQ(status, Status::bad_snapshot);
                    ASSERT_TRUE(same_bytes(*other, *world)) << at << ", value " << value_i;
                    continue;
                }
                ++accepted;
                // What is nobody's, as impulses of a pair that has parted, is not saved again: the second time it is not there.
                const Bytes again = saved(*other);
                ASSERT_EQ(ingot::load_snapshot(*other, again.data(), again.size()), Status::ok) << at << ", value " << value_i;
                ASSERT_EQ(saved(*other), again) << at << ", value " << value_i;
                for (int step_i = 0; step_i < 2; ++step_i) (void)ingot::step(*other, h);
                ASSERT_TRUE(is_whole(*other)) << at << ", value " << value_i;
                copy(*other, *world);
            }
    }
    EXPECT_GT(refused, 100);
    EXPECT_GT(accepted, 100);
}

}  // namespace
