// SPDX-License-Identifier: MIT
// Figures in company: each moves as if it were alone, to the bit, whatever else the world has, in whatever order bodies and joints came in.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "random_trees.h"
#include "reference/draws.h"
#include "scene_in_world.h"

namespace {

using namespace figures;
using namespace ingot_figures;

struct Party : ingot::Scene {
    static constexpr int max_bodies = 64, max_joints = 80, max_manifolds = 240, max_pairs = 600;
    static constexpr bool translates = true;
    using joints = AllJoints;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
struct Limited : Party {
    using joints = AllJointsWith<ingot::WithLimits>;
};
struct Driven : Party {
    using joints = AllJointsWith<ingot::WithLimits, ingot::WithDrives>;
};
struct Looped : Party {
    static constexpr int max_loops = 8;
};
struct Tied : Party {
    static constexpr int max_loops = 16;
    using joints = AllJointsWith<ingot::RodJoint, ingot::RopeJoint>;
};
struct Machined : Looped {
    using joints = AllJointsWith<ingot::WithLimits, ingot::WithDrives>;
};
struct Roped : Tied {
    using joints = AllJointsWith<ingot::RodJoint, ingot::RopeJoint, ingot::WithLimits, ingot::WithDrives>;
};
/// Each guest on a turntable of its own.
struct DrivenRound : Driven {
    static constexpr bool kinematic_bodies = true;
};
struct MachinedRound : Machined {
    static constexpr bool kinematic_bodies = true;
};
struct Swinging : Party {
    using figure_motion = ingot::EnergyMomentum<>;
};
struct Sleepy : Limited {
    static constexpr bool sleeps = true;
};

struct Guest {
    FigureScene scene;
    double torque;  ///< N m, the most of its drives
    Vector3d spin;  ///< rad/s, of what it falls on, where that turns
    std::vector<ingot::BodyId> bodies;
    std::vector<ingot::JointId> joints;
};

/// A tree that falls, beside boxes that it falls on; with limits, loops or ties where the scene has them.
template <class Scene>
Guest drawn_guest(RandomInput& random) {
    FigureScene scene;
    const bool closes = Scene::max_loops > 0 && !Scene::joints::has_ties && random.integer(0, 1) == 1;
    if constexpr (Scene::joints::has_limits)
        scene = closes ? limited_ring(random, 8, false, 6) : limited_tree(random, 8, false, 6);
    else
        scene = closes ? ring_and_tree(random) : plain_tree(random);
    double z = 0;
    for (FigureBody& body : scene.bodies) {
        body.half_extent *= 0.3;
        body.restitution = random.integer(0, 1) * 0.4;
        z = std::max(z, random.real(0.01, 0.5) + body.half_extent.norm() - body.r_CM.z());
    }
    for (FigureBody& body : scene.bodies) body.r_CM.z() += z;
    for (FigureJoint& joint : scene.joints) joint.anchor.z() += z;
    const int figure_bodies = scene.body_count();
    for (int i = random.integer(0, 2); i > 0; --i) {
        const Vector3d half(random.real(0.1, 0.3), random.real(0.1, 0.3), 0.1);
        scene.add(box(random.real(1, 50), half, {random.real(-0.5, 0.5), random.real(-0.5, 0.5), 0.1 + 0.2 * i}));
    }
    if constexpr (Scene::joints::has_ties)
        for (int i = random.integer(0, 2); i > 0; --i) {
            FigureJoint tie;
            tie.kind = FigureJointKind::distance;
            tie.body_A = random.integer(0, figure_bodies - 1);
            tie.body_B = (tie.body_A + random.integer(1, scene.body_count() - 1)) % scene.body_count();
            if (tie.body_B == tie.body_A) continue;
            tie.anchor = scene.body(tie.body_A).r_CM;
            tie.anchor_B = scene.body(tie.body_B).r_CM;
            tie.most = (tie.anchor - tie.anchor_B).norm() * (1 + random.integer(0, 1) * random.real(0, 0.5));
            if (tie.most < 0.05) continue;
            if (random.integer(0, 1) == 1) tie.least = tie.most;
            scene.join(tie);
        }
    return {scene, random.real(0.5, 200), {random.real(-0.1, 0.1), 0, random.real(-3, 3)}, {}, {}};
}

/// Guests 30 m apart, whose bodies and joints come in at random turns.
template <class Scene>
class Gathering {
public:
    Gathering(std::vector<Guest> guests, const std::vector<int>& places, uint64_t seed) : guests_(std::move(guests)), random_(seed) {
        sound = add_ground(*world_) && weigh(*world_);
        for (std::size_t i = 0; i < guests_.size(); ++i)
            for (FigureBody& body : guests_[i].scene.bodies) body.r_CM.x() += 30.0 * places[i];
        if constexpr (Scene::kinematic_bodies)
            for (std::size_t i = 0; i < guests_.size(); ++i) add_turntable(guests_[i], 30.0 * places[i]);
        in_turns([](const Guest& guest) { return guest.bodies.size() < guest.scene.bodies.size(); }, [&](Guest& guest) {
            const auto id = world_->add(definition_of<Scene>(guest.scene.bodies[guest.bodies.size()]));
            sound = sound && id.ok();
            guest.bodies.push_back(id.value);
        });
        in_turns([](const Guest& guest) { return guest.joints.size() < guest.scene.joints.size(); }, [&](Guest& guest) {
            FigureJoint joint = guest.scene.joints[guest.joints.size()];
            const double x = 30.0 * places[static_cast<std::size_t>(&guest - guests_.data())];
            joint.anchor.x() += x;
            joint.anchor_B.x() += x;
            guest.joints.push_back(join(guest, joint));
        });
    }

    void step(scalar h) { (void)ingot::step(*world_, h); }
    const Guest& guest(std::size_t i) const { return guests_[i]; }
    const ingot::World<Scene>& world() const { return *world_; }
    bool sound;

private:
    template <class Waits, class Act>
    void in_turns(const Waits& waits, const Act& act) {
        for (bool some = true; some;) {
            some = false;
            for (const Guest& guest : guests_) some = some || waits(guest);
            Guest& guest = guests_[static_cast<std::size_t>(random_.integer(0, static_cast<int>(guests_.size()) - 1))];
            if (some && waits(guest)) act(guest);
        }
    }
    /// Flush with the ground, which it comes out of as it tilts.
    void add_turntable(const Guest& guest, double x) {
        ingot::BodyDef table;
        table.kinematic = true;
        table.shape = ingot::Box{{3, 3, 1}};
        table.friction = scalar(0.6);
        table.state.r_CM = {static_cast<scalar>(x), 0, -1};
        const auto id = world_->add(table);
        sound = sound && id.ok() && world_->set_velocity(id.value, {}, ingot_reference::to_vector(guest.spin)) == ingot::Status::ok;
    }
    ingot::JointId join(const Guest& guest, const FigureJoint& joint) {
        const auto body_of = [&](int body_i) { return body_i == the_world ? ingot::BodyId{} : guest.bodies[static_cast<std::size_t>(body_i)]; };
        const auto id = world_->add_joint(joint_def(joint, body_of));
        sound = sound && id.ok();
        if constexpr (Scene::joints::has_drives) {
            const ingot::JointDrive drive = ingot::SpringDrive{200, 5, scalar(0.5), 0, 0, static_cast<scalar>(guest.torque)};
            if (world_->set_joint_drive(id.value, drive) != ingot::Status::ok) (void)world_->set_ball_drive(id.value, drive);
        }
        return id.value;
    }

    std::unique_ptr<ingot::World<Scene>> world_ = std::make_unique<ingot::World<Scene>>();
    std::vector<Guest> guests_;
    RandomInput random_;
};

template <class Scene>
class FiguresInCompany : public testing::Test {};
using Scenes = testing::Types<Party, Limited, Driven, DrivenRound, Looped, Machined, MachinedRound, Tied, Roped, Swinging, Sleepy>;
TYPED_TEST_SUITE(FiguresInCompany, Scenes);

/// Steps four guests together, and each alone.
template <class Scene>
void expect_the_same_alone(const std::vector<Guest>& guests, double rate, int steps_max, int case_i) {
    Gathering<Scene> together(guests, {0, 1, 2, 3}, static_cast<uint64_t>(case_i));
    std::vector<std::unique_ptr<Gathering<Scene>>> alone;
    for (int i = 0; i < 4; ++i)
        alone.push_back(std::make_unique<Gathering<Scene>>(std::vector<Guest>{guests[static_cast<std::size_t>(i)]}, std::vector<int>{i}, 1));
    ASSERT_TRUE(together.sound);
    for (int step_i = 0; step_i < std::min(steps_max, static_cast<int>(2 * rate)); ++step_i) {
        together.step(static_cast<scalar>(1 / rate));
        for (std::size_t i = 0; i < 4; ++i) {
            alone[i]->step(static_cast<scalar>(1 / rate));
            ASSERT_TRUE(are_same(together.world(), alone[i]->world(), together.guest(i).bodies, alone[i]->guest(0).bodies))
                << "case " << case_i << ", guest " << i << ", " << rate << " Hz, step " << step_i;
        }
    }
}

TYPED_TEST(FiguresInCompany, move_as_if_alone) {
    RandomInput random(21);
    // Ropes beside drives are solved again and again: a few are as long as all the others.
    constexpr int cases = TypeParam::joints::has_ties && TypeParam::joints::has_drives ? 4 : 24;
    for (int case_i = 0; case_i < ingot_reference::draws(cases); ++case_i) {
        std::vector<Guest> guests;
        for (int i = 0; i < 4; ++i) guests.push_back(drawn_guest<TypeParam>(random));
        const double rate = rates[random.integer(0, 4)];
        ASSERT_NO_FATAL_FAILURE(expect_the_same_alone<TypeParam>(guests, rate, 200, case_i));
    }
}

/// A row of figures, each of two boxes on a ball, that lie on the ground and press each other: one island, in which the ground bears up to seven at
/// once. What these change in a sweep is summed in an order that no neighbour may alter.
Guest lying_row(RandomInput& random) {
    FigureScene scene;
    double x = -1;
    for (int i = random.integer(5, 7); i > 0; --i) {
        const Vector3d half(random.real(0.05, 0.15), random.real(0.1, 0.2), random.real(0.05, 0.1));
        for (const double side : {-1.0, 1.0}) {
            FigureBody part = box(random.real(0.5, 20), half, {x + half.x(), side * (half.y() + 0.01), half.z()});
            part.friction = random.real(0, 1);
            part.v_CM = {random.real(-1, 1), random.real(-1, 1), 0};
            scene.add(part);
        }
        FigureJoint joint;
        joint.body_A = scene.body_count() - 2;
        joint.body_B = scene.body_count() - 1;
        joint.anchor = {x + half.x(), 0, half.z()};
        scene.join(joint);
        x += 2 * half.x() - 0.001;
    }
    return {scene, random.real(0.5, 20), {0, 0, random.real(-3, 3)}, {}, {}};
}

TYPED_TEST(FiguresInCompany, of_many_that_touch_move_as_if_alone) {
    RandomInput random(22);
    for (int case_i = 0; case_i < ingot_reference::draws(8); ++case_i) {
        std::vector<Guest> guests;
        for (int i = 0; i < 4; ++i) guests.push_back(lying_row(random));
        const double rate = rates[random.integer(0, 4)];
        ASSERT_NO_FATAL_FAILURE(expect_the_same_alone<TypeParam>(guests, rate, 40, case_i));
    }
}

}  // namespace
