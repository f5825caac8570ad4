// SPDX-License-Identifier: MIT
// Two balls on a rod or a rope, both of which move: the way of each is known in closed form. Their centre flies as one body. About it they go
// straight until the rope is as long as it can be; that takes the speed along it, as an impact that does not bounce; from there on they go in a
// circle, at the speed that is left.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using Eigen::Vector3d;
using ingot::Status;
using ingot_reference::to_eigen;

struct OnTies : ingot::Scene {
    static constexpr int max_bodies = 12, max_joints = 12, max_loops = 12;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::RodJoint, ingot::RopeJoint, ingot::WithReactions>;
};
using OnTiesWorld = ingot::World<OnTies>;

struct TwoBalls {
    double M[2], length;
    Vector3d r[2], v[2], g;
    bool is_rope;

    double mass() const { return M[0] + M[1]; }
    double reduced() const { return M[0] * M[1] / mass(); }
    Vector3d apart() const { return r[1] - r[0]; }
    Vector3d speed_apart() const { return v[1] - v[0]; }
    Vector3d centre() const { return (r[0] * M[0] + r[1] * M[1]) / mass(); }
    Vector3d speed() const { return (v[0] * M[0] + v[1] * M[1]) / mass(); }
    /// s, after which the rope is at its end.
    double taut_at() const {
        if (!is_rope) return 0;
        const Vector3d d = apart(), u = speed_apart();
        const double b = d.dot(u), a = u.squaredNorm(), c = d.squaredNorm() - length * length;
        return (-b + std::sqrt(b * b - a * c)) / a;
    }
    /// What is apart of them at t, and how fast it changes.
    void at(double t, Vector3d& d, Vector3d& u) const {
        const double from = taut_at();
        if (t < from) {
            d = apart() + speed_apart() * t;
            u = speed_apart();
            return;
        }
        const Vector3d n = (apart() + speed_apart() * from) / length;
        const Vector3d across = speed_apart() - n * n.dot(speed_apart());
        const double fast = across.norm(), angle = fast / length * (t - from);
        const Vector3d along = fast > 0 ? Vector3d(across / fast) : Vector3d::Zero();
        d = length * (n * std::cos(angle) + along * std::sin(angle));
        u = fast * (along * std::cos(angle) - n * std::sin(angle));
    }
    /// rad/s, of the circle.
    double rate() const {
        Vector3d d, u;
        at(taut_at() + 1e-9, d, u);
        return u.norm() / length;
    }
};

/// rate_max: rad/s, of the circle, about as much. Masses that are as far apart as a hundred, either way round.
TwoBalls drawn_pair(RandomInput& random, double rate_max, bool is_rope) {
    TwoBalls two;
    two.is_rope = is_rope;
    two.g = random.integer(0, 1) == 0 ? Vector3d::Zero() : Vector3d(0, 0, -g);
    const double scale = std::exp(random.real(-6, 0));  // kg, of the lighter
    for (double& M : two.M) M = scale * std::exp(random.real(0, std::log(100.0)));
    two.length = std::exp(random.real(std::log(0.02), std::log(2.0)));
    two.r[0] = random.vector(2);
    const Vector3d n = random.direction(), across = n.cross(random.direction()).normalized();
    two.r[1] = two.r[0] + n * (is_rope ? two.length * random.real(0.5, 0.9) : two.length);
    const double fast = two.length * rate_max * random.real(0.3, 1);
    const Vector3d u = across * fast + (is_rope ? Vector3d(n * (fast * random.real(0.2, 1))) : Vector3d::Zero()), speed = random.vector(2);
    two.v[0] = speed - u * (two.M[1] / two.mass());
    two.v[1] = speed + u * (two.M[0] / two.mass());
    return two;
}

struct BuiltPair {
    ingot::BodyId balls[2];
    ingot::JointId tie;
};
BuiltPair add_pair(OnTiesWorld& world, const TwoBalls& two) {
    BuiltPair built;
    for (int i = 0; i < 2; ++i) {
        ingot::BodyDef def;
        def.mass = ingot::principal(ingot::with_mass(ingot::solid_sphere(1, scalar(0.1)), static_cast<scalar>(two.M[i]))).value;
        def.state.r_CM = to_vector(two.r[i]);
        def.state.v_CM = to_vector(two.v[i]);
        built.balls[i] = world.add(def).value;
    }
    ingot::JointDef def;
    def.body_A = built.balls[0];
    def.body_B = built.balls[1];
    def.P = to_vector(two.r[0]);
    def.P_B = to_vector(two.r[1]);
    if (two.is_rope) def.joint = ingot::RopeJoint{static_cast<scalar>(two.length)};
    else def.joint = ingot::RodJoint{static_cast<scalar>(two.length)};
    const auto id = world.add_joint(def);
    EXPECT_TRUE(id.ok());
    built.tie = id.value;
    return built;
}

/// How often the substeps of a pair that turns by so much in each are halved: see limits::turn_of_doublings.
int doublings_of(double turn_of_substep) {
    int doublings = 0;
    for (const scalar turn : ingot::limits::turn_of_doublings) doublings += turn_of_substep > static_cast<double>(turn) ? 1 : 0;
    return doublings;
}

/// Masses up to a hundred to one, either way round, in each of four pairs that are in one world. A substep goes along the chord of its arc, at the
/// speed of its middle: it is late by the sixth part of the square of its turn, so much of the angle, and of so much less where the pair turns so far
/// that its substeps are halved. A rope takes up to a substep to know that it is taut. What it bears is what holds the balls in the circle.
TEST(PairsOnTies, go_in_a_circle_about_their_centre) {
    RandomInput random(1);
    int halved = 0, taut = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(80); ++run_i) {
        const double rate = rates[random.integer(0, 4)], h = static_cast<double>(static_cast<scalar>(1 / rate));
        const double substep = h / OnTies::effort.substeps;
        const auto world = std::make_unique<OnTiesWorld>();
        const Vector3d weight = run_i % 2 == 0 ? Vector3d::Zero() : Vector3d(0, 0, -g);
        ASSERT_EQ(world->set_gravity(to_vector(weight)), Status::ok);
        TwoBalls pairs[4];
        BuiltPair built[4];
        for (int i = 0; i < 4; ++i) {
            pairs[i] = drawn_pair(random, rate * std::exp(random.real(std::log(0.05), std::log(5.0))), random.integer(0, 1) == 1);
            built[i] = add_pair(*world, pairs[i]);
        }
        const int steps = 40;
        for (int step_i = 1; step_i <= steps; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(h)).clean()) << run_i;
            for (int i = 0; i < 4; ++i) {
                const TwoBalls& two = pairs[i];
                const double t = step_i * h, from = two.taut_at(), fast = two.rate() * two.length, turn = two.rate() * substep;
                Vector3d r[2], v[2], d, u;
                for (int ball_i = 0; ball_i < 2; ++ball_i) {
                    const ingot::BodyState state = world->state(built[i].balls[ball_i]).value;
                    r[ball_i] = to_eigen(state.r_CM);
                    v[ball_i] = to_eigen(state.v_CM);
                }
                two.at(t, d, u);
                const double size = two.r[0].norm() + (two.v[0].norm() + two.v[1].norm() + g * t) * t + 2, roundings = 16 * eps * size;
                const Vector3d apart = r[1] - r[0], speed = v[1] - v[0];
                const double beyond = apart.norm() - two.length;
                ASSERT_LE(two.is_rope && t < from ? beyond : std::abs(beyond) * (t < from + h ? 0 : 1), held + roundings) << run_i << ", " << i;
                const Vector3d p = (v[0] * two.M[0] + v[1] * two.M[1]) / two.mass(), centre = (r[0] * two.M[0] + r[1] * two.M[1]) / two.mass();
                EXPECT_LE((p - two.speed() - weight * t).norm(), 64 * eps * std::sqrt(step_i) * (fast + two.speed().norm() + g * t)) << run_i;
                EXPECT_LE((centre - two.centre() - two.speed() * t - weight * (t * t / 2)).norm(), g * substep * t + 4 * roundings) << run_i;
                if (t < from) {
                    EXPECT_LE((apart - d).norm(), roundings) << run_i << ", " << i << ": who is not held goes straight";
                    continue;
                }
                // Doublings are of the step after: the first goes as it comes.
                const double angle = two.rate() * (t - from), first = std::min(angle, 2 * two.rate() * h);
                const double cut = turn / (1 << doublings_of(turn * 0.98));
                const double late = (angle - first) * (cut * cut / 6) * 1.1 + first * std::min(1.0, turn * turn / 6 * 1.1) + (two.is_rope ? turn : 0);
                EXPECT_LE((apart - d).norm(), two.length * std::min(2.0, late) + 4 * roundings) << run_i << ", pair " << i << ": " << turn << " rad";
                if (t < from + 2 * h || doublings_of(turn * 0.98) != doublings_of(turn * 1.02)) continue;
                // It is the speed along the last chord, half of a turn from the circle. The force is the mean of a step, along which it turns.
                EXPECT_NEAR(speed.norm(), fast * (1 + cut * cut / 8), fast * (cut * cut * cut * cut / 8 + 64 * eps * step_i) + roundings * rate)
                    << run_i << ", pair " << i;
                const double half = two.rate() * h / 2, F = to_eigen(world->joint_reaction(built[i].tie).value.force).norm();
                const double due = two.reduced() * fast * two.rate() * std::abs(std::sin(half)) / half;
                EXPECT_NEAR(F, due, due * (cut * cut) + two.reduced() * roundings * rate * rate) << run_i << ", pair " << i;
                halved += cut < turn ? 1 : 0;
                taut += two.is_rope ? 1 : 0;
            }
        }
    }
    EXPECT_GT(halved, ingot_reference::draws(80));
    EXPECT_GT(taut, ingot_reference::draws(80));
}

/// A pair that goes in a circle on a rope, one of which is struck towards the other, or across: the rope lets go at once, or stays taut. Who is let
/// go flies straight.
TEST(PairsOnTies, that_are_struck_together_are_let_go) {
    RandomInput random(4);
    int let_go = 0, held_on = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(160); ++run_i) {
        const double rate = rates[random.integer(0, 4)], h = static_cast<double>(static_cast<scalar>(1 / rate));
        const auto world = std::make_unique<OnTiesWorld>();
        ASSERT_EQ(world->set_gravity({}), Status::ok);
        TwoBalls two = drawn_pair(random, rate * random.real(0.02, 0.2), false);
        two.is_rope = true;
        two.g.setZero();
        const BuiltPair built = add_pair(*world, two);
        for (int step_i = random.integer(4, 12); step_i > 0; --step_i) ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(h)).clean());
        const auto state = [&](int i) { return world->state(built.balls[i]).value; };
        const auto apart = [&] { return Vector3d(to_eigen(state(1).r_CM) - to_eigen(state(0).r_CM)); };
        const auto speed = [&] { return Vector3d(to_eigen(state(1).v_CM) - to_eigen(state(0).v_CM)); };
        const double fast = speed().norm();
        const int struck = random.integer(0, 1);
        const bool together = run_i % 3 != 0;
        const Vector3d n = apart().normalized() * (struck == 0 ? 1 : -1);  // from who is struck to the other
        const Vector3d across = n.cross(random.direction()).normalized();
        const double blow = fast * random.real(0.5, 3);
        const Vector j = to_vector(Vector3d((together ? n : across) * (blow * two.M[struck])));
        ASSERT_EQ(world->apply_impulse(built.balls[struck], j, state(struck).r_CM), Status::ok);
        const Vector3d from = apart(), u = speed();
        // In a step it gets no further than half-way through the other side, and in the next the rope may be at its end again.
        const double size = from.norm() + two.r[0].norm() + two.v[0].norm() * 20 * h + u.norm() * h + 2;
        ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(h)).clean());
        if (together && (from + u * h).norm() < two.length * (1 - 1e-3) && from.dot(u) < -0.2 * u.norm() * from.norm()) {
            ++let_go;
            EXPECT_LE((apart() - from - u * h).norm(), 16 * eps * size) << run_i;
            EXPECT_LE((speed() - u).norm(), 16 * eps * (size * rate + u.norm())) << run_i;
            EXPECT_EQ(to_eigen(world->joint_reaction(built.tie).value.force).norm(), 0) << run_i;
        } else if (!together) {
            ++held_on;
            EXPECT_LE(std::abs(apart().norm() - two.length), held + 16 * eps * size) << run_i;
        }
    }
    EXPECT_GT(let_go, ingot_reference::draws(160) / 4);
    EXPECT_GT(held_on, ingot_reference::draws(160) / 4);
}

/// A light ball between two heavy ones on rods, which are held taut by their turn about the middle: plucked along the axis it swings as a string
/// does, at a frequency that is known. A substep is late by a 24th part of the square of its turn of that: so much of the angle, and so much less
/// where the pull is such that substeps are halved. Whichever of two is A of a rod.
TEST(StringsOfTies, swing_at_their_frequency) {
    RandomInput random(3);
    int halved[4] = {};
    for (int run_i = 0; run_i < ingot_reference::draws(160); ++run_i) {
        const double rate = rates[random.integer(0, 4)], h = static_cast<double>(static_cast<scalar>(1 / rate));
        const double substep = h / OnTies::effort.substeps;
        const auto world = std::make_unique<OnTiesWorld>();
        ASSERT_EQ(world->set_gravity({}), Status::ok);
        const auto even = [&random](double low, double high) { return std::exp(random.real(std::log(low), std::log(high))); };  // in its logarithm
        const double m = even(1, 7), M = m * even(100, 3000), L = even(0.2, 5);
        // rad, by which it swings in a substep, squared: omega^2 = 2 T / L (1 / m + 1 / (2 M)), where T = M w^2 L
        const double tight = even(0.02, 12), omega = std::sqrt(tight) / substep;
        const double w = omega / std::sqrt(2 * M * (1 / m + 0.5 / M));
        const double a = 0.03 * L * std::sqrt(m / M);  // so little that it does not draw in the heavy ones
        const Eigen::Matrix3d R = random.rotation();
        const Vector3d r[3] = {R * Vector3d(L, 0, -a * m / (2 * M)), R * Vector3d(0, 0, a), R * Vector3d(-L, 0, -a * m / (2 * M))};
        const Vector3d v[3] = {R * Vector3d(0, L * w, 0), Vector3d::Zero(), R * Vector3d(0, -L * w, 0)};
        ingot::BodyId balls[3];
        for (int i = 0; i < 3; ++i) {
            ingot::BodyDef def;
            def.mass = ingot::principal(ingot::with_mass(ingot::solid_sphere(1, scalar(0.1)), static_cast<scalar>(i == 1 ? m : M))).value;
            def.state.r_CM = to_vector(r[i]);
            def.state.v_CM = to_vector(v[i]);
            balls[i] = world->add(def).value;
        }
        for (int i = 0; i < 2; ++i) {
            const bool light_first = run_i % 3 == 0 || (run_i % 3 == 1 && i == 0);
            ingot::JointDef def;
            def.body_A = light_first ? balls[1] : balls[2 * i];
            def.body_B = light_first ? balls[2 * i] : balls[1];
            def.P = world->state(def.body_A).value.r_CM;
            def.P_B = world->state(def.body_B).value.r_CM;
            def.joint = ingot::RodJoint{};
            ASSERT_TRUE(world->add_joint(def).ok());
        }
        // One rod alone turns the light ball back by half of that; a pull that is a tenth short of a limit counts for less.
        int doublings = 0;
        for (const scalar tension : ingot::limits::tension_of_doublings) doublings += 0.45 * tight > static_cast<double>(tension) ? 1 : 0;
        ++halved[doublings];
        const double cut_sq = tight / (1 << 2 * doublings);
        const int steps = std::min(200, static_cast<int>(std::ceil(20 / (omega * h))));
        for (int step_i = 1; step_i <= steps; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(h)).clean()) << run_i;
            const auto height = [&](int i) { return (R.transpose() * to_eigen(world->state(balls[i]).value.r_CM)).z(); };
            const double angle = omega * step_i * h, due = a * (1 + m / (2 * M)) * std::cos(angle), off = std::abs(height(1) - height(0) - due) / a;
            // 3 % for the bend of its way, and roundings of places.
            EXPECT_LE(off, angle * cut_sq / 24 * 1.1 + 0.03 + 16 * eps * L * std::sqrt(step_i) / a)
                << run_i << ": " << tight << ", " << M / m << " to one, step " << step_i;
        }
    }
    for (const int count : {halved[0], halved[1], halved[2]}) EXPECT_GT(count, ingot_reference::draws(160) / 20);
}

/// Balls in a line on ropes that are all as long as they can be, and one at an end that is thrown: away from the others it takes all along, as one
/// impact that does not bounce does; towards them it takes nobody. Bodies and ropes in any order, either one of two as A, masses up to 1000 to one.
TEST(RowsOnRopes, are_taken_along_as_one) {
    RandomInput random(2);
    for (int run_i = 0; run_i < ingot_reference::draws(400); ++run_i) {
        const double rate = rates[random.integer(0, 4)], h = static_cast<double>(static_cast<scalar>(1 / rate));
        const auto world = std::make_unique<OnTiesWorld>();
        ASSERT_EQ(world->set_gravity({}), Status::ok);
        const int count = random.integer(2, 7);
        const bool away = run_i % 4 != 0;
        const Vector3d line = random.direction();
        std::vector<int> order(static_cast<size_t>(count)), ropes;
        for (int i = 0; i < count; ++i) order[static_cast<size_t>(i)] = i;
        for (int i = count - 1; i > 0; --i) std::swap(order[static_cast<size_t>(i)], order[static_cast<size_t>(random.integer(0, i))]);
        std::vector<double> at(static_cast<size_t>(count), 0), M(at);
        for (size_t i = 0; i < at.size(); ++i) {
            at[i] = i == 0 ? random.real(-1, 1) : at[i - 1] - random.real(0.2, 0.8);
            M[i] = std::exp(random.real(0, std::log(1000.0)));
        }
        const double speed = (away ? 1 : -1) * random.real(0.05, 1) * 0.2 * rate;  // by no more than the least gap in a step
        std::vector<ingot::BodyId> balls(at.size());
        for (const int i : order) {
            ingot::BodyDef def;
            def.mass = ingot::principal(ingot::with_mass(ingot::solid_sphere(1, scalar(0.1)), static_cast<scalar>(M[static_cast<size_t>(i)]))).value;
            def.state.r_CM = to_vector(line * at[static_cast<size_t>(i)]);
            if (i == 0) def.state.v_CM = to_vector(line * speed);
            balls[static_cast<size_t>(i)] = world->add(def).value;
        }
        for (int i = 1; i < count; ++i) ropes.insert(ropes.begin() + random.integer(0, i - 1), i);
        for (const int i : ropes) {
            const int flip = random.integer(0, 1);
            ingot::JointDef def;
            def.body_A = balls[static_cast<size_t>(i - flip)];
            def.body_B = balls[static_cast<size_t>(i - 1 + flip)];
            def.P = world->state(def.body_A).value.r_CM;
            def.P_B = world->state(def.body_B).value.r_CM;
            def.joint = ingot::RopeJoint{};
            ASSERT_TRUE(world->add_joint(def).ok());
        }
        ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(h)).clean()) << run_i;
        double all = 0;
        for (const double m : M) all += m;
        // Places are rounded, so ropes are slack by that; what a light ball shares with heavy ones is known to roundings of them.
        const double rounding = 16 * eps * (4 * rate + std::abs(speed)) * std::sqrt(1000.0);
        for (size_t i = 0; i < at.size(); ++i) {
            const double v = to_eigen(world->state(balls[i]).value.v_CM).dot(line), due = away ? speed * M[0] / all : i == 0 ? speed : 0;
            EXPECT_NEAR(v, due, rounding) << run_i << ", ball " << i << " of " << count << (away ? ", away" : ", towards them");
        }
    }
}

}  // namespace
