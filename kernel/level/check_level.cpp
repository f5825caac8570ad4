// SPDX-License-Identifier: MIT
#include "height_walk.h"
#include "lattice.h"
#include "lattice_steps.h"
#include "level_checksum.h"
#include "level_walk.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

bool holds_triangle(const MeshTable& mesh, const MeshNode& node, int k, const LatticeTriangle& triangle) {
    const uint16_t(&c)[3] = triangle.corners;
    if (c[0] >= mesh.corner_count || c[1] >= mesh.corner_count || c[2] >= mesh.corner_count) return false;
    const LatticePoint &a = mesh.corners[c[0]], &b = mesh.corners[c[1]], &d = mesh.corners[c[2]];
    if (!lattice::has_area(a, b, d)) return false;
    const lattice::Box box = lattice::box_of(a, b, d);
    const int origin[3] = {node.origin.x, node.origin.y, node.origin.z};
    for (int axis = 0; axis < 3; ++axis)
        if (box.low[axis] < origin[axis] + (node.low[axis][k] << node.shift(axis)) ||
            box.high[axis] > origin[axis] + (node.high[axis][k] << node.shift(axis)))
            return false;
    return true;
}

/// Nodes lie level by level, so each has to say that its children come next.
bool check_nodes(const MeshTable& mesh) {
    int next_node = 1, next_triangle = 0, level_end = 1, depth = 1;
    for (int node_i = 0; node_i < mesh.node_count; ++node_i) {  // bound: nodes of the mesh
        if (node_i == level_end) {
            level_end = next_node;
            ++depth;
        }
        const MeshNode& node = mesh.nodes[node_i];
        if (node_i >= next_node || depth > MeshTable::depth_max || node.first_node != next_node || node.first_triangle != next_triangle) return false;
        for (int axis = 0; axis < 3; ++axis)
            if (node.shift(axis) > 9) return false;
        for (int k = 0; k < MeshNode::children; ++k) {
            const int count = node.count(k);
            if (count > MeshNode::inner) return false;
            if (count == MeshNode::inner) {
                ++next_node;
                continue;
            }
            if (next_triangle + count > mesh.triangle_count) return false;
            for (int i = 0; i < count; ++i)  // bound: MeshTable::triangles_of_leaf_max
                if (!holds_triangle(mesh, node, k, mesh.triangles[next_triangle + i])) return false;
            next_triangle += count;
        }
    }
    return next_node == mesh.node_count && next_triangle == mesh.triangle_count;
}

bool check_mesh(const LevelTable& level) {
    const MeshTable& mesh = level.mesh;
    if (mesh.corners == nullptr || mesh.triangles == nullptr || mesh.nodes == nullptr || mesh.corner_count == 0 || mesh.node_count == 0) return false;
    const lattice::Box box = lattice::box_of_corners(mesh);
    const scalar origin[3] = {level.origin.x, level.origin.y, level.origin.z};
    const scalar low[3] = {level.low.x, level.low.y, level.low.z}, high[3] = {level.high.x, level.high.y, level.high.z};
    for (int axis = 0; axis < 3; ++axis)
        if (low[axis] != corner_along(origin[axis], level.step, box.low[axis]) ||
            high[axis] != corner_along(origin[axis], level.step, box.high[axis]))
            return false;
    return check_nodes(mesh);
}

/// Samples in bytes, none above what 16 bits hold.
bool check_bytes(const HeightTable& heights) {
    const int64_t blocks = grid::byte_blocks_of(heights.columns, heights.rows);
    for (int64_t i = 0; i < blocks; ++i)  // bound: the field
        if (heights.blocks[i].shift > HeightBlock::shift_max) return false;
    for (int row = 0; row < heights.rows; ++row)                 // bound: the field
        for (int column = 0; column < heights.columns; ++column)  // bound: the field
            if (grid::height_at(heights, column, row) > lattice::last) return false;
    return true;
}

bool check_heights(const LevelTable& level) {
    const HeightTable& heights = level.heights;
    const bool is_in_bytes = heights.bytes != nullptr;
    if (is_in_bytes == (heights.heights != nullptr) || is_in_bytes != (heights.blocks != nullptr)) return false;
    if (heights.extremes == nullptr || heights.columns < 2 || heights.rows < 2) return false;
    if (static_cast<int64_t>(grid::cells_of(heights.columns)) * grid::cells_of(heights.rows) >= grid::cells_max) return false;
    if (!grid::is_spacing(heights.spacing_x, level.origin.x) || !grid::is_spacing(heights.spacing_y, level.origin.y)) return false;
    if (is_in_bytes && !check_bytes(heights)) return false;
    const int levels = grid::levels_of(heights.columns, heights.rows);
    for (int level_i = 1; level_i <= levels; ++level_i) {  // bound: grid::levels_max
        const int width = grid::blocks_of(grid::cells_of(heights.columns), level_i), length = grid::blocks_of(grid::cells_of(heights.rows), level_i);
        for (int y = 0; y < length; ++y)       // bound: the field
            for (int x = 0; x < width; ++x) {  // bound: the field
                const grid::Extremes found = grid::extremes_of_block(heights, heights.extremes, level_i, x, y);
                const uint16_t* stored = extremes_of_block(heights, level_i, x, y);
                if (found.least != stored[0] || found.most != stored[1]) return false;
            }
    }
    const Vector low = grid::low_of(level), high = grid::high_of(level);
    return level.low.x == low.x && level.low.y == low.y && level.low.z == low.z && level.high.x == high.x && level.high.y == high.y &&
           level.high.z == high.z;
}

}  // namespace

Status check_level(const LevelTable& level) {
    if (!lattice::is_step(level.step) || !lattice::is_origin(level.origin.z, level.step)) return Status::bad_shape;
    const bool has_heights = level.heights.columns > 0;
    if (level.is_mesh() == has_heights) return Status::bad_shape;
    if (level.is_mesh()) {
        if (!lattice::is_origin(level.origin.x, level.step) || !lattice::is_origin(level.origin.y, level.step) || !check_mesh(level))
            return Status::bad_shape;
    } else if (!check_heights(level)) {
        return Status::bad_shape;
    }
    if (level.material_count < 0 || level.material_count > LevelMaterial::count_max) return Status::bad_shape;
    if (level.material_count > 0 && level.materials == nullptr) return Status::bad_shape;
    return level.checksum == checksum_of(level) ? Status::ok : Status::bad_shape;
}

}}  // namespace ingot::INGOT_ABI
