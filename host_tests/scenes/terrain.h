// SPDX-License-Identifier: MIT
// A ground of tables in flash: a field of heights with a mesh of steps across a seam, and bodies that roll, slide and come to rest on them.
#pragma once

#include <ingot/level/height_field_of.h>
#include <ingot/level/mesh_of.h>

#include "stacked.h"

namespace scenes {

/// Hills in whole steps of 1/32 m, nine samples by nine, a metre apart.
struct Hills {
    static constexpr int side = 9;
    uint16_t heights[side * side];
};
constexpr Hills hills() {
    Hills of = {};
    for (int i = 0; i < Hills::side * Hills::side; ++i) {
        const int x = i % Hills::side - 4, y = i / Hills::side - 4;
        const int bowl = x * x + y * y, bump = (x * 5 + y * 3 + 64) % 7;  // a bowl, so that nothing rolls away, and roughness
        of.heights[i] = static_cast<uint16_t>(2 * bowl + 2 * bump);
    }
    return of;
}
inline constexpr Hills hills_of_terrain = hills();
inline constexpr auto field_of_terrain = ingot::height_field_of<9, 9>(hills_of_terrain.heights, 1, 1, ingot::scalar(1) / 32);
static_assert(field_of_terrain.ok());

/// Two steps of 1/4 m, which begin where the field ends.
constexpr ingot::Vector step_corners[] = {{0, 0, 0}, {0, 8, 0}, {1, 0, 0}, {1, 8, 0}, {1, 0, 0.25}, {1, 8, 0.25}, {2, 0, 0.25}, {2, 8, 0.25},
                                          {2, 0, 0.5}, {2, 8, 0.5}, {4, 0, 0.5}, {4, 8, 0.5}};
constexpr ingot::LevelFace step_faces[] = {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}, {4, 6, 7},
                                           {4, 7, 5}, {6, 8, 9}, {6, 9, 7}, {8, 10, 11}, {8, 11, 9}};
inline constexpr auto steps_of_terrain = ingot::mesh_of(step_corners, step_faces, ingot::scalar(1) / 64);
static_assert(steps_of_terrain.ok());

struct Terrain : Stacked<16, 24> {
    static constexpr const char* name = "terrain";
    static constexpr const char* title = "balls, boxes, a capsule and a wheel on hills and steps of tables in flash";
    static constexpr int golden_steps = 180;
    static constexpr bool sleeps = true;
    static constexpr ingot::LevelTable levels[] = {field_of_terrain.value.view(), steps_of_terrain.value.view()};
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::Level>;
    static bool went_well(ingot::StepReport report) { return well_but_for_impacts(report); }
    static constexpr int body_count = 6;

    static constexpr PlacedBody body(int body_i) {
        const scalar mu = scalar(0.6), third = scalar(0.3);
        const Vector at = {body_i % 3 == 2 ? scalar(9.25) : scalar(2 * (body_i % 3)) + 3, scalar(2 * (body_i / 3)) + 3, 3};
        PlacedBody body = body_i % 2 == 0 ? solid_ball(1, third, at, mu, scalar(0.25)) : solid_box(2, {third, third, scalar(0.2)}, at, mu);
        if (body_i == 4) body.def.shape = ingot::Capsule{scalar(0.2), third};
        if (body_i == 5) body.def.shape = ingot::Cylinder{third, scalar(0.2)};
        body.turn(scattered_rotation(body_i));
        body.move({body_i % 3 == 2 ? scalar(-1) : scalar(body_i % 3) - scalar(0.5), scalar(0.5), 0}, {1, scalar(body_i), 0});
        return body;
    }
};
inline ingot::Status set_up(ingot::World<Terrain>& world) {
    ingot::Status status = world.set_gravity({0, 0, -standard_gravity});
    for (int level_i = 0; level_i < 2; ++level_i) {
        ingot::LevelDef def;
        def.number = level_i;
        def.friction = scalar(0.6);
        if (level_i == 1) def.r = {8, 0, 0};
        if (status == ingot::Status::ok) status = world.add_level(def).status;
    }
    for (int body_i = 0; body_i < Terrain::body_count; ++body_i) {
        PlacedBody body = Terrain::body(body_i);
        body.def.friction = body.mu;
        if (status == ingot::Status::ok) status = world.add(body.def).status;
    }
    return status;
}

}  // namespace scenes
