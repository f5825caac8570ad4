// SPDX-License-Identifier: MIT
// Scenes that sweeps do not serve: heavy bodies on light ones, tall towers. And those that they do, which must not change.
#include "direct/contact_run.h"

namespace {

using namespace direct_test;
using ingot::DirectIslands;
using ingot::Sweeps;

using Direct = DirectIslands<64>;

/// Where bodies are is known to their rounding, m: some roundings of 40 m at most, which displacements of 4 substeps add up.
constexpr double rounding_of_place = 1e-5;

template <class Contact>
Totals run_direct() {
    ContactRun<Contact, Direct> run;
    run.step(static_cast<int>(Contact::seconds * 60));
    EXPECT_EQ(run.totals.refused, 0);
    EXPECT_EQ(run.totals.unfinished, 0);
    EXPECT_GT(run.totals.solves, 0);
    std::printf("%s: %.1f us a step\n", Contact::name, run.totals.us);
    return run.totals;
}

template <class Contact>
void expect_stands_still() {
    const Totals totals = run_direct<Contact>();
    EXPECT_LE(totals.sink, rounding_of_place);
    EXPECT_LE(totals.drift, rounding_of_place);
    EXPECT_LE(totals.overlap, rounding_of_place);
}

TEST(DirectIslands, carry_1000_kg_on_1_kg) { expect_stands_still<scenes::MassRatio<1, 1000>>(); }
TEST(DirectIslands, carry_1e6_kg_on_1_kg) { expect_stands_still<scenes::MassRatio<1, 1000000>>(); }
TEST(DirectIslands, carry_100_kg_on_nine_cubes) { expect_stands_still<scenes::MassRatio<9, 100>>(); }
TEST(DirectIslands, carry_1000_kg_on_nine_cubes) { expect_stands_still<scenes::MassRatio<9, 1000>>(); }
TEST(DirectIslands, carry_1e6_kg_on_nine_cubes) { expect_stands_still<scenes::MassRatio<9, 1000000>>(); }
TEST(DirectIslands, keep_a_tower_of_20_for_a_minute) { expect_stands_still<scenes::Tower<20>>(); }
TEST(DirectIslands, keep_a_tower_of_40_for_a_minute) { expect_stands_still<scenes::Tower<40>>(); }

/// What sweeps serve well is theirs, to the bit.
TEST(DirectIslands, leave_a_pyramid_to_the_sweeps) {
    ContactRun<scenes::Pyramid<6>, Direct> direct;
    ContactRun<scenes::Pyramid<6>, Sweeps> swept;
    direct.step(120);
    swept.step(120);
    EXPECT_EQ(direct.totals.solves, 0);
    EXPECT_EQ(direct.world->state_hash(), swept.world->state_hash());
}

/// An island with more manifolds than there is room for is swept, and the report says so.
TEST(DirectIslands, report_an_island_that_is_too_large) {
    ContactRun<scenes::MassRatio<3, 1000>, DirectIslands<3>> small;
    ContactRun<scenes::MassRatio<3, 1000>, Sweeps> swept;
    small.step(30);
    swept.step(30);
    EXPECT_EQ(small.totals.refused, 30);
    EXPECT_EQ(small.totals.solves, 0);
    EXPECT_EQ(small.world->state_hash(), swept.world->state_hash());
    EXPECT_FALSE(ingot::step(*small.world, scalar(1) / 60).clean());
}

/// So is one whose matrix has no room: two rows of entries are less than a column of four needs.
TEST(DirectIslands, report_a_matrix_that_is_too_large) {
    ContactRun<scenes::MassRatio<3, 1000>, DirectIslands<4, 2>> small;
    ContactRun<scenes::MassRatio<3, 1000>, Sweeps> swept;
    small.step(30);
    swept.step(30);
    EXPECT_EQ(small.totals.unfinished, 4 * 30);
    EXPECT_EQ(small.totals.solves, 0);
    EXPECT_EQ(small.world->state_hash(), swept.world->state_hash());
}

/// A column of light and heavy on ground that is tilted by way of gravity: it slides as one, by the closed form.
struct SlidingColumn : scenes::MassRatio<1, 1000> {
    static constexpr scalar mu = scalar(0.3);
    static constexpr Vector gravity = {scalar(9.81) * scalar(0.5), 0, -scalar(9.81) * scalar(0.8660254)};
    static constexpr scenes::PlacedBody body(int body_i) {
        scenes::PlacedBody placed = scenes::MassRatio<1, 1000>::body(body_i);
        placed.mu = mu;
        return placed;
    }
};
TEST(DirectIslands, slide_as_coulomb_says) {
    ContactRun<SlidingColumn, Direct> run;
    const int steps = 120;
    run.step(steps);
    const double t = steps / 60.0, mu = static_cast<double>(SlidingColumn::mu),
                 g_x = static_cast<double>(SlidingColumn::gravity.x), g_z = -static_cast<double>(SlidingColumn::gravity.z),
                 expected = 0.5 * (g_x - mu * g_z) * t * t;
    for (const std::size_t body_i : {std::size_t(1), std::size_t(2)})
        EXPECT_NEAR(static_cast<double>(run.place(body_i).x), expected, 1e-5 * expected) << body_i;
    EXPECT_LE(run.totals.overlap, rounding_of_place);
    EXPECT_EQ(run.totals.unfinished, 0);
    std::printf("slides %.6f m, closed form %.6f, %d unfinished\n", static_cast<double>(run.place(1).x), expected,
                run.totals.unfinished);
}

/// A heavy cube that falls flat on a light one: neither sinks into the other, and energy does not grow.
struct Landing : scenes::MassRatio<1, 1000> {
    static constexpr scenes::PlacedBody body(int body_i) {
        scenes::PlacedBody placed = scenes::MassRatio<1, 1000>::body(body_i);
        if (body_i == 2) placed.def.state.r_CM.z += scalar(0.5);
        return placed;
    }
};
double energy_of(const ContactRun<Landing, Direct>& run) {
    double sum = 0;
    for (std::size_t body_i = 1; body_i < run.ids.size(); ++body_i)
        sum += static_cast<double>(run.world->kinetic_energy(run.ids[body_i]).value) +
               static_cast<double>(run.world->mass(run.ids[body_i]).value) * 9.81 * static_cast<double>(run.place(body_i).z);
    return sum;
}
TEST(DirectIslands, land_without_sinking_in) {
    ContactRun<Landing, Direct> run;
    double before = energy_of(run), most = 0;
    for (int step_i = 0; step_i < 120; ++step_i) {
        run.step(1);
        const double now = energy_of(run);
        most = std::fmax(most, now - before);
        before = now;
    }
    EXPECT_LE(run.totals.overlap, 1e-3);  // limits::touching_gap: within it a point is stopped as if it touched
    EXPECT_LE(most, 1e-4 * before);
    EXPECT_EQ(run.totals.unfinished, 0);
    std::printf("lands: overlap %.4f mm, largest gain %.3g of the energy\n", run.totals.overlap * 1e3, most / before);
}

}  // namespace
