// SPDX-License-Identifier: MIT
// Impacts without friction happen when shapes meet, not when a step begins: bounces, balls that meet on their way, chains of them, in closed form.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include "laws/bodies.h"
#include "reference/ball_and_brick.h"
#include "reference/csv_table.h"
#include "reference/draws.h"

namespace {

using namespace ingot_laws;
using namespace ingot_reference;
using Eigen::Vector3d;

struct Balls : ingot::Scene {
    static constexpr int max_bodies = 32;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 512;  // more than 26 balls have pairs, with each other and six walls
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
};
using World = ingot::World<Balls>;

World& empty_world() {
    static World world;
    world = World{};
    return world;
}

constexpr double rates[] = {30, 60, 64, 120, 240, 1000};

/// A ball over the ground, stepped beside its closed form.
struct Bounces {
    double g, h_0, v_0, e;

    /// m, that roundings may put the ball off at the time t. A flight of n steps adds n roundings of its speed, which come out at random:
    /// 4 sqrt(n) u. Each flight then lasts longer by twice that over g, and so does each after it: k^1.5 flights in the sum, at the speed of the
    /// impact.
    double rounding(double t, double rate) const {
        const double speed = std::sqrt(v_0 * v_0 + 2 * g * h_0), flight = 2 * speed / g, flights = 1 + t / flight;
        return std::pow(flights, 1.5) * flight * speed * 4 * std::sqrt(1 + flight * rate) * u + 16 * u * (h_0 + 1);
    }
    /// Impacts slower than 2 g h are none: bounces are missing that rise by 2 e^2 g h^2. What is as slow and nearer than limits::flatness lies.
    double missing(double rate) const { return e < 1 ? 2 * g / (rate * rate) + static_cast<double>(ingot::limits::flatness) * 0.5 : 0; }

    void follow(double seconds, double rate) const {
        World& world = empty_world();
        const scalar h = static_cast<scalar>(1 / rate);
        ASSERT_EQ(world.set_gravity({0, 0, static_cast<scalar>(-g)}), ingot::Status::ok);
        (void)add(world, half_space({0, 0, 1}, 0, e));
        const Known body = add(world, ball(1, 0.5, {0, 0, 0.5 + h_0}, {0, 0, v_0}, e));
        const BouncingBall exact(static_cast<long double>(static_cast<scalar>(g)), static_cast<long double>(static_cast<scalar>(0.5 + h_0)) - 0.5L,
                                 static_cast<long double>(static_cast<scalar>(v_0)), static_cast<long double>(static_cast<scalar>(e)));
        for (int step_i = 1; step_i <= seconds * rate; ++step_i) {
            ASSERT_TRUE(ingot::step(world, h).clean());
            const double z = position(world, body)(2) - 0.5, t = step_i * static_cast<double>(h);
            ASSERT_NEAR(z, static_cast<double>(exact.at(static_cast<long double>(t)).z), rounding(t, rate) + missing(rate))
                << t << " s at " << rate << " Hz: g " << g << " h_0 " << h_0 << " v_0 " << v_0 << " e " << e;
        }
    }
};

/// The figures of the table: before, an elastic ball was 1.5 m off after 20 s at 60 Hz.
TEST(TimeOfImpact, a_ball_bounces_as_in_the_table) {
    const CsvTable table("bouncing_ball.csv");
    for (std::size_t row = 0; row < table.row_count(); ++row) {
        if (table.number<double>(row, "t") != 0) continue;
        const Bounces ball{table.number<double>(row, "g"), table.number<double>(row, "h0"), table.number<double>(row, "v0"),
                           table.number<double>(row, "e")};
        for (const double rate : rates) ball.follow(ball.e == 1 ? 20 : 4, rate);
    }
}

TEST(TimeOfImpact, a_ball_bounces_in_closed_form) {
    RandomInput random(351);
    for (int i = 0; i < draws(60); ++i) {
        const Bounces ball{random.real(1, 20), random.real(0.1, 5), random.real(-3, 3), i % 3 == 0 ? 1 : random.real(0.3, 1)};
        ball.follow(3, rates[i % 6]);
    }
}

/// Two balls that fly freely meet somewhere, some time: then each goes on with its velocity after the impact from where it was.
struct Meeting {
    Vector3d r[2], v[2];
    double M[2], R[2], e, t;
    Vector3d n;  ///< from B to A, when they meet

    explicit Meeting(RandomInput& random) {
        for (int side = 0; side < 2; ++side) {
            M[side] = std::exp(random.real(-2, 2));
            R[side] = random.real(0.1, 0.6);
        }
        e = random.real(0, 1);
        t = random.real(0.01, 0.5);
        n = random.direction();
        do {  // at least 0.7 of their speed is along n: where they graze, the normal is a matter of rounding
            for (Vector3d& of : v) of = random.vector(5);
        } while (!((v[0] - v[1]).dot(n) < -0.7 * (v[0] - v[1]).norm()) || (v[0] - v[1]).norm() < 1);
        const Vector3d P = random.vector(1);
        r[0] = P + n * R[0] - v[0] * t;
        r[1] = P - n * R[1] - v[1] * t;
    }
};

TEST(TimeOfImpact, balls_meet_on_their_way) {
    RandomInput random(352);
    for (int i = 0; i < draws(400); ++i) {
        const Meeting of(random);
        World& world = empty_world();
        const Known A = add(world, ball(of.M[0], of.R[0], of.r[0], of.v[0], of.e)), B = add(world, ball(of.M[1], of.R[1], of.r[1], of.v[1], of.e));
        const double rate = rates[i % 6];
        const int steps = static_cast<int>(0.6 * rate);
        for (int step_i = 0; step_i < steps; ++step_i) ASSERT_TRUE(ingot::step(world, static_cast<scalar>(1 / rate)).clean());
        const double j = -(1 + of.e) * (of.v[0] - of.v[1]).dot(of.n) / (1 / of.M[0] + 1 / of.M[1]);
        const double end = steps * static_cast<double>(static_cast<scalar>(1 / rate));
        // The place of the impact is known to 8 roundings of places below 6 m and one a step, n to that over the radii and the cosine.
        const double place = (8 + std::sqrt(0.6 * rate)) * 2 * u * 6, turned = place / (of.R[0] + of.R[1]) / 0.7;
        for (int side = 0; side < 2; ++side) {
            const Vector3d dv = of.n * (side == 0 ? j / of.M[0] : -j / of.M[1]), r = of.r[side] + of.v[side] * end + dv * (end - of.t);
            const Known& body = side == 0 ? A : B;
            const double speed = dv.norm() + (of.v[0] - of.v[1]).norm();
            ASSERT_LE((velocity(world, body) - of.v[side] - dv).norm(), 2 * speed * turned + 32 * u * speed) << i;
            ASSERT_LE((position(world, body) - r).norm(), place * (1 + speed) + 2 * speed * turned + 32 * u * speed) << i;
        }
    }
}

/// A row of like balls with gaps, of which the first moves: the impact goes through at its speed, several balls a step, and each stops where its
/// neighbour stood.
TEST(TimeOfImpact, an_impact_goes_through_a_row_in_its_own_time) {
    RandomInput random(353);
    for (int i = 0; i < draws(60); ++i) {
        constexpr int count = 8;
        const double v = random.real(0.5, 8), rate = rates[i % 6], R = random.real(0.02, 0.5);
        World& world = empty_world();
        std::vector<Known> balls;
        double x = 0, gaps[count] = {}, begin[count] = {};
        for (int ball_i = 0; ball_i < count; ++ball_i) {
            begin[ball_i] = x;
            balls.push_back(add(world, ball(1, R, {x, 0, 0}, {ball_i == 0 ? v : 0, 0, 0}, 1)));
            // Balls at rest that are nearer than limits::flatness touch.
            gaps[ball_i] = 4 * R * static_cast<double>(ingot::limits::flatness) + (i % 2 == 0 ? 0.01 * random.real(0, R) : random.real(0, R));
            x += 2 * R + gaps[ball_i];
        }
        const int steps = 1 + static_cast<int>((x - 2 * R * count) / v * rate * 1.2);
        for (int step_i = 1; step_i <= steps; ++step_i) {
            ASSERT_TRUE(ingot::step(world, static_cast<scalar>(1 / rate)).clean());
            double way = v * step_i * static_cast<double>(static_cast<scalar>(1 / rate));  // of the impact, through the gaps
            for (int ball_i = 0; ball_i < count; ++ball_i) {
                const double own = ball_i == count - 1 ? way : std::min(way, gaps[ball_i]);
                const double rounding = (32 + step_i) * u * (x + 1);  // a step adds the same way again, and may round it the same way
                ASSERT_NEAR(position(world, balls[static_cast<std::size_t>(ball_i)])(0), begin[ball_i] + own, rounding)
                    << "ball " << ball_i << " step " << step_i << " at " << rate << " Hz";
                way -= own;
            }
        }
    }
}

/// A light ball between two heavy ones has more impacts than a step follows, or their impulses more than its sweeps find.
bool reaches_bound(ingot::StepReport report) {
    const bool some = report.impacts_deferred > 0 || report.sweeps_unfinished > 0;
    report.impacts_deferred = report.sweeps_unfinished = 0;
    return some && report.clean();
}

/// Balls that fly about in a closed room.
struct Cloud {
    std::vector<Known> balls{};
    std::vector<double> radii{};
    double fastest = 0;

    Cloud(World& world, RandomInput& random) {
        for (int wall_i = 0; wall_i < 6; ++wall_i)
            (void)add(world, half_space(Vector3d::Unit(wall_i / 2) * (wall_i % 2 == 0 ? 1 : -1), -1.2, 1));
        const int count = random.integer(2, 26);
        const double most = random.real(0.05, 0.39), speed = random.real(0.5, 12);
        const bool alike = random.integer(0, 3) == 0;
        for (int ball_i = 0; ball_i < count; ++ball_i) {
            const Vector3d cell(ball_i % 3 - 1, ball_i / 3 % 3 - 1, ball_i / 9 - 1), v = random.vector(speed);
            radii.push_back(alike ? most : random.real(most / 4, most));
            balls.push_back(add(world, ball(std::exp(random.real(-2, 2)), radii.back(), 0.8 * cell, v, 1)));
            fastest = std::max(fastest, v.norm());
        }
    }
    /// m; how deep they are in each other or in a wall.
    double depth(const World& world) const {
        double deepest = -1;
        for (std::size_t a = 0; a < balls.size(); ++a) {
            const Vector3d r = position(world, balls[a]);
            deepest = std::max(deepest, r.cwiseAbs().maxCoeff() + radii[a] - 1.2);
            for (std::size_t b = 0; b < a; ++b) deepest = std::max(deepest, radii[a] + radii[b] - (r - position(world, balls[b])).norm());
        }
        return deepest;
    }
};

/// Elastic, of any number, sizes, masses and speeds, at any rate: none gets into another or into a wall, and energy stays, in each step. A light ball
/// that heavy ones throw is faster than any was as the step began.
TEST(TimeOfImpact, a_cloud_of_balls_keeps_its_energy_and_its_distances) {
    RandomInput random(354);
    for (int i = 0; i < draws(600); ++i) {
        World& world = empty_world();
        const Cloud cloud(world, random);
        const double rate = rates[i % 6];
        long double before = kinetic_energy(world, cloud.balls);
        for (int step_i = 0; step_i < rate; ++step_i) {
            const ingot::StepReport report = ingot::step(world, static_cast<scalar>(1 / rate));
            ASSERT_TRUE(report.clean() || reaches_bound(report));
            const long double now = kinetic_energy(world, cloud.balls);
            // Speeds of impacts are met to contact_roundings; in each of them the energy of two bodies is changed by that.
            const double off = 4 * ingot::limits::contact_roundings * 2 * u * (1 + report.impact_waves);
            ASSERT_LE(static_cast<double>(now / before), 1 + off) << "cloud " << i << " step " << step_i << " at " << rate;
            ASSERT_GE(static_cast<double>(now / before), report.clean() ? 1 - off : 0) << "cloud " << i << " step " << step_i << " at " << rate;
            before = now;
            // Of places within 1.2 m and the way of a step, in each impact once more.
            const double rounding = 2 * u * (32 + report.impact_waves) * (1.2 + cloud.fastest / rate);
            ASSERT_LE(cloud.depth(world), rounding) << "cloud " << i << " step " << step_i << " at " << rate;
        }
    }
}

/// A light ball between two heavy ones that come nearer to each other is thrown to and fro more often than a step follows. That is told, and the
/// balls get no energy, and no deeper into each other than what counts as touching lies apart, and 128 waves of 128 sweeps leave of the way that they
/// have in a step: exp(-2 128^2 / 6000), 0.4 %, at the ratio of their masses.
TEST(TimeOfImpact, what_is_squeezed_is_held_and_told) {
    RandomInput random(355);
    int told = 0;
    for (int i = 0; i < draws(400); ++i) {
        World& world = empty_world();
        const double M = std::exp(random.real(3, 8)), R = random.real(0.1, 0.5), r = random.real(0.02, 0.3), v = random.real(0.5, 10);
        const double gap = random.real(0.001, 0.3), rate = rates[i % 6];
        const Vector3d n = random.direction(), aside = random.vector(i % 3 == 0 ? 0 : 0.01 * r);
        const Known balls[] = {add(world, ball(M, R, aside - n * (R + r + gap), n * v, 1)),
                               add(world, ball(M * random.real(0.5, 2), R, n * (R + r + gap), -n * v, 1)),
                               add(world, ball(1, r, {0, 0, 0}, n * random.real(-1, 1), 1))};
        const double radii[] = {R, R, r};
        const auto energy = [&] { return kinetic_energy(world, std::vector<Known>(balls, balls + 3)); };
        const auto depth = [&] {
            double deepest = -1;
            for (int a = 0; a < 3; ++a)
                for (int b = 0; b < a; ++b)
                    deepest = std::max(deepest, radii[a] + radii[b] - (position(world, balls[a]) - position(world, balls[b])).norm());
            return deepest;
        };
        long double before = energy();
        for (int step_i = 0; step_i < 2 + 1.5 * gap / v * rate + 20; ++step_i) {
            const ingot::StepReport report = ingot::step(world, static_cast<scalar>(1 / rate));
            ASSERT_TRUE(report.clean() || reaches_bound(report));
            told += report.impacts_deferred > 0 ? 1 : 0;
            const long double now = energy();
            const double off = 4 * ingot::limits::contact_roundings * 2 * u * (1 + report.impact_waves);
            ASSERT_LE(static_cast<double>(now / before), 1 + off) << i << " step " << step_i;
            ASSERT_GE(static_cast<double>(now / before), report.clean() ? 1 - off : 0) << i << " step " << step_i;
            before = now;
            ASSERT_LE(depth(), 2 * static_cast<double>(ingot::limits::flatness) * (R + r) + 0.004 * 2 * v / rate) << i << " step " << step_i;
        }
    }
    EXPECT_GT(told, draws(400) / 20);
}

}  // namespace
