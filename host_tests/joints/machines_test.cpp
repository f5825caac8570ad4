// SPDX-License-Identifier: MIT
// Machines: joints that close loops have limits and drives as others, whichever of them it is that closes one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "joints/constrained_reference.h"
#include "joints/constrained_step_reference.h"
#include "joints/figure_scenes.h"
#include "random_trees.h"
#include "reference/draws.h"
#include "scene_in_world.h"

namespace {

using namespace figures;
using namespace ingot_figures;
using ingot::Status;

struct Workshop : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 28, max_loops = 8;
    static constexpr bool translates = true;
    using joints = AllJointsWith<ingot::WithLimits, ingot::WithDrives>;
};
using WorkshopWorld = ingot::World<Workshop>;

struct LimitedWorkshop : Workshop {
    using joints = AllJointsWith<ingot::WithLimits>;
};

/// A ring of links, each of a mass of its own, on a line that is closed and in no plane, tied to the world or not; a tail hangs on some. Links are
/// thrown about. Joints are balls and hinges, so many balls that the ring can move, and come in any order, so that any of them closes it.
FigureScene thrown_ring(RandomInput& random, double ratio) {
    FigureScene scene;
    scene.g = Vector3d::Zero();
    const int links = random.integer(3, 12);
    const Matrix3d R = random.rotation();
    const auto corner = [&](int i) -> Vector3d {
        const double angle = 2 * pi * i / links;
        return R * Vector3d(std::cos(angle), std::sin(angle), 0.1 * (i % links % 3));
    };
    const auto add = [&](const Vector3d& begin, const Vector3d& end) {
        FigureBody link = capsule(std::exp(random.real(0, std::log(ratio))), 0.05, (end - begin).norm() / 2, (begin + end) / 2, along(end - begin));
        link.v_CM = random.vector(1);
        link.omega = random.vector(1);
        scene.add(link);
    };
    for (int i = 0; i < links; ++i) add(corner(i), corner(i + 1));
    int freedoms = -6;
    for (int i = 0; i < links; ++i) {
        const bool is_ball = random.integer(0, 2) == 0 || freedoms + (links - i) < 2 + i % 2;
        freedoms += is_ball ? 3 : 1;
        const Vector3d P = corner(i + 1);
        scene.join(is_ball ? ball(i, (i + 1) % links, P) : hinge(i, (i + 1) % links, P, random.direction()));
    }
    if (random.integer(0, 1) == 1) scene.join(hinge(the_world, 0, corner(0), random.direction()));
    for (int i = random.integer(0, 2); i > 0; --i) {
        const int link = random.integer(0, links - 1);
        add(corner(link), corner(link) + random.direction());
        scene.join(hinge(link, scene.body_count() - 1, corner(link), random.direction()));
    }
    for (std::size_t i = scene.joints.size() - 1; i > 0; --i)
        std::swap(scene.joints[i], scene.joints[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
    return scene;
}

/// A hinge as its limit or its drive has it, in the substeps of one step.
struct MovingHinge {
    enum { free, limited, driven } kind = free;
    ingot::SpringDrive drive{};
    double angle = 0;  ///< rad, since the step began: of B against A; of a drive, against its target

    /// The row of a substep of h seconds: impulse = -h k (angle + h (rate - target rate)) - h d (rate - target rate), within the torque.
    StepRow row(const FigureJoint& joint, double h) const {
        StepRow row;
        row.row = turn_row(joint.body_A, joint.body_B, joint.axis_A);
        if (kind == limited) {
            row.lower = 0;
            row.target = -angle / h;
            return row;
        }
        const double k = static_cast<double>(drive.stiffness), resist = h * static_cast<double>(drive.damping) + h * h * k;
        row.compliance = 1 / resist;
        row.target = static_cast<double>(drive.target_rate) - h * k * angle / resist;
        if (drive.max_torque < ingot::unlimited) {
            row.upper = h * static_cast<double>(drive.max_torque);
            row.lower = -row.upper;
        }
        return row;
    }
    void go_on(const FigureJoint& joint, const FigureState& state, double h) {
        const auto omega = [&](int body_i) { return body_i == the_world ? Vector3d(Vector3d::Zero()) : state.body(body_i).omega; };
        angle += h * (joint.axis_A.dot(omega(joint.body_B) - omega(joint.body_A)) - (kind == driven ? static_cast<double>(drive.target_rate) : 0));
    }
};

struct Precise : Workshop {
    static constexpr ingot::Effort effort = {2, 4};
};

/// Drives and limits of hinges: the first velocities are those of the dense solution, with compliance and bounds, whichever joints close the ring.
/// In so short a step nothing turns, but for what drives and limits see of it.
TEST(Machines, velocities_are_those_of_the_exact_solution) {
    RandomInput random(1);
    for (int run_i = 0; run_i < ingot_reference::draws(160); ++run_i) {
        const double ratio = run_i % 2 == 0 ? 1 : 100, h = INGOT_DOUBLE ? 1e-6 : 1e-3;
        FigureScene scene = thrown_ring(random, ratio);
        std::vector<MovingHinge> hinges(scene.joints.size());
        for (std::size_t i = 0; i < hinges.size(); ++i) {
            if (scene.joints[i].kind != FigureJointKind::hinge) continue;
            if (random.integer(0, 3) == 0) {
                hinges[i].kind = MovingHinge::limited;
                scene.joints[i].lower = 0;
            } else if (random.integer(0, 1) == 1) {
                // What a substep moves and what it gives are of one size.
                const double R = std::exp(random.real(-3, 3));
                ingot::SpringDrive& drive = hinges[i].drive;
                hinges[i].kind = MovingHinge::driven;
                drive.stiffness = std::min(static_cast<scalar>(random.real(0, 1) * R / (h * h)), ingot::limits::drive_gain_max);
                drive.damping = static_cast<scalar>(R / h);
                drive.target_rate = static_cast<scalar>(random.real(-1, 1));
                if (random.integer(0, 1) == 1) drive.max_torque = static_cast<scalar>(random.real(0, 1) * R / h);
            }
        }
        const auto world = std::make_unique<ingot::World<Precise>>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound);
        for (std::size_t i = 0; i < hinges.size(); ++i)
            if (hinges[i].kind == MovingHinge::driven) {
                ASSERT_EQ(world->set_joint_drive(built.joints[i], hinges[i].drive), Status::ok);
            }
        const JointRows rows(scene);
        FigureState exact = state_of(*world, built);
        for (int substep_i = 0; substep_i < 2; ++substep_i) {
            std::vector<StepRow> asked;
            for (int joint_i = 0; joint_i < scene.joint_count(); ++joint_i) {
                for (const StepRow& row : locked_rows(rows, exact, joint_i, JointTarget{})) asked.push_back(row);
                const MovingHinge& of = hinges[static_cast<std::size_t>(joint_i)];
                if (of.kind != MovingHinge::free) asked.push_back(of.row(scene.joint(joint_i), h / 2));
            }
            const StepSolution solution = solve_step(step_bodies(scene, exact), asked, BoundedBy::pivoting);
            ASSERT_LE(solution.miss, 1e-6) << run_i;
            exact = with_velocities(exact, solution);
            for (std::size_t i = 0; i < hinges.size(); ++i) hinges[i].go_on(scene.joints[i], exact, h / 2);
        }
        ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(h)).clean()) << run_i;
        const FigureState state = state_of(*world, built);
        const double allowed = 100 * h + 64 * eps / h;
        for (int body_i = 0; body_i < scene.body_count(); ++body_i) {
            EXPECT_LE((state.body(body_i).v_CM - exact.body(body_i).v_CM).norm(), allowed) << run_i << ", " << scene.body_count() << " bodies";
            EXPECT_LE((state.body(body_i).omega - exact.body(body_i).omega).norm(), 10 * allowed) << run_i << ", " << scene.body_count() << " bodies";
        }
    }
}

/// The same joints, begun with another: so another closes the loop.
FigureScene begun_with(FigureScene scene, int first) {
    std::rotate(scene.joints.begin(), scene.joints.begin() + first, scene.joints.end());
    return scene;
}
/// Which of the built joints is the one that was joint_i before.
ingot::JointId joint_of_begun(const Built& built, int first, int joint_i) {
    const int count = static_cast<int>(built.joints.size());
    return built.joints[static_cast<std::size_t>((joint_i - first + count) % count)];
}

/// What a limit may be exceeded by, as in JointLimits; loops add what their own rows leave, limits::loop_gap.
constexpr double slack =
    std::max(2 * static_cast<double>(ingot::limits::limit_slack), 1e-6) + static_cast<double>(ingot::limits::loop_gap) + 16 * eps;

TEST(Machines, limits_end_where_they_say) {
    RandomInput random(2);
    for (int run_i = 0; run_i < ingot_reference::draws(120); ++run_i) {
        const FigureScene scene = limited_ring(random, 9, run_i % 3 != 0, 4);
        const double rate = rates[random.integer(0, 4)];
        const JointRows rows(scene);
        const auto world = std::make_unique<ingot::World<LimitedWorkshop>>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound);
        for (int step_i = 0; step_i < static_cast<int>(rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean()) << run_i;
            ASSERT_LE(worst_gap(*world, built), held) << run_i << ", " << rate << " Hz, step " << step_i;
            ASSERT_LE(worst_excess(rows, state_of(*world, built)), slack) << run_i << ", " << rate << " Hz, step " << step_i;
        }
    }
}

/// A motor on the crank of an engine, whichever joint closes its loop: it goes round, through both dead centres, and the piston is where it should
/// be.
TEST(Machines, an_engine_runs_through_its_dead_centres) {
    for (const double rate : rates)
        for (const double speed : {3.0, -20.0})
            for (int first = 0; first < 4; ++first) {
                const FigureScene scene = begun_with(slider_crank(0.3, speed), first);
                const auto world = std::make_unique<WorkshopWorld>();
                const Built built = add_scene(*world, scene);
                ASSERT_TRUE(built.sound);
                const ingot::JointId crank = joint_of_begun(built, first, 0), piston = joint_of_begun(built, first, 3);
                ASSERT_EQ(world->set_joint_drive(crank, ingot::MotorDrive{static_cast<scalar>(speed)}), Status::ok);
                for (int step_i = 1; step_i <= static_cast<int>(2 * rate); ++step_i) {
                    ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
                    const double angle = static_cast<double>(world->joint_angle(crank).value);
                    const double travel = static_cast<double>(world->joint_travel(piston).value);
                    // A motor gives way to its load by 1 / limits::motor_gain, with the inertia that the crank has as the step begins: at a dead
                    // centre a tenth of what it has later.
                    const double gone = speed * step_i / rate;
                    ASSERT_NEAR(angle, gone, (1e-3 + 64 * eps) * std::abs(gone)) << first << ", " << rate << " Hz, step " << step_i;
                    ASSERT_NEAR(travel, piston_position(0.3 + angle) - piston_position(0.3), held) << first << ", " << rate << " Hz, step " << step_i;
                }
            }
}

/// Two hinges in a line are one: what limits or drives the second does to the door what it does to a door on one.
TEST(Machines, a_second_hinge_is_as_good_as_the_first) {
    for (const double rate : rates)
        for (int with = 0; with < 4; ++with) {
            FigureState states[2];
            for (int hinges = 1; hinges <= 2; ++hinges) {
                FigureScene scene = door(hinges);
                if (with == 0) {
                    scene.joints.back().upper = 0.2;
                    scene.joints.back().lower = -0.3;
                    scene.joints.back().restitution = 0.5;
                }
                const auto world = std::make_unique<WorkshopWorld>();
                const Built built = add_scene(*world, scene);
                ASSERT_TRUE(built.sound);
                if (with == 1) {
                    ASSERT_EQ(world->set_joint_drive(built.joints.back(), ingot::SpringDrive{200, 10, scalar(0.3)}), Status::ok);
                }
                if (with == 2) {
                    ASSERT_EQ(world->set_joint_drive(built.joints.back(), ingot::MotorDrive{1, 12}), Status::ok);
                }
                if (with == 3) {
                    ASSERT_EQ(world->set_joint_drive(built.joints.back(), ingot::TunedDrive{2, scalar(0.3)}), Status::ok);
                }
                for (int step_i = 0; step_i < static_cast<int>(rate); ++step_i)
                    ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean()) << rate << " Hz, " << hinges;
                states[hinges - 1] = state_of(*world, built);
            }
            // Roundings of four substeps a step, whose turns add up.
            const double rounding = 4 * rate * 16 * eps * 4;
            EXPECT_LE((states[1].body(0).r_CM - states[0].body(0).r_CM).norm(), rounding) << with << ", " << rate << " Hz";
        }
}

/// A motor of a four-bar is cut at its torque in every step, wherever it is and whichever joint closes the loop; and the energy that the linkage gets
/// is no more than its work.
TEST(Machines, motors_keep_to_their_torque) {
    for (const double rate : rates)
        for (int first = 0; first < 4; ++first)
            for (int driven = 0; driven < 4; ++driven) {
                const FigureScene scene = begun_with(four_bar(), first);
                const auto world = std::make_unique<WorkshopWorld>();
                const Built built = add_scene(*world, scene);
                const JointRows rows(scene);
                const ingot::JointId joint = joint_of_begun(built, first, driven);
                constexpr double torque = 2;
                ASSERT_EQ(world->set_joint_drive(joint, ingot::MotorDrive{3, static_cast<scalar>(torque)}), Status::ok);
                double last = energy(rows, state_of(*world, built)), angle = 0;
                for (int step_i = 0; step_i < static_cast<int>(2 * rate); ++step_i) {
                    ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
                    ASSERT_LE(std::abs(static_cast<double>(world->drive_torque(joint).value)), torque * (1 + 8 * eps));
                    const double now = energy(rows, state_of(*world, built)), turned = static_cast<double>(world->joint_angle(joint).value) - angle;
                    // Second orders of turns are allowed what JointEnergy allows them.
                    ASSERT_LE(now - last, torque * std::abs(turned) + 0.01 * (mass(scene) * g + std::abs(last)))
                        << rate << " Hz, begun with " << first << ", driven " << driven << ", step " << step_i;
                    last = now;
                    angle += turned;
                }
            }
}

/// Saved in the midst of it, machines go on to the same bits.
TEST(Machines, go_on_from_a_snapshot) {
    RandomInput random(5);
    const auto world = std::make_unique<WorkshopWorld>(), other = std::make_unique<WorkshopWorld>();
    const Built built = add_scene(*world, limited_ring(random, 9, true, 4));
    ASSERT_TRUE(built.sound);
    for (const ingot::JointId joint : built.joints) (void)world->set_joint_drive(joint, ingot::SpringDrive{50, 2, scalar(0.4), 0, 0, 5});
    for (int step_i = 0; step_i < 40; ++step_i) (void)ingot::step(*world, scalar(1) / 60);
    std::vector<uint8_t> bytes(ingot::snapshot_size<Workshop>());
    const auto size = ingot::save_snapshot(*world, bytes.data(), bytes.size());
    ASSERT_TRUE(size.ok());
    ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), size.value), Status::ok);
    for (int step_i = 0; step_i < 40; ++step_i) {
        (void)ingot::step(*world, scalar(1) / 60);
        (void)ingot::step(*other, scalar(1) / 60);
        ASSERT_EQ(world->state_hash(), other->state_hash()) << step_i;
    }
}

}  // namespace
