// SPDX-License-Identifier: MIT
#include "wake.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Wakes one body, and no other of its island. Its flight begins anew: a rotation that remembers the energy of a flight forgets it.
void wake_body(const BodyView& bodies, const RestView& rest, int slot) {
    rest.wake(slot);
    rest.rest_time[slot] = 0;
    uint16_t& kicked = bodies.rotation[place_of(slot).tile].kicked;
    kicked = static_cast<uint16_t>(kicked | 1u << place_of(slot).lane);
}

/// The manifolds of an island that were put aside are manifolds of the step again.
void bring_back(const RestView& rest, const ManifoldView& manifolds, int root) {
    const int first = rest.aside[root];
    // bound: max_manifolds: a ring of records, which ends where it began
    for (int at = first; at != 0;) {
        BodyPair& pair = rest.pairs_aside[at - 1];
        const int next = pair.record;
        manifolds.pairs[(*manifolds.count)++] = {pair.body_A, pair.body_B, static_cast<Index>(at - 1)};
        --*rest.aside_count;
        pair = {};
        at = next == first ? 0 : next;
    }
    rest.aside[root] = 0;
}

}  // namespace

void begin_awake(const RestView& rest, int slot) {
    rest.wake(slot);
    rest.rest_time[slot] = 0;
    rest.make_alone(slot);
}

void wake_island(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot) {
    if (rest.is_awake(slot)) {
        rest.rest_time[slot] = 0;
        return;
    }
    bring_back(rest, manifolds, rest.root(slot));
    int other = slot;
    // bound: max_bodies: a ring of bodies, which ends where it began
    do {
        if (!rest.is_awake(other)) wake_body(bodies, rest, other);
        other = rest.next_body[other];
    } while (other != slot);
}

void wake_touching(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot) {
    if (is_dynamic(bodies, slot)) return wake_island(bodies, rest, manifolds, slot);
    rest.wake(slot);
    const auto wake_partner = [&](const BodyPair& pair) {
        const int A = rest.body_of(pair.body_A), B = rest.body_of(pair.body_B), other = A == slot ? B : A;
        if ((A == slot || B == slot) && is_dynamic(bodies, other)) wake_island(bodies, rest, manifolds, other);
    };
    const int in_step = *manifolds.count;  // those that come back are behind them, and their bodies are awake
    // bound: max_manifolds
    for (int manifold_i = 0; manifold_i < in_step; ++manifold_i) wake_partner(manifolds.pairs[manifold_i]);
    // bound: max_manifolds: record_i grows each turn
    for (int record_i = 0; record_i < *manifolds.records_used && *rest.aside_count != 0; ++record_i) wake_partner(rest.pairs_aside[record_i]);
}

void wake_touching_and_leave(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, int slot) {
    wake_touching(bodies, rest, manifolds, slot);
    rest.settle(slot);
    rest.rest_time[slot] = 0;
}

void wake_all(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds) {
    // bound: max_bodies, rounded up to whole tiles
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot) {
        if (!is_dynamic(bodies, slot)) continue;
        wake_island(bodies, rest, manifolds, slot);
        wake_body(bodies, rest, slot);
    }
}

void wake_met_islands(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds) {
    const int in_step = *manifolds.count;
    for (int manifold_i = 0; manifold_i < in_step; ++manifold_i) {
        const int A = rest.body_of(manifolds.pairs[manifold_i].body_A), B = rest.body_of(manifolds.pairs[manifold_i].body_B);
        if (rest.is_awake(A) == rest.is_awake(B)) continue;
        const int met = rest.is_awake(A) ? B : A;
        if (is_dynamic(bodies, met)) wake_island(bodies, rest, manifolds, met);
    }
}

void list_awake_pairs(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, BodyPair* awake_pairs, Index& count) {
    count = 0;
    const auto moves = [&](int slot) { return rest.is_awake(slot) && is_dynamic(bodies, slot); };
    // bound: max_manifolds
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {
        const BodyPair& pair = manifolds.pairs[manifold_i];
        const int A = rest.body_of(pair.body_A), B = rest.body_of(pair.body_B);
        if (moves(A) || moves(B)) awake_pairs[count++] = {static_cast<Index>(A), static_cast<Index>(B), pair.record};
    }
}

} }  // namespace ingot
