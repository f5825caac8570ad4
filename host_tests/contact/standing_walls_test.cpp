// SPDX-License-Identifier: MIT
// What stands goes on standing: walls of many rows, of bricks of any size, which nothing holds but friction and their weight, and which do not sleep.
#include <gtest/gtest.h>

#include <ingot/ingot.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "reference/draws.h"
#include "reference/powers_of_two.h"
#include "reference/random_input.h"

namespace {

using ingot::BodyDef;
using ingot::BodyId;
using ingot::scalar;
using ingot::Vector;
using ingot_reference::equal;
using ingot_reference::power_of_two;
using ingot_reference::RandomInput;

constexpr double g = 9.81;  // m s^-2

/// Lengths, speeds and gravity are 2^k times as large.
template <int k>
struct Yard : ingot::Scene {
    static constexpr int max_bodies = 520, max_manifolds = 2000;
    static constexpr bool translates = true, bounces = false;
    static constexpr scalar length_unit = power_of_two(k);
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

/// One wall, or two that stand 30 m apart, whose bricks come in turns.
template <int k = 0>
struct Built {
    Wall wall;
    ingot::World<Yard<k>> world;
    std::vector<BodyId> ids;
    std::vector<Vector> laid;
    int contacts_of_step = 0;

    explicit Built(const Wall& of, const Wall* other = nullptr) : wall(of) {
        BodyDef ground;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        ground.friction = static_cast<scalar>(wall.mu);
        EXPECT_TRUE(world.add(ground).ok());
        const auto along = [](double x) { return static_cast<scalar>(x) * power_of_two(k); };
        EXPECT_EQ(world.set_gravity({along(g * std::sin(wall.slope)), 0, along(-g * std::cos(wall.slope))}), ingot::Status::ok);
        std::vector<BodyDef> others;
        if (other != nullptr)
            for_bricks(*other, 30, [&](const BodyDef& brick) { others.push_back(brick); });
        std::size_t next = 0;
        for_bricks(wall, 0, [&](const BodyDef& brick) {
            if (next < others.size()) add(others[next++]);
            laid.push_back(brick.state.r_CM);
            ids.push_back(add(brick));
        });
        for (; next < others.size(); ++next) add(others[next]);
    }
    BodyId add(const BodyDef& def) {
        const auto id = world.add(def);
        EXPECT_TRUE(id.ok());
        return id.value;
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

private:
    template <class Each>
    static void for_bricks(const Wall& of, double y, const Each& each) {
        const double pitch = of.length + of.joint, half = (of.length - of.joint) / 2;
        for (int row = 0; row < of.rows; ++row) {
            const bool whole = row % 2 == 0;
            for (int i = 0; i < of.bricks - (whole ? 0 : 1); ++i) each(brick(of, row, (i + (whole ? 0.5 : 1)) * pitch, y, of.length));
            if (whole) continue;
            each(brick(of, row, of.joint / 2 + half / 2, y, half));
            each(brick(of, row, of.bricks * pitch - of.joint / 2 - half / 2, y, half));
        }
    }
    /// The mass is that of scale 1.
    static BodyDef brick(const Wall& of, int row, double x, double y, double length) {
        const auto along = [](double m) { return static_cast<scalar>(m) * power_of_two(k); };
        const Vector extents = {along(length / 2), along(of.thickness / 2), along(of.height / 2)};
        BodyDef def;
        def.mass = ingot::principal(ingot::solid_box(static_cast<scalar>(of.density) * power_of_two(-3 * k), extents)).value;
        def.shape = ingot::Box{extents};
        def.friction = static_cast<scalar>(of.mu);
        def.state.r_CM = {along(x), along(y), along((row + 0.5) * of.height)};
        return def;
    }
};

/// A wall that is let lean begins by a rounding, and its lean grows by e in the time in which a brick falls by its height, about: it is given fifty
/// of these. What the last sweeps leave moves it to and fro; so any bound between that and a brick tells the same, four of these times apart.
TEST(Walls, go_on_standing) {
    RandomInput random(41);
    for (int draw_i = 0; draw_i < ingot_reference::draws(24); ++draw_i) {
        Built<> built(drawn_wall(random));
        const Wall& wall = built.wall;
        built.run(50 * std::sqrt(wall.height / g));
        EXPECT_GT(built.contacts_of_step, ingot::limits::small_island) << "too few for a large island";
        EXPECT_LE(built.shift(), wall.height / 50)
            << "draw " << draw_i << ": " << wall.rows << " rows of " << wall.bricks << ", " << wall.length << " x " << wall.thickness << " x "
            << wall.height << " m at " << wall.rate << " Hz, leaning " << wall.leaning();
    }
}

/// What stands beside it, and falls there as its friction gives way, is nothing to it: the same bits.
TEST(Walls, stand_beside_others_as_they_do_alone) {
    RandomInput random(43);
    for (int draw_i = 0; draw_i < ingot_reference::draws(16); ++draw_i) {
        const Wall wall = drawn_wall(random);
        Wall other = drawn_wall(random);
        other.mu = random.integer(0, 1) == 0 ? 0 : other.mu;
        Built<> alone(wall), beside(wall, &other);
        const double seconds = 10 * std::sqrt(wall.height / g);
        alone.run(seconds);
        beside.run(seconds);
        for (std::size_t i = 0; i < alone.ids.size(); ++i) {
            const ingot::BodyState a = alone.world.state(alone.ids[i]).value, b = beside.world.state(beside.ids[i]).value;
            ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0) << "draw " << draw_i << ", brick " << i;
        }
    }
}

template <int k>
void expect_the_same_at(const Wall& wall, int draw_i) {
    Built<> one(wall);
    Built<k> scaled(wall);
    const double seconds = 10 * std::sqrt(wall.height / g);
    one.run(seconds);
    scaled.run(seconds);
    const scalar length = power_of_two(k);
    for (std::size_t i = 0; i < one.ids.size(); ++i) {
        const ingot::BodyState a = one.world.state(one.ids[i]).value, b = scaled.world.state(scaled.ids[i]).value;
        ASSERT_TRUE(equal(a.r_CM * length, b.r_CM) && equal(a.v_CM * length, b.v_CM) && equal(a.A.c0, b.A.c0) && equal(a.A.c1, b.A.c1) &&
                    equal(a.L * (length * length), b.L))
            << "draw " << draw_i << ", 2^" << k << ", brick " << i;
    }
}

/// A wall of bricks of a kilometre's part, or of kilometres, stands as this one does, to the bit.
TEST(Walls, stand_at_any_scale_alike) {
    RandomInput random(47);
    for (int draw_i = 0; draw_i < ingot_reference::draws(16); ++draw_i) {
        const Wall wall = drawn_wall(random);
        if (random.integer(0, 1) == 0)
            expect_the_same_at<-8>(wall, draw_i);
        else
            expect_the_same_at<8>(wall, draw_i);
    }
}

}  // namespace
