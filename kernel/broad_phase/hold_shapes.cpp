// SPDX-License-Identifier: MIT
#include "hold_shapes.h"

#include "bound_shape.h"
#include "tree_walk.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

using namespace trees;

/// A half space ends at its face where that lies along two axes, to the bit; what its n has beside them counts for much far away.
TreeBox box_of_half_space(const Vector& r, const Vector& n, scalar offset) {
    const scalar n_of[3] = {n.x, n.y, n.z}, r_of[3] = {r.x, r.y, r.z};
    scalar low[3], high[3];
    const scalar slack = 16 * epsilon * (abs(r.x) + abs(r.y) + abs(r.z) + abs(offset));
    for (int axis = 0; axis < 3; ++axis) {
        const bool alone = n_of[(axis + 1) % 3] == 0 && n_of[(axis + 2) % 3] == 0;
        low[axis] = alone && n_of[axis] == -1 ? r_of[axis] - offset - slack : -limits::unbounded;
        high[axis] = alone && n_of[axis] == 1 ? r_of[axis] + offset + slack : limits::unbounded;
    }
    return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

/// Where a shape is. Flatness, and a rounding of its place.
TreeBox box_now(const SearchView& search, int slot) {
    const Place at = place_of(slot);
    const Surface& surface = search.surfaces.surfaces[slot];
    const Vector r = lane_of(search.shapes.translation[at.tile].r_CM, at.lane);
    const Matrix A = lane_of(search.shapes.rotation[at.tile].A, at.lane);
    if (surface.shape.kind == ShapeKind::half_space) return box_of_half_space(r, A * surface.shape.size, surface.shape.offset);
    const Vector reach = bounding::reach_of(surface, A) * (1 + limits::flatness);
    return {r - reach, r + reach};
}

bool holds(const TreeLeaf& leaf, int i, const TreeBox& box) {
    return leaf.low[0][i] <= box.low.x && leaf.low[1][i] <= box.low.y && leaf.low[2][i] <= box.low.z && box.high.x <= leaf.high[0][i] &&
           box.high.y <= leaf.high[1][i] && box.high.z <= leaf.high[2][i];
}

void hold_shape(const SearchView& search, const SortedTreeView& tree, int slot) {
    if (search.surfaces.surfaces[slot].shape.kind == ShapeKind::none) return;
    const TreeBox now = box_now(search, slot);
    const int place = tree.place[slot] - 1;
    if (place >= 0 && holds(tree.leaves[place / leaf_bodies], place % leaf_bodies, now)) return;
    // The search goes by fat AABBs, and may leave this one as it is: it stays within the box. A blank tile has none yet.
    const bool bounded = !is_blank(search.bounds[place_of(slot).tile]);
    put_in_place(tree, slot, bounded ? around(box_of(search.bounds, slot), now) : now, search.moves(slot));
}

}  // namespace

void hold_shapes(const SearchView& search, const SortedTreeView& tree, int first, int last) {
    if (*tree.used == 0) return;
    for (int slot = first; slot < last; ++slot) hold_shape(search, tree, slot);  // bound: max_bodies max_shapes_of_body
}

} }  // namespace ingot
