// SPDX-License-Identifier: MIT
// The ground of a level as it lies in flash: a mesh of triangles, or a field of heights. Tables are constants, made by host_tests/level_tool or, for
// small ones, by the compiler; nothing of them is ever copied to RAM. See mesh_of.h and height_field_of.h.
#pragma once

#include "../math/vec3.h"

namespace ingot { inline namespace INGOT_ABI {

/// A corner on the lattice of a level: so many steps from its origin. Levels on one lattice meet without a gap.
struct LatticePoint {
    uint16_t x{}, y{}, z{};
};

/// What lies beyond an edge of a triangle.
enum class EdgeKind : uint8_t {
    border,   ///< nothing, or more than one triangle
    flat,     ///< a triangle whose far corner is in the plane, to half a step of the lattice
    convex,   ///< a triangle that falls away: a ridge
    concave,  ///< a triangle that rises: a valley
};

/// A triangle of a MeshTable. Corners counter-clockwise as seen from outside, where bodies may be.
struct LatticeTriangle {
    uint16_t corners[3]{};  ///< of MeshTable::corners
    uint8_t edges{};        ///< two bits each, from the lowest: EdgeKind of the edges from corner 0, 1 and 2 to the next
    uint8_t material{};     ///< the user's
};

/// Up to four boxes around parts of the mesh. A box is given in units of 2^shift steps from the node's origin: 8 bits a side, rounded outwards.
/// Nodes that are children of one node lie one behind the other, and so do the triangles of its leaves: the first of each is enough.
struct MeshNode {
    static constexpr int children = 4;
    static constexpr int inner = 9;  ///< in counts: not a leaf but a node
    LatticePoint origin{};
    uint16_t shifts{};          ///< 0 .. 9 of x, y and z, four bits each from the lowest
    uint16_t counts{};          ///< of child 0 to 3, four bits each from the lowest: triangles of a leaf; 0: there is none; or inner
    uint16_t first_node{};      ///< of the children that are nodes; after this one
    uint16_t first_triangle{};  ///< of the children that are leaves
    uint8_t low[3][children]{}, high[3][children]{};  ///< by axis and child

    constexpr int shift(int axis) const { return shifts >> 4 * axis & 15; }
    constexpr int count(int child) const { return counts >> 4 * child & 15; }
};

/// A mesh. Nodes lie level by level, so what node, and what triangle, comes next is known before it is read.
struct MeshTable {
    static constexpr int depth_max = 12;                  ///< of nodes
    static constexpr int stack_max = 3 * depth_max + 1;   ///< nodes that wait in a walk
    static constexpr int triangles_of_leaf_max = 8;
    const LatticePoint* corners{};
    const LatticeTriangle* triangles{};
    const MeshNode* nodes{};  ///< the first is the root
    uint16_t corner_count{}, triangle_count{}, node_count{};
};

/// Of 16 by 16 samples of a HeightTable in bytes: a sample is base + (byte << shift), steps.
struct HeightBlock {
    static constexpr int side = 16;  ///< samples
    static constexpr int shift_max = 9;
    uint16_t base{};
    uint8_t shift{};   ///< 0 .. shift_max
    uint8_t unused{};  ///< 0
};

/// Heights over a grid in x and y; z is up. Samples row by row, x first. Solid below, at any depth.
struct HeightTable {
    static constexpr uint8_t hole = 255;  ///< in cells: no ground
    const uint16_t* heights{};      ///< steps of LevelTable::step in z; columns times rows of them; null where `bytes` has them
    const uint8_t* cells{};         ///< material of each cell, or hole; (columns - 1) (rows - 1) of them; null: all 0
    /// Least and greatest height of blocks of 8 by 8 cells, row by row, then of 8 by 8 of these, and so on, up to one block.
    const uint16_t* extremes{};
    uint16_t columns{}, rows{};     ///< samples, 2 .. 65535
    scalar spacing_x{}, spacing_y{};  ///< m, between samples
    bool other_diagonal{};          ///< cells are cut from (0, 1) to (1, 0), not from (0, 0) to (1, 1)
    const uint8_t* bytes{};         ///< samples in bytes, columns times rows of them, or null
    const HeightBlock* blocks{};    ///< what they are to be read by, row by row
};

/// What it is like to touch a material of a level: see BodyDef.
struct LevelMaterial {
    static constexpr int count_max = 256;
    scalar friction = scalar(0.5);
    scalar restitution = 0;
};

/// One of the two; the other is empty. The level's frame is the user's: a level is placed as a body is.
struct LevelTable {
    MeshTable mesh{};        ///< where mesh.triangle_count > 0
    HeightTable heights{};   ///< where heights.columns > 0
    Vector origin{};  ///< m, of lattice point (0, 0, 0), in the level's frame
    scalar step{};    ///< m, of the lattice: a power of two
    Vector low{}, high{};  ///< m, in the level's frame: a box that holds all of it. Of heights, what lies on top
    uint32_t checksum{};   ///< of all tables: snapshots name the level by it
    /// By LatticeTriangle::material, or HeightTable::cells: see with_materials. Those beyond, and all where there are none, are as LevelDef says.
    const LevelMaterial* materials{};
    int material_count{};  ///< 0 .. LevelMaterial::count_max

    /// m, of that box, in the level's frame.
    constexpr Vector middle() const { return (low + high) * scalar(0.5); }
    /// Null: as LevelDef says.
    constexpr const LevelMaterial* material(int number) const { return number < material_count ? materials + number : nullptr; }
    constexpr bool is_mesh() const { return mesh.triangle_count > 0; }
};

/// Of the box that holds a level, m.
constexpr Vector half_extents_of(const LevelTable& level) { return (level.high - level.low) * scalar(0.5); }

/// The levels of a scene, in flash. A body has the number of its level, no pointer.
struct LevelTables {
    const LevelTable* levels{};
    int count{};
};

/// The levels of a scene that names none.
struct NoLevels {};

constexpr LevelTables levels_in(const NoLevels&) { return {nullptr, 0}; }
template <unsigned N>
constexpr LevelTables levels_in(const LevelTable (&levels)[N]) {
    return {levels, static_cast<int>(N)};
}

/// A triangle of a level, in the level's frame.
struct LevelTriangle {
    Vector corners[3]{};  ///< m, counter-clockwise as seen from outside
    uint32_t number{};    ///< of a mesh, in MeshTable::triangles; of heights, 2 (row (columns - 1) + column) and one more
    uint8_t edges{};      ///< as LatticeTriangle::edges
    uint8_t material{};

    constexpr EdgeKind edge(int i) const { return static_cast<EdgeKind>(edges >> 2 * i & 3); }
};

} }  // namespace ingot
