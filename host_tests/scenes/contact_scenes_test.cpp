// SPDX-License-Identifier: MIT
// The contact scenes as they are defined: bodies that a world takes, no overlaps, and what the exact solution of one step from
// rest says of their thresholds. The kernel does no step here.
#include <gtest/gtest.h>

#include <cstdio>

#include "contact/all_contact_scenes.h"
#include "contact/exact_problem.h"
#include "reference/ball_and_brick.h"
#include "reference/csv_table.h"

namespace {

using namespace scenes;
using namespace ingot_reference;

constexpr bool is_double = sizeof(scalar) == 8;

/// Sizes and places are given to the scalar's digits: 10 m and less, a few roundings. Bodies touch within this, m.
constexpr double place = is_double ? 1e-12 : 1e-5;

/// Speed after a step of what rests, m/s, where free fall makes 0.16: places off by 1e-6 m in float, over the 0.04 m that the
/// thinnest card is thick, times g h are 4e-6. In double the solver's own bar, amplified by what stands on what.
constexpr double rest = is_double ? 1e-9 : 1e-5;

double fastest(const ContactProblem& problem, const ContactSolution& solution) {
    double most = 0;
    for (std::size_t i = 0; i < problem.bodies.size(); ++i)
        most = std::max({most, solution.v_CM[i].norm(), solution.omega[i].norm()});
    return most;
}

/// The fastest body after one exact step.
double fastest_after(const ContactProblem& problem, const char* name) {
    const ContactSolution solution = solve_contacts(problem);
    EXPECT_TRUE(solution.converged) << name << " residual " << solution.residual;
    EXPECT_LE(contact_defects(problem, solution).worst(), 1e-9) << name;
    return fastest(problem, solution);
}

template <class Scene>
double fastest_in() {
    return fastest_after(exact_problem_of<Scene>(place), Scene::name);
}

void expect_valid(const PlacedBody& body, const char* name, int body_i) {
    using ingot::Status;
    if (!body.def.immovable) {
        EXPECT_EQ(check_mass_properties(body.def.mass), Status::ok) << name << " " << body_i;
        const Vector I = body.def.mass.I_body;
        EXPECT_EQ(check_state(body.def.state, {1 / I.x, 1 / I.y, 1 / I.z}), Status::ok) << name << " " << body_i;
    }
    EXPECT_TRUE(body.is_hull || check_shape(body.def.shape) == Status::ok) << name << " " << body_i;
    EXPECT_TRUE(body.mu >= 0 && body.def.restitution >= 0 && body.def.restitution <= 1) << name << " " << body_i;
    EXPECT_LE(ingot::orthogonality_error(body.def.state.A), 16 * ingot::epsilon) << name << " " << body_i;
}

/// Bodies that a world takes, immovable ones first, none inside another by more than `deepest`.
void expect_well_made(const std::vector<PlacedBody>& bodies, const char* name, double deepest = place) {
    std::vector<Surface> surfaces;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        expect_valid(bodies[i], name, static_cast<int>(i));
        surfaces.emplace_back(bodies[i]);
        EXPECT_FALSE(bodies[i].def.immovable && i > 0 && !bodies[i - 1].def.immovable) << name << " " << i;
        for (std::size_t j = 0; j < i; ++j) {
            if (bodies[i].def.immovable && bodies[j].def.immovable) continue;
            EXPECT_LE(overlap_of(surfaces[i], surfaces[j]), deepest) << name << " " << j << " " << i;
        }
    }
}

template <class Scene>
void expect_well_made(double deepest = place) {
    expect_well_made(bodies_of<Scene>(), Scene::name, deepest);
}

TEST(ContactScenes, are_well_made) {
    expect_well_made<Pyramid<10>>();
    expect_well_made<Pyramid<20>>();
    expect_well_made<Tower<20>>();
    expect_well_made<MassRatio<1, 1000>>();
    expect_well_made<MassRatio<9, 1000>>();
    expect_well_made<TenBoxes<true>>();
    expect_well_made<TenBoxes<false>>();
    expect_well_made<Overhang<1>>();
    expect_well_made<Sliver<true>>();
    expect_well_made<Sliver<false>>();
    expect_well_made<SpherePile<4>>();
    expect_well_made<SpherePile<8>>();
    expect_well_made<PitOfBoxes>();
    expect_well_made<FallingPlanks>();
    expect_well_made<SlabOnTiles>();
    expect_well_made<Incline<70>>();
    expect_well_made<Bounce<100>>();
    expect_well_made<Cradle<5, 2, 1>>();
    expect_well_made<BoxDroppedFlat<50>>();
    expect_well_made<CardHouse<3, 60>>();
    expect_well_made<Arch<13, 200, 60>>();
    expect_well_made<Dominoes<20>>();
    expect_well_made<SlidingRod<60, 200>>();
    expect_well_made<SpinningBar>();
    expect_well_made<SimRolling>(5e-5);  // as defined: 2e-5 and twice that deep
    expect_well_made<SimBouncing>();
    expect_well_made<Sim666<false>>();
    expect_well_made<Sim666<true>>();
}

TEST(ContactScenes, with_choices_are_well_made) {
    for (const scalar phase : {scalar(0), scalar(0.5)})
        expect_well_made({BulletAndPlate::body(0, phase, 0), BulletAndPlate::body(1, phase, 0)}, BulletAndPlate::name);
    for (int phase_i = 0; phase_i < HeadOn::phase_count; ++phase_i)
        for (const bool balls : {false, true})
            expect_well_made({HeadOn::body(0, balls, 80, phase_i), HeadOn::body(1, balls, 80, phase_i)}, HeadOn::name);
    for (const scalar degrees : {scalar(0), scalar(30), scalar(90)})
        expect_well_made({brick_pushed_at(0, degrees, scalar(0.4)), brick_pushed_at(1, degrees, scalar(0.4))}, "pushed");
    expect_well_made<PlankOnEdge<1000>>();
    // Overlaps are what they are named after.
    const std::vector<PlacedBody> half_inside = bodies_of<Overlap<50, false>>();
    EXPECT_NEAR(overlap_of(Surface(half_inside[0]), Surface(half_inside[1])), 0.5, place);
}

/// The scene is the table's case: after one exact step (bodies touch, so nothing else acts) it moves as the closed form says.
template <class Case>
std::vector<PlacedBody> bodies_of_case(const Case& one) {
    return {one.body(0), one.body(1)};
}

TEST(ContactScenes, cases_are_those_of_the_tables) {
    const double h = 1.0 / 1024, near = is_double ? 1e-11 : 2e-6;  // speeds up to 13 in float
    const auto stepped = [&](const std::vector<PlacedBody>& bodies, double g) {
        const ContactProblem problem = exact_problem(bodies, {0, 0, -g}, h, place);
        EXPECT_FALSE(problem.points.empty());
        return solve_contacts(problem);
    };
    const CsvTable bricks("brick_on_incline.csv");
    for (const SlopeCase& one : brick_cases) {
        const std::size_t row = bricks.rows_with("case", one.table_case).front();
        const auto x = [&](const char* column) { return bricks.number<long double>(row, column); };
        const long double hyp = std::sqrt(x("tan_num") * x("tan_num") + x("tan_den") * x("tan_den"));
        const BrickOnIncline exact(x("g"), x("mu"), x("tan_num") / hyp, x("tan_den") / hyp, x("v0"));
        const Vector3d v = stepped(bodies_of_case(one), static_cast<double>(x("g"))).v_CM[1];
        EXPECT_NEAR(v.dot(to_eigen(one.slope.down())), static_cast<double>(exact.at(h).v), near) << one.table_case;
    }
    const CsvTable inclines("sphere_on_incline.csv");
    for (const SlopeCase& one : sphere_incline_cases) {
        const std::size_t row = inclines.rows_with("case", one.table_case).front();
        const auto x = [&](const char* column) { return inclines.number<long double>(row, column); };
        const long double hyp = std::sqrt(x("tan_num") * x("tan_num") + x("tan_den") * x("tan_den"));
        const SphereOnIncline exact(x("g"), x("mu"), x("r"), x("k"), x("tan_num") / hyp, x("tan_den") / hyp);
        const ContactSolution solution = stepped(bodies_of_case(one), static_cast<double>(x("g")));
        EXPECT_NEAR(solution.v_CM[1].dot(to_eigen(one.slope.down())), static_cast<double>(exact.at(h).v), near)
            << one.table_case;
        EXPECT_NEAR(solution.omega[1].y(), static_cast<double>(exact.at(h).w), near) << one.table_case;
    }
    const CsvTable planes("sphere_on_plane.csv");
    for (const SpherePlaneCase& one : sphere_plane_cases) {
        const std::size_t row = planes.rows_with("case", one.table_case).front();
        const auto x = [&](const char* column) { return planes.number<long double>(row, column); };
        using Column = SphereOnPlane::Vector3;
        const SphereOnPlane exact(x("g"), x("mu"), x("r"), x("k"), Column(x("vx0"), x("vy0"), 0),
                                  Column(x("wx0"), x("wy0"), x("wz0")));
        const ContactSolution solution = stepped(bodies_of_case(one), static_cast<double>(x("g")));
        EXPECT_LE((solution.v_CM[1] - exact.at(h).v.cast<double>()).norm(), near) << one.table_case;
        EXPECT_LE((solution.omega[1] - exact.at(h).omega.cast<double>()).norm(), near) << one.table_case;
    }
    const CsvTable bounces("bouncing_ball_impacts.csv");
    for (const BounceCase& one : bounce_cases) {
        const std::size_t row = bounces.rows_with("case", one.table_case).front();
        EXPECT_EQ(bounces.number<double>(row, "h0"), static_cast<double>(one.h_0));
        EXPECT_EQ(bounces.number<double>(row, "v0"), static_cast<double>(one.v_0));
        EXPECT_EQ(bounces.number<double>(row, "e"), static_cast<double>(one.e));
        expect_well_made(bodies_of_case(one), one.table_case);
    }
}

TEST(ContactScenes, have_the_bodies_their_names_say) {
    static_assert(Pyramid<10>::cube_count == 55 && Pyramid<20>::cube_count == 210 && Pyramid<30>::cube_count == 465, "base");
    static_assert(SpherePile<8>::body_count == 5 + 512 && PitOfBoxes::body_count == 5 + 125, "walls and bodies");
    static_assert(CardHouse<3, 60>::pair_count == 6 && CardHouse<3, 60>::across_count == 3, "three levels");
    static_assert(SimRolling::body_count == 27 && SimBouncing::body_count == 50 && Sim666<true>::body_count == 217,
                  "SimBenchmark");
    double energy = 0;
    for (const PlacedBody& body : bodies_of<SimBouncing>())
        if (!body.def.immovable)
            energy += static_cast<double>(body.def.mass.M) * 9.81 * static_cast<double>(body.def.state.r_CM.z);
    EXPECT_NEAR(energy, 24034.5, 1e-2);
    for (int i = 0; i < 1000; ++i) EXPECT_LE(ingot::orthogonality_error(scattered_rotation(i)), 16 * ingot::epsilon);
}

/// I_body of a hull from its mesh, by the kernel's own integral, which the tables of polyhedra check.
TEST(ContactScenes, stones_of_the_arch_have_the_mass_of_their_corners) {
    const PlacedBody stone = Arch<13, 200, 60>::body(4);
    ingot::MeshTriangle triangles[12];
    for (int face_i = 0; face_i < 6; ++face_i) {
        const int(&f)[4] = hexahedron_face[face_i];
        triangles[2 * face_i] = {f[0], f[1], f[2]};
        triangles[2 * face_i + 1] = {f[0], f[2], f[3]};
    }
    const ingot::MassDistribution solid = ingot::solid_mesh(2000, stone.corner, 8, triangles, 12).value;
    const double u = 64 * static_cast<double>(ingot::epsilon), I = static_cast<double>(solid.I.xx);
    EXPECT_NEAR(double(solid.M), double(stone.def.mass.M), u * double(solid.M));
    EXPECT_NEAR(double(solid.I.xx), double(stone.def.mass.I_body.x), u * I);
    EXPECT_NEAR(double(solid.I.yy), double(stone.def.mass.I_body.y), u * I);
    EXPECT_NEAR(double(solid.I.zz), double(stone.def.mass.I_body.z), u * I);
    EXPECT_LE(ingot_reference::to_eigen(solid.r_CM).norm(), u);
}

TEST(ContactScenes, stacks_rest_in_the_exact_solution) {
    EXPECT_LE(fastest_in<Pyramid<10>>(), rest);
    EXPECT_LE(fastest_in<Pyramid<20>>(), rest);
    EXPECT_LE(fastest_in<Tower<20>>(), rest);
    EXPECT_LE(fastest_in<Tower<40>>(), rest);
    EXPECT_LE((fastest_in<MassRatio<1, 1000>>()), rest);
    EXPECT_LE((fastest_in<MassRatio<1, 1000000>>()), rest);
    EXPECT_LE((fastest_in<MassRatio<9, 1000>>()), rest);
    EXPECT_LE(fastest_in<TenBoxes<true>>(), rest);
    EXPECT_LE(fastest_in<TenBoxes<false>>(), rest);
    EXPECT_LE(fastest_in<Sliver<true>>(), rest);
    EXPECT_LE(fastest_in<Sliver<false>>(), rest);
}

TEST(ContactScenes, pyramid_of_210_is_solved_with_400_pairs) {
    const ContactProblem problem = exact_problem_of<Pyramid<20>>(place);
    EXPECT_EQ(problem.points.size(), 4u * (20 + 2 * 190));
    const ContactSolution solution = solve_contacts(problem);
    double ground = 0;
    for (std::size_t i = 0; i < problem.points.size(); ++i)
        if (problem.points[i].body_B == 0) ground += solution.impulse[i].z();
    EXPECT_NEAR(ground, 210 * 9.81 / 60, 1e-6 * ground);
}

TEST(ContactScenes, a_plank_on_an_edge_feels_no_torque) {
    EXPECT_LE((fastest_in<PlankOnEdge<1570796>>()), rest);
    EXPECT_LE((fastest_in<PlankOnEdge<1000>>()), rest);
    EXPECT_LE((fastest_in<PlankOnEdge<0>>()), rest);
}

TEST(ContactScenes, the_rolling_of_SimBenchmark_starts_as_its_closed_form) {
    ContactProblem problem = exact_problem_of<SimRolling>(1e-4, product);  // bodies are up to 4e-5 m inside each other
    EXPECT_EQ(problem.points.size(), 4u + 25u);
    problem.bodies[SimRolling::pushed_body].v_CM += 1e-3 * to_eigen(SimRolling::push_diagonal) / 10;
    const ContactSolution solution = solve_contacts(problem);
    ASSERT_TRUE(solution.converged);
    const PushedBoxWithBalls exact(9.81L, 150, 10, 1, 25, 0.4L, 0.4L);
    const Vector3d direction(0.5, std::sqrt(0.75), 0);
    // The box is 0.5 m - 2e-5 m over the ground and the balls stand 2e-5 m in it, which tilts nothing; radii count to 1e-4.
    EXPECT_LE((solution.v_CM[1] - 1e-3 * static_cast<double>(exact.a_box) * direction).norm(), 1e-7);
    EXPECT_LE((solution.v_CM[SimRolling::measured_ball] - 1e-3 * static_cast<double>(exact.a_ball) * direction).norm(), 1e-7);
}

TEST(ContactScenes, overhang_tips_past_the_edge) {
    EXPECT_LE(fastest_in<Overhang<-1>>(), rest);
    EXPECT_GE(fastest_in<Overhang<1>>(), 1e-4);  // 3/5 g h 2 mm / m: 2e-4 rad/s
}

TEST(ContactScenes, incline_sticks_at_mu_07_and_slides_at_04) {
    EXPECT_LE(fastest_in<Incline<70>>(), rest);
    const double slides = 9.81 / 60 * (0.5 - 0.4 * std::sqrt(0.75));
    EXPECT_NEAR(fastest_in<Incline<40>>(), slides, is_double ? 1e-10 : 1e-7);
}

TEST(ContactScenes, boxes_topple_where_the_slope_is_steeper_than_they_are_wide) {
    for (const scalar factor : {scalar(0.98), scalar(1.02)}) {
        const scalar height = 2, width = factor * 2 * scalar(0.75);
        const std::vector<PlacedBody> bodies = {box_that_may_topple(0, three_four, width, height),
                                                box_that_may_topple(1, three_four, width, height)};
        const double speed = fastest_after(exact_problem(bodies, {0, 0, -9.81}, 1.0 / 60, place), "topple");
        EXPECT_TRUE(factor > 1 ? speed <= rest : speed > 5e-4) << factor << " " << speed;
    }
}

template <int degrees>
void expect_plank_threshold() {
    using Plank = LeaningPlank<degrees>;
    EXPECT_NEAR(static_cast<double>(Plank::mu_least),
                static_cast<double>(leaning_plank_mu(static_cast<long double>(Plank::angle))), 0.02);
    for (const scalar factor : {scalar(0.98), scalar(1.02)}) {
        std::vector<PlacedBody> bodies;
        for (int body_i = 0; body_i < Plank::body_count; ++body_i)
            bodies.push_back(Plank::body(body_i, factor * Plank::mu_least));
        // The pair of the plank and the ground takes their mu; with the wall, 0.
        const double speed = fastest_after(exact_problem(bodies, {0, 0, -9.81}, 1.0 / 60, place), Plank::name);
        EXPECT_TRUE(factor > 1 ? speed <= rest : speed > 1e-3) << degrees << " " << factor << " " << speed;
    }
}

TEST(ContactScenes, planks_lean_above_their_least_friction) {
    expect_plank_threshold<45>();
    expect_plank_threshold<60>();
}

/// Least mu at which a scene whose bodies all have the same mu rests, by halving.
template <class Scene>
double least_mu(double low, double high) {
    std::vector<PlacedBody> bodies = bodies_of<Scene>();
    while (high - low > 1e-4) {
        const double mu = (low + high) / 2;
        for (PlacedBody& body : bodies) body.mu = static_cast<scalar>(mu);
        const ContactProblem problem = exact_problem(bodies, {0, 0, -9.81}, 1.0 / 60, place);
        const ContactSolution solution = solve_contacts(problem);
        EXPECT_LE(solution.residual, rest) << Scene::name << " mu " << mu;  // next to the threshold problems degenerate
        (fastest(problem, solution) <= 2 * rest ? high : low) = mu;
    }
    return high;
}

TEST(ContactScenes, card_houses_stand_above_their_least_friction) {
    // One pair: moments about the foot give H length cos = W (length sin - thickness cos) / 2.
    const double one = least_mu<CardHouse<1, 60>>(0.05, 0.6), three = least_mu<CardHouse<3, 60>>(0.05, 0.6);
    std::printf("least mu of card houses: one level %.4f, three levels %.4f\n", one, three);
    EXPECT_NEAR(one, static_cast<double>(leaning_cards_mu(0.4363323129985824L, 1, 0)) - 0.04 / 2, 3e-4);
    EXPECT_NEAR(three, card_house_least_mu, 1e-3);
    EXPECT_LE((fastest_in<CardHouse<3, 60>>()), rest);
    EXPECT_GE((fastest_in<CardHouse<3, 30>>()), 0.01);
}

TEST(ContactScenes, arches_stand_above_their_least_thickness) {
    EXPECT_LE((fastest_in<Arch<13, 200, 60>>()), rest);
    EXPECT_LE((fastest_in<Arch<13, 105, 70>>()), rest);
    EXPECT_GE((fastest_in<Arch<13, 100, 70>>()), 3e-3);  // thinner by 5 mm: 5 mm of lever in 0.16 m/s, and some
    EXPECT_GE((fastest_in<Arch<13, 95, 70>>()), 1e-2);
    EXPECT_LE((fastest_in<Arch<31, 110, 70>>()), rest);  // more stones: nearer to 0.1075
    EXPECT_GE((fastest_in<Arch<31, 103, 70>>()), 3e-4);
    const double friction = least_mu<Arch<13, 200, 60>>(0.05, 0.6);
    std::printf("least mu of the arch: %.4f\n", friction);
    EXPECT_NEAR(friction, arch_least_mu, 1e-3);
}

}  // namespace
