// SPDX-License-Identifier: MIT
#include "islands.h"

#include "wake.h"

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
    for_slots(rest.due, bodies.tile_count, alone);
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {
        const int A = manifolds.pairs[manifold_i].body_A, B = manifolds.pairs[manifold_i].body_B;
        if ((rest.stirs(A) || rest.stirs(B)) && is_free(bodies, A) && is_free(bodies, B)) join(rest, A, B);
    }
}

void join_all_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds) {
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot) rest.parent[slot] = static_cast<uint16_t>(slot);
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {
        const int A = manifolds.pairs[manifold_i].body_A, B = manifolds.pairs[manifold_i].body_B;
        if (is_free(bodies, A) && is_free(bodies, B)) join(rest, A, B);
    }
}

void wake_met_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds) {
    bool some_met = false;
    const auto sleeper_met = [&](const BodyPair& pair) -> int {
        const bool A_awake = rest.is_awake(pair.body_A);
        return A_awake == rest.is_awake(pair.body_B) ? -1 : A_awake ? pair.body_B : pair.body_A;
    };
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {
        const int met = sleeper_met(manifolds.pairs[manifold_i]);
        if (met < 0 || !is_free(bodies, met)) continue;
        if (!some_met)
            for (int slot = 0; slot < bodies.tile_count * lanes; ++slot) rest.marks[slot] = 0;
        some_met = true;
        rest.marks[rest.root(met)] = 1;
    }
    if (!some_met) return;
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot)
        if (is_free(bodies, slot) && !rest.is_awake(slot) && rest.marks[rest.root(slot)] != 0) stand_up(bodies, rest, slot);
}

void list_awake_pairs(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, BodyPair* awake_pairs, uint16_t& count) {
    count = 0;
    const auto moves = [&](int slot) { return rest.is_awake(slot) && is_free(bodies, slot); };
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {
        const BodyPair& pair = manifolds.pairs[manifold_i];
        if (moves(pair.body_A) || moves(pair.body_B)) awake_pairs[count++] = pair;
    }
}

} }  // namespace ingot
