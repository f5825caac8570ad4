// SPDX-License-Identifier: MIT
// How a mesh becomes a table: for the compiler (mesh_of.h) and for host_tests/level_tool the same code, in integers alone. What comes out depends on
// the triangles and not on the order in which they are given.
#pragma once

#include "../base/status.h"
#include "lattice.h"

namespace ingot { inline namespace INGOT_ABI {

/// A triangle of a mesh that is to be a table: numbers of its corners, counter-clockwise as seen from outside.
struct LevelFace {
    int a{}, b{}, c{};   ///< of the corners given
    uint8_t material{};  ///< the user's
};

namespace meshes {

/// Nodes of so many triangles at most: a node has more than eight of them, so four children.
constexpr unsigned node_room(unsigned triangles) { return triangles / 3 + 1; }

/// Where the builder works: arrays of the caller, for so many faces and corners as are given.
struct Workspace {
    uint64_t* corners{};    ///< of corners
    uint64_t* triangles{};  ///< of faces
    uint64_t* edges{};      ///< 3 of faces
    uint64_t* aside{};      ///< 3 of faces, and of corners
    lattice::Box* boxes{};  ///< of faces
    int* order[3]{};        ///< of faces: the triangles as they lie along each axis
    int* begin{};           ///< node_room
    int* end{};             ///< node_room
    uint8_t* kinds{};       ///< of faces: LatticeTriangle::edges
    uint8_t* left{};        ///< of faces
};

/// What it makes: arrays of the caller, for as many.
struct Tables {
    LatticePoint* corners{};
    LatticeTriangle* triangles{};
    MeshNode* nodes{};  ///< node_room
    int corner_count{}, triangle_count{}, node_count{};
    int without_area{}, doubled{};  ///< faces that were left out
};

/// A triangle as one number, which orders them: corners from the least on, and material.
constexpr uint64_t key_of_triangle(int a, int b, int c, uint8_t material) {
    const int first = a < b && a < c ? a : b < c ? b : c, second = first == a ? b : first == b ? c : a, third = first == a ? c : first == b ? a : b;
    return static_cast<uint64_t>(first) << 40 | static_cast<uint64_t>(second) << 24 | static_cast<uint64_t>(third) << 8 | material;
}
constexpr int corner_of_key(uint64_t key, int i) { return static_cast<int>(key >> (40 - 16 * i) & 65535); }

/// The number of a key among those that are sorted, one of which it is.
constexpr int place_of(uint64_t key, const uint64_t* keys, int count) {
    int from = 0, to = count - 1;
    // bound: log2 of the count: each turn halves what is left
    while (from < to) {
        const int middle = (from + to) / 2;
        if (keys[middle] < key)
            from = middle + 1;
        else
            to = middle;
    }
    return from;
}

/// Sorts, and keeps one of those that are equal but for the lowest `ignored` bits. Returns how many are left.
constexpr int sort_and_merge(uint64_t* keys, uint64_t* aside, int count, int ignored) {
    lattice::sort_keys(keys, aside, count);
    int kept = 0;
    for (int i = 0; i < count; ++i)  // bound: the count
        if (kept == 0 || keys[i] >> ignored != keys[kept - 1] >> ignored) keys[kept++] = keys[i];
    return kept;
}

/// Corners and triangles, sorted, each once.
constexpr Status weld(const LatticePoint* points, int point_count, const LevelFace* faces, int face_count, Workspace& work, Tables& tables) {
    tables = {tables.corners, tables.triangles, tables.nodes};
    // Only corners of triangles that are kept count.
    for (int i = 0; i < point_count; ++i) work.corners[i] = 0;  // bound: of the workspace
    int kept = 0;
    for (int i = 0; i < face_count; ++i) {  // bound: of the workspace
        const LevelFace& face = faces[i];
        const int numbers[3] = {face.a, face.b, face.c};
        for (int corner : numbers)
            if (corner < 0 || corner >= point_count) return Status::out_of_range;
        if (!lattice::has_area(points[face.a], points[face.b], points[face.c])) continue;
        ++kept;
        work.corners[face.a] = work.corners[face.b] = work.corners[face.c] = 1;
    }
    tables.without_area = face_count - kept;
    if (kept == 0) return Status::bad_shape;
    int corners = 0;
    for (int i = 0; i < point_count; ++i)
        if (work.corners[i] != 0) work.corners[corners++] = lattice::key_of_point(points[i]);
    corners = sort_and_merge(work.corners, work.aside, corners, 0);
    if (corners > lattice::last) return Status::no_room;
    tables.corner_count = corners;
    for (int i = 0; i < corners; ++i) tables.corners[i] = lattice::point_of_key(work.corners[i]);  // bound: corners given

    int triangles = 0;
    for (int i = 0; i < face_count; ++i) {
        const LatticePoint &a = points[faces[i].a], &b = points[faces[i].b], &c = points[faces[i].c];
        if (!lattice::has_area(a, b, c)) continue;
        work.triangles[triangles++] =
            key_of_triangle(place_of(lattice::key_of_point(a), work.corners, corners), place_of(lattice::key_of_point(b), work.corners, corners),
                            place_of(lattice::key_of_point(c), work.corners, corners), faces[i].material);
    }
    tables.triangle_count = sort_and_merge(work.triangles, work.aside, triangles, 8);
    tables.doubled = triangles - tables.triangle_count;
    return tables.triangle_count > lattice::last ? Status::no_room : Status::ok;
}

/// What lies beyond each edge. An edge has a neighbour where two triangles have it, each the other way round.
constexpr void look_at_edges(Workspace& work, const Tables& tables) {
    const int count = 3 * tables.triangle_count;
    for (int i = 0; i < count; ++i) {  // bound: three a triangle
        const uint64_t key = work.triangles[i / 3];
        const int a = corner_of_key(key, i % 3), b = corner_of_key(key, (i + 1) % 3);
        const auto low = static_cast<uint64_t>(a < b ? a : b), high = static_cast<uint64_t>(a < b ? b : a);
        work.edges[i] = low << 36 | high << 20 | static_cast<uint64_t>(i);
        if (i % 3 == 0) work.kinds[i / 3] = 0;
    }
    lattice::sort_keys(work.edges, work.aside, count);
    // bound: three a triangle: end is after begin
    for (int begin = 0, end = 0; begin < count; begin = end) {
        end = begin + 1;
        // bound: three a triangle
        while (end < count && work.edges[end] >> 20 == work.edges[begin] >> 20) ++end;
        if (end - begin != 2) continue;
        const int edge = static_cast<int>(work.edges[begin] & 0xfffff), other = static_cast<int>(work.edges[begin + 1] & 0xfffff);
        const uint64_t triangle = work.triangles[edge / 3], neighbour = work.triangles[other / 3];
        const int a = corner_of_key(triangle, edge % 3);
        if (a == corner_of_key(neighbour, other % 3)) continue;  // the same way round: one of them is inside out
        const EdgeKind kind =
            lattice::kind_of_edge(tables.corners[a], tables.corners[corner_of_key(triangle, (edge + 1) % 3)],
                                  tables.corners[corner_of_key(triangle, (edge + 2) % 3)], tables.corners[corner_of_key(neighbour, (other + 2) % 3)]);
        work.kinds[edge / 3] = static_cast<uint8_t>(work.kinds[edge / 3] | static_cast<int>(kind) << 2 * (edge % 3));
        work.kinds[other / 3] = static_cast<uint8_t>(work.kinds[other / 3] | static_cast<int>(kind) << 2 * (other % 3));
    }
}

/// The triangles by where their middle is, along each axis.
constexpr void sort_along_axes(Workspace& work, const Tables& tables) {
    const int count = tables.triangle_count;
    for (int i = 0; i < count; ++i) {  // bound: triangles
        const uint64_t key = work.triangles[i];
        work.boxes[i] =
            lattice::box_of(tables.corners[corner_of_key(key, 0)], tables.corners[corner_of_key(key, 1)], tables.corners[corner_of_key(key, 2)]);
    }
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < count; ++i) {
            const auto middle = static_cast<uint64_t>(work.boxes[i].low[axis] + work.boxes[i].high[axis]);
            work.edges[i] = middle << 20 | static_cast<uint64_t>(i);
        }
        lattice::sort_keys(work.edges, work.aside, count);
        for (int i = 0; i < count; ++i) work.order[axis][i] = static_cast<int>(work.edges[i] & 0xfffff);
    }
}

/// Triangles that will be a child of a node: the same, in each order, from begin to end.
struct Part {
    int begin{}, end{};
    uint64_t area{};

    constexpr int count() const { return end - begin; }
    constexpr uint64_t work() const { return area * static_cast<uint64_t>(count()); }
    constexpr bool is_leaf() const { return count() <= MeshTable::triangles_of_leaf_max; }
};

constexpr lattice::Box box_of_part(const Workspace& work, const Part& part) {
    lattice::Box box = work.boxes[work.order[0][part.begin]];
    for (int i = part.begin + 1; i < part.end; ++i) lattice::hold(box, work.boxes[work.order[0][i]]);  // bound: triangles
    return box;
}

/// Where a part is cut: so many triangles to the left of it along the axis.
struct Cut {
    int axis{}, left{};
    uint64_t cost{~uint64_t{}};
};

/// What triangles of a box cost: how often it is looked at, by its area, times what is in it, in leaves.
constexpr uint64_t cost_of(uint64_t area, int count) {
    constexpr int leaf = MeshTable::triangles_of_leaf_max;
    return (area + 1) * static_cast<uint64_t>((count + leaf - 1) / leaf);
}

/// The cut that costs least, of those that leave no more than `room` children's worth: a child takes up to `capacity` triangles. Of equals the one
/// along the first axis, furthest to the left.
///
/// Source: MacDonald and Booth, "Heuristics for ray tracing using space subdivision", 1990.
constexpr Cut best_cut(Workspace& work, const Part& part, int capacity, int room) {
    Cut best{};
    for (int axis = 0; axis < 3; ++axis) {
        const int* order = work.order[axis];
        lattice::Box box = work.boxes[order[part.end - 1]];
        for (int i = part.end - 1; i > part.begin; --i) {  // bound: triangles
            lattice::hold(box, work.boxes[order[i]]);
            work.aside[i] = lattice::half_area(box);
        }
        box = work.boxes[order[part.begin]];
        for (int i = part.begin + 1; i < part.end; ++i) {  // bound: triangles
            const int left = i - part.begin, right = part.end - i;
            lattice::hold(box, work.boxes[order[i - 1]]);
            if ((left + capacity - 1) / capacity + (right + capacity - 1) / capacity > room) continue;
            const uint64_t cost = cost_of(lattice::half_area(box), left) + cost_of(work.aside[i], right);
            if (cost < best.cost) best = {axis, left, cost};
        }
    }
    return best;
}

/// Orders the part so that in each order the left ones come first, and the order is kept on both sides.
constexpr void cut_part(Workspace& work, const Part& part, const Cut& cut) {
    for (int i = part.begin; i < part.end; ++i) work.left[work.order[cut.axis][i]] = i < part.begin + cut.left;  // bound: triangles
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == cut.axis) continue;
        int* order = work.order[axis];
        int left = part.begin, right = 0;
        for (int i = part.begin; i < part.end; ++i) {
            if (work.left[order[i]])
                order[left++] = order[i];
            else
                work.aside[right++] = static_cast<uint64_t>(order[i]);
        }
        for (int i = 0; i < right; ++i) order[left + i] = static_cast<int>(work.aside[i]);  // bound: triangles
    }
}

/// Cuts what is in a node into up to four children, of up to `capacity` triangles. Returns how many.
constexpr int cut_node(Workspace& work, Part (&parts)[MeshNode::children], int capacity) {
    int count = 1;
    for (int cuts = 1; cuts < MeshNode::children; ++cuts) {
        int needed = 0;
        for (int i = 0; i < count; ++i) needed += (parts[i].count() + capacity - 1) / capacity;  // bound: MeshNode::children
        // The part that costs most: of those that must be cut, where no more cuts than these are left; then of those that are no leaves.
        const bool is_tight = needed == MeshNode::children;
        int chosen = -1;
        for (int i = 0; i < count; ++i) {
            const Part& part = parts[i];
            if (part.count() < 2 || (is_tight && part.count() <= capacity)) continue;
            if (chosen >= 0 && part.is_leaf() && !parts[chosen].is_leaf()) continue;
            const bool first = chosen < 0 || (parts[chosen].is_leaf() && !part.is_leaf());
            if (first || part.work() > parts[chosen].work()) chosen = i;
        }
        if (chosen < 0) break;
        Part& part = parts[chosen];
        const Cut cut = best_cut(work, part, capacity, MeshNode::children - needed + (part.count() + capacity - 1) / capacity);
        cut_part(work, part, cut);
        parts[count] = {part.begin + cut.left, part.end, 0};
        part.end = part.begin + cut.left;
        part.area = lattice::half_area(box_of_part(work, part));
        parts[count].area = lattice::half_area(box_of_part(work, parts[count]));
        ++count;
    }
    return count;
}

/// The triangles of a leaf, in the order of their corners.
constexpr void write_leaf(Workspace& work, Tables& tables, const Part& part, int first) {
    int* numbers = work.order[0];
    for (int i = part.begin + 1; i < part.end; ++i) {  // bound: triangles_of_leaf_max
        const int number = numbers[i];
        int at = i;
        for (; at > part.begin && numbers[at - 1] > number; --at) numbers[at] = numbers[at - 1];  // bound: triangles_of_leaf_max
        numbers[at] = number;
    }
    for (int i = part.begin; i < part.end; ++i) {
        const uint64_t key = work.triangles[numbers[i]];
        LatticeTriangle& triangle = tables.triangles[first + i - part.begin];
        for (int k = 0; k < 3; ++k) triangle.corners[k] = static_cast<uint16_t>(corner_of_key(key, k));
        triangle.edges = work.kinds[numbers[i]];
        triangle.material = static_cast<uint8_t>(key & 255);
    }
}

/// Box and shifts of a node of these children.
constexpr void write_boxes(MeshNode& node, const lattice::Box (&boxes)[MeshNode::children], int count) {
    lattice::Box all = boxes[0];
    for (int i = 1; i < count; ++i) lattice::hold(all, boxes[i]);  // bound: MeshNode::children
    node.origin = {all.low[0], all.low[1], all.low[2]};
    for (int axis = 0; axis < 3; ++axis) {
        const int extent = all.high[axis] - all.low[axis];
        int shift = 0;
        for (; extent > 255 << shift; ++shift) {  // bound: 9: 255 * 2^9 is beyond the lattice
        }
        node.shifts = static_cast<uint16_t>(node.shifts | shift << 4 * axis);
        for (int i = 0; i < count; ++i) {
            node.low[axis][i] = static_cast<uint8_t>((boxes[i].low[axis] - all.low[axis]) >> shift);
            node.high[axis][i] = static_cast<uint8_t>((boxes[i].high[axis] - all.low[axis] + (1 << shift) - 1) >> shift);
        }
    }
}

/// The tree, level by level: children of a node lie behind those of the node before it.
constexpr void build_tree(Workspace& work, Tables& tables) {
    constexpr int leaf = MeshTable::triangles_of_leaf_max;
    tables.node_count = 1;
    work.begin[0] = 0;
    work.end[0] = tables.triangle_count;
    int written = 0, level_end = 1, depth = 1;
    for (int node_i = 0; node_i < tables.node_count; ++node_i) {  // bound: node_room
        if (node_i == level_end) {
            level_end = tables.node_count;
            ++depth;
        }
        // What a child may hold, so that the levels below it are enough. More than all from six levels on.
        const int levels = MeshTable::depth_max - depth;
        const int capacity = levels > 6 ? leaf << 12 : leaf << 2 * levels;
        Part parts[MeshNode::children] = {{work.begin[node_i], work.end[node_i], 0}};
        const int count = cut_node(work, parts, capacity);

        MeshNode node{};
        node.first_node = static_cast<uint16_t>(tables.node_count);
        node.first_triangle = static_cast<uint16_t>(written);
        lattice::Box boxes[MeshNode::children] = {};
        for (int i = 0; i < count; ++i) {  // bound: MeshNode::children
            const Part& part = parts[i];
            boxes[i] = box_of_part(work, part);
            const int content = part.is_leaf() ? part.count() : MeshNode::inner;
            node.counts = static_cast<uint16_t>(node.counts | content << 4 * i);
            if (part.is_leaf()) {
                write_leaf(work, tables, part, written);
                written += part.count();
            } else {
                work.begin[tables.node_count] = part.begin;
                work.end[tables.node_count++] = part.end;
            }
        }
        write_boxes(node, boxes, count);
        tables.nodes[node_i] = node;
    }
}

/// Errors: out_of_range (a number of a corner), bad_shape (no triangle has an area), no_room (more than 65535 corners or triangles).
constexpr Status build(const LatticePoint* points, int point_count, const LevelFace* faces, int face_count, Workspace& work, Tables& tables) {
    const Status status = weld(points, point_count, faces, face_count, work, tables);
    if (status != Status::ok) return status;
    look_at_edges(work, tables);
    sort_along_axes(work, tables);
    build_tree(work, tables);
    return Status::ok;
}

}  // namespace meshes
}}  // namespace ingot::INGOT_ABI
