// SPDX-License-Identifier: MIT
// Attitudes of fast bodies in a crowd stay rotations, however often they are taken back, wait or meet something within a step.
#include <gtest/gtest.h>

#include <vector>

#include "contact/play.h"
#include "reference/brief_types.h"
#include "reference/draws.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_contact;
using namespace scenes;
using ingot_reference::BriefTypes;
using ingot_reference::RandomInput;
using ingot_reference::to_vector;

template <class Solver, class Rotation = ingot::Scene::rotation, bool asleep = false>
struct Crowd : Room<room_size(18)> {
    static constexpr bool continuous = true, sleeps = asleep;
    using solver = Solver;
    using rotation = Rotation;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
};
using Crowds = BriefTypes<3, Crowd<ingot::BlockSweeps>, Crowd<ingot::SequentialImpulses, ingot::Scene::rotation, true>,
                          Crowd<ingot::BlockSweeps, ingot::SymmetricTop>, Crowd<ingot::HybridIslands<8, 10>>,
                          Crowd<ingot::SequentialImpulses, ingot::LieMidpoint>>;

template <class S>
class EveryCrowd : public ::testing::Test {};
TYPED_TEST_SUITE(EveryCrowd, Crowds);

ingot::BodyDef crowd_body(RandomInput& random, double half_room) {
    const auto half = [&random] { return static_cast<scalar>(random.real(0.01, 0.1)); };
    const scalar x = half(), y = half(), z = half();
    ingot::BodyDef def;
    ingot::MassDistribution mass = ingot::solid_box(1000, {x, y, z});
    def.shape = ingot::Box{{x, y, z}};
    const int kind = random.integer(0, 2);
    if (kind == 1) {
        def.shape = ingot::Capsule{x, y};
        mass = ingot::solid_capsule(1000, x, y);
    }
    if (kind == 2) {
        def.shape = ingot::Cylinder{x, y};
        mass = ingot::solid_cylinder(1000, x, y);
    }
    def.mass = ingot::principal(mass).value;
    def.friction = static_cast<scalar>(random.real(0, 1));
    def.restitution = random.integer(0, 1) == 0 ? scalar(0) : static_cast<scalar>(random.real(0, 1));
    def.state.r_CM = to_vector(random.vector(0.4 * half_room));
    def.state.A = ingot_reference::to_matrix(random.rotation());
    return def;
}

/// Twelve bodies in a closed room, kicked so often that they wait for each other in most steps.
///
/// Whenever one is put anywhere it is made a rotation to 4 epsilon. Until the next polar step of its flights, limits::polar_interval steps later at
/// most, each step rounds the entries of A, by half an epsilon: an entry of A^T A, two sums of three products of a rounding and an entry, is off by
/// 2 sqrt(3) / 2 epsilon more. waits: those of this draw are added.
template <class S>
void keeps_rotations(int draw, int& waits) {
    RandomInput random(static_cast<uint64_t>(3300 + draw));
    const double half_room = random.real(0.35, 0.7);
    constexpr int rates[] = {30, 60, 120, 240, 1000};
    const int rate = rates[random.integer(0, 4)], every = random.integer(1, 5);
    static ingot::World<S> world, loaded;
    world = {};
    (void)world.set_gravity({0, 0, -standard_gravity});
    for (int side = 0; side < 6; ++side) {
        ingot::BodyDef wall;
        wall.immovable = true;
        scalar n[3] = {};
        n[side / 2] = side % 2 == 0 ? scalar(1) : scalar(-1);
        wall.shape = ingot::HalfSpace{{n[0], n[1], n[2]}, static_cast<scalar>(-half_room)};
        ASSERT_TRUE(world.add(wall).ok());
    }
    std::vector<ingot::BodyId> bodies;
    for (int i = 0; i < 12; ++i) bodies.push_back(world.add(crowd_body(random, half_room)).value);
    const scalar bound = ingot::epsilon * (4 + 2 * ingot::limits::polar_interval);
    for (int step_i = 0; step_i < 300; ++step_i) {
        for (const ingot::BodyId id : bodies) {
            if (step_i % every != 0) continue;
            const scalar M = world.mass(id).value;
            (void)world.apply_central_impulse(id, to_vector(random.vector(20)) * M);
            (void)world.apply_angular_impulse(id, to_vector(random.vector(0.3)) * M);
        }
        waits += ingot::step(world, static_cast<scalar>(1.0 / rate)).impacts_deferred;
        for (const ingot::BodyId id : bodies)
            ASSERT_LE(ingot::orthogonality_error(world.state(id).value.A), bound) << "draw " << draw << ", step " << step_i << ", " << rate << " Hz";
    }
    std::vector<uint8_t> bytes(ingot::snapshot_size<S>());
    const auto saved = ingot::save_snapshot(world, bytes.data(), bytes.size());
    ASSERT_TRUE(saved.ok());
    EXPECT_EQ(ingot::load_snapshot(loaded, bytes.data(), saved.value), ingot::Status::ok) << "draw " << draw;
}

TYPED_TEST(EveryCrowd, keeps_its_attitudes_rotations) {
    int waits = 0;
    for (int draw = 0; draw < ingot_reference::draws(24); ++draw) keeps_rotations<TypeParam>(draw, waits);
    EXPECT_GT(waits, 0);
}

}  // namespace
