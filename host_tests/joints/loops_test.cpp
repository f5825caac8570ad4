// SPDX-License-Identifier: MIT
// Joints that close loops: they hold as those of trees do, whatever the masses, in flight and in contact, and rows that say the same do no harm.
#include <gtest/gtest.h>

#include <memory>

#include "joints/constrained_reference.h"
#include "joints/constrained_step_reference.h"
#include "joints/figure_scenes.h"
#include "reference/draws.h"
#include "scene_in_world.h"

namespace {

using namespace figures;
using namespace ingot_figures;

struct Swinging : ingot::Scene {
    static constexpr int max_bodies = 48, max_joints = 60, max_loops = 8;
    static constexpr bool translates = true;
    using joints = AllJoints;
};
using SwingingWorld = ingot::World<Swinging>;

struct Touching : Swinging {
    static constexpr int max_manifolds = 200, max_pairs = 800;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box>;
};

/// Joins two bodies of a figure, or one and the world, once more, where they are.
template <class World>
void add_loop(World& world, RandomInput& random, const Built& figure, Built& built) {
    const int count = static_cast<int>(figure.bodies.size());
    const int first = random.integer(0, count - 1), second = random.integer(-1, count - 1);
    if (first == second) return;
    ingot::JointDef joint;
    joint.body_A = figure.bodies[static_cast<size_t>(first)];
    if (second >= 0) joint.body_B = figure.bodies[static_cast<size_t>(second)];
    joint.P = world.state(joint.body_A).value.r_CM + to_vector(random.direction());
    const Eigen::Vector3d axis = random.direction();
    joint.axis = to_vector(axis);
    joint.axis_B = to_vector(axis.cross(random.direction()).normalized());
    joint.joint = kinds[random.integer(0, 4)];
    const auto id = world.add_joint(joint);
    built.sound = built.sound && id.ok();
    if (id.ok()) built.joints.push_back(id.value);
}

/// Figures of every form and ratio with one or two loops, most of which leave them little or nothing free; a tree is beside them. In float, where
/// masses differ a thousandfold, rows that give way by less than limits::loop_compliance are let go, and the next way the figure turns is seen.
TEST(Loops, hold_whatever_hangs_on_them) {
    RandomInput random(1);
    for (int run_i = 0; run_i < ingot_reference::draws(120); ++run_i) {
        const double rate = rates[random.integer(0, 4)], ratio = run_i % 2 == 0 ? 1 : 1000;
        const auto world = std::make_unique<SwingingWorld>();
        ASSERT_TRUE(weigh(*world));
        const Drawn drawn = {random.integer(3, 13), random.real(0.3, 1), ratio, random.real(0, 4), random.integer(0, 1) == 1};
        Built built, beside;
        add_figure(*world, random, drawn, {0, 0, 0}, built);
        add_figure(*world, random, drawn, {0, 30, 0}, beside);
        const Built tree = built;
        for (int i = random.integer(1, 2); i > 0; --i) add_loop(*world, random, tree, built);
        ASSERT_TRUE(built.sound && beside.sound);
        double gap = 0, gap_beside = 0;
        for (int step_i = 0; step_i < static_cast<int>(rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean()) << run_i;
            gap = std::max(gap, worst_gap(*world, built));
            gap_beside = std::max(gap_beside, worst_gap(*world, beside));
        }
        EXPECT_LE(gap, ratio > 1 && !INGOT_DOUBLE ? 1e-3 : held) << run_i << ", " << rate << " Hz, " << drawn.bodies << " bodies, ratio " << ratio;
        EXPECT_LE(gap_beside, held) << run_i << ", " << rate << " Hz";
    }
}

/// A ring of links, each of a mass of its own, that are thrown apart: the first velocities are, of all that its joints allow, those nearest to what
/// they were, in kinetic energy. In so short a step nothing turns.
TEST(Loops, velocities_are_the_nearest_that_they_allow) {
    RandomInput random(2);
    for (int run_i = 0; run_i < ingot_reference::draws(80); ++run_i) {
        const int links = random.integer(3, 16);
        const double ratio = run_i % 2 == 0 ? 1 : 1000, h = INGOT_DOUBLE ? 1e-6 : 1e-3;
        FigureScene scene;
        scene.g = Vector3d::Zero();
        const Matrix3d R = random.rotation();
        const auto corner = [&](int i) -> Vector3d {
            const double angle = 2 * pi * i / links;
            return R * Vector3d(std::cos(angle), std::sin(angle), 0.1 * (i % links % 3));
        };
        for (int i = 0; i < links; ++i) {
            const double M = std::exp(random.real(0, std::log(ratio)));
            const Vector3d side = corner(i + 1) - corner(i);
            FigureBody link = capsule(M, 0.05, side.norm() / 2, corner(i) + side / 2, along(side));
            link.v_CM = random.vector(1);
            link.omega = random.vector(1);
            scene.add(link);
        }
        for (int i = 0; i < links; ++i)
            scene.join(run_i % 3 == 0 ? hinge(i, (i + 1) % links, corner(i + 1), random.direction()) : ball(i, (i + 1) % links, corner(i + 1)));
        const auto world = std::make_unique<SwingingWorld>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound);
        const JointRows rows(scene);
        const FigureState start = state_of(*world, built);
        std::vector<StepRow> locked;
        for (int joint_i = 0; joint_i < scene.joint_count(); ++joint_i)
            for (const StepRow& row : locked_rows(rows, start, joint_i, JointTarget{})) locked.push_back(row);
        const FigureState exact = with_velocities(start, solve_step(step_bodies(scene, start), locked));
        ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(h)).clean());
        const FigureState state = state_of(*world, built);
        // Links turn by up to 10 rad/s: their speeds change by (10 rad/s)^2 times 1 m in a second. Places are rounded, and looked at over a substep.
        const double allowed = 100 * h + 64 * eps / h;
        for (int body_i = 0; body_i < links; ++body_i) {
            EXPECT_LE((state.body(body_i).v_CM - exact.body(body_i).v_CM).norm(), allowed) << run_i << ", " << links << " links";
            EXPECT_LE((state.body(body_i).omega - exact.body(body_i).omega).norm(), 10 * allowed) << run_i << ", " << links << " links";
        }
    }
}

struct Machine {
    const char* name;
    FigureScene scene;
    double time;
};
std::vector<Machine> machines() {
    return {{"four bars", four_bar(false, 1, 2), 1},   {"four bars, doubled", four_bar(true, 1, 2), 1}, {"Bennett", bennett_loop(1, 2), 1},
            {"slider and crank", slider_crank(0.3, 6), 1}, {"door on two", door(2), 1},                     {"door on three", door(3), 1}};
}

/// Where a machine's bodies are after a while, against the exact motion: m, the worst. A substep moves bodies by the velocities of its end; so they
/// start with those of half a substep earlier, and what is left is of second order.
double error_of(const Machine& machine, double rate, double& gap) {
    ConstrainedReference exact(machine.scene);
    const double half = 0.5 / (rate * Swinging::effort.substeps);
    const auto a = exact.accelerations();
    FigureScene scene = machine.scene;
    for (int i = 0; i < scene.body_count(); ++i) {
        scene.body(i).v_CM -= a.segment<3>(6 * i) * half;
        scene.body(i).omega -= a.segment<3>(6 * i + 3) * half;
    }
    const auto world = std::make_unique<SwingingWorld>();
    const Built built = add_scene(*world, scene);
    EXPECT_TRUE(built.sound) << machine.name;
    for (int step_i = 0; step_i < static_cast<int>(std::lround(machine.time * rate)); ++step_i) {
        EXPECT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean()) << machine.name;
        gap = std::max(gap, worst_gap(*world, built));
    }
    exact.advance_to(machine.time);
    const FigureState state = state_of(*world, built);
    double worst = 0;
    for (int i = 0; i < scene.body_count(); ++i) worst = std::max(worst, (state.body(i).r_CM - exact.state().body(i).r_CM).norm());
    return worst;
}

/// Machines go where the exact motion goes, to second order in the step, and their loops are closed all the way.
TEST(Loops, machines_follow_the_exact_motion) {
    for (const Machine& machine : machines()) {
        double gap = 0;
        const double coarse = error_of(machine, 120, gap), fine = error_of(machine, 240, gap);
        std::printf("%-20s %.2e m at 120 Hz, %.2e at 240, gap %.2e mm\n", machine.name, coarse, fine, gap * 1e3);
        EXPECT_LE(fine, coarse / 3 + 1e4 * eps) << machine.name;
        EXPECT_LE(gap, INGOT_DOUBLE ? 1e-9 : held) << machine.name;
    }
}

/// One, two or three hinges in a line: the door swings alike, and what hinges two and three add is nothing.
TEST(Loops, hinges_in_a_line_are_one) {
    FigureState states[3];
    for (int hinges = 1; hinges <= 3; ++hinges) {
        const auto world = std::make_unique<SwingingWorld>();
        const Built built = add_scene(*world, door(hinges));
        ASSERT_TRUE(built.sound);
        for (int step_i = 0; step_i < 120; ++step_i) ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
        states[hinges - 1] = state_of(*world, built);
    }
    const double rounding = 480 * 16 * eps;  // of 480 substeps
    for (int hinges = 2; hinges <= 3; ++hinges)
        for (size_t i = 0; i < states[0].bodies.size(); ++i)
            EXPECT_LE((states[hinges - 1].bodies[i].r_CM - states[0].bodies[i].r_CM).norm(), rounding) << hinges;
}

/// The bars of a bridge held at both ends, with boxes on it of as much as two hundred planks.
TEST(Loops, a_bridge_carries_what_falls_on_it) {
    for (const double rate : {30.0, 60.0, 120.0})
        for (const double box_factor : {2.0, 20.0, 200.0}) {
            if (INGOT_TEST_BRIEF && (rate == 120 || box_factor == 20)) continue;
            const auto world = std::make_unique<ingot::World<Touching>>();
            const FigureScene scene = bridge(30, 10, box_factor);
            const Built built = add_scene(*world, scene);
            ASSERT_TRUE(built.sound);
            double gap = 0;
            for (int step_i = 0; step_i < static_cast<int>(3 * rate); ++step_i) {
                const ingot::StepReport report = ingot::step(*world, static_cast<scalar>(1 / rate));
                ASSERT_EQ(report.bodies_frozen + report.contacts_lost + report.joints_lost, 0);
                gap = std::max(gap, worst_gap(*world, built));
            }
            EXPECT_LE(gap, 1.5e-4) << rate << " Hz, boxes of " << box_factor;
            const FigureState state = state_of(*world, built);
            for (const BodyMotion& body : state.bodies) EXPECT_GT(body.r_CM.z(), 1) << rate << " Hz, boxes of " << box_factor;
        }
}

struct Drawing : Touching {
    static constexpr bool kinematic_bodies = true;
};

/// The ends of a chain are drawn apart by two metres more than it is long, which cannot be: nothing flies, and when they are back it hangs as before.
TEST(Loops, what_cannot_be_is_bounded) {
    for (const ingot::Joint& kind : {kinds[0], kinds[1], kinds[3]})
        for (const double rate : {30.0, 60.0, 240.0}) {
            const auto world = std::make_unique<ingot::World<Drawing>>();
            ASSERT_TRUE(weigh(*world));
            Built built;
            const int links = 10;
            for (int i = 0; i < links + 2; ++i) {
                ingot::BodyDef def;
                def.mass = ingot::principal(ingot::with_mass(ingot::solid_capsule(1, scalar(0.05), scalar(0.2)), 1)).value;
                def.shape = ingot::Capsule{scalar(0.05), scalar(0.2)};
                def.state.r_CM = {scalar(0.5) * static_cast<scalar>(i), 0, 5};
                def.state.A = ingot::axis_angle({0, 1, 0}, static_cast<scalar>(pi / 2));
                def.kinematic = i == 0 || i == links + 1;
                built.bodies.push_back(world->add(def).value);
                if (i == 0) continue;
                ingot::JointDef joint;
                joint.body_A = built.bodies[static_cast<size_t>(i - 1)];
                joint.body_B = built.bodies.back();
                joint.joint = kind;
                joint.axis = {0, 1, 0};
                joint.P = {scalar(0.5) * static_cast<scalar>(i) - scalar(0.25), 0, 5};
                built.joints.push_back(world->add_joint(joint).value);
            }
            double speed = 0, gap = 0, gap_after = 0;
            for (int step_i = 0; step_i < static_cast<int>(6 * rate); ++step_i) {
                const double t = step_i / rate, v = t < 2 ? 1 : t < 4 ? -1.1 : 0;  // in the end the chain is longer than its way by 0.2 m
                ASSERT_EQ(world->set_velocity(built.bodies.back(), {static_cast<scalar>(v), 0, 0}, {}), ingot::Status::ok);
                ASSERT_EQ(ingot::step(*world, static_cast<scalar>(1 / rate)).bodies_frozen, 0);
                for (const ingot::BodyId id : built.bodies)
                    speed = std::max(speed, ingot_reference::to_eigen(world->state(id).value.v_CM).norm());
                (t < 5 ? gap : gap_after) = std::max(t < 5 ? gap : gap_after, worst_gap(*world, built));
            }
            EXPECT_LE(gap, 2) << rate << " Hz";
            EXPECT_LE(speed, 20) << rate << " Hz";  // two metres' fall of a chain drawn taut, and the whip of its middle
            EXPECT_LE(gap_after, held) << rate << " Hz";
        }
}

/// Alone as beside others, to the bit, in whatever slots and lanes.
TEST(Loops, take_no_notice_of_others) {
    for (int run_i = 0; run_i < ingot_reference::draws(24); ++run_i) {
        RandomInput first(static_cast<uint64_t>(100 + run_i)), again(static_cast<uint64_t>(100 + run_i)), others(static_cast<uint64_t>(run_i));
        const auto alone = std::make_unique<SwingingWorld>(), beside = std::make_unique<SwingingWorld>();
        const Drawn drawn = {3 + run_i % 9, 0.5, 10, 3, run_i % 2 == 0};
        Built of_alone, of_beside, rest, more;
        add_figure(*alone, first, drawn, {0, 0, 0}, of_alone);
        const Built tree = of_alone;
        add_loop(*alone, first, tree, of_alone);
        add_figure(*beside, others, {5, 0.7, 3, 4, run_i % 3 == 0}, {0, 50, 0}, rest);
        add_figure(*beside, again, drawn, {0, 0, 0}, of_beside);
        const Built tree_beside = of_beside;
        add_loop(*beside, again, tree_beside, of_beside);
        add_figure(*beside, others, drawn, {0, -50, 0}, more);
        const Built tree_of_more = more;
        add_loop(*beside, others, tree_of_more, more);
        ASSERT_TRUE(of_alone.sound && of_beside.sound && rest.sound && more.sound);
        for (int step_i = 0; step_i < 60; ++step_i) {
            (void)ingot::step(*alone, scalar(1) / 60);
            (void)ingot::step(*beside, scalar(1) / 60);
        }
        ASSERT_TRUE(are_same(*alone, *beside, of_alone.bodies, of_beside.bodies)) << run_i;
    }
}

}  // namespace
