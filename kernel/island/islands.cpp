// SPDX-License-Identifier: MIT
#include "islands.h"

namespace ingot { inline namespace INGOT_ABI {

void join_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds) {
    const auto alone = [&](int slot) { rest.islands().make_set(slot); };
    for_slots(rest.awake, bodies.tile_count, alone);
    for_slots(rest.settling, bodies.tile_count, alone);
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {  // bound: max_manifolds
        const int A = manifolds.pairs[manifold_i].body_A, B = manifolds.pairs[manifold_i].body_B;
        if ((rest.is_active(A) || rest.is_active(B)) && is_dynamic(bodies, A) && is_dynamic(bodies, B)) rest.islands().join(A, B);
    }
}

void join_all_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds) {
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot) rest.islands().make_set(slot);  // bound: max_bodies, rounded up to whole tiles
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {
        const int A = manifolds.pairs[manifold_i].body_A, B = manifolds.pairs[manifold_i].body_B;
        if (is_dynamic(bodies, A) && is_dynamic(bodies, B)) rest.islands().join(A, B);
    }
}

} }  // namespace ingot
