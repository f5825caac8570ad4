// SPDX-License-Identifier: MIT
// Full arrays, bodies that come and go while they touch, bodies that leave the range, input at the ends of what is allowed.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "contact/play.h"
#include "reference/draws.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_contact;
using namespace scenes;
using ingot_reference::draws;
using ingot_reference::RandomInput;

constexpr double g = 9.81;

/// The slab of 1000 tiles with so much room; it lands within 0.15 s.
template <class BroadPhase, int manifolds, int pairs>
Play<Room<SlabOnTiles::body_count, BroadPhase, true, manifolds, pairs>> slab() {
    return {bodies_of<SlabOnTiles>(), SlabOnTiles::gravity};
}

/// With too little room the report says so in every step that lost something, the world stays finite, and where the tiles that are kept
/// bear the slab it rests on them. 600 pairs of the lowest slots are tiles on both sides of its middle.
template <class Scene>
void expect_slab_rests_on_fewer(Scene scene) {
    ASSERT_TRUE(scene.sound());
    constexpr int slab_i = SlabOnTiles::body_count - 1;
    int lost_steps = 0;
    scene.run(OnEarth::h, 3, [&](int) {
        ASSERT_TRUE(scene.finite());
        lost_steps += scene.reports().lost > 0;
    });
    figure("contacts, most", scene.reports().most_contacts);
    figure("lost, in all steps", scene.reports().lost);
    figure("height, m", scene.r(slab_i).z());
    EXPECT_GT(scene.reports().lost, 0);
    EXPECT_LE(scene.reports().most_contacts, 600);
    EXPECT_GT(lost_steps, 100);
    EXPECT_NEAR(scene.r(slab_i).z(), 0.25, 1e-3);
    EXPECT_LE(scene.v(slab_i).norm(), 1e-2);
}
TEST(FullPairs, slab_rests_on_those_that_are_kept) { expect_slab_rests_on_fewer(slab<ingot::AllPairs, 600, 600>()); }
TEST(FullManifolds, slab_rests_on_those_that_are_kept) { expect_slab_rests_on_fewer(slab<ingot::AllPairs, 600, 1200>()); }
TEST(FullManifolds, slab_rests_on_those_that_are_kept_by_the_tree) { expect_slab_rests_on_fewer(slab<ingot::SortedTree, 600, 1200>()); }

/// Room for ten of a thousand: it goes down, and says so.
TEST(FullPairs, world_stays_finite_when_hardly_any_is_kept) {
    auto scene = slab<ingot::SortedTree, 10, 12>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, INGOT_TEST_BRIEF ? 1 : 3, [&](int) { ASSERT_TRUE(scene.finite()); });
    EXPECT_GT(scene.reports().lost, 0);
    EXPECT_LE(scene.reports().most_contacts, 10);
    EXPECT_EQ(scene.reports().frozen, 0);
}

PlacedBody cube_at(double x, double y, double z) { return unit_cube(ingot_reference::to_vector(Vector3d(x, y, z)), scalar(0.6)); }

using RoomForTen = Room<12, ingot::AllPairs, true, 10, 40>;
struct NoCrowdsInRoomForTen : RoomForTen {
    static constexpr bool holds_crowds = false;
};

/// After two seconds; the ten do not stir.
template <class S>
double height_of_the_eleventh() {
    std::vector<PlacedBody> bodies = {flat_ground(scalar(0.6))};
    bodies.push_back(cube_at(-3, 0, 2.5));  // in the lowest slot: the order of slots is not what decides
    for (int i = 0; i < 10; ++i) bodies.push_back(cube_at(3.0 * i, 0, 0.5));
    Play<S> scene(bodies, OnEarth::gravity);
    EXPECT_TRUE(scene.sound());
    scene.run(OnEarth::h, 2);
    EXPECT_GT(scene.reports().lost, 0);
    for (int i = 2; i < 12; ++i) EXPECT_LE(scene.moved(i).norm(), 1e-5) << i;
    return scene.r(1).z();
}

/// Contacts that are held stay: ten cubes at rest take all manifolds, an eleventh has none and lies on the ground all the same; they do not stir.
TEST(FullManifolds, held_contacts_stay) { EXPECT_NEAR(height_of_the_eleventh<RoomForTen>(), 0.5, 1e-5); }

/// Where a scene leaves that out, the eleventh falls freely, and the report says so.
TEST(FullManifolds, let_who_comes_late_fall_where_a_scene_holds_no_crowds) {
    EXPECT_NEAR(height_of_the_eleventh<NoCrowdsInRoomForTen>(), 2.5 - g * 2 * 2 / 2, 1e-3);
}

/// What is taken away is gone: cubes above fall freely from the moment on.
TEST(Removal, leaves_nothing_behind) {
    auto scene = play<Tower<3>>();
    scene.run(OnEarth::h, 1);
    ASSERT_EQ(scene.world().remove(scene.id(2)), Status::ok);
    const double z = scene.r(3).z(), v = scene.v(3).z();
    (void)scene.step(OnEarth::h);
    EXPECT_NEAR(scene.v(3).z(), v - g / 60, 1e-5);
    EXPECT_NEAR(scene.r(3).z(), z + v / 60 - g / 7200, 1e-6);
    EXPECT_LE(scene.v(1).norm(), 1e-5);

    ASSERT_EQ(scene.world().remove(scene.id(0)), Status::ok);  // the ground
    const StepReport report = scene.step(OnEarth::h);
    EXPECT_EQ(report.contacts, 0);
    EXPECT_NEAR(scene.v(1).z(), -g / 60, 1e-4);
}

/// Who takes the slot of another inherits nothing: the same bits as after one that never touched.
TEST(Removal, slot_taken_again_does_not_inherit_impulses) {
    PlacedBody heavy = solid_box(1000, {scalar(0.5), scalar(0.5), scalar(0.5)}, {0, 0, scalar(0.5)}, scalar(0.6));
    PlacedBody light = solid_box(1, {scalar(0.5), scalar(0.5), scalar(0.5)}, {0, 0, scalar(0.5)}, scalar(0.6));
    light.def.friction = heavy.def.friction = scalar(0.6);
    std::uint64_t hashes[2][30];
    for (const bool touched : {false, true}) {
        heavy.def.state.r_CM.z = touched ? scalar(0.5) : scalar(1000);
        Play<Room<4>> scene({flat_ground(scalar(0.6)), heavy}, OnEarth::gravity);
        scene.run(OnEarth::h, 1);
        ASSERT_EQ(scene.world().remove(scene.id(1)), Status::ok);
        const ingot::Result<BodyId> added = scene.world().add(light.def);
        ASSERT_TRUE(added.ok());
        ASSERT_EQ(added.value.slot, scene.id(1).slot);
        for (int step_i = 0; step_i < 30; ++step_i) {
            (void)scene.step(OnEarth::h);
            EXPECT_LE(to_eigen(scene.world().state(added.value).value.v_CM).norm(), 1e-5) << step_i;
            hashes[touched][step_i] = scene.world().state_hash();
        }
    }
    for (int step_i = 0; step_i < 30; ++step_i) EXPECT_EQ(hashes[0][step_i], hashes[1][step_i]) << step_i;
}

/// However bodies came and went, no record is lost: afterwards there is room for as many contacts as ever.
TEST(Removal, loses_no_room) {
    RandomInput random(10);
    using Yard = Room<24, ingot::SortedTree, true, 20, 60>;
    Play<Yard> scene({}, OnEarth::gravity);
    auto& world = scene.world();
    std::vector<BodyId> alive;
    PlacedBody ground = flat_ground(scalar(0.6));
    ASSERT_TRUE(world.add(ground.def).ok());
    for (int step_i = 0; step_i < 1500; ++step_i) {
        if (random.integer(0, 2) > 0 && alive.size() < 23) {
            const PlacedBody cube = cube_at(random.real(-2, 2), random.real(-2, 2), random.real(0.4, 3));
            const ingot::Result<BodyId> added = world.add(cube.def);
            ASSERT_TRUE(added.ok());
            alive.push_back(added.value);
        }
        for (int removals = random.integer(0, 2); removals > 0 && !alive.empty(); --removals) {
            const std::size_t which = static_cast<std::size_t>(random.integer(0, static_cast<int>(alive.size()) - 1));
            ASSERT_EQ(world.remove(alive[which]), Status::ok);
            alive.erase(alive.begin() + static_cast<std::ptrdiff_t>(which));
        }
        const StepReport report = ingot::step(world, OnEarth::h);
        ASSERT_LE(report.contacts, 20);
        ASSERT_EQ(report.bodies_frozen, 0);
        for (const BodyId id : alive) ASSERT_TRUE(to_eigen(world.state(id).value.r_CM).allFinite());
    }
    for (const BodyId id : alive) ASSERT_EQ(world.remove(id), Status::ok);
    (void)ingot::step(world, OnEarth::h);
    for (int i = 0; i < 20; ++i) ASSERT_TRUE(world.add(cube_at(3.0 * i, 0, 0.5).def).ok());
    const StepReport report = ingot::step(world, OnEarth::h);
    EXPECT_EQ(report.contacts, 20);
    EXPECT_EQ(report.contacts_lost, 0);
}

/// A body moved by hand, across others and away, leaves no contact behind and finds those that are there.
TEST(Placement, by_hand_is_seen) {
    auto scene = play<Tower<3>>();
    scene.run(OnEarth::h, 0.5);
    BodyState state = scene.state(3);
    state.r_CM = {10, 0, scalar(0.5)};
    ASSERT_EQ(scene.world().set_state(scene.id(3), state), Status::ok);
    scene.run(OnEarth::h, 0.5);
    EXPECT_NEAR(scene.r(3).z(), 0.5, 1e-4);
    EXPECT_NEAR(scene.r(3).x(), 10, 1e-4);
    EXPECT_NEAR(scene.r(2).z(), 1.5, 1e-4);
}

/// A copy of the bytes goes on with the same bits.
TEST(Snapshot, of_a_pile_goes_on_the_same) {
    auto scene = play<SpherePile<3>>();
    scene.run(SpherePile<3>::h, 1);
    const auto copy = std::make_unique<std::remove_reference_t<decltype(scene.world())>>(scene.world());
    for (int step_i = 0; step_i < 60; ++step_i) {
        (void)scene.step(SpherePile<3>::h);
        (void)ingot::step(*copy, SpherePile<3>::h);
        ASSERT_EQ(scene.world().state_hash(), copy->state_hash()) << step_i;
    }
}

/// A cube is driven out of the range by a force it may be given. It is reported and frozen; a tower far away stands; nothing is
/// ever not finite; and the cubes below and above it are not torn along: they stay where they are.
TEST(Frozen, body_among_contacts_harms_no_other) {
    std::vector<PlacedBody> bodies = {flat_ground(scalar(0.6))};
    for (int i = 0; i < 3; ++i) bodies.push_back(cube_at(0, 0, 0.5 + i));
    for (int i = 0; i < 5; ++i) bodies.push_back(cube_at(20, 0, 0.5 + i));
    Play<Room<10>> scene(bodies, OnEarth::gravity);
    scene.run(OnEarth::h, 1);
    ASSERT_EQ(scene.world().add_central_force(scene.id(2), {ingot::limits::force_max, 0, 0}), Status::ok);
    scene.run(OnEarth::h, 2, [&](int) { ASSERT_TRUE(scene.finite()); });
    EXPECT_EQ(scene.reports().frozen, 1);
    EXPECT_TRUE(scene.world().is_frozen(scene.id(2)));
    for (const int i : {1, 3, 4, 5, 6, 7, 8}) {
        EXPECT_FALSE(scene.world().is_frozen(scene.id(i))) << i;
        EXPECT_LE(scene.moved(i).norm(), 1e-3) << i;
    }
}

/// add() refuses a friction that is none.
TEST(Friction, is_checked_at_the_door) {
    Play<Room<4>> scene({flat_ground(scalar(0.6))}, OnEarth::gravity);
    ingot::BodyDef def = cube_at(0, 0, 0.5).def;
    for (const scalar mu : {scalar(-1), std::numeric_limits<scalar>::quiet_NaN(), std::numeric_limits<scalar>::infinity()}) {
        def.friction = mu;
        const ingot::Result<BodyId> added = scene.world().add(def);
        EXPECT_NE(added.status, Status::ok) << static_cast<double>(mu);
        EXPECT_EQ(scene.world().body_count(), added.ok() ? 2 : 1);
        if (added.ok()) {
            EXPECT_EQ(scene.world().remove(added.value), Status::ok);
        }
    }
}

/// Bodies at the ends of what add() takes, on top of each other, at any step: states stay finite, and what leaves the range is reported.
TEST(Degenerate, input_gives_no_nan) {
    RandomInput random(11);
    int frozen = 0, contacts = 0;
    for (int case_i = 0; case_i < draws(300); ++case_i) {
        std::vector<PlacedBody> bodies = {flat_ground(static_cast<scalar>(random.real(0, 2)), static_cast<scalar>(random.integer(0, 1)))};
        const double size_decades = random.real(0, 5), mass_decades = random.real(0, 9);
        const bool one_place = random.integer(0, 3) == 0, fast = random.integer(0, 3) == 0;
        for (int i = 0; i < 8; ++i) {
            const scalar size = static_cast<scalar>(std::pow(10, random.real(-size_decades, size_decades / 3)));
            const scalar M = static_cast<scalar>(std::pow(10, random.real(-mass_decades / 2, mass_decades)));
            const scalar flat_by = random.integer(0, 3) == 0 ? static_cast<scalar>(std::pow(10, random.real(-2.5, 0))) : scalar(1);
            const Vector r = one_place ? Vector{0, 0, scalar(0.5)} : ingot_reference::to_vector(Vector3d(random.vector(1) + Vector3d(0, 0, 1)));
            const scalar mu = static_cast<scalar>(random.real(0, 2)), e = static_cast<scalar>(random.real(0, 1));
            PlacedBody body = random.integer(0, 2) == 0 ? solid_ball(M, size, r, mu, e) : solid_box(M, {size, size, size * flat_by}, r, mu, e);
            if (random.integer(0, 1) == 0) body.turn(scattered_rotation(case_i * 8 + i));
            if (fast) body.move(ingot_reference::to_vector(Vector3d(random.vector(1e5))), ingot_reference::to_vector(Vector3d(random.vector(1e4))));
            if (check_mass_properties(body.def.mass) != Status::ok || check_shape(body.def.shape) != Status::ok) continue;
            const Vector I = body.def.mass.I_body;
            if (check_state(body.def.state, {1 / I.x, 1 / I.y, 1 / I.z}) != Status::ok) continue;
            bodies.push_back(body);
        }
        Play<Room<9>> scene(bodies, OnEarth::gravity);
        ASSERT_TRUE(scene.sound()) << case_i;
        const scalar h = static_cast<scalar>(std::pow(10, random.real(-4, -0.5)));
        for (int step_i = 0; step_i < 30; ++step_i) {
            (void)scene.step(h);
            ASSERT_TRUE(scene.finite()) << "case " << case_i << " step " << step_i;
            for (int i = 1; i < scene.body_count(); ++i)
                ASSERT_LE(ingot::orthogonality_error(scene.state(i).A), ingot::limits::orthogonality) << "case " << case_i << " step " << step_i;
        }
        frozen += scene.reports().frozen;
        contacts += scene.reports().most_contacts;
        EXPECT_EQ(scene.reports().not_ok, 0);
    }
    figure("bodies frozen", frozen);
    figure("contacts", contacts);
    EXPECT_GT(contacts, draws(1000));
}

/// C19: a tower stands 10 km from the origin, where places in float are 1 mm apart: it stands, and no more is asked.
/// Ground that is tilted by so little that its normal, which rounds to no unit vector, has a 1 in it: far uphill it is 0.2 m higher or more, and
/// holds there.
template <class BroadPhase>
void expect_tilted_ground_holds(scalar tilt, scalar away) {
    const scalar up = scalar(0.5) + away * tilt;
    PlacedBody ground = flat_ground(scalar(0.6));
    ground.def.shape = ingot::HalfSpace{{tilt, 0, 1}, 0};
    Play<Room<2, BroadPhase>> play({ground, unit_cube({-away, 0, up}, scalar(0.6))}, OnEarth::gravity);
    ASSERT_TRUE(play.sound());
    play.run(OnEarth::h, 1);
    EXPECT_TRUE(play.reports().clean());
    EXPECT_NEAR(play.r(1).z(), static_cast<double>(up), 1e-3);
}
template <class BroadPhase>
void expect_tilted_grounds_hold() {
    expect_tilted_ground_holds<BroadPhase>(is_double ? scalar(1.75e-8) : scalar(3e-4), is_double ? scalar(2e7) : scalar(1000));
    // And by so much less that it does round to one.
    const scalar tilt = is_double ? scalar(1) / (1 << 27) : scalar(1) / 8192;
    ASSERT_EQ(1 + tilt * tilt, 1);
    expect_tilted_ground_holds<BroadPhase>(tilt, is_double ? scalar(1 << 25) : scalar(2048));
}
TEST(TiltedGround, holds_far_away) { expect_tilted_grounds_hold<ingot::AllPairs>(); }
TEST(TiltedGround, holds_far_away_by_the_tree) { expect_tilted_grounds_hold<ingot::SortedTree>(); }

TEST(FarAway, tower_stands_10_km_from_the_origin) {
    std::vector<PlacedBody> bodies = bodies_of<Tower<5>>();
    for (PlacedBody& body : bodies)
        if (!body.def.immovable) body.def.state.r_CM += Vector{10000, 10000, 0};
    Play<Room<6>> scene(bodies, OnEarth::gravity);
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 20);
    figure("shift, mm", 1e3 * scene.shift());
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(scene.shift(), is_double ? 1e-4 : 0.1);
    EXPECT_LE(scene.sink(), 1e-2);
}

/// C22: run twice, the same bits; in another order of bodies the same to 1e-9 (double) of what it is, while motion is regular.
TEST(Order, of_bodies_does_not_matter_much) {
    std::vector<PlacedBody> bodies = bodies_of<Tower<10>>();
    Play<Room<11>> scene(bodies, OnEarth::gravity), again(bodies, OnEarth::gravity);
    std::reverse(bodies.begin() + 1, bodies.end());
    Play<Room<11>> reversed(bodies, OnEarth::gravity);
    for (int step_i = 0; step_i < 300; ++step_i) {
        (void)scene.step(OnEarth::h);
        (void)again.step(OnEarth::h);
        (void)reversed.step(OnEarth::h);
        ASSERT_EQ(scene.world().state_hash(), again.world().state_hash());
    }
    double apart = 0;
    for (int i = 1; i <= 10; ++i) apart = std::max(apart, (scene.r(i) - reversed.r(11 - i)).norm());
    figure("apart, m", apart);
    EXPECT_LE(apart, is_double ? 1e-9 : 1e-4);
}

/// Where two fast bodies meet within the step, the points they meet in are solved in the arrays of the step, which its own contacts fill.
struct FastOnes : ingot::Scene {
    static constexpr int max_bodies = 7, max_manifolds = 4, max_pairs = 21;
    static constexpr bool translates = true, continuous = true;
    using solver = ingot::SequentialImpulses;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
ingot::BodyDef box_at(const ingot::Vector& half, const ingot::Vector& r) {
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::solid_box(100, half)).value;
    def.shape = ingot::Box{half};
    def.state.r_CM = r;
    return def;
}
struct FastPair {
    ingot::World<FastOnes> world;
    ingot::BodyId ids[2];

    FastPair(uint64_t seed, int standing) {
        RandomInput random(seed);
        const auto drawn = [&](double from, double to) { return static_cast<ingot::scalar>(random.real(from, to)); };
        bool sound = world.set_gravity({0, 0, static_cast<ingot::scalar>(-g)}) == ingot::Status::ok;
        ingot::BodyDef ground;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        sound = sound && world.add(ground).ok();
        for (int i = 0; i < 2; ++i) {
            const ingot::scalar side = i == 0 ? -1 : 1;
            ingot::BodyDef fast = box_at({drawn(0.1, 0.3), drawn(0.1, 0.3), drawn(0.1, 0.3)}, {});
            fast.state.A = ingot_reference::to_matrix(random.rotation());
            fast.state.r_CM = {side * ingot::scalar(1.2), drawn(-0.1, 0.1), drawn(0.7, 1.2)};
            fast.state.v_CM = {side * -60, 0, drawn(-60, -20)};
            ids[i] = world.add(fast).value;
        }
        const ingot::scalar half = ingot::scalar(0.5);
        for (int i = 0; i < standing; ++i)
            sound = world.add(box_at({half, half, half}, {static_cast<ingot::scalar>(20 + 3 * i), 20, half})).ok() && sound;
        EXPECT_TRUE(sound);
    }
};
TEST(FullManifolds, fast_bodies_meet_beside_them_as_they_do_alone) {
    for (uint64_t seed = 1; seed <= (INGOT_TEST_BRIEF ? 300 : 3000); ++seed) {
        FastPair alone(seed, 0), beside(seed, FastOnes::max_manifolds);
        (void)ingot::step(alone.world, ingot::scalar(1) / 60);
        const ingot::StepReport report = ingot::step(beside.world, ingot::scalar(1) / 60);
        ASSERT_EQ(static_cast<int>(report.contacts), int(FastOnes::max_manifolds));
        for (int i = 0; i < 2; ++i) {
            const ingot::BodyState a = alone.world.state(alone.ids[i]).value, b = beside.world.state(beside.ids[i]).value;
            ASSERT_TRUE(std::memcmp(&a, &b, sizeof a) == 0) << "seed " << seed;
        }
    }
}

}  // namespace
