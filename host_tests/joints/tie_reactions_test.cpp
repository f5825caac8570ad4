// SPDX-License-Identifier: MIT
// What rods, ropes, targets, parallel joints and gears bear, and that they break: by the momenta of their bodies.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using Eigen::Vector3d;
using ingot::Status;
using ingot_reference::to_eigen;

struct Tearing : ingot::Scene {
    static constexpr int max_bodies = 16, max_joints = 24, max_loops = 24;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::RodJoint, ingot::RopeJoint, ingot::ParallelJoint, ingot::TargetJoint,
                                 ingot::ServoJoint, ingot::GearJoint, ingot::WithDrives, ingot::WithBreaking>;
};
struct TearingInTouch : Tearing {
    static constexpr int max_manifolds = 40, max_pairs = 100;
    static constexpr bool sleeps = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
};

template <class World>
ingot::BodyId add_ball(World& world, double M, const Vector3d& place, const Vector3d& v = Vector3d::Zero()) {
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::with_mass(ingot::solid_sphere(1, scalar(0.1)), static_cast<scalar>(M))).value;
    if constexpr (World::scene::max_manifolds > 0) def.shape = ingot::Sphere{scalar(0.1)};
    def.state.r_CM = to_vector(place);
    def.state.v_CM = to_vector(v);
    return world.add(def).value;
}
template <class World>
ingot::JointId join(World& world, const ingot::Joint& kind, ingot::BodyId A, ingot::BodyId B, const Vector3d& P = Vector3d::Zero(),
                    const Vector3d& axis = {0, 0, 1}) {
    ingot::JointDef def;
    def.body_A = A;
    def.body_B = B;
    def.joint = kind;
    def.P = A == ingot::BodyId{} ? to_vector(P) : world.state(A).value.r_CM;
    def.P_B = world.state(B).value.r_CM;
    def.axis = to_vector(axis);
    const auto id = world.add_joint(def);
    EXPECT_TRUE(id.ok());
    return id.value;
}
Vector3d force_of(const ingot::World<Tearing>& world, ingot::JointId id) { return to_eigen(world.joint_reaction(id).value.force); }
Vector3d torque_of(const ingot::World<Tearing>& world, ingot::JointId id) { return to_eigen(world.joint_reaction(id).value.torque); }

/// Balls on rods and ropes from middle to middle, some hung on the world, and one drawn to a target: what each gets of all its ties is what its
/// momentum changes by, beside its weight. Ropes pull.
TEST(TieReactions, are_what_momenta_change_by) {
    RandomInput random(1);
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i) {
        const auto world = std::make_unique<ingot::World<Tearing>>();
        ASSERT_TRUE(weigh(*world));
        const double rate = rates[random.integer(0, 4)], h = 1 / rate;
        struct Tie {
            ingot::JointId id;
            int A, B;  // -1: the world
            bool is_rope;
        };
        std::vector<ingot::BodyId> balls;
        std::vector<Tie> ties;
        for (int i = random.integer(1, 8); i >= 0; --i) {
            const int B = static_cast<int>(balls.size()), A = B == 0 ? -1 : random.integer(-1, B - 1);
            const Vector3d from = A < 0 ? Vector3d(random.vector(2)) : to_eigen(world->state(balls[static_cast<size_t>(A)]).value.r_CM);
            balls.push_back(add_ball(*world, random.real(0.5, 20), from + random.direction(), random.vector(2)));
            const bool is_rope = random.integer(0, 1) == 1;
            ingot::Joint kind = ingot::RodJoint{};
            if (is_rope) kind = ingot::RopeJoint{static_cast<scalar>(random.real(1, 1.3))};
            ties.push_back({join(*world, kind, A < 0 ? ingot::BodyId{} : balls[static_cast<size_t>(A)], balls.back(), from), A, B, is_rope});
        }
        if (random.integer(0, 1) == 1) {
            ingot::JointDef def;
            def.body_B = balls.back();
            def.P = world->state(def.body_B).value.r_CM;
            def.joint = ingot::TargetJoint{};
            const ingot::JointId id = world->add_joint(def).value;
            ASSERT_EQ(world->set_target(id, def.P + Vector{1, 0, 0}), Status::ok);
            ties.push_back({id, -1, static_cast<int>(balls.size()) - 1, false});
        }
        double M_of_all = 0;
        for (const ingot::BodyId id : balls) M_of_all += static_cast<double>(world->mass(id).value);
        for (int step_i = 0; step_i < 60; ++step_i) {
            std::vector<Vector3d> before;
            for (const ingot::BodyId id : balls) before.push_back(to_eigen(world->state(id).value.v_CM));
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(h)).clean()) << run_i;
            std::vector<Vector3d> got(balls.size(), Vector3d::Zero());
            double most = 0;
            for (const Tie& tie : ties) {
                const Vector3d F = force_of(*world, tie.id);
                most = std::max(most, F.norm());
                got[static_cast<size_t>(tie.B)] += F;
                if (tie.A >= 0) got[static_cast<size_t>(tie.A)] -= F;
                if (!tie.is_rope) continue;
                const auto place = [&](int i) { return to_eigen(world->state(balls[static_cast<size_t>(i)]).value.r_CM); };
                if (tie.A >= 0) {
                    EXPECT_LE(F.dot(place(tie.B) - place(tie.A)), 0.1 * F.norm() + 1e-6) << run_i;
                }
            }
            for (size_t i = 0; i < balls.size(); ++i) {
                const double M = static_cast<double>(world->mass(balls[i]).value);
                const Vector3d asked = (to_eigen(world->state(balls[i]).value.v_CM) - before[i]) * (M / h) + Vector3d(0, 0, M * g);
                const double rounding = 256 * eps * (most + M_of_all * (g + (before[i].norm() + 1) / h));
                EXPECT_LE((got[i] - asked).norm(), rounding) << run_i << ", step " << step_i << ", ball " << i;
            }
        }
    }
}

/// A parallel joint, a servo and a gear by the turn of what they turn.
TEST(TieReactions, of_turns_are_too) {
    const auto world = std::make_unique<ingot::World<Tearing>>();
    const ingot::BodyId A = add_ball(*world, 3, {0, 0, 0}), B = add_ball(*world, 2, {2, 0, 0}), C = add_ball(*world, 5, {4, 0, 0});
    const ingot::JointId at_A = join(*world, ingot::HingeJoint{}, {}, A, {0, 0, 0}), at_B = join(*world, ingot::HingeJoint{}, {}, B, {2, 0, 0});
    const ingot::JointId gear = world->add_gear(at_A, at_B, -3).value;
    const ingot::JointId parallel = join(*world, ingot::ParallelJoint{}, {}, C, {4, 0, 0});
    const ingot::JointId servo = join(*world, ingot::ServoJoint{}, {}, C, {4, 0, 0});
    ASSERT_EQ(world->set_joint_drive(servo, ingot::SpringDrive{10, 1, 1}), Status::ok);
    for (int step_i = 0; step_i < 20; ++step_i) {
        ASSERT_EQ(world->add_torque(A, {0, 0, scalar(0.5)}), Status::ok);
        ASSERT_EQ(world->add_torque(C, {scalar(0.3), scalar(0.2), 0}), Status::ok);
        const auto L_of = [&](ingot::BodyId id) { return to_eigen(world->state(id).value.L); };
        const Vector3d L_A = L_of(A), L_B = L_of(B), L_C = L_of(C);
        ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
        const double T = torque_of(*world, gear).z();
        EXPECT_NEAR(T, (L_of(B) - L_B).z() * 60, 256 * eps) << step_i;
        EXPECT_NEAR(3 * T + 0.5, (L_of(A) - L_A).z() * 60, 256 * eps) << step_i;
        const Vector3d of_C = (L_of(C) - L_C) * 60 - Vector3d(0.3, 0.2, 0);
        EXPECT_LE((torque_of(*world, parallel) - of_C).head(2).norm(), 256 * eps) << step_i;
        EXPECT_EQ(torque_of(*world, servo).norm(), 0);
    }
}

/// A rope tears at more than it bears, told once; it is mended where its ends have come near again, and no earlier.
TEST(TieReactions, ropes_tear_and_are_mended) {
    for (const bool is_rope : {true, false}) {
        const auto world = std::make_unique<ingot::World<TearingInTouch>>();
        ASSERT_TRUE(add_ground(*world) && weigh(*world));
        const ingot::BodyId load = add_ball(*world, 10, {0, 0, 2});
        ingot::Joint kind = ingot::RodJoint{2};
        if (is_rope) kind = ingot::RopeJoint{2};
        const ingot::JointId tie = join(*world, kind, {}, load, {0, 0, 4});
        ASSERT_EQ(world->set_joint_strength(tie, {200, 10}), Status::ok);
        for (int step_i = 0; step_i < 120; ++step_i) ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
        // A place is rounded by 4 m eps, which a substep may take back.
        EXPECT_NEAR(static_cast<double>(world->joint_reaction(tie).value.force.z), 10 * g, 10 * (4 * eps * 240) * 60);
        EXPECT_FALSE(world->is_joint_broken(tie).value);
        ASSERT_EQ(world->apply_central_impulse(load, {0, 0, -60}), Status::ok);
        (void)ingot::step(*world, scalar(1) / 60);
        int told = 0;
        for (const ingot::JointBreak& broken : world->broken_joints()) told += broken.joint == tie ? 1 : 0;
        EXPECT_EQ(told, 1);
        EXPECT_TRUE(world->is_joint_broken(tie).value);
        EXPECT_EQ(world->joint_length(tie).value, scalar(2));
        std::vector<uint8_t> bytes(ingot::snapshot_size<TearingInTouch>());
        const auto other = std::make_unique<ingot::World<TearingInTouch>>();
        const auto size = ingot::save_snapshot(*world, bytes.data(), bytes.size());
        ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), size.value), Status::ok);
        for (int step_i = 0; step_i < 60; ++step_i) {
            (void)ingot::step(*world, scalar(1) / 60);
            (void)ingot::step(*other, scalar(1) / 60);
        }
        EXPECT_EQ(world->state_hash(), other->state_hash());
        EXPECT_LT(world->state(load).value.r_CM.z, scalar(0.2));
        EXPECT_EQ(world->set_joint_enabled(tie, true), Status::bad_joint);
        ingot::BodyState state = world->state(load).value;
        state.r_CM = {0, 0, scalar(2.02)};
        state.v_CM = {};
        ASSERT_EQ(world->set_state(load, state), Status::ok);
        EXPECT_EQ(world->set_joint_enabled(tie, true), Status::ok);
        ASSERT_EQ(world->set_joint_strength(tie, {}), Status::ok);
        for (int step_i = 0; step_i < 60; ++step_i) (void)ingot::step(*world, scalar(1) / 60);
        EXPECT_NEAR(static_cast<double>(world->state(load).value.r_CM.z), 2, 1e-3);
    }
}

/// A gear whose joint is switched off lets go, and couples anew as its joints are then; it breaks as others do.
TEST(TieReactions, gears_are_clutches) {
    const auto world = std::make_unique<ingot::World<Tearing>>();
    const ingot::BodyId A = add_ball(*world, 3, {0, 0, 0}), B = add_ball(*world, 2, {2, 0, 0});
    const ingot::JointId at_A = join(*world, ingot::HingeJoint{}, {}, A, {0, 0, 0}), at_B = join(*world, ingot::HingeJoint{}, {}, B, {2, 0, 0});
    const ingot::JointId gear = world->add_gear(at_A, at_B, 2).value;
    const auto run = [&](int steps) {
        for (int step_i = 0; step_i < steps; ++step_i) ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
    };
    for (const ingot::JointId id : {at_A, at_B, gear}) {
        ASSERT_EQ(world->set_joint_enabled(id, false), Status::ok);
        const scalar rate_B = world->joint_rate(at_B).value;
        ASSERT_EQ(world->apply_angular_impulse(A, {0, 0, scalar(0.05)}), Status::ok);
        run(30);
        EXPECT_NEAR(static_cast<double>(world->joint_rate(at_B).value), static_cast<double>(rate_B), 1e-5);
        EXPECT_EQ(torque_of(*world, gear).norm(), 0);
        ASSERT_EQ(world->set_joint_enabled(id, true), Status::ok);
        run(2);
        EXPECT_NEAR(static_cast<double>(world->joint_rate(at_B).value), 2 * static_cast<double>(world->joint_rate(at_A).value), 1e-4);
        EXPECT_LE(static_cast<double>(world->joint_gap(gear).value), 1e-4);
    }
    ASSERT_EQ(world->set_joint_strength(gear, {scalar(1e9), scalar(0.1)}), Status::ok);
    ASSERT_EQ(world->apply_angular_impulse(A, {0, 0, 1}), Status::ok);
    run(1);
    EXPECT_TRUE(world->is_joint_broken(gear).value);
    EXPECT_FALSE(world->is_joint_broken(at_A).value);
}

/// Axes that were let go are held again where they are parallel, wherever their bodies are, however they are turned about them; and nowhere else.
TEST(TieReactions, parallel_axes_are_mended_where_they_fit) {
    RandomInput random(4);
    for (int run_i = 0; run_i < ingot_reference::draws(24); ++run_i) {
        const auto world = std::make_unique<ingot::World<Tearing>>();
        const ingot::BodyId A = add_ball(*world, 3, {0, 0, 0}), B = add_ball(*world, 2, {2, 0, 0});
        const Vector3d axis = random.direction(), across = axis.unitOrthogonal();
        const ingot::JointId id = join(*world, ingot::ParallelJoint{}, A, B, {0, 0, 0}, axis);
        ASSERT_EQ(world->set_joint_enabled(id, false), Status::ok);
        const auto mended_at = [&](const Vector3d& about, double angle) {
            ingot::BodyState state = world->state(B).value;
            state.r_CM = to_vector(random.vector(5));
            state.A = ingot_reference::to_matrix(Eigen::AngleAxisd(angle, about).toRotationMatrix());
            EXPECT_EQ(world->set_state(B, state), Status::ok);
            return world->set_joint_enabled(id, true);
        };
        EXPECT_EQ(mended_at(across, random.real(0.5, 2.5)), Status::bad_joint) << run_i;
        EXPECT_EQ(mended_at(across, 3.14159265), Status::bad_joint) << run_i;  // opposite
        EXPECT_EQ(mended_at(axis, random.real(-3, 3)), Status::ok) << run_i;
        ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
        EXPECT_LE(static_cast<double>(world->kinetic_energy()), 1e-6);
    }
}

/// A servo whose B has come to stand turns nothing, and its A goes as if it were not there, to the bit; once B moves again it is turned.
TEST(TieReactions, servos_of_what_stands_are_nothing) {
    const auto world = std::make_unique<ingot::World<Tearing>>(), without = std::make_unique<ingot::World<Tearing>>();
    std::vector<ingot::BodyId> bodies[2];
    ingot::JointId servo{};
    for (auto* const of : {world.get(), without.get()}) {
        auto& ids = bodies[of == world.get() ? 0 : 1];
        ids = {add_ball(*of, 3, {0, 0, 0}), add_ball(*of, 2, {2, 0, 0})};
        (void)join(*of, ingot::HingeJoint{}, {}, ids[0], {0, 0, 0});
        ASSERT_EQ(of->apply_angular_impulse(ids[0], {0, 0, scalar(0.1)}), Status::ok);
        if (of == without.get()) continue;
        servo = join(*of, ingot::ServoJoint{}, ids[0], ids[1]);
        ASSERT_EQ(of->set_joint_drive(servo, ingot::SpringDrive{1, 1, 1}), Status::ok);
    }
    const ingot::MassProperties mass = [] {
        return ingot::principal(ingot::with_mass(ingot::solid_sphere(1, scalar(0.1)), 2)).value;
    }();
    for (auto* const of : {world.get(), without.get()}) ASSERT_EQ(of->set_immovable(bodies[of == world.get() ? 0 : 1][1]), Status::ok);
    for (int step_i = 0; step_i < 30; ++step_i) {
        ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
        ASSERT_TRUE(ingot::step(*without, scalar(1) / 60).clean());
        ASSERT_TRUE(are_same(*world, *without, bodies[0], bodies[1])) << step_i;
        EXPECT_EQ(world->drive_torque(servo).value, 0);
    }
    ASSERT_EQ(world->set_movable(bodies[0][1], mass), Status::ok);
    ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
    EXPECT_GT(world->omega(bodies[0][1]).value.z, 0);
}

}  // namespace
