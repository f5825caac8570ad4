// SPDX-License-Identifier: MIT
#pragma once

#include "../base/config.h"

namespace ingot { inline namespace INGOT_ABI {

/// Union-find over numbers 0 .. n - 1, in an array of parents. The root of a set is its lowest number, whatever the order of joins.
///
/// Cost:   logarithmic in the mean, for it has no ranks; never recursive.
/// Source: Tarjan and van Leeuwen, "Worst-case analysis of set union algorithms", 1984: path halving.
struct DisjointSets {
    Index* parent;

    void make_set(int number) const { parent[number] = static_cast<Index>(number); }

    /// Halves the path on its way, so that the next way is shorter.
    int root(int number) const {
        while (parent[number] != number) {  // bound: max_bodies: number falls each turn, for a parent is never higher
            parent[number] = parent[parent[number]];
            number = parent[number];
        }
        return number;
    }
    void join(int a, int b) const {
        const int root_a = root(a), root_b = root(b);
        if (root_a < root_b) parent[root_b] = static_cast<Index>(root_a);
        if (root_b < root_a) parent[root_a] = static_cast<Index>(root_b);
    }
};

} }  // namespace ingot
