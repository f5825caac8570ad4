// SPDX-License-Identifier: MIT
// Tables of a level in memory of the host, made by the code that the compiler runs for small ones.
#pragma once

#include <ingot/level/byte_heights_of.h>
#include <ingot/level/mesh_of.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace level_tool {

/// A mesh, with its arrays. `view` points into them: moved it stays true, copied it does not.
struct MeshData {
    std::vector<ingot::LatticePoint> corners;
    std::vector<ingot::LatticeTriangle> triangles;
    std::vector<ingot::MeshNode> nodes;
    ingot::LevelTable view;
    int without_area = 0, doubled = 0;

    MeshData() = default;
    MeshData(MeshData&&) = default;
    MeshData& operator=(MeshData&&) = default;
    MeshData(const MeshData&) = delete;
    MeshData& operator=(const MeshData&) = delete;
};

/// Of points on the lattice, from its origin on, which is so many steps from that of the frame. Errors: as ingot::meshes::build.
inline ingot::Status build_mesh(const std::vector<ingot::LatticePoint>& points, const std::vector<ingot::LevelFace>& faces,
                                const int64_t (&origin)[3], ingot::scalar step, MeshData& data) {
    const size_t face_count = std::max<size_t>(faces.size(), 1), point_count = std::max<size_t>(points.size(), 1);
    const size_t node_room = ingot::meshes::node_room(static_cast<unsigned>(face_count));
    std::vector<uint64_t> corner_keys(point_count), triangle_keys(face_count), edges(3 * face_count);
    std::vector<uint64_t> aside(std::max(3 * face_count, point_count));
    std::vector<ingot::lattice::Box> boxes(face_count);
    std::vector<int> order[3], begin(node_room), end(node_room);
    for (auto& along : order) along.resize(face_count);
    std::vector<uint8_t> kinds(face_count), left(face_count);
    ingot::meshes::Workspace work{
        corner_keys.data(), triangle_keys.data(), edges.data(), aside.data(), boxes.data(), {order[0].data(), order[1].data(), order[2].data()},
        begin.data(),       end.data(),           kinds.data(), left.data()};
    data.corners.assign(point_count, {});
    data.triangles.assign(face_count, {});
    data.nodes.assign(node_room, {});
    ingot::meshes::Tables tables{data.corners.data(), data.triangles.data(), data.nodes.data()};
    const ingot::Status status =
        ingot::meshes::build(points.data(), static_cast<int>(points.size()), faces.data(), static_cast<int>(faces.size()), work, tables);
    data.without_area = tables.without_area;
    data.doubled = tables.doubled;
    if (status != ingot::Status::ok) return status;
    data.corners.resize(static_cast<size_t>(tables.corner_count));
    data.triangles.resize(static_cast<size_t>(tables.triangle_count));
    data.nodes.resize(static_cast<size_t>(tables.node_count));
    data.view = {};
    data.view.mesh = {data.corners.data(),
                      data.triangles.data(),
                      data.nodes.data(),
                      static_cast<uint16_t>(tables.corner_count),
                      static_cast<uint16_t>(tables.triangle_count),
                      static_cast<uint16_t>(tables.node_count)};
    ingot::meshes::frame(data.view, origin, step);
    return status;
}

/// A field of heights, with its arrays: as MeshData.
struct HeightData {
    std::vector<uint16_t> heights, extremes;
    std::vector<uint8_t> cells;  ///< empty where there is no hole
    std::vector<uint8_t> bytes;  ///< in the place of heights
    std::vector<ingot::HeightBlock> blocks;
    ingot::LevelTable view;

    HeightData() = default;
    HeightData(HeightData&&) = default;
    HeightData& operator=(HeightData&&) = default;
    HeightData(const HeightData&) = delete;
    HeightData& operator=(const HeightData&) = delete;
};

/// Fills what follows from heights, cells, origin, step and spacings.
inline void finish_heights(HeightData& data, int columns, int rows) {
    ingot::HeightTable& heights = data.view.heights;
    heights.heights = data.bytes.empty() ? data.heights.data() : nullptr;
    heights.bytes = data.bytes.empty() ? nullptr : data.bytes.data();
    heights.blocks = data.bytes.empty() ? nullptr : data.blocks.data();
    heights.cells = data.cells.empty() ? nullptr : data.cells.data();
    heights.columns = static_cast<uint16_t>(columns);
    heights.rows = static_cast<uint16_t>(rows);
    data.extremes.resize(static_cast<size_t>(ingot::grid::extremes_of(columns, rows)));
    heights.extremes = data.extremes.data();
    ingot::grid::fill_extremes(heights, data.extremes.data());
    data.view.low = ingot::grid::low_of(data.view);
    data.view.high = ingot::grid::high_of(data.view);
    data.view.checksum = checksum_of(data.view);
}

/// Puts the samples into bytes; finish_heights comes after it. Returns: as ingot::grid::fill_bytes.
inline int put_into_bytes(HeightData& data, int columns, int rows) {
    data.bytes.resize(data.heights.size());
    data.blocks.resize(static_cast<size_t>(ingot::grid::byte_blocks_of(columns, rows)));
    return ingot::grid::fill_bytes(data.heights.data(), columns, rows, data.bytes.data(), data.blocks.data());
}

}  // namespace level_tool
