// SPDX-License-Identifier: MIT
// A world holds what its scene names and not a byte more, for every lane count: sizes counted by hand, row by row.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include "scenes/all_scenes.h"

namespace {

using ingot::lanes;
using ingot::scalar;

constexpr size_t rounded_up(size_t bytes, size_t alignment) { return (bytes + alignment - 1) / alignment * alignment; }

// Rows of `lanes` numbers, and two bytes a tile for each set of marks; a tile is as wide as the vectors it is loaded into.
constexpr size_t row = sizeof(scalar) * lanes;
constexpr size_t mark = 2;
constexpr size_t rotation_tile = rounded_up((9 + 3 + 3 + 3 + 1) * row + 2 * mark, row);          // A L tau_T ratio scale
constexpr size_t compensation_tile = 9 * row;                                                     // A_low
constexpr size_t energy_tile = 1 * row;                                                           // E_0
constexpr size_t translation_tile = rounded_up((3 + 3 + 3 + 1 + 6) * row + mark, row);            // r_CM v_CM F_T inv_M inv_I_world

static_assert(sizeof(ingot::RotationTile) == rotation_tile);
static_assert(sizeof(ingot::CompensationTile) == compensation_tile);
static_assert(sizeof(ingot::EnergyTile) == energy_tile);
static_assert(sizeof(ingot::TranslationTile) == translation_tile);

// What every world has once: steps, slots_used, free_hint, world_tag. And once a body: its generation.
constexpr size_t counters = 3 * 4 + 2;
constexpr size_t a_generation = 4;

// The parts lie one behind the other, each aligned; so does the whole.
constexpr size_t bookkeeping(size_t bodies) { return bodies * a_generation + counters; }
constexpr size_t energy_part = rounded_up(energy_tile + sizeof(scalar), row);  // h_1 fills the tile's last row

template <class S>
constexpr size_t world_bytes = sizeof(ingot::World<S>);

// One body that turns, with the default method: no r_CM, v_CM, F_T, inv_M, gravity, shapes or contacts.
constexpr size_t one_turning_body = rounded_up(compensation_tile + energy_part + rotation_tile + bookkeeping(1), row);
static_assert(world_bytes<scenes::Satellite> == one_turning_body);
static_assert(world_bytes<scenes::THandle> == one_turning_body);

/// Adds nothing to the satellite but a place.
struct MovingSatellite : scenes::Satellite {
    static constexpr bool translates = true;
};
static_assert(world_bytes<MovingSatellite> > one_turning_body);
static_assert(world_bytes<MovingSatellite> <= one_turning_body + translation_tile + sizeof(ingot::Vector) + row, "and gravity");

/// The satellite with a method that keeps nothing beside A.
struct Listing1Satellite : scenes::Satellite {
    using rotation = ingot::Listing1Euler;
};
static_assert(world_bytes<Listing1Satellite> == rounded_up(rotation_tile + bookkeeping(1), row));

/// Bodies that turn: only tiles and generations grow with their number.
template <int bodies>
struct Turning : ingot::Scene {
    static constexpr int max_bodies = bodies;
    using rotation = ingot::Listing1Euler;
};
constexpr size_t tiles(size_t bodies) { return (bodies + lanes - 1) / lanes; }
static_assert(world_bytes<Turning<100>> == rounded_up(tiles(100) * rotation_tile + bookkeeping(100), row));
static_assert(world_bytes<Turning<1000>> == rounded_up(tiles(1000) * rotation_tile + bookkeeping(1000), row));

TEST(WorldSize, what_a_scene_does_not_name_takes_no_byte) {
    RecordProperty("satellite_bytes", static_cast<int>(world_bytes<scenes::Satellite>));
    EXPECT_EQ(world_bytes<scenes::Satellite>, one_turning_body);
    EXPECT_EQ(world_bytes<Listing1Satellite>, one_turning_body - compensation_tile - energy_part);
}

}  // namespace
