// SPDX-License-Identifier: MIT
#include "kinematic_motion.h"

#include "../base/limits.h"
#include "../math/quaternion.h"
#include "../math/rotation.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

void write_spin(const BodyView& bodies, int slot, scalar ratio, scalar scale, const Vector& L) {
    const Place at = place_of(slot);
    RotationTile& rotation = bodies.rotation[at.tile];
    set_lane(rotation.inv_I_ratio, at.lane, Vector{ratio, ratio, ratio});
    rotation.inv_I_scale[at.lane] = scale;
    set_lane(rotation.L, at.lane, L);
}

/// sum + low = a + low + change, with low below the last bit of the sum (Kahan).
scalar add_keeping(scalar a, scalar change, scalar& low) {
    const scalar due = change + low, sum = a + due;
    low = due - (sum - a);
    return sum;
}
Vector add_keeping(const Vector& a, const Vector& change, Vector& low) {
    return {add_keeping(a.x, change.x, low.x), add_keeping(a.y, change.y, low.y), add_keeping(a.z, change.z, low.z)};
}

/// The angle of 0 .. pi/2 with this sine and cosine, of any length.
scalar angle_of(scalar sine, scalar cosine) {
    const scalar size = sqrt(sine * sine + cosine * cosine), s = sine / size, c = cosine / size;
    scalar angle = scalar(1.57079632679489661923) * s / (s + c);  // within 0.08
    // sin(wanted - angle) by the addition theorem, and the first term of its arc sine: an error e becomes 3/40 e^5, 2.5e-7 and then nothing.
    for (int step_i = 0; step_i < 3; ++step_i) {
        const SinCos at = sin_cos(angle);
        const scalar off = s * at.cos - c * at.sin;
        angle += off + off * off * off * (scalar(1) / 6);
    }
    return angle;
}

/// The turn from one orientation to another, rad, by the shorter way.
Vector turn_to(const Matrix& from, const Matrix& to) {
    const Quaternion q = quaternions::from_rotation(to * transposed(from));
    const scalar sign = q.w < 0 ? scalar(-1) : scalar(1), sine = sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
    if (!(sine > 0)) return {};
    return Vector{q.x, q.y, q.z} * (sign * 2 * angle_of(sine, abs(q.w)) / sine);
}

}  // namespace

void show_kinematic_motion(const BodyView& bodies, int slot, const Vector& v_CM, const Vector& omega) {
    write_spin(bodies, slot, 1, -1, -omega);
    set_lane(bodies.translation[place_of(slot).tile].v_CM, place_of(slot).lane, v_CM);
}

void hide_kinematic_motion(const BodyView& bodies, int slot) {
    write_spin(bodies, slot, scalar(1) / 3, 0, {});
    TranslationTile& translation = bodies.translation[place_of(slot).tile];
    set_lane(translation.v_CM, place_of(slot).lane, Vector{});
    set_lane(translation.inv_I_world, place_of(slot).lane, SymmetricMatrix{});
}

Vector change_by_turn(const Vector& omega, scalar h, const Vector& r) {
    const scalar speed = sqrt(length_sq(omega));
    if (!(speed > 0)) return {};
    const Vector n = omega * (1 / speed), across = cross(n, r);
    const SinCos half = sin_cos(min(speed * h, limits::kinematic_turn_max) * scalar(0.5));
    return across * (2 * half.sin * half.cos) + cross(n, across) * (2 * half.sin * half.sin);
}

void aim_at_goal(const BodyView& bodies, scalar h, scalar smooth, int slot, KinematicBody& body) {
    const Vector v_before = body.v_CM_before, omega_before = body.omega_before;
    body.v_CM_before = body.v_CM;
    body.omega_before = body.omega;
    if (body.goal != KinematicGoal::pose) return;
    const Place at = place_of(slot);
    body.v_CM = (body.r_CM_goal - lane_of(bodies.translation[at.tile].r_CM, at.lane)) * (1 / h);
    body.omega = turn_to(lane_of(bodies.rotation[at.tile].A, at.lane), body.A_goal) * (1 / h);
    if (check_kinematic_motion(body.v_CM, {}) != Status::ok) body.v_CM = body.omega = {};
    body.v_CM_before = body.v_CM;
    body.omega_before = body.omega;
    const bool is_smooth = length_sq(body.v_CM - v_before) <= smooth * smooth;
    body.v_CM_change = is_smooth ? body.v_CM - v_before : Vector{};
    body.omega_change = is_smooth ? body.omega - omega_before : Vector{};
}

void move_kinematic_body(const BodyView& bodies, scalar h, int slot, KinematicBody& body) {
    const Place at = place_of(slot);
    RotationTile& rotation = bodies.rotation[at.tile];
    TranslationTile& translation = bodies.translation[at.tile];
    const Matrix A = lane_of(rotation.A, at.lane);
    if (body.goal == KinematicGoal::pose) {
        set_lane(translation.r_CM, at.lane, body.r_CM_goal);
        set_lane(rotation.A, at.lane, body.A_goal);
        set_kinematic_motion(body, {}, {});
        body.r_CM_low = {};
        body.A_low = {};
        return;
    }
    Vector r_CM_low = body.r_CM_low;
    const Vector r_CM = add_keeping(lane_of(translation.r_CM, at.lane), body.v_CM * h, r_CM_low);
    if (check_vector(r_CM, limits::position_max) != Status::ok) return set_kinematic_motion(body, {}, {});
    body.r_CM_low = r_CM_low;
    set_lane(translation.r_CM, at.lane, r_CM);
    if (!(length_sq(body.omega) > 0)) return;
    const Matrix off = correction_of_rotation(A);
    Matrix next;
    next.c0 = add_keeping(A.c0, change_by_turn(body.omega, h, A.c0 + off.c0) + off.c0, body.A_low.c0);
    next.c1 = add_keeping(A.c1, change_by_turn(body.omega, h, A.c1 + off.c1) + off.c1, body.A_low.c1);
    next.c2 = add_keeping(A.c2, change_by_turn(body.omega, h, A.c2 + off.c2) + off.c2, body.A_low.c2);
    set_lane(rotation.A, at.lane, next);
}

Status check_kinematic_motion(const Vector& v_CM, const Vector& omega) {
    const Status status = check_vector(v_CM, limits::speed_max);
    return status == Status::ok ? check_vector(omega, limits::spin_max) : status;
}

void set_kinematic_motion(KinematicBody& body, const Vector& v_CM, const Vector& omega) {
    body.v_CM = v_CM + Vector{};  // x + 0 turns -0 into +0: one value, one set of bits
    body.omega = omega + Vector{};
    body.v_CM_change = body.omega_change = {};
    body.r_CM_goal = {};
    body.A_goal = {};
    body.goal = KinematicGoal::velocity;
}

bool is_valid(const KinematicBody& body) {
    if (body.goal > KinematicGoal::pose || check_kinematic_motion(body.v_CM, body.omega) != Status::ok) return false;
    if (check_kinematic_motion(body.v_CM_before, {}) != Status::ok || !is_finite(body.omega_before)) return false;
    if (!is_finite(body.r_CM_low) || !is_finite(body.A_low)) return false;
    if (body.goal != KinematicGoal::pose) return is_finite(body.r_CM_goal) && is_finite(body.A_goal);
    return check_vector(body.r_CM_goal, limits::position_max) == Status::ok && check_rotation(body.A_goal) == Status::ok;
}

} }  // namespace ingot
