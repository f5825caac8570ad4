// SPDX-License-Identifier: MIT
// What goes bad stays alone: whatever a body is driven to, by the most that calls take, those who only touch the same ground, level or kinematic body
// move as they do beside a calm one, to the bit, in every solver.
#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <ingot/level/mesh_of.h>

#include "joints/figures.h"
#include "reference/draws.h"
#include "reference/sanitized.h"

namespace {

using ingot::BodyDef;
using ingot::BodyId;
using ingot::scalar;
using ingot::Status;
using ingot::Vector;
using ingot_reference::is_sanitized;
using ingot_reference::RandomInput;
namespace limits = ingot::limits;

scalar number(double x) { return static_cast<scalar>(x); }

constexpr Vector corners_of_plane[] = {{-300, -300, 0}, {300, -300, 0}, {300, 300, 0}, {-300, 300, 0}};
constexpr ingot::LevelFace faces_of_plane[] = {{0, 1, 2, 0}, {0, 2, 3, 0}};
constexpr auto plane_built = ingot::mesh_of(corners_of_plane, faces_of_plane, scalar(1) / 64);
static_assert(plane_built.ok());
constexpr auto plane = ingot::trimmed<plane_built>();

enum class Ground { half_space, box, kinematic_box, level };

struct Pile : ingot::Scene {
    static constexpr int max_bodies = 24, max_manifolds = 120;
    static constexpr bool translates = true, has_boxes = true, has_levels = false;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
struct Balls : Pile {
    static constexpr bool has_boxes = false;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
};
struct Materials : Pile {
    static constexpr bool rolling_resistance = true, surface_velocities = true, kinematic_bodies = true, sleeps = true;
};
struct Locked : Pile {
    static constexpr bool axis_locks = true;
};
struct OnLevels : Pile {
    static constexpr bool has_levels = true;
    static constexpr int max_bodies = 28;
    static constexpr ingot::LevelTable levels[] = {plane.view()};
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace, ingot::Level>;
};
struct Fast : Pile {
    static constexpr bool continuous = true, kinematic_bodies = true;
};
struct Direct : Pile {
    static constexpr bool kinematic_bodies = true;
    using solver = ingot::HybridIslands<12>;
};
struct Pointwise : Pile {
    static constexpr bool kinematic_bodies = true;
    using solver = ingot::SequentialImpulses;
};
struct Frictionless : ingot::Scene {
    static constexpr int max_bodies = 24, max_contacts = 240;
    static constexpr bool translates = true, has_boxes = true, has_levels = false;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using solver = ingot::FrictionlessImpacts;
};
struct Trees : Pile {
    static constexpr int max_joints = 24;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint>;
};
template <class Base>
struct Machines : Base {
    static constexpr int max_joints = 40, max_loops = 24;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::RodJoint, ingot::ServoJoint, ingot::WithLimits, ingot::WithDrives>;
};
struct Swinging : Pile {
    static constexpr int max_joints = 24;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint>;
    using figure_motion = ingot::EnergyMomentum<>;
};

template <class S>
Status add_ground(ingot::World<S>& world, Ground kind) {
    if constexpr (S::has_levels)
        if (kind == Ground::level) return world.add_level({}).status;
    BodyDef def;
    def.immovable = kind != Ground::kinematic_box;
    def.kinematic = kind == Ground::kinematic_box;
    def.shape = kind == Ground::half_space ? ingot::Shape(ingot::HalfSpace{{0, 0, 1}, 0}) : ingot::Shape(ingot::Box{{300, 300, 1}});
    if (kind != Ground::half_space) def.state.r_CM = {0, 0, -1};
    if (def.kinematic) def.state.v_CM = {scalar(0.25), 0, 0};
    return world.add(def).status;
}
template <class S>
Ground draw_ground(RandomInput& random) {
    if (S::has_levels && random.integer(0, 1) == 0) return Ground::level;
    if (!S::has_boxes) return Ground::half_space;
    return S::kinematic_bodies && random.integer(0, 1) == 0 ? Ground::kinematic_box : random.integer(0, 1) == 0 ? Ground::box : Ground::half_space;
}

/// Up to four bodies upon each other, or, where the scene has joints, hung together by trees, rods and servos, some of them driven.
template <class S>
std::vector<BodyId> add_heap(ingot::World<S>& world, double y, double size, int most, RandomInput random) {
    std::vector<BodyId> bodies;
    const int count = random.integer(1, most);
    for (int body_i = 0; body_i < count; ++body_i) {
        BodyDef def;
        const double I = 0.1 * size * size;
        def.mass = {1, {number(I), number(I), number(I)}, {}, ingot::identity_matrix<scalar>()};
        const scalar half = number(0.5 * size);
        def.shape = random.integer(0, 1) == 0 || !S::has_boxes ? ingot::Shape(ingot::Sphere{half}) : ingot::Shape(ingot::Box{{half, half, half}});
        def.friction = number(random.real(0, 1));
        def.restitution = number(random.integer(0, 1) == 0 ? 0 : random.real(0, 1));
        def.state.r_CM = {number(size * random.real(-0.3, 0.3)), number(y + size * random.real(-0.3, 0.3)), number(size * (0.5 + 0.95 * body_i))};
        if constexpr (S::axis_locks) def.locks = static_cast<uint8_t>(random.integer(0, 3) == 0 ? random.integer(0, 63) : 0);
        bodies.push_back(world.add(def).value);
    }
    if constexpr (ingot::has_joints<S>) {
        if (random.integer(0, 4) == 0) return bodies;
        const auto join = [&](const ingot::Joint& joint, size_t A, size_t B) {
            ingot::JointDef def;
            def.body_A = bodies[A];
            def.body_B = bodies[B];
            def.joint = joint;
            const Vector a = world.state(def.body_A).value.r_CM, b = world.state(def.body_B).value.r_CM;
            def.P = (a + b) * scalar(0.5);
            def.P_B = b;
            def.bodies_meet = random.integer(0, 1) == 0;
            const auto id = world.add_joint(def);
            EXPECT_TRUE(id.ok()) << ingot::name(id.status);
            return id.value;
        };
        for (size_t i = 1; i < bodies.size(); ++i) {
            if constexpr (ingot::has_joint_drives<S>)
                if (random.integer(0, 2) == 0) {
                    (void)join(ingot::RodJoint{}, i - 1, i);
                    continue;
                }
            if (random.integer(0, 1) == 0) {
                (void)join(ingot::BallJoint{}, i - 1, i);
                continue;
            }
            [[maybe_unused]] const ingot::JointId hinge = join(ingot::HingeJoint{}, i - 1, i);
            if constexpr (ingot::has_joint_drives<S>)
                if (random.integer(0, 1) == 0) {
                    EXPECT_EQ(world.set_joint_drive(hinge, ingot::SpringDrive{100, 1, 0, 1, 0, number(random.real(0, 50))}), Status::ok);
                }
        }
        if constexpr (ingot::has_joint_drives<S>) {
            if (bodies.size() > 2 && random.integer(0, 1) == 0) (void)join(ingot::BallJoint{}, 0, bodies.size() - 1);
            if (bodies.size() > 1 && random.integer(0, 2) == 0) (void)join(ingot::ServoJoint{}, 0, bodies.size() - 1);
        }
    }
    return bodies;
}

/// What is done to a body, or to all of its heap.
struct Outrage {
    bool all, light, thrown, spun, pushed, turned;
    int from, victim;
    double M, I, share;
    Vector along, about;

    explicit Outrage(RandomInput& random) {
        all = random.integer(0, 2) == 0;
        light = random.integer(0, 1) == 0;
        thrown = random.integer(0, 3) == 0;
        spun = random.integer(0, 3) == 0;
        pushed = random.integer(0, 3) == 0;
        turned = random.integer(0, 2) == 0;
        from = random.integer(0, 4);
        victim = random.integer(0, 1) == 0 ? 0 : random.integer(0, 3);
        M = std::pow(10, random.real(-8.9, random.integer(0, 2) == 0 ? 12 : 0));
        I = std::min(std::max(M * std::pow(10, random.real(-10, 0)), 1.1 * static_cast<double>(limits::inertia_min)), 1e17);
        share = std::pow(10, random.real(-9, 0));
        const double angle = random.real(0, 6.28);
        along = {number(std::cos(angle)), 0, number(std::sin(angle))};  // not towards the others
        about = ingot_reference::to_vector(random.direction());
    }
    template <class S>
    void commit(ingot::World<S>& world, BodyId id, int step_i) const {
        if (step_i == from) {
            if (light) (void)world.set_mass(id, {number(M), {number(I), number(I), number(I)}, {}, ingot::identity_matrix<scalar>()});
            ingot::BodyState state = world.state(id).value;
            if (thrown) state.v_CM = along * (limits::speed_max * number(std::sqrt(share)));
            if (spun) state.L = about * (limits::spin_max * number(std::sqrt(share)) * world.inertia(id).value.x);
            if (thrown || spun) (void)world.set_state(id, state);
        }
        if (step_i < from) return;
        if (pushed) (void)world.add_central_force(id, along * (limits::force_max * number(share)));
        if (turned) (void)world.add_torque(id, about * (limits::torque_max * number(share)));
    }
};

constexpr double apart = 60, reach = 25;  // m

/// What has left its place, or will by the next step, may meet the others.
template <class S>
bool stays(const ingot::World<S>& world, const std::vector<BodyId>& heap, double h) {
    for (const BodyId id : heap) {
        const ingot::BodyState state = world.state(id).value;
        if (!(std::abs(static_cast<double>(state.r_CM.y)) + 2 * h * std::abs(static_cast<double>(state.v_CM.y)) < reach)) return false;
    }
    return true;
}
template <class S>
int frozen_of(const ingot::World<S>& world, const std::vector<BodyId>& heap) {
    return static_cast<int>(std::count_if(heap.begin(), heap.end(), [&](BodyId id) { return world.is_frozen(id); }));
}

template <class S>
class BesideBadBodies : public ::testing::Test {};
using Scenes = ::testing::Types<Pile, Balls, Materials, Locked, OnLevels, Fast, Direct, Pointwise, Frictionless, Trees, Machines<Pile>,
                                Machines<Materials>, Swinging>;
TYPED_TEST_SUITE(BesideBadBodies, Scenes);

TYPED_TEST(BesideBadBodies, others_go_as_beside_calm_ones) {
    using S = TypeParam;
    // To be mended: see told_after_freezing_test.
    if (is_sanitized && ingot::swings_freely<S>) GTEST_SKIP();
    using World = ingot::World<S>;
    constexpr int count = is_sanitized ? 16 : 160, heaps = 4;  // watched, a draw takes seconds
    constexpr double rates[] = {30, 60, 120, 240, 1000};
    RandomInput random(2);
    int froze = 0, beside = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(count); ++run_i) {
        const double h = 1 / rates[random.integer(0, 4)], size = std::pow(2, random.integer(-3, 4));
        const Ground ground = draw_ground<S>(random);
        const int bad = random.integer(0, heaps - 1);
        const uint64_t seed = random.bits();
        Outrage outrage(random);
        if constexpr (S::solver::is_frictionless) {
            // Meetings are foreseen by a parabola of the distance. What gets 10^10 m/s^2 bends more than that, and is taken to meet bodies that are
            // hundreds of metres off its way: these are looked at again.
            outrage.turned = outrage.turned || outrage.pushed;
            outrage.pushed = false;
        }
        const std::unique_ptr<World> world = std::make_unique<World>(), calm = std::make_unique<World>();
        std::vector<BodyId> of_world[heaps], of_calm[heaps];
        for (World* const each : {world.get(), calm.get()}) {
            ASSERT_EQ(each->set_gravity({0, 0, scalar(-9.8125)}), Status::ok);
            if (run_i % 2 == 0) {
                ASSERT_EQ(add_ground<S>(*each, ground), Status::ok);
            }
            for (int heap_i = 0; heap_i < heaps; ++heap_i) {
                // Others are alike in form, or not: they share lanes with what goes bad.
                const double y = heap_i == bad ? 0 : apart * (heap_i + 1), of_size = heap_i == bad ? size : 1;
                // Where impacts follow each other within a step, what is thrown off its own heap may meet the others in that step.
                const int most = heap_i == bad && S::solver::is_frictionless ? 1 : 4;
                (each == world.get() ? of_world : of_calm)[heap_i] =
                    add_heap<S>(*each, y, of_size, most, RandomInput(seed + (run_i % 3 == 0 ? 0 : static_cast<uint64_t>(heap_i))));
            }
            if (run_i % 2 == 1) {
                ASSERT_EQ(add_ground<S>(*each, ground), Status::ok);
            }
        }
        const std::vector<BodyId>& heap = of_world[bad];
        for (int step_i = 0; step_i < 10; ++step_i) {
            for (size_t i = 0; i < heap.size(); ++i)
                if (outrage.all || i == static_cast<size_t>(outrage.victim) % heap.size()) outrage.commit(*world, heap[i], step_i);
            if (!stays(*world, heap, h)) break;
            const ingot::StepReport report = ingot::step(*world, number(h));
            (void)ingot::step(*calm, number(h));
            if (!stays(*world, heap, h)) break;
            for (int heap_i = 0; heap_i < heaps; ++heap_i) {
                if (heap_i == bad) continue;
                ASSERT_TRUE(figures::are_same(*world, *calm, of_world[heap_i], of_calm[heap_i]) && frozen_of(*world, of_world[heap_i]) == 0)
                    << "run " << run_i << ", step " << step_i << ", heap " << heap_i << " beside " << bad << ", " << 1 / h << " Hz, ground "
                    << static_cast<int>(ground);
                beside += report.bodies_frozen > 0 ? 1 : 0;
            }
            froze += report.bodies_frozen > 0 ? 1 : 0;
        }
    }
    std::printf("    bodies froze in %d steps, beside %d heaps\n", froze, beside);
    EXPECT_GT(froze, ingot_reference::draws(count) / 16);
}

}  // namespace
