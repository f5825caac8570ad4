// SPDX-License-Identifier: MIT
// Grounds of the page that lie in the module as tables: hills with a pond of ice, and stairs with a ramp.
#pragma once

#include <ingot/ingot.h>
#include <ingot/level/height_field_of.h>
#include <ingot/level/mesh_of.h>

namespace viewer {

using ingot::scalar;
using ingot::Vector;

inline constexpr int hills_side = 25;
inline constexpr scalar hills_spacing = 1;
struct HillsOf {
    uint16_t heights[hills_side * hills_side];        ///< in steps of 1/64 m
    uint8_t cells[(hills_side - 1) * (hills_side - 1)];  ///< 1: ice
};
/// A bowl with waves in it, so that nothing rolls away; one quarter of it is ice.
constexpr HillsOf hills_of() {
    HillsOf of = {};
    constexpr int middle = hills_side / 2;
    // A wave of eight metres, in 1/64 m: parabolas up and down, which meet with one slope.
    constexpr auto wave = [](int x) {
        const int t = (x % 8 + 8) % 8, s = t % 4;
        return (t < 4 ? 1 : -1) * 10 * s * (4 - s);
    };
    for (int i = 0; i < hills_side * hills_side; ++i) {
        const int x = i % hills_side - middle, y = i / hills_side - middle;
        of.heights[i] = static_cast<uint16_t>(2 * (x * x + y * y) + 120 + wave(x + 2) + wave(y + y / 3));
    }
    for (int i = 0; i < (hills_side - 1) * (hills_side - 1); ++i) {
        const int x = i % (hills_side - 1) - middle, y = i / (hills_side - 1) - middle;
        of.cells[i] = x >= 0 && y < 0 ? 1 : 0;
    }
    return of;
}
inline constexpr HillsOf samples_of_hills = hills_of();
inline constexpr ingot::LevelMaterial materials_of_hills[] = {{scalar(0.7), 0}, {scalar(0.02), 0}};  // grass, ice
inline constexpr auto hills = ingot::height_field_of<hills_side, hills_side>(samples_of_hills.heights, hills_spacing, hills_spacing, scalar(1) / 64,
                                                                             {samples_of_hills.cells, false, {-hills_side / 2, -hills_side / 2, 0}});
static_assert(hills.ok());

/// Stairs up, along -x, a landing, and a ramp down: a line in the plane of x and z, drawn out along y, with walls below it.
inline constexpr int tread_count = 8, profile_count = 2 * tread_count + 3;
struct StairsOf {
    Vector corners[4 * profile_count];
    ingot::LevelFace faces[6 * (profile_count - 1)];
};
constexpr StairsOf stairs_of() {
    constexpr scalar rise = scalar(0.15625), tread = scalar(0.28125), landing = 2, ramp = 3, low_y = 1, high_y = 6;
    StairsOf of = {};
    scalar x = tread * tread_count + landing / 2, z = 0;
    for (int i = 0; i < profile_count; ++i) {
        for (int side = 0; side < 2; ++side) {
            const scalar y = side == 0 ? low_y : high_y;
            of.corners[4 * i + side] = {x, y, z};
            of.corners[4 * i + 2 + side] = {x, y, 0};
        }
        if (i >= 2 * tread_count) x -= i == 2 * tread_count ? landing : ramp;
        else if (i % 2 == 0) z += rise;
        else x -= tread;
        if (i + 2 == profile_count) z = 0;
    }
    for (int i = 0; i + 1 < profile_count; ++i) {
        const int a = 4 * i, b = a + 4;
        const ingot::LevelFace six[] = {{a, a + 1, b + 1}, {a, b + 1, b},         {a, b, b + 2},
                                        {a, b + 2, a + 2}, {a + 1, b + 3, b + 1}, {a + 1, a + 3, b + 3}};
        for (int n = 0; n < 6; ++n) of.faces[6 * i + n] = six[n];
    }
    return of;
}
inline constexpr StairsOf parts_of_stairs = stairs_of();
inline constexpr auto built_stairs = ingot::mesh_of(parts_of_stairs.corners, parts_of_stairs.faces);
static_assert(built_stairs.ok());
inline constexpr auto stairs = ingot::trimmed<built_stairs>();

}  // namespace viewer
