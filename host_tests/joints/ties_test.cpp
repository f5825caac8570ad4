// SPDX-License-Identifier: MIT
// Rods and ropes: they hold whatever hangs on them, between trees of joints and bodies that have none, and a rope that is slack is not there.
#include <gtest/gtest.h>

#include <memory>

#include "joints/constrained_reference.h"
#include "joints/constrained_step_reference.h"
#include "joints/figure_measures.h"
#include "joints/figure_scenes.h"
#include "joints/pendulum_tables.h"
#include "reference/draws.h"
#include "scene_in_world.h"

namespace {

using namespace figures;
using namespace ingot_figures;
using ingot::Status;

struct Tied : ingot::Scene {
    static constexpr int max_bodies = 48, max_joints = 80, max_loops = 60;
    static constexpr bool translates = true;
    using joints = AllJointsWith<ingot::RodJoint, ingot::RopeJoint, ingot::ParallelJoint>;
};
using TiedWorld = ingot::World<Tied>;

/// Rods and ropes alone: bodies are figures of one.
struct Strung : Tied {
    static constexpr int max_joints = 40, max_loops = 30;
    using joints = ingot::Joints<ingot::RodJoint, ingot::RopeJoint>;
};
using StrungWorld = ingot::World<Strung>;
struct StrungAsleep : Strung {
    static constexpr int max_manifolds = 60, max_pairs = 200;
    static constexpr bool sleeps = true;
    using shapes = ingot::Shapes<ingot::Sphere>;
};

/// m: of ties, alone, after a step. A push ends below loop_gap; beside other figures those of trees have `held`.
constexpr double tied_gap = INGOT_DOUBLE ? 1e-9 : held;

FigureJoint tie(int A, int B, const Vector3d& P_A, const Vector3d& P_B, double slack = 1, bool is_rod = true) {
    FigureJoint joint = joint_of(FigureJointKind::distance, A, B, P_A, Vector3d::UnitZ(), Vector3d::UnitZ());
    joint.anchor_B = P_B;
    joint.most = (P_B - P_A).norm() * slack;
    joint.least = is_rod ? joint.most : 0;
    return joint;
}

/// What a net is drawn from.
struct Net {
    int bodies, cross;   ///< cross: ties beside those that make it a tree
    double mass_ratio;
    bool tied;           ///< to the world, by its first body
    double with_joints;  ///< of links, how many are joints of trees
    double ropes;        ///< of ties, how many are ropes
};

/// Boxes, each tied or joined to one before it, and some ties across.
FigureScene net(RandomInput& random, const Net& drawn) {
    FigureScene scene;
    const auto link = [&](int A, int B) {
        const auto end = [&](int body_i) -> Vector3d {
            return body_i == the_world ? Vector3d(random.direction()) : scene.body(body_i).r_CM + 0.3 * Vector3d(random.direction());
        };
        const bool is_rope = random.real(0, 1) < drawn.ropes;
        scene.join(tie(A, B, end(A), end(B), is_rope ? random.real(1, 1.2) : 1, !is_rope));
    };
    for (int i = 0; i < drawn.bodies; ++i) {
        const int before = i == 0 ? the_world : random.integer(0, i - 1);
        const Vector3d from = before == the_world ? Vector3d::Zero() : scene.body(before).r_CM;
        const double M = std::exp(random.real(0, std::log(drawn.mass_ratio)));
        FigureBody body = box(M, Vector3d(0.3, 0.2, 0.1), from + 1.5 * Vector3d(random.direction()), random.rotation());
        body.v_CM = random.vector(1);
        body.omega = random.vector(1);
        scene.add(body);
        if (before == the_world && !drawn.tied) continue;
        if (random.real(0, 1) < drawn.with_joints)
            scene.join(random.integer(0, 1) == 0 ? ball(before, i, from + Vector3d(random.direction()))
                                                 : hinge(before, i, from + Vector3d(random.direction()), random.direction()));
        else
            link(before, i);
    }
    for (int i = 0; i < drawn.cross; ++i) {
        const int B = random.integer(0, drawn.bodies - 1), A = random.integer(drawn.tied ? -1 : 0, drawn.bodies - 1);
        if (A != B) link(A, B);
    }
    return scene;
}

/// Of two bodies of a net, or of one and the world.
FigureJoint parallel(RandomInput& random, const Net& drawn) {
    const int B = random.integer(0, drawn.bodies - 1);
    const Vector3d axis = random.direction();
    return joint_of(FigureJointKind::parallel, random.integer(-1, B - 1), B, Vector3d::Zero(), axis, axis);
}

Net drawn_net(RandomInput& random, int run_i) {
    return {random.integer(2, 12), random.integer(0, 3), run_i % 2 == 0 ? 1.001 : 1000.0, random.integer(0, 1) == 1, run_i % 3 == 0 ? 0 : 0.4,
            run_i % 4 < 2 ? 0 : 0.4};
}

/// Nets of every form and ratio: ties keep their lengths, joints stay closed. In double all are closed to a nanometre after a step. A net that snaps
/// taut, so that light bodies would have to turn by more in a substep than its pushes may, is closed in the next: of a thousand steps one may be
/// such.
TEST(Ties, hold_whatever_hangs_on_them) {
    RandomInput random(1);
    double worst = 0;
    int steps = 0, late = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(160); ++run_i) {
        const double rate = rates[random.integer(0, 4)];
        const FigureScene scene = net(random, drawn_net(random, run_i));
        const auto world = std::make_unique<TiedWorld>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound) << run_i;
        for (int step_i = 0; step_i < static_cast<int>(rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean()) << run_i;
            const double gap = worst_gap(*world, built);
            ASSERT_LE(gap, static_cast<double>(ingot::limits::parted_gap)) << run_i << ", " << rate << " Hz, " << scene.body_count() << " bodies";
            ++steps;
            late += gap > tied_gap ? 1 : 0;
            if (gap <= tied_gap) worst = std::max(worst, gap);
        }
    }
    EXPECT_LE(late, steps / 1000);
    std::printf("    %.2e mm at most, %d of %d steps late\n", worst * 1e3, late, steps);
}

double weight_of(const FigureScene& scene) {
    double M = 0;
    for (const FigureBody& body : scene.bodies) M += body.M;
    return M * g;
}

/// As figures do, and what is slack in them takes energy when it comes to its end.
TEST(Ties, make_no_energy) {
    RandomInput random(2);
    for (int run_i = 0; run_i < ingot_reference::draws(80); ++run_i) {
        const double rate = rates[random.integer(1, 4)];
        const FigureScene scene = net(random, drawn_net(random, run_i));
        const auto world = std::make_unique<TiedWorld>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound);
        const double begin = energy_of(*world, built);
        double most = begin, kinetic = 0;
        for (int step_i = 0; step_i < static_cast<int>(2 * rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
            most = std::max(most, energy_of(*world, built));
            kinetic = std::max(kinetic, static_cast<double>(world->kinetic_energy()));
        }
        EXPECT_LE(most - begin, 0.01 * (weight_of(scene) + kinetic)) << run_i << ", " << rate << " Hz";
    }
}

/// Ties act in one line on both of their bodies.
TEST(Ties, keep_the_momentum_of_what_floats) {
    RandomInput random(3);
    for (int run_i = 0; run_i < ingot_reference::draws(80); ++run_i) {
        const double rate = rates[random.integer(1, 4)];
        Net drawn = drawn_net(random, run_i);
        drawn.tied = false;
        FigureScene scene = net(random, drawn);
        scene.g = Vector3d::Zero();
        const auto world = std::make_unique<TiedWorld>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound);
        const auto p_of = [&] { return ingot_reference::to_eigen(world->linear_momentum()); };
        const auto L_of = [&] { return ingot_reference::to_eigen(world->angular_momentum()); };
        ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
        const Vector3d p = p_of(), L = L_of();
        double size = 0, r = 0;  // of the momenta that roundings are of
        for (const ingot::BodyId id : built.bodies) {
            size += static_cast<double>(world->mass(id).value) * (1 + ingot_reference::to_eigen(world->state(id).value.v_CM).norm());
            r = std::max(r, ingot_reference::to_eigen(world->state(id).value.r_CM).norm());
        }
        for (int step_i = 0; step_i < static_cast<int>(2 * rate); ++step_i)
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
        const double rounding = 64 * std::sqrt(2 * rate) * eps * size * 10;
        EXPECT_LE((p_of() - p).norm(), rounding) << run_i << ", " << rate << " Hz";
        EXPECT_LE((L_of() - L).norm(), (2 + r) * rounding + 2e-3 * size) << run_i << ", " << rate << " Hz";
    }
}

/// Bodies on rods and ropes that are thrown apart: the first velocities are, of all that ties and joints allow, those nearest to what they were, in
/// kinetic energy; ropes pull alone. In so short a step nothing turns.
TEST(Ties, velocities_are_the_nearest_that_they_allow) {
    RandomInput random(4);
    for (int run_i = 0; run_i < ingot_reference::draws(80); ++run_i) {
        const double h = INGOT_DOUBLE ? 1e-6 : 1e-3;
        Net drawn = drawn_net(random, run_i);
        drawn.ropes = 0;
        FigureScene scene = net(random, drawn);
        scene.g = Vector3d::Zero();
        for (FigureJoint& joint : scene.joints)  // ropes that are just taut
            if (joint.kind == FigureJointKind::distance && random.integer(0, 1) == 0) joint.least = 0;
        if (run_i % 2 == 0) scene.join(parallel(random, drawn));
        const auto world = std::make_unique<TiedWorld>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound);
        const JointRows rows(scene);
        const FigureState start = state_of(*world, built);
        std::vector<StepRow> locked;
        for (int joint_i = 0; joint_i < scene.joint_count(); ++joint_i)
            for (const StepRow& row : locked_rows(rows, start, joint_i, JointTarget{})) locked.push_back(row);
        const StepSolution solution = solve_step(step_bodies(scene, start), locked);
        const FigureState exact = with_velocities(start, solution);
        ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(h)).clean());
        const FigureState state = state_of(*world, built);
        // As of loops; and what roundings of the exact impulses are, which redundant rows may hold against each other without a bound: on 1 kg and
        // more, whose least moment of inertia is a hundredth of that.
        double most = 0;
        for (const double j : solution.impulse) most = std::max(most, std::abs(j));
        const double allowed = 100 * h + 64 * eps / h + 2.2e-14 * most;
        for (int body_i = 0; body_i < scene.body_count(); ++body_i) {
            EXPECT_LE((state.body(body_i).v_CM - exact.body(body_i).v_CM).norm(), allowed) << run_i << ", body " << body_i;
            EXPECT_LE((state.body(body_i).omega - exact.body(body_i).omega).norm(), 10 * allowed) << run_i << ", body " << body_i;
        }
    }
}

/// A ball on a rod is a point: its tables, to second order. A substep moves bodies by the velocities of its end, so it starts with that of half a
/// substep earlier.
TEST(Ties, a_rod_is_a_pendulum) {
    for (const char* name : {"conical_perturbed", "near_planar", "over_the_top"}) {
        const PendulumCase pendulum = spherical_pendulum_case(name);
        const ingot_reference::CsvTable parameters("spherical_pendulum_params.csv");
        const std::size_t row = parameters.row_with("case", name);
        const double gravity = parameters.number(row, "g"), l = parameters.number(row, "l");
        const auto error_at = [&](double rate) {
            const auto point_of = [](const PendulumSample& sample) -> Vector3d { return Eigen::Map<const Vector3d>(sample.coordinates.data()); };
            const std::vector<double>& start = pendulum.samples[0].coordinates;
            FigureScene scene;
            scene.g = Vector3d(0, 0, -gravity);
            FigureBody ball = sphere(2, 0.1, point_of(pendulum.samples[0]));
            const Vector3d v(start[3], start[4], start[5]), n = ball.r_CM / l;
            const Vector3d a = scene.g - n * (v.squaredNorm() / l + scene.g.dot(n));
            ball.v_CM = v - a * (0.5 / (rate * Tied::effort.substeps));
            scene.add(ball);
            scene.join(tie(the_world, 0, Vector3d::Zero(), ball.r_CM));
            const auto world = std::make_unique<StrungWorld>();
            const Built built = add_scene(*world, scene);
            EXPECT_TRUE(built.sound);
            double worst = 0;
            int step_i = 0;
            for (const PendulumSample& sample : pendulum.samples) {
                if (sample.t > 2) break;
                for (; step_i < static_cast<int>(std::lround(sample.t * rate)); ++step_i)
                    EXPECT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
                worst = std::max(worst, (state_of(*world, built).body(0).r_CM - point_of(sample)).norm());
            }
            return worst;
        };
        const double coarse = error_at(64), fine = error_at(128);
        std::printf("    %-18s %.2e m at 64 Hz, %.2e at 128\n", name, coarse, fine);
        EXPECT_LE(fine, coarse / 3 + 1e4 * eps) << name;
        EXPECT_LE(fine, 2e-3) << name;
    }
}

/// rad, between the axes of a parallel joint.
double tilt_of(const FigureJoint& joint, const FigureScene& scene, const FigureState& state) {
    const auto axis_of = [&](int body_i) -> Vector3d {
        return body_i == the_world ? joint.axis_A : state.body(body_i).A() * (scene.body(body_i).A.transpose() * joint.axis_A);
    };
    return axis_of(joint.body_A).cross(axis_of(joint.body_B)).norm();
}

/// Axes stay along each other, of bodies by themselves, of nets, and against the world, and places are free: what falls alone falls as it would.
TEST(Ties, axes_stay_parallel) {
    RandomInput random(7);
    double worst = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(80); ++run_i) {
        const double rate = rates[random.integer(0, 4)];
        const Net drawn = drawn_net(random, run_i);
        FigureScene scene = net(random, drawn);
        scene.join(parallel(random, drawn));
        const int alone = scene.add(box(3, Vector3d(0.3, 0.2, 0.1), Vector3d(0, 50, 0), random.rotation()));
        scene.body(alone).omega = random.vector(3);
        scene.body(alone).v_CM = random.vector(3);
        const Vector3d axis = random.direction();
        scene.join(joint_of(FigureJointKind::parallel, the_world, alone, Vector3d::Zero(), axis, axis));
        const auto world = std::make_unique<TiedWorld>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound) << run_i;
        for (int step_i = 0; step_i < static_cast<int>(rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean()) << run_i;
            const FigureState state = state_of(*world, built);
            for (const FigureJoint& joint : scene.joints)
                if (joint.kind == FigureJointKind::parallel) worst = std::max(worst, tilt_of(joint, scene, state));
        }
        const FigureState state = state_of(*world, built);
        const Vector3d fallen = scene.body(alone).r_CM + scene.body(alone).v_CM + Vector3d(0, 0, -g / 2);
        const double h = 1 / (rate * Tied::effort.substeps);  // a substep moves by the velocity of its end
        EXPECT_LE((state.body(alone).r_CM - fallen).norm(), g * h + 1e3 * eps * 50) << run_i;
    }
    std::printf("    %.2e rad at most\n", worst);
    EXPECT_LE(worst, held);
}

/// Hung on a rope a ball goes as on a rod, while the rope is taut.
TEST(Ties, a_taut_rope_is_a_rod) {
    for (const double rate : rates) {
        std::unique_ptr<StrungWorld> worlds[2];
        Built built[2];
        for (const int is_rod : {0, 1}) {
            FigureScene scene;
            scene.add(sphere(1, 0.1, Vector3d(0.8, 0, -0.6)));
            scene.join(tie(the_world, 0, Vector3d::Zero(), scene.body(0).r_CM, 1, is_rod == 1));
            worlds[is_rod] = std::make_unique<StrungWorld>();
            built[is_rod] = add_scene(*worlds[is_rod], scene);
        }
        for (int step_i = 0; step_i < static_cast<int>(2 * rate); ++step_i)
            for (const auto& world : worlds) ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
        // A rope that is too short by a rounding is not pushed apart, so ends are off by what pushes leave, and by what that makes of the way.
        const double off = (state_of(*worlds[0], built[0]).body(0).r_CM - state_of(*worlds[1], built[1]).body(0).r_CM).norm();
        EXPECT_LE(off, tied_gap * 2 * rate) << rate;
    }
}

/// A rope that is slack is not there, to the bit: bodies fly, and trees of joints swing, as without it.
TEST(Ties, a_slack_rope_is_nothing) {
    RandomInput random(5);
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i) {
        const double rate = rates[random.integer(0, 4)];
        Net drawn = drawn_net(random, run_i);
        drawn.ropes = 0;
        FigureScene without = net(random, drawn), with = without;
        for (int i = random.integer(1, 6); i > 0; --i) {
            const int A = random.integer(-1, drawn.bodies - 1), B = random.integer(0, drawn.bodies - 1);
            if (A == B) continue;
            FigureJoint rope = tie(A, B, Vector3d(random.vector(3)), Vector3d(random.vector(3)), 1, false);
            rope.most = 100;  // m
            with.join(rope);
        }
        with.add(without.body(0));  // and one that has nothing else
        without.add(without.body(0));
        with.join(tie(the_world, drawn.bodies, Vector3d::Zero(), with.body(drawn.bodies).r_CM, 100 / with.body(drawn.bodies).r_CM.norm(), false));
        const auto plain = std::make_unique<TiedWorld>(), roped = std::make_unique<TiedWorld>();
        const Built of_plain = add_scene(*plain, without), of_roped = add_scene(*roped, with);
        ASSERT_TRUE(of_plain.sound && of_roped.sound);
        for (int step_i = 0; step_i < static_cast<int>(rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*plain, static_cast<scalar>(1 / rate)).clean());
            ASSERT_TRUE(ingot::step(*roped, static_cast<scalar>(1 / rate)).clean());
        }
        EXPECT_TRUE(are_same(*plain, *roped, of_plain.bodies, of_roped.bodies)) << run_i << ", " << rate << " Hz";
    }
}

/// A ball falls to the end of its rope, which takes the speed along itself and leaves that across: as the exact motion has it. Where in a substep the
/// end is met is known to a substep; so is the speed.
TEST(Ties, a_rope_comes_taut) {
    for (const double rate : {60.0, 240.0, 1000.0}) {
        FigureScene scene;
        scene.add(sphere(2, 0.1, Vector3d(0.6, 0, 0)));
        FigureJoint rope = tie(the_world, 0, Vector3d::Zero(), scene.body(0).r_CM, 1, false);
        rope.most = 1;
        scene.join(rope);
        const auto world = std::make_unique<StrungWorld>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound);
        ConstrainedReference exact(scene);
        double before = energy_of(*world, built);
        for (int step_i = 0; step_i < static_cast<int>(0.6 * rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
            const double now = energy_of(*world, built);
            // A fall is given as speed at the end of a substep, which has not lowered the ball yet.
            EXPECT_LE(now - before, 2 * g * 5 / (rate * Tied::effort.substeps)) << rate << " Hz, step " << step_i;
            before = now;
            EXPECT_LE(worst_gap(*world, built), tied_gap) << rate << " Hz, step " << step_i;
        }
        exact.advance_to(0.6);
        const double off = (state_of(*world, built).body(0).r_CM - exact.state().body(0).r_CM).norm();
        std::printf("    %g Hz: %.2e m off\n", rate, off);
        EXPECT_LE(off, 5 / (rate * Tied::effort.substeps));  // at 5 m/s
    }
}

/// Balls that float asleep on slack ropes, and one that is thrown, again and again: what it pulls at wakes, and no impulse goes to what sleeps.
TEST(Ties, a_rope_that_comes_taut_wakes) {
    RandomInput random(7);
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        const double rate = rates[random.integer(0, 4)];
        FigureScene scene;
        scene.g.setZero();
        const int count = random.integer(2, 12);
        for (int i = 0; i < count; ++i) {
            scene.add(sphere(random.real(0.5, 5), 0.1, Vector3d(2 * i, 0, 0) + random.vector(0.5)));
            for (int ropes = random.integer(1, 2); i > 0 && ropes > 0; --ropes) {
                const int other = random.integer(0, i - 1);
                scene.join(tie(other, i, scene.body(other).r_CM, scene.body(i).r_CM, random.real(1.02, 1.4), false));
            }
        }
        const auto world = std::make_unique<ingot::World<StrungAsleep>>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound);
        const auto h = static_cast<scalar>(1 / rate);
        for (int step_i = 0; step_i < rate; ++step_i) ASSERT_TRUE(ingot::step(*world, h).clean());
        ASSERT_EQ(world->asleep_count(), count) << run_i;
        Vector3d momentum = Vector3d::Zero();
        for (int throw_i = 0; throw_i < 4; ++throw_i) {
            const Vector3d j = random.vector(1);
            const ingot::BodyId thrown = built.bodies[static_cast<std::size_t>(random.integer(0, count - 1))];
            ASSERT_EQ(world->apply_impulse(thrown, to_vector(j), world->state(thrown).value.r_CM), Status::ok);
            momentum += j;
            for (int step_i = 0; step_i < 2 * rate; ++step_i) {
                ASSERT_TRUE(ingot::step(*world, h).clean());
                ASSERT_LE(worst_gap(*world, built), tied_gap) << run_i << ", " << rate << " Hz";
            }
            Vector3d now = Vector3d::Zero();
            double moved = 0;  // kg m/s, in all: a rounding of it is lost in each substep
            for (const ingot::BodyId id : built.bodies) {
                const Vector3d p = static_cast<double>(world->mass(id).value) * ingot_reference::to_eigen(world->state(id).value.v_CM);
                now += p;
                moved += p.norm();
            }
            const double substeps = 2 * rate * StrungAsleep::effort.substeps;
            EXPECT_LE((now - momentum).norm(), substeps * 4 * eps * (moved + momentum.norm())) << run_i << ", " << throw_i;
        }
    }
}

/// Alone as beside others, to the bit, in whatever slots and lanes.
TEST(Ties, take_no_notice_of_others) {
    for (int run_i = 0; run_i < ingot_reference::draws(24); ++run_i) {
        RandomInput random(static_cast<uint64_t>(100 + run_i)), others(static_cast<uint64_t>(run_i));
        const FigureScene scene = net(random, {4, 2, 10, run_i % 2 == 0, 0.4, 0.3});
        const auto alone = std::make_unique<TiedWorld>(), beside = std::make_unique<TiedWorld>();
        const FigureScene first = net(others, {5, 1, 10, run_i % 3 == 0, 0.4, 0.3}), last = net(others, {6, 1, 10, true, 0, 0.3});
        ASSERT_TRUE(add_scene(*beside, first).sound);
        const Built of_alone = add_scene(*alone, scene), of_beside = add_scene(*beside, scene);
        ASSERT_TRUE(of_alone.sound && of_beside.sound && add_scene(*beside, last).sound);
        for (int step_i = 0; step_i < 60; ++step_i) {
            (void)ingot::step(*alone, scalar(1) / 60);
            (void)ingot::step(*beside, scalar(1) / 60);
        }
        ASSERT_TRUE(are_same(*alone, *beside, of_alone.bodies, of_beside.bodies)) << run_i;
    }
}

}  // namespace
