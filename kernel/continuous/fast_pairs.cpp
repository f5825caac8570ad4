// SPDX-License-Identifier: MIT
#include "fast_pairs.h"

#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

bool FastPairs::meets_hard(const BodyPair& pair, const Manifold& manifold) const {
    const ShapeSlot of_pair[2] = {{pair.body_A}, {pair.body_B}};
    Vector r[2], v[2], omega[2];
    scalar least = limits::unbounded, closing = 0;
    bool tilts = false;
    for (int which = 0; which < 2; ++which) {
        const int slot = shapes.body_of(of_pair[which]);
        const Place at = place_of(slot);
        if (!paths[slot].fast && is_dynamic(bodies, slot)) return false;
        r[which] = lane_of(bodies.translation[at.tile].r_CM, at.lane);
        v[which] = lane_of(bodies.translation[at.tile].v_CM, at.lane);
        omega[which] = omega_of(bodies, slot);
        least = min(least, least_half_extent(shapes.surface(of_pair[which]).shape, shapes.hull(of_pair[which])));
        const Vector seen = seen_turn(shapes, slot, lane_of(bodies.rotation[at.tile].A, at.lane), omega[which]) * h;
        tilts = tilts || length_sq(cross(seen, manifold.n)) > limits::tilt_of_contact * limits::tilt_of_contact;
    }
    // bound: 4: Manifold::points_max
    for (int point_i = 0; point_i < manifold.count; ++point_i) {
        const Vector& P = manifold.points[point_i].P;
        closing = max(closing, -dot(manifold.n, v[0] + cross(omega[0], P - r[0]) - v[1] - cross(omega[1], P - r[1])));
    }
    return tilts || closing * h > limits::skin_share * least;
}

namespace {

/// Sets of bodies that touch: the union-find of island/disjoint_sets.h, with BodyPath::partner for the parent; `presses` of its root: the set is
/// soft.
struct TouchingBodies {
    const FastPairs& fast;

    /// The two bodies of a pair of shapes; false where one of them cannot move.
    bool both_move(const BodyPair& pair, int (&slots)[2]) const {
        slots[0] = fast.shapes.body_of({pair.body_A});
        slots[1] = fast.shapes.body_of({pair.body_B});
        return is_dynamic(fast.bodies, slots[0]) && is_dynamic(fast.bodies, slots[1]);
    }
    int root(int slot) const {
        // bound: max_bodies: slot falls each turn, for what it is joined to is never higher
        while (fast.paths[slot].partner != slot) {
            fast.paths[slot].partner = fast.paths[fast.paths[slot].partner].partner;
            slot = fast.paths[slot].partner;
        }
        return slot;
    }
    void join(int slot_A, int slot_B) const {
        const int A = root(slot_A), B = root(slot_B);
        fast.paths[A < B ? B : A].partner = static_cast<Index>(A < B ? A : B);
    }
    bool is_soft(int slot) const { return is_dynamic(fast.bodies, slot) && fast.paths[root(slot)].presses; }
};

}  // namespace

void leave_to_flights(const FastPairs& fast, const PairList& found, const ManifoldView& manifolds) {
    const TouchingBodies touching{fast};
    const auto is_hard = [&](const BodyPair& pair) { return fast.has(pair) && fast.meets_hard(pair, manifolds.records[pair.record].manifold); };
    int slots[2];
    bool some = false;
    // bound: max_manifolds
    for (int i = 0; i < *manifolds.count; ++i) {
        (void)touching.both_move(manifolds.pairs[i], slots);
        for (const int slot : slots) {
            fast.paths[slot].partner = static_cast<Index>(slot);
            fast.paths[slot].presses = false;
        }
        some = some || is_hard(manifolds.pairs[i]);
    }
    if (!some) return;
    for (int i = 0; i < *manifolds.count; ++i)
        if (touching.both_move(manifolds.pairs[i], slots)) touching.join(slots[0], slots[1]);
    for (int i = 0; i < *manifolds.count; ++i)
        if (touching.both_move(manifolds.pairs[i], slots) && !is_hard(manifolds.pairs[i])) fast.paths[touching.root(slots[0])].presses = true;
    int kept = 0, found_i = 0;
    for (int i = 0; i < *manifolds.count; ++i) {
        const BodyPair pair = manifolds.pairs[i];
        (void)touching.both_move(pair, slots);
        if (!is_hard(pair) || touching.is_soft(slots[0]) || touching.is_soft(slots[1])) {
            manifolds.pairs[kept++] = pair;
            continue;
        }
        // bound: pairs_with_own of scene.h: over the whole walk: both lists are sorted, and whoever touches was found
        while (found_i < *found.count - 1 && found.pairs[found_i].key() != pair.key()) ++found_i;
        give_back(manifolds, found.pairs[found_i].record);
    }
    *manifolds.count = static_cast<Index>(kept);
}

} }  // namespace ingot
