// SPDX-License-Identifier: MIT
// C20 and C21: SimBenchmark's scenes at its step of 1 ms, against the best that is on record for them (scenes/contact/simbenchmark.h).
#include <gtest/gtest.h>

#include "contact/play.h"

namespace {

using namespace ingot_contact;
using namespace scenes;

/// Mean over the steps, each taken before its step, of (E - E_0)^2, J^2.
template <class Scene>
double energy_error(Play<Room<Scene::body_count, ingot::SortedTree>>& scene) {
    const double start = scene.energy();
    double sum = 0, last = 0;
    int steps = 0;
    scene.run(Scene::h, static_cast<double>(Scene::seconds), [&](int) {
        sum += last;
        ++steps;
        last = (scene.energy() - start) * (scene.energy() - start);
    });
    return sum / steps;
}

/// C20, bouncing 7 x 7: <= 1.9e-2 J^2 (RaiSim). In float an energy of 490 J a ball is right to 490 epsilon / 2 a step at best.
TEST(SimBenchmark, elastic_balls_keep_their_energy) {
    auto scene = play<SimBouncing, ingot::SortedTree>();
    ASSERT_TRUE(scene.sound());
    const double error = energy_error<SimBouncing>(scene);
    figure("energy error, J^2", error);
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(error, 1.9e-2);
}

/// C20, elastic 666: <= 8.4 J^2 (RaiSim).
TEST(SimBenchmark, elastic_666_keeps_its_energy) {
    auto scene = play<Sim666<true>, ingot::SortedTree>();
    ASSERT_TRUE(scene.sound());
    const double error = energy_error<Sim666<true>>(scene);
    figure("energy error, J^2", error);
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(error, 8.4);
}

/// C20, 666: sum over pairs of squared penetration, in the mean over every tenth step: <= 1.35e-4 m^2 (RaiSim).
TEST(SimBenchmark, pile_666_does_not_overlap) {
    auto scene = play<Sim666<false>, ingot::SortedTree>();
    ASSERT_TRUE(scene.sound());
    double sum = 0;
    int samples = 0;
    scene.run(SimBenchmark::h, static_cast<double>(Sim666<false>::seconds), [&](int step_i) {
        if (step_i % 10 != 0) return;
        for (const double deep : scene.overlaps()) sum += deep * deep;
        ++samples;
    });
    figure("squared overlap, m^2", sum / samples);
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(sum / samples, 1.35e-4);
}

/// C21: a push sets off the box, and the balls roll on it. The error is that of the definition, in the mean over the steps, each taken before
/// its step:
/// |v_box - a_box t|^2 + |v_ball - a_ball t|^2 with a_box = (F - mu_1 (M + 25 m) g) / (M + 25 m 2/7) and a_ball = 2/7 a_box. The definition
/// multiplies the coefficients of two materials (0.5, 0.8, 1); here, where the geometric mean counts, those of 0.2, 0.8 and 0.8 give its 0.4 and 0.8.
double rolling_error(const Vector& push) {
    const scalar mu[] = {scalar(0.2), scalar(0.8), scalar(0.8)};
    Play<Room<SimRolling::body_count>> scene(bodies_from<SimRolling::body_count>([&](int body_i) {
                                                 PlacedBody body = SimRolling::body(body_i);
                                                 body.mu = mu[body_i < 2 ? body_i : 2];
                                                 return body;
                                             }),
                                             SimRolling::gravity);
    EXPECT_TRUE(scene.sound());
    constexpr double M = 10, m = 1, balls = 25, F = 150, g = 9.81;
    const double a_box = (F - 0.4 * (M + balls * m) * g) / (M + balls * m * 2 / 7);
    const Vector3d direction = to_eigen(push).normalized();
    double sum = 0;
    const int steps = static_cast<int>(std::lround(static_cast<double>(SimRolling::seconds) / 1e-3));
    for (int step_i = 0; step_i < steps; ++step_i) {
        const Vector3d box = direction * (a_box * step_i * 1e-3);
        sum += (scene.v(SimRolling::pushed_body) - box).squaredNorm() + (scene.v(SimRolling::measured_ball) - box * (2.0 / 7)).squaredNorm();
        EXPECT_EQ(scene.world().add_central_force(scene.id(SimRolling::pushed_body), push), Status::ok);
        (void)scene.step(SimRolling::h);
    }
    EXPECT_TRUE(scene.reports().clean());
    figure("rolling error, m^2 s^-2", sum / steps);
    return sum / steps;
}
/// Double: <= 5.7e-9 (Bullet), <= 7.7e-9 (ODE), 1e-8 of C21; all of these are runs in double. Float cannot get there: in each substep the box
/// takes the push and one impulse of each of its 26 contacts, all the same from substep to substep, so that each may round by half an ulp the
/// same way every time.
/// Of v = a t that adds up to 27 (epsilon / 2) (a t / 2) t / h, h of a substep; the balls have 2/7 of it.
double rolling_bound() {
    if (is_double) return 5.7e-9;
    const double a = 0.73850, T = 4, h = 1e-3 / ingot::limits::substeps, of_t_sq = 27 * (static_cast<double>(ingot::epsilon) / 2) * a / 2 / h;
    return of_t_sq * of_t_sq * (T * T * T * T / 5) * (1 + 4.0 / 49);
}
TEST(SimBenchmark, balls_roll_on_a_box_that_is_pushed) {
    EXPECT_LE(rolling_error(SimRolling::push_diagonal), rolling_bound());
    EXPECT_LE(rolling_error(SimRolling::push_along_y), rolling_bound());
}

}  // namespace
