// SPDX-License-Identifier: MIT
#include "islands.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

void swap(Index& a, Index& b) {
    const Index before = a;
    a = b;
    b = before;
}

/// Two rings become one where two of their members exchange what follows them.
void join(const RestView& rest, int A, int B) {
    const int root_A = rest.root(A), root_B = rest.root(B);
    if (root_A == root_B) return;
    const int low = root_A < root_B ? root_A : root_B, high = root_A < root_B ? root_B : root_A;
    rest.islands().join(low, high);
    swap(rest.next_body[low], rest.next_body[high]);
    if (rest.aside[high] == 0) return;
    if (rest.aside[low] != 0)
        swap(rest.pairs_aside[rest.aside[low] - 1].record, rest.pairs_aside[rest.aside[high] - 1].record);
    else
        rest.aside[low] = rest.aside[high];
    rest.aside[high] = 0;
}

void join_pairs(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds) {
    // bound: max_manifolds
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {
        const int A = rest.body_of(manifolds.pairs[manifold_i].body_A), B = rest.body_of(manifolds.pairs[manifold_i].body_B);
        if (is_dynamic(bodies, A) && is_dynamic(bodies, B)) join(rest, A, B);
    }
}

}  // namespace

void join_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds) {
    for_active(rest, [&](int slot) { rest.make_alone(slot); });
    join_pairs(bodies, rest, manifolds);
}

void join_bodies_of(const RestView& rest, int slot_A, int slot_B) { join(rest, slot_A, slot_B); }

void join_all_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds) {
    // bound: max_bodies, rounded up to whole tiles
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot) rest.make_alone(slot);
    join_pairs(bodies, rest, manifolds);
}

} }  // namespace ingot
