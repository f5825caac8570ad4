// SPDX-License-Identifier: MIT
// Every call about joints, by ids of none, of kinds that have nothing of the sort, and of joints whose bodies cannot move: it says why, and no bit of
// the world is another.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <string>

#include "figures.h"

namespace {

using namespace figures;
using ingot::JointId;
using ingot::Status;

/// All kinds, and all that they may have beside.
struct Store : ingot::Scene {
    static constexpr int max_bodies = 26, max_joints = 14, max_loops = 14;
    static constexpr bool translates = true, sleeps = true, kinematic_bodies = true;
    static constexpr int max_manifolds = 40;
    using joints = AllJointsWith<ingot::WheelJoint, ingot::RodJoint, ingot::RopeJoint, ingot::ParallelJoint, ingot::TargetJoint, ingot::ServoJoint,
                                 ingot::BallServoJoint, ingot::GearJoint, ingot::WithLimits, ingot::WithDrives, ingot::WithBreaking>;
    using shapes = ingot::Shapes<ingot::Sphere>;
};
using StoreWorld = ingot::World<Store>;
constexpr scalar frame = scalar(1) / 60;

ingot::BodyId add_ball(StoreWorld& world, const Vector& r_CM, const Vector& v_CM = {}) {
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::solid_sphere(1000, scalar(0.1))).value;
    def.shape = ingot::Sphere{scalar(0.1)};
    def.state.r_CM = r_CM;
    def.state.v_CM = v_CM;
    return world.add(def).value;
}
ingot::Result<JointId> join(StoreWorld& world, const ingot::Joint& kind, ingot::BodyId A, ingot::BodyId B) {
    ingot::JointDef def;
    def.body_A = A;
    def.body_B = B;
    def.joint = kind;
    def.P = world.state(A == ingot::BodyId{} ? B : A).value.r_CM;
    if (A == ingot::BodyId{} && !(kind.kind == ingot::JointKind::target)) def.P.z += scalar(0.5);
    def.P_B = world.state(B == ingot::BodyId{} ? A : B).value.r_CM;
    def.axis = {0, 0, 1};
    def.axis_B = {1, 0, 0};
    return world.add_joint(def);
}

/// A joint of each kind, each of two bodies of its own; a target has the world for one.
struct Shelf {
    std::unique_ptr<StoreWorld> world = std::make_unique<StoreWorld>();
    JointId of[20] = {};  ///< by kind

    Shelf() {
        EXPECT_EQ(world->set_tag(5), Status::ok);  // so that the null id is of no world
        int place = 0;
        const ingot::Joint kinds[] = {ingot::BallJoint{},   ingot::HingeJoint{}, ingot::SliderJoint{}, ingot::UniversalJoint{},
                                      ingot::FixedJoint{},  ingot::WheelJoint{}, ingot::RodJoint{},    ingot::RopeJoint{},
                                      ingot::ParallelJoint{}, ingot::TargetJoint{}, ingot::ServoJoint{}, ingot::BallServoJoint{}};
        for (const ingot::Joint& kind : kinds) {
            const Vector at = {static_cast<scalar>(2 * place++), 0, 0};
            const bool is_target = kind.kind == ingot::JointKind::target;
            const ingot::BodyId A = is_target ? ingot::BodyId{} : add_ball(*world, at), B = add_ball(*world, at + Vector{0, 0, -1});
            const auto id = join(*world, kind, A, B);
            EXPECT_TRUE(id.ok()) << place << ": " << ingot::name(id.status);
            at_kind(kind.kind) = id.value;
        }
        const auto gear = world->add_gear(at_kind(ingot::JointKind::hinge), at_kind(ingot::JointKind::slider), 2);
        EXPECT_TRUE(gear.ok());
        at_kind(ingot::JointKind::gear) = gear.value;
        EXPECT_TRUE(ingot::step(*world, frame).clean());
    }
    JointId& at_kind(ingot::JointKind kind) { return of[static_cast<int>(kind)]; }
};

using Kind = ingot::JointKind;
struct Call {
    const char* name;
    std::function<Status(StoreWorld&, JointId)> make;
    std::vector<Kind> kinds;  ///< that have what it asks for; empty: all of them
};

std::vector<Call> all_calls() {
    const std::vector<Kind> turning = {Kind::ball, Kind::hinge, Kind::universal, Kind::wheel, Kind::servo}, sliding = {Kind::slider, Kind::wheel};
    const std::vector<Kind> driven = {Kind::hinge, Kind::slider, Kind::universal, Kind::wheel, Kind::servo}, balls = {Kind::ball, Kind::ball_servo};
    const std::vector<Kind> limited = {Kind::ball, Kind::hinge, Kind::slider, Kind::universal, Kind::wheel};
    const std::vector<Kind> tied = {Kind::rod, Kind::rope}, drawn = {Kind::target};
    const ingot::SpringDrive spring{20, 2, scalar(0.1)};
    return {
        {"joint_gap", [](StoreWorld& w, JointId id) { return w.joint_gap(id).status; }, {}},
        {"joint_place", [](StoreWorld& w, JointId id) { return w.joint_place(id).status; }, {}},
        {"figure", [](StoreWorld& w, JointId id) { return w.figure(id).status; }, {}},
        {"joint_reaction", [](StoreWorld& w, JointId id) { return w.joint_reaction(id).status; }, {}},
        {"joint_strength", [](StoreWorld& w, JointId id) { return w.joint_strength(id).status; }, {}},
        {"set_joint_strength", [](StoreWorld& w, JointId id) { return w.set_joint_strength(id, {1000, 1000}); }, {}},
        {"is_joint_enabled", [](StoreWorld& w, JointId id) { return w.is_joint_enabled(id).status; }, {}},
        {"is_joint_broken", [](StoreWorld& w, JointId id) { return w.is_joint_broken(id).status; }, {}},
        {"set_joint_enabled", [](StoreWorld& w, JointId id) { return w.set_joint_enabled(id, true); }, {}},
        {"joint_angle", [](StoreWorld& w, JointId id) { return w.joint_angle(id).status; }, turning},
        {"joint_rate", [](StoreWorld& w, JointId id) { return w.joint_rate(id).status; }, turning},
        {"ball_turn", [](StoreWorld& w, JointId id) { return w.ball_turn(id).status; }, {Kind::ball}},
        {"ball_rate", [](StoreWorld& w, JointId id) { return w.ball_rate(id).status; }, {Kind::ball}},
        {"joint_travel", [](StoreWorld& w, JointId id) { return w.joint_travel(id).status; }, sliding},
        {"joint_speed", [](StoreWorld& w, JointId id) { return w.joint_speed(id).status; }, sliding},
        {"set_joint_limits", [](StoreWorld& w, JointId id) { return w.set_joint_limits(id, {}); }, limited},
        {"set_joint_drive", [=](StoreWorld& w, JointId id) { return w.set_joint_drive(id, spring); }, driven},
        {"set_joint_target", [](StoreWorld& w, JointId id) { return w.set_joint_target(id, scalar(0.1)); }, driven},
        {"joint_drive", [](StoreWorld& w, JointId id) { return w.joint_drive(id).status; }, driven},
        {"drive_torque", [](StoreWorld& w, JointId id) { return w.drive_torque(id).status; }, driven},
        {"set_ball_drive", [=](StoreWorld& w, JointId id) { return w.set_ball_drive(id, spring); }, balls},
        {"set_ball_target", [](StoreWorld& w, JointId id) { return w.set_ball_target(id, {scalar(0.1), 0, 0}); }, balls},
        {"ball_torque", [](StoreWorld& w, JointId id) { return w.ball_torque(id).status; }, balls},
        {"set_joint_length", [](StoreWorld& w, JointId id) { return w.set_joint_length(id, scalar(0.9)); }, tied},
        {"joint_length", [](StoreWorld& w, JointId id) { return w.joint_length(id).status; }, tied},
        {"joint_distance", [](StoreWorld& w, JointId id) { return w.joint_distance(id).status; }, tied},
        {"target_drive", [](StoreWorld& w, JointId id) { return w.target_drive(id).status; }, drawn},
        {"set_target_drive", [](StoreWorld& w, JointId id) { return w.set_target_drive(id, {4, 1, 500, 50}); }, drawn},
        {"set_target of a place", [](StoreWorld& w, JointId id) { return w.set_target(id, {1, 2, 3}); }, drawn},
        {"set_target of axes", [](StoreWorld& w, JointId id) { return w.set_target(id, {1, 2, 3}, ingot::identity_matrix<scalar>()); }, drawn},
        {"target_force", [](StoreWorld& w, JointId id) { return w.target_force(id).status; }, drawn},
        {"target_torque", [](StoreWorld& w, JointId id) { return w.target_torque(id).status; }, drawn},
        {"gear_ratio", [](StoreWorld& w, JointId id) { return w.gear_ratio(id).status; }, {Kind::gear}},
    };
}

/// The call is refused so, and the world is what it was.
void expect_refused(StoreWorld& world, Status status, const std::function<Status(StoreWorld&)>& call, const std::string& what) {
    std::vector<unsigned char> before(sizeof world);
    std::memcpy(before.data(), &world, sizeof world);
    const Status said = call(world);
    EXPECT_EQ(said, status) << what << ": " << ingot::name(said);
    EXPECT_EQ(std::memcmp(before.data(), &world, sizeof world), 0) << what;
}

TEST(JointIds, of_none_are_refused_by_every_call) {
    Shelf shelf;
    std::vector<Call> calls = all_calls();
    calls.push_back({"remove", [](StoreWorld& w, JointId id) { return w.remove(id); }, {}});
    calls.push_back({"set_target of bad axes", [](StoreWorld& w, JointId id) { return w.set_target(id, {}, ingot::Matrix{}); }, {}});
    const JointId hinge = shelf.at_kind(Kind::hinge);
    calls.push_back({"add_gear, A", [=](StoreWorld& w, JointId id) { return w.add_gear(id, hinge, 1).status; }, {}});
    calls.push_back({"add_gear, B", [=](StoreWorld& w, JointId id) { return w.add_gear(hinge, id, 1).status; }, {}});
    for (const Kind kind : {Kind::ball, Kind::hinge, Kind::wheel, Kind::rope, Kind::target, Kind::gear}) {
        const JointId id = shelf.at_kind(kind);
        JointId stale = id, even = id, foreign = id, beyond = id;
        stale.generation += 2;
        even.generation += 1;
        foreign.world_tag ^= 1;
        beyond.slot = Store::max_joints;
        for (const Call& call : calls)
            for (const auto& [bad, status] : {std::pair{stale, Status::stale_id}, {even, Status::stale_id}, {beyond, Status::stale_id},
                                              {JointId{}, Status::stale_id}, {foreign, Status::foreign_id}})
                expect_refused(*shelf.world, status, [&, bad = bad](StoreWorld& w) { return call.make(w, bad); }, call.name);
    }
    EXPECT_EQ(shelf.world->joint_at(-1), JointId{});
    EXPECT_EQ(shelf.world->joint_at(Store::max_joints), JointId{});
}

TEST(JointIds, of_other_kinds_are_refused_by_every_call) {
    Shelf shelf;
    for (const Call& call : all_calls()) {
        if (call.kinds.empty()) continue;
        for (int kind_i = 0; kind_i < 20; ++kind_i) {
            const JointId id = shelf.of[kind_i];
            if (id == JointId{}) continue;
            bool has = false;
            for (const Kind kind : call.kinds) has = has || static_cast<int>(kind) == kind_i;
            if (!has)
                expect_refused(*shelf.world, Status::not_in_scene, [&](StoreWorld& w) { return call.make(w, id); },
                               std::string(call.name) + " of kind " + std::to_string(kind_i));
        }
    }
}

TEST(JointIds, of_their_kinds_are_obeyed_by_every_call) {
    for (const Call& call : all_calls()) {
        Shelf shelf;
        for (int kind_i = 0; kind_i < 20; ++kind_i) {
            bool has = call.kinds.empty();
            for (const Kind kind : call.kinds) has = has || static_cast<int>(kind) == kind_i;
            if (!has || shelf.of[kind_i] == JointId{}) continue;
            EXPECT_EQ(call.make(*shelf.world, shelf.of[kind_i]), Status::ok) << call.name << " of kind " << kind_i;
        }
        EXPECT_EQ(ingot::step(*shelf.world, frame).bodies_frozen, 0) << call.name;
    }
}

/// What cannot be a number, or goes too far, is refused, and the target is where it was.
TEST(JointIds, targets_of_balls_are_looked_at) {
    Shelf shelf;
    const JointId ball = shelf.at_kind(Kind::ball);
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN(), far = ingot::limits::joint_swing_max * scalar(1.01);
    const auto refused = [&](Status status, const Vector& target, const Vector& rate) {
        expect_refused(*shelf.world, status, [&](StoreWorld& w) { return w.set_ball_target(ball, target, rate); }, "set_ball_target");
        const ingot::SpringDrive spring{20, 2};
        expect_refused(*shelf.world, status, [&](StoreWorld& w) { return w.set_ball_drive(ball, spring, target, rate); }, "set_ball_drive");
    };
    refused(Status::not_finite, {0, nan, 0}, {});
    refused(Status::not_finite, {}, {0, 0, nan});
    refused(Status::out_of_range, {far, 0, 0}, {});
    refused(Status::out_of_range, Vector{1, 1, 1} * (far * scalar(0.6)), {});
}

/// Bodies that fly out of what numbers can say freeze: their joints tell so, work no more, and are not made anew.
TEST(JointIds, of_frozen_bodies) {
    for (const bool A_freezes : {true, false}) {
        StoreWorld world;
        const Vector far = {0, 0, ingot::limits::position_max};
        const ingot::BodyId lost = add_ball(world, far, {0, 0, ingot::limits::speed_max}), other = add_ball(world, {1, 0, 0});
        const ingot::BodyId post = add_ball(world, {2, 0, 0});
        const JointId joint = join(world, ingot::FixedJoint{}, A_freezes ? lost : other, A_freezes ? other : lost).value;
        const JointId by_post = join(world, ingot::HingeJoint{}, A_freezes ? lost : post, A_freezes ? post : lost).value;
        for (const JointId id : {joint, by_post}) ASSERT_EQ(world.set_joint_enabled(id, false), Status::ok);
        EXPECT_EQ(ingot::step(world, frame).bodies_frozen, 1);
        ASSERT_TRUE(world.is_frozen(lost));
        for (const JointId id : {joint, by_post})
            expect_refused(world, Status::frozen, [&](StoreWorld& w) { return w.set_joint_enabled(id, true); }, "set_joint_enabled");
        ingot::JointDef def;
        def.body_A = A_freezes ? lost : other;
        def.body_B = A_freezes ? other : lost;
        def.joint = ingot::BallJoint{};
        expect_refused(world, Status::frozen, [&](StoreWorld& w) { return w.add_joint(def).status; }, "add_joint");

        // One that works while what slides on it is driven beyond all that is a speed.
        StoreWorld working;
        const ingot::BodyId slid = add_ball(working, {});
        ingot::JointDef rail;
        (A_freezes ? rail.body_A : rail.body_B) = slid;
        rail.joint = ingot::SliderJoint{};
        const JointId held = working.add_joint(rail).value;
        const scalar F = working.mass(slid).value * ingot::limits::speed_runaway * 90;
        ASSERT_EQ(working.add_central_force(slid, {0, 0, F}), Status::ok);
        EXPECT_EQ(ingot::step(working, frame).bodies_frozen, 1);
        ASSERT_TRUE(working.is_frozen(slid));
        EXPECT_EQ(working.figure(held).status, Status::frozen);
    }
}

/// Both sides of a joint that is switched off have become kinematic: it does not work again, and so do no gears of such joints.
TEST(JointIds, of_kinematic_bodies) {
    Shelf shelf;
    StoreWorld& world = *shelf.world;
    const JointId hinge = shelf.at_kind(Kind::hinge), slider = shelf.at_kind(Kind::slider), ball = shelf.at_kind(Kind::ball);
    ASSERT_EQ(world.remove(shelf.at_kind(Kind::gear)), Status::ok);
    const auto stop = [&](JointId id) {
        const ingot::JointPlace place = world.joint_place(id).value;
        ASSERT_EQ(world.set_kinematic(place.A), Status::ok);
        ASSERT_EQ(world.set_kinematic(place.B), Status::ok);
    };
    ASSERT_EQ(world.set_joint_enabled(ball, false), Status::ok);
    stop(hinge);
    const auto half = world.add_gear(hinge, slider, 2);  // of which one joint moves
    ASSERT_TRUE(half.ok());
    EXPECT_TRUE(world.figure(half.value).ok());
    ASSERT_EQ(world.remove(half.value), Status::ok);
    for (const JointId id : {slider, ball}) stop(id);
    EXPECT_EQ(world.figure(hinge).status, Status::immovable);
    expect_refused(world, Status::immovable, [&](StoreWorld& w) { return w.set_joint_enabled(ball, true); }, "set_joint_enabled");
    expect_refused(world, Status::immovable, [&](StoreWorld& w) { return w.add_gear(hinge, slider, 2).status; }, "add_gear");
}

/// Gears of joints that are switched off, or for which there is no slot; one in a slot that has become free; and what fits again.
TEST(JointIds, of_gears) {
    Shelf shelf;
    StoreWorld& world = *shelf.world;
    const JointId hinge = shelf.at_kind(Kind::hinge), slider = shelf.at_kind(Kind::slider), parallel = shelf.at_kind(Kind::parallel);
    const auto geared = [&](JointId A, JointId B) { return [=](StoreWorld& w) { return w.add_gear(A, B, 2).status; }; };
    for (const JointId off : {hinge, slider, parallel}) ASSERT_EQ(world.set_joint_enabled(off, false), Status::ok);
    ASSERT_EQ(world.set_joint_enabled(slider, true), Status::ok);
    expect_refused(world, Status::not_in_scene, geared(hinge, slider), "A is switched off");
    expect_refused(world, Status::not_in_scene, geared(slider, hinge), "B is switched off");
    ASSERT_EQ(world.set_joint_enabled(hinge, true), Status::ok);
    EXPECT_EQ(world.set_joint_enabled(parallel, true), Status::ok);  // its axes are still along each other
    while (world.joint_count() < Store::max_joints) ASSERT_TRUE(world.add_gear(hinge, slider, 2).ok());
    expect_refused(world, Status::no_room, geared(hinge, slider), "all slots are taken");
    const JointId removed = shelf.at_kind(Kind::fixed);
    ASSERT_EQ(world.remove(removed), Status::ok);
    const auto again = world.add_gear(hinge, slider, 2);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again.value.slot, removed.slot);
    EXPECT_FALSE(world.is_alive(removed));
    EXPECT_EQ(world.gear_ratio(again.value).value, scalar(2));
}

struct Few : ingot::Scene {
    static constexpr int max_bodies = 2, max_joints = 2;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint>;
};
/// The ids of a slot are not given out twice: after the last of them it stays empty.
TEST(JointIds, are_used_up) {
    ingot::World<Few> world;
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::solid_sphere(1000, scalar(0.1))).value;
    ingot::JointDef joint;
    joint.joint = ingot::BallJoint{};
    joint.body_B = world.add(def).value;
    for (int life = 0; life < 1000; ++life) ASSERT_EQ(world.remove(world.add_joint(joint).value), Status::ok);
    // 2^31 lives take too long: the counter is found by its value and moved on.
    unsigned char* const bytes = reinterpret_cast<unsigned char*>(&world);
    const uint32_t lived = 2000, nearly_used_up = std::numeric_limits<uint32_t>::max() - 3;
    int found = 0;
    for (size_t at = 0; at + sizeof lived <= sizeof world; at += sizeof lived) {
        if (std::memcmp(bytes + at, &lived, sizeof lived) != 0) continue;
        std::memcpy(bytes + at, &nearly_used_up, sizeof nearly_used_up);
        ++found;
    }
    ASSERT_EQ(found, 1);
    const JointId last = world.add_joint(joint).value;
    EXPECT_EQ(last.slot, 0);
    ASSERT_EQ(world.remove(last), Status::ok);
    EXPECT_EQ(world.add_joint(joint).value.slot, 1) << "slot 0 is used up";
    EXPECT_EQ(world.add_joint(joint).status, Status::no_room);
    EXPECT_FALSE(world.is_alive(last));
}

}  // namespace
