// SPDX-License-Identifier: MIT
// Bodies of several shapes: mass, rest, rolling, tipping; arrays, removal, snapshots; events, filters, sensors and queries by shape.
#include <gtest/gtest.h>

#include <cstring>

#include "contact/play.h"
#include "reference/ball_and_brick.h"
#include "scenes/compounds.h"

namespace {

using namespace ingot_contact;
using namespace scenes;
using ingot::BodyDef;
using ingot::EventKind;
using ingot::Matrix;
using ingot::Result;
using ingot::Shape;
using ingot::ShapeDef;
using ingot::World;

constexpr double rest_speed = 1e-3;  // m/s: free fall through one step gives 0.16
constexpr Matrix no_turn = ingot::identity_matrix<scalar>();

template <int bodies, int manifolds = 16 * bodies, int shapes_of_body = 5>
struct Told : Compounded<bodies, manifolds, shapes_of_body> {
    static constexpr bool filters = true;
    static constexpr int max_overlaps = 16, max_events = 64;
};
template <int bodies>
using Some = Compounded<bodies, 24 * bodies>;

/// A new world with gravity, on the heap of the test.
template <class S>
std::unique_ptr<World<S>> earth() {
    std::unique_ptr<World<S>> world(new World<S>{});
    EXPECT_EQ(world->set_gravity(OnEarth::gravity), Status::ok);
    return world;
}
template <class S>
BodyId add_placed(World<S>& world, const PlacedBody& body) {
    BodyDef def = body.def;
    def.friction = body.mu;
    const Result<BodyId> id = world.add(def);
    EXPECT_EQ(id.status, Status::ok);
    return id.value;
}
/// Steps of 1/60 s, clean but for islands that are being hit.
template <class S>
void run(World<S>& world, double seconds) {
    for (int step_i = 0; step_i < static_cast<int>(seconds * 60); ++step_i)
        ASSERT_TRUE(scenes::well_but_for_impacts(ingot::step(world, OnEarth::h))) << step_i;
}
template <class S>
double speed(const World<S>& world, BodyId id) {
    return to_eigen(world.state(id).value.v_CM).norm() + to_eigen(world.omega(id).value).norm();
}
template <class S>
Vector3d place(const World<S>& world, BodyId id) {
    return to_eigen(world.state(id).value.r_CM);
}

// Mass.

/// An L: 1 x 1 x 0.5 m on the ground from the origin on, and 0.5 x 1 x 1 m on its one end; in double by the parallel axis law.
constexpr scalar L_mu = 2;
constexpr Parts<2> L_shape = {{part(ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.25)}}, {scalar(0.5), scalar(0.5), scalar(0.25)}, L_mu),
                               part(ingot::Box{{scalar(0.25), scalar(0.5), scalar(0.5)}}, {scalar(0.25), scalar(0.5), 1}, L_mu)}};

TEST(SolidOfShapes, is_that_of_the_parts) {
    const ingot::MassDistribution L = ingot::solid_of_shapes(2, L_shape.parts);
    // Two boxes of 1 kg each with their centres at (0.5, 0.5, 0.25) and (0.25, 0.5, 1): each is 0.125 m and 0.375 m from the common one.
    const double x = 0.125, z = 0.375;
    const double I_xx = (1 + 0.25) / 12 + (1 + 1.0) / 12 + 2 * z * z;
    const double I_yy = (1 + 0.25) / 12 + (0.25 + 1) / 12 + 2 * (x * x + z * z);
    const double I_zz = (1 + 1.0) / 12 + (0.25 + 1) / 12 + 2 * x * x;
    const double tolerance = 16 * static_cast<double>(ingot::epsilon);
    EXPECT_NEAR(L.M, 2, tolerance);
    EXPECT_LE((to_eigen(L.r_CM) - Vector3d(0.375, 0.5, 0.625)).norm(), tolerance);
    EXPECT_NEAR(L.I.xx, I_xx, tolerance);
    EXPECT_NEAR(L.I.yy, I_yy, tolerance);
    EXPECT_NEAR(L.I.zz, I_zz, tolerance);
    EXPECT_NEAR(L.I.xy, 0, tolerance);
    EXPECT_NEAR(L.I.yz, 0, tolerance);
    EXPECT_NEAR(L.I.xz, 2 * x * z, tolerance);  // - m r_x r_z with r = (0.125, -0.375) and (-0.125, 0.375)

    ShapeDef with_sensor[3] = {L_shape.parts[0], L_shape.parts[1], part(ingot::Sphere{5}, {9, 9, 9}, 1)};
    with_sensor[2].sensor = true;
    EXPECT_EQ(ingot::solid_of_shapes(2, with_sensor).M, L.M);
    const ShapeDef ground[1] = {part(ingot::HalfSpace{{0, 0, 1}, 0}, {}, 1)};
    EXPECT_EQ(ingot::principal(ingot::solid_of_shapes(1, ground)).status, Status::not_finite);
}

/// On a slope it stands until its centre of mass is beyond the lower edge: tan alpha = 0.375 / 0.625 with the heavy side down the slope, from
/// x = 0 down. 1 % to either side of it.
TEST(LOfTwoBoxes, tips_where_its_centre_of_mass_passes_the_edge) {
    for (const double factor : {0.99, 1.01}) {
        const double slope = std::atan(0.375 / 0.625 * factor), c = std::cos(slope), s = std::sin(slope);
        auto world = earth<Some<2>>();
        add_placed(*world, half_space({scalar(-s), 0, scalar(c)}, 0, L_mu));  // falls towards -x
        const Matrix A = {{scalar(c), 0, scalar(s)}, {0, 1, 0}, {scalar(-s), 0, scalar(c)}};
        const BodyId id = add_parts(*world, L_shape, 2, {}, A).value;
        run(*world, 4);
        const Vector3d up = to_eigen(ingot::user_pose(L_shape.mass(2), world->state(id).value).A).col(2);
        const double tilt = std::acos(std::min(1.0, up.dot(Vector3d(-s, 0, c))));
        figure("tilt, rad", tilt);
        if (factor < 1) {
            EXPECT_LE(tilt, 1e-3);
        } else {
            EXPECT_GE(tilt, 1);  // it lies on its side
        }
    }
}

// Motion.

/// Two balls on an axle roll as one: 5/7 g sin alpha, as C1 asks of a ball, and the axle stays level.
TEST(Dumbbell, rolls_down_an_incline_as_a_ball) {
    auto world = earth<Some<2>>();
    constexpr scalar radius = scalar(0.25);
    add_placed(*world, half_space(thirty_degrees.up(), 0, 1));
    const BodyId id = add_parts(*world, dumbbell(radius, 1, 1), 2, thirty_degrees.up() * radius, thirty_degrees.A()).value;
    const Vector3d from = place(*world, id), down = to_eigen(thirty_degrees.down());
    run(*world, 2);
    const double way = down.dot(place(*world, id) - from), exact = 0.5 * 5.0 / 7 * 9.81 * 0.5 * 4;
    figure("error of the way, %", 100 * (way / exact - 1));
    EXPECT_NEAR(way / exact, 1, 0.005);
    EXPECT_NEAR(to_eigen(world->omega(id).value).y() * static_cast<double>(radius), down.dot(to_eigen(world->state(id).value.v_CM)), 1e-3);
    EXPECT_LE(std::abs(place(*world, id).y()), 1e-3);
}

TEST(Dumbbell, of_two_boxes_comes_to_rest_on_both) {
    auto world = earth<Some<2>>();
    constexpr Shape weight = ingot::Box{{scalar(0.25), scalar(0.25), scalar(0.25)}};
    constexpr scalar mu = scalar(0.5);
    const Parts<3> parts = {{part(weight, {scalar(-0.75), 0, 0}, mu), part(weight, {scalar(0.75), 0, 0}, mu),
                             part(ingot::Capsule{scalar(0.0625), scalar(0.75)}, {}, mu, along_x)}};
    add_placed(*world, flat_ground(mu));
    const BodyId id = add_parts(*world, parts, 2, {0, 0, 2}, scattered_rotation(5)).value;
    run(*world, 10);
    EXPECT_LE(speed(*world, id), rest_speed);
    EXPECT_NEAR(place(*world, id).z(), 0.25, 1e-3);
}

/// Two halves behave as the whole: the tower of cubes, and the way down the incline.
constexpr Parts<2> cube_of_halves(scalar mu) {
    constexpr Shape half = ingot::Box{{scalar(0.25), scalar(0.5), scalar(0.5)}};
    return {{part(half, {scalar(-0.25), 0, 0}, mu), part(half, {scalar(0.25), 0, 0}, mu)}};
}
TEST(CubeOfHalves, tower_of_10_stands) {
    auto world = earth<Some<11>>();
    add_placed(*world, flat_ground(scalar(0.6)));
    std::vector<BodyId> ids;
    for (int i = 0; i < 10; ++i) ids.push_back(add_parts(*world, cube_of_halves(scalar(0.6)), 1, {0, 0, scalar(i) + scalar(0.5)}).value);
    run(*world, 30);
    for (int i = 0; i < 10; ++i) {
        EXPECT_LE((place(*world, ids[static_cast<std::size_t>(i)]) - Vector3d(0, 0, i + 0.5)).norm(), 1e-3) << i;
        EXPECT_LE(speed(*world, ids[static_cast<std::size_t>(i)]), rest_speed) << i;
    }
}
TEST(CubeOfHalves, slides_the_exact_way) {
    auto world = earth<Some<2>>();
    add_placed(*world, half_space(thirty_degrees.up(), 0, scalar(0.4)));
    const BodyId id = add_parts(*world, cube_of_halves(scalar(0.4)), 1, thirty_degrees.up() * scalar(0.5), thirty_degrees.A()).value;
    const Vector3d from = place(*world, id);
    run(*world, 2);
    const double way = to_eigen(thirty_degrees.down()).dot(place(*world, id) - from);
    const double exact = static_cast<double>(ingot_reference::BrickOnIncline(9.81L, 0.4L, 0.5L, std::sqrt(0.75L), 0).at(2).s);
    figure("error of the way, %", 100 * (way / exact - 1));
    EXPECT_LE(std::abs(way / exact - 1), 1e-5);
}

TEST(TableOfFiveBoxes, carries_a_tower) {
    auto world = earth<Some<7>>();
    constexpr scalar mu = scalar(0.6);
    add_placed(*world, flat_ground(mu));
    const BodyId table_id = add_parts(*world, table(mu), 2, {}).value;
    std::vector<BodyId> cubes;
    constexpr scalar half = scalar(0.25);
    for (int i = 0; i < 5; ++i)
        cubes.push_back(add_placed(*world, solid_box(1, {half, half, half}, {0, 0, scalar(0.875) + half + scalar(i) * 2 * half}, mu)));
    const Vector3d from = place(*world, table_id);
    run(*world, 30);
    EXPECT_LE((place(*world, table_id) - from).norm(), 1e-3);
    EXPECT_LE(speed(*world, table_id), rest_speed);
    for (int i = 0; i < 5; ++i) {
        EXPECT_LE((place(*world, cubes[static_cast<std::size_t>(i)]) - Vector3d(0, 0, 1.125 + 0.5 * i)).norm(), 1e-3) << i;
        EXPECT_LE(speed(*world, cubes[static_cast<std::size_t>(i)]), rest_speed) << i;
    }
}

/// On the ground it comes to rest on handle and head: neither a part of it in the ground nor all of it above.
TEST(Hammer, comes_to_rest) {
    constexpr scalar mu = scalar(0.5);
    auto world = earth<Some<2>>();
    add_placed(*world, flat_ground(mu));
    const BodyId id = add_parts(*world, hammer(mu), 1, {0, 0, 2}, scattered_rotation(2)).value;
    ASSERT_EQ(world->apply_angular_impulse(id, {scalar(0.05), scalar(0.1), 0}), Status::ok);
    run(*world, 10);
    EXPECT_LE(speed(*world, id), 1e-2);
    const ingot::UserPose pose = ingot::user_pose(hammer(mu).mass(1), world->state(id).value);
    const Matrix3d A = to_eigen(pose.A);
    const Vector3d r = to_eigen(pose.r), half(0.125, 0.125, 0.25), axis = A.col(0);
    const double head = (r + axis).z() - A.row(2).cwiseAbs().dot(half);
    const double across = 0.0625 * std::sqrt(std::max(0.0, 1 - axis.z() * axis.z()));
    const double handle = std::min(r.z(), (r + axis).z()) - across;
    EXPECT_NEAR(head, 0, 1e-3);
    EXPECT_NEAR(handle, 0, 1e-3);
}

/// Jacks and dumbbells on tables: all come to rest in the pit, in each other's gaps. Their balls roll without resistance, so that one may sway on
/// for minutes in a hollow of 0.1 mm: at rest is who is no faster than a fall of that depth makes it.
TEST(CompoundPile, comes_to_rest) {
    static World<CompoundPile> world;
    ASSERT_EQ(set_up(world), Status::ok);
    run(world, 15);
    double fastest = 0;
    for (int slot = CompoundPile::wall_count; slot < CompoundPile::max_bodies; ++slot) {
        const BodyId id = world.body_at(slot);
        fastest = std::max(fastest, to_eigen(world.state(id).value.v_CM).norm());
        EXPECT_GE(place(world, id).z(), 0.1) << slot;
        EXPECT_LE(place(world, id).head<2>().cwiseAbs().maxCoeff(), 1.5) << slot;
    }
    figure("fastest, m/s", fastest);
    EXPECT_LE(fastest, std::sqrt(2 * 9.81 * 1e-4));
}

// Materials.

/// Feet of ice slide where feet of rubber hold, whatever the rest of the table is made of.
TEST(MaterialsOfShapes, are_those_of_the_shape_that_touches) {
    for (const bool ice : {false, true}) {
        auto world = earth<Some<2>>();
        add_placed(*world, half_space(thirty_degrees.up(), 0, 1));
        Parts<5> parts = table(ice ? scalar(1) : scalar(0));
        for (int i = 1; i < 5; ++i) parts.parts[i].friction = ice ? scalar(0) : scalar(1);
        const BodyId id = add_parts(*world, parts, 1, {}, thirty_degrees.A()).value;
        const Vector3d from = place(*world, id);
        run(*world, 1);
        const double way = to_eigen(thirty_degrees.down()).dot(place(*world, id) - from);
        EXPECT_NEAR(way, ice ? 0.5 * 9.81 * 0.5 : 0, ice ? 1e-3 : 1e-4);
    }
}

/// A ball that springs on the one end, a dead one on the other: dropped flat, the springy end comes up.
TEST(MaterialsOfShapes, bounce_by_the_shape) {
    auto world = earth<Some<2>>();
    add_placed(*world, flat_ground(0));
    Parts<2> parts = dumbbell(scalar(0.25), 2, 0);
    parts.parts[1].restitution = scalar(0.75);
    const BodyId id = add_parts(*world, parts, 1, {0, 0, scalar(1.25)}).value;
    double dead = 0, springy = 0, least = 1;
    for (int step_i = 0; step_i < 45; ++step_i) {
        ASSERT_TRUE(ingot::step(*world, OnEarth::h).clean());
        const ingot::UserPose pose = ingot::user_pose(parts.mass(1), world->state(id).value);
        const Vector3d y = to_eigen(pose.A).col(1), r = to_eigen(pose.r);
        least = std::min(least, r.z());
        if (least > 0.5) continue;  // on its way down
        dead = std::max(dead, (r - y).z() - 0.25);
        springy = std::max(springy, (r + y).z() - 0.25);
    }
    EXPECT_GT(springy, dead + 0.2);
}

// Doors, arrays.

template <class S>
void expect_refused(World<S>& world, const BodyDef& def, const ShapeDef* shapes, int count, Status status) {
    static World<S> before;
    std::memcpy(static_cast<void*>(&before), &world, sizeof world);
    EXPECT_EQ(world.add(def, shapes, count).status, status);
    EXPECT_EQ(std::memcmp(&world, &before, sizeof world), 0);
}

TEST(Compound, with_bad_input_is_refused_and_the_world_is_what_it_was) {
    using S = Compounded<3, 8, 3>;
    auto world = earth<S>();
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    BodyDef def;
    def.mass = jack(1).mass(1);
    const auto with = [](auto change) {
        Parts<4> parts = {{jack(1).parts[0], jack(1).parts[1], jack(1).parts[2], jack(1).parts[2]}};
        change(parts.parts[2]);
        return parts;
    };
    ASSERT_EQ(world->add(def, jack(1).parts).status, Status::ok);
    const struct {
        Parts<4> parts;
        Status status;
    } wrong[] = {{with([](ShapeDef& d) { d.shape = {}; }), Status::bad_shape},
                 {with([](ShapeDef& d) { d.shape = ingot::Sphere{0}; }), Status::bad_shape},
                 {with([](ShapeDef& d) { d.shape = ingot::hull_of<S>(9); }), Status::bad_shape},
                 {with([](ShapeDef& d) { d.shape = ingot::HalfSpace{{0, 0, 1}, 0}; }), Status::bad_shape},
                 {with([&](ShapeDef& d) { d.shape = ingot::Sphere{nan}; }), Status::not_finite},
                 {with([&](ShapeDef& d) { d.r.y = nan; }), Status::not_finite},
                 {with([&](ShapeDef& d) { d.r.y = ingot::limits::position_max * 2; }), Status::out_of_range},
                 {with([&](ShapeDef& d) { d.A.c1.y = nan; }), Status::not_finite},
                 {with([](ShapeDef& d) { d.A.c1 = d.A.c0; }), Status::not_a_rotation},
                 {with([](ShapeDef& d) { d.restitution = 2; }), Status::bad_restitution},
                 {with([](ShapeDef& d) { d.friction = -1; }), Status::bad_friction},
                 {with([](ShapeDef& d) { d.sensor = true; }), Status::not_in_scene}};
    for (const auto& [parts, status] : wrong) expect_refused(*world, def, parts.parts, 3, status);
    const Parts<4> good = with([](ShapeDef&) {});
    expect_refused(*world, def, good.parts, 4, Status::no_room);
    expect_refused(*world, def, good.parts, 0, Status::out_of_range);
    expect_refused(*world, def, good.parts, -1, Status::out_of_range);
    expect_refused<S>(*world, def, nullptr, 1, Status::out_of_range);
    BodyDef other = def;
    other.mass.r_CM.y = -ingot::limits::position_max;
    expect_refused(*world, other, with([](ShapeDef& d) { d.r.y = ingot::limits::position_max; }).parts, 3, Status::out_of_range);
    other = def;
    other.shape = ingot::Sphere{1};
    expect_refused(*world, other, good.parts, 3, Status::bad_shape);
    other = def;
    other.mass.M = -1;
    expect_refused(*world, other, good.parts, 3, Status::bad_mass);
    other = def;
    other.mass.r_CM.x = nan;
    expect_refused(*world, other, good.parts, 3, Status::not_finite);
    other = def;
    other.mass.A_principal.c0 = {2, 0, 0};
    expect_refused(*world, other, good.parts, 3, Status::not_a_rotation);
    other = def;
    other.filter.category = 2;
    expect_refused(*world, other, good.parts, 3, Status::not_in_scene);
    ASSERT_EQ(world->add(def, good.parts, 3).status, Status::ok);
    ASSERT_EQ(world->add(def, good.parts, 2).status, Status::ok);
    expect_refused(*world, def, good.parts, 3, Status::no_room);
}

/// Bodies that come, touch and go leave all the room there was: contacts are never short in a scene that holds those of one jack on a table.
TEST(Compound, gives_everything_back_when_removed) {
    using S = Compounded<3, 8>;
    auto world = earth<S>();
    add_placed(*world, flat_ground(1));
    int most = 0;
    for (int round_i = 0; round_i < 200; ++round_i) {
        const BodyId table_id = add_parts(*world, table(1), 1, {0, 0, 0}).value;
        const BodyId jack_id = add_parts(*world, jack(1), 1, {0, 0, scalar(1.375)}).value;
        for (int step_i = 0; step_i < 10; ++step_i) {
            const StepReport report = ingot::step(*world, OnEarth::h);
            ASSERT_TRUE(report.clean()) << round_i;
            most = std::max<int>(most, report.contacts);
        }
        ASSERT_EQ(world->remove(table_id), Status::ok);
        if (round_i % 2 == 0) {
            ASSERT_TRUE(ingot::step(*world, OnEarth::h).clean());
        }
        ASSERT_EQ(world->remove(jack_id), Status::ok);
        EXPECT_FALSE(world->cast_ray({0, 0, 3}, {0, 0, -2}).value.found()) << "nothing is left above the ground";
        ASSERT_EQ(world->remove(table_id), Status::stale_id);
        ASSERT_EQ(world->set_state(table_id, {}), Status::stale_id);
    }
    figure("contacts, most", most);
    EXPECT_GE(most, 5);  // four feet and the jack
    const StepReport report = ingot::step(*world, OnEarth::h);
    EXPECT_EQ(report.contacts, 0);
}

/// Room for three of the four feet: said in every step, and nothing else goes wrong.
TEST(Compound, that_has_no_room_for_its_contacts_is_reported) {
    auto world = earth<Compounded<2, 3>>();
    add_placed(*world, flat_ground(1));
    const BodyId id = add_parts(*world, table(1), 1, {}).value;
    for (int step_i = 0; step_i < 5; ++step_i) {
        const StepReport report = ingot::step(*world, OnEarth::h);
        EXPECT_EQ(report.contacts, 3);
        EXPECT_EQ(report.contacts_lost, 1);
        EXPECT_FALSE(report.clean());
    }
    EXPECT_TRUE(to_eigen(world->state(id).value.r_CM).allFinite());
}

/// Both searches find the same pairs, without those within a body: the same steps to the bit.
struct PileOfAllPairs : CompoundPile {
    using broad_phase = ingot::AllPairs;
};
TEST(Compound, is_found_by_both_searches) {
    static World<CompoundPile> tree;
    static World<PileOfAllPairs> all;
    ASSERT_EQ(set_up(tree), Status::ok);
    ASSERT_EQ(scenes::set_up_compounds(all), Status::ok);
    for (int step_i = 0; step_i < 180; ++step_i) {
        ASSERT_TRUE(scenes::well_but_for_impacts(ingot::step(tree, CompoundPile::h)));
        ASSERT_TRUE(scenes::well_but_for_impacts(ingot::step(all, CompoundPile::h)));
        ASSERT_EQ(all.state_hash(), tree.state_hash()) << step_i;
    }
    static uint8_t bytes[ingot::snapshot_size<CompoundPile>()];
    const auto size = ingot::save_snapshot(tree, bytes, sizeof bytes);
    EXPECT_EQ(ingot::load_snapshot(all, bytes, size.value), Status::other_scene) << "but every trait is part of what a scene is to a snapshot";
}

/// Rollback by memcpy and by the portable bytes: the same steps to the bit, the same bytes.
TEST(CompoundSnapshot, goes_on_to_the_bit) {
    static World<CompoundPile> world, copied, restored;
    static uint8_t bytes[ingot::snapshot_size<CompoundPile>()], again[sizeof bytes];
    ASSERT_EQ(set_up(world), Status::ok);
    for (int step_i = 0; step_i < 200; ++step_i) {
        if (step_i == 90) {
            ASSERT_EQ(world.remove(world.body_at(6)), Status::ok);
        }
        if (step_i == 120) {
            ASSERT_EQ(add_parts(world, hammer(1), 1, {0, 0, 5}).status, Status::ok);
        }
        if (step_i % 40 == 0) {
            const auto size = ingot::save_snapshot(world, bytes, sizeof bytes);
            ASSERT_TRUE(size.ok());
            std::memset(static_cast<void*>(&restored), 0xa5, sizeof restored);
            ASSERT_EQ(ingot::load_snapshot(restored, bytes, size.value), Status::ok);
            std::memcpy(static_cast<void*>(&copied), &world, sizeof world);
            for (int ahead_i = 0; ahead_i < 30; ++ahead_i) {
                (void)ingot::step(restored, CompoundPile::h);
                (void)ingot::step(copied, CompoundPile::h);
                ASSERT_EQ(restored.state_hash(), copied.state_hash()) << step_i << " + " << ahead_i;
            }
            const auto size_of_copied = ingot::save_snapshot(copied, bytes, sizeof bytes);
            ASSERT_EQ(ingot::save_snapshot(restored, again, sizeof again).value, size_of_copied.value);
            ASSERT_EQ(std::memcmp(bytes, again, size_of_copied.value), 0);
        }
        ASSERT_TRUE(scenes::well_but_for_impacts(ingot::step(world, CompoundPile::h)));
    }
    static World<Compounded<19, 160, 4>> other;
    const auto size = ingot::save_snapshot(world, bytes, sizeof bytes);
    EXPECT_EQ(ingot::load_snapshot(other, bytes, size.value), Status::other_scene);
}

/// Bytes changed one by one, checksum made good: loaded or refused, never half, and what is loaded can step.
TEST(CompoundSnapshot, of_damaged_shapes_is_refused_or_sound) {
    using S = Compounded<3, 8>;
    static World<S> world, victim, before;
    ASSERT_EQ(world.set_gravity(OnEarth::gravity), Status::ok);
    add_placed(world, flat_ground(1));
    (void)add_parts(world, table(1), 1, {}).ok();
    (void)add_parts(world, jack(1), 1, {0, 0, scalar(1.375)}).ok();
    for (int step_i = 0; step_i < 10; ++step_i) ASSERT_TRUE(ingot::step(world, OnEarth::h).clean());
    static uint8_t bytes[ingot::snapshot_size<S>()];
    const std::size_t size = ingot::save_snapshot(world, bytes, sizeof bytes).value;
    int refused = 0, loaded = 0;
    for (std::size_t byte_i = ingot::snapshot_header_size(); byte_i < size - ingot::snapshot_checksum_size; ++byte_i) {
        static uint8_t damaged[sizeof bytes];
        std::memcpy(damaged, bytes, size);
        damaged[byte_i] = static_cast<uint8_t>(damaged[byte_i] ^ (byte_i % 2 == 0 ? 0x80 : 0xff));
        const uint64_t checksum = ingot::snapshot_checksum(damaged, size - ingot::snapshot_checksum_size);
        for (unsigned i = 0; i < 8; ++i) damaged[size - 8 + i] = static_cast<uint8_t>(checksum >> (8 * i));
        std::memcpy(static_cast<void*>(&victim), &world, sizeof world);
        std::memcpy(static_cast<void*>(&before), &world, sizeof world);
        const Status status = ingot::load_snapshot(victim, damaged, size);
        if (status != Status::ok) {
            ++refused;
            ASSERT_EQ(std::memcmp(&victim, &before, sizeof victim), 0) << byte_i;
            continue;
        }
        ++loaded;
        for (int step_i = 0; step_i < 2; ++step_i) (void)ingot::step(victim, OnEarth::h);
    }
    EXPECT_GT(refused, 100);
    EXPECT_GT(loaded, 100);
}

// What is told by shape.

TEST(CompoundQueries, tell_the_shape_and_each_body_once) {
    auto world = std::unique_ptr<World<Told<3>>>(new World<Told<3>>{});
    BodyDef def;
    def.mass = table(1).mass(1);
    def.filter = {4, 0xffffffffu};
    def.state = ingot::body_state(def.mass, {{10, 0, 0}});
    const BodyId id = world->add(def, table(1).parts).value;
    const BodyId ball = add_placed(*world, solid_ball(1, scalar(0.25), {10, 0, 2}, 1));
    const ingot::QueryHit down = world->cast_ray({10, 0, scalar(1.5)}, {0, 0, -2}).value;
    EXPECT_EQ(down.body, id);
    EXPECT_EQ(down.shape, 0);
    EXPECT_NEAR(down.P.z, 0.875, 1e-5);
    const double a = 0.4375;
    const double legs[4][2] = {{a, a}, {-a, a}, {a, -a}, {-a, -a}};
    for (int leg_i = 0; leg_i < 4; ++leg_i) {
        const Vector under = {scalar(10 + legs[leg_i][0]), scalar(legs[leg_i][1]), -1};
        const ingot::QueryHit up = world->cast_ray(under, {0, 0, 3}).value;
        EXPECT_EQ(up.body, id);
        EXPECT_EQ(up.shape, 1 + leg_i);
        EXPECT_NEAR(up.P.z, 0, 1e-5);
        EXPECT_EQ(world->find_nearest(under, 2).value.shape, 1 + leg_i);
        EXPECT_NEAR(world->find_nearest(under, 2).value.distance, 1, 1e-5);
        const ingot::PlacedShape probe = {ingot::Sphere{scalar(0.03125)}, under, no_turn, nullptr};
        EXPECT_EQ(world->cast_shape(probe, {0, 0, 3}).value.shape, 1 + leg_i);
    }
    EXPECT_FALSE(world->cast_ray({10, -3, scalar(0.375)}, {0, 6, 0}).value.found()) << "between the legs there is nothing";

    const ingot::PlacedShape around = {ingot::Sphere{2}, {10, 0, 0}, no_turn, nullptr};
    BodyId found[3];
    EXPECT_EQ(world->find_overlaps(around, found, 3).value, 2);
    EXPECT_EQ(found[0], id);
    EXPECT_EQ(found[1], ball);
    ingot::QueryFilter filter;
    filter.except = id;
    EXPECT_EQ(world->find_overlaps(around, found, 3, filter).value, 1);
    EXPECT_FALSE(world->cast_ray({10, 0, scalar(1.5)}, {0, 0, -2}, filter).value.found());
    filter.except = {};
    filter.filter.mask = ~4u;
    EXPECT_EQ(world->find_overlaps(around, found, 3, filter).value, 1);

    // Moved and turned, without a step: shapes are where the body is.
    ingot::BodyState moved = ingot::body_state(def.mass, {{-5, 0, 0}, along_x});
    ASSERT_EQ(world->set_state(id, moved), Status::ok);
    EXPECT_FALSE(world->cast_ray({10, 0, scalar(1.5)}, {0, 0, -2}).value.found());
    EXPECT_EQ(world->cast_ray({0, 0, 0}, {-8, 0, 0}).value.body, id);
    EXPECT_NEAR(world->cast_ray({0, 0, 0}, {-8, 0, 0}).value.P.x, -5 + 0.875, 1e-5);

    World<Told<3>> copy = *world;  // refused: nothing moves
    moved.A.c0 = {2, 0, 0};
    EXPECT_EQ(world->set_state(id, moved), Status::not_a_rotation);
    EXPECT_EQ(std::memcmp(&copy, world.get(), sizeof copy), 0);
}

TEST(CompoundQueries, see_the_shapes_where_a_step_has_left_them) {
    auto world = earth<Told<2>>();
    const BodyId id = add_parts(*world, dumbbell(scalar(0.25), 2, 1), 1, {}).value;
    ASSERT_EQ(world->apply_angular_impulse(id, {0, 0, 1}), Status::ok);
    for (int step_i = 0; step_i < 30; ++step_i) {
        ASSERT_TRUE(ingot::step(*world, OnEarth::h).clean());
        const ingot::UserPose pose = ingot::user_pose(dumbbell(scalar(0.25), 2, 1).mass(1), world->state(id).value);
        for (int ball_i = 0; ball_i < 2; ++ball_i) {
            const Vector centre = pose.r + pose.A.c1 * scalar(ball_i == 0 ? -1 : 1);
            const ingot::QueryNearest nearest = world->find_nearest(centre, 0).value;
            EXPECT_EQ(nearest.body, id);
            EXPECT_EQ(nearest.shape, ball_i);
            EXPECT_NEAR(nearest.distance, -0.25, 1e-5);
        }
    }
}

/// The four feet begin to touch, each by its number; one body that is removed ends them all; a body that takes the slot begins anew.
TEST(CompoundEvents, are_told_by_shape) {
    using S = Told<3>;
    auto world = earth<S>();
    const BodyId ground = add_placed(*world, flat_ground(1));
    const BodyId id = add_parts(*world, table(1), 1, {0, 0, scalar(0.01)}).value;
    unsigned began = 0, ended = 0;
    const auto tell = [&](BodyId of) {
        for (const ingot::Event& event : world->events()) {
            EXPECT_EQ(event.A, ground);
            EXPECT_EQ(event.B, of);
            EXPECT_EQ(event.shape_A, 0);
            if (event.kind == EventKind::begin) began |= 1u << event.shape_B;
            if (event.kind == EventKind::end) ended |= 1u << event.shape_B;
        }
    };
    for (int step_i = 0; step_i < 30; ++step_i) {
        ASSERT_TRUE(ingot::step(*world, OnEarth::h).clean());
        tell(id);
    }
    EXPECT_EQ(began, 0x1eu);
    EXPECT_EQ(ended, 0u);
    ASSERT_EQ(world->remove(id), Status::ok);
    const BodyId next = add_parts(*world, hammer(1), 1, {0, 0, 5}).value;
    EXPECT_EQ(next.slot, id.slot);
    ASSERT_TRUE(ingot::step(*world, OnEarth::h).clean());
    tell(id);
    EXPECT_EQ(ended, 0x1eu);
}

/// A body with a sensor around its solid part: it notes a visitor by the shape, and touches with the solid one alone.
TEST(CompoundSensors, are_shapes) {
    using S = Told<3>;
    auto world = earth<S>();
    add_placed(*world, flat_ground(1));
    Parts<2> parts = {{part(ingot::Sphere{scalar(0.25)}, {}, 1), part(ingot::Sphere{1}, {}, 1)}};
    parts.parts[1].sensor = true;
    const BodyId guard = add_parts(*world, parts, 1, {0, 0, scalar(0.25)}).value;
    const BodyId visitor = add_placed(*world, solid_ball(1, scalar(0.25), {scalar(0.75), 0, scalar(0.25)}, 1));
    run(*world, 1);
    EXPECT_NEAR(place(*world, guard).z(), 0.25, 1e-3) << "the sensor does not touch the ground";
    EXPECT_NEAR(place(*world, visitor).x(), 0.75, 1e-3);
    bool noted = false;
    for (int i = 0; i < world->overlap_count(); ++i) {
        const ingot::OverlapInfo info = world->overlap(i).value;
        EXPECT_EQ(info.sensor, guard);
        EXPECT_EQ(info.sensor_shape, 1);
        noted = noted || (info.visitor == visitor && info.visitor_shape == 0);
    }
    EXPECT_TRUE(noted);
    ingot::QueryFilter all;
    all.sensors = true;
    EXPECT_EQ(world->cast_ray({0, 0, 3}, {0, 0, -3}).value.shape, 0);
    EXPECT_EQ(world->cast_ray({0, 0, 3}, {0, 0, -3}, all).value.shape, 1);
}

/// Two tables through each other that their filters keep apart, and two that meet.
TEST(CompoundFilters, are_of_the_body) {
    for (const bool meet : {false, true}) {
        auto world = std::unique_ptr<World<Told<2>>>(new World<Told<2>>{});
        BodyDef def;
        def.mass = table(1).mass(1);
        def.filter = {1, meet ? 3u : 1u};
        def.state = ingot::body_state(def.mass, {});
        const BodyId first = world->add(def, table(1).parts).value;
        def.filter.category = 2;
        def.filter.mask = meet ? 3u : 2u;
        def.state = ingot::body_state(def.mass, {{scalar(0.03125), 0, scalar(0.03125)}});
        (void)world->add(def, table(1).parts).ok();
        const StepReport report = ingot::step(*world, OnEarth::h);
        EXPECT_EQ(report.contacts > 0, meet);
        if (meet) {
            ASSERT_EQ(world->set_filter(first, {1, 1}), Status::ok);
            EXPECT_EQ(ingot::step(*world, OnEarth::h).contacts, 0);
        }
    }
}

/// A scene of bodies of one shape knows nothing of this: nothing of it is in its storage, and its bodies are the shapes.
TEST(OneShape, is_the_body) {
    using S = Hulled<4, 8>;
    static_assert(std::is_empty_v<ingot::features::Compounds::Memory<S, ingot::has_compounds<S>>> &&
                  std::is_empty_v<ingot::features::BodyPairPart<S, ingot::has_compounds<S>>>);
    ingot::Storage<S> storage{};
    EXPECT_EQ(storage.shapes().rotation, storage.bodies().rotation);
    EXPECT_EQ(storage.manifolds_of_bodies().pairs, storage.pairs);
}

}  // namespace
