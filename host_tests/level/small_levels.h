// SPDX-License-Identifier: MIT
// A roof and a hill, by the compiler; fixtures/ has the same for the tool.
#pragma once

#include <ingot/level/byte_heights_of.h>
#include <ingot/level/height_field_of.h>
#include <ingot/level/mesh_of.h>

namespace level_test {

constexpr ingot::Vector roof_corners[] = {{0, 0, 0}, {4, 0, 0}, {4, 6, 0}, {0, 6, 0}, {0, 3, 2}, {4, 3, 2}};
constexpr ingot::LevelFace roof_faces[] = {{0, 1, 5, 3}, {0, 5, 4, 3}, {4, 5, 2, 4}, {4, 2, 3, 4}, {0, 4, 3, 0}, {1, 2, 5, 0}, {0, 0, 1, 0}};
inline constexpr auto roof_built = ingot::mesh_of(roof_corners, roof_faces);
static_assert(roof_built.ok() && roof_built.value.without_area == 1 && roof_built.value.triangle_count == 6 && roof_built.value.corner_count == 6);
inline constexpr auto roof = ingot::trimmed<roof_built>();
static_assert(sizeof roof.corners == 6 * 6 && sizeof roof.triangles == 6 * 8 && sizeof roof.nodes == 38);

inline constexpr uint16_t hill_samples[] = {0, 4, 8, 9, 4, 0, 4, 9};
inline constexpr auto hill = ingot::height_field_of<4, 2>(hill_samples, 1, 1, ingot::scalar(1) / 64);
static_assert(hill.ok() && hill.value.extremes[0] == 0 && hill.value.extremes[1] == 9);

inline constexpr auto byte_hill = ingot::byte_heights_of<4, 2>(hill_samples, 1, 1, ingot::scalar(1) / 64);
static_assert(byte_hill.ok() && byte_hill.value.furthest == 0 && sizeof byte_hill.value.bytes == 8 && sizeof byte_hill.value.blocks == 4);

inline constexpr ingot::LevelTable small_levels[] = {roof.view(), hill.value.view(), byte_hill.value.view()};

}  // namespace level_test
