// SPDX-License-Identifier: MIT
// Levels with `continuous`: nothing gets through a sheet of triangles, at any speed, and it comes off as off planes.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

#include "ground.h"
#include "reference/draws.h"

namespace {

using namespace level_test;

struct Fast : OnLevel {
    static constexpr bool continuous = true;
    static inline LevelTable levels[2] = {};
};

constexpr double g = 9.81;

/// Of any shape that can be thrown, plates of a centimetre too; restitution as its ground has it.
BodyDef thrown(Random& random, scalar restitution) {
    const int kind = between(random, 0, goers_count);
    const double size = about(random, 0.03, 0.4);
    BodyDef def = goer(random, kind < goers_count ? static_cast<Goer>(kind) : Goer::box, static_cast<scalar>(size), 0);
    if (kind == goers_count) {
        const Vector half = {static_cast<scalar>(size), static_cast<scalar>(size), static_cast<scalar>(about(random, 0.005, 0.03))};
        def.shape = ingot::Box{half};
        def.mass = ingot::principal(ingot::solid_box(1000, half)).value;
    }
    def.restitution = restitution;
    return def;
}
void throw_at(Random& random, const Vector& r, const Vector& v, BodyDef& def) {
    const Vector omega = any_rotation(random) * Vector{static_cast<scalar>(random() % 2 == 0 ? 0 : about(random, 0.1, 100)), 0, 0};
    def.state = ingot::body_state(def.mass, {r, any_rotation(random)}, {v, omega});
}

double energy_of(const World<Fast>& world, BodyId id) {
    return static_cast<double>(world.kinetic_energy()) + g * static_cast<double>(world.mass(id).value * world.state(id).value.r_CM.z);
}
double least_half_extent_of(const BodyDef& def) {
    return static_cast<double>(ingot::least_half_extent(def.shape, def.shape.kind == ingot::ShapeKind::hull ? Slab::hulls : nullptr));
}
/// J; by pushing out of a skin a step lifts as much, see limits::skin_share, and out of those of three walls that meet in a corner below by the
/// diagonal of a cube of that. And roundings of what moves.
double gain_allowed(const BodyDef& def, double energy) {
    return std::sqrt(3.0) * static_cast<double>(def.mass.M * ingot::limits::skin_share) * g * least_half_extent_of(def) + 1e-5 * std::abs(energy);
}

constexpr int rates[] = {30, 60, 120, 240};

/// At walls, edges and corners of rooms that are cut and tilted any way, up to 300 m/s and 100 rad/s fast.
TEST(FastOnTriangles, stay_in_rooms_and_gain_no_energy) {
    for (int draw = 0; draw < ingot_reference::draws(400); ++draw) {
        Random random(static_cast<uint64_t>(900000 + draw));
        const Ground room = room_of(random);
        auto& world = empty_world<Fast>();
        Fast::levels[0] = room.view;
        LevelDef level;
        level.friction = static_cast<scalar>(within(random, 0, 0.8));
        level.restitution = static_cast<scalar>(draw % 2 == 0 ? 0 : within(random, 0, 1));
        level.A = any_rotation(random);
        ASSERT_TRUE(world.add_level(level).ok());
        BodyDef def = thrown(random, level.restitution);
        const double sizes[3] = {6, 5, 4};
        double start[3], to[3], way = 0;
        for (int i = 0; i < 3; ++i) {
            start[i] = within(random, 1.3, sizes[i] - 1.3);
            to[i] = random() % 2 == 0 ? within(random, 0, sizes[i]) : random() % 2 == 0 ? 0 : sizes[i];
            way += (to[i] - start[i]) * (to[i] - start[i]);
        }
        const double speed = about(random, 1, 300) / std::sqrt(way + 1e-6);
        const Vector r = {static_cast<scalar>(start[0]), static_cast<scalar>(start[1]), static_cast<scalar>(start[2])};
        const Vector aim = {static_cast<scalar>(to[0]), static_cast<scalar>(to[1]), static_cast<scalar>(to[2])};
        throw_at(random, level.A * r, level.A * ((aim - r) * static_cast<scalar>(speed)), def);
        const BodyId id = world.add(def).value;
        const int rate = rates[random() % 4];
        double before = energy_of(world, id);
        for (int i = 0; i < rate; ++i) {
            const ingot::StepReport report = ingot::step(world, 1 / static_cast<scalar>(rate));
            ASSERT_EQ(report.contacts_lost + report.bodies_frozen, 0) << "draw " << draw << ", step " << i;
            const double now = energy_of(world, id);
            ASSERT_LE(now - before, gain_allowed(def, before)) << "draw " << draw << ", step " << i << ", " << rate << " Hz";
            before = now;
            const Vector at = transpose_times(level.A, world.state(id).value.r_CM);
            ASSERT_TRUE(at.x > 0 && at.x < 6 && at.y > 0 && at.y < 5 && at.z > 0 && at.z < 4) << "draw " << draw << ", step " << i;
        }
    }
}

/// Rods, plates and discs, a few millimetres thin, at up to 10 km/s: an impact sets them spinning by hundreds of turns in a step. Walls are
/// triangles, or half spaces, which lose nobody: beyond one a centre gets no deeper than contacts bring it back from, and they do.
TEST(FastOnTriangles, thin_things_stay_in_rooms) {
    for (int draw = 0; draw < ingot_reference::draws(800); ++draw) {
        Random random(static_cast<uint64_t>(60000 + draw));
        const Ground room = room_of(random);
        auto& world = empty_world<Fast>();
        const Vector size = {6, 5, 4}, axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        if (draw % 2 == 0) add_level(world, room.view, scalar(0.5));
        for (int side = 0; draw % 2 == 1 && side < 6; ++side) {
            BodyDef wall;
            wall.immovable = true;
            wall.shape = ingot::HalfSpace{axes[side / 2] * (side % 2 == 0 ? scalar(1) : scalar(-1)), side % 2 == 0 ? 0 : -dot(axes[side / 2], size)};
            ASSERT_TRUE(world.add(wall).ok());
        }
        BodyDef def;
        const auto length = static_cast<scalar>(about(random, 0.02, 0.5));
        const int kind = draw / 2 % 3;
        if (kind == 0) {
            def.shape = ingot::Capsule{length / 5, length};
            def.mass = ingot::principal(ingot::solid_capsule(1000, length / 5, length)).value;
        } else if (kind == 1) {
            def.shape = ingot::Box{{length, length / 20, length}};
            def.mass = ingot::principal(ingot::solid_box(1000, {length, length / 20, length})).value;
        } else {
            def.shape = ingot::Cylinder{length, length / 10};
            def.mass = ingot::principal(ingot::solid_cylinder(1000, length, length / 10)).value;
        }
        def.friction = scalar(0.5);
        const Vector way = any_rotation(random) * Vector{static_cast<scalar>(about(random, 100, 10000)), 0, 0};
        def.state = ingot::body_state(def.mass, {size * scalar(0.5), any_rotation(random)}, {way, {}});
        const BodyId id = world.add(def).value;
        for (int i = 0; i < 40; ++i) {
            (void)ingot::step(world, scalar(1) / 60);
            const Vector at = world.state(id).value.r_CM;
            const scalar deep = draw % 2 == 0 ? scalar(0) : static_cast<scalar>(least_half_extent_of(def));
            ASSERT_TRUE(at.x > -deep && at.x < 6 + deep && at.y > -deep && at.y < 5 + deep && at.z > -deep && at.z < 4 + deep)
                << "draw " << draw << ", step " << i;
        }
        const Vector at = world.state(id).value.r_CM;
        ASSERT_TRUE(at.x > 0 && at.x < 6 && at.y > 0 && at.y < 5 && at.z > 0 && at.z < 4) << "draw " << draw << ", at the end";
    }
}

/// Hills of triangles, or of heights, steep and flat.
Ground hills_of(Random& random, bool is_field) {
    constexpr int n = 40;
    const int cell = between(random, 64, 400);
    const double rise = about(random, 0.05, 1.5) * cell, wave = within(random, 0.1, 1.5);
    std::vector<int> heights;
    for (int i = 0; i < (n + 1) * (n + 1); ++i) {
        const int column = i % (n + 1), row = i / (n + 1);
        const double hill = 0.7 * (std::sin(column * wave) + std::cos(0.8 * row * wave)) / wave + within(random, -0.3, 0.3);
        heights.push_back(static_cast<int>(std::max(0.0, 4000 + rise * hill)));
    }
    const auto height = [&](int column, int row) { return heights[static_cast<size_t>(row * (n + 1) + column)]; };
    Ground ground;
    if (!is_field) {
        take_mesh(terrain(random, n, cell, height), 1.0 / 256, ground);
        return ground;
    }
    ground.field = field(random, n + 1, n + 1, random() % 2 == 0, 0, height);
    ground.view = ground.field.view;
    return ground;
}

/// The height of a ground, by a ray in a world that holds nothing else.
double height_at(const World<OnLevel>& ground, const Vector& r) {
    return 200 - 400 * static_cast<double>(ground.cast_ray({r.x, r.y, 200}, {0, 0, -400}).value.fraction);
}

/// No centre gets below the ground, deeper than contacts bring it back from: its least half extent.
TEST(FastOnTriangles, stay_above_hills) {
    for (int draw = 0; draw < ingot_reference::draws(120); ++draw) {
        Random random(static_cast<uint64_t>(700000 + draw));
        const Ground ground = hills_of(random, draw % 2 == 0);
        auto& world = empty_world<Fast>();
        auto& empty = empty_world<OnLevel>();
        add_level(world, ground.view, static_cast<scalar>(within(random, 0, 1)));
        add_level(empty, ground.view);
        const Vector middle = ground.view.middle(), half = ingot::half_extents_of(ground.view);
        std::vector<BodyId> bodies;
        std::vector<double> half_extents;
        for (int i = 0; i < 5; ++i) {
            BodyDef def = thrown(random, 0);
            half_extents.push_back(least_half_extent_of(def));
            const double x = within(random, -0.6, 0.6), y = within(random, -0.6, 0.6);
            Vector r = middle + Vector{static_cast<scalar>(x) * half.x, static_cast<scalar>(y) * half.y, 0};
            r.z = static_cast<scalar>(height_at(empty, r) + within(random, 1.5, 6));
            const double speed = about(random, 0.5, 200), down = within(random, 0, 1.5);
            const Vector along = about_z(within(random, 0, 2 * pi)).c1;
            throw_at(random, r, along * static_cast<scalar>(speed * std::cos(down)) - Vector{0, 0, static_cast<scalar>(speed * std::sin(down))}, def);
            bodies.push_back(world.add(def).value);
        }
        const int rate = rates[random() % 4];
        for (int i = 0; i < 2 * rate; ++i) {
            (void)ingot::step(world, 1 / static_cast<scalar>(rate));
            for (size_t k = 0; k < bodies.size(); ++k) {
                const Vector r = world.state(bodies[k]).value.r_CM;
                if (std::abs(r.x - middle.x) > half.x - 2 || std::abs(r.y - middle.y) > half.y - 2) continue;  // over the rim, or near it
                const double height = height_at(empty, r);
                ASSERT_GE(static_cast<double>(r.z), height - half_extents[k]) << "draw " << draw << ", step " << i << ", " << rate << " Hz";
            }
        }
    }
}

/// Plates of three centimetres, as wide as the triangles, that tumble onto four of them.
TEST(FastOnTriangles, plates_do_not_fall_through_four_triangles) {
    Soup soup;
    for (const auto& corner : {std::array<int, 2>{0, 0}, {1024, 0}, {1024, 1024}, {0, 1024}, {512, 512}})
        soup.points.push_back(lattice_point(corner[0], corner[1], 8));
    for (int i = 0; i < 4; ++i) soup.faces.push_back({i, (i + 1) % 4, 4});
    Ground ground;
    take_mesh(soup, 1.0 / 256, ground);
    for (int draw = 0; draw < ingot_reference::draws(200); ++draw) {
        Random random(static_cast<uint64_t>(30000 + draw));
        auto& world = empty_world<Fast>();
        add_level(world, ground.view, static_cast<scalar>(within(random, 0, 1)));
        const Vector half = {1, scalar(0.015), 1};
        BodyDef def;
        def.shape = ingot::Box{half};
        def.mass = ingot::principal(ingot::solid_box(1000, half)).value;
        throw_at(random, {2, 2, scalar(1.6)}, {0, 0, static_cast<scalar>(-about(random, 0.1, 50))}, def);
        const BodyId id = world.add(def).value;
        const int rate = rates[random() % 4];
        for (int i = 0; i < rate; ++i) {
            (void)ingot::step(world, 1 / static_cast<scalar>(rate));
            const Vector r = world.state(id).value.r_CM;
            if (!(r.x > 1 && r.x < 3 && r.y > 1 && r.y < 3)) break;  // it tips over the rim
            ASSERT_GE(r.z, scalar(8) / 256) << "draw " << draw << ", step " << i << ", " << rate << " Hz";
        }
    }
}

/// A shot among others, and saved and loaded on its way, goes as it goes alone, to the bit.
TEST(FastOnTriangles, move_alone_as_in_company_and_from_snapshots) {
    for (int draw = 0; draw < ingot_reference::draws(24); ++draw) {
        Random random(static_cast<uint64_t>(810000 + draw));
        const Ground ground = plane_of(random, static_cast<Seams>(draw % seams_count));
        BodyDef one = thrown(random, 0);
        throw_at(random, ground.middle + Vector{0, 0, 1}, any_rotation(random) * Vector{static_cast<scalar>(about(random, 1, 10)), 0, 0}, one);
        auto& alone = empty_world<Fast>();
        add_level(alone, ground.view);
        const BodyId a = alone.add(one).value;
        static World<Fast> company, loaded;
        std::memset(static_cast<void*>(&company), 0, sizeof company);
        (void)company.set_gravity({0, 0, scalar(-g)});
        add_level(company, ground.view);
        BodyId b{};
        for (int i = 0; i < 9; ++i) {
            BodyDef other = thrown(random, 0);
            const Vector away = {static_cast<scalar>(9 * (i % 3) - 9), static_cast<scalar>(9 * (i / 3) - 9), scalar(1.5)};
            throw_at(random, ground.middle + away, any_rotation(random) * Vector{static_cast<scalar>(about(random, 0.1, 3)), 0, 0}, other);
            b = i == 4 ? company.add(one).value : b;
            if (i == 4) continue;
            ASSERT_TRUE(company.add(other).ok());
        }
        std::vector<std::uint8_t> bytes(ingot::snapshot_size<Fast>());
        for (int i = 0; i < 24; ++i) {
            (void)ingot::step(alone, scalar(1) / 60);
            if (i == 8) {
                const auto size = ingot::save_snapshot(company, bytes.data(), bytes.size());
                ASSERT_TRUE(size.ok());
                ASSERT_EQ(ingot::load_snapshot(loaded, bytes.data(), size.value), Status::ok);
            }
            (void)ingot::step(company, scalar(1) / 60);
            const ingot::BodyState as = alone.state(a).value, is = company.state(b).value;
            ASSERT_EQ(std::memcmp(&as, &is, sizeof as), 0) << "draw " << draw << ", step " << i;
            if (i < 8) continue;
            (void)ingot::step(loaded, scalar(1) / 60);
            ASSERT_EQ(loaded.state_hash(), company.state_hash()) << "draw " << draw << ", step " << i;
        }
    }
}

/// Twice as large and twice as fast, on ground twice as large: the same bits, with lengths of another exponent.
struct FastTwiceAsLarge : Fast {
    static constexpr scalar length_unit = 2;
    static inline LevelTable levels[2] = {};
};
TEST(FastOnTriangles, worlds_twice_as_large_go_the_same_way) {
    for (int draw = 0; draw < ingot_reference::draws(24); ++draw) {
        Random random(static_cast<uint64_t>(910000 + draw));
        const Ground room = room_of(random);
        auto& one = empty_world<Fast>();
        auto& two = empty_world<FastTwiceAsLarge>();
        (void)two.set_gravity({0, 0, scalar(-2 * g)});
        add_level(one, room.view);
        add_level(two, twice(room.view));
        std::vector<BodyId> a, b;
        for (int i = 0; i < 3; ++i) {
            BodyDef def = thrown(random, 0);
            if (def.shape.kind == ingot::ShapeKind::hull) continue;  // of one size
            const Vector v = any_rotation(random) * Vector{static_cast<scalar>(about(random, 1, 200)), 0, 0};
            throw_at(random, {static_cast<scalar>(1.5 + 1.5 * i), 2, 2}, v, def);
            a.push_back(one.add(def).value);
            b.push_back(two.add(twice(def)).value);
        }
        EXPECT_EQ(parts_in_step(one, two, a, b, 60), 0) << "draw " << draw;
    }
}

}  // namespace
