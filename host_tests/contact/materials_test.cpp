// SPDX-License-Identifier: MIT
// Rolling resistance and surfaces that move, against closed forms.
//
// Errors: a solve of a substep leaves limits::settled_speed_of_small, and each of its additions rounds v by epsilon / 2; both add up over the
// substeps, of which a step has limits::substeps. Ways are their sum over time.
#include <gtest/gtest.h>

#include "contact/play.h"
#include "replay/snapshot_fields.h"
#include "scenes/stacked.h"

#include <cmath>
#include <cstring>

namespace {

using namespace ingot_contact;
using namespace scenes;

template <int size>
struct MaterialRoomOfSize : Room<size> {
    static constexpr bool rolling_resistance = true, surface_velocities = true;
};
template <int bodies>
using MaterialRoom = MaterialRoomOfSize<room_size(bodies)>;
struct CapsuleRoom : MaterialRoom<2> {
    using shapes = ingot::Shapes<ingot::Capsule, ingot::HalfSpace>;
};
struct SleepRoom : MaterialRoom<2> {
    static constexpr bool sleeps = true;
};
struct RoomOfSides : MaterialRoom<3> {
    static constexpr int max_shapes_of_body = 2;
};
struct RollingRoom : Room<ConveyorLine::body_count> {
    static constexpr bool rolling_resistance = true;
};
struct BeltRoom : Room<ConveyorLine::body_count> {
    static constexpr bool surface_velocities = true;
};

/// Bodies with their materials, in room for them.
template <int bodies, class S = MaterialRoom<bodies>>
Play<S> play_materials(const std::vector<MaterialBody>& all, const Vector& gravity) {
    std::vector<PlacedBody> placed;
    for (const MaterialBody& one : all) placed.push_back(one.body);
    Play<S> scene(placed, gravity);
    for (int i = 0; i < scene.body_count(); ++i) {
        const MaterialBody& one = all[static_cast<std::size_t>(i)];
        EXPECT_EQ(scene.world().set_rolling_resistance(scene.id(i), one.rolling_lever), Status::ok);
        EXPECT_EQ(scene.world().set_surface_velocity(scene.id(i), one.surface_velocity), Status::ok);
    }
    EXPECT_TRUE(scene.sound());
    return scene;
}

/// What may be left of a speed up to v after so many seconds, and of the way; m/s, m.
struct Allowed {
    double speed, way;
};
Allowed allowed(double seconds, double v) {
    const double substeps = seconds / static_cast<double>(OnEarth::h) * ingot::limits::substeps;
    const double speed = substeps * (static_cast<double>(ingot::limits::settled_speed_of_small) + 2 * static_cast<double>(ingot::epsilon) * v);
    return {speed, speed * seconds};
}

constexpr double g = 9.81;
const double h = 1.0 / 60;

/// A ball of radius R that rolls slows by (5/7) (lever / R) g, and stops: from M dv/dt = -F, I domega/dt = F R - lever M g with I = (2/5) M R^2 and
/// v = omega R. Whoever of the two has the lever.
TEST(RollingResistance, slows_a_ball_by_its_law_and_stops_it) {
    constexpr double R = 0.5, lever = 0.05, v_0 = 2, a = 5.0 / 7 * lever / R * g, t_stop = v_0 / a;
    for (const bool of_ball : {true, false}) {
        PlacedBody ball = solid_ball(3, scalar(R), {0, 0, scalar(R)}, scalar(0.5));
        ball.move({scalar(1.6), scalar(1.2), 0}, {scalar(-1.2 / R), scalar(1.6 / R), 0});
        auto scene = play_materials<2>({{flat_ground(scalar(0.5)), scalar(of_ball ? 0 : lever), {}}, {ball, scalar(of_ball ? lever : 0.01), {}}},
                                       OnEarth::gravity);
        const Allowed most = allowed(t_stop, v_0);
        const Vector3d way(0.8, 0.6, 0);
        double worst = 0, stopped_at = -1;
        scene.run(OnEarth::h, 5, [&](int step_i) {
            const double t = step_i * h, v = std::max(v_0 - a * t, 0.0);
            if (std::abs(t - t_stop) > h) worst = std::max(worst, (scene.v(1) - way * v).norm());
            if (stopped_at < 0 && scene.v(1).norm() < 1e-3) stopped_at = t;
        });
        figure("error of the speed, m/s", worst);
        figure("allowed", most.speed);
        figure("error of the stopping distance, m", scene.drift(1) - v_0 * v_0 / (2 * a));
        figure("speed after it has stopped, m/s", scene.v(1).norm());
        EXPECT_LE(worst, most.speed);
        EXPECT_NEAR(stopped_at, t_stop, h);
        EXPECT_NEAR(scene.drift(1), v_0 * v_0 / (2 * a), most.way + a * h * h);  // where within the step it stops
        EXPECT_LE(scene.v(1).norm(), static_cast<double>(ingot::limits::settled_speed_of_small));
    }
}

/// On an incline it stays where it is up to tan(alpha) = lever / R; beyond, it rolls with (5/7) (g sin - (lever / R) g cos).
TEST(RollingResistance, holds_a_ball_up_to_its_angle) {
    for (const double factor : {1.01, 0.99}) {
        const double R = 0.5, lever = R / 8 * factor, seconds = factor > 1 ? 60 : 4;
        const PlacedBody ball = solid_ball(1, scalar(R), one_eighth.up() * scalar(R), scalar(0.5));
        auto scene = play_materials<2>({{half_space(one_eighth.up(), 0, scalar(0.5)), 0, {}}, {ball, scalar(lever), {}}}, OnEarth::gravity);
        scene.run(OnEarth::h, seconds);
        const double way = to_eigen(one_eighth.down()).dot(scene.moved(1));
        figure(factor > 1 ? "way in a minute, m" : "way, m", way);
        if (factor > 1) {
            EXPECT_LE(std::abs(way), 1e-5) << "as C6 asks of a brick";
        } else {
            const double a = 5.0 / 7 * g * (static_cast<double>(one_eighth.sin_alpha) - lever / R * static_cast<double>(one_eighth.cos_alpha));
            figure("error of the way, m", way - a * seconds * seconds / 2);
            EXPECT_NEAR(way, a * seconds * seconds / 2, allowed(seconds, a * seconds).way);
        }
    }
}

/// Two balls that are pressed together, one of which spins: each turn takes lever F of the other's until they turn alike. The sum of L stays.
TEST(RollingResistance, is_between_two_bodies) {
    constexpr double R = 0.5, lever = 0.02, force = 30, omega = 4, I = 0.4 * R * R;
    PlacedBody left = solid_ball(1, scalar(R), {scalar(-R), 0, 0}, 0), right = solid_ball(1, scalar(R), {scalar(R), 0, 0}, 0);
    left.move({}, {0, 0, scalar(omega)});
    auto scene = play_materials<2>({{left, scalar(lever), {}}, {right, 0, {}}}, {0, 0, 0});
    const double rate = lever * force / I, t_equal = omega / 2 / rate;
    double worst = 0;
    for (int step_i = 1; step_i <= 60; ++step_i) {
        for (const int i : {0, 1}) EXPECT_EQ(scene.world().add_central_force(scene.id(i), {scalar(i == 0 ? force : -force), 0, 0}), Status::ok);
        (void)scene.step(OnEarth::h);
        const double given = std::min(rate * step_i * h, omega / 2);
        if (std::abs(step_i * h - t_equal) > h)
            worst = std::max({worst, std::abs(scene.omega(0).z() - omega + given), std::abs(scene.omega(1).z() - given)});
        EXPECT_NEAR((scene.omega(0) + scene.omega(1)).z(), omega, 400 * static_cast<double>(ingot::epsilon) * omega);
    }
    figure("error of the spin, rad/s", worst);
    EXPECT_LE(worst, allowed(1, omega * R).speed / R);
}

/// A capsule that lies rolls as a cylinder does: (M + I / R^2) a = -M g lever / R.
TEST(RollingResistance, stops_what_lies_along_a_line) {
    constexpr double R = 0.25, lever = 0.01;
    PlacedBody capsule;
    capsule.def.mass = mass_of(ingot::with_mass(ingot::solid_capsule(1, scalar(R), scalar(0.5)), 2));
    capsule.def.shape = ingot::Capsule{scalar(R), scalar(0.5)};
    capsule.def.state.r_CM = {0, 0, scalar(R)};
    capsule.mu = scalar(0.5);
    capsule.turn({{0, 0, -1}, {1, 0, 0}, {0, -1, 0}});  // its axis along -y
    capsule.move({1, 0, 0}, {0, scalar(1 / R), 0});
    auto scene = play_materials<2, CapsuleRoom>({{flat_ground(scalar(0.5)), 0, {}}, {capsule, scalar(lever), {}}}, OnEarth::gravity);
    const double I = static_cast<double>(capsule.def.mass.I_body.z), a = 2 * g * lever / R / (2 + I / (R * R));
    scene.run(OnEarth::h, 2);
    figure("error of the speed, m/s", scene.v(1).x() - (1 - a * 2));
    EXPECT_NEAR(scene.v(1).x(), 1 - a * 2, allowed(2, 1).speed);
}

/// A box that is put on a belt gets mu g t, until it has the belt's speed; then it rides on it.
TEST(Belt, brings_a_box_to_its_speed_by_friction) {
    constexpr double mu = 0.4, V = 1.5, t_ride = V / (mu * g);
    auto scene = play_materials<2>(
        {{fixed_box({20, 2, scalar(0.5)}, {0, 0, scalar(-0.5)}, scalar(mu)), 0, {scalar(-V), 0, 0}}, {parcel(flat, scalar(mu)), 0, {}}},
        OnEarth::gravity);
    double worst = 0;
    scene.run(OnEarth::h, 3, [&](int step_i) {
        const double t = step_i * h, v = -std::min(mu * g * t, V);
        if (std::abs(t - t_ride) > h) worst = std::max(worst, (scene.v(1) - Vector3d(v, 0, 0)).norm());
    });
    const double way = -V * t_ride / 2 - V * (3 - t_ride);
    figure("error of the speed, m/s", worst);
    figure("error of the way, m", scene.moved(1).x() - way);
    EXPECT_LE(worst, allowed(3, V).speed);
    EXPECT_NEAR(scene.moved(1).x(), way, allowed(3, V).way + mu * g * h * h);  // where within the step it begins to ride
    EXPECT_EQ(scene.state(0).r_CM.x, 0);
}

/// Up an incline with (mu cos - sin) g, then with the belt: it does not slide back.
TEST(Belt, carries_a_box_up_an_incline) {
    constexpr double mu = 0.9, V = 1, sin_alpha = 0.5;
    const double cos_alpha = std::sqrt(0.75), a = g * (mu * cos_alpha - sin_alpha), t_ride = V / a;
    PlacedBody incline = fixed_box({20, 2, scalar(0.5)}, thirty_degrees.up() * scalar(-0.5), scalar(mu));
    incline.turn(thirty_degrees.A());
    auto scene = play_materials<2>({{incline, 0, {scalar(-V), 0, 0}}, {parcel(thirty_degrees, scalar(mu)), 0, {}}}, OnEarth::gravity);
    const Vector3d up_the_slope = -to_eigen(thirty_degrees.down());
    double worst = 0;
    scene.run(OnEarth::h, 4, [&](int step_i) {
        const double t = step_i * h;
        if (std::abs(t - t_ride) > h) worst = std::max(worst, (scene.v(1) - up_the_slope * std::min(a * t, V)).norm());
    });
    const double way = V * t_ride / 2 + V * (4 - t_ride);
    figure("error of the speed, m/s", worst);
    figure("error of the way, m", up_the_slope.dot(scene.moved(1)) - way);
    EXPECT_LE(worst, allowed(4, V).speed);
    EXPECT_NEAR(up_the_slope.dot(scene.moved(1)), way, allowed(4, V).way + a * h * h);
}

/// A ball on a belt slides for 2 V / (7 mu g) and then rolls, with 2/7 of the belt's speed and its rim with all of it.
TEST(Belt, sets_a_ball_rolling_with_two_sevenths_of_its_speed) {
    constexpr double mu = 0.25, V = 2, R = 0.5, t_roll = 2 * V / (7 * mu * g);
    auto scene = play_materials<2>(
        {{flat_ground(scalar(mu)), 0, {0, scalar(V), 0}}, {solid_ball(1, scalar(R), {0, 0, scalar(R)}, scalar(mu)), 0, {}}}, OnEarth::gravity);
    double rolls_at = -1;
    scene.run(OnEarth::h, 4, [&](int step_i) {
        const double rim = (scene.v(1) + scene.omega(1).cross(Vector3d(0, 0, -R))).y();
        if (rolls_at < 0 && std::abs(rim - V) < 1e-3) rolls_at = step_i * h;
    });
    const Vector3d v = scene.v(1), rim = v + scene.omega(1).cross(Vector3d(0, 0, -R));
    figure("error of the speed, m/s", v.y() - V * 2 / 7);
    EXPECT_NEAR(rolls_at, t_roll, h);
    EXPECT_LE((v - Vector3d(0, V * 2 / 7, 0)).norm(), allowed(4, V).speed);
    EXPECT_LE((rim - Vector3d(0, V, 0)).norm(), allowed(4, V).speed);
}

/// Who moves with the belt sees ground: a ball that bounces and comes to roll, with and without resistance, does so as over ground at rest, but for
/// rounding. In chains of impacts too: two balls above each other.
TEST(Belt, is_ground_to_who_moves_with_it) {
    for (const double lever : {0.0, 0.01}) {
        constexpr double V = 0.75;
        const auto with_belt = [&](double belt) {
            PlacedBody lower = solid_ball(1, scalar(0.5), {0, 0, scalar(0.5)}, scalar(0.5), 1),
                       upper = solid_ball(1, scalar(0.25), {0, 0, scalar(1.375)}, scalar(0.5), scalar(0.5));
            lower.move({scalar(1 + belt), 0, -1}, {0, -6, 0});
            upper.move({scalar(1 + belt), scalar(0.25), -2}, {0, 3, 0});
            return play_materials<3>({{flat_ground(scalar(0.5), 1), 0, {scalar(belt), 0, 0}}, {lower, scalar(lever), {}}, {upper, scalar(lever), {}}},
                                     {0, 0, -8});
        };
        auto still = with_belt(0), moving = with_belt(V);
        double worst = 0;
        still.run(OnEarth::h, 0.25, [&](int) {
            (void)moving.step(OnEarth::h);
            for (const int i : {1, 2})
                worst = std::max({worst, (still.v(i) - moving.v(i) + Vector3d(V, 0, 0)).norm(), (still.omega(i) - moving.omega(i)).norm()});
        });
        figure("largest difference, m/s and rad/s", worst);
        EXPECT_LE(worst, allowed(0.25, 2).speed / 0.25);
    }
}

/// A crawler on a slab that slides freely: momentum stays, and the two part at the speed of its surface.
TEST(Belt, of_a_body_that_moves_pushes_back) {
    constexpr double s = 1.2;
    auto scene =
        play_materials<3>({{flat_ground(0), 0, {}},
                           {solid_box(6, {4, 1, scalar(0.25)}, {0, 0, scalar(0.25)}, scalar(0.5)), 0, {}},
                           {solid_box(2, {scalar(0.5), scalar(0.5), scalar(0.25)}, {0, 0, scalar(0.75)}, scalar(0.5)), 0, {scalar(-s), 0, 0}}},
                          OnEarth::gravity);
    scene.run(OnEarth::h, 1);
    figure("relative speed, m/s", scene.v(2).x() - scene.v(1).x());
    EXPECT_NEAR(scene.v(2).x() - scene.v(1).x(), s, allowed(1, s).speed);
    EXPECT_NEAR(2 * scene.v(2).x() + 6 * scene.v(1).x(), 0, 2 * allowed(1, s).speed);
    EXPECT_LE(scene.fastest_spin(), allowed(1, s).speed);
}

/// Across the surface a velocity does nothing; a belt that is switched on and off takes along what lies on it, and lets it go.
TEST(Belt, counts_along_the_surface_only_and_may_be_switched) {
    auto scene = play_materials<2>({{flat_ground(scalar(0.5)), 0, {0, 0, 5}}, {parcel(flat, scalar(0.5)), 0, {}}}, OnEarth::gravity);
    scene.run(OnEarth::h, 1);
    EXPECT_LE(scene.v(1).norm(), static_cast<double>(ingot::limits::settled_speed_of_small));
    EXPECT_EQ(scene.world().set_surface_velocity(scene.id(0), {1, 0, 0}), Status::ok);
    scene.run(OnEarth::h, 1);
    EXPECT_NEAR(scene.v(1).x(), 1, allowed(1, 1).speed);
    EXPECT_EQ(scene.world().set_surface_velocity(scene.id(0), {}), Status::ok);
    scene.run(OnEarth::h, 1);
    EXPECT_LE(scene.v(1).norm(), static_cast<double>(ingot::limits::settled_speed_of_small));
}

/// What sleeps on a belt wakes when it starts.
TEST(Belt, wakes_what_sleeps_on_it) {
    auto scene = play_materials<2, SleepRoom>({{flat_ground(scalar(0.5)), 0, {}}, {parcel(flat, scalar(0.5)), 0, {}}}, OnEarth::gravity);
    scene.run(OnEarth::h, 2);
    ASSERT_TRUE(scene.world().is_asleep(scene.id(1)));
    EXPECT_EQ(scene.world().set_surface_velocity(scene.id(0), {1, 0, 0}), Status::ok);
    scene.run(OnEarth::h, 1);
    EXPECT_FALSE(scene.world().is_asleep(scene.id(1)));
    EXPECT_NEAR(scene.v(1).x(), 1, allowed(1, 1).speed);
    EXPECT_EQ(scene.world().set_surface_velocity(scene.id(0), {}), Status::ok);
    scene.run(OnEarth::h, 2);
    EXPECT_TRUE(scene.world().is_asleep(scene.id(1)));
    EXPECT_EQ(scene.world().set_rolling_resistance(scene.id(0), scalar(0.1)), Status::ok);
    EXPECT_FALSE(scene.world().is_asleep(scene.id(1)));
}

/// Each shape of a body has its own, in its own axes.
TEST(Belt, of_one_shape_of_several_moves_what_touches_that) {
    auto world = std::make_unique<ingot::World<RoomOfSides>>();
    ASSERT_EQ(world->set_gravity(OnEarth::gravity), Status::ok);
    ingot::BodyDef def;
    def.immovable = true;
    const ingot::ShapeDef table[] = {{ingot::Box{{2, 1, scalar(0.5)}}, {0, -2, scalar(-0.5)}},
                                     {ingot::Box{{1, 2, scalar(0.5)}}, {0, 2, scalar(-0.5)}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}};
    const BodyId id = world->add(def, table).value;
    EXPECT_EQ(world->set_surface_velocity(id, {0, -1, 0}, 1), Status::ok);  // along +x of the world
    BodyId boxes[2];
    for (const int i : {0, 1}) {
        PlacedBody box = parcel(flat, scalar(0.5));
        box.def.state.r_CM.y = scalar(i == 0 ? -2 : 2);
        boxes[i] = world->add(box.def).value;
    }
    for (int step_i = 0; step_i < 60; ++step_i) ASSERT_TRUE(ingot::step(*world, OnEarth::h).clean());
    EXPECT_NEAR(static_cast<double>(world->state(boxes[0]).value.v_CM.x), 0, 1e-5);
    EXPECT_NEAR(static_cast<double>(world->state(boxes[1]).value.v_CM.x), 1, 1e-5);
    EXPECT_EQ(world->surface_velocity(id, 0).value.y, 0);
    EXPECT_EQ(world->surface_velocity(id, 1).value.y, -1);
    EXPECT_EQ(world->set_surface_velocity(id, {}, 2), Status::out_of_range);
    EXPECT_EQ(world->set_surface_velocity(boxes[0], {}, 1), Status::out_of_range) << "it has one shape";
    EXPECT_EQ(world->set_rolling_resistance(boxes[0], 1, -1), Status::out_of_range);
}

/// Bad numbers are refused and change nothing; who comes later into a slot has nothing of who was there.
TEST(Materials, refuse_what_is_no_number_of_theirs) {
    auto scene = play_materials<2>({{flat_ground(scalar(0.5)), scalar(0.25), {1, 2, 0}}, {parcel(flat, scalar(0.5)), 0, {}}}, OnEarth::gravity);
    auto& world = scene.world();
    const BodyId ground = scene.id(0);
    std::vector<unsigned char> before(sizeof world), after(sizeof world);
    std::memcpy(before.data(), &world, sizeof world);
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN(), infinity = std::numeric_limits<scalar>::infinity();
    EXPECT_EQ(world.set_rolling_resistance(ground, nan), Status::not_finite);
    EXPECT_EQ(world.set_rolling_resistance(ground, infinity), Status::not_finite);
    EXPECT_EQ(world.set_rolling_resistance(ground, scalar(-0.001)), Status::out_of_range);
    EXPECT_EQ(world.set_rolling_resistance(ground, 2 * ingot::limits::size_max), Status::out_of_range);
    EXPECT_EQ(world.set_rolling_resistance(ground, 1, 1), Status::out_of_range);
    EXPECT_EQ(world.set_rolling_resistance({}, 1), Status::stale_id);
    EXPECT_EQ(world.set_surface_velocity(ground, {0, nan, 0}), Status::not_finite);
    EXPECT_EQ(world.set_surface_velocity(ground, {0, 2 * ingot::limits::speed_max, 0}), Status::out_of_range);
    EXPECT_EQ(world.set_surface_velocity(ground, {}, -1), Status::out_of_range);
    EXPECT_EQ(world.set_surface_velocity({}, {}), Status::stale_id);
    EXPECT_EQ(world.rolling_resistance({}).status, Status::stale_id);
    EXPECT_EQ(world.surface_velocity(ground, 1).status, Status::out_of_range);
    std::memcpy(after.data(), &world, sizeof world);
    EXPECT_EQ(before, after);
    EXPECT_EQ(world.rolling_resistance(ground).value, scalar(0.25));
    EXPECT_EQ(world.surface_velocity(ground).value.y, 2);

    EXPECT_EQ(world.remove(ground), Status::ok);
    PlacedBody next = flat_ground(scalar(0.5));
    const BodyId heir = world.add(next.def).value;
    EXPECT_EQ(heir.slot, ground.slot);
    EXPECT_EQ(world.rolling_resistance(heir).value, 0);
    EXPECT_EQ(world.surface_velocity(heir).value.x, 0);
    EXPECT_EQ(world.set_rolling_resistance(ground, 1), Status::stale_id);
}

std::vector<MaterialBody> conveyor_line() {
    std::vector<MaterialBody> bodies;
    for (int i = 0; i < ConveyorLine::body_count; ++i) bodies.push_back(ConveyorLine::body(i));
    return bodies;
}

/// A snapshot has them, and the impulses of rolling resistance: what follows is the same to the bit.
TEST(Materials, are_kept_by_a_snapshot) {
    using Line = MaterialRoom<ConveyorLine::body_count>;
    auto scene = play_materials<ConveyorLine::body_count>(conveyor_line(), OnEarth::gravity);
    scene.run(OnEarth::h, 1.5);
    std::vector<uint8_t> bytes(ingot::snapshot_size<Line>());
    const ingot::Result<size_t> size = ingot::save_snapshot(scene.world(), bytes.data(), bytes.size());
    ASSERT_TRUE(size.ok());
    replay::SnapshotFields fields;
    EXPECT_EQ(replay::read_fields({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size.value)}, fields), "")
        << "as ingot_replay reads it";
    double rolling = 0;
    for (const replay::SnapshotField& field : fields.fields) rolling += field.name == "rolling_resistance" ? field.value(fields.doubles) : 0;
    double given = 0;
    for (const MaterialBody& one : conveyor_line()) given += static_cast<double>(one.rolling_lever);
    EXPECT_EQ(rolling, given);
    auto loaded = std::make_unique<ingot::World<Line>>();
    ASSERT_EQ(ingot::load_snapshot(*loaded, bytes.data(), size.value), Status::ok);
    EXPECT_EQ(loaded->rolling_resistance(scene.id(9)).value, ConveyorLine::body(9).rolling_lever);
    EXPECT_EQ(loaded->surface_velocity(scene.id(1)).value.x, ConveyorLine::body(1).surface_velocity.x);
    for (int step_i = 0; step_i < 120; ++step_i) {
        (void)scene.step(OnEarth::h);
        ASSERT_TRUE(scenes::well_but_for_impacts(ingot::step(*loaded, OnEarth::h)));
        ASSERT_EQ(scene.world().state_hash(), loaded->state_hash()) << step_i;
    }
    EXPECT_TRUE(scene.reports().clean());
    for (int i = 4; i < 8; ++i) {
        figure("height of a parcel, m", scene.r(i).z());
        EXPECT_GT(scene.moved(i).z(), 0.5);
    }
    EXPECT_GT(scene.r(7).z(), 3.8) << "on the table";

    auto other = std::make_unique<ingot::World<RollingRoom>>();
    EXPECT_EQ(ingot::load_snapshot(*other, bytes.data(), size.value), Status::other_scene);
}

/// A scene that names one of them is solved as one that names both and uses one; a scene that uses neither, as one without.
TEST(Materials, that_are_not_used_change_no_bit) {
    std::vector<PlacedBody> placed;
    for (const MaterialBody& one : conveyor_line()) placed.push_back(one.body);
    Play<Room<ConveyorLine::body_count>> plain(placed, OnEarth::gravity);
    Play<RollingRoom> rolling(placed, OnEarth::gravity), rolling_used(placed, OnEarth::gravity);
    Play<BeltRoom> belts(placed, OnEarth::gravity), belts_used(placed, OnEarth::gravity);
    auto line = conveyor_line();
    for (MaterialBody& one : line) one.surface_velocity = {};
    auto both_rolling = play_materials<ConveyorLine::body_count>(line, OnEarth::gravity);
    line = conveyor_line();
    for (MaterialBody& one : line) one.rolling_lever = 0;
    auto both_belts = play_materials<ConveyorLine::body_count>(line, OnEarth::gravity);
    for (int i = 0; i < ConveyorLine::body_count; ++i) {
        EXPECT_EQ(rolling_used.world().set_rolling_resistance(rolling_used.id(i), ConveyorLine::body(i).rolling_lever), Status::ok);
        EXPECT_EQ(belts_used.world().set_surface_velocity(belts_used.id(i), ConveyorLine::body(i).surface_velocity), Status::ok);
    }
    for (int step_i = 0; step_i < 120; ++step_i) {
        (void)plain.step(OnEarth::h);
        (void)rolling.step(OnEarth::h);
        (void)belts.step(OnEarth::h);
        (void)rolling_used.step(OnEarth::h);
        (void)both_rolling.step(OnEarth::h);
        (void)belts_used.step(OnEarth::h);
        (void)both_belts.step(OnEarth::h);
        ASSERT_EQ(plain.world().state_hash(), rolling.world().state_hash()) << step_i;
        ASSERT_EQ(plain.world().state_hash(), belts.world().state_hash()) << step_i;
        ASSERT_EQ(rolling_used.world().state_hash(), both_rolling.world().state_hash()) << step_i;
        ASSERT_EQ(belts_used.world().state_hash(), both_belts.world().state_hash()) << step_i;
    }
    EXPECT_NE(plain.world().state_hash(), rolling_used.world().state_hash());
    EXPECT_NE(plain.world().state_hash(), belts_used.world().state_hash());
}

/// A zero has one set of bits, whatever its sign was: worlds that are equal have equal bytes.
TEST(Materials, of_minus_nothing_are_of_nothing) {
    auto scene = play_materials<2>({{flat_ground(scalar(0.5)), 0, {}}, {solid_ball(1, 1, {0, 0, 1}, 0), 0, {}}}, OnEarth::gravity);
    ASSERT_EQ(scene.world().set_rolling_resistance(scene.id(1), scalar(-0.0)), Status::ok);
    ASSERT_EQ(scene.world().set_surface_velocity(scene.id(1), {scalar(-0.0), scalar(-0.0), scalar(-0.0)}), Status::ok);
    EXPECT_FALSE(std::signbit(scene.world().rolling_resistance(scene.id(1)).value));
    const Vector v = scene.world().surface_velocity(scene.id(1)).value;
    EXPECT_FALSE(std::signbit(v.x) || std::signbit(v.y) || std::signbit(v.z));
}

}  // namespace
