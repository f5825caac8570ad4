// SPDX-License-Identifier: MIT
#include "wake.h"

namespace ingot { inline namespace INGOT_ABI {

void wake_body(const BodyView& bodies, const RestView& rest, int slot) {
    RestView::set(rest.awake, slot);
    rest.rest_time[slot] = 0;
    uint16_t& kicked = bodies.rotation[place_of(slot).tile].kicked;
    kicked = static_cast<uint16_t>(kicked | 1u << place_of(slot).lane);
}

void begin_awake(const RestView& rest, int slot) {
    RestView::set(rest.awake, slot);
    rest.rest_time[slot] = 0;
    rest.parent[slot] = static_cast<uint16_t>(slot);
}

void wake_island(const BodyView& bodies, const RestView& rest, int slot) {
    if (rest.is_awake(slot)) {
        rest.rest_time[slot] = 0;
        return;
    }
    const int island = rest.root(slot);
    // bound: max_bodies, rounded up to whole tiles
    for (int other = 0; other < bodies.tile_count * lanes; ++other)
        if (is_dynamic(bodies, other) && !rest.is_awake(other) && rest.root(other) == island) wake_body(bodies, rest, other);
}

void wake_touching(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot) {
    if (is_dynamic(bodies, slot)) return wake_island(bodies, rest, slot);
    RestView::set(rest.awake, slot);
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {  // bound: max_manifolds
        const BodyPair& pair = manifolds.pairs[manifold_i];
        if (pair.body_A != slot && pair.body_B != slot) continue;
        const int other = pair.body_A == slot ? pair.body_B : pair.body_A;
        if (is_dynamic(bodies, other)) wake_island(bodies, rest, other);
    }
}

void wake_touching_and_leave(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot) {
    wake_touching(bodies, rest, manifolds, slot);
    RestView::clear(rest.awake, slot);
    RestView::set(rest.settling, slot);  // the next step learns that the slot is empty
    rest.rest_time[slot] = 0;
}

void wake_all(const BodyView& bodies, const RestView& rest) {
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot)
        if (is_dynamic(bodies, slot)) wake_body(bodies, rest, slot);
}

void wake_met_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds) {
    bool some_met = false;
    const auto sleeper_met = [&](const BodyPair& pair) -> int {
        const bool A_awake = rest.is_awake(pair.body_A);
        return A_awake == rest.is_awake(pair.body_B) ? -1 : A_awake ? pair.body_B : pair.body_A;
    };
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {
        const int met = sleeper_met(manifolds.pairs[manifold_i]);
        if (met < 0 || !is_dynamic(bodies, met)) continue;
        if (!some_met)
            for (int slot = 0; slot < bodies.tile_count * lanes; ++slot) rest.marks[slot] = 0;
        some_met = true;
        rest.marks[rest.root(met)] = 1;
    }
    if (!some_met) return;
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot)
        if (is_dynamic(bodies, slot) && !rest.is_awake(slot) && rest.marks[rest.root(slot)] != 0) wake_body(bodies, rest, slot);
}

void list_awake_pairs(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, BodyPair* awake_pairs, uint16_t& count) {
    count = 0;
    const auto moves = [&](int slot) { return rest.is_awake(slot) && is_dynamic(bodies, slot); };
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {
        const BodyPair& pair = manifolds.pairs[manifold_i];
        if (moves(pair.body_A) || moves(pair.body_B)) awake_pairs[count++] = pair;
    }
}

} }  // namespace ingot
