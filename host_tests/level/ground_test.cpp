// SPDX-License-Identifier: MIT
// Bodies in rooms and on hills: none leaves, none gains energy, they come to rest; and what a world is asked and told of its levels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "ground.h"
#include "reference/draws.h"

namespace {

using namespace level_test;

struct Sleepers : OnLevel {
    static constexpr bool sleeps = true;
    static constexpr bool filters = true;
    static constexpr int max_events = 200;
    static inline LevelTable levels[2] = {};
};

double energy_of(const World<OnLevel>& world, const std::vector<BodyId>& bodies) {
    double sum = static_cast<double>(world.kinetic_energy());
    for (const BodyId id : bodies) sum += 9.81 * static_cast<double>(world.mass(id).value * world.state(id).value.r_CM.z);
    return sum;
}

/// Bodies of every shape, up to 8 m/s and 6 rad/s fast, in rooms of every cut, and tilted any way. The bar for the energy of a step is that of single
/// bodies on one slab (1e-5 of what there is), and what taking back an overlap of touching_gap lifts.
TEST(RoomOfTriangles, holds_bodies_and_gives_them_no_energy) {
    for (int draw = 0; draw < ingot_reference::draws(48); ++draw) {
        Random random(static_cast<uint64_t>(500 + draw));
        const Ground room = room_of(random);
        auto& world = empty_world<OnLevel>();
        OnLevel::levels[0] = room.view;
        LevelDef level;
        level.friction = static_cast<scalar>(within(random, 0, 0.8));
        level.A = any_rotation(random);
        ASSERT_TRUE(world.add_level(level).ok());
        std::vector<BodyId> bodies;
        double weight = 0;
        for (int i = 0; i < 4; ++i) {
            BodyDef def = goer(random, static_cast<Goer>(between(random, 0, goers_count - 2)), static_cast<scalar>(within(random, 0.1, 0.35)), 0);
            const Vector place = level.A * Vector{static_cast<scalar>(1 + 1.3 * i), static_cast<scalar>(1.2 + 0.8 * i), 2};
            def.state = ingot::body_state(def.mass, {place, any_rotation(random)},
                                          {{static_cast<scalar>(within(random, -4, 4)), static_cast<scalar>(within(random, -4, 4)), 0},
                                           {static_cast<scalar>(within(random, -6, 6)), static_cast<scalar>(within(random, -6, 6)), 0}});
            bodies.push_back(world.add(def).value);
            weight += 9.81 * static_cast<double>(world.mass(bodies.back()).value);
        }
        const int rate = between(random, 0, 1) == 0 ? 60 : 240;
        double before = energy_of(world, bodies);
        for (int i = 0; i < 4 * rate; ++i) {
            (void)ingot::step(world, 1 / static_cast<scalar>(rate));
            const double now = energy_of(world, bodies);
            ASSERT_LE(now - before, 1e-5 * std::abs(before) + 1e-3 * weight) << "draw " << draw << ", step " << i << ", " << rate << " Hz";
            before = now;
            for (const BodyId id : bodies) {
                const Vector r = transpose_times(level.A, world.state(id).value.r_CM);
                ASSERT_TRUE(r.x > 0 && r.x < 6 && r.y > 0 && r.y < 5 && r.z > 0 && r.z < 4) << "draw " << draw << ", step " << i;
            }
        }
    }
}

/// A tower on cells of every size stands as on a slab, and sleeps as soon.
TEST(OnTriangles, towers_stand_as_on_a_slab) {
    for (int draw = 0; draw < ingot_reference::draws(24); ++draw) {
        Random random(static_cast<uint64_t>(700 + draw));
        const Ground ground = plane_of(random, static_cast<Seams>(draw % seams_count));
        auto& world = empty_world<Sleepers>();
        add_level(world, ground.view, scalar(0.5));
        std::vector<BodyId> tower;
        const Vector half = {scalar(0.25), scalar(0.3), scalar(0.2)};
        const Matrix A = about_z(within(random, 0, 6));
        for (int i = 0; i < 5; ++i) {
            BodyDef def;
            def.mass = ingot::principal(ingot::solid_box(500, half)).value;
            def.shape = ingot::Box{half};
            def.state = ingot::body_state(def.mass, {ground.middle + Vector{0, 0, static_cast<scalar>(0.2 + 0.4 * i)}, A});
            tower.push_back(world.add(def).value);
        }
        for (int i = 0; i < 120; ++i) (void)ingot::step(world, scalar(1) / 60);
        for (int i = 0; i < 5; ++i) {
            EXPECT_TRUE(world.is_asleep(tower[static_cast<size_t>(i)])) << "draw " << draw;
            const Vector r = world.state(tower[static_cast<size_t>(i)]).value.r_CM - ground.middle;
            EXPECT_NEAR(r.z, 0.2 + 0.4 * i, 2e-4) << "draw " << draw;
            EXPECT_LE(std::abs(r.x) + std::abs(r.y), 2e-4) << "draw " << draw;
        }
    }
}

/// A hill that rises by 1 in 4, and friction below that: what lies on it slides, and what is stuck above it does not sink.
TEST(OnTriangles, slopes_are_left_at_the_angle_of_friction) {
    for (const double mu : {0.2, 0.24, 0.26, 0.3}) {
        Random random(1);
        Soup soup = terrain(random, 20, 256, [](int column, int) { return 64 * column; });
        Ground ground;
        take_mesh(soup, 1.0 / 256, ground);
        auto& world = empty_world<OnLevel>();
        add_level(world, ground.view, static_cast<scalar>(mu));
        const double tilt = std::atan(0.25);
        const auto c = static_cast<scalar>(std::cos(tilt)), s = static_cast<scalar>(std::sin(tilt));
        BodyDef def;
        const Vector half = {scalar(0.4), scalar(0.3), scalar(0.1)};
        def.mass = ingot::principal(ingot::solid_box(500, half)).value;
        def.shape = ingot::Box{half};
        def.friction = static_cast<scalar>(mu);
        def.state = ingot::body_state(def.mass, {Vector{10, 10, scalar(2.5)} + Vector{-s, 0, c} * half.z, {{c, 0, s}, {0, 1, 0}, {-s, 0, c}}});
        const BodyId id = world.add(def).value;
        for (int i = 0; i < 60; ++i) (void)ingot::step(world, scalar(1) / 60);
        const double way = std::sqrt(static_cast<double>(length_sq(world.state(id).value.r_CM - def.state.r_CM)));
        const double pull = 9.81 * (std::sin(tilt) - mu * std::cos(tilt));
        EXPECT_NEAR(way, pull > 0 ? pull / 2 : 0, 0.01 * std::abs(pull) + 1e-3) << mu;
    }
}

/// A sheet without thickness, triangles that are there from both sides: bodies of every shape stay on the side that they come from.
TEST(OnTriangles, sheets_have_two_sides) {
    for (int draw = 0; draw < ingot_reference::draws(60); ++draw) {
        Random random(static_cast<uint64_t>(600 + draw));
        Soup soup = terrain(random, between(random, 1, 12), 64 * between(random, 1, 4), [](int, int) { return 8; });
        const std::vector<ingot::LevelFace> above = soup.faces;
        for (const ingot::LevelFace& face : above) soup.faces.push_back({face.a, face.c, face.b});
        Ground ground;
        take_mesh(soup, 1.0 / 64, ground);
        auto& world = empty_world<OnLevel>();
        add_level(world, ground.view);
        const Vector middle = ground.view.middle();
        const auto reach = static_cast<double>(middle.x);
        const double side = draw % 2 == 0 ? 1 : -1;
        (void)world.set_gravity({0, 0, static_cast<scalar>(-9.81 * side)});
        BodyDef def = goer(random, static_cast<Goer>(draw % (goers_count - 1)), static_cast<scalar>(within(random, 0.1, 0.3)), 0);
        const auto x = static_cast<scalar>(within(random, -0.4, 0.4) * reach), y = static_cast<scalar>(within(random, -0.4, 0.4) * reach);
        def.state.r_CM = middle + Vector{x, y, static_cast<scalar>(side * within(random, 0.6, 2))};
        def.state.A = any_rotation(random);
        const BodyId id = world.add(def).value;
        for (int i = 0; i < 60; ++i) {
            (void)ingot::step(world, scalar(1) / 60);
            ASSERT_GT(side * static_cast<double>(world.state(id).value.r_CM.z - middle.z), 0) << "draw " << draw << ", step " << i;
        }
    }
}

/// Slivers 90 m long and a step of the lattice wide lie in a plane: float makes no plane of them, and they are as if they were not there, to bodies,
/// queries and movers.
TEST(OnTriangles, slivers_whose_area_is_lost_are_not_there) {
    Random random(52);
    Soup soup;
    for (const auto& corner : {std::array<int, 2>{0, 0}, {65535, 0}, {65535, 65535}, {0, 65535}})
        soup.points.push_back(lattice_point(corner[0], corner[1], 8));
    soup.faces = {{0, 1, 2}, {0, 2, 3}};
    Ground ground[2];
    take_mesh(soup, 1.0 / 1024, ground[0]);
    for (int i = 0; i < 12; ++i) {
        const int x = between(random, 0, 9), y = between(random, 0, 9), first = static_cast<int>(soup.points.size());
        // Twice its area, of both long edges, is n (2 - n) + (n - 1)^2 = 1 step squared.
        const int n = 65500 - between(random, 0, 20000);
        soup.points.push_back(lattice_point(x, y, 8));
        soup.points.push_back(lattice_point(x + n, y + n - 1, 8));
        soup.points.push_back(lattice_point(x + 1, y + 1, 8));
        soup.faces.push_back({first, first + 1, first + 2});
    }
    take_mesh(soup, 1.0 / 1024, ground[1]);
    int lost = 0;
    ingot::TriangleFace face;
    for (const uint32_t number : triangles_of(ground[1].view)) lost += face_of_triangle(triangle_of(ground[1].view, number), face) ? 0 : 1;
    if (!INGOT_DOUBLE) {
        EXPECT_GT(lost, 0) << "of slivers";
    }
    for (int draw = 0; draw < ingot_reference::draws(40); ++draw) {
        const double at = within(random, 10, 50), angle = within(random, 0, 2 * pi);
        BodyDef def = goer(random, static_cast<Goer>(draw % (goers_count - 1)), static_cast<scalar>(within(random, 0.1, 0.4)), within(random, 0, 4));
        def.state.r_CM = def.state.r_CM + Vector{static_cast<scalar>(at), static_cast<scalar>(at), 8.0f / 1024};
        const Vector from = def.state.r_CM + Vector{0, 0, 3}, way = about_z(angle).c0 * scalar(2) - Vector{0, 0, 6};
        const ingot::PlacedShape ball = {ingot::Sphere{scalar(0.2)}, from, ingot::identity_matrix<scalar>(), nullptr};
        Vector r[2], of_mover[2];
        scalar told[2][3];
        for (int which = 0; which < 2; ++which) {
            auto& world = empty_world<OnLevel>();
            add_level(world, ground[which].view);
            told[which][0] = world.cast_ray(from, way).value.fraction;
            told[which][1] = world.cast_shape(ball, way).value.fraction;
            told[which][2] = world.find_nearest(from, 10).value.distance;
            ingot::Mover mover;
            mover.r = from;
            for (int i = 0; i < 120; ++i) ASSERT_EQ(world.move(mover, {about_z(angle).c0, 0}, scalar(1) / 60), Status::ok);
            of_mover[which] = mover.r;
            const BodyId id = world.add(def).value;
            for (int i = 0; i < 60; ++i) (void)ingot::step(world, scalar(1) / 60);
            r[which] = world.state(id).value.r_CM;
        }
        for (const int i : {0, 1, 2}) EXPECT_NEAR(told[0][i], told[1][i], 1e-5 * std::abs(told[0][i])) << draw << " " << i;
        EXPECT_LT(length(of_mover[0] - of_mover[1]), 1e-4) << draw;
        EXPECT_LT(length(r[0] - r[1]), 1e-3 * (length(r[0] - def.state.r_CM) + 0.1)) << draw;
    }
}

TEST(LevelsOfAWorld, ids_rooms_and_edits) {
    Random random(3);
    const Ground ground = plane_of(random, Seams::grid);
    auto& world = empty_world<Sleepers>();
    Sleepers::levels[0] = Sleepers::levels[1] = ground.view;
    BodyDef ball = goer(random, Goer::ball, scalar(0.2), 0);
    std::vector<BodyId> bodies;
    for (int i = 0; i < 7; ++i) bodies.push_back(world.add(ball).value);
    EXPECT_EQ(world.remove(bodies[1]), Status::ok);  // room for one, not for a level
    const ingot::Result<BodyId> level = world.add_level({1, {1, 2, 3}, about_z(1), 0, scalar(0.7)});
    ASSERT_TRUE(level.ok());
    EXPECT_EQ(level.value.slot, 7);
    EXPECT_EQ(world.body_count(), 7);
    EXPECT_EQ(world.body_at(7), level.value);
    EXPECT_FALSE(world.body_at(8).generation != 0) << "no body of its own";
    EXPECT_EQ(world.add(ball).value.slot, 1) << "the lowest free slot";
    EXPECT_EQ(world.add(ball).value.slot, 11);

    EXPECT_EQ(world.friction(level.value).value, scalar(0.7));
    EXPECT_EQ(world.set_friction(level.value, scalar(0.1)), Status::ok);
    EXPECT_FALSE(world.is_movable(level.value));
    EXPECT_EQ(world.set_movable(level.value, ball.mass), Status::bad_shape);
    EXPECT_EQ(world.set_shape(level.value, ingot::Sphere{1}), Status::bad_shape);
    EXPECT_EQ(world.set_shape(bodies[0], world.shape(level.value).value), Status::bad_shape);

    const uint64_t hash = world.state_hash();
    LevelDef bad;
    bad.number = 2;
    EXPECT_EQ(world.add_level(bad).status, Status::bad_shape);
    bad.number = -1;
    EXPECT_EQ(world.add_level(bad).status, Status::bad_shape);
    bad = {};
    bad.friction = -1;
    EXPECT_EQ(world.add_level(bad).status, Status::bad_friction);
    bad = {};
    bad.r.x = std::nanf("");
    EXPECT_EQ(world.add_level(bad).status, Status::not_finite);
    bad = {};
    bad.A.c0 = {2, 0, 0};
    EXPECT_EQ(world.add_level(bad).status, Status::not_a_rotation);
    BodyDef no_level;
    no_level.immovable = true;
    no_level.shape = world.shape(level.value).value;
    EXPECT_EQ(world.add(no_level).status, Status::bad_shape);
    EXPECT_EQ(world.state_hash(), hash);

    EXPECT_EQ(world.remove(level.value), Status::ok);
    EXPECT_FALSE(world.is_alive(level.value));
    EXPECT_EQ(world.remove(level.value), Status::stale_id);
    for (int slot = 7; slot < 11; ++slot) EXPECT_TRUE(world.add(ball).ok()) << "its slots are free";
    while (world.add(ball).ok()) {}
    EXPECT_EQ(world.add_level({}).status, Status::no_room);
}

/// Of a level all of it is edited: what lies on a wall of it is drawn along as what lies on its floor is.
struct Edited : OnLevel {
    static constexpr bool surface_velocities = true, rolling_resistance = true;
    static constexpr int max_overlaps = 8, max_shapes_of_body = 2;
    static inline LevelTable levels[2] = {};
};
TEST(LevelsOfAWorld, are_edited_as_one) {
    Random random(7);
    const Ground ground = plane_of(random, Seams::grid);
    auto& world = empty_world<Edited>();
    const BodyId level = add_level(world, ground.view, scalar(0.5));
    EXPECT_EQ(world.body_count(), 1);
    EXPECT_EQ(world.set_surface_velocity(level, {1, 0, 0}), Status::ok);
    EXPECT_EQ(world.set_rolling_resistance(level, scalar(0.01)), Status::ok);
    EXPECT_EQ(world.set_sensor(level, true), Status::bad_shape);
    EXPECT_EQ(world.set_shape_place(level, {{}, ingot::identity_matrix<scalar>()}, 0), Status::bad_shape);
    for (int shape_i = 0; shape_i < 2; ++shape_i) {
        EXPECT_EQ(world.surface_velocity(level, shape_i).value.x, 1);
        EXPECT_EQ(world.rolling_resistance(level, shape_i).value, scalar(0.01));
    }
    BodyDef def = goer(random, Goer::box, scalar(0.2), 0);
    def.state.r_CM = def.state.r_CM + ground.middle;
    const ingot::ShapeDef part[] = {{def.shape, {}, ingot::identity_matrix<scalar>(), 0, scalar(0.5)}};
    def.shape = {};
    const BodyId box = world.add(def, part).value;
    for (int i = 0; i < 60; ++i) (void)ingot::step(world, scalar(1) / 60);
    EXPECT_NEAR(world.state(box).value.v_CM.x, 1, 1e-3) << "drawn along by the belt";
}

/// A level that is put elsewhere takes its ground along: the ball falls on.
TEST(LevelsOfAWorld, go_where_they_are_put_and_wake_who_rests) {
    Random random(4);
    const Ground ground = plane_of(random, Seams::grid);
    auto& world = empty_world<Sleepers>();
    const BodyId level = add_level(world, ground.view);
    BodyDef def = goer(random, Goer::box, scalar(0.2), 0);
    def.state.r_CM = def.state.r_CM + ground.middle;
    const BodyId box = world.add(def).value;
    bool begins = false;
    for (int i = 0; i < 90; ++i) {
        (void)ingot::step(world, scalar(1) / 60);
        for (const ingot::Event& event : world.events())
            begins = begins || (event.kind == ingot::EventKind::begin && (event.A == level || event.B == level));
    }
    EXPECT_TRUE(begins);
    EXPECT_TRUE(world.is_asleep(box));
    int of_level = 0;
    for (const ingot::ContactInfo& contact : world.contacts_of(level)) of_level += contact.A == box || contact.B == box ? 1 : 0;
    EXPECT_EQ(of_level, 1);
    ingot::BodyState lower = world.state(level).value;
    lower.r_CM.z -= 1;
    EXPECT_EQ(world.set_state(level, lower), Status::ok);
    for (int i = 0; i < 90; ++i) (void)ingot::step(world, scalar(1) / 60);
    EXPECT_NEAR(world.state(box).value.r_CM.z, def.state.r_CM.z - 1, 1e-3);
    EXPECT_EQ(world.remove(level), Status::ok);
    for (int i = 0; i < 60; ++i) (void)ingot::step(world, scalar(1) / 60);
    EXPECT_LT(world.state(box).value.r_CM.z, def.state.r_CM.z - 4);
}

/// Snapshots go on to the same bits, and name the level by its tables: over another one they are refused.
TEST(LevelsOfAWorld, snapshots_know_their_ground) {
    Random random(5);
    const Ground room = room_of(random), other = room_of(random);
    auto& world = empty_world<Sleepers>();
    add_level(world, room.view);
    for (int i = 0; i < 6; ++i) {
        BodyDef def = goer(random, static_cast<Goer>(i % 5), scalar(0.3), 3);
        def.state.r_CM = {static_cast<scalar>(0.8 + 0.8 * i), 2, 1};
        ASSERT_TRUE(world.add(def).ok());
    }
    for (int i = 0; i < 50; ++i) (void)ingot::step(world, scalar(1) / 60);
    std::vector<uint8_t> bytes(ingot::snapshot_size<Sleepers>());
    const auto saved = ingot::save_snapshot(world, bytes.data(), bytes.size());
    ASSERT_TRUE(saved.ok());
    for (int i = 0; i < 50; ++i) (void)ingot::step(world, scalar(1) / 60);
    const uint64_t hash = world.state_hash();
    static World<Sleepers> again;
    ASSERT_EQ(ingot::load_snapshot(again, bytes.data(), saved.value), Status::ok);
    for (int i = 0; i < 50; ++i) (void)ingot::step(again, scalar(1) / 60);
    EXPECT_EQ(again.state_hash(), hash);
    Sleepers::levels[0] = other.view;
    EXPECT_NE(ingot::load_snapshot(again, bytes.data(), saved.value), Status::ok);
    EXPECT_EQ(again.state_hash(), hash);
}

/// Rays, shapes that are cast, overlaps and what is nearest, in a room: as its six planes say.
TEST(LevelsOfAWorld, answer_queries_as_planes_do) {
    Random random(6);
    const Ground room = room_of(random);
    auto& world = empty_world<OnLevel>();
    const Vector at = {-1, 4, 2};
    const BodyId level = add_level(world, room.view, scalar(0.3), at);
    const double size[3] = {6, 5, 4};
    for (int draw = 0; draw < 2000; ++draw) {
        const double from[3] = {within(random, 0.5, 5.5), within(random, 0.5, 4.5), within(random, 0.5, 3.5)};
        const double way[3] = {within(random, -9, 9), within(random, -9, 9), within(random, -9, 9)};
        const double radius = within(random, 0.05, 0.45);
        double first = 1, first_of_ball = 1, nearest = 10;
        for (int axis = 0; axis < 3; ++axis) {
            const double room_ahead = way[axis] > 0 ? size[axis] - from[axis] : from[axis];
            first = std::min(first, room_ahead / std::abs(way[axis]));
            first_of_ball = std::min(first_of_ball, (room_ahead - radius) / std::abs(way[axis]));
            nearest = std::min({nearest, from[axis], size[axis] - from[axis]});
        }
        const Vector r = at + Vector{static_cast<scalar>(from[0]), static_cast<scalar>(from[1]), static_cast<scalar>(from[2])};
        const Vector d = {static_cast<scalar>(way[0]), static_cast<scalar>(way[1]), static_cast<scalar>(way[2])};
        const ingot::QueryHit ray = world.cast_ray(r, d).value;
        EXPECT_NEAR(ray.fraction, first, 1e-5);
        EXPECT_EQ(ray.body == level, first < 1);
        const ingot::PlacedShape ball = {ingot::Sphere{static_cast<scalar>(radius)}, r, ingot::identity_matrix<scalar>(), nullptr};
        EXPECT_NEAR(world.cast_shape(ball, d).value.fraction, first_of_ball, 2e-3);
        EXPECT_NEAR(world.find_nearest(r, 10).value.distance, nearest, 1e-5);
        const ingot::PlacedShape large = {ingot::Sphere{static_cast<scalar>(nearest + 0.01)}, r, ingot::identity_matrix<scalar>(), nullptr};
        const ingot::PlacedShape small = {ingot::Sphere{static_cast<scalar>(nearest - 0.01)}, r, ingot::identity_matrix<scalar>(), nullptr};
        BodyId found[2];
        EXPECT_EQ(world.find_overlaps(large, found, 2).value, 1);
        EXPECT_EQ(world.find_overlaps(small, found, 2).value, 0);
    }
}

/// What lies on one level moves as it does beside whatever else lies on it, to the bit.
TEST(OnTriangles, bodies_move_alone_as_in_company) {
    for (int draw = 0; draw < ingot_reference::draws(16); ++draw) {
        Random random(static_cast<uint64_t>(800 + draw));
        const Ground ground = plane_of(random, Seams::grid);
        BodyDef one = goer(random, static_cast<Goer>(draw % goers_count), scalar(0.3), 2);
        one.state.r_CM = one.state.r_CM + ground.middle;
        auto& alone = empty_world<OnLevel>();
        add_level(alone, ground.view);
        const BodyId a = alone.add(one).value;
        static World<OnLevel> company;
        std::memset(static_cast<void*>(&company), 0, sizeof company);
        (void)company.set_gravity({0, 0, scalar(-9.81)});
        add_level(company, ground.view);
        BodyId b{};
        for (int i = 0; i < 9; ++i) {
            BodyDef other = goer(random, static_cast<Goer>(between(random, 0, goers_count - 1)), scalar(0.2), 3);
            const Vector away = {static_cast<scalar>(12 * (i % 3) - 12), static_cast<scalar>(12 * (i / 3) - 12), 1};
            other.state.r_CM = other.state.r_CM + ground.middle + away;
            if (i == 4)
                b = company.add(one).value;
            else
                ASSERT_TRUE(company.add(other).ok());
        }
        for (int i = 0; i < 90; ++i) {
            (void)ingot::step(alone, scalar(1) / 60);
            (void)ingot::step(company, scalar(1) / 60);
            const ingot::BodyState as = alone.state(a).value, is = company.state(b).value;
            ASSERT_EQ(std::memcmp(&as, &is, sizeof as), 0) << "draw " << draw << ", step " << i;
        }
    }
}

/// Twice as large, on a level twice as large: the same bits, with lengths of another exponent.
struct TwiceAsLarge : OnLevel {
    static constexpr scalar length_unit = 2;
    static inline LevelTable levels[2] = {};
};
TEST(OnTriangles, worlds_twice_as_large_go_the_same_way) {
    for (int draw = 0; draw < ingot_reference::draws(16); ++draw) {
        Random random(static_cast<uint64_t>(900 + draw));
        const Ground room = room_of(random);
        auto& one = empty_world<OnLevel>();
        auto& two = empty_world<TwiceAsLarge>();
        (void)two.set_gravity({0, 0, scalar(-2 * 9.81)});
        add_level(one, room.view);
        add_level(two, twice(room.view));
        std::vector<BodyId> a, b;
        for (int i = 0; i < 4; ++i) {
            BodyDef def = goer(random, static_cast<Goer>(i), scalar(0.3), 3);
            def.state.r_CM = {static_cast<scalar>(1 + 1.25 * i), 2, 1};
            a.push_back(one.add(def).value);
            b.push_back(two.add(twice(def)).value);
        }
        EXPECT_EQ(parts_in_step(one, two, a, b, 90), 0) << "draw " << draw;
    }
}

}  // namespace
