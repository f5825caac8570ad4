// SPDX-License-Identifier: MIT
#include "mesh_walk.h"

#include "lattice_steps.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

const LatticePoint& corner_of(const MeshTable& mesh, const LatticeTriangle& triangle, int i) {
    const uint16_t corner = triangle.corners[i];
    return mesh.corners[corner < mesh.corner_count ? corner : 0];
}

/// The box of three numbers meets what is asked for along one axis.
bool meet(int a, int b, int c, int low, int high) {
    const int least = a < b ? (a < c ? a : c) : (b < c ? b : c), most = a > b ? (a > c ? a : c) : (b > c ? b : c);
    return least <= high && most >= low;
}
bool meets(const MeshTable& mesh, const LatticeTriangle& triangle, const MeshWalk& walk) {
    const LatticePoint &a = corner_of(mesh, triangle, 0), &b = corner_of(mesh, triangle, 1), &c = corner_of(mesh, triangle, 2);
    return meet(a.x, b.x, c.x, walk.low[0], walk.high[0]) && meet(a.y, b.y, c.y, walk.low[1], walk.high[1]) &&
           meet(a.z, b.z, c.z, walk.low[2], walk.high[2]);
}

/// Bit k: child k of the node meets what is asked for.
int children_met(const MeshNode& node, const MeshWalk& walk) {
    const int origin[3] = {node.origin.x, node.origin.y, node.origin.z};
    int met = (1 << MeshNode::children) - 1;
    for (int axis = 0; axis < 3; ++axis) {
        const int shift = node.shift(axis);
        const int from = walk.low[axis] - origin[axis], to = walk.high[axis] - origin[axis];
        if (to < 0) return 0;
        const int first = from <= 0 ? 0 : (from + (1 << shift) - 1) >> shift, last = to >> shift;
        for (int k = 0; k < MeshNode::children; ++k)
            if (node.low[axis][k] > last || node.high[axis][k] < first) met &= ~(1 << k);
    }
    return met;
}

/// Puts the children that are met where they wait.
void look_at_node(const MeshTable& mesh, int number, MeshWalk& walk) {
    const MeshNode& node = mesh.nodes[number];
    const int met = children_met(node, walk);
    int child = node.first_node, triangle = node.first_triangle;
    walk.leaves = 0;
    for (int k = 0; k < MeshNode::children; ++k) {
        const int count = node.count(k);
        const bool is_met = (met >> k & 1) != 0;
        if (count == MeshNode::inner) {
            if (is_met && child < mesh.node_count && walk.waiting < MeshTable::stack_max)
                walk.stack[walk.waiting++] = static_cast<uint16_t>(child);
            ++child;
        } else if (count < MeshNode::inner) {
            if (is_met && triangle + count <= mesh.triangle_count) {
                walk.next[walk.leaves] = static_cast<uint16_t>(triangle);
                walk.end[walk.leaves++] = static_cast<uint16_t>(triangle + count);
            }
            triangle += count;
        }
    }
}

}  // namespace

LevelTriangle triangle_of_mesh(const LevelTable& level, uint32_t number) {
    LevelTriangle triangle{};
    triangle.number = number;
    const MeshTable& mesh = level.mesh;
    if (number >= mesh.triangle_count) return triangle;
    const LatticeTriangle& stored = mesh.triangles[number];
    for (int i = 0; i < 3; ++i) {
        const LatticePoint& corner = corner_of(mesh, stored, i);
        triangle.corners[i] = {corner_along(level.origin.x, level.step, corner.x), corner_along(level.origin.y, level.step, corner.y),
                               corner_along(level.origin.z, level.step, corner.z)};
    }
    triangle.edges = stored.edges;
    triangle.material = stored.material;
    return triangle;
}

bool begin_walk(const LevelTable& level, const Vector& low, const Vector& high, MeshWalk& walk) {
    if (!(low.x <= high.x && low.y <= high.y && low.z <= high.z) || level.mesh.node_count == 0) return false;
    const scalar inv_step = 1 / level.step;
    const scalar lows[3] = {low.x, low.y, low.z}, highs[3] = {high.x, high.y, high.z};
    const scalar origins[3] = {level.origin.x, level.origin.y, level.origin.z};
    for (int axis = 0; axis < 3; ++axis) {
        walk.low[axis] = first_step_from(lows[axis], origins[axis], level.step, inv_step);
        walk.high[axis] = last_step_to(highs[axis], origins[axis], level.step, inv_step);
        // Not where low is above high: a triangle may be larger than what is between two corners of the lattice.
        if (walk.high[axis] < 0 || walk.low[axis] > 65535) return false;
    }
    walk.nodes_left = level.mesh.node_count;
    walk.leaves = 0;
    walk.waiting = 1;
    walk.stack[0] = 0;
    return true;
}

bool next_triangle(const LevelTable& level, MeshWalk& walk, LevelTriangle& triangle) {
    const MeshTable& mesh = level.mesh;
    // bound: nodes and triangles of the mesh: each turn takes one away
    while (true) {
        if (walk.leaves > 0) {
            const int leaf = walk.leaves - 1;
            if (walk.next[leaf] == walk.end[leaf]) {
                --walk.leaves;
                continue;
            }
            const int number = walk.next[leaf]++;
            if (!meets(mesh, mesh.triangles[number], walk)) continue;
            triangle = triangle_of_mesh(level, static_cast<uint32_t>(number));
            return true;
        }
        if (walk.waiting == 0 || walk.nodes_left == 0) return false;
        --walk.nodes_left;
        look_at_node(mesh, walk.stack[--walk.waiting], walk);
    }
}

}}  // namespace ingot::INGOT_ABI
