// SPDX-License-Identifier: MIT
#include "height_walk.h"
#include "lattice_steps.h"
#include "level_walk.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// A ray as boxes and triangles want it. Axes in turn, the third that along which it goes furthest, so that what faces it turns clockwise.
struct LevelRay {
    scalar from[3], way[3];
    int x, y, z;  ///< axes
    scalar shear_x, shear_y, inv_z;
    scalar inv[3];
    bool is_still[3];  ///< goes along this axis by no more than the margin
    scalar margin;     ///< m, see lay_ray
};

/// Corners of a triangle are seen from the start of the ray, m away at most, along axes that are sheared so that the ray is one of them: each lies
/// then within 2 epsilon m of where it should be. What a box of nodes says of a ray is off by 2 epsilon m too. With twice that to spare no node is
/// passed by that has a triangle the ray meets.
constexpr scalar margin_share = 8 * epsilon;

bool lay_ray(const LevelTable& level, const Vector& from, const Vector& way, LevelRay& ray) {
    if (!is_finite(from) || !is_finite(way)) return false;
    const Vector reach = max(max(level.low - from, from - level.low), max(level.high - from, from - level.high));
    const scalar furthest = max(max(reach.x, reach.y), reach.z);
    ray.margin = margin_share * furthest;
    const scalar start[3] = {from.x, from.y, from.z}, along[3] = {way.x, way.y, way.z};
    ray.z = abs(way.x) > abs(way.y) ? (abs(way.x) > abs(way.z) ? 0 : 2) : (abs(way.y) > abs(way.z) ? 1 : 2);
    ray.x = ray.z == 2 ? 0 : ray.z + 1;
    ray.y = ray.x == 2 ? 0 : ray.x + 1;
    const scalar longest = along[ray.z];
    if (!(abs(longest) > 0)) return false;
    if (longest < 0) {
        const int kept = ray.x;
        ray.x = ray.y;
        ray.y = kept;
    }
    for (int axis = 0; axis < 3; ++axis) {
        ray.from[axis] = start[axis];
        ray.way[axis] = along[axis];
        ray.is_still[axis] = abs(along[axis]) <= ray.margin;
        ray.inv[axis] = ray.is_still[axis] ? 0 : 1 / along[axis];
    }
    ray.inv_z = 1 / longest;
    ray.shear_x = along[ray.x] / longest;
    ray.shear_y = along[ray.y] / longest;
    return true;
}

/// Where the ray enters a box, of its way; false where it passes by, or comes there after `end`.
bool enters(const LevelRay& ray, const scalar (&low)[3], const scalar (&high)[3], scalar end, scalar& begin) {
    begin = 0;
    for (int axis = 0; axis < 3; ++axis) {
        // What is still may move by the margin.
        const scalar margin = ray.is_still[axis] ? 2 * ray.margin : ray.margin;
        const scalar to_low = low[axis] - margin - ray.from[axis], to_high = high[axis] + margin - ray.from[axis];
        if (ray.is_still[axis]) {
            if (to_low > 0 || to_high < 0) return false;
            continue;
        }
        const scalar a = to_low * ray.inv[axis], b = to_high * ray.inv[axis];
        begin = max(begin, min(a, b));
        end = min(end, max(a, b));
    }
    return begin <= end;
}

/// Takes the triangle for the hit where the ray meets it from outside, before the hit, or there with a lesser number. Watertight: rounding does not
/// turn two products round, it makes them equal at most. So an edge is never on the wrong side of the ray, and one that is on neither belongs to
/// both of its triangles.
///
/// Source: Woop, Benthin and Wald, "Watertight ray/triangle intersection", 2013.
void meet_triangle(const LevelRay& ray, const LevelTriangle& triangle, LevelHit& hit, bool& is_met) {
    scalar x[3], y[3], z[3];
    for (int i = 0; i < 3; ++i) {
        const Vector& corner = triangle.corners[i];
        const scalar place[3] = {corner.x, corner.y, corner.z};
        z[i] = place[ray.z] - ray.from[ray.z];
        x[i] = (place[ray.x] - ray.from[ray.x]) - ray.shear_x * z[i];
        y[i] = (place[ray.y] - ray.from[ray.y]) - ray.shear_y * z[i];
    }
    const scalar u = x[2] * y[1] - y[2] * x[1], v = x[0] * y[2] - y[0] * x[2], w = x[1] * y[0] - y[1] * x[0];
    if (!(u >= 0 && v >= 0 && w >= 0)) return;
    const scalar sum = u + v + w;
    if (!(sum > 0)) return;
    const scalar fraction = (u * z[0] + v * z[1] + w * z[2]) * ray.inv_z / sum;
    if (!(fraction >= 0 && fraction <= 1)) return;
    if (is_met && !(fraction < hit.fraction || (fraction == hit.fraction && triangle.number < hit.triangle))) return;
    hit = {fraction, triangle.number};
    is_met = true;
}

/// A node that waits, and where the ray enters it.
struct WaitingNode {
    uint16_t number;
    scalar begin;
};

/// Puts a node on the stack below those that come first.
void put_in_order(WaitingNode* stack, int first, int& count, const WaitingNode& node) {
    int at = count++;
    for (; at > first && stack[at - 1].begin < node.begin; --at) stack[at] = stack[at - 1];  // bound: MeshNode::children
    stack[at] = node;
}

/// Box of a child, m.
void box_of_child(const LevelTable& level, const MeshNode& node, int k, scalar (&low)[3], scalar (&high)[3]) {
    const scalar origin[3] = {level.origin.x, level.origin.y, level.origin.z};
    const int first[3] = {node.origin.x, node.origin.y, node.origin.z};
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = corner_along(origin[axis], level.step, first[axis] + (node.low[axis][k] << node.shift(axis)));
        high[axis] = corner_along(origin[axis], level.step, first[axis] + (node.high[axis][k] << node.shift(axis)));
    }
}

/// The leaves of a node; its nodes are put on the stack.
void meet_node(const LevelTable& level, const LevelRay& ray, int number, WaitingNode* stack, int& waiting, LevelHit& hit, bool& is_met) {
    const MeshTable& mesh = level.mesh;
    const MeshNode& node = mesh.nodes[number];
    int child = node.first_node, triangle = node.first_triangle;
    const int first_waiting = waiting;
    for (int k = 0; k < MeshNode::children; ++k) {
        const int count = node.count(k);
        if (count == 0 || count > MeshNode::inner) continue;
        const int begin_triangle = triangle, child_number = child;
        if (count == MeshNode::inner)
            ++child;
        else
            triangle += count;
        scalar low[3], high[3], begin;
        box_of_child(level, node, k, low, high);
        if (!enters(ray, low, high, is_met ? hit.fraction : scalar(1), begin)) continue;
        if (count == MeshNode::inner) {
            if (child_number < mesh.node_count && waiting < MeshTable::stack_max)
                put_in_order(stack, first_waiting, waiting, {static_cast<uint16_t>(child_number), begin});
        } else if (triangle <= mesh.triangle_count) {
            for (int i = begin_triangle; i < triangle; ++i)  // bound: MeshTable::triangles_of_leaf_max
                meet_triangle(ray, triangle_of(level, static_cast<uint32_t>(i)), hit, is_met);
        }
    }
}

bool cast_ray_on_mesh(const LevelTable& level, const LevelRay& ray, LevelHit& hit) {
    WaitingNode stack[MeshTable::stack_max];
    int waiting = 1, nodes_left = level.mesh.node_count;
    stack[0] = {0, 0};
    bool is_met = false;
    for (; waiting > 0 && nodes_left > 0; --nodes_left) {  // bound: nodes of the mesh, each once
        const WaitingNode node = stack[--waiting];
        if (is_met && node.begin > hit.fraction) continue;
        meet_node(level, ray, node.number, stack, waiting, hit, is_met);
    }
    return is_met;
}

/// Box of a block, or of a cell, m.
void box_of_block(const LevelTable& level, const grid::Place& place, scalar (&low)[3], scalar (&high)[3]) {
    const HeightTable& heights = level.heights;
    const int cells[2] = {grid::cells_of(heights.columns), grid::cells_of(heights.rows)};
    const scalar origin[2] = {level.origin.x, level.origin.y}, spacing[2] = {heights.spacing_x, heights.spacing_y};
    for (int axis = 0; axis < 2; ++axis) {
        const int first = place.at[axis] << 3 * place.level, end = (place.at[axis] + 1) << 3 * place.level;
        low[axis] = corner_along(origin[axis], spacing[axis], first);
        high[axis] = corner_along(origin[axis], spacing[axis], end < cells[axis] ? end : cells[axis]);
    }
    const int block_level = place.level > 0 ? place.level : 1;
    const int up = 3 * (block_level - place.level);
    const uint16_t* extremes = extremes_of_block(heights, block_level, place.at[0] >> up, place.at[1] >> up);
    low[2] = corner_along(level.origin.z, level.step, extremes[0]);
    high[2] = corner_along(level.origin.z, level.step, extremes[1]);
}

bool cast_ray_on_heights(const LevelTable& level, const LevelRay& ray, LevelHit& hit) {
    const HeightTable& heights = level.heights;
    scalar low[2], high[2];
    for (int axis = 0; axis < 2; ++axis) {
        const scalar end = ray.from[axis] + ray.way[axis];
        low[axis] = min(ray.from[axis], end) - ray.margin;
        high[axis] = max(ray.from[axis], end) + ray.margin;
    }
    int first[2], last[2];
    if (!cells_between(low[0], high[0], level.origin.x, heights.spacing_x, heights.columns, first[0], last[0]) ||
        !cells_between(low[1], high[1], level.origin.y, heights.spacing_y, heights.rows, first[1], last[1]))
        return false;
    grid::Place place = grid::place_over(first[0], last[0], first[1], last[1]);
    bool is_met = false;
    // bound: blocks of the field
    do {
        scalar box_low[3], box_high[3], begin;
        box_of_block(level, place, box_low, box_high);
        // bound: grid::levels_max
        while (place.level > 0 && enters(ray, box_low, box_high, is_met ? hit.fraction : scalar(1), begin)) {
            place.descend();
            box_of_block(level, place, box_low, box_high);
        }
        if (place.level > 0 || !enters(ray, box_low, box_high, is_met ? hit.fraction : scalar(1), begin)) continue;
        const uint32_t cell =
            static_cast<uint32_t>(place.at[1]) * static_cast<uint32_t>(grid::cells_of(heights.columns)) + static_cast<uint32_t>(place.at[0]);
        if (heights.cells != nullptr && heights.cells[cell] == HeightTable::hole) continue;
        for (uint32_t half = 0; half < 2; ++half) meet_triangle(ray, triangle_of(level, 2 * cell + half), hit, is_met);
    } while (place.advance());
    return is_met;
}

}  // namespace

bool cast_ray_on_level(const LevelTable& level, const Vector& from, const Vector& way, LevelHit& hit) {
    LevelRay ray;
    if (!lay_ray(level, from, way, ray)) return false;
    if (level.is_mesh()) return level.mesh.node_count > 0 && cast_ray_on_mesh(level, ray, hit);
    return level.heights.columns >= 2 && level.heights.rows >= 2 && cast_ray_on_heights(level, ray, hit);
}

}}  // namespace ingot::INGOT_ABI
