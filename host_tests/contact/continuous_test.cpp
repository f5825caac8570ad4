// SPDX-License-Identifier: MIT
// Bodies too fast for a step: nothing passes through anything, nothing is deflected that is not met, no energy comes of it.
#include <gtest/gtest.h>

#include "contact/play.h"

namespace {

using namespace ingot_contact;
using namespace scenes;

using AllShapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;

template <int size>
struct FastRoomOfSize : Room<size> {
    static constexpr bool continuous = true;
    using shapes = AllShapes;
};
template <int bodies>
using FastRoom = FastRoomOfSize<room_size(bodies)>;

constexpr double eps = static_cast<double>(ingot::epsilon);
constexpr int rates[] = {30, 60, 240};

scalar step_of(int rate) { return static_cast<scalar>(1.0 / rate); }

/// Energy never grows: by no more than the roundings of a step's sums, 16 of the energy there is.
template <class S>
class EnergyWatch {
public:
    explicit EnergyWatch(const Play<S>& scene) : scene_(scene), before_(scene.energy()), scale_(std::max(std::abs(before_), scene.kinetic())) {}
    void look() {
        const double now = scene_.energy();
        worst_ = std::max(worst_, (now - before_) / scale_);
        before_ = now;
    }
    double worst() const { return worst_; }
    /// In a crowd, what a step of any pile may gain (PitOfBoxes).
    static constexpr double allowed_in_a_crowd = 1e-4;

private:
    const Play<S>& scene_;
    double before_, scale_, worst_ = 0;
};

/// I11: in 40 phases: never beyond the plate; thrown back with e times the speed, and by where it is then the impact was at its time, to 1e-6 s.
class Bullet : public ::testing::TestWithParam<int> {};
TEST_P(Bullet, never_passes_a_plate) {
    const int rate = GetParam();
    double worst_time = 0, furthest = -1;
    for (const double e : {0.0, 0.5, 1.0}) {
        for (int phase_i = 0; phase_i < 40; ++phase_i) {
            const int ball = 1 - phase_i % 2;  // whichever was put in first
            const scalar phase = static_cast<scalar>(phase_i) / 40;
            Play<FastRoom<2>> scene(bodies_from<2>([&](int i) { return BulletAndPlate::body(ball == 1 ? i : 1 - i, phase, static_cast<scalar>(e)); }),
                                    BulletAndPlate::gravity);
            ASSERT_TRUE(scene.sound());
            const int steps = rate / 10;  // 0.1 s
            for (int step_i = 0; step_i < steps; ++step_i) {
                ASSERT_TRUE(scene.step(step_of(rate)).clean());
                furthest = std::max(furthest, scene.r(ball).x());
            }
            const double speed = static_cast<double>(BulletAndPlate::speed), x = scene.r(ball).x();
            EXPECT_NEAR(scene.v(ball).x(), -e * speed, 8 * eps * speed);
            EXPECT_NEAR(scene.v(ball).tail(2).norm(), 0, 8 * eps * speed);
            if (!(e > 0)) continue;
            const double at_plate = -static_cast<double>(BulletAndPlate::radius + BulletAndPlate::half_thickness);
            const double time = steps * static_cast<double>(step_of(rate)) - (at_plate - x) / (e * speed);
            worst_time = std::max(worst_time, std::abs(time - static_cast<double>(BulletAndPlate::time_of_impact(phase))));
        }
    }
    figure("time of impact, worst error, s", worst_time);
    EXPECT_LE(worst_time, 1e-6);
    // At rest it may be drawn into the plate by no more than the rounding of where it stops.
    EXPECT_LE(furthest, -static_cast<double>(BulletAndPlate::radius + BulletAndPlate::half_thickness) + 64 * eps);
}
INSTANTIATE_TEST_SUITE_P(Rates, Bullet, ::testing::ValuesIn(rates), [](const auto& tested) { return "Hz_" + std::to_string(tested.param); });

/// Head-on in 40 phases: none passes, momentum stays zero to rounding, energy never grows.
class Pairs : public ::testing::TestWithParam<int> {};
TEST_P(Pairs, do_not_pass_each_other_head_on) {
    const int rate = GetParam();
    double worst_gain = 0, worst_momentum = 0;
    for (const bool balls : {false, true}) {
        for (const int speed : {10, 20, 40, 80, 800}) {
            for (int phase_i = 0; phase_i < HeadOn::phase_count; ++phase_i) {
                Play<FastRoom<2>> scene(bodies_from<2>([&](int i) { return HeadOn::body(i, balls, static_cast<scalar>(speed), phase_i); }),
                                        HeadOn::gravity);
                ASSERT_TRUE(scene.sound());
                EnergyWatch watch(scene);
                for (int step_i = 0; step_i < rate / 10 + 2; ++step_i) {
                    ASSERT_TRUE(scene.step(step_of(rate)).clean());
                    watch.look();
                    ASSERT_LT(scene.r(0).x(), scene.r(1).x()) << speed << " m/s, phase " << phase_i;
                    worst_momentum = std::max(worst_momentum, (scene.v(0) + scene.v(1)).norm() / speed);
                }
                EXPECT_LE(std::abs(scene.v(0).x()), 1e-5 * speed) << "e = 0";
                worst_gain = std::max(worst_gain, watch.worst());
            }
        }
    }
    figure("momentum, worst, of that of one", worst_momentum);
    figure("energy, worst gain of a step", worst_gain);
    EXPECT_LE(worst_momentum, 16 * eps);
    EXPECT_LE(worst_gain, 16 * eps);
}
INSTANTIATE_TEST_SUITE_P(Rates, Pairs, ::testing::ValuesIn(rates), [](const auto& tested) { return "Hz_" + std::to_string(tested.param); });

/// I12, in 20 phases: the middle stays before the wall, the bar is never across it, energy never grows.
TEST(SpinningBar, does_not_get_across_a_wall) {
    double furthest = -9, deepest = 0, worst_gain = 0;
    for (int phase_i = 0; phase_i < 20; ++phase_i) {
        std::vector<PlacedBody> bodies = bodies_of<scenes::SpinningBar>();
        bodies[1].def.state.r_CM.x += static_cast<scalar>(phase_i) / 120;
        Play<FastRoom<2>> scene(bodies, scenes::SpinningBar::gravity);
        ASSERT_TRUE(scene.sound());
        EnergyWatch watch(scene);
        for (int step_i = 0; step_i < 60; ++step_i) {
            (void)scene.step(scenes::SpinningBar::h);
            watch.look();
            furthest = std::max(furthest, scene.r(1).x());
            deepest = std::max(deepest, scene.deepest_overlap());
        }
        worst_gain = std::max(worst_gain, watch.worst());
    }
    figure("furthest, m", furthest);
    figure("deepest overlap, m", deepest);
    figure("energy, worst gain of a step", worst_gain);
    EXPECT_LE(furthest, -0.01);
    EXPECT_LE(deepest, static_cast<double>(ingot::limits::touching_gap));
    EXPECT_LE(worst_gain, 16 * eps);
}

/// What is not met is not felt, to the last bit; what overlaps by as much is.
TEST(Grazing, leaves_a_ball_as_it_is) {
    for (const bool oblique : {false, true}) {
        for (const double away : {0.005, 0.002, -0.005}) {
            for (int phase_i = 0; phase_i < 10; ++phase_i) {
                const scalar phase = static_cast<scalar>(phase_i) / 10;
                Play<FastRoom<2>> scene(bodies_from<2>([&](int i) { return scenes::Grazing::body(i, static_cast<scalar>(away), phase, oblique); }),
                                        scenes::Grazing::gravity);
                ASSERT_TRUE(scene.sound());
                const Vector3d v = scene.v(1);
                const double y = scene.r(1).y();
                for (int step_i = 0; step_i < 4; ++step_i) ASSERT_EQ(scene.step(scenes::Grazing::h).impacts_deferred, 0);
                const bool same = scene.v(1) == v && scene.r(1).y() == y && scene.omega(1).norm() == 0;
                EXPECT_EQ(same, away > 0) << "away " << away << ", phase " << phase << ", oblique " << oblique;
            }
        }
    }
}

/// A ball that another would have met, had that not been thrown back before, by a post or by a heavy ball: it goes on as it is, and no part of its
/// step is lost. It flies, or slides on a plate without friction, from where nobody could take it.
void expect_not_met(bool slides, bool post_flies, bool crossing_first, int phase_i) {
    constexpr scalar radius = scalar(0.0625), h = scalar(1) / 64, speed = 64;  // 1 m in a step
    // The one goes along x and is at x = meeting when the other, along y, would be at y = 0. The post stands before that.
    const scalar meeting = scalar(0.375) + scalar(0.05) * static_cast<scalar>(phase_i), z = radius + scalar(1) / 64;
    const PlacedBody plate = fixed_box({2, scalar(0.125), scalar(0.125)}, {0, 0, scalar(slides ? -0.125 : -1)}, 0, 1);
    const Vector place = {meeting, scalar(-0.1875), z};
    PlacedBody post = post_flies ? solid_ball(100, radius, place, 0, 1) : fixed_box({scalar(0.125), scalar(1) / 64, scalar(0.25)}, place, 0, 1);
    PlacedBody along = solid_ball(1, radius, {0, 0, radius}, 0, 1), crossing = solid_ball(1, radius, {meeting, -meeting, z}, 0, 1);
    if (post_flies) post.move({0, -speed, 0});
    along.move({speed, 0, 0});
    crossing.move({0, speed, 0});
    const int slot = crossing_first ? 3 : 2, other = 5 - slot;
    std::vector<PlacedBody> bodies = {plate, post, along, crossing};
    if (crossing_first) std::swap(bodies[2], bodies[3]);
    Play<FastRoom<4>> scene(bodies, {0, 0, 0});
    ASSERT_TRUE(scene.sound());
    const StepReport report = scene.step(h);
    EXPECT_TRUE(report.clean());
    EXPECT_EQ(report.impacts_deferred, 0);
    EXPECT_EQ(scene.v(slot), Vector3d(static_cast<double>(speed), 0, 0));
    EXPECT_NEAR(scene.r(slot).x(), 1, 8 * eps);
    EXPECT_LT(scene.v(other).y(), 0) << "and the other was";
    if (post_flies) return;
    // It has gone 1 m too, and turned at the post, where the gap counts twice.
    const double turns = -0.1875 - 1.0 / 64 - static_cast<double>(radius), before = turns + static_cast<double>(meeting);
    EXPECT_NEAR(scene.r(other).y(), turns - (1 - before), 2 * static_cast<double>(ingot::limits::impact_gap_max) + 16 * eps);
    EXPECT_NEAR(scene.v(other).y(), -static_cast<double>(speed), 8 * eps * static_cast<double>(speed));
}
TEST(Diverted, is_not_met_where_it_would_have_been) {
    for (const bool slides : {false, true}) {
        for (const bool post_flies : {false, true}) {
            for (const bool crossing_first : {false, true}) {
                for (int phase_i = 0; phase_i < 10; ++phase_i) {
                    SCOPED_TRACE(::testing::Message() << slides << post_flies << crossing_first << " phase " << phase_i);
                    expect_not_met(slides, post_flies, crossing_first, phase_i);
                }
            }
        }
    }
}

TEST(ThroughGap, gets_a_ball_that_fits) {
    for (int phase_i = 0; phase_i < 10; ++phase_i) {
        Play<FastRoom<3>> scene(bodies_from<3>([&](int i) { return ThroughGap::body(i, static_cast<scalar>(phase_i) / 10); }), ThroughGap::gravity);
        ASSERT_TRUE(scene.sound());
        const Vector3d v = scene.v(2);
        for (int step_i = 0; step_i < 4; ++step_i) ASSERT_TRUE(scene.step(ThroughGap::h).clean());
        EXPECT_EQ(scene.v(2), v) << phase_i;
        EXPECT_GT(scene.r(2).x(), 1);
    }
}

/// Seventeen bounces a frame for a second: it keeps its energy, and is where it should be. Each bounce rounds positions of up to 0.5 m and velocities
/// of up to 17 m a step, four times each.
TEST(BetweenPlates, a_ball_bounces_on_and_keeps_its_energy) {
    Play<FastRoom<3>> scene(bodies_from<3>([](int i) { return BetweenPlates::body(i, BetweenPlates::speed); }), BetweenPlates::gravity);
    ASSERT_TRUE(scene.sound());
    const double speed = static_cast<double>(BetweenPlates::speed), half = 0.475, h = static_cast<double>(BetweenPlates::h);
    double worst_place = 0, worst_speed = 0;
    for (int step_i = 1; step_i <= 60; ++step_i) {
        ASSERT_TRUE(scene.step(BetweenPlates::h).clean());
        const double way = std::fmod(speed * h * step_i + half, 4 * half), x = way < 2 * half ? way - half : 3 * half - way;
        worst_place = std::max(worst_place, std::abs(scene.r(2).x() - x));
        worst_speed = std::max(worst_speed, std::abs(scene.v(2).norm() / speed - 1));
    }
    figure("place, worst error, m", worst_place);
    figure("speed, worst error", worst_speed);
    EXPECT_LE(worst_place, 526 * 4 * eps * (0.5 + speed * h));
    EXPECT_LE(worst_speed, 8 * eps);
}

/// More impacts in a step than are followed: the rest of the step is lost to the ball, which is told; it stays inside, with its energy.
TEST(BetweenPlates, more_impacts_than_are_followed_are_counted) {
    Play<FastRoom<3>> scene(bodies_from<3>([](int i) { return BetweenPlates::body(i, 10000); }), BetweenPlates::gravity);
    ASSERT_TRUE(scene.sound());
    for (int step_i = 0; step_i < 20; ++step_i) {
        const StepReport report = scene.step(BetweenPlates::h);
        EXPECT_EQ(report.impacts_deferred, 1);
        EXPECT_FALSE(report.clean());
        EXPECT_LE(std::abs(scene.r(2).x()), 0.4751);
        EXPECT_NEAR(scene.v(2).norm(), 10000, 8 * eps * 10000);
    }
}

/// A light ball waits at a crate that carries another, and a heavy one comes after it as fast: it waits too. Each waits once in a step and is told,
/// the next step finds all three touching, and none is driven into what it waited at. No momentum is lost to that, and no energy comes of it.
TEST(WaitingBall, is_not_driven_through_what_it_waits_at) {
    constexpr scalar speed = 100;
    std::vector<PlacedBody> bodies = {flat_ground(0), solid_box(1000, {scalar(0.5), scalar(0.5), scalar(0.5)}, {0, 0, scalar(0.5)}, 0, 1),
                                      solid_ball(scalar(0.01), scalar(0.125), {scalar(-0.75), 0, scalar(0.5)}, 0, 1),
                                      solid_ball(1, scalar(0.125), {scalar(-1.25), 0, scalar(0.5)}, 0, 1),
                                      solid_box(1, {scalar(0.25), scalar(0.25), scalar(0.25)}, {0, 0, scalar(1.25)}, 0, 1)};
    for (const std::size_t ball_i : {2u, 3u}) bodies[ball_i].move({speed, 0, 0});
    Play<FastRoom<5>> scene(bodies, {});
    ASSERT_TRUE(scene.sound());
    const auto momentum = [&] { return scene.M(1) * scene.v(1).x() + scene.M(2) * scene.v(2).x() + scene.M(3) * scene.v(3).x(); };
    const double before = momentum();
    EnergyWatch watch(scene);
    for (int step_i = 0; step_i < 10; ++step_i) {
        const StepReport report = scene.step(display_rate_h);
        EXPECT_LE(report.impacts_deferred, step_i == 0 ? 2 : 1);
        EXPECT_EQ(report.impacts_deferred == 2, step_i == 0);
        watch.look();
        EXPECT_LE(scene.overlap(2, 1), 0.001) << step_i;
        EXPECT_LE(scene.overlap(3, 2), 0.001) << step_i;
        EXPECT_LT(scene.r(3).x(), scene.r(2).x()) << step_i;
        EXPECT_LT(scene.r(2).x(), scene.r(1).x()) << step_i;
    }
    // Three bodies whose speeds are rounded by each sweep and each of the ten steps: fewer than 1000 times, by an epsilon of all there is.
    EXPECT_NEAR(momentum(), before, 1000 * eps * before);
    EXPECT_LE(watch.worst(), 16 * eps);
}

/// One ball catches up with another, a little faster, shortly before a plate: what they do to each other takes long, and the plate is not forgotten
/// over it. None gets behind it, and both come back, as nothing takes from their energy.
TEST(CatchingUp, of_two_balls_before_a_plate_takes_none_through_it) {
    constexpr scalar radius = scalar(0.125), speed = 100;
    for (const scalar faster : {scalar(0), scalar(0.1), scalar(1), scalar(10)}) {
        for (const scalar gap : {scalar(0.001), scalar(0.01)}) {
            std::vector<PlacedBody> bodies = {fixed_box({scalar(0.05), 2, 2}, {0, 0, 0}, 0, 1),
                                              solid_ball(1, radius, {-1, 0, 0}, 0, 1),
                                              solid_ball(1, radius, {-1 - 2 * radius - gap, 0, 0}, 0, 1)};
            bodies[1].move({speed, 0, 0});
            bodies[2].move({speed + faster, 0, 0});
            Play<FastRoom<3>> scene(bodies, {});
            ASSERT_TRUE(scene.sound());
            EnergyWatch watch(scene);
            for (int step_i = 0; step_i < 10; ++step_i) {
                (void)scene.step(display_rate_h);
                watch.look();
                ASSERT_LT(scene.r(1).x(), 0) << faster << ", " << gap << ", step " << step_i;
                ASSERT_LT(scene.r(2).x(), scene.r(1).x()) << faster << ", " << gap << ", step " << step_i;
            }
            EXPECT_LT(scene.v(1).x(), 0);
            EXPECT_LE(watch.worst(), 16 * eps);
        }
    }
}

/// A bullet stays before the cube it hits, and waits for the others of the stack: a flight that was cut, and told so.
TEST(BulletIntoStack, stays_before_the_cube_it_hits) {
    for (int phase_i = 0; phase_i < 10; ++phase_i) {
        Play<FastRoom<7>> scene(bodies_from<7>([&](int i) { return BulletIntoStack::body(i, static_cast<scalar>(phase_i) / 10); }),
                                BulletIntoStack::gravity);
        ASSERT_TRUE(scene.sound());
        EnergyWatch watch(scene);
        int cut = 0;
        for (int step_i = 0; step_i < 40; ++step_i) {
            cut += scene.step(BulletIntoStack::h).impacts_deferred;
            watch.look();
            if (step_i < 12) {  // then it flies by what it has thrown over
                ASSERT_LT(scene.r(6).x(), scene.r(3).x()) << phase_i << ", step " << step_i;
            }
            ASSERT_LE(scene.overlap(6, 3), 0.001) << phase_i << ", step " << step_i;
        }
        // m v is shared by the ball and the cubes; friction with the ground takes some.
        double momentum = 0.1 * scene.v(6).x();
        for (int cube_i = 1; cube_i < 6; ++cube_i) momentum += 4 * scene.v(cube_i).x();
        EXPECT_LE(momentum, 50 * (1 + 16 * eps));
        EXPECT_GT(momentum, 25);
        EXPECT_GE(cut, 1);
        EXPECT_LE(watch.worst(), watch.allowed_in_a_crowd) << phase_i;
    }
}

/// Nobody gets beyond the immovable plate behind the walls; energy never grows.
void expect_walls_stop_bullets(double overlap_allowed) {
    Play<FastRoom<BulletWalls::body_count>> scene(bodies_of<BulletWalls>(), BulletWalls::gravity);
    ASSERT_TRUE(scene.sound());
    EnergyWatch watch(scene);
    double furthest = 0, deepest = 0;
    scene.run(BulletWalls::h, 2, [&](int) {
        watch.look();
        for (int i = 2; i < BulletWalls::body_count; ++i) furthest = std::max(furthest, scene.r(i).x());
        deepest = std::max(deepest, scene.deepest_overlap());
    });
    figure("furthest, m", furthest);
    figure("deepest overlap, m", deepest);
    figure("energy, worst gain of a step", watch.worst());
    EXPECT_TRUE(scene.finite());
    EXPECT_LT(furthest, 5);
    EXPECT_LE(deepest, overlap_allowed);
    EXPECT_LE(watch.worst(), watch.allowed_in_a_crowd);
}
TEST(BulletWalls, are_not_left_in_each_other) { expect_walls_stop_bullets(0.005); }

/// A body of any kind but a half space, about 0.1 m large.
PlacedBody any_shape(int kind, const Vector& r, scalar mu, scalar e) {
    PlacedBody body = solid_box(1, {scalar(0.1), scalar(0.08), scalar(0.03)}, r, mu, e);
    if (kind == 1) return body;
    if (kind == 0) return solid_ball(1, scalar(0.05), r, mu, e);
    if (kind == 2) body.def.shape = ingot::Capsule{scalar(0.03), scalar(0.08)};
    if (kind == 3) body.def.shape = ingot::Cylinder{scalar(0.05), scalar(0.08)};
    return body;
}

/// Twelve bodies at up to 300 m/s along each axis, and spins up to `spin`, in a room of 2 m whose walls are plates of 1 cm.
template <int kinds_from, int kinds_to>
std::vector<PlacedBody> room_full_of_bullets(int seed, scalar e, scalar spin) {
    std::vector<PlacedBody> bodies;
    const scalar half = 1, thin = scalar(0.005), wide = half + 2 * thin, mu = scalar(0.3);
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {-1, 1}) {
            const scalar at = static_cast<scalar>(side) * (half + thin);
            bodies.push_back(fixed_box({axis == 0 ? thin : wide, axis == 1 ? thin : wide, axis == 2 ? thin : wide},
                                       {axis == 0 ? at : 0, axis == 1 ? at : 0, axis == 2 ? at : 0}, mu, e));
        }
    }
    for (int i = 0; i < 12; ++i) {
        const int index = 100 * seed + i;
        const auto place = [&](int cell, int channel) {
            return scalar(0.6) * static_cast<scalar>(cell - 1) + scalar(0.1) * scattered(index, channel);
        };
        PlacedBody body = any_shape(kinds_from + i % (kinds_to - kinds_from + 1), {place(i % 3, 0), place(i / 3 % 3, 1), place(i / 9, 2)}, mu, e);
        body.turn(scattered_rotation(index));
        body.move(Vector{scattered(index, 3), scattered(index, 4), scattered(index, 5)} * scalar(300),
                  Vector{scattered(index, 6), scattered(index, 7), scattered(index, 8)} * spin);
        bodies.push_back(body);
    }
    return bodies;
}

/// None escapes in a second; there is never more energy than at the start.
template <int from, int to>
void expect_none_escapes(scalar spin) {
    int escaped = 0, cut = 0;
    double most = 0;
    for (int seed = 0; seed < 6; ++seed) {
        for (const int rate : rates) {
            Play<FastRoom<18>> scene(room_full_of_bullets<from, to>(seed, scalar(0.8), spin), {0, 0, -standard_gravity});
            ASSERT_TRUE(scene.sound());
            const double start = scene.energy();
            for (int step_i = 0; step_i < rate; ++step_i) {
                cut += scene.step(step_of(rate)).impacts_deferred;
                most = std::max(most, scene.energy() / start);
                for (int i = 6; i < 18; ++i) escaped += !(scene.r(i).cwiseAbs().maxCoeff() < 1);
            }
            EXPECT_EQ(escaped, 0) << "seed " << seed << ", " << rate << " Hz";
            EXPECT_TRUE(scene.finite());
        }
    }
    figure("energy, most, of the start", most);
    figure("flights cut", cut);
    EXPECT_LE(most, 1 + 16 * eps);
}
TEST(ThinRoom, keeps_balls_in) { expect_none_escapes<0, 0>(300); }
TEST(ThinRoom, keeps_boxes_in) { expect_none_escapes<1, 1>(300); }
TEST(ThinRoom, keeps_capsules_in) { expect_none_escapes<2, 2>(300); }
TEST(ThinRoom, keeps_cylinders_in) { expect_none_escapes<3, 3>(300); }
TEST(ThinRoom, keeps_all_kinds_in) { expect_none_escapes<0, 3>(300); }
struct Follows : Room<11> {
    static constexpr bool continuous = true;
};
/// Where nobody is fast, a scene that follows fast bodies is the one that does not, to the last bit.
TEST(SlowScenes, are_what_they_were) {
    Play<Room<11>> plain(bodies_of<Tower<10>>(), Tower<10>::gravity);
    Play<Follows> follows(bodies_of<Tower<10>>(), Tower<10>::gravity);
    for (int step_i = 0; step_i < 60; ++step_i) {
        (void)plain.step(OnEarth::h);
        EXPECT_EQ(follows.step(OnEarth::h).impacts_deferred, 0);
        ASSERT_EQ(plain.world().state_hash(), follows.world().state_hash()) << step_i;
    }
}

}  // namespace
