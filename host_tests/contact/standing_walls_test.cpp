// SPDX-License-Identifier: MIT
// What stands goes on standing: walls of many rows, of bricks of any size, which nothing holds but friction and their weight, and which do not sleep.
#include <gtest/gtest.h>

#include <ingot/ingot.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/draws.h"
#include "reference/random_input.h"

namespace {

using ingot::BodyDef;
using ingot::BodyId;
using ingot::scalar;
using ingot::Vector;
using ingot_reference::RandomInput;

constexpr double g = 9.81;  // m s^-2

struct Yard : ingot::Scene {
    static constexpr int max_bodies = 260, max_manifolds = 1000;
    static constexpr bool translates = true, bounces = false;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
    using broad_phase = ingot::SortedTree;
};

/// Rows of whole bricks, and between them rows of one less and a half at each end.
struct Wall {
    double length, thickness, height;  ///< m, of a brick
    int rows, bricks;
    double joint;  ///< m, between neighbours
    double density, mu;
    double slope;  ///< rad, of the ground along the wall: much less than friction holds
    int rate;      ///< steps a second

    /// How far it leans by itself in a substep, against what a sweep takes back: the root of (N h)^2 g s / b^2, see solver/README.md.
    double leaning() const { return rows / (4.0 * rate) * std::sqrt(g * height) / (thickness / 2); }
};

/// One that stays within what the sweeps of a substep hold up.
Wall drawn_wall(RandomInput& random) {
    for (;;) {
        Wall wall{};
        wall.height = std::pow(10, random.real(-1.3, 0));
        wall.length = wall.height * random.real(1.5, 4);
        wall.thickness = wall.height * random.real(1.2, 2.5);
        wall.rows = random.integer(12, 20);
        wall.bricks = random.integer(4, 8);
        wall.joint = wall.length * random.real(0.001, 0.02);
        wall.density = random.real(500, 3000);
        wall.mu = random.real(0.4, 0.9);
        wall.slope = random.integer(0, 1) * random.real(0, 0.1);
        constexpr int rates[] = {30, 60, 120, 240};
        wall.rate = rates[random.integer(0, 3)];
        if (wall.leaning() < 3) return wall;
    }
}

struct Built {
    Wall wall;
    ingot::World<Yard> world;
    std::vector<BodyId> ids;
    std::vector<Vector> laid;
    int contacts_of_step = 0;

    explicit Built(const Wall& of) : wall(of) {
        BodyDef ground;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        ground.friction = static_cast<scalar>(wall.mu);
        EXPECT_TRUE(world.add(ground).ok());
        const Vector gravity = {static_cast<scalar>(g * std::sin(wall.slope)), 0, static_cast<scalar>(-g * std::cos(wall.slope))};
        EXPECT_EQ(world.set_gravity(gravity), ingot::Status::ok);
        const double pitch = wall.length + wall.joint, half = (wall.length - wall.joint) / 2;
        for (int row = 0; row < wall.rows; ++row) {
            const bool whole = row % 2 == 0;
            for (int i = 0; i < wall.bricks - (whole ? 0 : 1); ++i) lay(row, (i + (whole ? 0.5 : 1)) * pitch, wall.length);
            if (whole) continue;
            lay(row, wall.joint / 2 + half / 2, half);
            lay(row, wall.bricks * pitch - wall.joint / 2 - half / 2, half);
        }
    }
    void lay(int row, double x, double length) {
        const Vector extents = {static_cast<scalar>(length / 2), static_cast<scalar>(wall.thickness / 2), static_cast<scalar>(wall.height / 2)};
        BodyDef brick;
        brick.mass = ingot::principal(ingot::solid_box(static_cast<scalar>(wall.density), extents)).value;
        brick.shape = ingot::Box{extents};
        brick.friction = static_cast<scalar>(wall.mu);
        brick.state.r_CM = {static_cast<scalar>(x), 0, static_cast<scalar>((row + 0.5) * wall.height)};
        laid.push_back(brick.state.r_CM);
        const auto id = world.add(brick);
        ASSERT_TRUE(id.ok());
        ids.push_back(id.value);
    }
    void run(double seconds) {
        const scalar h = scalar(1) / static_cast<scalar>(wall.rate);
        for (int step_i = 0; step_i < seconds * wall.rate; ++step_i) contacts_of_step = ingot::step(world, h).contacts;
    }
    /// m, of the brick that is furthest from where it was laid.
    double shift() {
        double most = 0;
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const Vector d = world.state(ids[i]).value.r_CM - laid[i];
            most = std::max(most, std::hypot(static_cast<double>(d.x), static_cast<double>(d.y), static_cast<double>(d.z)));
        }
        return most;
    }
};

/// A wall that is let lean begins by a rounding, and its lean grows by e in the time in which a brick falls by its height, about: it is given fifty
/// of these. What the last sweeps leave moves it to and fro; so any bound between that and a brick tells the same, four of these times apart.
TEST(Walls, go_on_standing) {
    RandomInput random(41);
    for (int draw_i = 0; draw_i < ingot_reference::draws(24); ++draw_i) {
        Built built(drawn_wall(random));
        const Wall& wall = built.wall;
        built.run(50 * std::sqrt(wall.height / g));
        EXPECT_GT(built.contacts_of_step, ingot::limits::small_island) << "too few for a large island";
        EXPECT_LE(built.shift(), wall.height / 50)
            << "draw " << draw_i << ": " << wall.rows << " rows of " << wall.bricks << ", " << wall.length << " x " << wall.thickness << " x "
            << wall.height << " m at " << wall.rate << " Hz, leaning " << wall.leaning();
    }
}

}  // namespace
