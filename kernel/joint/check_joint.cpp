// SPDX-License-Identifier: MIT
#include "check_joint.h"

#include "../base/figure_limits.h"
#include "../body/check_body.h"
#include "../math/sqrt.h"
#include "../math/rotation.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// One of each body, at right angles.
bool has_axes(JointKind kind) { return kind == JointKind::universal || kind == JointKind::wheel; }
bool has_axis(JointKind kind) {
    return kind == JointKind::hinge || kind == JointKind::slider || kind == JointKind::parallel || kind == JointKind::servo || has_axes(kind);
}

Status check_direction(const Vector& n) {
    if (!is_finite(n)) return Status::not_finite;
    return abs(length_sq(n) - 1) <= limits::unit_length ? Status::ok : Status::bad_direction;
}

bool has_no_length(const Vector& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// What stays in a cone may be anywhere but opposite to its middle.
Status check_middle(const JointDef& def) {
    const Status status = check_direction(def.joint.middle);
    if (status != Status::ok) return status;
    return dot(def.joint.middle, def.axis) > limits::joint_opposite_cos ? Status::ok : Status::out_of_range;
}

Vector unit(const Vector& a) { return a * (1 / sqrt(length_sq(a))); }

/// At right angles to a unit vector, whichever way: from the axis of the world that is least along it.
Vector across(const Vector& n) {
    const Vector a = {abs(n.x), abs(n.y), abs(n.z)};
    const Vector least = a.x <= a.y && a.x <= a.z ? Vector{1, 0, 0} : a.y <= a.z ? Vector{0, 1, 0} : Vector{0, 0, 1};
    return unit(cross(n, least));
}

JointFrame frame_on(const BodyView& bodies, Index slot, const Vector& P, const Vector& axis, const Vector& side) {
    if (slot == no_body) return {P + Vector{}, axis + Vector{}, side + Vector{}};
    const Place at = place_of(slot);
    const Matrix A = lane_of(bodies.rotation[at.tile].A, at.lane);
    return {transpose_times(A, P - r_CM_of(bodies, slot)) + Vector{}, transpose_times(A, axis) + Vector{}, transpose_times(A, side) + Vector{}};
}

/// As a unit vector that is turned so goes from one to another.
Vector turned_along(const Vector& v, const Vector& from, const Vector& to) {
    const Vector c = cross(from, to), x = cross(c, v);
    return v + x + cross(c, x) * (1 / (1 + dot(from, to)));
}

bool is_frame(const JointFrame& frame) {
    constexpr scalar off = 64 * epsilon;
    const Vector a = frame.anchor;
    if (!is_finite(a) || !is_finite(frame.axis) || !is_finite(frame.side)) return false;
    if (abs(a.x) > 2 * limits::position_max || abs(a.y) > 2 * limits::position_max || abs(a.z) > 2 * limits::position_max) return false;
    return abs(length_sq(frame.axis) - 1) <= off && abs(length_sq(frame.side) - 1) <= off && abs(dot(frame.axis, frame.side)) <= off;
}

}  // namespace

Status check_joint(const JointDef& def, bool balls_have_axes) {
    const bool is_ball_with_axis = balls_have_axes && def.joint.kind == JointKind::ball;
    Status status = check_vector(def.P, limits::position_max);
    if (status == Status::ok && (has_axis(def.joint.kind) || is_ball_with_axis)) status = check_direction(def.axis);
    if (status == Status::ok && is_ball_with_axis && !has_no_length(def.joint.middle)) status = check_middle(def);
    if (status != Status::ok || !has_axes(def.joint.kind)) return status;
    status = check_direction(def.axis_B);
    if (status == Status::ok && !(abs(dot(def.axis, def.axis_B)) <= limits::orthogonality)) status = Status::bad_joint;
    return status;
}

JointRecord record_of(const JointDef& def, const BodyView& bodies, Index slot_A, Index slot_B, bool balls_have_axes) {
    const bool is_ball_with_axis = balls_have_axes && def.joint.kind == JointKind::ball;
    const Vector axis = has_axis(def.joint.kind) || is_ball_with_axis ? unit(def.axis) : Vector{0, 0, 1};
    JointRecord record{};
    record.kind = def.joint.kind;
    record.body_A = slot_A;
    record.body_B = slot_B;
    record.resolved = 1;
    record.bodies_meet = def.bodies_meet ? 1 : 0;
    if (has_axes(def.joint.kind)) {
        const Vector axis_B = unit(def.axis_B - axis * dot(axis, def.axis_B));
        record.frame_A = frame_on(bodies, slot_A, def.P, axis, axis_B);
        record.frame_B = frame_on(bodies, slot_B, def.P, axis_B, axis);
    } else {
        const Vector side = across(axis);
        const bool is_aside = is_ball_with_axis && !has_no_length(def.joint.middle);
        const Vector middle = is_aside ? unit(def.joint.middle) : axis;
        record.frame_A = frame_on(bodies, slot_A, def.P, middle, is_aside ? turned_along(side, axis, middle) : side);
        record.frame_B = frame_on(bodies, slot_B, def.P, axis, side);
        if (is_servo(record.kind)) {  // what B is measured against is the world, and A gets a torque; see loop_sides.h
            record.frame_A.axis = axis + Vector{};
            record.frame_A.side = side + Vector{};
            record.bodies_meet = 1;
        }
    }
    return record;
}

scalar gap_of(const JointRecord& joint, const BodyView& bodies) {
    const auto in_world = [&](Index slot, const JointFrame& frame, Vector& axis) {
        axis = frame.axis;
        if (slot == no_body) return frame.anchor;
        const Matrix A = lane_of(bodies.rotation[place_of(slot).tile].A, place_of(slot).lane);
        axis = A * frame.axis;
        return r_CM_of(bodies, slot) + A * frame.anchor;
    };
    Vector axis{}, axis_B{};
    Vector gap = in_world(joint.body_B, joint.frame_B, axis_B) - in_world(joint.body_A, joint.frame_A, axis);
    if (joint.kind == JointKind::slider || joint.kind == JointKind::wheel) gap = gap - axis * dot(axis, gap);
    return sqrt(length_sq(gap));
}

bool is_valid(const JointRecord& joint, int slots) {
    const auto is_body = [slots](Index slot) { return slot == no_body || slot < slots; };
    const bool is_kind = joint.kind != JointKind::none && (joint.kind <= JointKind::wheel || is_tie(joint.kind));
    if (!is_kind || !is_body(joint.body_A) || !is_body(joint.body_B)) return false;
    if (joint.body_A == joint.body_B || !is_finite(joint.j) || !is_frame(joint.frame_A) || !is_frame(joint.frame_B)) return false;
    return joint.resolved <= 1 && joint.bodies_meet <= 1 && joint.doublings <= limits::doublings_max;
}

} }  // namespace ingot
