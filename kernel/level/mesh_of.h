// SPDX-License-Identifier: MIT
// A mesh of a few triangles as a table, by the compiler. Large ones are made by host_tests/level_tool.
//
//     constexpr ingot::Vector corners[] = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}};
//     constexpr ingot::LevelFace faces[] = {{0, 1, 2}, {0, 2, 3}};
//     static constexpr auto built = ingot::mesh_of(corners, faces);           // static storage
//     static_assert(built.ok());
//     static constexpr auto ground = ingot::trimmed<built>();                 // the same, in arrays that have no room to spare
//     static constexpr ingot::LevelTable levels[] = {ground.view()};
//
// Only what is used lies in flash: here `ground`. Compilers make 200 triangles (clang) or 800 (gcc) as they are; beyond it needs
// -fconstexpr-steps or -fconstexpr-ops-limit: 2000 triangles take some seconds.
#pragma once

#include "../base/limits.h"
#include "level_checksum.h"
#include "mesh_builder.h"

namespace ingot { inline namespace INGOT_ABI {

/// The arrays of a mesh of up to so many corners and triangles.
template <unsigned corner_room, unsigned triangle_room, unsigned node_room = meshes::node_room(triangle_room)>
struct MeshOf {
    LatticePoint corners[corner_room]{};                      ///< see MeshTable
    LatticeTriangle triangles[triangle_room]{};               ///< see MeshTable
    MeshNode nodes[node_room]{};                              ///< see MeshTable
    uint16_t corner_count{}, triangle_count{}, node_count{};  ///< see MeshTable
    int without_area{}, doubled{};                            ///< triangles that were left out: of no area on the lattice, or there already
    Vector origin{};                                          ///< m, see LevelTable
    scalar step{};                                            ///< m, see LevelTable
    Vector low{}, high{};                                     ///< m, see LevelTable
    uint32_t checksum{};                                      ///< see LevelTable

    /// What LevelTables and the calls of level_walk.h take: it points here.
    constexpr LevelTable view() const {
        LevelTable level{};
        level.mesh = {corners, triangles, nodes, corner_count, triangle_count, node_count};
        level.origin = origin;
        level.step = step;
        level.low = low;
        level.high = high;
        level.checksum = checksum;
        return level;
    }
};

namespace meshes {

/// Points on the lattice, and where it begins: at the least of the points that faces have.
template <unsigned corner_room, unsigned triangle_room>
constexpr Status take_corners(const Vector (&corners)[corner_room], const LevelFace (&faces)[triangle_room], scalar step,
                              LatticePoint (&points)[corner_room], int64_t (&origin)[3]) {
    constexpr int corner_count = static_cast<int>(corner_room);
    bool used[corner_room] = {};
    for (const LevelFace& face : faces) {
        const int numbers[3] = {face.a, face.b, face.c};
        for (int number : numbers) {
            if (number < 0 || number >= corner_count) return Status::out_of_range;
            used[number] = true;
        }
    }
    int64_t high[3] = {};
    bool is_first = true;
    for (int pass = 0; pass < 2; ++pass) {
        for (int i = 0; i < corner_count; ++i) {  // bound: of the caller
            const scalar place[3] = {corners[i].x, corners[i].y, corners[i].z};
            if (pass == 0 && !is_finite(corners[i])) return Status::not_finite;
            if (!used[i]) continue;
            int64_t steps[3] = {};
            for (int axis = 0; axis < 3; ++axis) {
                if (!(abs(place[axis]) <= limits::position_max)) return Status::out_of_range;
                steps[axis] = lattice::nearest_step(place[axis], step);
                if (is_first || steps[axis] < origin[axis]) origin[axis] = steps[axis];
                if (is_first || steps[axis] > high[axis]) high[axis] = steps[axis];
            }
            is_first = false;
            if (pass == 1)
                points[i] = {static_cast<uint16_t>(steps[0] - origin[0]), static_cast<uint16_t>(steps[1] - origin[1]),
                             static_cast<uint16_t>(steps[2] - origin[2])};
        }
        for (int axis = 0; axis < 3; ++axis)
            if (high[axis] - origin[axis] > lattice::last || origin[axis] < -lattice::origin_max || origin[axis] > lattice::origin_max)
                return Status::out_of_range;
    }
    return Status::ok;
}

/// Origin, box and checksum of tables.
constexpr void frame(LevelTable& level, const int64_t (&origin)[3], scalar step) {
    const auto at = [step](int64_t steps) { return static_cast<scalar>(steps) * step; };
    level.step = step;
    level.origin = {at(origin[0]), at(origin[1]), at(origin[2])};
    const lattice::Box box = lattice::box_of_corners(level.mesh);
    level.low = {at(origin[0] + box.low[0]), at(origin[1] + box.low[1]), at(origin[2] + box.low[2])};
    level.high = {at(origin[0] + box.high[0]), at(origin[1] + box.high[1]), at(origin[2] + box.high[2])};
    level.checksum = checksum_of(level);
}

}  // namespace meshes

/// The table of a mesh. Corners are moved to the nearest point of the lattice; those that meet there are one. Triangles that have no area then are
/// left out, and so are those that are there already. The result depends on the triangles, and not on the order of corners or triangles, nor on the
/// corner that a triangle begins with.
///
/// Units:   m, in the level's frame. step: a power of two; 2^-10 m makes 64 m of lattice.
/// Errors:  not_finite, out_of_range (a number that is no corner's, a step that is no power of two from 2^-20 to 2^20, more than 65535 steps across,
///          a place beyond limits::position_max or 2^23 steps, of double 2^52), no_room (more than 65535 corners or triangles), bad_shape (no
///          triangle is left).
/// Cost:    none at run time where all of it is constant; else n log n comparisons.
template <unsigned corner_room, unsigned triangle_room>
constexpr Result<MeshOf<corner_room, triangle_room>> mesh_of(const Vector (&corners)[corner_room], const LevelFace (&faces)[triangle_room],
                                                             scalar step = scalar(1) / 1024) {
    constexpr int corner_count = static_cast<int>(corner_room), face_count = static_cast<int>(triangle_room);
    constexpr auto node_room = meshes::node_room(triangle_room);
    Result<MeshOf<corner_room, triangle_room>> result{};
    if (!lattice::is_step(step)) return {Status::out_of_range, {}};
    LatticePoint points[corner_room] = {};
    int64_t origin[3] = {};
    const Status taken = meshes::take_corners(corners, faces, step, points, origin);
    if (taken != Status::ok) return {taken, {}};

    uint64_t corner_keys[corner_room] = {}, triangle_keys[triangle_room] = {}, edges[3 * triangle_room] = {};
    uint64_t aside[3 * triangle_room < corner_room ? corner_room : 3 * triangle_room] = {};
    lattice::Box boxes[triangle_room] = {};
    int order[3][triangle_room] = {}, begin[node_room] = {}, end[node_room] = {};
    uint8_t kinds[triangle_room] = {}, left[triangle_room] = {};
    meshes::Workspace work{corner_keys, triangle_keys, edges, aside, boxes, {order[0], order[1], order[2]}, begin, end, kinds, left};
    MeshOf<corner_room, triangle_room>& mesh = result.value;
    meshes::Tables tables{mesh.corners, mesh.triangles, mesh.nodes};
    const Status built = meshes::build(points, corner_count, faces, face_count, work, tables);
    if (built != Status::ok) return {built, {}};

    mesh.corner_count = static_cast<uint16_t>(tables.corner_count);
    mesh.triangle_count = static_cast<uint16_t>(tables.triangle_count);
    mesh.node_count = static_cast<uint16_t>(tables.node_count);
    mesh.without_area = tables.without_area;
    mesh.doubled = tables.doubled;
    LevelTable level = mesh.view();
    meshes::frame(level, origin, step);
    mesh.origin = level.origin;
    mesh.step = level.step;
    mesh.low = level.low;
    mesh.high = level.high;
    mesh.checksum = level.checksum;
    return result;
}

/// A mesh that mesh_of has made, in arrays that are as long as they have to be.
template <const auto& built>
constexpr auto trimmed() {
    static_assert(built.ok(), "this is no mesh: ask mesh_of for the status");
    constexpr const auto& mesh = built.value;
    MeshOf<mesh.corner_count, mesh.triangle_count, mesh.node_count> all{};
    for (int i = 0; i < mesh.corner_count; ++i) all.corners[i] = mesh.corners[i];        // bound: corners of the mesh
    for (int i = 0; i < mesh.triangle_count; ++i) all.triangles[i] = mesh.triangles[i];  // bound: triangles of the mesh
    for (int i = 0; i < mesh.node_count; ++i) all.nodes[i] = mesh.nodes[i];              // bound: nodes of the mesh
    all.corner_count = mesh.corner_count;
    all.triangle_count = mesh.triangle_count;
    all.node_count = mesh.node_count;
    all.without_area = mesh.without_area;
    all.doubled = mesh.doubled;
    all.origin = mesh.origin;
    all.step = mesh.step;
    all.low = mesh.low;
    all.high = mesh.high;
    all.checksum = mesh.checksum;
    return all;
}

}}  // namespace ingot::INGOT_ABI
