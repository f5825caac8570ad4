// SPDX-License-Identifier: MIT
// Figures that swing free in company: of what touches, of free bodies, of loops, on ground that moves; saved.
#include <gtest/gtest.h>

#include <memory>

#include "figures.h"
#include "joints/figure_scenes.h"
#include "reference/draws.h"

namespace {

using namespace figures;

/// Bodies touch.
struct Crowd : ingot::Scene {
    static constexpr int max_bodies = 60, max_joints = 60, max_manifolds = 300, max_pairs = 1000;
    static constexpr bool translates = true, sleeps = true, kinematic_bodies = true;
    using joints = AllJoints;
    using shapes = ingot::Shapes<ingot::Capsule, ingot::Box, ingot::HalfSpace>;
};
struct SwingingCrowd : Crowd {
    using figure_motion = ingot::EnergyMomentum<>;
};
/// Bodies touch nothing.
struct Flock : ingot::Scene {
    static constexpr int max_bodies = 60, max_joints = 60;
    static constexpr bool translates = true;
    using joints = AllJoints;
};
struct SwingingFlock : Flock {
    using figure_motion = ingot::EnergyMomentum<>;
};
struct Rings : Flock {
    static constexpr int max_loops = 1;
};
struct SwingingRings : Rings {
    using figure_motion = ingot::EnergyMomentum<>;
};

/// Boxes that spin, by themselves.
template <class World>
std::vector<ingot::BodyId> add_boxes(World& world, const ingot::Shape& shape, scalar z) {
    std::vector<ingot::BodyId> boxes;
    for (int i = 0; i < 3; ++i) {
        ingot::BodyDef box;
        box.mass = ingot::principal(ingot::solid_box(500, {scalar(0.2), scalar(0.3), scalar(0.1)})).value;
        box.shape = shape;
        box.state.r_CM = {static_cast<scalar>(20 + 3 * i), 0, z};
        box.state.L = {scalar(i), 2, -1};
        boxes.push_back(world.add(box).value);
    }
    return boxes;
}

TEST(FreeFigures, free_bodies_of_their_scene_fly_as_ever) {
    const auto plain = std::make_unique<ingot::World<Flock>>();
    const auto swinging = std::make_unique<ingot::World<SwingingFlock>>();
    const auto crowd = std::make_unique<ingot::World<Crowd>>();
    const auto swinging_crowd = std::make_unique<ingot::World<SwingingCrowd>>();
    const auto follow = [](auto& a, auto& b, bool touch) {
        const auto build = [&](auto& world) {
            EXPECT_TRUE(weigh(world));
            if (touch) {
                EXPECT_TRUE(add_ground(world));
            }
            RandomInput random(3);
            Built built;
            add_figure(world, random, {5, 0.3, 10, 2, true}, {0, 0, 20}, built);
            EXPECT_TRUE(built.sound);
            const ingot::Shape box = ingot::Box{{scalar(0.2), scalar(0.3), scalar(0.1)}};
            return add_boxes(world, touch ? box : ingot::Shape{}, scalar(0.5));
        };
        const auto of_a = build(a), of_b = build(b);
        for (int step_i = 0; step_i < 90; ++step_i) {
            (void)ingot::step(a, scalar(1) / 60);
            EXPECT_NE(ingot::step(b, scalar(1) / 60).figure_passes, 0);
            ASSERT_TRUE(are_same(a, b, of_a, of_b)) << step_i;
        }
    };
    follow(*plain, *swinging, false);
    follow(*crowd, *swinging_crowd, true);
}

/// A ragdoll that lies is moved by the substeps of its contacts, as if the scene named nothing else, while another swings as it does alone.
TEST(FreeFigures, what_touches_goes_by_the_substeps) {
    const auto plain = std::make_unique<ingot::World<Crowd>>();
    const auto both = std::make_unique<ingot::World<SwingingCrowd>>(), alone = std::make_unique<ingot::World<SwingingCrowd>>();
    const ingot::Matrix on_its_back = ingot::axis_angle({0, 1, 0}, scalar(1.5707963267948966));
    Built lying, beside, hanging, hanging_alone;
    ASSERT_TRUE(add_ground(*plain) && add_ground(*both));
    ASSERT_TRUE(weigh(*plain) && weigh(*both) && weigh(*alone));
    add_ragdoll(*plain, {0, 0, scalar(0.129)}, on_its_back, lying);
    add_ragdoll(*both, {0, 0, scalar(0.129)}, on_its_back, beside);
    RandomInput random(4), again(4);
    add_figure(*both, random, {7, 0.3, 100, 3, true}, {0, 0, 30}, hanging);
    add_figure(*alone, again, {7, 0.3, 100, 3, true}, {0, 0, 30}, hanging_alone);
    ASSERT_TRUE(lying.sound && beside.sound && hanging.sound && hanging_alone.sound);
    for (int step_i = 0; step_i < 60; ++step_i) {
        ASSERT_GT(ingot::step(*plain, scalar(1) / 60).contacts, 0);
        (void)ingot::step(*both, scalar(1) / 60);
        (void)ingot::step(*alone, scalar(1) / 60);
        ASSERT_TRUE(are_same(*plain, *both, lying.bodies, beside.bodies)) << step_i;
        ASSERT_TRUE(are_same(*alone, *both, hanging_alone.bodies, hanging.bodies)) << step_i;
    }
}

/// Chains of capsules that fly, fall on each other, lie and come apart again: the bars of a heap, whichever of the two schemes has them.
TEST(FreeFigures, chains_fall_and_lie) {
    const auto world = std::make_unique<ingot::World<SwingingCrowd>>();
    ASSERT_TRUE(add_ground(*world) && weigh(*world));
    RandomInput random(6);
    Built built;
    for (int chain_i = 0; chain_i < 6; ++chain_i) {
        const Eigen::Vector3d along = random.direction(), top(random.real(-0.3, 0.3), random.real(-0.3, 0.3), 3 + 2.5 * chain_i);
        for (int link_i = 0; link_i < 5; ++link_i) {
            ingot::BodyDef link;
            const double M = std::exp(random.real(0, std::log(30)));
            link.mass = ingot::principal(ingot::with_mass(ingot::solid_capsule(1, scalar(0.08), scalar(0.15)), static_cast<scalar>(M))).value;
            link.shape = ingot::Capsule{scalar(0.08), scalar(0.15)};
            link.friction = scalar(0.6);
            link.state.A = ingot_reference::to_matrix(ingot_figures::along(along));
            link.state.r_CM = to_vector(top - 0.5 * link_i * along);
            link.state.L = to_vector(random.direction() * (0.02 * M));
            built.bodies.push_back(world->add(link).value);
            if (link_i == 0) continue;
            ingot::JointDef joint;
            joint.body_A = built.bodies[built.bodies.size() - 2];
            joint.body_B = built.bodies.back();
            joint.joint = link_i == 2 ? ingot::Joint(ingot::UniversalJoint{}) : ingot::Joint(ingot::BallJoint{});
            joint.P = to_vector(top - (0.5 * link_i - 0.25) * along);
            const Eigen::Vector3d across = along.cross(random.direction()).normalized();
            joint.axis = to_vector(across);
            joint.axis_B = to_vector(along.cross(across));
            built.joints.push_back(world->add_joint(joint).value);
        }
    }
    double before = energy_of(*world, built), most = 0, gap = 0;
    int swung = 0, touched = 0;
    for (int step_i = 0; step_i < 180; ++step_i) {
        const ingot::StepReport report = ingot::step(*world, scalar(1) / 60);
        ASSERT_EQ(report.bodies_frozen, 0);
        swung += report.figure_passes != 0;
        touched += report.contacts != 0;
        const double now = energy_of(*world, built);
        most = std::max(most, now - before);
        before = now;
        gap = std::max(gap, worst_gap(*world, built));
    }
    std::printf("    swung in %d steps, touched in %d, gap %.1e m, most gained in a step %.1e J\n", swung, touched, gap, most);
    EXPECT_GT(swung, 60);
    EXPECT_GT(touched, 100);
    EXPECT_LE(gap, 5e-5);
    EXPECT_LE(most, 1);
}

/// A figure that closes a loop goes by the substeps, as if the scene named nothing else, and the step says so.
TEST(FreeFigures, loops_are_left_to_the_substeps) {
    const auto plain = std::make_unique<ingot::World<Rings>>();
    const auto swinging = std::make_unique<ingot::World<SwingingRings>>();
    const auto build = [](auto& world, bool closes) {
        EXPECT_TRUE(weigh(world));
        Built built;
        for (int i = 0; i < 4; ++i) {
            const scalar x = i % 2 == 0 ? scalar(0) : scalar(0.5), z = i < 2 ? scalar(0.5) : scalar(0);
            ingot::BodyDef def;
            def.mass = ingot::principal(ingot::solid_box(500, {scalar(0.2), scalar(0.1), scalar(0.1)})).value;
            def.state.r_CM = {x, 0, z};
            built.bodies.push_back(world.add(def).value);
        }
        constexpr int ring[] = {0, 1, 3, 2};
        for (int i = 0; i < (closes ? 4 : 3); ++i) {
            ingot::JointDef joint;
            joint.body_A = built.bodies[static_cast<size_t>(ring[i])];
            joint.body_B = built.bodies[static_cast<size_t>(ring[(i + 1) % 4])];
            joint.joint = ingot::HingeJoint{};
            joint.axis = {0, 1, 0};
            joint.P = (world.state(joint.body_A).value.r_CM + world.state(joint.body_B).value.r_CM) * scalar(0.5);
            built.joints.push_back(world.add_joint(joint).value);
        }
        EXPECT_EQ(world.apply_angular_impulse(built.bodies[1], {0, 3, 0}), ingot::Status::ok);
        return built;
    };
    const Built of_plain = build(*plain, true), of_swinging = build(*swinging, true);
    for (int step_i = 0; step_i < 60; ++step_i) {
        (void)ingot::step(*plain, scalar(1) / 60);
        EXPECT_EQ(ingot::step(*swinging, scalar(1) / 60).figures, ingot::FigureBits::left_to_substeps);
        ASSERT_TRUE(are_same(*plain, *swinging, of_plain.bodies, of_swinging.bodies));
    }
    ASSERT_EQ(swinging->remove(of_swinging.joints[3]), ingot::Status::ok);
    EXPECT_EQ(ingot::step(*swinging, scalar(1) / 60).figures & ingot::FigureBits::left_to_substeps, 0);
}

/// Hung from a platform that goes and turns: order 2 against many more steps.
TEST(FreeFigures, hang_from_ground_that_moves) {
    const auto end_of = [](int rate) {
        const auto world = std::make_unique<ingot::World<SwingingCrowd>>();
        EXPECT_TRUE(weigh(*world));
        ingot::BodyDef platform;
        platform.immovable = true;
        platform.shape = ingot::Box{{scalar(0.2), scalar(0.2), scalar(0.1)}};
        platform.state.r_CM = {0, 0, 5};
        const ingot::BodyId base = world->add(platform).value;
        EXPECT_EQ(world->set_kinematic(base), ingot::Status::ok);
        Built built;
        ingot::BodyId last = base;
        for (int i = 0; i < 3; ++i) {
            ingot::BodyDef link;
            link.mass = ingot::principal(ingot::solid_capsule(500, scalar(0.05), scalar(0.2))).value;
            link.shape = ingot::Capsule{scalar(0.05), scalar(0.2)};
            link.state.r_CM = {scalar(0.4), 0, scalar(4.5) - scalar(0.6) * static_cast<scalar>(i)};
            built.bodies.push_back(world->add(link).value);
            ingot::JointDef joint;
            joint.body_A = last;
            joint.body_B = last = built.bodies.back();
            joint.joint = i == 1 ? ingot::Joint(ingot::HingeJoint{}) : ingot::Joint(ingot::BallJoint{});
            joint.axis = {1, 0, 0};
            joint.P = link.state.r_CM + Vector{0, 0, scalar(0.3)};
            built.joints.push_back(world->add_joint(joint).value);
        }
        EXPECT_EQ(world->set_velocity(base, {scalar(0.5), 0, 0}, {0, 0, 2}), ingot::Status::ok);
        for (int step_i = 0; step_i < rate; ++step_i) {
            const ingot::StepReport report = ingot::step(*world, scalar(1) / static_cast<scalar>(rate));
            EXPECT_NE(report.figure_passes, 0);
            EXPECT_EQ(report.figures & ingot::FigureBits::unsolved, 0);
            EXPECT_LE(worst_gap(*world, built), 64 * eps);
        }
        return ingot_reference::to_eigen(world->state(last).value.r_CM);
    };
    const Eigen::Vector3d exact = end_of(1920), coarse = end_of(30), fine = end_of(60);
    const double slope = std::log2((coarse - exact).norm() / (fine - exact).norm());
    std::printf("    30 Hz %.2e m, 60 Hz %.2e m, slope %.2f\n", (coarse - exact).norm(), (fine - exact).norm(), slope);
    EXPECT_NEAR(slope, 2, 0.2);
}

/// Saved in mid-air, and among contacts, they go on to the same bits.
TEST(FreeFigures, go_on_from_a_snapshot) {
    const auto world = std::make_unique<ingot::World<SwingingCrowd>>(), other = std::make_unique<ingot::World<SwingingCrowd>>();
    ASSERT_TRUE(add_ground(*world) && weigh(*world));
    Built built;
    RandomInput random(8);
    add_figure(*world, random, {9, 0.3, 100, 4, true}, {0, 0, 30}, built);
    add_figure(*world, random, {6, 0.3, 100, 4, false}, {0, 20, 30}, built);
    add_ragdoll(*world, {20, 0, scalar(0.2)}, ingot::axis_angle({0, 1, 0}, 1), built);
    ASSERT_TRUE(built.sound);
    for (int step_i = 0; step_i < 40; ++step_i) (void)ingot::step(*world, scalar(1) / 60);
    std::vector<uint8_t> bytes(ingot::snapshot_size<SwingingCrowd>());
    const auto size = ingot::save_snapshot(*world, bytes.data(), bytes.size());
    ASSERT_TRUE(size.ok());
    ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), size.value), ingot::Status::ok);
    for (int step_i = 0; step_i < 40; ++step_i) {
        (void)ingot::step(*world, scalar(1) / 60);
        (void)ingot::step(*other, scalar(1) / 60);
        ASSERT_EQ(world->state_hash(), other->state_hash()) << step_i;
    }
}

}  // namespace
