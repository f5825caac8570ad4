// SPDX-License-Identifier: MIT
// Calls about joints: what is refused changes no bit.
#include <gtest/gtest.h>
#include <ingot/joint/check_joint.h>

#include <cstring>
#include <limits>
#include <memory>
#include <type_traits>

#include "figures.h"

namespace {

using namespace figures;
using ingot::Status;

struct Hinged : ingot::Scene {
    static constexpr int max_bodies = 4, max_joints = 3;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::UniversalJoint>;
};
using HingedWorld = ingot::World<Hinged>;

struct Setting {
    std::unique_ptr<HingedWorld> world = std::make_unique<HingedWorld>();
    ingot::BodyId post, A, B;

    Setting() {
        ingot::BodyDef def;
        def.mass = ingot::principal(ingot::solid_box(1000, {scalar(0.5), scalar(0.5), scalar(0.5)})).value;
        A = world->add(def).value;
        def.state.r_CM = {2, 0, 0};
        B = world->add(def).value;
        def.immovable = true;
        def.state.r_CM = {0, 5, 0};
        post = world->add(def).value;
    }
    ingot::JointDef hinge() const {
        ingot::JointDef def;
        def.body_A = A;
        def.body_B = B;
        def.joint = ingot::HingeJoint{};
        def.P = {1, 0, 0};
        return def;
    }
    /// The call is refused so, and the world is what it was.
    void expect_refused(const ingot::JointDef& def, Status status) {
        std::vector<unsigned char> before(sizeof *world);
        std::memcpy(before.data(), world.get(), sizeof *world);
        const auto id = world->add_joint(def);
        EXPECT_EQ(id.status, status) << ingot::name(id.status);
        EXPECT_EQ(std::memcmp(before.data(), world.get(), sizeof *world), 0) << ingot::name(status);
    }
};

TEST(JointCalls, bad_definitions_are_refused) {
    Setting setting;
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN(), infinity = std::numeric_limits<scalar>::infinity();
    const auto refused = [&](Status status, const auto& change) {
        ingot::JointDef def = setting.hinge();
        change(def);
        setting.expect_refused(def, status);
    };
    refused(Status::bad_joint, [&](ingot::JointDef& def) { def.body_B = def.body_A; });
    refused(Status::bad_joint, [&](ingot::JointDef& def) { def.body_A = def.body_B = {}; });
    refused(Status::stale_id, [&](ingot::JointDef& def) { def.body_A.generation += 2; });
    refused(Status::stale_id, [&](ingot::JointDef& def) { def.body_B.slot = 3, def.body_B.generation = 1; });
    refused(Status::foreign_id, [&](ingot::JointDef& def) { def.body_A.world_tag = 7; });
    refused(Status::not_finite, [&](ingot::JointDef& def) { def.P.x = nan; });
    refused(Status::not_finite, [&](ingot::JointDef& def) { def.P.y = infinity; });
    refused(Status::out_of_range, [&](ingot::JointDef& def) { def.P.z = 2 * ingot::limits::position_max; });
    refused(Status::bad_direction, [&](ingot::JointDef& def) { def.axis = {}; });
    refused(Status::bad_direction, [&](ingot::JointDef& def) { def.axis = {1, 1, 0}; });
    refused(Status::not_finite, [&](ingot::JointDef& def) { def.axis.x = nan; });
    refused(Status::not_in_scene, [&](ingot::JointDef& def) { def.joint = ingot::SliderJoint{}; });
    refused(Status::not_in_scene, [&](ingot::JointDef& def) { def.joint = {}; });
    refused(Status::bad_joint, [&](ingot::JointDef& def) { def.joint = ingot::UniversalJoint{}, def.axis_B = def.axis; });
    refused(Status::bad_direction, [&](ingot::JointDef& def) { def.joint = ingot::UniversalJoint{}, def.axis_B = {0, 2, 0}; });
    refused(Status::immovable, [&](ingot::JointDef& def) { def.body_A = {}, def.body_B = setting.post; });
}

TEST(JointCalls, more_than_there_is_room_for_are_refused) {
    Setting setting;
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::solid_box(1000, {scalar(0.5), scalar(0.5), scalar(0.5)})).value;
    ingot::JointDef joint = setting.hinge();
    joint.body_B = setting.world->add(def).value;
    EXPECT_TRUE(setting.world->add_joint(joint).ok());
    EXPECT_TRUE(setting.world->add_joint(setting.hinge()).ok());
    joint = setting.hinge();
    joint.body_A = setting.post;
    EXPECT_TRUE(setting.world->add_joint(joint).ok());
    setting.expect_refused(joint, Status::no_room);
}

/// What closes a loop needs room for it; what is refused leaves nothing behind but what is worked in. Bodies of a ring go their ways once it is cut.
template <int loops>
struct Ringed : ingot::Scene {
    static constexpr int max_bodies = 8, max_joints = 12, max_loops = loops;
    static constexpr bool translates = true;
    using without = ingot::Joints<ingot::BallJoint, ingot::FixedJoint>;
    using joints = std::conditional_t<loops == 0, ingot::Joints<ingot::BallJoint, ingot::FixedJoint, ingot::WithLimits>, without>;
};
template <int loops>
struct Ring {
    std::unique_ptr<ingot::World<Ringed<loops>>> world = std::make_unique<ingot::World<Ringed<loops>>>();
    ingot::BodyId bodies[4];

    Ring() {
        ingot::BodyDef def;
        def.mass = ingot::principal(ingot::solid_box(1000, {scalar(0.5), scalar(0.5), scalar(0.5)})).value;
        for (int i = 0; i < 4; ++i) {
            def.state.r_CM = {static_cast<scalar>(i % 2), static_cast<scalar>(i / 2), 0};
            bodies[i] = world->add(def).value;
        }
    }
    ingot::Result<ingot::JointId> join(int A, int B, const ingot::Joint& kind = ingot::BallJoint{}) {
        ingot::JointDef def;
        if (A >= 0) def.body_A = bodies[A];
        def.body_B = bodies[B];
        def.joint = kind;
        def.P = world->state(def.body_B).value.r_CM;
        return world->add_joint(def);
    }
    std::vector<uint8_t> saved() const {
        std::vector<uint8_t> bytes(ingot::snapshot_size<Ringed<loops>>());
        bytes.resize(ingot::save_snapshot(*world, bytes.data(), bytes.size()).value);
        return bytes;
    }
    void expect_refused(int A, int B, const ingot::Joint& kind = ingot::BallJoint{}) {
        const auto before = saved();
        EXPECT_EQ(join(A, B, kind).status, Status::no_room);
        EXPECT_EQ(saved(), before);
    }
};

TEST(JointCalls, loops_need_room) {
    Ring<0> none;
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(none.join(i, i + 1).ok());
    none.expect_refused(3, 0);
    none.expect_refused(0, 2);
    const auto tied = none.join(-1, 1);  // is no loop
    ASSERT_TRUE(tied.ok());
    EXPECT_EQ(none.world->remove(tied.value), Status::ok);
    none.expect_refused(0, 2, ingot::BallJoint{1});  // in the slot that has become free
    EXPECT_TRUE(none.join(-1, 1).ok());
    none.expect_refused(-1, 3);

    Ring<1> one;
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(one.join(i, (i + 1) % 4).ok());
    one.expect_refused(0, 2);
    EXPECT_TRUE(ingot::step(*one.world, scalar(1) / 60).clean());

    Ring<8> rows;  // enough loops, and a figure with as many rows as one may have
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(rows.join(i, i + 1).ok());
    for (int row = 0; row + 6 <= ingot::limits::loop_rows_max; row += 6) EXPECT_TRUE(rows.join(0, 3, ingot::FixedJoint{}).ok());
    rows.expect_refused(0, 2);
    EXPECT_TRUE(ingot::step(*rows.world, scalar(1) / 60).clean());
}

TEST(JointCalls, a_ring_that_is_cut_is_a_chain) {
    Ring<1> ring;
    std::vector<ingot::JointId> joints;
    for (int i = 0; i < 4; ++i) joints.push_back(ring.join(i, (i + 1) % 4).value);
    EXPECT_TRUE(ingot::step(*ring.world, scalar(1) / 60).clean());
    EXPECT_EQ(ring.world->remove(joints[1]), Status::ok);
    EXPECT_TRUE(ingot::step(*ring.world, scalar(1) / 60).clean());
    EXPECT_TRUE(ring.join(3, 1).ok());
    ring.expect_refused(1, 2);
    EXPECT_EQ(ring.world->remove(ring.bodies[0]), Status::ok);
    EXPECT_EQ(ring.world->joint_count(), 2);
    EXPECT_TRUE(ingot::step(*ring.world, scalar(1) / 60).clean());
}

/// A ring saved on its way goes on to the same bits.
TEST(JointCalls, a_ring_goes_on_from_a_snapshot) {
    Ring<1> ring, other;
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(ring.join(i, (i + 1) % 4).ok());
    EXPECT_EQ(ring.world->apply_angular_impulse(ring.bodies[2], {300, 200, 100}), Status::ok);
    for (int step_i = 0; step_i < 20; ++step_i) EXPECT_TRUE(ingot::step(*ring.world, scalar(1) / 60).clean());
    const auto bytes = ring.saved();
    ASSERT_EQ(ingot::load_snapshot(*other.world, bytes.data(), bytes.size()), Status::ok);
    for (int step_i = 0; step_i < 20; ++step_i) {
        (void)ingot::step(*ring.world, scalar(1) / 60);
        (void)ingot::step(*other.world, scalar(1) / 60);
    }
    EXPECT_EQ(ring.world->state_hash(), other.world->state_hash());
}

TEST(JointCalls, ids_outlive_joints) {
    Setting setting;
    HingedWorld& world = *setting.world;
    const ingot::JointId first = world.add_joint(setting.hinge()).value;
    EXPECT_TRUE(world.is_alive(first));
    EXPECT_EQ(world.remove(first), Status::ok);
    EXPECT_FALSE(world.is_alive(first));
    EXPECT_EQ(world.remove(first), Status::stale_id);
    EXPECT_EQ(world.joint_gap(first).status, Status::stale_id);
    const ingot::JointId second = world.add_joint(setting.hinge()).value;
    EXPECT_EQ(second.slot, first.slot);
    EXPECT_NE(second, first);
    EXPECT_EQ(world.joint_count(), 1);
}

/// A body takes its joints along, and the other end of each goes on by itself.
TEST(JointCalls, a_body_takes_its_joints_along) {
    Setting setting;
    HingedWorld& world = *setting.world;
    const ingot::JointId between = world.add_joint(setting.hinge()).value;
    ingot::JointDef to_post = setting.hinge();
    to_post.body_A = setting.post;
    to_post.body_B = setting.A;
    const ingot::JointId other = world.add_joint(to_post).value;
    ASSERT_EQ(world.remove(setting.B), Status::ok);
    EXPECT_FALSE(world.is_alive(between));
    EXPECT_TRUE(world.is_alive(other));
    for (int step_i = 0; step_i < 10; ++step_i) EXPECT_TRUE(ingot::step(world, scalar(1) / 60).clean());
}

/// The world, an immovable body and a body with the mass of a moon hold alike.
TEST(JointCalls, what_cannot_move_holds) {
    Setting setting;
    HingedWorld& world = *setting.world;
    ASSERT_EQ(world.set_gravity({0, 0, -10}), Status::ok);
    ingot::JointDef def = setting.hinge();
    def.body_A = {};
    ASSERT_TRUE(world.add_joint(def).ok());
    def = setting.hinge();
    def.body_A = setting.post;
    def.body_B = setting.A;
    def.P = {0, 1, 0};
    def.axis = {1, 0, 0};
    ASSERT_TRUE(world.add_joint(def).ok());
    for (int step_i = 0; step_i < 120; ++step_i) ASSERT_TRUE(ingot::step(world, scalar(1) / 60).clean());
    const double of_B = ingot_reference::to_eigen(world.state(setting.B).value.r_CM - ingot::Vector{1, 0, 0}).norm();
    const double of_A = ingot_reference::to_eigen(world.state(setting.A).value.r_CM - ingot::Vector{0, 1, 0}).norm();
    EXPECT_NEAR(of_B, 1, 5e-5);
    EXPECT_NEAR(of_A, 1, 5e-5);
}

/// What a snapshot says that a joint is made of: both sides have two unit vectors at right angles, and a place.
TEST(JointCalls, frames_of_records_are_square_and_of_unit_length) {
    RandomInput random(24);
    for (int run_i = 0; run_i < 200; ++run_i) {
        ingot::JointRecord joint{};
        joint.kind = ingot::JointKind::hinge;
        joint.body_A = ingot::no_body;
        ingot::JointFrame* const frames[2] = {&joint.frame_A, &joint.frame_B};
        for (ingot::JointFrame* frame : frames) {
            const Eigen::Matrix3d A = random.rotation();
            *frame = {ingot_reference::to_vector(random.vector(9)), ingot_reference::to_vector(A.col(0)), ingot_reference::to_vector(A.col(1))};
        }
        ASSERT_TRUE(ingot::is_valid(joint, 1)) << run_i;
        ingot::JointFrame& bad = *frames[random.integer(0, 1)];
        const auto factor = static_cast<scalar>(random.integer(0, 1) == 0 ? random.real(0.01, 0.999) : random.real(1.001, 100));
        switch (run_i % 4) {
            case 0: bad.axis = bad.axis * factor; break;
            case 1: bad.side = bad.side * factor; break;
            case 2: {
                const auto lean = static_cast<scalar>((random.integer(0, 1) == 0 ? 1 : -1) * random.real(0.001, 0.9));
                bad.side = bad.axis * lean + bad.side * ingot::sqrt(1 - lean * lean);
                break;
            }
            default: bad.anchor.y = 4 * ingot::limits::position_max; break;
        }
        EXPECT_FALSE(ingot::is_valid(joint, 1)) << run_i;
    }
}

}  // namespace
