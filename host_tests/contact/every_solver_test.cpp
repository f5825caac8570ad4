// SPDX-License-Identifier: MIT
// Rolling resistance, surfaces that move, and restitution are the same laws with every solver: over random bodies, directions and rates.
//
// A solver leaves its settled speed in a substep; both it and rounding add up over the substeps of a step, of which there are limits::substeps.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/play.h"
#include "reference/ball_and_brick.h"
#include "scenes/random.h"

namespace {

using namespace ingot_contact;
using namespace scenes;

constexpr double g = 9.81;

template <class Solver>
struct Materials : Room<4, ingot::AllPairs, true, 8, 16, Solver> {
    static constexpr bool rolling_resistance = true, surface_velocities = true;
};

/// What a solver may leave of a speed, in a substep; m/s.
template <class Solver>
double settled_of() {
    return static_cast<double>(Solver::is_pointwise ? ingot::limits::settled_speed_of_points : ingot::limits::settled_speed_of_small);
}

struct MaterialOf {
    PlacedBody body;
    double lever;
    Vector belt;
};

template <class Solver>
class EverySolver : public ::testing::Test {
protected:
    using Scene = Materials<Solver>;

    static Play<Scene> play(const std::vector<MaterialOf>& all) {
        std::vector<PlacedBody> placed;
        for (const MaterialOf& one : all) placed.push_back(one.body);
        Play<Scene> scene(placed, {0, 0, scalar(-g)});
        for (int i = 0; i < scene.body_count(); ++i) {
            const MaterialOf& one = all[static_cast<std::size_t>(i)];
            EXPECT_EQ(scene.world().set_rolling_resistance(scene.id(i), scalar(one.lever)), Status::ok);
            EXPECT_EQ(scene.world().set_surface_velocity(scene.id(i), one.belt), Status::ok);
        }
        EXPECT_TRUE(scene.sound());
        return scene;
    }
    /// m/s, after so many steps of motion at v.
    static double allowed(int steps, double v) {
        return 20e-6 + steps * ingot::limits::substeps * (settled_of<Solver>() + 8 * static_cast<double>(ingot::epsilon) * v);
    }

    static double heavy() { return Solver::is_pointwise ? 1 : 100; }
    double between(double low, double high) { return low + (high - low) * (static_cast<double>(random_.symmetric()) + 1) / 2; }
    /// Steps a second, as many as not between 30 and 1000.
    double rate() {
        const double rates[] = {30, 60, 144, 240, 1000};
        return rates[static_cast<int>(between(0, 4.999))];
    }
    Vector3d heading() {
        const double angle = between(-3, 3);
        return {std::cos(angle), std::sin(angle), 0};
    }

private:
    Random random_{11};
};
using Solvers = ::testing::Types<ingot::BlockSweeps, ingot::HybridIslands<8>, ingot::SequentialImpulses>;
TYPED_TEST_SUITE(EverySolver, Solvers);

/// (5/7) g lever / R, on the ground and on a slab that is a hundredth as heavy: there the direct solver is at work. The sequential solver is not for
/// those, and gets one as heavy.
TYPED_TEST(EverySolver, slows_a_ball_that_rolls_by_its_lever) {
    double worst = 0;
    for (int case_i = 0; case_i < 24; ++case_i) {
        const double R = this->between(0.1, 1), M = this->between(0.5, 50), lever = R * this->between(0.02, 0.1), v_0 = this->between(1, 4);
        const double h = 1 / this->rate(), a = 5.0 / 7 * lever / R * g;
        const bool on_slab = case_i % 2 == 1;
        const Vector3d way = this->heading();
        const int steps = static_cast<int>(std::min(1.0, 0.8 * v_0 / a) / h);
        PlacedBody ball = solid_ball(scalar(M), scalar(R), {0, 0, scalar(R + (on_slab ? 0.2 : 0))}, scalar(0.8));
        ball.move({scalar(v_0 * way.x()), scalar(v_0 * way.y()), 0}, {scalar(-v_0 / R * way.y()), scalar(v_0 / R * way.x()), 0});
        std::vector<MaterialOf> bodies = {{flat_ground(scalar(0.8)), 0, {}}, {ball, lever, {}}};
        if (on_slab) bodies.push_back({solid_box(scalar(M / this->heavy()), {8, 8, scalar(0.1)}, {0, 0, scalar(0.1)}, scalar(0.8)), 0, {}});
        auto scene = this->play(bodies);
        double most = 0;
        for (int step_i = 1; step_i <= steps; ++step_i) {
            (void)scene.step(scalar(h));
            const double off = (scene.v(1) - way * (v_0 - a * step_i * h)).norm() / this->allowed(step_i, v_0);
            most = std::max(most, off);
        }
        worst = std::max(worst, most);
        EXPECT_LE(most, 1) << "case " << case_i << " R " << R << " M " << M << " v " << v_0 << " 1/h " << 1 / h;
        if (on_slab && TypeParam::is_direct) {
            EXPECT_GT(scene.reports().solved_directly, steps / 2);
        }
    }
    figure("error of the speed, of what is allowed", worst);
}

/// mu g, and then the belt's own speed; also under a load a hundred times as heavy as what lies between.
TYPED_TEST(EverySolver, carries_on_a_belt_at_its_speed) {
    double worst = 0;
    for (int case_i = 0; case_i < 24; ++case_i) {
        const double mu = this->between(0.2, 0.9), M = this->between(0.5, 20), speed = this->between(0.3, 2), h = 1 / this->rate();
        const bool loaded = case_i % 2 == 1;
        const Vector3d way = this->heading(), belt = way * speed;
        const double t_carried = speed / (mu * g);
        const int steps = static_cast<int>((t_carried + 0.5) / h);
        std::vector<MaterialOf> bodies = {
            {flat_ground(scalar(mu)), 0, {scalar(belt.x()), scalar(belt.y()), 0}},
            {solid_box(scalar(M), {scalar(0.5), scalar(0.5), scalar(0.1)}, {0, 0, scalar(0.1)}, scalar(mu)), 0, {}}};
        if (loaded) bodies.push_back({solid_box(scalar(this->heavy() * M), {scalar(0.4), scalar(0.4), scalar(0.1)}, {0, 0, scalar(0.3)}, 1), 0, {}});
        auto scene = this->play(bodies);
        double most = 0;
        for (int step_i = 1; step_i <= steps; ++step_i) {
            (void)scene.step(scalar(h));
            const double t = step_i * h, v = std::min(mu * g * t, speed);
            if (std::abs(t - t_carried) <= h) continue;
            for (int i = 1; i < scene.body_count(); ++i)
                most = std::max(most, (scene.v(i) - way * v).norm() / this->allowed(step_i, speed));
        }
        worst = std::max(worst, most);
        EXPECT_LE(most, 1) << "case " << case_i << " mu " << mu << " M " << M << " v " << speed << " 1/h " << 1 / h;
        if (loaded && TypeParam::is_direct) {
            EXPECT_GT(scene.reports().solved_directly, steps / 2);
        }
    }
    figure("error of the speed, of what is allowed", worst);
}

/// Up a slope whose surface may move by itself, until the slip turns round, and down again: speed and place by the closed form, at every rate; also
/// under a load a hundred times as heavy as what lies between. A slip that turns round at less than limits::reversal_speed is not split there; and
/// where several bodies touch they are displaced by the mean of the velocities about the substep, which for accelerations a and b before and after
/// the turn is off by (a - b) h^2 / 8 at most.
TYPED_TEST(EverySolver, turns_round_on_a_slope_within_a_substep) {
    double worst = 0, worst_way = 0;
    for (int case_i = 0; case_i < 36; ++case_i) {
        const double mu = this->between(0.1, 0.6), slope = mu * this->between(1.1, 3), M = this->between(0.5, 20), v_0 = this->between(1, 5);
        const double h = 1 / this->rate(), belt = case_i % 3 == 2 ? this->between(-1, 1) : 0;
        const bool loaded = case_i % 2 == 1;
        const Vector3d down = this->heading(), gravity = g / std::hypot(1, slope) * (slope * down - Vector3d::UnitZ());
        const auto exact = ingot_reference::BrickOnIncline(-gravity.z(), mu, slope, 1, -v_0);
        const double of_mean = loaded ? -2 * mu * gravity.z() * h * h / (8 * ingot::limits::substeps * ingot::limits::substeps) : 0;
        const int steps = static_cast<int>((static_cast<double>(exact.t_stop()) + this->between(0.3, 1)) / h);
        std::vector<PlacedBody> bodies = {flat_ground(scalar(mu)),
                                          solid_box(scalar(M), {scalar(0.5), scalar(0.5), scalar(0.1)}, {0, 0, scalar(0.1)}, scalar(mu))};
        if (loaded) bodies.push_back(solid_box(scalar(this->heavy() * M), {scalar(0.4), scalar(0.4), scalar(0.1)}, {0, 0, scalar(0.3)}, 4));
        const Vector3d v_begin = down * (belt - v_0), v_belt = down * belt;
        for (std::size_t i = 1; i < bodies.size(); ++i) bodies[i].move({scalar(v_begin.x()), scalar(v_begin.y()), 0});
        Play<typename TestFixture::Scene> scene(bodies, ingot_reference::to_vector(gravity));
        ASSERT_TRUE(scene.sound());
        EXPECT_EQ(scene.world().set_surface_velocity(scene.id(0), ingot_reference::to_vector(v_belt)), Status::ok);
        double most = 0, most_way = 0;
        for (int step_i = 1; step_i <= steps; ++step_i) {
            (void)scene.step(scalar(h));
            const auto now = exact.at(step_i * static_cast<long double>(h));
            const double allowed = this->allowed(step_i, 2 * v_0) + 2 * static_cast<double>(ingot::limits::reversal_speed);
            for (int i = 1; i < scene.body_count(); ++i) {
                most = std::max(most, (scene.v(i) - v_belt - down * static_cast<double>(now.v)).norm() / allowed);
                const Vector3d way = v_belt * (step_i * h) + down * static_cast<double>(now.s);
                most_way = std::max(most_way, (scene.moved(i) - way).norm() / (allowed * step_i * h + of_mean));
            }
        }
        worst = std::max(worst, most);
        worst_way = std::max(worst_way, most_way);
        const auto about = ::testing::Message() << "case " << case_i << " mu " << mu << " slope " << slope << " v " << v_0 << " belt " << belt;
        EXPECT_LE(most, 1) << about << " 1/h " << 1 / h;
        EXPECT_LE(most_way, 1) << about << " 1/h " << 1 / h;
        if (loaded && TypeParam::is_direct) {
            EXPECT_GT(scene.reports().solved_directly, steps / 2);
        }
    }
    figure("error of the speed, of what is allowed", worst);
    figure("error of the place, of what is allowed", worst_way);
}

/// A ball that bounces, slides and rolls gains nothing from ground at rest, nor does a box that falls on it. (A box that bounces on its corners does
/// with any solver: Newton's law of restitution and friction do not go together there, see Kane and Levinson, "Dynamics", 1985.)
TYPED_TEST(EverySolver, gives_no_energy) {
    double worst = 0;
    for (int case_i = 0; case_i < 40; ++case_i) {
        const double R = this->between(0.2, 0.6), M = this->between(0.5, 20), h = 1 / this->rate(), e = case_i % 2 == 0 ? this->between(0, 1) : 0;
        PlacedBody ball = solid_ball(scalar(M), scalar(R), {0, 0, scalar(R + this->between(0, 0.3))}, scalar(this->between(0, 1)));
        PlacedBody box = solid_box(scalar(this->between(0.5, 20)), {scalar(0.3), scalar(0.2), scalar(0.25)},
                {scalar(20), 0, scalar(0.5)}, scalar(0.5));
        for (PlacedBody* body : {&ball, &box}) {
            const Vector v = {scalar(this->between(-2, 2)), scalar(this->between(-2, 2)), scalar(this->between(-2, 0))};
            body->move(v, {scalar(this->between(-5, 5)), scalar(this->between(-5, 5)), scalar(this->between(-5, 5))});
        }
        ball.def.restitution = scalar(e);
        auto scene = this->play({{flat_ground(scalar(0.6)), 0, {}}, {ball, R * this->between(0, 0.1), {}}, {box, 0.01, {}}});
        double before = scene.energy(), most = 0;
        const double scale = before;
        for (int step_i = 1; step_i <= static_cast<int>(1.5 / h); ++step_i) {
            (void)scene.step(scalar(h));
            const double now = scene.energy();
            most = std::max(most, (now - before) / scale);
            before = now;
        }
        EXPECT_TRUE(scene.finite());
        worst = std::max(worst, most);
        EXPECT_LE(most, 64 * static_cast<double>(ingot::epsilon) + 2e-6) << "case " << case_i << " 1/h " << 1 / h << " e " << e;
    }
    figure("largest gain of a step, of the energy", worst);
}

/// e = 1 keeps the height, for as long as rounding lets it.
TYPED_TEST(EverySolver, keeps_the_energy_of_a_ball_that_bounces_with_e_1) {
    double worst = 0;
    for (int case_i = 0; case_i < 10; ++case_i) {
        const double R = this->between(0.1, 1), drop = this->between(0.2, 2), h = 1 / this->rate();
        PlacedBody ball = solid_ball(scalar(this->between(0.1, 50)), scalar(R), {0, 0, scalar(R + drop)}, 0);
        ball.def.restitution = 1;
        auto scene = this->play({{flat_ground(0), 0, {}}, {ball, 0, {}}});
        const double E = scene.M(1) * g * drop, base = scene.M(1) * g * R;
        for (int step_i = 1; step_i <= static_cast<int>(10 / h); ++step_i) (void)scene.step(scalar(h));
        worst = std::max(worst, std::abs(scene.energy() - base - E) / E);
    }
    figure("change of the energy in 10 s, of it", worst);
    EXPECT_LE(worst, is_double ? 1e-5 : 2e-3);
}

/// e = 1/2 comes to rest after t = sqrt(2 drop / g) (1 + e) / (1 - e), and stays; a stack of such bodies does not shake.
TYPED_TEST(EverySolver, brings_to_rest_what_bounces_with_e_a_half) {
    double fastest_ball = 0, fastest_stack = 0, sunk = 0;
    for (int case_i = 0; case_i < 10; ++case_i) {
        const double R = this->between(0.1, 1), drop = this->between(0.2, 1), h = 1 / this->rate();
        PlacedBody ball = solid_ball(scalar(this->between(0.1, 50)), scalar(R), {0, 0, scalar(R + drop)}, scalar(0.5));
        ball.def.restitution = scalar(0.5);
        auto scene = this->play({{flat_ground(scalar(0.5)), 0, {}}, {ball, 0, {}}});
        scene.run(scalar(h), 3 * std::sqrt(2 * drop / g) + 0.5);
        fastest_ball = std::max(fastest_ball, scene.v(1).norm());
        sunk = std::max(sunk, std::abs(scene.r(1).z() - R));

        std::vector<MaterialOf> stack = {{flat_ground(scalar(0.5)), 0, {}}};
        for (int i = 0; i < 3; ++i) {
            PlacedBody box = solid_box(scalar(this->between(1, 3)), {scalar(0.5), scalar(0.5), scalar(0.25)},
                    {0, 0, scalar(0.25 + 0.5 * i)}, scalar(0.5));
            box.def.restitution = scalar(0.5);
            stack.push_back({box, 0, {}});
        }
        auto tower = this->play(stack);
        tower.run(scalar(h), 1);
        tower.run(scalar(h), 0.5, [&](int) { fastest_stack = std::max(fastest_stack, tower.fastest()); });
    }
    figure("ball at rest, m/s", fastest_ball);
    figure("and off its place, m", sunk);
    figure("stack at rest, m/s", fastest_stack);
    EXPECT_LE(fastest_ball, 1e-4);
    EXPECT_LE(sunk, 1e-4);
    EXPECT_LE(fastest_stack, 1e-3);
}

}  // namespace
