// SPDX-License-Identifier: MIT
#include "wake.h"

namespace ingot { inline namespace INGOT_ABI {

void stand_up(const BodyView& bodies, const RestView& rest, int slot) {
    RestView::set(rest.awake, slot);
    rest.slow_for[slot] = 0;
    uint16_t& kicked = bodies.rotation[place_of(slot).tile].kicked;
    kicked = static_cast<uint16_t>(kicked | 1u << place_of(slot).lane);
}

void begin_awake(const RestView& rest, int slot) {
    RestView::set(rest.awake, slot);
    rest.slow_for[slot] = 0;
    rest.parent[slot] = static_cast<uint16_t>(slot);
}

void wake_island(const BodyView& bodies, const RestView& rest, int slot) {
    if (rest.is_awake(slot)) {
        rest.slow_for[slot] = 0;
        return;
    }
    const int island = rest.root(slot);
    for (int other = 0; other < bodies.tile_count * lanes; ++other)
        if (is_free(bodies, other) && !rest.is_awake(other) && rest.root(other) == island) stand_up(bodies, rest, other);
}

void stir(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot) {
    if (is_free(bodies, slot)) return wake_island(bodies, rest, slot);
    RestView::set(rest.awake, slot);
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {
        const BodyPair& pair = manifolds.pairs[manifold_i];
        if (pair.body_A != slot && pair.body_B != slot) continue;
        const int other = pair.body_A == slot ? pair.body_B : pair.body_A;
        if (is_free(bodies, other)) wake_island(bodies, rest, other);
    }
}

void stir_and_leave(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot) {
    stir(bodies, rest, manifolds, slot);
    RestView::clear(rest.awake, slot);
    RestView::set(rest.due, slot);  // the next step learns that the slot is empty
    rest.slow_for[slot] = 0;
}

void wake_all(const BodyView& bodies, const RestView& rest) {
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot)
        if (is_free(bodies, slot)) stand_up(bodies, rest, slot);
}

} }  // namespace ingot
