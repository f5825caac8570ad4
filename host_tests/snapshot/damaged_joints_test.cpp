// SPDX-License-Identifier: MIT
// Damaged snapshots of joints: every number of every kind, with its limits, drives, strength, length, target and ratio. What no call could have made
// is refused, and changes no bit of the world; what is accepted is what was asked for, and goes on.
#include "snapshot/sound.h"

namespace {

using namespace life;
using ingot::JointId;
using ingot::JointKind;

struct Jointed : ingot::Scene {
    static constexpr int max_bodies = 8, max_joints = 16, max_loops = 10;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::FixedJoint, ingot::WheelJoint,
                                 ingot::RodJoint, ingot::RopeJoint, ingot::ParallelJoint, ingot::TargetJoint, ingot::ServoJoint,
                                 ingot::BallServoJoint, ingot::GearJoint, ingot::WithLimits, ingot::WithDrives, ingot::WithBreaking>;
};

/// Of every kind one, in motion, and the slot of one that was taken away.
struct Joints {
    Sound<Jointed> sound;
    std::vector<JointKind> kinds;  ///< by slot
    std::unique_ptr<World<Jointed>> victim{new World<Jointed>};

    Joints() {
        World<Jointed>& world = *sound.world;
        clear(world);
        BodyId bodies[Jointed::max_bodies];
        for (int i = 0; i < Jointed::max_bodies; ++i) bodies[i] = world.add(plain_body({static_cast<scalar>(i), 0, 0})).value;
        const auto join = [&](const ingot::Joint& joint, BodyId A, BodyId B) {
            ingot::JointDef def;
            def.body_A = A;
            def.body_B = B;
            def.joint = joint;
            def.P = world.state(B).value.r_CM;
            def.P_B = def.P + Vector{0, scalar(0.25), 0};
            const auto id = world.add_joint(def);
            EXPECT_TRUE(id.ok()) << static_cast<int>(joint.kind) << ": " << ingot::name(id.status);
            kinds.push_back(joint.kind);
            return id.value;
        };
        (void)join(ingot::BallJoint{1, scalar(-0.5), 2}, bodies[0], bodies[1]);
        const JointId hinge = join(ingot::HingeJoint{-9, 9}, bodies[1], bodies[2]), slider = join(ingot::SliderJoint{-1, 1}, bodies[2], bodies[3]);
        (void)join(ingot::UniversalJoint{{-1, 1}, {-2, 2}}, bodies[3], bodies[4]);
        (void)join(ingot::FixedJoint{}, bodies[4], bodies[5]);
        const JointId wheel = join(ingot::WheelJoint{-1, 1}, bodies[5], bodies[6]), gone = join(ingot::BallJoint{}, bodies[6], bodies[7]);
        (void)join(ingot::RodJoint{}, {}, bodies[0]);
        (void)join(ingot::RopeJoint{3}, bodies[0], bodies[2]);
        (void)join(ingot::ParallelJoint{}, bodies[6], bodies[7]);
        (void)join(ingot::TargetJoint{}, {}, bodies[7]);
        (void)join(ingot::ServoJoint{}, bodies[0], bodies[3]);
        (void)join(ingot::BallServoJoint{}, {}, bodies[4]);
        EXPECT_TRUE(world.add_gear(hinge, slider, scalar(0.5)).ok());
        kinds.push_back(JointKind::gear);
        EXPECT_EQ(world.set_joint_drive(hinge, ingot::TunedDrive{2, 1, 1}), Status::ok);
        EXPECT_EQ(world.set_joint_drive(wheel, ingot::MotorDrive{3, 5}), Status::ok);
        EXPECT_EQ(world.remove(gone), Status::ok);
        kinds[6] = JointKind::none;
        EXPECT_EQ(world.apply_angular_impulse(bodies[2], {1, 2, 3}), Status::ok);
        for (int step_i = 0; step_i < 2; ++step_i) EXPECT_EQ(ingot::step(world, h).bodies_frozen, 0);
        sound.keep();
        copy(*victim, world);
    }

    /// Of the joint in a slot, the n-th of this name.
    const replay::SnapshotField& field(int slot, const std::string& name, int nth = 0) const {
        int at = -1;
        for (const auto& one : sound.fields) {
            if (one.name == "joint.generation") ++at;
            if (at == slot && one.name == name && nth-- == 0) return one;
        }
        ADD_FAILURE() << "no " << name << " of joint " << slot;
        return sound.fields.front();
    }
    int slot_of(JointKind kind) const {
        for (size_t i = 0; i < kinds.size(); ++i)
            if (kinds[i] == kind) return static_cast<int>(i);
        return -1;
    }
    /// Calls each(slot, field) for all numbers of joints.
    template <class Each>
    void over_numbers(const Each& each) const {
        int slot = -1;
        for (const auto& one : sound.fields) {
            if (one.name == "joint.generation") ++slot;
            if (one.name.rfind("joint.", 0) == 0) each(slot, one);
        }
    }
    void refuses(const Bytes& bytes, const std::string& what) const {
        EXPECT_EQ(ingot::load_snapshot(*victim, bytes.data(), bytes.size()), Status::bad_snapshot) << what;
        ASSERT_TRUE(same_bytes(*victim, *sound.world)) << what << " changed the world";
    }
    /// It is what it says it is, and goes on.
    void accepts(const Bytes& bytes, const std::string& what) const {
        ASSERT_EQ(ingot::load_snapshot(*victim, bytes.data(), bytes.size()), Status::ok) << what;
        EXPECT_EQ(saved(*victim), bytes) << what;
        (void)ingot::step(*victim, h);
        copy(*victim, *sound.world);
    }
};

TEST(DamagedJoints, of_numbers_that_are_not_finite) {
    const Joints joints;
    joints.accepts(joints.sound.bytes, "what was saved");
    int count = 0;
    joints.over_numbers([&](int slot, const replay::SnapshotField& field) {
        if (!field.is_real || joints.kinds[static_cast<size_t>(slot)] == JointKind::none) return;
        ++count;
        const bool some = count % 4 == 0 || !INGOT_TEST_BRIEF;
        joints.refuses(joints.sound.with_real(field, std::numeric_limits<scalar>::quiet_NaN()), field.name + " of " + std::to_string(slot));
        if (some) joints.refuses(joints.sound.with_real(field, -std::numeric_limits<scalar>::infinity()), field.name + " of " + std::to_string(slot));
    });
    EXPECT_GT(count, 13 * 80);
}

/// A number that no joint has, and one at the end of what there may be.
struct Range {
    const char* name;
    scalar beyond, last;
};

TEST(DamagedJoints, of_numbers_that_are_out_of_range) {
    const Joints joints;
    const scalar more = 1 + 8 * ingot::epsilon, place = limits::position_max, pi = scalar(3.1415926535897932385);
    const Range ranges[] = {
        {"joint.anchor.x", 2 * more * place, 2 * place}, {"joint.anchor.y", -2 * more * place, -2 * place},
        {"joint.anchor.z", 2 * more * place, -2 * place},
        {"joint.restitution", -ingot::epsilon, 0}, {"joint.restitution", more, 1},
        {"joint.angle", pi * more, pi}, {"joint.angle", -pi * more, -pi},
        {"joint.stiffness", -ingot::epsilon, limits::drive_hertz_max}, {"joint.stiffness", limits::drive_gain_max * more, 0},
        {"joint.damping", -ingot::epsilon, limits::damping_ratio_max}, {"joint.damping", limits::drive_gain_max * more, 0},
        {"joint.target", place * more, place}, {"joint.target", -place * more, -place},
        {"joint.target_low", place * ingot::epsilon * more, place * ingot::epsilon}, {"joint.target_low", -place * ingot::epsilon * more, 0},
        {"joint.target_rate", limits::drive_rate_max * more, limits::drive_rate_max}, {"joint.target_rate", -limits::drive_rate_max * more, 1},
        {"joint.feedforward", limits::drive_gain_max * more, limits::drive_gain_max}, {"joint.feedforward", -limits::drive_gain_max * more, 1},
        {"joint.max_torque", -ingot::epsilon, ingot::unlimited},
        {"joint.strength.force", -ingot::epsilon, ingot::unlimited}, {"joint.strength.torque", -ingot::epsilon, 0},
        {"joint.hertz", -ingot::epsilon, 0}, {"joint.hertz", limits::drive_hertz_max * more, limits::drive_hertz_max},
        {"joint.damping_ratio", -ingot::epsilon, 0}, {"joint.damping_ratio", limits::damping_ratio_max * more, limits::damping_ratio_max},
        {"joint.max_force", -ingot::epsilon, 0}, {"joint.target_velocity.y", limits::speed_max * more, limits::speed_max},
        {"joint.target_spin.z", -limits::drive_rate_max * more, -limits::drive_rate_max},
    };
    for (const Range& range : ranges) {
        const std::string name = range.name;
        const bool is_target =
            name == "joint.hertz" || name == "joint.damping_ratio" || name == "joint.max_force" || name.rfind("joint.target_", 0) == 0;
        const JointKind kind = is_target && name != "joint.target_rate" && name != "joint.target_low" ? JointKind::target : JointKind::hinge;
        const auto& field = joints.field(joints.slot_of(kind), name);
        joints.refuses(joints.sound.with_real(field, range.beyond), name + " beyond its range");
        joints.accepts(joints.sound.with_real(field, range.last), name + " at the end of its range");
    }
    for (const char* const name : {"joint.axis.x", "joint.axis.z", "joint.side.y"})
        for (int side = 0; side < 2; ++side)
            joints.refuses(joints.sound.with_real(joints.field(1, name, side), 2), std::string(name) + ", no unit vector");
    Bytes along = joints.sound.bytes;  // unit vectors, not at right angles
    for (const char* const part : {".x", ".y", ".z"}) {
        const auto &axis = joints.field(1, std::string("joint.axis") + part), &side = joints.field(1, std::string("joint.side") + part);
        along = Sound<Jointed>::put(along, side.offset, axis.bits, side.size);
    }
    joints.refuses(Sound<Jointed>::sealed(along), "a side along its axis");
}

TEST(DamagedJoints, of_limits) {
    const Joints joints;
    const scalar swing = limits::joint_swing_max * 2, turns = limits::joint_angle_max * 2, far = limits::position_max * 2;
    struct Ends {
        JointKind kind;
        int range;
        scalar beyond;
    };
    for (const Ends& ends : {Ends{JointKind::ball, 0, swing}, {JointKind::ball, 1, swing}, {JointKind::hinge, 0, turns}, {JointKind::slider, 0, far},
                             {JointKind::universal, 0, swing}, {JointKind::universal, 1, swing}, {JointKind::wheel, 0, turns},
                             {JointKind::wheel, 1, far}}) {
        const int slot = joints.slot_of(ends.kind);
        const auto &lower = joints.field(slot, "joint.lower", ends.range), &upper = joints.field(slot, "joint.upper", ends.range);
        const std::string what = "of kind " + std::to_string(static_cast<int>(ends.kind)) + " range " + std::to_string(ends.range);
        joints.refuses(joints.sound.with_real(lower, -ends.beyond), "lower " + what);
        joints.refuses(joints.sound.with_real(upper, ends.beyond), "upper " + what);
        joints.refuses(joints.sound.with_real(lower, ends.beyond / 4 * 3), "lower above upper " + what);
        joints.accepts(joints.sound.with_real(upper, ingot::unlimited), "none " + what);
    }
    const auto& cone = joints.field(joints.slot_of(JointKind::ball), "joint.upper", 1);
    joints.refuses(joints.sound.with_real(cone, limits::joint_cone_min / 2), "a narrow cone");
    for (const JointKind kind : {JointKind::servo, JointKind::ball_servo}) {  // they have none
        joints.refuses(joints.sound.with_real(joints.field(joints.slot_of(kind), "joint.lower"), 0), "of a servo");
        joints.refuses(joints.sound.with_real(joints.field(joints.slot_of(kind), "joint.upper", 1), 0), "of a servo");
    }
}

TEST(DamagedJoints, of_ties) {
    const Joints joints;
    for (const JointKind kind : {JointKind::rod, JointKind::rope}) {
        const int slot = joints.slot_of(kind);
        const auto &length = joints.field(slot, "joint.length"), &reeled = joints.field(slot, "joint.reeled");
        for (const scalar bad : {scalar(0), scalar(-1), limits::tie_length_min / 2, limits::position_max * 2}) {
            joints.refuses(joints.sound.with_real(length, bad), "a length");
            if (bad != limits::tie_length_min / 2) joints.refuses(joints.sound.with_real(reeled, bad), "how far it is reeled");
        }
        joints.accepts(joints.sound.with_real(length, limits::position_max), "the longest");
        joints.refuses(joints.sound.with(joints.field(slot, "joint.slack"), 2), "more than slack");
        joints.refuses(joints.sound.with_real(joints.field(slot, "joint.ratio"), 1), "a ratio");
    }
    for (const JointKind kind : {JointKind::hinge, JointKind::target, JointKind::parallel, JointKind::ball_servo, JointKind::gear}) {
        const int slot = joints.slot_of(kind);
        joints.refuses(joints.sound.with_real(joints.field(slot, "joint.length"), 1), "what has no length");
        joints.refuses(joints.sound.with_real(joints.field(slot, "joint.reeled"), 1), "what cannot be reeled");
        const Bytes slack = joints.sound.with(joints.field(slot, "joint.slack"), 1);
        kind == JointKind::gear ? joints.accepts(slack, "a gear that does nothing") : joints.refuses(slack, "what does not hang slack");
    }
}

TEST(DamagedJoints, of_gears) {
    const Joints joints;
    const int gear = joints.slot_of(JointKind::gear), hinge = joints.slot_of(JointKind::hinge);
    const auto& ratio = joints.field(gear, "joint.ratio");
    joints.refuses(joints.sound.with_real(ratio, 0), "no ratio");
    joints.accepts(joints.sound.with_real(ratio, 2), "another ratio");
    for (int i = 0; i < 2; ++i) {
        const auto& geared = joints.field(gear, "joint.geared", i);
        joints.refuses(joints.sound.with(geared, joints.field(gear, "joint.geared", 1 - i).bits), "of one joint");
        joints.refuses(joints.sound.with(geared, Jointed::max_joints), "of a joint beyond the last");
        for (const auto slot : {6, gear, Jointed::max_joints - 1, joints.slot_of(JointKind::rope), joints.slot_of(JointKind::ball)})
            joints.accepts(joints.sound.with(geared, static_cast<uint64_t>(slot)), "of a joint that cannot be geared: it does nothing");
        joints.accepts(joints.sound.with(joints.field(gear, "joint.gear_turns", i), 77), "after some turns");
        // Of what is no gear nothing of one is kept.
        joints.refuses(joints.sound.with(joints.field(hinge, "joint.geared", i), 3), "gears of a hinge");
        joints.refuses(joints.sound.with(joints.field(hinge, "joint.gear_turns", i), 3), "turns of a hinge");
        joints.refuses(joints.sound.with_real(joints.field(hinge, "joint.gear_begin", i), 1), "a begin of a hinge");
        joints.refuses(joints.sound.with_real(joints.field(hinge, "joint.gear_angle", i), 1), "an angle of a hinge");
    }
    joints.refuses(joints.sound.with_real(joints.field(hinge, "joint.ratio"), 1), "a ratio of a hinge");
    // Whole turns of more than limits::turns_max, on both sides in their ratio, a half: after a step they begin again, and nothing else has changed.
    const auto &turns = joints.field(gear, "joint.gear_turns"), &others = joints.field(gear, "joint.gear_turns", 1);
    const Bytes turned = Sound<Jointed>::put(joints.sound.bytes, turns.offset, 2000000000, turns.size);
    const Bytes both = Sound<Jointed>::sealed(Sound<Jointed>::put(turned, others.offset, 1000000000, others.size));
    ASSERT_EQ(ingot::load_snapshot(*joints.victim, both.data(), both.size()), Status::ok);
    Joints plain;
    (void)ingot::step(*joints.victim, h);
    (void)ingot::step(*plain.sound.world, h);
    for (int i = 0; i < Jointed::max_bodies; ++i) {
        const BodyState a = joints.victim->state(joints.victim->body_at(i)).value, b = plain.sound.world->state(plain.sound.world->body_at(i)).value;
        EXPECT_TRUE(same_bits(a, b)) << i;
    }
    EXPECT_LE(joints.victim->joint_gap(joints.victim->joint_at(gear)).value, 2 * ingot::limits::joint_gap);
    copy(*plain.sound.world, *joints.victim);
    plain.sound.keep();
    for (int i = 0; i < 2; ++i) EXPECT_EQ(plain.field(gear, "joint.gear_turns", i).bits, 0u);
}

TEST(DamagedJoints, of_kinds_bodies_and_marks) {
    const Joints joints;
    for (size_t slot = 0; slot < joints.kinds.size(); ++slot) {
        const auto at = [&](const char* name) { return joints.field(static_cast<int>(slot), name); };
        const std::string what = " of joint " + std::to_string(slot);
        if (joints.kinds[slot] == JointKind::none) {
            joints.refuses(joints.sound.with(at("joint.kind"), 1), "a kind" + what);
            joints.refuses(joints.sound.with(at("joint.generation"), at("joint.generation").bits + 1), "life" + what);
            continue;
        }
        for (const unsigned kind : {0u, static_cast<unsigned>(JointKind::carriage), static_cast<unsigned>(JointKind::driven_ball), 15u, 255u})
            joints.refuses(joints.sound.with(at("joint.kind"), kind), "another kind" + what);
        joints.refuses(joints.sound.with(at("joint.body_A"), Jointed::max_bodies), "no body A" + what);
        joints.refuses(joints.sound.with(at("joint.body_B"), Jointed::max_bodies), "no body B" + what);
        joints.refuses(joints.sound.with(at("joint.body_B"), at("joint.body_A").bits), "one body" + what);
        joints.refuses(joints.sound.with(at("joint.resolved"), 2), "a mark" + what);
        joints.refuses(joints.sound.with(at("joint.bodies_meet"), 2), "a mark" + what);
        joints.refuses(joints.sound.with(at("joint.doublings"), limits::doublings_max + 1), "doublings" + what);
        joints.refuses(joints.sound.with(at("joint.drive"), 4), "a drive" + what);
        joints.refuses(joints.sound.with(at("joint.phase"), 4), "a phase" + what);
    }
}

}  // namespace
