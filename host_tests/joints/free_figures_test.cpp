// SPDX-License-Identifier: MIT
// Figures that swing free by the energy-momentum step: where they go, and what stays as it is, beside a dense solver that shares nothing with it.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "joints/energy_momentum_reference.h"
#include "joints/figure_measures.h"
#include "joints/pendulum_tables.h"
#include "random_trees.h"
#include "reference/draws.h"
#include "scene_in_world.h"

namespace {

using namespace figures;
using namespace ingot_figures;

struct Swinging : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 24;
    static constexpr bool translates = true;
    using joints = AllJoints;
    using figure_motion = ingot::EnergyMomentum<>;
};
struct SwingingByFour : Swinging {
    using figure_motion = ingot::EnergyMomentum<ingot::Snap::keep, 4>;
};
struct SnappingInHeat : Swinging {
    using figure_motion = ingot::EnergyMomentum<ingot::Snap::lose>;
};

/// A figure, and a world of its own.
template <class Scene>
struct FigureWorld {
    ingot::World<Scene> world;
    Built built;

    explicit FigureWorld(const FigureScene& scene) : built(add_scene(world, scene)) {}
    bool sound() const { return built.sound; }
    FigureState state() const { return state_of(world, built); }
};

/// No figure was left to the substeps.
bool is_solved(const ingot::StepReport& report) {
    return report.clean() && (report.figures & (ingot::FigureBits::unsolved | ingot::FigureBits::left_to_substeps)) == 0;
}
template <class Scene>
bool swing(FigureWorld<Scene>& of, double rate) {
    return is_solved(ingot::step(of.world, static_cast<ingot::scalar>(1 / rate)));
}

/// What roundings are measured by.
struct Units {
    double length = 1, momentum = 0, spin = 0, energy = 0;  // m, N s, N m s, J
};
Units units_of(const FigureScene& scene, const FigureState& state) {
    Units units;
    for (const BodyMotion& body : state.bodies) units.length = std::max(units.length, 1 + body.r_CM.norm());
    for (std::size_t body_i = 0; body_i < state.bodies.size(); ++body_i) {
        const FigureBody& body = scene.bodies[body_i];
        const BodyMotion& motion = state.bodies[body_i];
        units.momentum += body.M * motion.v_CM.norm();
        units.spin += body.M * motion.v_CM.norm() * units.length + body.I_body.maxCoeff() * motion.omega.norm();
        units.energy += body.M * scene.g.norm() * units.length;
    }
    units.energy += kinetic_energy(scene, state);
    return units;
}

/// By how much one is off the other: of places and turns, and of what velocities give in a step.
double difference(const FigureState& a, const FigureState& b, double rate) {
    double worst = 0;
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        worst = std::max({worst, (a.bodies[i].r_CM - b.bodies[i].r_CM).norm(), (a.bodies[i].A() - b.bodies[i].A()).norm()});
        worst = std::max({worst, (a.bodies[i].v_CM - b.bodies[i].v_CM).norm() / rate, (a.bodies[i].omega - b.bodies[i].omega).norm() / rate});
    }
    return worst;
}

/// A few roundings of its size for each body on the way from the root.
TEST(FreeFigures, go_where_the_dense_step_goes) {
    double worst = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(80); ++run_i) {
        RandomInput random(static_cast<uint64_t>(run_i) + 1);
        const double rate = rates[random.integer(0, 4)];
        const FigureScene scene = random_tree(random, {random.integer(2, 8), run_i % 2 == 0 ? 1.001 : 1000, random.real(0.1, 4), run_i % 4 < 2});
        FigureWorld<Swinging> of(scene);
        ASSERT_TRUE(of.sound());
        const JointRows rows(scene);
        FigureState state = start_of(scene);
        for (int step_i = 0; step_i < 2; ++step_i) {
            const EnergyMomentumStep step = energy_momentum_step(rows, state, 1 / rate);
            ASSERT_TRUE(step.converged);
            state = step.state;
            ASSERT_TRUE(swing(of, rate)) << run_i;
        }
        const double off = difference(of.state(), state, rate), may = 16 * eps * scene.body_count() * units_of(scene, state).length;
        EXPECT_LE(off, may) << run_i << ", " << rate << " Hz, " << scene.body_count() << " bodies";
        worst = std::max(worst, off / may);
    }
    std::printf("    %.2f of what roundings may do\n", worst);
}

/// A second of any tree: each step adds roundings of what there is, which go up and down.
TEST(FreeFigures, keep_energy_and_momentum_and_stay_joined) {
    double worst_gap_of_all = 0, worst_share = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i) {
        RandomInput random(static_cast<uint64_t>(run_i) + 1000);
        const double rate = rates[random.integer(0, 4)];
        const bool tied = run_i % 4 < 2;
        const FigureScene scene = random_tree(random, {random.integer(2, 12), run_i % 2 == 0 ? 1.001 : 1000, random.real(0.1, 4), tied});
        FigureWorld<Swinging> of(scene);
        ASSERT_TRUE(of.sound());
        const JointRows rows(scene);
        FigureState state = of.state();
        const double E = energy(rows, state);
        const Vector3d p = momentum(scene, state), L = angular_momentum(scene, state);
        Units most = units_of(scene, state);
        for (int step_i = 0; step_i < static_cast<int>(rate); ++step_i) {
            ASSERT_TRUE(swing(of, rate)) << run_i << ", step " << step_i;
            state = of.state();
            const Units units = units_of(scene, state);
            most = {std::max(most.length, units.length), std::max(most.momentum, units.momentum), std::max(most.spin, units.spin),
                    std::max(most.energy, units.energy)};
            ASSERT_LE(worst_gap(rows, state), 4 * eps * units.length) << run_i << ", step " << step_i;
            ASSERT_LE(worst_misalignment(rows, state), 8 * eps) << run_i << ", step " << step_i;
            worst_gap_of_all = std::max(worst_gap_of_all, worst_gap(rows, state));
        }
        const double rounding = 64 * std::sqrt(rate) * eps;
        EXPECT_NEAR(energy(rows, state), E, rounding * most.energy) << run_i << ", " << rate << " Hz";
        worst_share = std::max(worst_share, std::abs(energy(rows, state) - E) / most.energy);
        if (tied) continue;
        EXPECT_LE((momentum(scene, state) - p).norm(), rounding * most.momentum) << run_i;
        EXPECT_LE((angular_momentum(scene, state) - L).norm(), rounding * most.spin) << run_i;
    }
    std::printf("    energy to %.1e, gaps to %.1e m\n", worst_share, worst_gap_of_all);
}

/// Largest error at the samples of a table until t_end.
template <class Scene>
double error_of(const PendulumCase& pendulum, int rate, double t_end) {
    FigureWorld<Scene> of(pendulum.scene);
    double worst = 0;
    std::size_t sample_i = 0;
    for (int step_i = 0; step_i <= std::lround(t_end * rate); ++step_i) {
        const double t = static_cast<double>(step_i) / rate;
        while (pendulum.samples[sample_i].t < t - 1e-9) ++sample_i;
        if (std::abs(pendulum.samples[sample_i].t - t) < 1e-9)
            worst = std::max(worst, pendulum.error(pendulum.samples[sample_i], of.state()).position);
        EXPECT_TRUE(swing(of, rate));
    }
    return worst;
}
template <class Scene>
void expect_order(const char* name, const PendulumCase& pendulum, double t_end, double order) {
    const double coarse = error_of<Scene>(pendulum, 64, t_end), fine = error_of<Scene>(pendulum, 128, t_end);
    std::printf("    %-22s 64 Hz %.2e rad, 128 Hz %.2e, slope %.2f\n", name, coarse, fine, std::log2(coarse / fine));
    EXPECT_NEAR(std::log2(coarse / fine), order, 0.2) << name;
}

TEST(FreeFigures, have_order_2_and_by_composition_4) {
    expect_order<Swinging>("planar large", planar_pendulum_case("large"), 8, 2);
    expect_order<Swinging>("parallel swing", double_parallel_pendulum_case("swing"), 4, 2);
    expect_order<Swinging>("perpendicular swing", double_perpendicular_pendulum_case("swing"), 4, 2);
    if (!INGOT_DOUBLE) return;  // errors of order 4 are below the roundings of float
    expect_order<SwingingByFour>("planar large, 4", planar_pendulum_case("large"), 8, 4);
    expect_order<SwingingByFour>("parallel swing, 4", double_parallel_pendulum_case("swing"), 4, 4);
    expect_order<SwingingByFour>("perpendicular swing, 4", double_perpendicular_pendulum_case("swing"), 2, 4);
}

/// Of S9, by itself in two steps a call of 60 Hz: tilt 30 +- 0.07 degrees, precession to 0.1 %.
TEST(FreeFigures, a_heavy_top_stands) {
    const FigureScene scene = heavy_top();
    FigureWorld<Swinging> of(scene);
    double most = 0, least = 90, azimuth = 0, last = 0;
    for (int step_i = 0; step_i < 600; ++step_i) {
        ASSERT_TRUE(swing(of, 60));
        const Vector3d axis = of.state().body(0).A().col(2);
        const double tilt = std::acos(axis.z()) * 180 / pi;
        most = std::max(most, tilt);
        least = std::min(least, tilt);
        azimuth += std::remainder(std::atan2(axis.y(), axis.x()) - last, 2 * pi);
        last = std::atan2(axis.y(), axis.x());
    }
    std::printf("    S9, 10 s: tilt %.4f to %.4f degrees, precession %+.3f %%\n", least, most, 100 * (azimuth / 10 / top_precession() - 1));
    EXPECT_NEAR(most, 30, 0.07);
    EXPECT_NEAR(least, 30, 0.07);
    EXPECT_NEAR(azimuth / 10 / top_precession(), 1, 1e-3);
}

/// Of S5, ten seconds at 60 Hz through its snaps: energy, gap, passes, and none of the energy in velocities that joints do not allow.
TEST(FreeFigures, a_chain_snaps_and_loses_nothing) {
    const ingot_reference::CsvTable table(INGOT_REFERENCE_DIR "/../joints", "chain_s5.csv");
    const std::size_t row = table.row_with("t", "0.50");
    const FigureScene scene = chain();
    FigureWorld<Swinging> of(scene);
    const JointRows rows(scene);
    const double unit = 11.04e3, E = energy(rows, of.state());
    double worst_energy = 0, gap = 0, hidden = 0;
    int many_passes = 0;
    for (int step_i = 1; step_i <= 600; ++step_i) {
        const ingot::StepReport report = ingot::step(of.world, ingot::scalar(1) / 60);
        ASSERT_TRUE(is_solved(report)) << step_i;
        many_passes += report.figure_passes > 12;
        const FigureState state = of.state();
        worst_energy = std::max(worst_energy, std::abs(energy(rows, state) - E) / unit);
        gap = std::max(gap, worst_gap(rows, state));
        if (step_i % 4 == 0) hidden = std::max(hidden, inadmissible_share(rows, state));
        if (step_i != 30) continue;
        const double off = (state.body(20).r_CM - Vector3d(table.number(row, "x21"), 0, table.number(row, "z21"))).norm();
        std::printf("    S5, 0.5 s: %.3f mm off\n", 1e3 * off);
        EXPECT_LE(off, 2e-4);
    }
    std::printf("    S5, 10 s: energy to %.1e %%, gap to %.1e mm, hidden %.1e, more than 12 passes in %d steps\n", 100 * worst_energy, 1e3 * gap,
                hidden, many_passes);
    EXPECT_LE(worst_energy, INGOT_DOUBLE ? 1e-6 : 5e-4);
    EXPECT_LE(gap, INGOT_DOUBLE ? 1e-7 : 2e-5);
    EXPECT_LE(hidden, 1e-3);
    EXPECT_LE(many_passes, 6);
}

/// Where snaps become heat, no step gains more than roundings of what there is, and the chain's snaps do lose some.
TEST(FreeFigures, snaps_may_be_lost) {
    const FigureScene scene = chain();
    FigureWorld<SnappingInHeat> of(scene);
    const JointRows rows(scene);
    const double unit = 11.04e3;
    const double begin = energy(rows, of.state());
    double before = begin;
    for (int step_i = 0; step_i < 600; ++step_i) {
        ASSERT_TRUE(swing(of, 60));
        const double now = energy(rows, of.state());
        ASSERT_LE(now - before, 64 * eps * unit) << step_i;
        before = now;
    }
    EXPECT_LE(before, begin - 0.01 * unit);
}

/// Whoever strikes a body of it gives its momentum to the figure, which is on its joints again at once.
TEST(FreeFigures, take_a_blow_as_a_whole) {
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        RandomInput random(static_cast<uint64_t>(run_i) + 2000);
        const FigureScene scene = random_tree(random, {random.integer(2, 8), run_i % 2 == 0 ? 1.001 : 1000, random.real(0.1, 2), false});
        FigureWorld<Swinging> of(scene);
        const JointRows rows(scene);
        ASSERT_TRUE(swing(of, 60));
        const int struck = random.integer(0, scene.body_count() - 1);
        const Vector3d p = momentum(scene, of.state()), L = angular_momentum(scene, of.state());
        const Vector3d j = random.vector(scene.body(struck).M), r = of.state().body(struck).r_CM;
        ASSERT_EQ(of.world.apply_central_impulse(of.built.bodies[static_cast<std::size_t>(struck)], to_vector(j)), ingot::Status::ok);
        const double unit = kinetic_energy(scene, of.state());
        ASSERT_TRUE(swing(of, 60));
        const FigureState state = of.state();
        const Units units = units_of(scene, state);
        EXPECT_LE((momentum(scene, state) - p - j).norm(), 64 * eps * (units.momentum + j.norm())) << run_i;
        EXPECT_LE((angular_momentum(scene, state) - L - r.cross(j)).norm(), 64 * eps * (units.spin + units.length * j.norm())) << run_i;
        EXPECT_LE(kinetic_energy(scene, state), unit * (1 + 64 * eps)) << run_i;
        EXPECT_LE(worst_gap(rows, state), 4 * eps * units.length) << run_i;
    }
}

}  // namespace
