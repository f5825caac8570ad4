// SPDX-License-Identifier: MIT
// The reference of constrained motion itself: tables of 32 digits in minimal coordinates, closed forms, what is kept. Nothing here is the kernel.
//
// Bar: each step errs by up to 1e-13 of a coordinate; some hundred steps of a motion that multiplies errors a hundredfold make 1e-10.
#include "joints/constrained_reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "joints/figure_scenes.h"
#include "joints/pendulum_tables.h"
#include "reference/measure.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_figures;

constexpr double bar = 1e-10;

/// Largest errors along a case, of the reference with a tolerance.
double error_along(const PendulumCase& pendulum, double tolerance) {
    ConstrainedReference reference(pendulum.scene, tolerance);
    double worst = 0;
    for (const PendulumSample& sample : pendulum.samples) {
        reference.advance_to(sample.t);
        const PendulumCase::Error error = pendulum.error(sample, reference.state());
        worst = std::max({worst, error.position, error.rate});
        EXPECT_LE(worst_gap(reference.rows(), reference.state()), 1e-14);
        EXPECT_NEAR(reference.energy(), pendulum.energy, 1e-12 * std::max(1.0, std::abs(pendulum.energy)) + 30 * tolerance) << sample.t;
    }
    return worst;
}

void expect_table(const char* name, const PendulumCase& pendulum) {
    const double error = error_along(pendulum, 1e-13);
    std::printf("    %-18s %.1e\n", name, error);
    EXPECT_LE(error, bar) << name;
}

/// Where errors are multiplied a millionfold the motion is as good as its tolerance: a hundred times that is ten times worse at least.
void expect_chaotic_table(const char* name, const PendulumCase& pendulum) {
    const double error = error_along(pendulum, 1e-13), loose = error_along(pendulum, 1e-11);
    std::printf("    %-18s %.1e, with a tolerance of 1e-11 %.1e\n", name, error, loose);
    EXPECT_LE(error, loose / 10) << name;
    EXPECT_LE(error, 1e-3) << name;
}

TEST(ConstrainedReference, planar_pendulum_of_the_table) {
    expect_table("small", planar_pendulum_case("small"));
    expect_table("large", planar_pendulum_case("large"));
    expect_chaotic_table("near_top", planar_pendulum_case("near_top"));
}

TEST(ConstrainedReference, spherical_pendulum_of_the_table) {
    for (const char* name : {"conical_perturbed", "near_planar", "over_the_top"}) expect_table(name, spherical_pendulum_case(name));
}

TEST(ConstrainedReference, double_parallel_pendulum_of_the_table) {
    expect_table("swing", double_parallel_pendulum_case("swing"));
    expect_table("heavy_tip", double_parallel_pendulum_case("heavy_tip"));
    expect_chaotic_table("chaotic_short", double_parallel_pendulum_case("chaotic_short"));
}

TEST(ConstrainedReference, double_perpendicular_pendulum_of_the_table) {
    expect_table("swing", double_perpendicular_pendulum_case("swing"));
    expect_chaotic_table("energetic", double_perpendicular_pendulum_case("energetic"));
}

TEST(ConstrainedReference, tops_of_the_table) {
    for (const char* name : {"regular_slow", "cuspidal", "looping"}) {
        const ingot_reference::TopCase top(name);
        ConstrainedReference reference(top_of_table(top));
        double worst = 0;
        for (const auto& sample : top.samples) {
            reference.advance_to(static_cast<double>(sample.t));
            worst = std::max(worst, ingot_reference::attitude_error(reference.state().body(0).A(), sample.A));
        }
        std::printf("    %-18s %.1e rad\n", name, worst);
        EXPECT_LE(worst, 1e-8) << name;  // 25..35 rad/s for 20 s: 1e-11 rad a turn
    }
}

/// S9: tilt and precession stay, and the pivot carries what the centre's way asks for.
TEST(ConstrainedReference, heavy_top_precesses_steadily) {
    const double precession = top_precession();
    EXPECT_NEAR(precession, 1.1479, 5e-5);  // published
    ConstrainedReference reference(heavy_top());
    const double arm = 0.3;
    for (double t = 0.25; t <= 10; t += 0.25) {
        reference.advance_to(t);
        const Vector3d axis = reference.state().body(0).A().col(2);
        EXPECT_NEAR(std::acos(axis.z()), pi / 6, bar);
        EXPECT_NEAR(std::remainder(std::atan2(axis.y(), axis.x()) - precession * t, 2 * pi), 0, bar);
        const Vector3d inward(-axis.x(), -axis.y(), 0);
        const Vector3d force = arm * precession * precession * inward + Vector3d(0, 0, 9.81);
        EXPECT_LE((reference.loads()[0].force - force).norm(), 1e-8);
    }
    EXPECT_NEAR(reference.energy(), energy(reference.rows(), start_of(heavy_top())), 1e-13 * 136 * 100);
}

/// Tension of a pendulum: m (g cos theta + c theta'^2) along, m (g sin theta + c theta'') across.
TEST(ConstrainedReference, a_hinge_carries_what_its_pendulum_needs) {
    const double k = 9.8125, c = 0.5;
    ConstrainedReference reference(planar_pendulum(k, 2.5));
    for (double t = 0.1; t < 3; t += 0.1) {
        reference.advance_to(t);
        const BodyMotion& body = reference.state().body(0);
        const double theta = turned_about_y(body.A()), rate = body.omega.y();
        const Vector3d along = -body.r_CM / c, across = along.cross(Vector3d::UnitY());  // towards the hinge; against the motion
        const JointLoad load = reference.loads()[0];
        EXPECT_NEAR(load.force.dot(along), k * std::cos(theta) + c * rate * rate, bar * 40);
        EXPECT_NEAR(load.force.dot(across), k * std::sin(theta) - c * k * std::sin(theta), bar * 40);
        EXPECT_NEAR(load.force.y(), 0, bar);
        EXPECT_LE(load.torque.norm(), bar);
        EXPECT_TRUE(load.determined);
    }
}

/// Free figures keep momentum and angular momentum; all keep energy.
TEST(ConstrainedReference, free_figures_keep_momentum_and_energy) {
    RagdollOptions free;
    free.limits = false;
    std::vector<FigureScene> scenes{floating_chain(20), mixed_tree(true, 2), ragdoll_20(free)};
    for (FigureScene& scene : scenes) {
        scene.g.setZero();
        if (scene.joint(0).body_A == the_world) scene.joints.erase(scene.joints.begin());
        ingot_reference::RandomInput random(7);
        for (FigureBody& body : scene.bodies) body.omega += random.vector(3);
        hold_joints(scene);
        add_motion(scene, Vector3d(0.3, -0.2, 0.1), Vector3d(0.1, 0.5, 0.2));
        ConstrainedReference reference(scene);
        const FigureState start = reference.state();
        const double E = reference.energy(), p = momentum(scene, start).norm(), L = angular_momentum(scene, start).norm();
        reference.advance_to(1);
        const FigureState& end = reference.state();
        std::printf("    %-16s energy %.1e, momentum %.1e, angular momentum %.1e, of themselves\n", scene.name.c_str(), reference.energy() / E - 1,
                    (momentum(scene, end) - momentum(scene, start)).norm() / p,
                    (angular_momentum(scene, end) - angular_momentum(scene, start)).norm() / L);
        EXPECT_NEAR(reference.energy(), E, bar * E);
        EXPECT_LE((momentum(scene, end) - momentum(scene, start)).norm(), 1e-12 * std::max(p, 1.0));
        EXPECT_LE((angular_momentum(scene, end) - angular_momentum(scene, start)).norm(), 1e-11 * std::max(L, 1.0));
        EXPECT_LE(worst_gap(reference.rows(), end), 1e-13);
        EXPECT_LE(worst_misalignment(reference.rows(), end), 1e-13);
        EXPECT_LE(inadmissible_share(reference.rows(), end), 1e-20);
    }
}

/// S5, whose geometric stiffness is of some hundred rad/s: energy, and the table that was made with a tolerance ten times less.
TEST(ConstrainedReference, chain_swings_as_in_its_table) {
    const ingot_reference::CsvTable table(INGOT_REFERENCE_DIR "/../joints", "chain_s5.csv");
    ConstrainedReference reference(chain(), 1e-12);
    double worst = 0;
    for (std::size_t row = 0; table.number(row, "t") <= 2; ++row) {
        reference.advance_to(table.number(row, "t"));
        const Vector3d link(table.number(row, "x10"), 0, table.number(row, "z10")), ball(table.number(row, "x21"), 0, table.number(row, "z21"));
        worst = std::max({worst, (reference.state().body(9).r_CM - link).norm(), (reference.state().body(20).r_CM - ball).norm()});
        EXPECT_LE(worst_gap(reference.rows(), reference.state()), 1e-13);
    }
    std::printf("    chain of 20: %.1e m, energy %.1e J\n", worst, reference.energy());
    EXPECT_LE(worst, bar);
    EXPECT_NEAR(reference.energy(), 0, 1e-11 * 11e3);
}

double angle_about(const Matrix3d& R, const Matrix3d& A) {  // of a bar in the plane of a four-bar turned by R
    const Vector3d e = R.transpose() * A.col(2);
    return std::atan2(e.z(), e.x());
}

/// Loops of spatial hinges: three rows too many, or nine where two hinges are doubled. The plane leans, so that nothing is zero by luck.
TEST(ConstrainedReference, four_bar_keeps_to_its_closed_form) {
    const Matrix3d R = rotation_by(Vector3d(0.3, 0.5, 0.7)).toRotationMatrix();
    ConstrainedReference once(four_bar(false, 1, 3, R)), twice(four_bar(true, 1, 3, R));
    const double E = once.energy();
    double worst = 0, turned = 0, last = 1;
    for (double t = 0.05; t <= 2; t += 0.05) {
        once.advance_to(t);
        twice.advance_to(t);
        const double crank = angle_about(R, once.state().body(0).A());
        turned += std::abs(std::remainder(crank - last, 2 * pi));
        last = crank;
        const FourBarPose pose = four_bar_pose(crank);
        worst = std::max(worst, std::abs(std::remainder(angle_about(R, once.state().body(1).A()) - pose.coupler, 2 * pi)));
        worst = std::max(worst, std::abs(std::remainder(angle_about(R, -once.state().body(2).A()) - pose.rocker, 2 * pi)));
        for (int body_i = 0; body_i < 3; ++body_i) worst = std::max(worst, (once.state().body(body_i).r_CM - twice.state().body(body_i).r_CM).norm());
    }
    std::printf("    four-bar: crank turned %.1f rad, off the closed form and the doubled one by %.1e\n", turned, worst);
    EXPECT_GT(turned, 5);
    EXPECT_LE(worst, bar);
    EXPECT_NEAR(once.energy(), E, bar);
    EXPECT_NEAR(twice.energy(), E, bar);
    EXPECT_LE(worst_misalignment(twice.rows(), twice.state()), 1e-13);
    for (const JointLoad& load : twice.loads()) EXPECT_FALSE(load.determined);
}

TEST(ConstrainedReference, a_door_swings_alike_on_any_number_of_hinges) {
    ConstrainedReference one(door(1)), two(door(2)), three(door(3));
    for (ConstrainedReference* reference : {&one, &two, &three}) reference->advance_to(2);
    EXPECT_LE(one.state().body(0).q.angularDistance(two.state().body(0).q), bar);
    EXPECT_LE(one.state().body(0).q.angularDistance(three.state().body(0).q), bar);
    EXPECT_TRUE(one.loads()[0].determined);
    EXPECT_FALSE(three.loads()[1].determined);
    Vector3d sum = Vector3d::Zero();
    for (const JointLoad& load : three.loads()) sum += load.force;
    EXPECT_LE((sum - one.loads()[0].force).norm(), 1e-8);

    // Upright and at rest: the shortest multipliers share the weight, 98.1 N, alike.
    ConstrainedReference upright(door(3, 0));
    for (const JointLoad& load : upright.loads()) EXPECT_NEAR(load.force.z(), 98.1 / 3, 1e-9);
}

/// Four hinges in space that count says cannot move; tan(1/2) tan(2/2) of two neighbours is constant.
TEST(ConstrainedReference, bennett_loop_moves) {
    ConstrainedReference reference(bennett_loop());
    const double E = reference.energy();
    const FigureState start = reference.state();
    double way = 0;
    for (double t = 0.05; t <= 1; t += 0.05) {
        const Vector3d before = reference.state().body(1).r_CM;
        reference.advance_to(t);
        way += (reference.state().body(1).r_CM - before).norm();
        const double first = 1 + measured(reference.rows(), reference.state(), 0, FigureMeasure::angle);
        const double constant = std::sin(55 * pi / 180) / std::sin(15 * pi / 180);
        const double second = 2 * std::atan(constant / std::tan(0.5)) + measured(reference.rows(), reference.state(), 1, FigureMeasure::angle);
        EXPECT_NEAR(std::tan(first / 2) * std::tan(second / 2), constant, bar * 10);
        EXPECT_LE(worst_gap(reference.rows(), reference.state()), 1e-13);
    }
    EXPECT_GT(way, 0.5);
    EXPECT_NEAR(reference.energy(), E, bar);
    for (const JointLoad& load : reference.loads()) EXPECT_FALSE(load.determined);
}

TEST(ConstrainedReference, slider_crank_passes_dead_centres) {
    ConstrainedReference reference(slider_crank());
    const double E = reference.energy();
    int dead_centres = 0;
    double last = 1;
    for (double t = 0.005; t <= 0.5; t += 0.005) {
        reference.advance_to(t);
        const Vector3d arm = reference.state().body(0).A().col(2);
        const double crank = std::atan2(arm.z(), arm.x());
        const Vector3d piston = reference.state().body(2).r_CM;
        EXPECT_LE((piston - Vector3d(piston_position(crank), 0, 0)).norm(), 1e-13);
        if (std::sin(crank) * last < 0) ++dead_centres;
        last = std::sin(crank);
    }
    EXPECT_GE(dead_centres, 7);
    EXPECT_NEAR(reference.energy(), E, bar * E);
}

/// J x'' = -k x - c x': the frequency and decay of a hinge with spring and damper.
TEST(ConstrainedReference, a_spring_on_a_hinge_has_its_frequency) {
    const double J = 0.05, k = 20;
    for (const double ratio : {0.0, 0.1, 0.7}) {
        const double w = std::sqrt(k / J), decay = ratio * w, w_d = w * std::sqrt(1 - ratio * ratio);
        ConstrainedReference reference(spring_rotor(J, k, 2 * ratio * w * J, 1));
        for (double t = 0.02; t < 1; t += 0.02) {
            reference.advance_to(t);
            const double x = std::exp(-decay * t) * (std::cos(w_d * t) + decay / w_d * std::sin(w_d * t));
            EXPECT_NEAR(measured(reference.rows(), reference.state(), 0, FigureMeasure::angle) + 1, x, bar);
        }
    }
}

/// A car stands on suspensions that carry it, in the air of nothing but them: wheels fixed, chassis at rest.
TEST(ConstrainedReference, suspensions_carry_their_quarter) {
    FigureScene scene = car(20, 0);
    for (FigureJoint& joint : scene.joints) scene.body(joint.body_B).M = 0;
    ConstrainedReference reference(scene);
    reference.advance_to(0.5);
    EXPECT_LE((reference.state().body(1).r_CM - scene.body(1).r_CM).norm(), bar);
}

/// Gears: rates in their ratio, and what one loses the other gains through the gear alone.
TEST(ConstrainedReference, gears_turn_in_their_ratio) {
    FigureScene scene = rotor_on_base(1e-2, 0, 0, 0);
    scene.bodies.erase(scene.bodies.begin());
    scene.joint(0) = hinge(the_world, 0, scene.body(0).r_CM, Vector3d::UnitZ());
    FigureBody other = scene.body(0);
    other.r_CM = Vector3d(1, 0, 0);
    const int body = scene.add(other);
    scene.join(hinge(the_world, body, other.r_CM, Vector3d::UnitX()));
    scene.joint(1).servo.stiffness = 1;
    FigureJoint gear;
    gear.kind = FigureJointKind::gear;
    gear.body_B = body;
    gear.gear_1 = 0;
    gear.gear_2 = 1;
    gear.gear_ratio = 2;
    scene.join(gear);
    set_rate(scene, 0, 6);
    ConstrainedReference reference(scene);
    const double E = reference.energy();
    // The second turns with moment I_x + 2^2 I_z seen through the gear.
    const double J = other.I_body.x() + 4 * other.I_body.z(), w = std::sqrt(1 / J);
    for (double t = 0.05; t < 0.5; t += 0.05) {
        reference.advance_to(t);
        const double first = measured_rate(reference.rows(), reference.state(), 0, FigureMeasure::angle);
        const double second = measured_rate(reference.rows(), reference.state(), 1, FigureMeasure::angle);
        EXPECT_NEAR(first, -2 * second, bar);
        EXPECT_NEAR(second, -3 * std::cos(w * t), bar * 10);
    }
    EXPECT_NEAR(reference.energy(), E, bar);
}

/// A steered wheel spins about the axle that it is given; the frame of its pivot is turned with it.
TEST(ConstrainedReference, steering_turns_the_axle) {
    FigureScene scene = car(20, 0, 0.4);
    scene.body(1).M = 0;
    ConstrainedReference reference(scene);
    reference.advance_to(1);
    const Vector3d axle = reference.rows().axis_B(reference.state(), 0);
    EXPECT_LE((axle - Vector3d(-std::sin(0.4), std::cos(0.4), 0)).norm(), bar);
}

}  // namespace
