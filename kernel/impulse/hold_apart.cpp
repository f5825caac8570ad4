// SPDX-License-Identifier: MIT
#include "hold_apart.h"

#include "../base/limits.h"
#include "../body/auxiliary.h"
#include "../body/kinematics.h"
#include "../math/sqrt.h"
#include "impulse.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

CollidingBody body_at(const BodyView& bodies, int slot, const Vector& P) {
    const Place at = place_of(slot);
    const RotationTile& rotation = bodies.rotation[at.tile];
    const TranslationTile& translation = bodies.translation[at.tile];
    CollidingBody body;
    body.v_CM = lane_of(translation.v_CM, at.lane);
    body.omega = omega_of(bodies, slot);
    body.r_P = P - r_CM_of(bodies, slot);
    if (!is_dynamic(bodies, slot)) return body;
    body.inv_M = translation.inv_M[at.lane];
    body.inv_I_world = inverse_inertia_world(lane_of(rotation.A, at.lane), lane_of(rotation.inv_I_ratio, at.lane) * rotation.inv_I_scale[at.lane]);
    return body;
}

void move(const BodyView& bodies, int slot, const Vector& way) {
    const Place at = place_of(slot);
    const Vector r = r_CM_of(bodies, slot) + way;
    if (is_dynamic(bodies, slot) && is_finite(r)) set_lane(bodies.translation[at.tile].r_CM, at.lane, r);
}

/// lasted: s, that the impulse is a force for; the body goes back by what it would have gone less.
void push_point(const BodyView& bodies, int slot, const Vector& r_P, const Vector& impulse, scalar lasted) {
    const Place at = place_of(slot);
    if (!is_dynamic(bodies, slot)) return;
    RotationTile& rotation = bodies.rotation[at.tile];
    TranslationTile& translation = bodies.translation[at.tile];
    const Vector change = impulse * translation.inv_M[at.lane];
    const Vector v_CM = lane_of(translation.v_CM, at.lane) + change, L = lane_of(rotation.L, at.lane) + cross(r_P, impulse);
    if (!is_finite(v_CM) || !is_finite(L)) return mark_lane_bad(rotation.bad, at.lane);
    set_lane(translation.v_CM, at.lane, v_CM);
    set_lane(rotation.L, at.lane, L);
    rotation.kicked = static_cast<uint16_t>(rotation.kicked | 1u << at.lane);
    if (lasted > 0) move(bodies, slot, change * (lasted / 2));
}

/// A point of two bodies.
struct HeldPoint {
    const HeldStep& step;
    int A, B;
    Vector P;

    Vector v() const {
        const CollidingBody seen_A = body_at(step.bodies, A, P), seen_B = body_at(step.bodies, B, P);
        return point_velocity(seen_A.v_CM, seen_A.omega, seen_A.r_P) - point_velocity(seen_B.v_CM, seen_B.omega, seen_B.r_P);
    }
    /// They approach along d by no more than the room there is, m. Returns the impulse, N s.
    scalar stop(const Vector& d, scalar room, scalar most, scalar lasted = 0) const {
        CollidingBody seen_A = body_at(step.bodies, A, P);
        const CollidingBody seen_B = body_at(step.bodies, B, P);
        seen_A.v_CM += d * (room / step.h);
        scalar j = collision_impulse(seen_A, seen_B, d, 0);
        j = j < most ? j : most;
        if (!(j > 0)) return 0;
        push_point(step.bodies, A, seen_A.r_P, d * j, lasted);
        push_point(step.bodies, B, seen_B.r_P, d * -j, lasted);
        return j;
    }
    /// What slips is stopped by no more than so much, N s.
    void rub(const Vector& n, scalar most) const {
        const Vector of_point = v(), slip = of_point - n * dot(of_point, n);
        const scalar speed = sqrt(length_sq(slip));
        if (speed > 0 && most > 0) (void)stop(slip * (-1 / speed), 0, most, step.is_over ? step.h : scalar(0));
    }
};

/// Returns: m/s, at which their middle approached.
scalar stop_points(const HeldStep& step, int A, int B, const TouchPoints& points) {
    const auto room_of = [&points](int i) { return points.separation[i] > 0 ? points.separation[i] : scalar(0); };
    const scalar share = 1 / static_cast<scalar>(points.count);
    Vector P{};
    scalar room = 0;
    // bound: 8: TouchPoints::points_max
    for (int i = 0; i < points.count; ++i) {
        P += points.P[i] * share;
        room += room_of(i) * share;
    }
    const HeldPoint middle{step, A, B, P};
    const scalar approach = -dot(points.n, middle.v());
    scalar j = middle.stop(points.n, room, scalar_max);
    // bound: 8: TouchPoints::points_max
    for (int i = 0; i < points.count; ++i) j += HeldPoint{step, A, B, points.P[i]}.stop(points.n, room_of(i), scalar_max);
    middle.rub(points.n, points.mu * j);
    return approach;
}

void move_apart(const BodyView& bodies, int A, int B, const Vector& n, scalar by) {
    const scalar inv_M_A = is_dynamic(bodies, A) ? bodies.translation[place_of(A).tile].inv_M[place_of(A).lane] : scalar(0);
    const scalar inv_M_B = is_dynamic(bodies, B) ? bodies.translation[place_of(B).tile].inv_M[place_of(B).lane] : scalar(0);
    if (!(inv_M_A + inv_M_B > 0)) return;
    const scalar share_A = inv_M_A / (inv_M_A + inv_M_B);
    move(bodies, A, n * (by * share_A));
    move(bodies, B, n * (by * (share_A - 1)));
}

/// Overlap, of which they sank the one part in the step itself: they would not have, with a force that stops them.
void take_back(const HeldStep& step, int A, int B, const Vector& n, scalar depth, scalar sunk) {
    const scalar part = depth * limits::position_share;
    scalar way = step.push == 0 || !meets_fixed(step.bodies, A, B) ? (part < step.push ? part : step.push) : depth;
    if (way < sunk) way = sunk < depth ? sunk : depth;
    push_out(step, A, B, n, way);
}

}  // namespace

scalar hold_apart(const HeldStep& step, int A, int B, const TouchPoints& points) {
    if (points.count == 0 || (!is_dynamic(step.bodies, A) && !is_dynamic(step.bodies, B))) return limits::unbounded;
    scalar deepest = points.separation[0];
    // bound: 8: TouchPoints::points_max
    for (int i = 1; i < points.count; ++i) deepest = points.separation[i] < deepest ? points.separation[i] : deepest;
    const scalar approach = stop_points(step, A, B, points);
    if (step.is_over && deepest < 0) take_back(step, A, B, points.n, -deepest, approach * step.h / 2);
    return deepest;
}

void push_out(const HeldStep& step, int A, int B, const Vector& n, scalar way) {
    if (way > 0) move_apart(step.bodies, A, B, n, way);
}

int kept_contacts(const ContactView& contacts, int body_A, int body_B) {
    int kept = 0;
    // bound: max_contacts
    for (int i = 0; i < *contacts.count; ++i) kept += contacts.contacts[i].body_A == body_A && contacts.contacts[i].body_B == body_B ? 1 : 0;
    return kept;
}

TouchPoints touch_points(const BodyView& bodies, const Contact* contacts, int count) {
    TouchPoints points;
    points.count = count;
    // bound: 8: TouchPoints::points_max
    for (int i = 0; i < count; ++i) {
        const Place at = place_of(contacts[i].body_A);
        points.n = contacts[i].n;
        points.P[i] = lane_of(bodies.translation[at.tile].r_CM, at.lane) + cross(contacts[i].n, contacts[i].lever_A);
        points.separation[i] = contacts[i].separation;
    }
    return points;
}

} }  // namespace ingot
