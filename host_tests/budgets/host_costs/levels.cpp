// SPDX-License-Identifier: MIT
// What ground of triangles costs beside a slab: 64 boxes that slide over it, and a pile of 512 boxes and balls that falls on it.
#include "levels.h"

#include <algorithm>
#include <cstring>

#include "counted.h"
#include "level/fields.h"

namespace {

using host_costs::expect;
using ingot::LevelTable;
using ingot::scalar;
using ingot::Vector;

constexpr int cells = 95;        // along each side, of a metre: 18,050 triangles
constexpr int grain = 64;        // of the lattice, in a metre
const scalar smooth = scalar(0.05), rough = scalar(0.6);

struct OnSlab : ingot::Scene {
    static constexpr int max_bodies = 516, max_manifolds = 4000, max_pairs = 20000;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::Level>;
    using broad_phase = ingot::SortedTree;
    static inline LevelTable levels[1] = {};
};

constexpr int ground_height = 4 * grain;  // of the lattice

void add_mesh(ingot::World<OnSlab>& world) {
    static level_tool::MeshData mesh;
    level_test::Random random(1);
    const level_test::Soup soup = level_test::terrain(random, cells, grain, [](int, int) { return ground_height; });
    expect(level_tool::build_mesh(soup.points, soup.faces, {0, 0, 0}, scalar(1) / grain, mesh) == ingot::Status::ok, "there is no mesh");
    OnSlab::levels[0] = mesh.view;
    ingot::LevelDef def;
    def.friction = smooth;
    expect(world.add_level(def).ok(), "a mesh was refused");
}
void add_field(ingot::World<OnSlab>& world) {
    static level_test::Field field;
    field.heights.assign((cells + 1) * (cells + 1), ground_height);
    field.view.heights.spacing_x = field.view.heights.spacing_y = 1;
    field.view.step = scalar(1) / grain;
    level_tool::finish_heights(field, cells + 1, cells + 1);
    OnSlab::levels[0] = field.view;
    ingot::LevelDef def;
    def.friction = smooth;
    expect(world.add_level(def).ok(), "a field was refused");
}
void add_slab(ingot::World<OnSlab>& world) {
    ingot::BodyDef slab;
    slab.immovable = true;
    slab.shape = ingot::Box{{scalar(cells) / 2, scalar(cells) / 2, 2}};
    slab.state.r_CM = {scalar(cells) / 2, scalar(cells) / 2, 2};
    slab.friction = smooth;
    expect(world.add(slab).ok(), "a slab was refused");
}

void begin(ingot::World<OnSlab>& world, const char* ground) {
    expect(world.set_gravity({0, 0, -scenes::standard_gravity}) == ingot::Status::ok, "gravity was refused");
    if (std::strcmp(ground, "mesh") == 0) add_mesh(world);
    else if (std::strcmp(ground, "field") == 0) add_field(world);
    else add_slab(world);
}

/// Each slides by itself, at 3 m/s to begin with, over a cell of a metre and its neighbours.
void sliding_boxes(const char* ground) {
    static ingot::World<OnSlab> world;
    begin(world, ground);
    const scalar half = scalar(0.25);
    for (int i = 0; i < 64; ++i) {
        scenes::PlacedBody box = scenes::solid_box(10, {half, half, half}, {scalar(8 + 10 * (i % 8)), scalar(8 + 10 * (i / 8)), 4 + half}, smooth);
        box.move({3, scalar(0.1) * scalar(i % 8), 0}, {});
        (void)host_costs::add(world, box);
    }
    host_costs::measure(world, 5, 60);
}

/// Layers of boxes and balls, 8 by 8, that fall on the ground and spread over it: one pile of several, which differ by centimetres.
void pile(ingot::World<OnSlab>& world, int pile_i) {
    const scalar half = scalar(0.25);
    for (int i = 0; i < 512; ++i) {
        const scalar shift = scalar(0.03) * scalar((i + pile_i) % 7) + scalar(0.01) * scalar(i % 5);
        const Vector at = {scalar(40) + scalar(0.6) * scalar(i % 8) + shift, scalar(40) + scalar(0.6) * scalar(i / 8 % 8) - shift,
                           scalar(4.5) + scalar(0.6) * scalar(i / 64)};
        (void)host_costs::add(world, i % 2 == 0 ? scenes::solid_box(10, {half, half, half}, at, rough) : scenes::solid_ball(10, half, at, rough));
    }
    host_costs::measure(world, 180, 30);
}

/// How many sweeps one of its islands asks for is chance (16 or 250): of a single pile on a mesh a step took 1.10 to 1.43 of one on a slab, with the
/// way of the spread. So it is the median step of seven.
void piles(const char* ground) {
    static const ingot::World<OnSlab> empty;
    static ingot::World<OnSlab> world;
    for (int pile_i = 0; pile_i < 7; ++pile_i) {
        world = empty;
        begin(world, ground);
        pile(world, pile_i);
    }
}

}  // namespace

bool stand_on_levels(const char* name) {
    for (const char* ground : {"slab", "mesh", "field"}) {
        const std::size_t prefix = std::strlen(name) - std::min(std::strlen(name), std::strlen(ground));
        if (std::strcmp(name + prefix, ground) != 0) continue;
        if (std::strncmp(name, "sliding_boxes_on_", prefix) == 0) return sliding_boxes(ground), true;
        if (std::strncmp(name, "pile_512_on_", prefix) == 0) return piles(ground), true;
    }
    return false;
}
