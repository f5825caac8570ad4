// SPDX-License-Identifier: MIT
#include "crowded_manifolds.h"

#include "../body/auxiliary.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

struct MovingPoint {
    Vector r_CM, v_CM, omega;
    Vector v(const Vector& P) const { return v_CM + cross(omega, P - r_CM); }
};
MovingPoint moving_point_of(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    const TranslationTile& tile = bodies.translation[at.tile];
    return {lane_of(tile.r_CM, at.lane), lane_of(tile.v_CM, at.lane), omega_of(bodies, slot)};
}

}  // namespace

Index CrowdBodies::rank_of_contact(const BodyPair& pair, const Manifold& manifold, bool carries) const {
    const int body_A = body_of(pair.body_A), body_B = body_of(pair.body_B);
    const MovingPoint A = moving_point_of(bodies, body_A), B = moving_point_of(bodies, body_B);
    scalar least = limits::unbounded;
    // bound: 4: Manifold::points_max
    for (int i = 0; i < manifold.count; ++i) {
        const ManifoldPoint& point = manifold.points[i];
        const scalar at_end = point.separation + dot(manifold.n, A.v(point.P) - B.v(point.P)) * h;
        least = at_end < least ? at_end : least;
    }
    const scalar urgency = -least / lesser_radius(surfaces, pair) + (carries ? limits::crowd_patience : scalar(0));
    const bool on_fixed = !is_dynamic(bodies, body_A) || !is_dynamic(bodies, body_B);
    return rank_of(on_fixed && urgency > -limits::crowd_patience, urgency);
}

bool FullRecords::make_room(const BodyPair& pair, Index rank) const {
    if (*manifolds_.count == 0) return false;  // all records are of bodies at rest
    BodyPair least = manifolds_.pairs[0];
    const Index rank_of_least = manifolds_.records[least.record].next_free;
    if (rank < rank_of_least || (rank == rank_of_least && pair.key() > least.key())) return false;
    const int place = place_in(found_.pairs, *found_.count, least.key());
    if (place >= 0) found_.pairs[place].record = refused_record;
    give_back(manifolds_, least.record);
    return true;
}

void FullRecords::close() const {
    for (int i = 0; i < *manifolds_.count; ++i) manifolds_.records[manifolds_.pairs[i].record].next_free = 0;  // bound: max_manifolds
    sort_by_key(manifolds_.pairs, *manifolds_.count);
}

} }  // namespace ingot
