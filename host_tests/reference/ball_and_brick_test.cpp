// SPDX-License-Identifier: MIT
// Closed forms of balls and bricks against the 32-digit tables, and against the contact reference stepped in time.
#include "reference/ball_and_brick.h"

#include <gtest/gtest.h>

#include "reference/contact_problems.h"
#include "reference/csv_table.h"

namespace {

using namespace ingot_reference;
using Real = long double;
using Column = Eigen::Matrix<Real, 3, 1>;

/// A few dozen roundings of long double, relative to the largest number of the motion.
constexpr Real digits = 64 * std::numeric_limits<Real>::epsilon();

struct Incline {
    Real sin_alpha, cos_alpha;

    Incline(const CsvTable& table, std::size_t row) {
        const Real num = table.number<Real>(row, "tan_num"), den = table.number<Real>(row, "tan_den"),
                   hyp = std::sqrt(num * num + den * den);
        sin_alpha = num / hyp;
        cos_alpha = den / hyp;
    }
};

void expect_near(Real computed, Real exact, Real size, const CsvTable& table, std::size_t row) {
    EXPECT_LE(std::abs(computed - exact), digits * size) << table.text(row, "case") << ", row " << row;
}

void expect_time(Real t, const char* column, Real size, const CsvTable& table, std::size_t row) {
    const bool never = table.text(row, column) == "inf";
    EXPECT_EQ(std::isinf(t), never) << table.text(row, "case");
    if (!never) expect_near(t, table.number<Real>(row, column), size, table, row);
}

BouncingBall ball_of(const CsvTable& table, std::size_t row) {
    const auto x = [&](const char* column) { return table.number<Real>(row, column); };
    return {x("g"), x("h0"), x("v0"), x("e")};
}

TEST(BallAndBrick, bouncing_agrees_with_the_table) {
    const CsvTable table("bouncing_ball.csv");
    for (std::size_t row = 0; row < table.row_count(); ++row) {
        const BouncingBall::State state = ball_of(table, row).at(table.number<Real>(row, "t"));
        // Late in a long motion the phase carries the roundings of t: times the speed, and times g.
        const Real size = 1 + table.number<Real>(row, "t");
        expect_near(state.z, table.number<Real>(row, "z"), 8 * size, table, row);
        expect_near(state.v, table.number<Real>(row, "v"), 16 * size, table, row);
    }
    EXPECT_EQ(table.row_count(), 244u);
}

TEST(BallAndBrick, impacts_agree_with_the_table) {
    const CsvTable table("bouncing_ball_impacts.csv");
    for (std::size_t row = 0; row < table.row_count(); ++row) {
        const BouncingBall ball = ball_of(table, row);
        const BouncingBall::Impact impact = ball.impact(static_cast<int>(table.number<Real>(row, "k")));
        expect_near(impact.t, table.number<Real>(row, "t_impact"), 32, table, row);
        expect_near(impact.speed_in, table.number<Real>(row, "speed_in"), 8, table, row);
        expect_near(impact.speed_out, table.number<Real>(row, "speed_out"), 8, table, row);
        expect_near(impact.apex_after, table.number<Real>(row, "apex_after"), 4, table, row);
        expect_time(ball.t_rest(), "t_rest", 32, table, row);
    }
    EXPECT_EQ(table.row_count(), 81u);
}

TEST(BallAndBrick, a_ball_dropped_2_m_with_half_its_speed_is_at_rest_after_1916_ms) {
    const BouncingBall ball(9.81L, 2, 0, 0.5L);
    EXPECT_NEAR(static_cast<double>(ball.t_rest()), 3 * std::sqrt(4 / 9.81), 1e-15);
    EXPECT_NEAR(static_cast<double>(ball.t_rest()), 1.916, 5e-4);
    EXPECT_NEAR(static_cast<double>(ball.impact(1).apex_after), 0.5, 1e-15);
    EXPECT_EQ(ball.at(ball.t_rest()).v, 0);
}

TEST(BallAndBrick, sliding_bricks_agree_with_the_table) {
    const CsvTable table("brick_on_incline.csv");
    for (std::size_t row = 0; row < table.row_count(); ++row) {
        const auto x = [&](const char* column) { return table.number<Real>(row, column); };
        const Incline incline(table, row);
        const BrickOnIncline brick(x("g"), x("mu"), incline.sin_alpha, incline.cos_alpha, x("v0"));
        const BrickOnIncline::State state = brick.at(x("t"));
        expect_near(state.s, x("s"), 32, table, row);
        expect_near(state.v, x("v"), 16, table, row);
        expect_time(brick.t_stop(), "t_stop", 4, table, row);
    }
    EXPECT_EQ(table.row_count(), 190u);
}

TEST(BallAndBrick, spheres_on_inclines_agree_with_the_table) {
    const CsvTable table("sphere_on_incline.csv");
    for (std::size_t row = 0; row < table.row_count(); ++row) {
        const auto x = [&](const char* column) { return table.number<Real>(row, column); };
        const Incline incline(table, row);
        const SphereOnIncline sphere(x("g"), x("mu"), x("r"), x("k"), incline.sin_alpha, incline.cos_alpha);
        // Right at the threshold rolling and sliding are the same motion; mu = 3/14 is rounded there.
        const bool either = table.text(row, "case") == "threshold";
        EXPECT_TRUE(either || sphere.rolls() == (table.text(row, "mode") == "roll"));
        const SphereOnIncline::State state = sphere.at(x("t"));
        expect_near(state.s, x("s"), 32, table, row);
        expect_near(state.v, x("v"), 32, table, row);
        expect_near(state.w, x("w"), 64, table, row);
    }
    EXPECT_EQ(table.row_count(), 68u);
}

SphereOnPlane sphere_of(const CsvTable& table, std::size_t row) {
    const auto x = [&](const char* column) { return table.number<Real>(row, column); };
    return {x("g"), x("mu"), x("r"), x("k"), Column(x("vx0"), x("vy0"), 0), Column(x("wx0"), x("wy0"), x("wz0"))};
}

TEST(BallAndBrick, spheres_on_planes_agree_with_the_table) {
    const CsvTable table("sphere_on_plane.csv");
    for (std::size_t row = 0; row < table.row_count(); ++row) {
        const auto x = [&](const char* column) { return table.number<Real>(row, column); };
        const SphereOnPlane sphere = sphere_of(table, row);
        const SphereOnPlane::State state = sphere.at(x("t"));
        expect_near(sphere.t_roll(), x("t_roll"), 1, table, row);
        expect_near((state.r - Column(x("x"), x("y"), 0)).norm(), 0, 64, table, row);
        expect_near((state.v - Column(x("vx"), x("vy"), 0)).norm(), 0, 16, table, row);
        expect_near((state.omega - Column(x("wx"), x("wy"), x("wz"))).norm(), 0, 32, table, row);
    }
    EXPECT_EQ(table.row_count(), 99u);
}

/// Steps one body through contacts that stay as they are. Forces are constant while nothing sticks or stops, so velocities are
/// exact after every step; the step that ends a slip ends it exactly. 1e-9: 500 steps of at most 1e-12 each, and some.
class Stepped {
public:
    explicit Stepped(ContactProblem problem, const Vector3d& gravity, double h)
        : problem_(std::move(problem)), gravity_(gravity), h_(h) {}

    const ContactBody& body() const { return problem_.bodies[1]; }

    void step() {
        fall(problem_, gravity_, h_);
        const ContactSolution solution = solve_contacts(problem_);
        ASSERT_TRUE(solution.converged);
        problem_.bodies[1].v_CM = solution.v_CM[1];
        problem_.bodies[1].omega = solution.omega[1];
    }

private:
    ContactProblem problem_;
    Vector3d gravity_;
    double h_;
};

ContactProblem ball_on_plane(double mu, double R, double k) {
    ContactProblem problem;
    problem.bodies = {ContactBody{}, solid_ball(1, R, {0, 0, R})};
    problem.bodies[1].inv_I_world = Matrix3d::Identity() / (k * R * R);
    problem.points = {point_between(1, 0, {0, 0, 0}, Vector3d::UnitZ(), mu)};
    return problem;
}

TEST(BallAndBrick, the_contact_reference_steps_spheres_on_planes_as_the_table_says) {
    const CsvTable table("sphere_on_plane.csv");
    for (const char* name : {"backspin", "oblique", "shell"}) {
        const std::vector<std::size_t> rows = table.rows_with("case", name);
        const auto x = [&](std::size_t row, const char* column) { return table.number<double>(row, column); };
        ContactProblem problem = ball_on_plane(x(rows[0], "mu"), x(rows[0], "r"), x(rows[0], "k"));
        problem.bodies[1].v_CM = {x(rows[0], "vx0"), x(rows[0], "vy0"), 0};
        problem.bodies[1].omega = {x(rows[0], "wx0"), x(rows[0], "wy0"), x(rows[0], "wz0")};
        constexpr int steps_a_row = 16;
        Stepped stepped(problem, {0, 0, -x(rows[0], "g")}, 0.25 / steps_a_row);
        for (const std::size_t row : rows) {
            if (row != rows[0])
                for (int step_i = 0; step_i < steps_a_row; ++step_i) stepped.step();
            EXPECT_LE((stepped.body().v_CM - Vector3d(x(row, "vx"), x(row, "vy"), 0)).norm(), 1e-9)
                << name << " " << x(row, "t");
            EXPECT_LE((stepped.body().omega - Vector3d(x(row, "wx"), x(row, "wy"), x(row, "wz"))).norm(), 1e-9) << name;
        }
    }
}

TEST(BallAndBrick, the_contact_reference_steps_spheres_on_inclines_as_the_table_says) {
    const CsvTable table("sphere_on_incline.csv");
    for (const char* name : {"roll", "slide", "threshold", "gentle"}) {
        const std::vector<std::size_t> rows = table.rows_with("case", name);
        const auto x = [&](std::size_t row, const char* column) { return table.number<double>(row, column); };
        const Incline incline(table, rows[0]);
        const double g = x(rows[0], "g");
        Stepped stepped(ball_on_plane(x(rows[0], "mu"), x(rows[0], "r"), x(rows[0], "k")),
                        {g * static_cast<double>(incline.sin_alpha), 0, -g * static_cast<double>(incline.cos_alpha)},
                        x(rows[1], "t") / 16);
        for (const std::size_t row : rows) {
            if (row != rows[0])
                for (int step_i = 0; step_i < 16; ++step_i) stepped.step();
            EXPECT_NEAR(stepped.body().v_CM.x(), x(row, "v"), 1e-9) << name;
            EXPECT_NEAR(stepped.body().omega.y(), x(row, "w"), 1e-9) << name;
        }
    }
}

TEST(BallAndBrick, the_contact_reference_steps_bricks_as_the_table_says) {
    const CsvTable table("brick_on_incline.csv");
    for (const char* name : {"stop_on_flat", "down_stops", "down_accelerates", "up_and_back", "up_and_stick", "rest_sticks"}) {
        const std::vector<std::size_t> rows = table.rows_with("case", name);
        const auto x = [&](std::size_t row, const char* column) { return table.number<double>(row, column); };
        const Incline incline(table, rows[0]);
        const double g = x(rows[0], "g"), h = x(rows[1], "t") / 16;
        ContactProblem problem = stack_of_boxes({2.0}, {0.5, 0.4, 0.1}, x(rows[0], "mu"));
        problem.bodies[1].v_CM.x() = x(rows[0], "v0");
        Stepped stepped(problem, {g * static_cast<double>(incline.sin_alpha), 0, -g * static_cast<double>(incline.cos_alpha)},
                        h);
        // The step in which it turns at t_stop and goes on down is one of rest instead: late by less than h from then on.
        const double late = std::string(name) == "up_and_back" ? h * g : 0;
        for (const std::size_t row : rows) {
            if (row != rows[0])
                for (int step_i = 0; step_i < 16; ++step_i) stepped.step();
            EXPECT_NEAR(stepped.body().v_CM.x(), x(row, "v"), 1e-9 + late) << name << " " << x(row, "t");
            EXPECT_LE(stepped.body().omega.norm(), 1e-9) << name;
        }
    }
}

TEST(BallAndBrick, a_cradle_passes_on_as_many_balls_as_come_in) {
    for (int balls = 2; balls <= 5; ++balls) {
        for (int coming = 1; coming < balls; ++coming) {
            std::vector<Real> v(static_cast<std::size_t>(balls), 0), M(v.size(), 2), gap(v.size() - 1, 1e-6L);
            std::fill(v.begin(), v.begin() + coming, 3);
            for (int i = 0; i + 1 < coming; ++i) gap[static_cast<std::size_t>(i)] = 1e-6L;
            BallsOnALine cradle(M, gap, v, 1);
            int impacts = 0;
            while (cradle.next_impact()) ++impacts;
            EXPECT_EQ(impacts, coming * (balls - coming));
            for (int i = 0; i < balls; ++i)
                EXPECT_NEAR(static_cast<double>(cradle.v()[static_cast<std::size_t>(i)]), i >= balls - coming ? 3 : 0, 1e-15);
        }
    }
    // e < 1 keeps momentum and loses energy: two balls, (1 -+ e) / 2 of the speed.
    BallsOnALine pair({1, 1}, {1e-3L}, {2, 0}, 0.5L);
    EXPECT_TRUE(pair.next_impact());
    EXPECT_EQ(pair.v()[0], 0.5L);
    EXPECT_EQ(pair.v()[1], 1.5L);
    EXPECT_FALSE(pair.next_impact());
}

TEST(BallAndBrick, the_pushed_box_of_SimBenchmark_moves_as_the_contact_reference_says) {
    // 10 kg, 20 x 20 x 1 m, 25 balls of 1 kg on it, 150 N at (1/2, sqrt(3)/2), mu 0.8 and 0.4.
    const double h = 1e-3;
    const Vector3d push(75, 75 * std::sqrt(3.0), 0);
    ContactProblem problem = stack_of_boxes({10.0}, {10, 10, 0.5}, 0.4);
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 5; ++j) {
            const Vector3d top(2 * i - 4, 2 * j - 4, 1);
            problem.bodies.push_back(solid_ball(1, 0.5, top + Vector3d(0, 0, 0.5)));
            problem.points.push_back(
                point_between(static_cast<int>(problem.bodies.size()) - 1, 1, top, Vector3d::UnitZ(), 0.8));
        }
    }
    fall(problem, {0, 0, -9.81}, h);
    problem.bodies[1].v_CM += h * push / 10;
    const ContactSolution solution = solve_contacts(problem);
    ASSERT_TRUE(solution.converged);
    const PushedBoxWithBalls exact(9.81L, 150, 10, 1, 25, 0.4L, 0.4L);
    EXPECT_LE((solution.v_CM[1] - h * static_cast<double>(exact.a_box) * push / 150).norm(), 1e-12);
    for (std::size_t ball_i = 2; ball_i < 27; ++ball_i)
        EXPECT_LE((solution.v_CM[ball_i] - h * static_cast<double>(exact.a_ball) * push / 150).norm(), 1e-12);
}

TEST(BallAndBrick, leaning_planks_hold_above_their_least_friction_and_slip_below) {
    const double M = 1, length = 2, h = 1e-3;
    for (const double theta : {0.6, 0.9, 1.2}) {
        for (const double factor : {0.98, 1.02}) {
            ContactProblem problem;
            ContactBody plank;
            plank.inv_M = 1 / M;
            plank.inv_I_world = Matrix3d::Identity() * (12 / (M * length * length));
            const Vector3d along(std::cos(theta), 0, std::sin(theta));
            plank.r_CM = along * (length / 2);
            problem.bodies = {ContactBody{}, plank};
            problem.points = {
                point_between(1, 0, {0, 0, 0}, Vector3d::UnitZ(), factor * static_cast<double>(leaning_plank_mu(theta))),
                point_between(1, 0, along * length, -Vector3d::UnitX(), 0)};
            fall(problem, {0, 0, -9.81}, h);
            const ContactSolution solution = solve_contacts(problem);
            ASSERT_TRUE(solution.converged);
            const double speed = solution.v_CM[1].norm();
            EXPECT_TRUE(factor > 1 ? speed <= 1e-10 : speed >= 1e-5) << theta << " " << speed;
        }
    }
}

}  // namespace
