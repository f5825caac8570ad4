// SPDX-License-Identifier: MIT
#include "gear_rows.h"

#include "../base/figure_limits.h"
#include "../body/kinematics.h"
#include "../math/sqrt.h"
#include "../math/wide.h"
#include "loop_sides.h"
#include "measure_joint.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// A joint of a gear, in the step at hand: its B as the child, its A as the other.
struct GearedJoint {
    JointKind kind;
    Index node_A, node_B;  ///< no_node: what cannot move
    LoopSides sides;

    Spatial<scalar> direction() const {
        Spatial<scalar> s[3] = {};
        (void)free_directions(kind, sides.now(), s);
        return s[0];
    }
    scalar value() const { return measure(kind, sides.now()).of[0]; }
    Vector arm_on_A() const { return sides.arm_of_other(kind); }
    Vector arm_on_B() const { return sides.arm_of_child(kind); }
    Spatial<scalar> twist_of_A() const { return {sides.other.w, sides.other.v + cross(sides.other.w, arm_on_A())}; }
    Spatial<scalar> twist_of_B() const { return {sides.child.w, sides.child.v + cross(sides.child.w, arm_on_B())}; }
    /// rad/s, m/s.
    scalar rate() const { return dot(direction(), twist_of_B() - twist_of_A()); }
    /// The part of it by what moves as it is told.
    scalar rate_by_grounds() const {
        const Spatial<scalar> none{};
        if (node_A != no_node && node_B != no_node) return 0;
        return dot(direction(), (node_B == no_node ? twist_of_B() : none) - (node_A == no_node ? twist_of_A() : none));
    }
    /// What it would go in h seconds by itself, rad, m. Spins turn by FigureRow::turn about their axis, whatever the angle.
    scalar way(bool is_exact, scalar h) const {
        if (!is_exact) return rate() * h;
        if (kind != JointKind::slider) return dot(direction().w, sides.child.turn - sides.other.turn);
        Vector moved;
        const JointSides<scalar> now = sides.now(), after = sides_after(sides, now, true, h, moved);
        return dot(after.axis_of_parent, moved) + dot(after.axis_of_parent - now.axis_of_parent, now.gap);
    }
};

Index node_at(const FigureView& view, Index slot) {
    const bool is_node = slot != no_body && (static_cast<unsigned>(view.jointed[place_of(slot).tile]) >> place_of(slot).lane & 1u) != 0;
    return is_node ? view.node_of[slot] : no_node;
}

/// h: s, of the substep.
GearedJoint geared_joint(const FigureView& view, Index joint_i, scalar h) {
    const JointRecord& record = view.lists.joints[joint_i];
    const Index node_A = node_at(view, record.body_A), node_B = node_at(view, record.body_B);
    const auto motion_of = [&](Index node_i, Index slot) {
        if (node_i == no_node) return motion_of_ground(ground_at(view, slot), h);
        return at_node(view, node_i, [](const auto& rows, const auto& at, int row_i) { return motion_of_row(at, rows[row_i]); });
    };
    return {record.kind, node_A, node_B, {motion_of(node_B, record.body_B), motion_of(node_A, record.body_A), record.frame_B, record.frame_A}};
}

/// What its row has of a way of A and of B, 1 / rad or 1 / m.
struct GearWeights {
    scalar of[2];
};
GearWeights weights_of(const GearRecord& gear, const JointRecord* joints, scalar unit) {
    const scalar unit_A = unit_of_travel(joints[gear.joint[0]].kind, 0, unit), unit_B = unit_of_travel(joints[gear.joint[1]].kind, 0, unit);
    const scalar scale = 1 / max(unit_B, abs(gear.ratio) * unit_A);
    return {{-gear.ratio * scale, scale}};
}

/// C, of ways that have whole turns beside them. scale: of B's.
scalar off_by(const GearRecord& gear, const AngleRecord (&value)[2], scalar scale) {
    const auto wide = [](int32_t turns) { return wide_scalar(static_cast<double>(turns)); };
    const wide_scalar turns = wide(value[1].turns) - wide_scalar(gear.ratio) * wide(value[0].turns);
    const scalar rest = (value[1].angle - gear.begin[1]) - gear.ratio * (value[0].angle - gear.begin[0]);
    return static_cast<scalar>(turns * wide_scalar(6.28318530717958647693)) * scale + rest * scale;
}

/// way: rad, that it has gone since the last value.
void go_on(AngleRecord& value, JointKind kind, scalar now, scalar way) {
    if (turns_round(kind)) {
        int32_t more = 0;
        (void)nearest_turn(now, value.angle + way, more);
        value.turns += more;
    }
    value.angle = now;
}

/// Adds what a unit impulse is on a body: f, at `arm` from its centre of mass.
void add_unit(const FigureView& view, const LoopFigure& of, GearMotion& motion, Index node_i, const Spatial<scalar>& f, const Vector& arm) {
    if (node_i == no_node || node_i < of.first_node || node_i >= of.first_node + of.node_count) return;
    const Vector at = at_node(view, node_i, [&](const auto& rows, const auto& lane, int row_i) { return read(lane, rows[row_i].c) + arm; });
    const Spatial<scalar> unit = impulse_from(f, at);
    for (int i = 0; i < motion.count; ++i)  // bound: 4
        if (motion.node[i] == node_i) {
            motion.on[i] = motion.on[i] + unit;
            return;
        }
    motion.node[motion.count] = node_i;
    motion.on[motion.count++] = unit;
}

/// m/s, with which bodies go whose joint has to turn so fast: what hangs on them is no further away than the joint is, it is supposed. Of a joint
/// whose sides both move as they are told: more than any.
scalar speed_by(const FigureView& view, const GearedJoint& joint, scalar rate) {
    const auto size_of = [&](Index node_i, const Vector& arm) {
        if (node_i == no_node) return scalar(0);
        return at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) {
            const Vector I = read(at, rows[row_i].I_body);
            return sqrt(max(I.x, max(I.y, I.z)) / at.get(rows[row_i].M) + length_sq(arm));
        });
    };
    if (joint.node_A == no_node && joint.node_B == no_node) return scalar_max;  // it takes up nothing
    if (joint.kind == JointKind::slider) return abs(rate);
    return 2 * abs(rate) * max(size_of(joint.node_B, joint.arm_on_B()), size_of(joint.node_A, joint.arm_on_A()));
}

}  // namespace

void begin_gear(const LoopView& loops, const LoopJoint& loop) {
    GearMotion& motion = loops.gear_motions[loop.joint];
    motion = {};
    for (int i = 0; i < 2; ++i) motion.value[i] = loops.gears[loop.joint].value[i];
}

void place_gear(const FigureView& view, const LoopView& loops, const LoopFigure& of, LoopJoint& loop) {
    const GearRecord& gear = loops.gears[loop.joint];
    GearMotion& motion = loops.gear_motions[loop.joint];
    const GearWeights weights = weights_of(gear, view.lists.joints, view.unit);
    const scalar gone = view.elapsed - motion.elapsed;
    motion.count = 0;
    for (int i = 0; i < 2; ++i) {
        const GearedJoint joint = geared_joint(view, gear.joint[i], 0);
        const Spatial<scalar> s = joint.direction() * weights.of[i];
        go_on(motion.value[i], joint.kind, joint.value(), gone > 0 ? joint.rate() * gone : scalar(0));
        add_unit(view, of, motion, joint.node_B, s, joint.arm_on_B());
        add_unit(view, of, motion, joint.node_A, s * scalar(-1), joint.arm_on_A());
        loop.is_turn[0] = joint.kind != JointKind::slider;
        loop.direction[0] = loop.is_turn[0] ? s.w : s.v;  // of B, at the last
    }
    motion.elapsed = view.elapsed;
}

void aim_gear(const FigureView& view, const LoopView& loops, LoopJoint& loop, bool is_exact, scalar h) {
    const GearRecord& gear = loops.gears[loop.joint];
    const GearWeights weights = weights_of(gear, view.lists.joints, view.unit);
    const GearedJoint joints[2] = {geared_joint(view, gear.joint[0], h), geared_joint(view, gear.joint[1], h)};
    scalar change = 0, driven = 0;
    for (int i = 0; i < 2; ++i) {
        change += weights.of[i] * joints[i].way(is_exact, h);
        driven += weights.of[i] * joints[i].rate_by_grounds();
    }
    loop.target[0] = -change / h;
    // Either joint alone can take up what moves as it is told.
    scalar& speed = loops.gear_motions[loop.joint].driven;
    speed = driven == 0 ? scalar(0) : min(speed_by(view, joints[0], driven / weights.of[0]), speed_by(view, joints[1], driven / weights.of[1]));
}

scalar way_back_of_gear(const FigureView& view, const LoopView& loops, const LoopJoint& loop) {
    const GearRecord& gear = loops.gears[loop.joint];
    AngleRecord value[2];
    for (int i = 0; i < 2; ++i) {
        const GearedJoint joint = geared_joint(view, gear.joint[i], 0);
        value[i] = loops.gear_motions[loop.joint].value[i];
        go_on(value[i], joint.kind, joint.value(), 0);
    }
    return -off_by(gear, value, weights_of(gear, view.lists.joints, view.unit).of[1]);
}

void keep_gear(const LoopView& loops, const LoopJoint& loop) {
    const GearMotion& motion = loops.gear_motions[loop.joint];
    if (!is_finite(motion.value[0].angle) || !is_finite(motion.value[1].angle)) return;  // of bodies that have gone bad
    GearRecord& gear = loops.gears[loop.joint];
    bool again = false;
    for (int i = 0; i < 2; ++i) {
        gear.value[i] = motion.value[i];
        again = again || abs(static_cast<scalar>(motion.value[i].turns)) > limits::turns_max;
    }
    if (!again) return;
    for (int i = 0; i < 2; ++i) {  // turns begin again
        gear.begin[i] = gear.value[i].angle;
        gear.value[i].turns = 0;
    }
}

namespace {

/// Between two steps; rad, m.
scalar value_now(const BodyView& bodies, const JointRecord& joint) {
    const auto motion_of = [&](Index slot) {
        if (slot == no_body) return SideMotion<scalar>{{}, identity_matrix<scalar>(), {}, {}, {}};
        return SideMotion<scalar>{r_CM_of(bodies, slot), lane_of(bodies.rotation[place_of(slot).tile].A, place_of(slot).lane), {}, {}, {}};
    };
    return measure(joint.kind, sides_at(motion_of(joint.body_B), joint.frame_B, motion_of(joint.body_A), joint.frame_A)).of[0];
}

/// B of a joint where it can move, else A.
Index moving_side(const BodyView& bodies, const JointRecord& joint) {
    const auto moves = [&](Index slot) { return slot != no_body && is_dynamic(bodies, slot); };
    return moves(joint.body_B) ? joint.body_B : moves(joint.body_A) ? joint.body_A : no_body;
}

}  // namespace

void couple(const BodyView& bodies, const JointRecord* joints, GearRecord& gear) {
    for (int i = 0; i < 2; ++i) {
        gear.begin[i] = value_now(bodies, joints[gear.joint[i]]);
        gear.value[i] = {gear.begin[i], 0};
    }
}

void name_bodies(const BodyView& bodies, const JointLists& lists, const GearRecord& gear, JointRecord& record) {
    const JointRecord &A = lists.joints[gear.joint[0]], &B = lists.joints[gear.joint[1]];
    const auto moves = [&](Index slot) { return slot != no_body && is_dynamic(bodies, slot); };
    Index of_A = moving_side(bodies, A);
    const Index of_B = moving_side(bodies, B);
    if (of_A == of_B && of_B != no_body) of_A = moves(A.body_A) && A.body_A != of_B ? A.body_A : no_body;
    if (of_A == no_body && of_B == no_body) return;  // it does nothing, whichever it has
    record.body_A = of_A;
    record.body_B = of_B;
}

scalar gap_of(const BodyView& bodies, const JointRecord* joints, const GearRecord& gear) {
    AngleRecord value[2] = {gear.value[0], gear.value[1]};
    for (int i = 0; i < 2; ++i) go_on(value[i], joints[gear.joint[i]].kind, value_now(bodies, joints[gear.joint[i]]), 0);
    return off_by(gear, value, 1);
}

void look_at_gears(const BodyView& bodies, const JointLists& lists, GearRecord* gears, TieRecord* ties, int joint_slots) {
    for (int joint_i = 0; joint_i < joint_slots; ++joint_i) {  // bound: max_joints
        JointRecord& record = lists.joints[joint_i];
        if (record.kind != JointKind::gear) continue;
        GearRecord& gear = gears[joint_i];
        const bool works = may_be_geared(lists.joints[gear.joint[0]].kind) && may_be_geared(lists.joints[gear.joint[1]].kind);
        if (!works || ties[joint_i].slack != 0) couple(bodies, lists.joints, gear);
        ties[joint_i].slack = works ? 0 : 1;
        JointRecord named = record;
        name_bodies(bodies, lists, gear, named);
        if (named.body_A == record.body_A && named.body_B == record.body_B) continue;
        lists.unlink(joint_i);
        record = named;
        lists.link(joint_i);
    }
}

} }  // namespace ingot
