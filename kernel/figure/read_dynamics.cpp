// SPDX-License-Identifier: MIT
#include "read_dynamics.h"

#include "../body/auxiliary.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

using Twist = Spatial<scalar>;

/// Rods, parallel joints and gears close loops. Of other ties it is not known what they will give, as of contacts: ropes pull or do not, targets give
/// way.
bool is_outside(JointKind kind) { return kind == JointKind::rope || kind == JointKind::target || is_servo(kind); }

int direction_count_of(JointKind kind) {
    switch (kind) {
        case JointKind::ball:
        case JointKind::wheel: return 3;
        case JointKind::universal: return 2;
        case JointKind::hinge:
        case JointKind::slider: return 1;
        default: return 0;
    }
}

/// Adds bodies to the list, each once.
struct Lister {
    const Dynamics& of;
    const DynamicsSource& from;
    uint8_t* marks;
    Status status = Status::ok;
    DynamicsGround ground = {no_joint, no_body};

    bool has(Index slot) const { return (marks[slot / 8] >> slot % 8 & 1u) != 0; }
    void flip(Index slot) const { marks[slot / 8] = static_cast<uint8_t>(marks[slot / 8] ^ 1u << slot % 8); }
    bool moves(Index slot) const { return slot != no_body && is_dynamic(from.bodies, slot); }
    Index slot_of(int body_i) const { return of.bodies[body_i].body.slot; }

    void begin(Index root, Index joint) {
        of.size.body_count = 0;
        add(root, joint, -1, from.lists.joints[joint == no_joint ? 0 : joint]);
    }
    void add(Index slot, Index joint, int parent, const JointRecord& record) {
        if (of.size.body_count == of.capacity) {
            status = Status::no_room;
            return;
        }
        flip(slot);
        DynamicsBody& body = of.bodies[of.size.body_count++];
        body = {};
        body.body = {slot, from.world_tag, from.generation[slot]};
        body.parent = parent;
        if (joint == no_joint) return;
        body.joint = {joint, from.world_tag, from.joint_generation[joint]};
        body.count = direction_count_of(record.kind);
        body.is_A = record.body_A == slot;
    }
    /// Those that hang on a body, beside its own joint; also_loops: what closes one is refused.
    void add_partners(int body_i, bool also_loops) {
        const Index slot = slot_of(body_i);
        from.lists.for_ends(slot, [&](int end) {
            const JointRecord& record = from.lists.joints[end / 2];
            const auto joint = static_cast<Index>(end / 2);
            const bool is_own = of.bodies[body_i].joint == JointId{joint, from.world_tag, from.joint_generation[joint]};
            if (is_own || is_outside(record.kind)) return;
            const Index other = from.lists.partner_of(end);
            if (is_tie(record.kind)) {
                const bool holds_root = body_i == 0 && of.size.floats && !moves(other);  // what it bears is of the root's wrench
                status = also_loops && !holds_root && status == Status::ok ? Status::bad_joint : status;
            } else if (!moves(other)) {
                if (ground.joint == no_joint || joint < ground.joint) ground = {joint, other};
                status = also_loops && status == Status::ok ? Status::bad_joint : status;
            } else if (!has(other)) {
                add(other, joint, body_i, record);
            } else if (also_loops && status == Status::ok) {
                status = Status::bad_joint;
            }
        });
    }
    void add_all(bool also_loops) {
        for (int body_i = 0; body_i < of.size.body_count && status == Status::ok; ++body_i) add_partners(body_i, also_loops);  // bound: max_bodies
    }
};

/// A side of a joint: twist at the centre of mass there.
struct Side {
    Vector r;
    Matrix A;
    Twist twist;
};
Matrix orientation_of(const DynamicsSource& from, Index slot) { return lane_of(from.bodies.rotation[place_of(slot).tile].A, place_of(slot).lane); }

/// A free direction, for rates of B against A, of a line through a point or along an axis; and whether it stays as it is in B, else in A.
struct Direction {
    Vector axis;
    bool is_travel, stays_in_B;
};
Direction direction_of(const JointRecord& joint, const Matrix& A_of_A, const Matrix& A_of_B, int i) {
    const Vector columns[3] = {A_of_A.c0, A_of_A.c1, A_of_A.c2};
    switch (joint.kind) {
        case JointKind::ball: return {columns[i], false, false};
        case JointKind::hinge: return {A_of_B * joint.frame_B.axis, false, true};
        case JointKind::slider: return {A_of_A * joint.frame_A.axis, true, false};
        case JointKind::universal:
            return i == 0 ? Direction{A_of_A * joint.frame_A.axis, false, false} : Direction{A_of_B * joint.frame_B.axis, false, true};
        default:  // a wheel
            return i == 0 ? Direction{A_of_B * joint.frame_B.axis, false, true} : Direction{A_of_A * joint.frame_A.axis, i == 1, false};
    }
}

/// How a twist changes that stays as it is in what moves with another.
Twist turned_by(const Twist& by, const Twist& s) { return {cross(by.w, s.w), cross(by.w, s.v) + cross(by.v, s.w)}; }

void read_body(DynamicsBody& body, const DynamicsSource& from, const Vector& v) {
    const Index slot = body.body.slot;
    const Place at = place_of(slot);
    const RotationTile& rotation = from.bodies.rotation[at.tile];
    const TranslationTile& translation = from.bodies.translation[at.tile];
    const Matrix A = orientation_of(from, slot);
    const Vector inv_I = lane_of(rotation.inv_I_ratio, at.lane) * rotation.inv_I_scale[at.lane];
    body.r = lane_of(translation.r_CM, at.lane);
    body.M = 1 / translation.inv_M[at.lane];
    body.I = rotated_diagonal(A, Vector{1 / inv_I.x, 1 / inv_I.y, 1 / inv_I.z});
    body.twist = {omega_of(from.bodies, slot), lane_of(translation.v_CM, at.lane) - v};
    body.weight = from.gravity * (from.shares_of_gravity == nullptr ? body.M : body.M * from.shares_of_gravity[slot]);
    body.held = {lane_of(rotation.tau_T, at.lane), lane_of(translation.F_T, at.lane)};
    if (from.body_forces == nullptr) return;
    const BodyForceTile& pushed = from.body_forces[at.tile];
    body.held = body.held + Spatial<scalar>{A * lane_of(pushed.tau_body, at.lane), A * lane_of(pushed.F_body, at.lane)};
}

/// Directions of a joint, and the rates along them by which its sides move.
void read_joint(DynamicsBody& body, const DynamicsSource& from, const Side& parent) {
    const JointRecord& joint = from.lists.joints[body.joint.slot];
    const Matrix A = orientation_of(from, body.body.slot);
    const Matrix &A_of_A = body.is_A ? A : parent.A, &A_of_B = body.is_A ? parent.A : A;
    body.d = body.r - parent.r;
    const Vector arm = body.is_A ? A_of_B * joint.frame_B.anchor - body.d : A_of_B * joint.frame_B.anchor;  // to the anchor of B
    const Twist off = body.twist - twist_at(parent.twist, body.d);
    const scalar sign = body.is_A ? scalar(-1) : scalar(1);
    for (int i = 0; i < body.count; ++i) {  // bound: 3
        const Direction direction = direction_of(joint, A_of_A, A_of_B, i);
        const Vector n = direction.axis * sign;
        body.s[i] = direction.is_travel ? Twist{{}, n} : Twist{n, cross(arm, n)};
        body.rate[i] = direction.is_travel ? dot(n, off.v + cross(off.w, arm)) : dot(n, off.w);
    }
}

/// The twist of a body by that of its parent and by its rates: so all are of one motion, whatever joints have drifted.
void follow_parent(DynamicsBody& body, const DynamicsSource& from, const Twist& of_parent) {
    const JointRecord& joint = from.lists.joints[body.joint.slot];
    body.twist = of_parent;
    for (int i = 0; i < body.count; ++i) body.twist = body.twist + body.s[i] * body.rate[i];  // bound: 3
    for (int i = 0; i < body.count; ++i) {
        const bool in_B = direction_of(joint, identity_matrix<scalar>(), identity_matrix<scalar>(), i).stays_in_B;
        body.drift = body.drift + turned_by(in_B != body.is_A ? body.twist : of_parent, body.s[i] * body.rate[i]);
    }
}

}  // namespace

Result<DynamicsGround> list_figure(const Dynamics& of, const DynamicsSource& from, Index slot, uint8_t* marks) {
    of.size.direction_count = 0;
    of.size.inertias = DynamicsInertias::none;
    Lister lister{of, from, marks};
    lister.begin(slot, no_joint);
    lister.add_all(false);
    const DynamicsGround ground = lister.ground;
    of.size.floats = ground.joint == no_joint;
    if (lister.status == Status::ok) {
        for (int body_i = 0; body_i < of.size.body_count; ++body_i) lister.flip(lister.slot_of(body_i));  // bound: max_bodies
        const Index root =
            of.size.floats ? slot : from.lists.partner_of(2 * ground.joint + (from.lists.joints[ground.joint].body_A == ground.slot ? 0 : 1));
        lister.begin(root, ground.joint);
        lister.add_all(true);
    }
    if (lister.status != Status::ok) {
        of.size.body_count = 0;
        return {lister.status, {no_joint, no_body}};
    }
    for (int body_i = 0; body_i < of.size.body_count; ++body_i) {
        DynamicsBody& body = of.bodies[body_i];
        body.first = of.size.direction_count;
        if (body_i == 0 && of.size.floats) body.count = 6;
        of.size.direction_count += body.count;
    }
    return {Status::ok, ground};
}

void read_motions(const Dynamics& of, const DynamicsSource& from, const JointBody& ground) {
    of.size.v = of.size.floats ? v_CM_of(from.bodies, of.bodies[0].body.slot) : ground.v_CM;
    const Side below = {ground.r_CM, ground.A, {ground.omega, {}}};
    for (int body_i = 0; body_i < of.size.body_count; ++body_i) read_body(of.bodies[body_i], from, of.size.v);  // bound: max_bodies
    const auto side_of_parent = [&](const DynamicsBody& body) {
        if (body.parent < 0) return below;
        const DynamicsBody& parent = of.bodies[body.parent];
        return Side{parent.r, orientation_of(from, parent.body.slot), parent.twist};
    };
    const int first = of.size.floats ? 1 : 0;
    for (int body_i = first; body_i < of.size.body_count; ++body_i) read_joint(of.bodies[body_i], from, side_of_parent(of.bodies[body_i]));
    for (int body_i = first; body_i < of.size.body_count; ++body_i) {
        DynamicsBody& body = of.bodies[body_i];
        follow_parent(body, from, twist_at(side_of_parent(body).twist, body.d));
    }
}

}}  // namespace ingot::INGOT_ABI
