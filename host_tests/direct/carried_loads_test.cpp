// SPDX-License-Identifier: MIT
// Ratios of mass that build up from contact to contact: columns, plates on balls, squeezes. They stand, or the step says that they do not.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>

#include "contact/play.h"
#include "scenes/random.h"

namespace {

using namespace ingot_contact;
using namespace scenes;
using ingot::BlockSweeps;
using ingot::HybridIslands;

constexpr double g = 9.81;
constexpr scalar mu = scalar(0.6);
constexpr double rates[] = {30, 60, 120, 240, 1000};

/// Masses up to so many times the lightest are carried at any rate: a quarter of what the grain of impulses allows at 30 Hz with two substeps,
/// unsettled_speed / (direct_grain g h).
const double carried_most = static_cast<double>(ingot::limits::unsettled_speed) / (ingot::limits::direct_grain * g / 60) / 4;

double between(Random& random, double low, double high) { return low + (high - low) * 0.5 * (1 + static_cast<double>(random.symmetric())); }
int among(Random& random, int least, int most) { return static_cast<int>(between(random, least, most + 1)); }
/// Evenly by its logarithm.
double scale_between(Random& random, double low, double high) { return std::exp(between(random, std::log(low), std::log(high))); }

template <class Solver>
using Loads = Play<Room<72, ingot::AllPairs, true, 400, 800, Solver>>;
using Bodies = std::vector<PlacedBody>;

PlacedBody cube(double kg, double half, const Vector& r) {
    const scalar side = static_cast<scalar>(half);
    return solid_box(static_cast<scalar>(kg), {side, side, side}, r, mu);
}

/// Cubes, each q times as heavy as the one below.
void add_column(Bodies& bodies, int n, double q, double lightest, double half, double x = 0) {
    double kg = lightest;
    for (int i = 0; i < n; ++i, kg *= q)
        bodies.push_back(cube(kg, half, {static_cast<scalar>(x), 0, static_cast<scalar>((2 * i + 1) * half)}));
}

/// What a run did at its worst.
struct Course {
    double sink = 0, shift = 0, fastest = 0;  ///< m, m, m/s; sink either way
    int steps = 0, unclean = 0, solved = 0;
    int told_in_time = 0;  ///< steps that were not clean, up to the one in which a body sank
    bool finite = true;
};
constexpr double sunk = 1e-3;  ///< m, of a body that is not carried

template <class S>
Course run(S& scene, double rate, double seconds) {
    Course course;
    const int steps = static_cast<int>(std::lround(seconds * rate));
    for (int step_i = 0; step_i < steps; ++step_i) {
        const StepReport report = scene.step(static_cast<scalar>(1 / rate));
        ++course.steps;
        course.unclean += !report.clean();
        course.solved += (report.direct & ingot::DirectBits::solved) != 0;
        course.finite = course.finite && scene.finite();
        if (course.sink < sunk) course.told_in_time = course.unclean;
        for (int body_i = 0; body_i < scene.body_count(); ++body_i)
            if (scene.moves(body_i)) course.sink = std::max(course.sink, std::abs(scene.moved(body_i).z()));
        course.shift = std::max(course.shift, scene.shift());
        course.fastest = std::max(course.fastest, scene.fastest());
    }
    return course;
}

/// Sinks and shifts that clean steps allow. Each contact may close and slip with so much; of what closes position_share is taken back in the next
/// substep, down to settled_gap, of what slips nothing; a tilt, with twice that over the side, moves the top by its height. Places round by epsilon
/// of the height.
struct Allowed {
    double sink, shift;
};
Allowed allowed(int contacts, double height, double side, double rate, double seconds, bool direct) {
    const double left = direct ? 4 * ingot::limits::direct_settled_speed : static_cast<double>(ingot::limits::unsettled_speed);
    const double h = 1 / (rate * ingot::limits::steady_substeps);
    const double rounding = static_cast<double>(ingot::limits::settled_gap) + 4 * static_cast<double>(ingot::epsilon) * height;
    return {contacts * (left * h / static_cast<double>(ingot::limits::position_share) + rounding),
            seconds * left * contacts * (std::sqrt(2.0) + 2 * height / side) + contacts * rounding};
}

/// Best and worst of a family.
struct Worst {
    double least_sink = 1e30, sink = 0, least_shift = 1e30, shift = 0, fastest = 0;
    int runs = 0, direct = 0;

    void add(const Course& course) {
        least_sink = std::min(least_sink, course.sink);
        sink = std::max(sink, course.sink);
        least_shift = std::min(least_shift, course.shift);
        shift = std::max(shift, course.shift);
        fastest = std::max(fastest, course.fastest);
        direct += course.solved == course.steps;
        ++runs;
    }
    void tell() const {
        figure("runs", runs);
        figure("of them solved directly in each step", direct);
        figure("best sink, mm", 1e3 * least_sink);
        figure("worst sink, mm", 1e3 * sink);
        figure("best shift, mm", 1e3 * least_shift);
        figure("worst shift, mm", 1e3 * shift);
        figure("fastest, m/s", fastest);
    }
};

template <class Solver>
Course play_for(const Bodies& bodies, double rate, double seconds) {
    Loads<Solver> scene(bodies, OnEarth::gravity);
    EXPECT_TRUE(scene.sound());
    return run(scene, rate, seconds);
}

void expect_stands(const Course& course, const Allowed& most) {
    EXPECT_EQ(course.unclean, 0);
    EXPECT_LE(course.sink, most.sink);
    EXPECT_LE(course.shift, most.shift);
}

struct Column {
    int n;
    double q, lightest, half, rate;

    double ratio() const { return (std::pow(q, n) - 1) / (q - 1); }
};
::testing::Message told(const Column& column) {
    return ::testing::Message() << column.n << " x " << column.q << ", " << column.lightest << " kg, half " << column.half << ", " << column.rate
                                << " Hz";
}
Column draw_column(Random& random, double least, double most) {
    for (;;) {  // a fifth of them and more are within the range
        Column column{};
        column.n = among(random, 2, 30);
        column.q = between(random, 1.01, 10);
        column.lightest = scale_between(random, 1e-2, 1);
        column.half = scale_between(random, 0.1, 1);
        column.rate = rates[among(random, 0, 4)];
        if (column.ratio() >= least && column.ratio() <= most && column.ratio() * column.lightest < 1e12) return column;
    }
}

TEST(CarriedLoads, columns_stand) {
    Random random(1);
    Worst worst;
    for (int run_i = 0; run_i < 60; ++run_i) {
        const Column column = draw_column(random, 1, carried_most);
        SCOPED_TRACE(told(column));
        Bodies bodies = {flat_ground(mu)};
        add_column(bodies, column.n, column.q, column.lightest, column.half);
        const double seconds = column.rate > 500 ? 0.5 : 2;
        const Course course = play_for<HybridIslands<>>(bodies, column.rate, seconds);
        worst.add(course);
        expect_stands(course, allowed(column.n, 2 * column.half * column.n, 2 * column.half, column.rate, seconds, course.solved == course.steps));
    }
    worst.tell();
}

/// The scenes that fell: ten with ratio 4, thirty with ratio 2.
TEST(CarriedLoads, columns_of_4_and_of_2_stand) {
    for (const double rate : rates) {
        for (const auto& [n, q] : {std::pair{10, 4.0}, std::pair{30, 2.0}}) {
            Bodies bodies = {flat_ground(mu)};
            add_column(bodies, n, q, 1, 0.5);
            const Course course = play_for<HybridIslands<>>(bodies, rate, 2);
            EXPECT_EQ(course.solved, course.steps) << n << ", " << rate;
            expect_stands(course, allowed(n, n, 1, rate, 2, true));
        }
    }
}

/// Along each axis of the world, up it and down it: a column is one wherever its ground is.
TEST(CarriedLoads, columns_stand_whichever_way_is_down) {
    for (int axis = 0; axis < 6; ++axis) {
        Eigen::Matrix3d turn;
        for (int i = 0; i < 3; ++i) turn.col((i + axis) % 3) = Eigen::Vector3d::Unit(i);
        if (axis >= 3) turn.col(1) *= -1, turn.col(2) *= -1;
        Bodies bodies = {flat_ground(mu)};
        add_column(bodies, 10, 4, 1, 0.5);
        for (PlacedBody& body : bodies) {
            body.def.state.r_CM = ingot_reference::to_vector(turn * ingot_reference::to_eigen(body.def.state.r_CM));
            body.turn(ingot_reference::to_matrix(turn));
        }
        Loads<HybridIslands<>> scene(bodies, ingot_reference::to_vector(turn * Eigen::Vector3d(0, 0, -g)));
        ASSERT_TRUE(scene.sound());
        for (int step_i = 0; step_i < 60; ++step_i)
            EXPECT_NE(scene.step(OnEarth::h).direct & ingot::DirectBits::solved, 0) << "axis " << axis << " step " << step_i;
        const Allowed most = allowed(10, 10, 1, 60, 1, true);
        for (int body_i = 0; body_i < scene.body_count(); ++body_i) EXPECT_LE(scene.moved(body_i).norm(), most.sink + most.shift) << axis;
    }
}

/// 2^10 times as heavy or as light, a column does the same to the bit, and is solved directly in the same steps.
TEST(CarriedLoads, do_the_same_at_any_mass) {
    Random random(4);
    int solved = 0;
    for (int run_i = 0; run_i < 8; ++run_i) {
        const int n = run_i < 2 ? 30 : among(random, 2, 30);
        const double q = run_i < 4 ? 1 : between(random, 1, 1.5), half = scale_between(random, 0.1, 1);
        const auto play = [&](double lightest) {
            Bodies bodies = {flat_ground(mu)};
            add_column(bodies, n, q, lightest, half);
            for (PlacedBody& body : bodies)  // leaning by a thousandth
                body.def.state.r_CM.x += body.def.state.r_CM.z / 1024;
            return std::make_unique<Loads<HybridIslands<>>>(bodies, OnEarth::gravity);
        };
        const auto once = play(1), heavy = play(1024), light = play(1.0 / 1024);
        for (int step_i = 0; step_i < 60; ++step_i) {
            const StepReport report = once->step(OnEarth::h), of_heavy = heavy->step(OnEarth::h), of_light = light->step(OnEarth::h);
            ASSERT_EQ(report.direct, of_heavy.direct) << n << " x " << q << " step " << step_i;
            ASSERT_EQ(report.direct, of_light.direct) << n << " x " << q << " step " << step_i;
            solved += (report.direct & ingot::DirectBits::solved) != 0;
        }
        for (int body_i = 0; body_i < once->body_count(); ++body_i) {
            ASSERT_EQ(once->r(body_i), heavy->r(body_i)) << n << " x " << q;
            ASSERT_EQ(once->r(body_i), light->r(body_i)) << n << " x " << q;
        }
    }
    EXPECT_GT(solved, 0);
    figure("steps solved directly", solved);
}

/// What no solver carries says so before it has sunk in, and is thrown about by none: a fall from the top of the column to its foot and as deep into
/// the ground as it is high is the fastest there is.
void expect_told(const Course& course, double height, double rate) {
    EXPECT_TRUE(course.finite);
    if (course.sink >= sunk) {
        EXPECT_GT(course.told_in_time, 0);
    }
    EXPECT_LE(course.fastest, std::sqrt(2 * g * 2 * height) + g / rate);
}
TEST(CarriedLoads, columns_beyond_what_double_holds_are_told) {
    Random random(2);
    Worst worst;
    for (int run_i = 0; run_i < 12; ++run_i) {
        Column column = draw_column(random, 16 * carried_most, 1e14);
        SCOPED_TRACE(told(column));
        Bodies bodies = {flat_ground(mu)};
        add_column(bodies, column.n, column.q, column.lightest, column.half);
        const Course course = play_for<HybridIslands<>>(bodies, column.rate, column.rate > 500 ? 0.25 : 1);
        worst.add(course);
        expect_told(course, 2 * column.half * column.n, column.rate);
        EXPECT_GT(course.unclean, 0);
    }
    worst.tell();
}
TEST(CarriedLoads, sweeps_alone_tell_what_they_do_not_carry) {
    Random random(3);
    Worst worst;
    int not_clean = 0;
    for (int run_i = 0; run_i < 40; ++run_i) {
        const Column column = draw_column(random, 1, 1e12);
        SCOPED_TRACE(told(column));
        Bodies bodies = {flat_ground(mu)};
        add_column(bodies, column.n, column.q, column.lightest, column.half);
        const Course course = play_for<BlockSweeps>(bodies, column.rate, column.rate > 500 ? 0.25 : 1);
        worst.add(course);
        not_clean += course.unclean > 0;
        expect_told(course, 2 * column.half * column.n, column.rate);
    }
    worst.tell();
    figure("runs with steps that were not clean", not_clean);
    EXPECT_GT(not_clean, 20);
}

/// Balls or cubes in a ring, which a plate lies on.
void add_ring(Bodies& bodies, int k, double kg, double radius, double z, bool balls) {
    for (int i = 0; i < k; ++i) {
        const double angle = 2 * 3.14159265358979 * (i + 0.25) / k;
        const Vector r = {static_cast<scalar>(2 * std::cos(angle)), static_cast<scalar>(2 * std::sin(angle)), static_cast<scalar>(z)};
        bodies.push_back(balls ? solid_ball(static_cast<scalar>(kg), static_cast<scalar>(radius), r, mu) : cube(kg, radius, r));
    }
}
PlacedBody plate(double kg, double z) {
    return solid_box(static_cast<scalar>(kg), {scalar(2.5), scalar(2.5), scalar(0.1)}, {0, 0, static_cast<scalar>(z)}, mu);
}
/// More cubes under one plate take more work than an island is given; sweeps then do what they can, and say so.
constexpr int cubes_most = 8;
TEST(CarriedLoads, plates_lie_on_light_things) {
    Random random(4);
    Worst worst;
    for (int run_i = 0; run_i < 60; ++run_i) {
        const bool balls = run_i % 3 != 0, squeezed = run_i % 2 != 0;
        const int k = among(random, 3, balls ? 16 : cubes_most);
        const double ratio = scale_between(random, 1, 1e5), kg = scale_between(random, 0.01, 1), radius = between(random, 0.1, 0.3);
        const double rate = rates[run_i % 5], seconds = rate > 500 ? 0.5 : 2;
        SCOPED_TRACE(::testing::Message() << k << (balls ? " balls" : " cubes") << " of " << kg << " kg under " << ratio << " times, " << rate
                                          << (squeezed ? ", squeezed" : ""));
        Bodies bodies = {flat_ground(mu)};
        if (squeezed) bodies.push_back(plate(kg * ratio, 0.1));
        const double floor = squeezed ? 0.2 : 0;
        add_ring(bodies, k, kg, radius, floor + radius, balls);
        bodies.push_back(plate(kg * ratio, floor + 2 * radius + 0.1));
        const Course course = play_for<HybridIslands<>>(bodies, rate, seconds);
        worst.add(course);
        expect_stands(course, allowed(3, 1, 0.2, rate, seconds, course.solved == course.steps));
    }
    worst.tell();
}

TEST(CarriedLoads, plates_on_too_many_cubes_are_told) {
    for (const double rate : rates) {
        Bodies bodies = {flat_ground(mu), plate(1e4, 0.1)};
        add_ring(bodies, 16, 0.1, 0.2, 0.4, false);
        bodies.push_back(plate(1e4, 0.7));
        expect_told(play_for<HybridIslands<>>(bodies, rate, 0.5), 1, rate);
    }
}

/// What sweeps alone do with 10 t on nine balls of 0.1 kg, and with such a squeeze, they do not call clean.
TEST(CarriedLoads, sweeps_alone_tell_a_plate_that_sinks) {
    for (const bool squeezed : {false, true}) {
        Bodies bodies = {flat_ground(mu)};
        if (squeezed) bodies.push_back(plate(1e4, 0.1));
        add_ring(bodies, 9, 0.1, 0.2, squeezed ? 0.4 : 0.2, true);
        bodies.push_back(plate(1e4, squeezed ? 0.7 : 0.5));
        const Course course = play_for<BlockSweeps>(bodies, 60, 2);
        figure("sink, mm", 1e3 * course.sink);
        figure("steps that were not clean", course.unclean);
        EXPECT_GT(course.told_in_time, 0);
        expect_stands(play_for<HybridIslands<>>(bodies, 60, 2), allowed(3, 1, 0.2, 60, 2, true));
    }
}

/// Columns that are chosen by what they carry, beside light things that fall and rest: to the bit as each alone.
TEST(CarriedLoads, columns_and_neighbours_are_the_same_alone) {
    Random random(5);
    for (int run_i = 0; run_i < 10; ++run_i) {
        const Column column = draw_column(random, 60, run_i % 2 == 0 ? carried_most : 1e13);
        SCOPED_TRACE(told(column));
        Bodies alone = {flat_ground(mu)}, light = {flat_ground(mu)}, all = {flat_ground(mu)};
        add_column(alone, column.n, column.q, column.lightest, column.half);
        for (int i = 0; i < 12; ++i)
            light.push_back(cube(between(random, 0.5, 2), 0.3,
                                 {static_cast<scalar>(20 + i % 3), static_cast<scalar>(0.1 * i), static_cast<scalar>(0.3 + 0.7 * i)}));
        for (std::size_t i = 1; i < std::max(alone.size(), light.size()); ++i) {  // in turn: slots of both are mixed
            if (i < alone.size()) all.push_back(alone[i]);
            if (i < light.size()) all.push_back(light[i]);
        }
        Loads<HybridIslands<>> by_itself(alone, OnEarth::gravity), neighbours(light, OnEarth::gravity), together(all, OnEarth::gravity);
        const scalar h = static_cast<scalar>(1 / column.rate);
        for (int step_i = 0; step_i < 60; ++step_i) {
            (void)by_itself.step(h);
            (void)neighbours.step(h);
            (void)together.step(h);
            int at = 1;
            for (std::size_t i = 1; i < std::max(alone.size(), light.size()); ++i) {
                const int body_i = static_cast<int>(i);
                if (i < alone.size()) {
                    ASSERT_EQ(by_itself.r(body_i), together.r(at++)) << step_i;
                }
                if (i < light.size()) {
                    ASSERT_EQ(neighbours.r(body_i), together.r(at++)) << step_i;
                }
            }
        }
    }
}

}  // namespace
