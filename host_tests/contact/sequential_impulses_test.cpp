// SPDX-License-Identifier: MIT
// SequentialImpulses, at what the other solver is asked: towers, inclines, spin, balls, momentum; and with what else
// a scene may name.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "contact/play.h"
#include "reference/ball_and_brick.h"

namespace {

using namespace ingot_contact;
using namespace scenes;

constexpr double eps = static_cast<double>(ingot::epsilon);
/// What rows at rest may leave of a speed, m/s: nobody takes a slip back but friction, which leaves that alone.
constexpr double ignored_speed = static_cast<double>(ingot::limits::ignored_speed);

template <int size>
struct LightRoomOfSize : Room<size> {
    static constexpr bool bounces = false;
    using solver = ingot::SequentialImpulses;
};
template <int bodies>
using LightRoom = LightRoomOfSize<room_size(bodies)>;
template <class Scene>
Play<LightRoom<Scene::body_count>> play_lightly() {
    return {bodies_of<Scene>(), Scene::gravity};
}

/// Sinks <= 0.2 mm and drifts <= 1 mm within 60 s, and is at rest then: no faster than two sweeps may leave at each contact below.
template <class S>
void expect_rest(Play<S> scene, double overlap_mm = 0.2) {
    ASSERT_TRUE(scene.sound());
    double worst_sink = 0, worst_shift = 0;
    scene.run(OnEarth::h, 60, [&](int) {
        worst_sink = std::max(worst_sink, scene.sink());
        worst_shift = std::max(worst_shift, scene.shift());
    });
    figure("worst sink, mm", 1e3 * worst_sink);
    figure("worst shift, mm", 1e3 * worst_shift);
    figure("fastest, m/s", scene.fastest());
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(1e3 * worst_sink, overlap_mm);
    EXPECT_LE(1e3 * worst_shift, 1);
    EXPECT_LE(scene.fastest(), 1e-3);
}
TEST(SequentialImpulses, carry_boxes_side_by_side) { expect_rest(play_lightly<TenBoxes<false>>()); }
TEST(SequentialImpulses, carry_a_column_of_ten) { expect_rest(play_lightly<TenBoxes<true>>()); }
TEST(SequentialImpulses, carry_ten_times_the_mass) { expect_rest(play_lightly<MassRatio<1, 10>>()); }
TEST(SequentialImpulses, carry_ten_times_the_mass_on_three) { expect_rest(play_lightly<MassRatio<3, 10>>()); }
TEST(SequentialImpulses, carry_a_wall) { expect_rest(play_lightly<Pyramid<4>>()); }

/// Five boxes of unlike sizes and masses on each other, turned about the vertical. From the top: the pairs are sorted by slots, so that sweeps begin
/// at the wrong end.
template <bool from_the_top>
PlacedBody unlike_box(int body_i) {
    if (body_i == 0) return flat_ground(scalar(0.6));
    constexpr scalar half[5][3] = {{1, scalar(0.8), scalar(0.2)},
                                   {scalar(0.5), scalar(0.5), scalar(0.5)},
                                   {scalar(0.7), scalar(0.3), scalar(0.1)},
                                   {scalar(0.25), scalar(0.25), scalar(0.4)},
                                   {scalar(0.4), scalar(0.5), scalar(0.3)}};
    constexpr scalar M[5] = {3, 1, 2, scalar(0.5), 1};
    const int box_i = from_the_top ? 5 - body_i : body_i - 1;
    scalar z = half[box_i][2];
    for (int below = 0; below < box_i; ++below) z += 2 * half[below][2];
    PlacedBody box = solid_box(M[box_i], {half[box_i][0], half[box_i][1], half[box_i][2]}, {0, 0, z}, scalar(0.6));
    const scalar c = scalar(0.8), s = box_i % 2 == 0 ? scalar(0.6) : scalar(-0.6);
    box.turn({{c, s, 0}, {-s, c, 0}, {0, 0, 1}});
    return box;
}
TEST(SequentialImpulses, carry_unlike_boxes) { expect_rest(Play<LightRoom<6>>(bodies_from<6>(unlike_box<false>), OnEarth::gravity)); }
TEST(SequentialImpulses, carry_unlike_boxes_from_whichever_end) {
    expect_rest(Play<LightRoom<6>>(bodies_from<6>(unlike_box<true>), OnEarth::gravity));
}

/// A slip that is ignored goes on: in 10 s it is 1 um.
TEST(SequentialImpulses, do_not_creep_on_an_incline) {
    auto scene = play_lightly<Incline<70>>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 10);
    const double creep = to_eigen(thirty_degrees.down()).dot(scene.moved(1));
    figure("creep, mm", 1e3 * creep);
    EXPECT_LE(std::abs(creep), ignored_speed * 10);
}

TEST(SequentialImpulses, slide_the_exact_way) {
    auto scene = play_lightly<Incline<40>>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 2);
    const double way = to_eigen(thirty_degrees.down()).dot(scene.moved(1));
    const double exact = static_cast<double>(ingot_reference::BrickOnIncline(9.81L, 0.4L, 0.5L, std::sqrt(0.75L), 0).at(2).s);
    figure("error of the way, %", 100 * (way / exact - 1));
    EXPECT_LE(std::abs(way / exact - 1), 1e-4);
}

/// Boxes dropped on a face and on a corner, on their way sideways: friction and impacts only take energy. A step may round it by some units in the
/// last place of what there is, and lift the box by the overlaps that it takes back: settled_gap_of_points and what one more substep adds.
TEST(SequentialImpulses, gain_no_energy_where_boxes_fall) {
    for (int tilt_i = 0; tilt_i < 4; ++tilt_i) {
        PlacedBody box = solid_box(2, {scalar(0.5), scalar(0.3), scalar(0.2)}, {0, 0, scalar(1.5)}, scalar(0.5));
        if (tilt_i > 0) box.turn(scattered_rotation(tilt_i));
        box.move({3, 1, 0}, {});
        Play<LightRoom<2>> scene({flat_ground(scalar(0.5)), box}, OnEarth::gravity);
        ASSERT_TRUE(scene.sound());
        double before = scene.energy(), most = 0;
        const double start = before;
        scene.run(OnEarth::h, 6, [&](int) {
            most = std::max(most, scene.energy() - before);
            before = scene.energy();
        });
        figure("largest gain of a step, of the energy", most / start);
        figure("fastest at the end, m/s", scene.fastest());
        EXPECT_LE(most, 64 * eps * start + 2 * 9.81 * 2 * static_cast<double>(ingot::limits::settled_gap_of_points)) << tilt_i;
        EXPECT_LE(scene.fastest(), 1e-3) << tilt_i;
        EXPECT_TRUE(scene.finite() && scene.reports().clean());
    }
}

/// A cube that spins on the floor is stopped by mu N R, R the mean distance of its corners from the middle: omega_0 I / (mu M g R), I = M/6.
TEST(SequentialImpulses, stop_a_twist_in_time) {
    constexpr double mu = 0.4, spin = 6, radius = 0.70710678118654752;
    PlacedBody cube = unit_cube({0, 0, scalar(0.5)}, scalar(mu));
    cube.move({}, {0, 0, scalar(spin)});
    Play<LightRoom<2>> scene({flat_ground(scalar(mu)), cube}, OnEarth::gravity);
    const double exact = spin / 6 / (mu * 9.81 * radius);
    double stopped_at = -1;
    scene.run(OnEarth::h, 2, [&](int step_i) {
        if (stopped_at < 0 && scene.omega(1).norm() < 1e-3) stopped_at = step_i / 60.0;
    });
    figure("stops after, s", stopped_at);
    figure("exact, s", exact);
    EXPECT_NEAR(stopped_at, exact, 1.0 / 60 + 0.01 * exact);
    EXPECT_LE(scene.drift(1), 1e-3);
}

/// C3: a ball that slides comes to roll: 5/7 of its speed, after 2 v / (7 mu g); and rolls on.
TEST(SequentialImpulses, let_balls_roll) {
    constexpr double mu = 0.25, v = 3;
    PlacedBody ball = solid_ball(2, scalar(0.5), {0, 0, scalar(0.5)}, scalar(mu));
    ball.move({scalar(v), 0, 0}, {});
    Play<LightRoom<2>> scene({flat_ground(scalar(mu)), ball}, OnEarth::gravity);
    double rolls_at = -1, worst_slip = 0;
    scene.run(OnEarth::h, 10, [&](int step_i) {
        const double slip = (scene.v(1) + scene.omega(1).cross(Vector3d(0, 0, -0.5))).norm();
        if (rolls_at < 0 && slip < 1e-3) rolls_at = step_i / 60.0;
        if (rolls_at > 0) worst_slip = std::max(worst_slip, slip);
    });
    figure("rolls after, s", rolls_at);
    figure("speed, relative error", scene.v(1).x() / (5 * v / 7) - 1);
    figure("worst slip, m/s", worst_slip);
    EXPECT_NEAR(rolls_at, 2 * v / (7 * mu * 9.81), 1.5 / 60);
    EXPECT_NEAR(scene.v(1).x(), 5 * v / 7, 0.002 * v);
    EXPECT_LE(worst_slip, 1e-3);
}

/// Six boxes and balls meet in empty space: every impulse has its opposite at the same point. Angular momentum changes by the way that bodies go in
/// a step, while levers stay as they are: of first order in h.
struct Momenta {
    double p = 0, L = 0;  ///< N s, N m s; the largest change
    int contacts = 0;
};
Momenta momenta_that_change(double h) {
    std::vector<PlacedBody> bodies;
    for (int i = 0; i < 6; ++i) {
        const Vector r = {scalar(i % 2) - scalar(0.5), scalar(i / 2 % 2) - scalar(0.5), scalar(i / 4) - scalar(0.5)};
        PlacedBody body = i % 3 == 2 ? solid_ball(2, scalar(0.45), r * scalar(1.5), scalar(0.5))
                                     : solid_box(scalar(1 + i), {scalar(0.5), scalar(0.4), scalar(0.45)}, r * scalar(1.5), scalar(0.5));
        if (i % 3 != 2) body.turn(scattered_rotation(i));
        body.move(r * scalar(-2), {scattered(i, 0), scattered(i, 1), scattered(i, 2)});
        bodies.push_back(body);
    }
    Play<LightRoom<6>> scene(bodies, {});
    EXPECT_TRUE(scene.sound());
    Momenta most;
    const Vector3d p = to_eigen(scene.world().linear_momentum()), L = to_eigen(scene.world().angular_momentum());
    scene.run(static_cast<scalar>(h), 3, [&](int) {
        most.p = std::max(most.p, (to_eigen(scene.world().linear_momentum()) - p).norm());
        most.L = std::max(most.L, (to_eigen(scene.world().angular_momentum()) - L).norm());
    });
    most.contacts = scene.reports().most_contacts;
    figure("linear momentum, largest change, N s", most.p);
    figure("angular momentum, largest change, N m s", most.L);
    return most;
}
TEST(SequentialImpulses, keep_momentum) {
    const Momenta coarse = momenta_that_change(1.0 / 60), fine = momenta_that_change(1.0 / 960);
    EXPECT_GE(coarse.contacts, 4);
    // 20 kg at 2 m/s: 40 N s. Each step rounds each body some times, and the steps add up.
    EXPECT_LE(coarse.p, 180 * 6 * eps * 40);
    EXPECT_LE(fine.p, 2880 * 6 * eps * 40);
    EXPECT_LE(fine.L, coarse.L / 4);
}

template <int events, class Solver = ingot::SequentialImpulses>
struct LightPit : Room<8> {
    static constexpr bool bounces = false, filters = true, sleeps = true;
    static constexpr int max_overlaps = 4, max_events = events;
    using solver = Solver;
};
/// A tower of three, a sensor around it, and balls that roll into both.
std::vector<PlacedBody> pit() {
    std::vector<PlacedBody> bodies = {flat_ground(scalar(0.5)), fixed_box({2, 2, 2}, {0, 0, 2}, scalar(0.5))};
    bodies[1].def.sensor = true;
    for (int i = 0; i < 3; ++i) bodies.push_back(unit_cube({0, 0, scalar(i) + scalar(0.5)}, scalar(0.5)));
    for (int i = 0; i < 3; ++i) {
        PlacedBody ball = solid_ball(1, scalar(0.5), {scalar(-4 - 2 * i), scalar(0.1), scalar(0.5)}, scalar(0.5));
        ball.move({4, 0, 0}, {0, 8, 0});
        bodies.push_back(ball);
    }
    bodies.back().def.filter = {2, 4};  // falls through the ground
    return bodies;
}

/// Filters, sensors, events and sleep are asked of manifolds and bodies, whoever solves: the tower falls asleep, is hit, and wakes.
TEST(SequentialImpulses, let_scenes_filter_sense_tell_and_sleep) {
    Play<LightPit<24>> scene(pit(), OnEarth::gravity);
    ASSERT_TRUE(scene.sound());
    int begins = 0, enters = 0, hits = 0;
    scene.run(OnEarth::h, 10, [&](int) {
        for (const ingot::Event& event : scene.world().events()) {
            begins += event.kind == ingot::EventKind::begin;
            enters += event.kind == ingot::EventKind::enter;
            hits += event.kind == ingot::EventKind::hit;
        }
    });
    EXPECT_GE(begins, 3 + 2 + 1);  // cubes on each other, balls on the ground, a ball and the tower
    EXPECT_GE(enters, 3 + 1);
    EXPECT_GE(hits, 1);
    EXPECT_LT(scene.r(7).z(), -10);
    EXPECT_GT(scene.drift(2), 1e-3);
    EXPECT_TRUE(scene.world().is_asleep(scene.id(2)));
}

/// A snapshot in the middle of it goes on to the same bits.
TEST(SequentialImpulses, go_on_from_a_snapshot_to_the_bit) {
    Play<LightPit<0>> scene(pit(), OnEarth::gravity);
    std::vector<uint8_t> bytes(ingot::snapshot_size<LightPit<0>>());
    for (const int steps : {10, 60, 30, 30, 240}) {
        scene.run(OnEarth::h, steps / 60.0);
        const ingot::Result<std::size_t> size = ingot::save_snapshot(scene.world(), bytes.data(), bytes.size());
        ASSERT_TRUE(size.ok());
        auto other = std::make_unique<ingot::World<LightPit<0>>>();
        ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), size.value), Status::ok);
        for (int step_i = 0; step_i < 60; ++step_i) {
            (void)scene.step(OnEarth::h);
            (void)ingot::step(*other, OnEarth::h);
            ASSERT_EQ(scene.world().state_hash(), other->state_hash()) << step_i;
        }
    }
}

/// A snapshot of a scene that is like it but for the solver is refused: the steps that follow would be others.
TEST(SequentialImpulses, refuse_the_snapshots_of_other_solvers) {
    EXPECT_NE(ingot::scene_signature<LightPit<0>>(), (ingot::scene_signature<LightPit<0, ingot::BlockSweeps>>()));
}

/// A body that forces drive out of range freezes, and is no trouble to those it touches.
TEST(SequentialImpulses, freeze_a_body_that_runs_away) {
    Play<LightRoom<5>> scene({flat_ground(scalar(0.5)), unit_cube({0, 0, scalar(0.5)}, scalar(0.5)), unit_cube({0, 0, scalar(1.5)}, scalar(0.5)),
                              unit_cube({4, 0, scalar(0.5)}, scalar(0.5)), unit_cube({4, 0, scalar(1.5)}, scalar(0.5))},
                             OnEarth::gravity);
    scene.run(OnEarth::h, 1);
    ASSERT_EQ(scene.world().add_torque(scene.id(2), {0, 0, ingot::limits::torque_max}), Status::ok);
    const StepReport report = scene.step(OnEarth::h);
    EXPECT_EQ(report.bodies_frozen, 1);
    EXPECT_TRUE(scene.world().is_frozen(scene.id(2)));
    scene.run(OnEarth::h, 1);
    EXPECT_TRUE(scene.finite());
    const double h = static_cast<double>(OnEarth::h), fall = 9.81 * h * h / 2;  // it froze as it would have been without contacts
    for (const int body_i : {1, 3, 4}) {
        EXPECT_FALSE(scene.world().is_frozen(scene.id(body_i)));
        EXPECT_LE(scene.moved(body_i).norm(), body_i == 1 ? fall : 1e-4) << body_i;
        EXPECT_LE(scene.v(body_i).norm(), 1e-3) << body_i;
    }
}

/// Overlaps at the begin are taken back at no more than push_speed_max, and leave no speed behind: 0.2 m within 10 s to a thousandth.
TEST(SequentialImpulses, part_what_overlaps_without_energy) {
    Play<LightRoom<2>> scene({fixed_box({1, 1, scalar(0.5)}, {0, 0, 0}, scalar(0.5)), unit_cube({0, 0, scalar(0.8)}, scalar(0.5))}, {});
    double fastest = 0;
    scene.run(OnEarth::h, 2, [&](int) { fastest = std::max(fastest, scene.fastest()); });
    figure("overlap, mm", 1e3 * scene.deepest_overlap());
    figure("fastest, m/s", fastest);
    EXPECT_LE(scene.deepest_overlap(), 2e-4);
    EXPECT_LE(fastest, 10 * ignored_speed);
}

}  // namespace
