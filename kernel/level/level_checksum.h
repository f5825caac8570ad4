// SPDX-License-Identifier: MIT
#pragma once

#include "height_grid.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of the numbers of a level, in the order of the tables, whatever the order of bytes of the machine. A byte that is another always shows: each step
/// is one to one.
///
/// Source: Fowler, Noll and Vo, FNV-1a of 32 bits.
struct LevelChecksum {
    uint32_t value{2166136261u};  ///< so far

    constexpr void byte(unsigned x) { value = (value ^ (x & 255)) * 16777619u; }
    constexpr void pair(unsigned x) {
        byte(x);
        byte(x >> 8);
    }
    constexpr void word(uint32_t x) {
        pair(x & 65535);
        pair(x >> 16);
    }
    /// A number by its digits, so that float and double have the same where it is the same.
    constexpr void number(scalar x) {
        scalar size = x < 0 ? -x : x;
        if (!(size <= scalar_max)) size = 0;
        int exponent = 0;
        for (; size >= 1; size /= 2) ++exponent;                       // bound: 1024: a double is below 2^1024
        for (; size > 0 && size < scalar(0.5); size *= 2) --exponent;  // bound: 1074: it is above 2^-1075
        word(static_cast<uint32_t>(exponent) << 1 | (x < 0));
        constexpr scalar part = 65536;
        for (int i = 0; i < 4; ++i) {
            size *= part;
            const auto digits = static_cast<uint32_t>(size);
            size -= static_cast<scalar>(digits);
            pair(digits & 65535);
        }
    }
    constexpr void all_of(const LevelMaterial* materials, int count) {
        for (int i = 0; i < count; ++i) {  // bound: LevelMaterial::count_max
            number(materials[i].friction);
            number(materials[i].restitution);
        }
    }
    constexpr void point(const LatticePoint& p) {
        pair(p.x);
        pair(p.y);
        pair(p.z);
    }
    constexpr void triangle(const LatticeTriangle& t) {
        for (unsigned corner : t.corners) pair(corner);
        byte(t.edges);
        byte(t.material);
    }
    constexpr void block(const HeightBlock& b) {
        pair(b.base);
        byte(b.shift);
        byte(b.unused);
    }
    constexpr void node(const MeshNode& n) {
        point(n.origin);
        pair(n.shifts);
        pair(n.counts);
        pair(n.first_node);
        pair(n.first_triangle);
        for (int axis = 0; axis < 3; ++axis)
            for (int k = 0; k < MeshNode::children; ++k) {
                byte(n.low[axis][k]);
                byte(n.high[axis][k]);
            }
    }
};

/// All but materials.
constexpr void sum_tables(const LevelTable& level, LevelChecksum& sum) {
    sum.number(level.origin.x);
    sum.number(level.origin.y);
    sum.number(level.origin.z);
    sum.number(level.step);
    const MeshTable& mesh = level.mesh;
    sum.pair(mesh.corner_count);
    sum.pair(mesh.triangle_count);
    sum.pair(mesh.node_count);
    for (int i = 0; i < mesh.corner_count; ++i) sum.point(mesh.corners[i]);         // bound: corners of the mesh
    for (int i = 0; i < mesh.triangle_count; ++i) sum.triangle(mesh.triangles[i]);  // bound: triangles of the mesh
    for (int i = 0; i < mesh.node_count; ++i) sum.node(mesh.nodes[i]);              // bound: nodes of the mesh
    const HeightTable& heights = level.heights;
    sum.pair(heights.columns);
    sum.pair(heights.rows);
    if (heights.columns == 0 || heights.rows == 0) return;
    sum.number(heights.spacing_x);
    sum.number(heights.spacing_y);
    sum.byte(heights.other_diagonal);
    const int64_t samples = static_cast<int64_t>(heights.columns) * heights.rows;
    const int64_t cells = heights.cells == nullptr ? 0 : static_cast<int64_t>(heights.columns - 1) * (heights.rows - 1);
    const int64_t extremes = grid::extremes_of(heights.columns, heights.rows);
    if (heights.bytes != nullptr) {
        const int64_t blocks = grid::byte_blocks_of(heights.columns, heights.rows);
        for (int64_t i = 0; i < samples; ++i) sum.byte(heights.bytes[i]);   // bound: the field
        for (int64_t i = 0; i < blocks; ++i) sum.block(heights.blocks[i]);  // bound: the field
    } else {
        for (int64_t i = 0; i < samples; ++i) sum.pair(heights.heights[i]);  // bound: the field
    }
    for (int64_t i = 0; i < cells; ++i) sum.byte(heights.cells[i]);        // bound: the field
    for (int64_t i = 0; i < extremes; ++i) sum.pair(heights.extremes[i]);  // bound: the field
}

/// See LevelTable::checksum.
constexpr uint32_t checksum_of(const LevelTable& level) {
    LevelChecksum sum{};
    sum_tables(level, sum);
    sum.all_of(level.materials, level.material_count);
    return sum.value;
}

}}  // namespace ingot::INGOT_ABI
