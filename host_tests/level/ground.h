// SPDX-License-Identifier: MIT
// Bodies and ground drawn at random, the same over a level and over a half space.
#pragma once

#include <ingot/ingot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "fields.h"

namespace level_test {

using ingot::BodyDef;
using ingot::BodyId;
using ingot::LevelDef;
using ingot::LevelTable;
using ingot::Matrix;
using ingot::scalar;
using ingot::Status;
using ingot::Vector;
using ingot::World;

constexpr double pi = 3.14159265358979;

inline double share(Random& random) { return static_cast<double>(random() % 1048576) / 1048576; }
inline double within(Random& random, double low, double high) { return low + (high - low) * share(random); }
/// Even in its logarithm.
inline double about(Random& random, double low, double high) { return low * std::pow(high / low, share(random)); }

inline Matrix about_z(double angle) {
    const auto c = static_cast<scalar>(std::cos(angle)), s = static_cast<scalar>(std::sin(angle));
    return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
}
/// Its third axis lies along the ground, across the way of `angle`.
inline Matrix lying_across(double angle) {
    const auto c = static_cast<scalar>(std::cos(angle)), s = static_cast<scalar>(std::sin(angle));
    return {{c, s, 0}, {0, 0, 1}, {s, -c, 0}};
}
/// A rotation by any angle about any axis.
inline Matrix any_rotation(Random& random) {
    const Matrix turn = about_z(within(random, 0, 2 * pi)), tilt = lying_across(within(random, 0, 2 * pi));
    return ingot::nearest_rotation(turn * tilt * about_z(within(random, 0, 2 * pi)));
}

constexpr auto pebble_hull = ingot::convex_hull<10>({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0.7f, 0.7f, -0.5f}, {-0.7f, 0.7f, -0.5f},
                                                {0.7f, -0.7f, -0.5f}, {-0.7f, -0.7f, -0.5f}, {0.3f, 0, 0.6f}, {-0.3f, 0.1f, 0.6f}});
static_assert(pebble_hull.ok());
constexpr auto pebble_mass = ingot::principal(ingot::solid_hull(1000, pebble_hull.value.view()).value);
constexpr auto pebble_of_body = ingot::convex_hull_of_body<10>(
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0.7f, 0.7f, -0.5f}, {-0.7f, 0.7f, -0.5f}, {0.7f, -0.7f, -0.5f}, {-0.7f, -0.7f, -0.5f},
     {0.3f, 0, 0.6f}, {-0.3f, 0.1f, 0.6f}},
    pebble_mass.value);
static_assert(pebble_of_body.ok());

/// 2 m wide.
constexpr auto cube_hull =
    ingot::convex_hull<8>({{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}});
static_assert(cube_hull.ok());

struct Slab : ingot::Scene {
    static constexpr int max_bodies = 80;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 400;
    static constexpr bool reads_contacts = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::Capsule, ingot::Cylinder, ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {pebble_of_body.value.view(), cube_hull.value.view()};
};
/// Its level is whatever the test has drawn.
struct OnLevel : Slab {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::Capsule, ingot::Cylinder, ingot::Hull, ingot::HalfSpace, ingot::Level>;
    static inline LevelTable levels[2] = {};
};

/// Ground with its arrays; `view` points into them.
struct Ground {
    level_tool::MeshData mesh;
    Field field;
    LevelTable view;
    Vector middle{};    ///< m, on the ground
    double reach = 0;   ///< m, from there to its rim
};

inline void take_mesh(const Soup& soup, double step, Ground& ground) {
    ground.mesh = built(soup, static_cast<scalar>(step));
    ground.view = ground.mesh.view;
}

/// Ways in which a plane may be cut up.
enum class Seams { grid, fan, slivers, boxes, field };
constexpr int seams_count = 5;

/// Boxes of all sizes side by side, as high as each other: seams with T-joints, and walls between them that no one can touch.
inline int add_flush_boxes(Random& random, int side, int rows, int height, Soup& soup) {
    int y = 0;
    for (int row = 0; row < rows; ++row) {
        const int depth = side / 2 + between(random, 0, side - 1);
        for (int column = 0, x = 0; column < rows; ++column) {
            const int length = side / 2 + between(random, 0, side - 1);
            add_box(soup, {x, y, 0}, {x + length, y + depth, height}, 0);
            x += length;
        }
        y += depth;
    }
    return y;
}

/// A level plane that is cut up like that.
inline Ground plane_of(Random& random, Seams seams) {
    constexpr double step = 1.0 / 256;
    Ground ground;
    Soup soup;
    switch (seams) {
        case Seams::grid: {
            const int cells = between(random, 20, 80), cell = 60 * 256 / cells;
            soup = terrain(random, cells, cell, [](int, int) { return 8; });
            ground.middle = {30, 30, 8 * step};
            ground.reach = 18;
            break;
        }
        case Seams::fan:
            soup = slivers(100, true);
            ground.middle = {50, 18, 8 * step};
            ground.reach = 12;
            break;
        case Seams::slivers:
            soup = slivers(60, false);
            ground.middle = {30, 20, 8 * step};
            ground.reach = 12;
            break;
        case Seams::boxes: {
            const int side = between(random, 40, 440), across = add_flush_boxes(random, side, 24, 512, soup);
            ground.middle = {static_cast<scalar>(across / 2 * step), static_cast<scalar>(across / 2 * step), 512 * step};
            ground.reach = across * step * 0.3;
            break;
        }
        case Seams::field: {
            ground.field = field(random, 60, 36, random() % 2 == 0, 0, [](int, int) { return 40; });
            ground.view = ground.field.view;
            ground.middle = ground.view.middle();
            ground.middle.z = ground.view.origin.z + 40 * ground.view.step;
            ground.reach = 16;
            return ground;
        }
    }
    take_mesh(soup, step, ground);
    return ground;
}

/// A closed room, so many meters wide, seen from inside; each side cut into cells of its own. One corner is the origin.
inline Ground room_of(Random& random, const std::array<int, 3>& wide = {6, 5, 4}) {
    Soup soup;
    const int size[3] = {wide[0] * 256, wide[1] * 256, wide[2] * 256};
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3, cells = between(random, 1, 6);
        const auto point = [&](int i, int k) {
            int p[3] = {};
            p[axis] = (side % 2) * size[axis];
            p[u] = size[u] * i / cells;
            p[v] = size[v] * k / cells;
            soup.points.push_back({static_cast<uint16_t>(p[0]), static_cast<uint16_t>(p[1]), static_cast<uint16_t>(p[2])});
            return static_cast<int>(soup.points.size()) - 1;
        };
        for (int i = 0; i < cells; ++i)
            for (int k = 0; k < cells; ++k) {
                const int a = point(i, k), b = point(i + 1, k), c = point(i + 1, k + 1), d = point(i, k + 1);
                if (side % 2 == 0) {
                    soup.faces.push_back({a, b, c});
                    soup.faces.push_back({a, c, d});
                } else {
                    soup.faces.push_back({a, c, b});
                    soup.faces.push_back({a, d, c});
                }
            }
    }
    Ground ground;
    take_mesh(soup, 1.0 / 256, ground);
    ground.middle = {static_cast<scalar>(0.5 * wide[0]), static_cast<scalar>(0.5 * wide[1]), static_cast<scalar>(0.5 * wide[2])};
    return ground;
}

/// A body that goes over the ground at this speed: rolling, or sliding with friction. Its lowest point is at the origin.
enum class Goer { ball, box, wheel, roller, coin, pebble };
constexpr int goers_count = 6;

inline BodyDef goer(Random& random, Goer kind, scalar size, double speed) {
    const double way = within(random, 0, 2 * pi);
    const Vector v = {static_cast<scalar>(speed * std::cos(way)), static_cast<scalar>(speed * std::sin(way)), 0};
    BodyDef def;
    def.friction = scalar(0.3);
    Matrix A = about_z(within(random, 0, 2 * pi));
    Vector omega{};
    scalar height = size;
    const auto rolls = [&] { omega = cross(Vector{0, 0, 1}, v) * (1 / size); };
    const auto with_mass = [&def](const ingot::MassDistribution& mass) { def.mass = ingot::principal(mass).value; };
    switch (kind) {
        case Goer::ball:
            def.shape = ingot::Sphere{size};
            with_mass(ingot::solid_sphere(1000, size));
            rolls();
            break;
        case Goer::box: {
            const Vector half = {size * static_cast<scalar>(within(random, 1, 2)), size * static_cast<scalar>(within(random, 1, 2)), size};
            def.shape = ingot::Box{half};
            with_mass(ingot::solid_box(1000, half));
            break;
        }
        case Goer::wheel: {
            const scalar half = size * static_cast<scalar>(within(random, 0.3, 1.3));
            def.shape = ingot::Cylinder{size, half};
            with_mass(ingot::solid_cylinder(1000, size, half));
            A = lying_across(way);
            rolls();
            break;
        }
        case Goer::roller: {
            const scalar half = size * static_cast<scalar>(within(random, 0.3, 2.3));
            def.shape = ingot::Capsule{size, half};
            with_mass(ingot::solid_capsule(1000, size, half));
            A = lying_across(way);
            rolls();
            break;
        }
        case Goer::coin:
            height = size * static_cast<scalar>(within(random, 0.2, 0.5));
            def.shape = ingot::Cylinder{size, height};
            with_mass(ingot::solid_cylinder(1000, size, height));
            break;
        case Goer::pebble:
            def.shape = ingot::hull_of<Slab>(0);
            def.mass = pebble_mass.value;
            height = 0;
            for (int i = 0; i < Slab::hulls[0].vertex_count; ++i) height = std::max(height, -Slab::hulls[0].vertices[i].z);
            break;
    }
    def.state = ingot::body_state(def.mass, {{0, 0, height}, A}, {v, omega});
    if (kind == Goer::pebble) {  // its axes are those of the hull
        def.state.A = A;
        def.state.r_CM = {0, 0, height};
    }
    return def;
}

template <class S>
World<S>& empty_world() {
    static World<S> world;
    std::memset(static_cast<void*>(&world), 0, sizeof world);
    (void)world.set_gravity({0, 0, scalar(-9.81)});
    return world;
}

/// Of half of all levels, by their checksums, slots before them are free: bodies that come later have these, and are first in pairs with them.
template <class S>
BodyId add_level(World<S>& world, const LevelTable& table, scalar friction = scalar(0.3), const Vector& r = {}) {
    S::levels[0] = table;
    std::vector<BodyId> before;
    const int room = std::min(16, S::max_bodies - ingot::bodies_of_level<S>);
    while (table.checksum % 2 == 1 && static_cast<int>(before.size()) < room) {
        BodyDef place;
        place.immovable = true;
        before.push_back(world.add(place).value);
    }
    LevelDef def;
    def.friction = friction;
    def.r = r;
    const BodyId id = world.add_level(def).value;
    for (const BodyId place : before) (void)world.remove(place);
    return id;
}

/// How a body went: beside where it began, m, and what contacts gave along z, N s.
struct Went {
    Vector by{}, v{};
    double hop = 0, sink = 0, impulse = 0;
    int lost = 0;
};

/// One that goes for so many steps. (No further than the ground.)
template <class S>
Went go(World<S>& world, const BodyDef& def, int rate, int steps) {
    const BodyId id = world.add(def).value;
    Went went;
    for (int i = 0; i < steps; ++i) {
        const ingot::StepReport report = ingot::step(world, 1 / static_cast<scalar>(rate));
        const double height = static_cast<double>(world.state(id).value.r_CM.z - def.state.r_CM.z);
        went.hop = std::max(went.hop, height);
        went.sink = std::max(went.sink, -height);
        went.lost += report.contacts_lost;
        for (const ingot::ContactInfo& contact : world.contacts()) went.impulse += static_cast<double>(contact.j * std::abs(contact.n.z));
    }
    went.by = world.state(id).value.r_CM - def.state.r_CM;
    went.v = world.state(id).value.v_CM;
    return went;
}

/// The same over a half space, of the friction that bodies have.
inline Went go_on_slab(scalar height, const BodyDef& def, int rate, int steps) {
    auto& world = empty_world<Slab>();
    BodyDef slab;
    slab.immovable = true;
    slab.friction = scalar(0.3);
    slab.shape = ingot::HalfSpace{{0, 0, 1}, height};
    (void)world.add(slab);
    return go(world, def, rate, steps);
}
inline double length(const Vector& v) { return std::sqrt(static_cast<double>(length_sq(v))); }

// The same twice as large and twice as fast: in worlds of length_unit 2 it goes the same way.
inline LevelTable twice(LevelTable level) {
    level.step *= 2;
    level.low = level.low * 2;
    level.high = level.high * 2;
    level.origin = level.origin * 2;
    return level;
}
/// As heavy as before.
inline BodyDef twice(BodyDef def) {
    def.shape.size = def.shape.size * 2;
    def.mass.I_body = def.mass.I_body * 4;
    def.state.r_CM = def.state.r_CM * 2;
    def.state.v_CM = def.state.v_CM * 2;
    def.state.L = def.state.L * 4;
    return def;
}
/// Steps both, and says in which step, counted from 1, bodies are not at the same places to the bit; 0: in none.
template <class S, class Large>
int parts_in_step(World<S>& one, World<Large>& two, const std::vector<BodyId>& bodies, const std::vector<BodyId>& large, int steps) {
    for (int i = 1; i <= steps; ++i) {
        (void)ingot::step(one, scalar(1) / 60);
        (void)ingot::step(two, scalar(1) / 60);
        for (size_t k = 0; k < bodies.size(); ++k) {
            const Vector r = one.state(bodies[k]).value.r_CM * 2, R = two.state(large[k]).value.r_CM;
            if (!(r.x == R.x && r.y == R.y && r.z == R.z)) return i;
        }
    }
    return 0;
}

}  // namespace level_test
