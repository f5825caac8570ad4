// SPDX-License-Identifier: MIT
#include "part_leaves.h"

#include "hold_shapes.h"
#include "tree_walk.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

using namespace trees;

constexpr int cell_bits = 21;  // along each axis: three are in the codes of both keys of a shape
constexpr uint32_t last_cell = (1u << cell_bits) - 1;
// In the code of the first key, where a Morton code, which a tree that is built anew has there, has no bits.
constexpr uint32_t outlived = 1u << 30, parted = 1u << 31;

/// Where a shape of the order is, in cells.
struct Cells {
    uint32_t along[3];
};

/// The order of the tree: slots in other_keys, and cells in the codes of both.
class LeafOrder {
public:
    explicit LeafOrder(const SortedTreeView& tree) : keys_(tree.keys), other_keys_(tree.other_keys), count_(*tree.used) {
        TreeBox all = nothing;
        // bound: max_bodies max_shapes_of_body
        for (int i = 0; i < count_; ++i) {
            const Vector centre = centre_at(tree, i);
            all = around(all, {centre, centre});
            other_keys_[i].slot = tree.leaves[i / leaf_bodies].slot[i % leaf_bodies];
        }
        const Vector size = all.high - all.low;
        const scalar widest = max(max(size.x, size.y), size.z), per_metre = widest > 0 ? scalar(last_cell) / widest : scalar(0);
        // bound: max_bodies max_shapes_of_body
        for (int i = 0; i < count_; ++i) {
            const Vector at = (centre_at(tree, i) - all.low) * per_metre;
            const uint64_t code = cell_at(at.x) | cell_at(at.y) << cell_bits | cell_at(at.z) << 2 * cell_bits;
            keys_[i].code = static_cast<uint32_t>(code >> 32);
            other_keys_[i].code = static_cast<uint32_t>(code);
        }
    }
    int count() const { return count_; }
    /// Those of [first, last) that are before `middle` lie no farther along the longest side of all of them than the others.
    void halve(int first, int last, int middle) {
        Cells low = cells(first), high = low;
        // bound: max_bodies max_shapes_of_body
        for (int i = first + 1; i < last; ++i) {
            const Cells at = cells(i);
            for (int axis = 0; axis < 3; ++axis) {
                low.along[axis] = at.along[axis] < low.along[axis] ? at.along[axis] : low.along[axis];
                high.along[axis] = at.along[axis] > high.along[axis] ? at.along[axis] : high.along[axis];
            }
        }
        int axis = 0;
        for (int other = 1; other < 3; ++other)
            if (high.along[other] - low.along[other] > high.along[axis] - low.along[axis]) axis = other;
        uint32_t least = low.along[axis], most = high.along[axis];
        // bound: cell_bits: the side halves each turn
        while (first < middle && least < most) {
            const uint32_t half = least + (most - least) / 2;
            const int beyond = put_first(first, last, axis, half);
            if (beyond > middle) {
                last = beyond;
                most = half;
            } else {
                first = beyond;
                least = half + 1;
            }
        }
    }

private:
    static uint64_t cell_at(scalar at) { return at > 0 ? static_cast<uint64_t>(at < last_cell ? at : scalar(last_cell)) : 0; }
    static Vector centre_at(const SortedTreeView& tree, int i) {
        const TreeLeaf& leaf = tree.leaves[i / leaf_bodies];
        const int k = i % leaf_bodies;
        return centre_of({{leaf.low[0][k], leaf.low[1][k], leaf.low[2][k]}, {leaf.high[0][k], leaf.high[1][k], leaf.high[2][k]}});
    }
    uint64_t code(int i) const { return static_cast<uint64_t>(keys_[i].code) << 32 | other_keys_[i].code; }
    uint32_t cell(int i, int axis) const { return static_cast<uint32_t>(code(i) >> cell_bits * axis) & last_cell; }
    Cells cells(int i) const { return {{cell(i, 0), cell(i, 1), cell(i, 2)}}; }
    void swap(int i, int k) {
        const TreeKey key = keys_[i], other_key = other_keys_[i];
        keys_[i] = keys_[k];
        other_keys_[i] = other_keys_[k];
        keys_[k] = key;
        other_keys_[k] = other_key;
    }
    /// Those of a cell up to `half` come first. Returns where the others begin.
    int put_first(int first, int last, int axis, uint32_t half) {
        // bound: max_bodies max_shapes_of_body: last - first is less after each turn
        while (first < last) {
            if (cell(first, axis) <= half) ++first;
            else if (cell(last - 1, axis) > half) --last;
            else swap(first++, --last);
        }
        return first;
    }

    TreeKey *keys_, *other_keys_;
    int count_;
};

}  // namespace

bool part_leaves(const SearchView& search, const SortedTreeView& tree) {
    uint32_t& mark = tree.keys[0].code;
    if (*tree.used == 0 || (mark & parted) != 0) return false;
    if ((mark & outlived) == 0) {
        mark |= outlived;
        return false;
    }
    LeafOrder order(tree);
    // bound: levels_max: places halve each turn
    for (int places = tree.leaf_places * leaf_bodies; places > leaf_bodies; places /= 2) {
        // bound: leaf_places
        for (int first = 0; first + places / 2 < order.count(); first += places)
            order.halve(first, first + places < order.count() ? first + places : order.count(), first + places / 2);
    }
    make_leaves(search.shapes, search.bounds, tree, order.count());
    note_places(tree, order.count());
    mark = parted;
    hold_shapes(search, tree, 0, search.surfaces.slot_count);
    return true;
}

} }  // namespace ingot
