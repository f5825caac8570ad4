// SPDX-License-Identifier: MIT
#include "move_point_bodies.h"

#include "../../base/limits.h"
#include "../../body/kinematics.h"
#include "../../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

void add_motion(PointMotion& to, const PointMotion& rate, scalar h) {
    to.linear += rate.linear * h;
    to.angular += rate.angular * h;
    to.moment += rate.moment * h;
}

/// Of a body whose velocity, or the change of it in a second, is `linear`, with its angular momentum or torque.
INGOT_SHARED PointMotion motion_of(const PointBody& body, const Vector& linear, const Vector& moment) {
    return {linear, body.spin_of(moment), moment};
}

/// False for NaN. An L that is not finite has no omega that is.
bool is_valid(const PointMotion& motion) {
    const scalar most = limits::speed_runaway;
    const Vector& v = motion.linear;
    return abs(v.x) <= most && abs(v.y) <= most && abs(v.z) <= most && is_within_runaway(motion.angular);
}

void take_in_point_body(PointBody& body, const BodyView& bodies, const Vector& gravity, scalar h, int slot) {
    const Place at = place_of(slot);
    const TranslationTile& translation = bodies.translation[at.tile];
    const RotationTile& rotation = bodies.rotation[at.tile];
    const scalar inv_M = translation.inv_M[at.lane];
    if (body.inv_M > 0 || !(inv_M > 0)) return;
    body.inv_I_world = lane_of(translation.inv_I_world, at.lane);
    body.forces = motion_of(body, lane_of(translation.F_T, at.lane) * inv_M + gravity, lane_of(rotation.tau_T, at.lane));
    body.velocity = motion_of(body, lane_of(translation.v_CM, at.lane), lane_of(rotation.L, at.lane));
    body.begin = body.velocity;
    add_motion(body.begin, body.forces, h);  // at the end of the step, without contacts
    if (!is_valid(body.begin)) return mark_lane_bad(bodies.rotation[at.tile].bad, at.lane);
    body.r_CM = lane_of(translation.r_CM, at.lane);
    body.inv_M = inv_M;
    body.displacement.linear = body.displacement.angular = body.displacement.moment = {};  // as a whole it would be a call of memset
    body.root = static_cast<Index>(slot);
}

/// The begin of a substep: forces change the velocity of a body for h seconds, or it changes by as much again as in the substep before.
scalar begin_substep(const PointView& solver, bool again, scalar h) {
    scalar fastest_sq = 0;
    for (int i = 0; i < solver.body_count; ++i) {  // bound: max_bodies + 1
        PointBody& body = solver.bodies[solver.body_slots[i]];
        const PointMotion before = body.begin;
        body.begin = body.velocity;
        if (again) {
            add_motion(body.velocity, body.velocity, 1);
            add_motion(body.velocity, before, -1);
        } else {
            add_motion(body.velocity, body.forces, h);
        }
        fastest_sq = max(fastest_sq, length_sq(body.velocity.linear));
    }
    return min(sqrt(fastest_sq), limits::rounding_speed_max * solver.unit);
}

}  // namespace

void take_in_bodies(PointView& solver, const BodyView& bodies, const Vector& gravity, scalar h) {
    solver.slot_count = bodies.tile_count * lanes;
    for (int slot = 0; slot < solver.slot_count; ++slot) {  // bound: max_bodies
        solver.bodies[slot].inv_M = 0;  // of a body that does not move, nothing else is looked at
        solver.bodies[slot].hit = false;
        solver.bodies[slot].root = no_root;
    }
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {  // bound: max_manifolds
        const BodyPair& pair = solver.pairs[manifold_i];
        take_in_point_body(solver.bodies[pair.body_A], bodies, gravity, h, pair.body_A);
        take_in_point_body(solver.bodies[pair.body_B], bodies, gravity, h, pair.body_B);
    }
}

namespace {

/// The root of a body's tree, in the bodies themselves: see DisjointSets.
int root_of(const PointView& solver, int slot) {
    PointBody* const bodies = solver.bodies;
    while (bodies[slot].root != slot) {  // bound: max_bodies: slot falls each turn, for a root is never higher
        bodies[slot].root = bodies[bodies[slot].root].root;
        slot = bodies[slot].root;
    }
    return slot;
}

bool is_of_an_island(const PointView& solver, int slot) { return solver.bodies[slot].root != no_root; }

/// The root of a manifold's island; no_root: it joins no bodies that take part.
Index island_of(const PointView& solver, int manifold_i) {
    const BodyPair& pair = solver.pairs[manifold_i];
    const Index A = solver.bodies[pair.body_A].root;
    return A != no_root ? A : solver.bodies[pair.body_B].root;
}

/// Sorts the manifolds by the roots of their islands, by counting, in the lists of bodies, which are empty as yet; within an island they stay in the
/// order of pairs.
void sort_members(const PointView& solver) {
    Index* const next_of = solver.body_slots;
    const auto count_all = [&solver](const auto& each) {
        Index sum = 0;
        for (int slot = 0; slot < solver.slot_count; ++slot)  // bound: max_bodies
            if (solver.bodies[slot].root == slot) each(slot, sum);
    };
    count_all([&](int root, Index&) { next_of[root] = 0; });
    for (int i = 0; i < solver.members_left; ++i) ++next_of[island_of(solver, solver.members[i])];  // bound: max_manifolds
    count_all([&](int root, Index& sum) {
        const Index count = next_of[root];
        next_of[root] = sum;
        sum = static_cast<Index>(sum + count);
    });
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {
        const Index root = island_of(solver, manifold_i);
        if (root != no_root) solver.members[next_of[root]++] = static_cast<Index>(manifold_i);
    }
}

/// Lists the manifolds island after island. Where islands do not mingle, pairs are in this order as they come.
void list_members(PointView& solver) {
    bool sorted = true;
    Index last = 0;
    solver.members_left = solver.member_count = 0;
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {
        const Index root = island_of(solver, manifold_i);
        if (root == no_root) continue;
        solver.members[solver.members_left++] = static_cast<Index>(manifold_i);
        sorted = sorted && root >= last;
        last = root;
    }
    if (!sorted) sort_members(solver);
}

}  // namespace

void join_bodies(PointView& solver) {
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {
        const BodyPair& pair = solver.pairs[manifold_i];
        if (!is_of_an_island(solver, pair.body_A) || !is_of_an_island(solver, pair.body_B)) continue;
        const int A = root_of(solver, pair.body_A), B = root_of(solver, pair.body_B);
        solver.bodies[A < B ? B : A].root = static_cast<Index>(A < B ? A : B);
    }
    for (int slot = 0; slot < solver.slot_count; ++slot)
        if (is_of_an_island(solver, slot)) solver.bodies[slot].root = static_cast<Index>(root_of(solver, slot));
    list_members(solver);
}

bool next_island(PointView& solver) {
    solver.members += solver.member_count;
    solver.members_left -= solver.member_count;
    solver.member_count = solver.body_count = 0;
    if (solver.members_left == 0) return false;
    const Index root = island_of(solver, solver.members[0]);
    const auto list = [&](Index slot) {
        PointBody& body = solver.bodies[slot];
        if (body.root == no_root || body.hit) return;
        body.hit = true;  // it is listed
        solver.body_slots[solver.body_count++] = slot;
    };
    // bound: max_manifolds
    for (; solver.member_count < solver.members_left && island_of(solver, solver.members[solver.member_count]) == root; ++solver.member_count) {
        const BodyPair& pair = solver.pairs[solver.members[solver.member_count]];
        list(pair.body_A);
        list(pair.body_B);
    }
    for (int i = 0; i < solver.body_count; ++i) solver.bodies[solver.body_slots[i]].hit = false;  // bound: max_bodies
    return true;
}

scalar kick_bodies(const PointView& solver, scalar h) { return begin_substep(solver, false, h); }

scalar kick_again(const PointView& solver) { return begin_substep(solver, true, 0); }

SubstepOfPoints drift_bodies(const PointView& solver, scalar h) {
    SubstepOfPoints substep = {false, true};
    for (int i = 0; i < solver.body_count; ++i) {
        PointBody& body = solver.bodies[solver.body_slots[i]];
        const Vector change = body.velocity.linear - body.begin.linear, spun = body.velocity.moment - body.begin.moment;
        const scalar forced = sqrt(length_sq(body.forces.linear)) * h;
        const scalar steady_change = limits::steady_acceleration * forced + limits::settled_speed * solver.unit;
        const scalar change_sq = length_sq(change), spin_sq = dot(spun, body.velocity.angular - body.begin.angular) * body.inv_M;
        body.hit = change_sq > 4 * forced * forced;
        substep.some_hit = substep.some_hit || body.hit;
        substep.steady = substep.steady && change_sq + spin_sq <= steady_change * steady_change;
        add_motion(body.displacement, body.velocity, h);
        if (!body.hit) body.displacement.linear -= change * (h / 2);
    }
    return substep;
}

namespace {

/// The constant force that leads from the begin of the step to v: twice what v exceeds the mean of the step by, per second.
INGOT_INLINE Vector rate_beyond_mean(const Vector& v, const Vector& displacement, scalar inv_h) {
    return (v - displacement * inv_h) * (2 * inv_h);
}

}  // namespace

void write_contact_motion(const PointView& solver, const NoJointedBodies&, const BodyView& bodies, const Vector& gravity, scalar h) {
    for (int slot = 0; slot < solver.slot_count; ++slot) {
        const PointBody& body = solver.bodies[slot];
        if (!(body.inv_M > 0)) continue;
        const Place at = place_of(slot);
        const PointMotion &velocity = body.velocity, &displacement = body.displacement;
        if (!is_valid(velocity) || !is_finite(displacement.linear + displacement.moment)) {  // no finite two add up to more than there is
            mark_lane_bad(bodies.rotation[at.tile].bad, at.lane);
            continue;
        }
        RotationTile& rotation = bodies.rotation[at.tile];
        TranslationTile& translation = bodies.translation[at.tile];
        const scalar inv_h = 1 / h;
        const Vector a = rate_beyond_mean(velocity.linear, displacement.linear, inv_h);
        set_lane(translation.v_CM, at.lane, velocity.linear);
        set_lane(translation.F_T, at.lane, (a - gravity) * (1 / body.inv_M));
        set_lane(rotation.L, at.lane, velocity.moment);
        set_lane(rotation.tau_T, at.lane, rate_beyond_mean(velocity.moment, displacement.moment, inv_h));
        rotation.kicked = static_cast<uint16_t>(rotation.kicked | 1u << at.lane);
    }
}

} }  // namespace ingot
