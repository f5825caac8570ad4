// SPDX-License-Identifier: MIT
// What friction and thrust hold up, and what falls without.
#include <gtest/gtest.h>

#include "contact/play.h"

namespace {

using namespace ingot_contact;
using namespace scenes;

/// C10: three levels stand for 60 s at 1.1 of the least friction and above. A card that left its place by a tenth of its length has fallen.
template <int mu_percent>
void expect_card_house_stands() {
    auto scene = play<CardHouse<3, mu_percent>>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 60);
    figure("shift, mm", 1e3 * scene.shift());
    figure("sink, mm", 1e3 * scene.sink());
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(scene.shift(), 1e-4);
    EXPECT_LE(scene.sink(), 1e-4);
}
TEST(CardHouse, stands_with_friction_to_spare) { expect_card_house_stands<60>(); }
TEST(CardHouse, stands_at_11_of_its_least_friction) { expect_card_house_stands<41>(); }
TEST(CardHouse, falls_with_too_little_friction) {
    constexpr int mu_percent = 32;  // 0.9 * 0.365 = 0.3285, rounded down
    auto scene = play<CardHouse<3, mu_percent>>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 10);
    figure("sink, mm", 1e3 * scene.sink());
    EXPECT_GE(scene.sink(), 0.1);
    EXPECT_TRUE(scene.finite());
}
/// One level: (tan(angle) - thickness / length) / 2 = 0.2132.
TEST(CardHouse, of_one_level_knows_its_friction) {
    auto stands = play<CardHouse<1, 22>>();
    auto falls = play<CardHouse<1, 20>>();
    stands.run(OnEarth::h, 60);
    falls.run(OnEarth::h, 10);
    figure("sink with 0.22, mm", 1e3 * stands.sink());
    figure("sink with 0.20, mm", 1e3 * falls.sink());
    EXPECT_LE(stands.sink(), 1e-4);
    EXPECT_GE(falls.sink(), 0.1);
}

/// C11: sticks at 1.02 mu_least, slips at 0.98 mu_least.
template <int degrees>
void expect_plank_knows_its_friction() {
    using Plank = LeaningPlank<degrees>;
    for (const double factor : {1.02, 0.98}) {
        const scalar mu = static_cast<scalar>(static_cast<double>(Plank::mu_least) * factor);
        // Friction of a pair is the geometric mean: on the ground both have mu, on the wall 0.
        Play<Room<3>> scene(bodies_from<3>([&](int body_i) { return Plank::body(body_i, mu); }), Plank::gravity);
        ASSERT_TRUE(scene.sound());
        scene.run(OnEarth::h, Plank::seconds);
        figure(factor > 1 ? "way with 1.02, m" : "way with 0.98, m", scene.moved(2).norm());
        if (factor > 1) {
            EXPECT_LE(scene.moved(2).norm(), 1e-3);
        } else {
            EXPECT_GE(scene.moved(2).norm(), 0.1);
        }
    }
}
TEST(LeaningPlank, at_45_degrees_knows_its_friction) { expect_plank_knows_its_friction<45>(); }
TEST(LeaningPlank, at_60_degrees_knows_its_friction) { expect_plank_knows_its_friction<60>(); }
TEST(LeaningPlank, at_75_degrees_knows_its_friction) { expect_plank_knows_its_friction<75>(); }

/// When the last domino moves, s; and what the fall did to the energy.
struct Fall {
    double last_moves = -1, largest_gain = 0, start = 0;
    int fallen = 0;
};
template <int count>
Fall fall_of_dominoes(double h) {
    auto scene = play<Dominoes<count>>();
    Fall fall;
    fall.start = scene.energy();
    double before = fall.start;
    scene.run(static_cast<scalar>(h), Dominoes<count>::seconds, [&](int step_i) {
        const double now = scene.energy();
        fall.largest_gain = std::max(fall.largest_gain, now - before);
        before = now;
        if (fall.last_moves < 0 && scene.v(count).norm() > 0.1) fall.last_moves = step_i * h;
    });
    EXPECT_TRUE(scene.reports().clean());
    for (int i = 1; i <= count; ++i) fall.fallen += scene.A(i)(2, 2) < 0.5;
    EXPECT_NEAR(scene.A(count)(2, 2), 0, 0.05) << "the last lies flat";
    return fall;
}
/// C10: all fall, each on the next, the last one flat; no step gains more than 1e-4 of the energy; the time until the last one moves
/// converges with h: 240 and 480 Hz are nearer to each other than 60 and 120 Hz.
TEST(Dominoes, fall_in_a_time_that_converges) {
    constexpr int count = 20;
    double times[4];
    int i = 0;
    for (const double rate : {60.0, 120.0, 240.0, 480.0}) {
        const Fall fall = fall_of_dominoes<count>(1 / rate);
        figure("rate, Hz", rate);
        figure("  last one moves at, s", fall.last_moves);
        figure("  largest gain of a step, share", fall.largest_gain / fall.start);
        EXPECT_EQ(fall.fallen, count);
        EXPECT_LE(fall.largest_gain, 1e-4 * fall.start);
        times[i++] = fall.last_moves;
    }
    EXPECT_LE(std::abs(times[3] - times[2]), std::abs(times[1] - times[0]) + 1 / 240.0);
    EXPECT_NEAR(times[3], times[2], 0.02 * times[3]);
}

/// C15: |omega| <= 1e-4 rad/s over ten steps at every yaw.
template <int yaw_microrad>
void expect_no_ghost_torque() {
    auto scene = play<PlankOnEdge<yaw_microrad>>();
    ASSERT_TRUE(scene.sound());
    double spin = 0;
    for (int step_i = 0; step_i < 10; ++step_i) {
        (void)scene.step(OnEarth::h);
        spin = std::max(spin, scene.omega(1).norm());
    }
    figure(("spin at yaw " + std::to_string(yaw_microrad) + " urad, rad/s").c_str(), spin);
    EXPECT_LE(spin, 1e-4) << yaw_microrad;
}
TEST(PlankOnEdge, has_no_ghost_torque) {
    expect_no_ghost_torque<1570796>();
    expect_no_ghost_torque<785398>();
    expect_no_ghost_torque<100000>();
    expect_no_ghost_torque<10000>();
    expect_no_ghost_torque<3000>();
    expect_no_ghost_torque<1000>();
    expect_no_ghost_torque<100>();
    expect_no_ghost_torque<1>();
    expect_no_ghost_torque<0>();
}

/// C14: no NaN, no divergence; no step gains energy (1e-4 of the kinetic energy at the start).
template <int degrees, int mu_percent>
void expect_rod_gains_nothing() {
    auto scene = play<SlidingRod<degrees, mu_percent>>();
    ASSERT_TRUE(scene.sound());
    double before = scene.energy(), gain = 0;
    const double start = before;
    scene.run(OnEarth::h, SlidingRod<degrees, mu_percent>::seconds, [&](int) {
        gain = std::max(gain, scene.energy() - before);
        before = scene.energy();
    });
    figure("largest gain of a step, share", gain / start);
    EXPECT_TRUE(scene.finite());
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(gain, 1e-4 * start);
}
TEST(SlidingRod, gains_nothing_below_the_paradox) { expect_rod_gains_nothing<60, 50>(); }
TEST(SlidingRod, gains_nothing_far_above_the_paradox) { expect_rod_gains_nothing<45, 500>(); }
/// Above the paradox the blow turns the rod over its end, and it falls to the other side. The energy never gets beyond that of the start, at
/// any rate, and no step gains more than
///
/// - M g touching_gap: what stands on an edge as the rod does, and comes to stand on the face, is drawn there by displacements: no speed comes of it,
///   but a body may come to lie higher by the gap. 4e-4 of the energy here, at 120 to 1920 Hz, in double too.
/// - the energy of its spin about its own axis, where that turns it by a radian in a step, else the square of the angle of it: levers stand
///   still within a step. In float at 60 Hz the rod, 1 cm thick, begins to spin so from rounding, up to 115 rad/s, and a step gains 0.6 % of its
///   energy. Shorter steps do not cure it: at 120 Hz it does not spin, at 240 and 1920 Hz it does; in double it does at no rate.
TEST(SlidingRod, above_the_paradox_gains_no_more_than_its_axial_spin) {
    using Rod = SlidingRod<60, 200>;
    for (const int rate : {60, 120, 240, 480}) {
        auto scene = play<Rod>();
        ASSERT_TRUE(scene.sound());
        const double h = 1.0 / rate, start = scene.energy(), I = static_cast<double>(scene.placed(1).def.mass.I_body.x);
        const double drawn = scene.M(1) * static_cast<double>(standard_gravity * ingot::limits::touching_gap);
        double before = start, spin_before = 0, gain = 0, excess = 0, most = 0, fastest = 0;
        scene.run(static_cast<scalar>(h), Rod::seconds, [&](int) {
            const double now = scene.energy(), spin = std::abs(scene.A(1).col(0).dot(scene.omega(1))), w = std::max(spin, spin_before);
            const double angle = std::min(w * h, 1.0);
            gain = std::max(gain, now - before);
            excess = std::max(excess, now - before - drawn - I * w * w / 2 * angle * angle - 1e-4 * start);
            most = std::max(most, now);
            fastest = std::max(fastest, spin);
            before = now;
            spin_before = spin;
        });
        figure("rate, Hz", rate);
        figure("  largest gain of a step, share", gain / start);
        figure("  fastest spin about its axis, rad/s", fastest);
        EXPECT_LE(excess, 0) << rate;
        EXPECT_LE(most, start * (1 + 1e-4)) << rate;
        EXPECT_TRUE(scene.finite());
        EXPECT_TRUE(scene.reports().clean());
    }
}

}  // namespace
