// SPDX-License-Identifier: MIT
// Scale: a world whose lengths, speeds, gravity and length_unit are 2^k times as large, and its masses 2^m, goes the same way to the bit. Every power
// of two is exact, so whatever differs is a length that stands in the kernel as a number.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/play.h"
#include "reference/powers_of_two.h"
#include "reference/random_input.h"
#include "scenes/compounds.h"

namespace {

using namespace ingot_contact;
using namespace scenes;
using ingot::BodyDef;
using ingot_reference::equal;
using ingot_reference::power_of_two;
using ingot_reference::RandomInput;

/// The stone of scenes/hulls.h, this many times as large.
template <int k>
struct ScaledRock {
    static constexpr auto& rock = rock_hull.hull.value;
    static constexpr unsigned count = sizeof rock_points / sizeof rock_points[0];
    struct Points {
        Vector at[count];
    };
    static constexpr Points points() {
        Points scaled{};
        for (unsigned i = 0; i < count; ++i) scaled.at[i] = rock.view().vertices[i] * power_of_two(k);
        return scaled;
    }
    static constexpr Points at = points();
    static constexpr auto hull = ingot::convex_hull(at.at);
};

constexpr int bodies = 20;

template <class Solver, bool asleep, bool fast, int k>
struct Scaled : ingot::Scene {
    static constexpr int max_bodies = bodies, max_manifolds = 240, max_shapes_of_body = 3;
    static constexpr bool translates = true, sleeps = asleep, continuous = fast, rolling_resistance = true, surface_velocities = true;
    static constexpr scalar length_unit = power_of_two(k), sleep_time = scalar(0.125);
    using solver = Solver;
    using broad_phase = ingot::SortedTree;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {ScaledRock<k>::hull.value.view()};
};

/// A body of the world of scale 1, and what is scaled of it.
struct Thing {
    BodyDef def;
    Parts<3> arms{};
    bool is_compound = false;
    double lever = 0;
    Vector belt{};
};

/// Lengths 2^k, masses 2^m times as large.
Thing scaled(Thing thing, int k, int m) {
    const scalar length = power_of_two(k), mass = power_of_two(m);
    BodyDef& def = thing.def;
    const auto scale_shape = [&](ingot::Shape& shape) {
        if (shape.kind == ingot::ShapeKind::half_space)
            shape.offset = shape.offset * length;
        else if (shape.kind == ingot::ShapeKind::hull)
            shape.size.x = shape.size.x * length;  // y is its number
        else
            shape.size = shape.size * length;
    };
    def.mass.M = def.mass.M * mass;
    def.mass.I_body = def.mass.I_body * (mass * length * length);
    def.mass.r_CM = def.mass.r_CM * length;
    def.state.r_CM = def.state.r_CM * length;
    def.state.v_CM = def.state.v_CM * length;
    def.state.L = def.state.L * (mass * length * length);
    scale_shape(def.shape);
    for (ingot::ShapeDef& arm : thing.arms.parts) {
        arm.r = arm.r * length;
        scale_shape(arm.shape);
    }
    thing.lever = thing.lever * static_cast<double>(length);
    thing.belt = thing.belt * length;
    return thing;
}

/// Any shape, of 10^least to a metre, at rest or not.
Thing random_thing(RandomInput& random, double least, bool fast) {
    const auto size = static_cast<scalar>(std::pow(10, random.real(least, 0))), mu = static_cast<scalar>(random.real(0, 1));
    const scalar e = random.integer(0, 1) == 0 ? 0 : static_cast<scalar>(random.real(0, 0.9));
    const auto part = [&] { return size * static_cast<scalar>(random.real(0.05, 1)); };
    Thing thing;
    PlacedBody body = solid_ball(1, size, ingot_reference::to_vector(random.vector(1.5)), mu, e);
    body.def.state.r_CM.z = static_cast<scalar>(random.real(0, 2));
    switch (random.integer(0, 5)) {
        case 0: break;
        case 1: body = solid_box(1, {size, part(), part()}, body.def.state.r_CM, mu, e); break;
        case 2: {
            const scalar radius = part();
            body.def.shape = ingot::Capsule{radius, size};
            body.def.mass = ingot::principal(ingot::with_mass(ingot::solid_capsule(1, radius, size), 1)).value;
            break;
        }
        case 3: {
            const scalar half_length = part();
            body.def.shape = ingot::Cylinder{size, half_length};
            body.def.mass = ingot::principal(ingot::with_mass(ingot::solid_cylinder(1, size, half_length), 1)).value;
            break;
        }
        case 4:
            body.def.shape = {ingot::ShapeKind::hull, {ScaledRock<0>::hull.value.view().radius, 0, 0}, 0};
            body.def.mass = rock_hull.mass;
            break;
        default:
            thing.is_compound = true;
            thing.arms = jack(mu);
            for (ingot::ShapeDef& arm : thing.arms.parts) arm.shape.size = arm.shape.size * size;
            body.def.mass = thing.arms.mass(1);
            body.def.shape = {};
    }
    const double speed = fast && random.integer(0, 3) == 0 ? random.real(20, 200) : random.real(0, 2);
    body.def.mass.M = body.def.mass.M * static_cast<scalar>(std::pow(10, random.real(-1, 1)));
    body.def.friction = mu;
    body.turn(ingot_reference::to_matrix(random.rotation()));
    body.move(ingot_reference::to_vector(Eigen::Vector3d(random.direction() * speed)), ingot_reference::to_vector(random.vector(5)));
    thing.def = body.def;
    if (thing.is_compound) thing.def.restitution = 0;
    if (random.integer(0, 3) == 0) thing.lever = static_cast<double>(size) * random.real(0, 0.1);
    if (random.integer(0, 3) == 0) thing.belt = ingot_reference::to_vector(random.vector(1));
    return thing;
}

template <class S>
BodyId add(ingot::World<S>& world, const Thing& thing) {
    const ingot::Result<BodyId> id = thing.is_compound ? world.add(thing.def, thing.arms.parts) : world.add(thing.def);
    EXPECT_EQ(id.status, Status::ok) << static_cast<int>(id.status);
    if (!thing.is_compound) {
        EXPECT_EQ(world.set_rolling_resistance(id.value, static_cast<scalar>(thing.lever)), Status::ok);
        EXPECT_EQ(world.set_surface_velocity(id.value, thing.belt), Status::ok);
    }
    return id.value;
}

/// Plays random scenes at both scales.
template <template <int> class SceneAt, int k>
void expect_same_way(uint64_t seed) {
    static ingot::World<SceneAt<0>> plain;
    static ingot::World<SceneAt<k>> other;
    RandomInput random(seed);
    for (int case_i = 0; case_i < 6; ++case_i) {
        plain = {};
        other = {};
        // Where things get smaller, the smallest are not so small, and none gets lighter: they stay above limits::size_min and inertia_min. In float
        // they get heavier by as much: products of small impulses would lie below the smallest number that has all its digits, see equal.
        const int lightest = k >= 0 ? -10 : sizeof(scalar) == sizeof(float) ? -k : 0;
        const int m = random.integer(lightest, lightest + (k < 0 ? 10 : 20)), rates[] = {30, 60, 120, 240, 1000};
        const auto h = 1 / static_cast<scalar>(rates[random.integer(0, 4)]);
        const scalar length = power_of_two(k), L_scale = power_of_two(m) * length * length;
        ASSERT_EQ(plain.set_gravity({0, 0, -standard_gravity}), Status::ok);
        ASSERT_EQ(other.set_gravity({0, 0, -standard_gravity * length}), Status::ok);
        BodyId ids[2][bodies];
        for (int i = 0; i < bodies; ++i) {
            Thing thing = random_thing(random, k < 0 ? -1.5 : -3, SceneAt<0>::continuous);
            if (i < 2) thing = {i == 0 ? flat_ground(scalar(0.5)).def : fixed_box({1, 1, scalar(0.25)}, {0, 0, scalar(0.25)}, scalar(0.5)).def};
            if (i < 2) thing.def.friction = scalar(0.5);
            ids[0][i] = add(plain, thing);
            ids[1][i] = add(other, scaled(thing, k, m));
        }
        for (int step_i = 0; step_i < 90; ++step_i) {
            const StepReport a = ingot::step(plain, h), b = ingot::step(other, h);
            SCOPED_TRACE(::testing::Message() << "case " << case_i << ", step " << step_i);
            ASSERT_EQ(a.contacts, b.contacts);
            ASSERT_EQ(a.sweeps, b.sweeps);
            ASSERT_EQ(a.residual * length, b.residual);
            for (int i = 0; i < bodies; ++i) {
                const BodyState A = plain.state(ids[0][i]).value, B = other.state(ids[1][i]).value;
                ASSERT_TRUE(equal(A.r_CM * length, B.r_CM)) << i;
                ASSERT_TRUE(equal(A.v_CM * length, B.v_CM)) << i;
                ASSERT_TRUE(equal(A.L * L_scale, B.L)) << i;
                ASSERT_TRUE(equal(A.A.c0, B.A.c0) && equal(A.A.c1, B.A.c1) && equal(A.A.c2, B.A.c2)) << i;
                if constexpr (SceneAt<0>::sleeps) {
                    ASSERT_EQ(plain.is_asleep(ids[0][i]), other.is_asleep(ids[1][i])) << i;
                }
            }
        }
    }
}

/// A scale that is left to nightly: each is a scene.
template <template <int> class SceneAt, int k>
void expect_same_way_by_nightly(uint64_t seed) {
    if constexpr (INGOT_TEST_BRIEF)
        (void)seed;
    else
        expect_same_way<SceneAt, k>(seed);
}

template <int k>
using Swept = Scaled<ingot::BlockSweeps, false, false, k>;
template <int k>
using Asleep = Scaled<ingot::BlockSweeps, true, false, k>;
template <int k>
using Direct = Scaled<ingot::HybridIslands<24>, false, true, k>;
template <int k>
using Sequential = Scaled<ingot::SequentialImpulses, true, true, k>;

TEST(Scale, is_no_matter_to_sweeps) {
    expect_same_way<Swept, -10>(1);
    expect_same_way_by_nightly<Swept, 10>(2);
}
TEST(Scale, is_no_matter_to_sleep) {
    expect_same_way_by_nightly<Asleep, -10>(3);
    expect_same_way<Asleep, 7>(4);
}
TEST(Scale, is_no_matter_to_direct_islands_and_fast_bodies) {
    expect_same_way<Direct, -9>(5);
    expect_same_way_by_nightly<Direct, 10>(6);
}
TEST(Scale, is_no_matter_to_sequential_impulses) {
    expect_same_way_by_nightly<Sequential, -10>(7);
    expect_same_way<Sequential, 8>(8);
}

}  // namespace
