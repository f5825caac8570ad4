// SPDX-License-Identifier: MIT
// Joints: what two bodies, or a body and the world, may still do against each other.
#pragma once

#include "../base/ids.h"
#include "../math/vec3.h"

namespace ingot { inline namespace INGOT_ABI {

/// driven_ball: within figure/, a ball joint that has a drive; carriage: a wheel whose body is nearer to the root than what it carries.
enum class JointKind : uint8_t {
    none, ball, hinge, slider, universal, fixed, rod, rope, parallel, target, wheel, carriage, servo, ball_servo, gear, driven_ball = 64
};

/// They lock nothing: what they drive is measured in the world, and is driven against another body.
constexpr bool is_servo(JointKind kind) { return kind >= JointKind::servo && kind <= JointKind::ball_servo; }
/// Kinds that lock little, or give way: they are rows beside the trees, see figure/loop_view.h.
constexpr bool is_tie(JointKind kind) {
    return (kind >= JointKind::rod && kind <= JointKind::target) || (kind >= JointKind::servo && kind <= JointKind::gear);
}
constexpr bool is_wheel(JointKind kind) { return kind >= JointKind::wheel && kind <= JointKind::carriage; }
/// Those that a gear may couple: by their first free direction.
constexpr bool may_be_geared(JointKind kind) { return kind == JointKind::hinge || kind == JointKind::slider || kind == JointKind::wheel; }
/// Those that keep two points at a distance.
constexpr bool has_length(JointKind kind) { return kind == JointKind::rod || kind == JointKind::rope; }

/// As an end of a range: there is none.
inline constexpr scalar unlimited = scalar_max;

/// How far a joint goes in one of its free directions.
struct JointRange {
    scalar lower = -unlimited, upper = unlimited;  ///< rad or m; lower <= upper
};

/// Where the free directions of a joint end. In scenes that name WithLimits.
///
/// Of a hinge range[0] is of its angle, rad; of a slider of its travel, m; of a universal joint range[0] and range[1] are of its angles about the
/// axis of A and of B; of a ball joint range[0] is of its twist, and range[1].upper the half angle of its cone; of a wheel range[0] is of its spin
/// and range[1] of its travel. All are of B against A, and 0 where the bodies were joined. A joint that is beyond a limit goes back by no more than
/// limits::limit_return.
struct JointLimits {
    JointRange range[2];     ///< of which direction: see above
    scalar restitution = 0;  ///< of all, 0 to 1
};

/// Of any kind; the kinds below convert to it.
struct Joint {
    JointKind kind{};      ///< which
    JointLimits limits{};  ///< in scenes that name WithLimits
    Vector middle{};  ///< of the cone of a ball joint
};

/// Free in all turns about P: a shoulder, a link of a chain.
struct BallJoint {
    static constexpr JointKind kind = JointKind::ball;
    scalar cone = unlimited;                                     ///< rad, 0.01 to 3: how far the axis, which is B's, is from the middle, which is A's
    scalar twist_lower = -unlimited, twist_upper = unlimited;    ///< rad, -3 to 3: turn about the axis, once the swing of the axis is taken off
    scalar restitution = 0;  ///< of its limits, 0 to 1
    Vector middle = {};                                          ///< unit, world; 0: the axis as it is now
    constexpr operator Joint() const { return {kind, {{{twist_lower, twist_upper}, {-unlimited, cone}}, restitution}, middle}; }
};
/// Turns about an axis: a door, an elbow.
struct HingeJoint {
    static constexpr JointKind kind = JointKind::hinge;
    scalar lower = -unlimited, upper = unlimited;  ///< rad; more than a turn, if wanted
    scalar restitution = 0;  ///< of its limits, 0 to 1
    constexpr operator Joint() const { return {kind, {{{lower, upper}, {}}, restitution}, {}}; }
};
/// Goes along an axis, and does not turn: a piston.
struct SliderJoint {
    static constexpr JointKind kind = JointKind::slider;
    scalar lower = -unlimited, upper = unlimited;  ///< m
    scalar restitution = 0;  ///< of its limits, 0 to 1
    constexpr operator Joint() const { return {kind, {{{lower, upper}, {}}, restitution}, {}}; }
};
/// Turns about an axis of A and about an axis of B, which stay at right angles: a cardan.
struct UniversalJoint {
    static constexpr JointKind kind = JointKind::universal;
    JointRange about_A = {}, about_B = {};  ///< rad
    scalar restitution = 0;  ///< of its limits, 0 to 1
    constexpr operator Joint() const { return {kind, {{about_A, about_B}, restitution}, {}}; }
};
/// Neither turns nor goes: two bodies that are one.
struct FixedJoint {
    static constexpr JointKind kind = JointKind::fixed;
    constexpr operator Joint() const { return {kind, {}, {}}; }
};

/// A wheel, B, of what it carries, A, P on its axle: it spins about the axle, which is B's; it goes along an axis of A, its suspension; and about
/// that axis it is steered, while the two stay at right angles. All three are driven, see drives.h: the spin by a MotorDrive, an engine, or a brake
/// with the rate 0; the travel by a SpringDrive or a TunedDrive, its spring; the steering by a servo, to its target. As it is joined it is held
/// straight, as stiff as can be; without that drive it is a caster. In scenes that name WithDrives.
struct WheelJoint {
    static constexpr JointKind kind = JointKind::wheel;
    static constexpr int spin = 0, travel = 1, steering = 2;  ///< `which` of its drives, and of joint_angle and joint_rate
    scalar lower = -unlimited, upper = unlimited;  ///< m, of its travel: B against A along `axis`
    scalar restitution = 0;  ///< of its limits, 0 to 1
    constexpr operator Joint() const { return {kind, {{{}, {lower, upper}}, restitution}, {}}; }
};

/// Keeps two points, P of A and P_B of B, at a distance. One of max_loops.
struct RodJoint {
    static constexpr JointKind kind = JointKind::rod;
    scalar length = 0;  ///< m, limits::tie_length_min to limits::position_max; 0: as far as they are now
    constexpr operator Joint() const { return {kind, {{{length, length}, {}}, 0}, {}}; }
};
/// Lets two points, P of A and P_B of B, be no further apart: it pulls, and does not push. What comes to its end does not bounce. While it is slack
/// it is nothing to its bodies. One of max_loops.
struct RopeJoint {
    static constexpr JointKind kind = JointKind::rope;
    scalar length = 0;  ///< m, as of a rod
    constexpr operator Joint() const { return {kind, {{{-unlimited, length}, {}}, 0}, {}}; }
};

/// Keeps an axis of B along one of A, and nothing else: what slides over a table, or hangs from a balloon, and does not tilt. One of max_loops.
struct ParallelJoint {
    static constexpr JointKind kind = JointKind::parallel;
    constexpr operator Joint() const { return {kind, {}, {}}; }
};
/// Draws a body, B, to where it should be, P of it to a point of the world and its axes to others: a mouse, an animation, a hand. First to where it
/// is; see World::set_target, set_target_drive. A is the world. One of max_loops.
struct TargetJoint {
    static constexpr JointKind kind = JointKind::target;
    constexpr operator Joint() const { return {kind, {}, {}}; }
};

/// Turns a body, B, about an axis of the world to where it should be there, whatever it hangs on: the trunk of a walker, the thigh that swings. What
/// turns B turns A back: any other body, joined to it or not, or, with the null id, none. It locks nothing, and P is where it is drawn.
///
/// Its drive is that of a hinge, see World::set_joint_drive: torque on B along the axis, against it on A; angle and rate are those of B in the world,
/// about the axis, 0 as it is joined, and the angle goes on over whole turns. It is solved with the figures of both, their contacts and all that is
/// driven, so no stiffness rings. Where A, pushed back, would turn B more than B is turned, torque acts the wrong way round: then it is what the law
/// asks for as the substep begins. In scenes that name WithDrives. One of max_loops. B has to move.
struct ServoJoint {
    static constexpr JointKind kind = JointKind::servo;
    constexpr operator Joint() const { return {kind, {}, {}}; }
};
/// The same of all turns of a body: see World::set_ball_drive. Its targets and torques are in the axes of the world, 0 as it is joined.
struct BallServoJoint {
    static constexpr JointKind kind = JointKind::ball_servo;
    constexpr operator Joint() const { return {kind, {}, {}}; }
};

/// Couples two joints, A and B: by so much as A goes, B goes `ratio` times as far. See World::add_gear. One of max_loops.
///
/// Of a hinge it is its angle, of a wheel its spin, rad; of a slider its travel, m: each of its B against its A. Two hinges are wheels with teeth,
/// of ratio -z_A / z_B where they touch from outside and z_A / z_B by a chain or a belt; a hinge and a slider are a pinion and its rack, of its
/// radius, m; two hinges of one carrier with -1 are a differential, as what they turn by in it is opposite. Their bodies may be of one figure or of
/// two, or tied to the world; so limits, drives and brakes of either joint are those of both. The ratio holds over whole turns, to the rounding of
/// an angle: nothing adds up. There is no play.
///
/// While one of the two does nothing, as it is broken or switched off, so does the gear; once it works again they are coupled as they are then. What
/// turns by more than half a turn in a substep is not told from what turns the other way round.
struct GearJoint {
    static constexpr JointKind kind = JointKind::gear;
};

/// Beside the kinds of a scene's joints: they may have limits.
struct WithLimits {
    static constexpr JointKind kind = JointKind::none;
};

/// Beside the kinds of a scene's joints: they may be driven, see drives.h.
struct WithDrives {
    static constexpr JointKind kind = JointKind::none;
};

/// Beside the kinds of a scene's joints: World::joint_reaction tells what they bear, see reactions.h.
struct WithReactions {
    static constexpr JointKind kind = JointKind::none;
};

/// Beside the kinds of a scene's joints: they tell what they bear, and may break: see World::set_joint_strength.
struct WithBreaking {
    static constexpr JointKind kind = JointKind::none;
};

/// How many free directions of a kind may have limits: see JointLimits.
constexpr int limited_directions(JointKind kind) {
    switch (kind) {
        case JointKind::ball:
        case JointKind::driven_ball:
        case JointKind::universal:
        case JointKind::wheel:
        case JointKind::carriage: return 2;
        case JointKind::hinge:
        case JointKind::slider: return 1;
        default: return 0;
    }
}
/// How many can be driven: a ball joint's are its three turns, driven as one. The steering of a wheel has no limits.
constexpr int driven_directions(JointKind kind) {
    if (is_servo(kind)) return kind == JointKind::servo ? 1 : 3;
    return kind == JointKind::ball || kind == JointKind::driven_ball || is_wheel(kind) ? 3 : limited_directions(kind);
}

template <class A, class B>
inline constexpr bool is_same = false;
template <class A>
inline constexpr bool is_same<A, A> = true;

/// `using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint>;` of a scene: the kinds it has. What joints may have beside is named with them:
/// `ingot::Joints<ingot::HingeJoint, ingot::WithLimits>`.
template <class... Kinds>
struct Joints {
    /// The scene names this kind.
    static constexpr bool has(JointKind kind) { return kind != JointKind::none && ((Kinds::kind == kind) || ...); }
    static constexpr bool has_ties = (is_tie(Kinds::kind) || ...);
    /// It names hinges, and nothing else.
    static constexpr bool are_hinges = ((Kinds::kind == JointKind::hinge) && ...);
    static constexpr bool has_servos = (is_servo(Kinds::kind) || ...);
    static constexpr bool has_limits = (is_same<Kinds, WithLimits> || ...);
    /// The most directions with limits of a joint.
    static constexpr int limits_of_joint() {
        int most = 0;
        ((most = limited_directions(Kinds::kind) > most ? limited_directions(Kinds::kind) : most), ...);
        return has_limits ? most : 0;
    }
    static constexpr bool has_drives = (is_same<Kinds, WithDrives> || ...);
    /// The most driven directions of a joint.
    static constexpr int drives_of_joint() {
        int most = 0;
        ((most = driven_directions(Kinds::kind) > most ? driven_directions(Kinds::kind) : most), ...);
        return has_drives ? most : 0;
    }
    static constexpr bool may_break = (is_same<Kinds, WithBreaking> || ...);
    static constexpr bool has_reactions = may_break || (is_same<Kinds, WithReactions> || ...);
};

/// What World::add_joint needs to know. The bodies are joined as they are now: a hinge has the angle 0.
struct JointDef {
    BodyId body_A{}, body_B{};     ///< the null id: the world
    Joint joint{};                 ///< HingeJoint{} or another kind
    Vector P{};                    ///< m, world; of a rod and a rope: on A
    /// Unit, world: of a hinge, a slider, a servo, a parallel joint, of A of a universal one, of B of a ball joint with limits, of the suspension of
    /// a wheel.
    Vector axis = {0, 0, 1};
    Vector axis_B = {1, 0, 0};     ///< unit, world, at right angles to axis: of B of a universal joint; the axle of a wheel
    bool bodies_meet = false;      ///< the two may touch each other
    Vector P_B{};                  ///< m, world, on B: of a rod and a rope
};

/// Names one joint of one world for as long as it is there, as BodyId does a body.
struct JointId {
    Index slot{};           ///< where the joint is: World::joint_at; 0 .. max_joints - 1
    uint16_t world_tag{};   ///< World::set_tag
    uint32_t generation{};  ///< odd while the joint is there; 0: the null id

    /// The same joint of the same world.
    constexpr bool operator==(const JointId& other) const {
        return slot == other.slot && world_tag == other.world_tag && generation == other.generation;
    }
    constexpr bool operator!=(const JointId& other) const { return !(*this == other); }  ///< another
};

} }  // namespace ingot
