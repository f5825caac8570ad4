// SPDX-License-Identifier: MIT
#include "islands.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

void join(const RestView& rest, int A, int B) {
    const int root_A = rest.root(A), root_B = rest.root(B);
    if (root_A < root_B) rest.parent[root_B] = static_cast<uint16_t>(root_A);
    if (root_B < root_A) rest.parent[root_A] = static_cast<uint16_t>(root_B);
}

}  // namespace

void join_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds) {
    const auto alone = [&](int slot) { rest.parent[slot] = static_cast<uint16_t>(slot); };
    for_slots(rest.awake, bodies.tile_count, alone);
    for_slots(rest.settling, bodies.tile_count, alone);
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {  // bound: max_manifolds
        const int A = manifolds.pairs[manifold_i].body_A, B = manifolds.pairs[manifold_i].body_B;
        if ((rest.is_active(A) || rest.is_active(B)) && is_dynamic(bodies, A) && is_dynamic(bodies, B)) join(rest, A, B);
    }
}

void join_all_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds) {
    // bound: max_bodies, rounded up to whole tiles
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot) rest.parent[slot] = static_cast<uint16_t>(slot);
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {
        const int A = manifolds.pairs[manifold_i].body_A, B = manifolds.pairs[manifold_i].body_B;
        if (is_dynamic(bodies, A) && is_dynamic(bodies, B)) join(rest, A, B);
    }
}

} }  // namespace ingot
