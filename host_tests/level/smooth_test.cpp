// SPDX-License-Identifier: MIT
// Whatever a plane is cut into, a body goes over it as over one plane.
#include <gtest/gtest.h>

#include "ground.h"
#include "reference/draws.h"

namespace {

using namespace level_test;

/// m, of heights there.
double rounding_of(const BodyDef& def) { return 4 * static_cast<double>(ingot::epsilon * std::abs(def.state.r_CM.z)); }

void goes_as_on_a_slab(int draw) {
    Random random(static_cast<uint64_t>(9000 + draw));
    const auto seams = static_cast<Seams>(between(random, 0, seams_count - 1));
    const auto kind = static_cast<Goer>(between(random, 0, goers_count - 1));
    const Ground ground = plane_of(random, seams);
    constexpr int rates[] = {30, 60, 120, 240, 1000};
    const int rate = rates[random() % 5];
    const double speed = about(random, 0.5, 20), size = about(random, 0.05, 0.8);
    BodyDef def = goer(random, kind, static_cast<scalar>(size), speed);
    def.state.r_CM = def.state.r_CM + ground.middle;
    const int steps = static_cast<int>(std::min(2.0, ground.reach / speed) * rate);

    const Went as = go_on_slab(ground.middle.z, def, rate, steps);
    auto& on_level = empty_world<OnLevel>();
    add_level(on_level, ground.view);
    const Went went = go(on_level, def, rate, steps);

    const std::string what = "draw " + std::to_string(draw) + ", seams " + std::to_string(static_cast<int>(seams)) + ", body " +
                             std::to_string(static_cast<int>(kind)) + ", size " + std::to_string(size) + ", speed " + std::to_string(speed) + ", " +
                             std::to_string(rate) + " Hz";
    EXPECT_EQ(went.lost, 0) << what;
    EXPECT_NEAR(length(went.by) / length(as.by), 1, 1e-3) << what;
    EXPECT_LE(length(went.v - as.v), 1e-3 * speed) << what;
    EXPECT_LE(went.hop - as.hop, 1e-4 + rounding_of(def)) << what;
    EXPECT_LE(went.sink - as.sink, 1e-4 + rounding_of(def)) << what;
    EXPECT_NEAR(went.impulse / as.impulse, 1, 0.01) << what;
}

/// Half of the ground is a level, and half another one, a box, a row of boxes or of hulls, or a plane that goes on below the level: over the seam.
enum Beside { another_level, one_box, boxes, hulls, a_plane };
void crosses_a_seam(int draw, Beside beside) {
    Random random(static_cast<uint64_t>(40000 + draw));
    const Soup soup = terrain(random, between(random, 8, 30), 128, [](int, int) { return 8; });
    Ground ground, other;
    take_mesh(soup, 1.0 / 256, ground);
    const double width = static_cast<double>(ground.view.high.x);
    take_mesh(terrain(random, between(random, 8, 30), 128, [](int, int) { return 8; }), 1.0 / 256, other);
    const double common = std::min(width, static_cast<double>(other.view.high.x));
    const auto kind = static_cast<Goer>(between(random, 0, goers_count - 2));
    constexpr int rates[] = {30, 60, 120, 240, 1000};
    const int rate = rates[random() % 5];
    const double size = about(random, 0.05, 0.4), speed = about(random, 1, 20);
    BodyDef def = goer(random, kind, static_cast<scalar>(size), speed);
    const double back = std::min(1.0, 0.2 * width), seconds = std::min(2.0, 2 * back / speed);
    const Vector seam = {0, static_cast<scalar>(common / 2), 8.0f / 256};
    def.state.r_CM = def.state.r_CM + seam - def.state.v_CM * static_cast<scalar>(back / speed);

    const Went as = go_on_slab(seam.z, def, rate, static_cast<int>(seconds * rate));
    auto& on_level = empty_world<OnLevel>();
    add_level(on_level, ground.view);
    OnLevel::levels[1] = other.view;
    if (beside == another_level) {
        LevelDef def_of_other;
        def_of_other.number = 1;
        def_of_other.friction = scalar(0.3);
        def_of_other.r = {-other.view.high.x, 0, 0};
        ASSERT_TRUE(on_level.add_level(def_of_other).ok());
    } else {
        BodyDef solid;
        solid.immovable = true;
        solid.friction = scalar(0.3);
        const auto half = static_cast<scalar>(beside == one_box ? 10 : 1);
        solid.shape = ingot::Box{{half, half, half}};
        if (beside == hulls) solid.shape = ingot::hull_of<OnLevel>(1);
        if (beside == a_plane) solid.shape = ingot::HalfSpace{{0, 0, 1}, seam.z};
        for (int i = -3; i < 12; ++i) {
            if (beside != a_plane) solid.state.r_CM = {-half, beside == one_box ? static_cast<scalar>(2) : static_cast<scalar>(2 * i), seam.z - half};
            ASSERT_TRUE(on_level.add(solid).ok());
            if (beside == one_box || beside == a_plane) break;
        }
    }
    const Went went = go(on_level, def, rate, static_cast<int>(seconds * rate));
    std::string what = "draw " + std::to_string(draw) + ", beside " + std::to_string(static_cast<int>(beside)) + ", body ";
    what += std::to_string(static_cast<int>(kind)) + ", size " + std::to_string(size) + ", speed " + std::to_string(speed) + ", ";
    what += std::to_string(rate) + " Hz";
    EXPECT_NEAR(length(went.by) / length(as.by), 1, 1e-3) << what;
    EXPECT_LE(length(went.v - as.v), 1e-3 * speed) << what;
    EXPECT_LE(went.hop - as.hop, 1e-4 + rounding_of(def)) << what;
    EXPECT_LE(went.sink - as.sink, 1e-4 + rounding_of(def)) << what;
}

TEST(SmoothGround, goes_on_across_the_seams_of_levels_and_boxes) {
    constexpr Beside first[] = {another_level, one_box, boxes}, then[] = {hulls, a_plane};
    for (int draw = 0; draw < ingot_reference::draws(600); ++draw) crosses_a_seam(draw, first[draw % 3]);
    for (int draw = 0; draw < ingot_reference::draws(400); ++draw) crosses_a_seam(draw, then[draw % 2]);
}

/// The bars of the project: way and speed within 0.1 %, no hop above 0.1 mm, what the ground bears within 1 %.
TEST(SmoothGround, bodies_go_as_on_a_slab) {
    for (int draw = 0; draw < ingot_reference::draws(1200); ++draw) goes_as_on_a_slab(draw);
}

}  // namespace
