// SPDX-License-Identifier: MIT
// How a mover goes: over stairs, up to its slope, along walls, into corners, on moving ground.
#include <gtest/gtest.h>

#include "course.h"
#include "reference/random_input.h"

namespace {

using namespace mover_test;

struct Stairs {
    double rise, tread;
};
constexpr Stairs stairs_of[] = {{0.17, 0.29}, {0.20, 0.25}, {0.30, 0.30}};
constexpr int steps_of_stairs = 8;

/// Up along x from x = 4, a landing of 6 m, and down again; as boxes that stand on the ground. With a wall on one side.
std::vector<Block> staircase(const Stairs& stairs, double& length) {
    const double rise = on_lattice(stairs.rise), tread = on_lattice(stairs.tread);
    std::vector<Block> blocks = {{{-6, -4, -1}, {30, 4, 0}}, {{-6, 1.5, 0}, {30, 2, 6}}};
    double x = 4;
    for (int i = 1; i <= steps_of_stairs; ++i, x += tread) blocks.push_back({{x, -1.5, 0}, {x + tread, 1.5, rise * i}});
    blocks.push_back({{x, -1.5, 0}, {x + 6, 1.5, rise * steps_of_stairs}});
    x += 6;
    for (int i = steps_of_stairs; i >= 1; --i, x += tread) blocks.push_back({{x, -1.5, 0}, {x + tread, 1.5, rise * i}});
    length = x;
    return blocks;
}

/// What a walk along x over a course did.
struct Walked {
    double seconds = 0, highest = 0, least_gap = 1, aside = 0;
    int in_air = 0;
};
template <class S>
Walked walk(World<S>& world, Mover mover, const std::vector<Block>& blocks, double speed, double to, scalar h, double across = 0) {
    Walked walked;
    const double y = static_cast<double>(mover.r.y);
    const MoverInput input = {{static_cast<scalar>(speed), static_cast<scalar>(across), 0}, 0};
    const int steps = static_cast<int>(2 * to / speed / static_cast<double>(h));
    for (int i = 0; i < steps && static_cast<double>(mover.r.x) < to; ++i) {
        EXPECT_EQ(world.move(mover, input, h), Status::ok);
        walked.seconds += static_cast<double>(h);
        walked.highest = std::max(walked.highest, static_cast<double>(mover.r.z) - 0.91);
        walked.in_air += stands(mover) ? 0 : 1;
        walked.aside = std::max(walked.aside, std::abs(static_cast<double>(mover.r.y) - y));
        walked.least_gap = std::min(walked.least_gap, gap_to(mover, blocks));
    }
    return walked;
}

/// Over both flights, at every rate and speed, in the middle and along the wall: as fast as on the flat, and never off the ground.
template <class S>
void climb_all(bool as_mesh) {
    const scalar rates[] = {30, 60, 240};
    const double speeds[] = {1, 2.5, 5, 8};
    for (const Stairs& stairs : stairs_of)
        for (const scalar rate : rates)
            for (const double speed : speeds) {
                if (INGOT_TEST_BRIEF && (rate > 100 || (speed != 2.5 && speed != 8.0))) continue;
                for (const double across : {0.0, 0.5}) {
                    double to = 0;
                    const std::vector<Block> blocks = staircase(stairs, to);
                    auto& world = empty_world<S>();
                    level_tool::MeshData mesh;
                    if (as_mesh)
                        add_as_mesh(world, blocks, mesh);
                    else
                        add_as_boxes(world, blocks);
                    const Mover mover = standing_at(world, 0, across > 0 ? 1.19 : 0, 0);
                    const Walked walked = walk(world, mover, blocks, speed, to + 3, 1 / rate, across);
                    const auto where = ::testing::Message() << stairs.rise << "/" << stairs.tread << " at " << speed << " m/s, " << rate
                                                            << " Hz, across " << across;
                    EXPECT_NEAR(walked.highest, on_lattice(stairs.rise) * steps_of_stairs, 2e-3) << where;
                    const double flat = (to + 3 - static_cast<double>(mover.r.x)) / speed;
                    EXPECT_LT(walked.seconds, flat * 1.01 + 1 / static_cast<double>(rate)) << where;
                    EXPECT_EQ(walked.in_air, 0) << where;
                    EXPECT_GT(walked.least_gap, 0) << where;
                    if (::testing::Test::HasFailure()) return;
                }
            }
}

TEST(MoverOnStairs, of_boxes_is_as_fast_as_on_the_flat) { climb_all<Street>(false); }
TEST(MoverOnStairs, of_triangles_is_as_fast_as_on_the_flat) { climb_all<Street>(true); }

/// A ramp from x = 2 on, of one box or of two triangles, and where a mover gets to that walks at it for 3 s from x = 0.
double height_on_ramp(double degrees, bool as_mesh, scalar h, double speed) {
    auto& world = empty_world<Street>();
    (void)add_plane(world);
    const double angle = degrees * pi / 180;
    level_tool::MeshData mesh;
    if (as_mesh) {
        // As exact as the lattice: 0.01 degrees.
        level_test::Soup soup;
        const int far = 8192, high = static_cast<int>(std::lround(far * std::tan(angle)));
        soup.points = {level_test::lattice_point(0, 0, 0), level_test::lattice_point(far, 0, high), level_test::lattice_point(far, 8192, high),
                       level_test::lattice_point(0, 8192, 0)};
        soup.faces = {{0, 1, 2}, {0, 2, 3}};
        mesh = level_test::built(soup);
        Street::levels[0] = mesh.view;
        ingot::LevelDef def;
        def.r = {2, -4, 0};
        EXPECT_TRUE(world.add_level(def).ok());
    } else {
        const V half(8, 4, 1), along(std::cos(angle), 0, std::sin(angle)), n(-std::sin(angle), 0, std::cos(angle));
        (void)add_box(world, half, V(2, 0, 0) + along * 8 - n, pitched(-angle));
    }
    Mover mover = standing_at(world, 0, 0, 0);
    double highest = 0;
    for (int i = 0; i < static_cast<int>(3 / static_cast<double>(h)); ++i) {
        EXPECT_EQ(world.move(mover, {{static_cast<scalar>(speed), 0, 0}, 0}, h), Status::ok);
        highest = std::max(highest, static_cast<double>(mover.r.z) - 0.91);
    }
    return highest;
}

TEST(MoverOnSlope, of_its_limit_is_sharp_to_a_tenth_of_a_degree) {
    for (const bool as_mesh : {false, true})
        for (const scalar rate : {scalar(30), scalar(60), scalar(240)})
            for (const double speed : {1.5, 6.0}) {
                const auto where = ::testing::Message() << (as_mesh ? "mesh " : "box ") << rate << " Hz " << speed << " m/s";
                EXPECT_GT(height_on_ramp(49.9, as_mesh, 1 / rate, speed), 0.9 * speed) << where;
                EXPECT_LT(height_on_ramp(50.1, as_mesh, 1 / rate, speed), 0.05) << where;
            }
}

/// Speed over the ground is across `up`: as far on a slope as on the flat, up and down.
TEST(MoverOnSlope, is_as_fast_as_on_the_flat) {
    for (const double degrees : {-45.0, -20.0, 0.0, 10.0, 30.0, 49.0}) {
        const double angle = degrees * pi / 180;
        auto& world = empty_world<Street>();
        (void)add_plane(world, rounded(V(-std::sin(angle), 0, std::cos(angle)).normalized()));
        Mover mover = standing_at(world, 0, 0, 0.5);
        const Vector from = mover.r;
        for (int i = 0; i < 120; ++i) {
            ASSERT_EQ(world.move(mover, {{3, 2, 0}, 0}, scalar(1) / 60), Status::ok);
            ASSERT_TRUE(stands(mover)) << degrees << " at " << i;
        }
        EXPECT_NEAR(static_cast<double>(mover.r.x - from.x), 6, 6e-4) << degrees;
        EXPECT_NEAR(static_cast<double>(mover.r.y - from.y), 4, 4e-4) << degrees;
        EXPECT_NEAR(static_cast<double>(mover.v.x), 3, 3e-3) << degrees;
    }
}

/// Along a wall of many flush blocks, of boxes and of triangles: v cos of the angle.
TEST(MoverAtWall, slides_along_it_at_v_cos) {
    for (const bool as_mesh : {false, true})
        for (const double degrees : {5.0, 30.0, 60.0, 85.0}) {
            std::vector<Block> blocks = {{{-4, -4, -1}, {20, 6, 0}}};
            for (int i = 0; i < 24; ++i) blocks.push_back({{i * 1.0 - 4, 2, 0}, {i * 1.0 - 3, 3, i % 3 == 0 ? 4.0 : 3.0}});
            auto& world = empty_world<Street>();
            level_tool::MeshData mesh;
            if (as_mesh)
                add_as_mesh(world, blocks, mesh);
            else
                add_as_boxes(world, blocks);
            Mover mover = standing_at(world, 0, 1.6, 0);
            const double angle = degrees * pi / 180, speed = 4;
            const MoverInput input = {{static_cast<scalar>(speed * std::cos(angle)), static_cast<scalar>(speed * std::sin(angle)), 0}, 0};
            for (int i = 0; i < 30; ++i) ASSERT_EQ(world.move(mover, input, scalar(1) / 60), Status::ok);
            const Vector from = mover.r;
            double gap = 1;
            for (int i = 0; i < 120; ++i) {
                ASSERT_EQ(world.move(mover, input, scalar(1) / 60), Status::ok);
                gap = std::min(gap, gap_to(mover, blocks));
            }
            const double way = 2 * speed * std::cos(angle);
            EXPECT_NEAR(static_cast<double>(mover.r.x - from.x), way, 1e-3 * way) << degrees << (as_mesh ? " mesh" : " boxes");
            EXPECT_NEAR(static_cast<double>(mover.r.z), 0.91, 1e-4);
            EXPECT_NEAR(gap, 0.01, 1e-4);
        }
}

/// Into a corner of any angle, from any side: it comes to rest, to the bit.
TEST(MoverInCorner, comes_to_rest) {
    for (const double opening : {20.0, 45.0, 90.0, 170.0})
        for (const double aim : {-0.8, 0.0, 0.5}) {
            auto& world = empty_world<Street>();
            (void)add_plane(world);
            const double half = opening / 2 * pi / 180;
            for (const double side : {-1.0, 1.0}) {
                const V along(-std::cos(half), side * std::sin(half), 0), out(std::sin(half), side * std::cos(half), 0);
                const Matrix A = {rounded(along), rounded(V::UnitZ().cross(along)), {0, 0, 1}};
                (void)add_box(world, {6, 1, 4}, V(8, 0, 2) + along * 6 + out, A);
            }
            Mover mover = standing_at(world, 8 - 0.31 / std::sin(half) - 0.2, 0, 0);
            const double angle = aim * (pi / 2 - half);  // so that it goes towards the corner along either wall
            const MoverInput input = {{static_cast<scalar>(3 * std::cos(angle)), static_cast<scalar>(3 * std::sin(angle)), 0}, 0};
            for (int i = 0; i < 500; ++i) ASSERT_EQ(world.move(mover, input, scalar(1) / 60), Status::ok);
            const V from = exact(mover.r);
            double jitter = 0;
            for (int i = 0; i < 120; ++i) {
                ASSERT_EQ(world.move(mover, input, scalar(1) / 60), Status::ok);
                jitter = std::max(jitter, (exact(mover.r) - from).norm());
            }
            EXPECT_LT(jitter, 1e-5) << opening << " aim " << aim;
            EXPECT_TRUE(stands(mover));
        }
}

/// What a lift and a turntable carry stays where it is on them.
TEST(MoverOnMovingGround, does_not_drift) {
    for (const scalar rate : {scalar(30), scalar(60), scalar(240)})
        for (const double lift : {3.0, -3.0, 0.0}) {
            auto& world = empty_world<Street>();
            const BodyId ground = add_box(world, {3, 3, 0.5}, {0, 0, -0.5}, ingot::identity_matrix<scalar>(), true);
            Mover mover = standing_at(world, 1.5, 0.7, 0);
            const Vector spin = {0, 0, lift == 0.0 ? scalar(1) : scalar(0)};
            ASSERT_EQ(world.set_velocity(ground, {0, 0, static_cast<scalar>(lift)}, spin), Status::ok);
            const auto place = [&] {
                const ingot::BodyState state = world.state(ground).value;
                return exact(ingot::transpose_times(state.A, mover.r - state.r_CM));
            };
            const V from = place();
            const double seconds = 5;
            for (int i = 0; i < static_cast<int>(seconds * static_cast<double>(rate)); ++i) {
                (void)ingot::step(world, 1 / rate);
                ASSERT_EQ(world.move(mover, {}, 1 / rate), Status::ok);
                ASSERT_TRUE(stands(mover)) << i;
            }
            EXPECT_LT((place() - from).norm(), 1e-4 * seconds) << rate << " Hz, " << lift << " m/s";
            EXPECT_NEAR(static_cast<double>(mover.v.z), lift, 1e-3 * static_cast<double>(rate) / 30) << rate;
            if (lift == 0.0) {
                EXPECT_NEAR(exact(mover.v).norm(), std::hypot(1.5, 0.7), 0.03);
            }
        }
}

/// The velocity of its ground is that by which it was carried: a mover that stands still goes by just as much, on what goes up, along, and round. One
/// that has just landed is told what its ground does where it touches it, and gets out of what it came into its skin by in the move after that.
TEST(MoverOnMovingGround, is_told_how_it_is_carried) {
    ingot_reference::RandomInput random(207);
    for (int draw_i = 0; draw_i < 40; ++draw_i) {
        auto& world = empty_world<Street>();
        const int rate = random.integer(30, 240);
        const scalar h = 1 / static_cast<scalar>(rate);
        const BodyId ground = add_box(world, {6, 6, 0.5}, {0, 0, -0.5}, ingot::identity_matrix<scalar>(), true);
        const Vector v = rounded(random.vector(1)), omega = {0, 0, scalar(random.real(-2, 2))};
        ASSERT_EQ(world.set_velocity(ground, v, omega), Status::ok);
        Mover mover = standing_at(world, random.real(-2, 2), random.real(-2, 2), 0);
        mover.r.z += scalar(random.real(0.1, 0.3));
        mover.ground = {};
        int moves = 0;  // since it landed
        for (int i = 0; i < rate; ++i) {
            const V before = exact(mover.r);
            (void)ingot::step(world, h);
            ASSERT_EQ(world.move(mover, {}, h), Status::ok);
            if (!stands(mover)) continue;
            const ingot::BodyState state = world.state(ground).value;
            const V lever = exact(mover.ground.P) - exact(state.r_CM), turning = exact(omega).cross(lever) + exact(v);
            const V went = (exact(mover.r) - before) / static_cast<double>(h);
            // A rounding of places of 3 m, in a step, and of the skin that it keeps.
            const double rounding = 64 * static_cast<double>(ingot::epsilon) * 3 / static_cast<double>(h);
            if (moves != 1) {
                EXPECT_LE((exact(mover.ground.v) - (moves == 0 ? turning : went)).norm(), rounding) << draw_i << ", step " << i;
            }
            ++moves;
        }
        EXPECT_GT(moves, 1);
    }
}

TEST(MoverOnMovingGround, takes_its_velocity_along_when_it_jumps) {
    for (const int rate : {10, 60, 240})
        for (const double speed : {1.0, 4.0, 20.0}) {
            SCOPED_TRACE(::testing::Message() << rate << " Hz, " << speed << " m/s");
            auto& world = empty_world<Street>();
            const BodyId ground = add_box(world, {9, 3, 0.5}, {0, 0, -0.5}, ingot::identity_matrix<scalar>(), true);
            Mover mover = standing_at(world, 0, 0, 0);
            ASSERT_EQ(world.set_velocity(ground, {static_cast<scalar>(speed), 0, 1}), Status::ok);
            const scalar h = 1 / static_cast<scalar>(rate);
            const auto place = [&] { return V(exact(mover.r) - exact(world.state(ground).value.r_CM)); };
            for (int i = 0; i < 10; ++i) {
                (void)ingot::step(world, h);
                ASSERT_EQ(world.move(mover, {}, h), Status::ok);
            }
            const V before = place();
            (void)ingot::step(world, h);
            ASSERT_EQ(world.move(mover, {{0, 0, 0}, 3}, h), Status::ok);
            EXPECT_EQ(mover.ground.footing, MoverFooting::none);
            EXPECT_NEAR(static_cast<double>(mover.v.x), speed, 1e-3);
            EXPECT_NEAR(static_cast<double>(mover.v.z), 4 - 9.81 / rate, 1e-3);
            EXPECT_NEAR((place() - before).z(), 3.0 / rate - 9.81 / 2 / rate / rate, 1e-3) << "as high as from ground that stands";
            double seconds = 1.0 / rate;
            while (!stands(mover) && seconds < 2) {
                (void)ingot::step(world, h);
                ASSERT_EQ(world.move(mover, {}, h), Status::ok);
                seconds += 1.0 / rate;
            }
            EXPECT_NEAR(seconds, 2 * 3 / 9.81, 1.5 / rate);
            EXPECT_NEAR(place().x(), before.x(), 1e-3) << "it lands where it jumped";
        }
}

/// A lift that is put somewhere else takes it along, and the next move is as any other.
TEST(MoverOnMovingGround, goes_along_where_its_ground_is_put) {
    auto& world = empty_world<Street>();
    const BodyId ground = add_box(world, {2, 2, 0.5}, {0, 0, -0.5}, ingot::identity_matrix<scalar>(), true);
    Mover mover = standing_at(world, 0.5, 0, 0);
    ingot::BodyState state = world.state(ground).value;
    state.r_CM.x = 65536;
    ASSERT_EQ(world.set_state(ground, state), Status::ok);
    for (int i = 0; i < 3; ++i) ASSERT_EQ(world.move(mover, {}, scalar(1) / 60), Status::ok);
    EXPECT_NEAR(static_cast<double>(mover.r.x), 65536.5, 0.01);
    EXPECT_TRUE(stands(mover));
    EXPECT_NEAR(static_cast<double>(mover.v.x), 0, 1e-3);
}

/// Gates that are not quite parallel meet far away: it is not shot out of their wedge.
TEST(MoverOnMovingGround, is_not_shot_out_of_a_wedge) {
    for (const double tilt : {1e-6, 1e-4, 2e-3, 0.02}) {
        auto& world = empty_world<Street>();
        (void)add_plane(world);
        (void)add_box(world, {1, 3, 2}, {3, 0, 2});
        const BodyId gate = add_box(world, {1, 3, 2}, {-3, 0, 2}, pitched(tilt), true);
        Mover mover = standing_at(world, 0, 0, 0);
        const scalar h = scalar(1) / 60;
        ASSERT_EQ(world.set_velocity(gate, {2, 0, 0}), Status::ok);
        for (int i = 0; i < 110; ++i) {
            const V from = exact(mover.r);
            (void)ingot::step(world, h);
            ASSERT_EQ(world.move(mover, {}, h), Status::ok);
            EXPECT_LT((exact(mover.r) - from).norm(), 1.5) << tilt << " " << i;
        }
    }
}

TEST(MoverOnMovingGround, goes_with_a_belt) {
    auto& world = empty_world<Belts>();
    const BodyId belt = add_box(world, {8, 2, 0.5}, {0, 0, -0.5});
    ASSERT_EQ(world.set_surface_velocity(belt, {scalar(1.5), 0, 0}), Status::ok);
    Mover mover = standing_at(world, -4, 0, 0);
    const Vector from = mover.r;
    for (int i = 0; i < 120; ++i) ASSERT_EQ(world.move(mover, {{0, scalar(0.5), 0}, 0}, scalar(1) / 60), Status::ok);
    EXPECT_NEAR(static_cast<double>(mover.r.x - from.x), 3, 1e-4);
    EXPECT_NEAR(static_cast<double>(mover.r.y - from.y), 1, 1e-4);
    EXPECT_NEAR(static_cast<double>(mover.v.x), 1.5, 1e-4);
    EXPECT_NEAR(static_cast<double>(mover.ground.v.x), 1.5, 1e-4);
}

/// No more than force_max h to what is in the way, and no more than it takes.
TEST(MoverPushes, bodies_as_hard_as_it_may) {
    for (const double mass : {1.0, 400.0}) {
        auto& world = empty_world<Street>();
        (void)add_plane(world);
        BodyDef def;
        def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, {scalar(0.5), scalar(0.5), scalar(0.5)}), static_cast<scalar>(mass))).value;
        def.shape = ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}};
        def.friction = 0;
        def.state = ingot::body_state(def.mass, {{2, 0, scalar(0.5)}});
        const BodyId crate = world.add(def).value;
        Mover mover = standing_at(world, 0, 0, 0);
        mover.force_max = 50;
        const scalar h = scalar(1) / 60;
        double last = 0;
        for (int i = 0; i < 120; ++i) {
            (void)ingot::step(world, h);
            ASSERT_EQ(world.move(mover, {{2, 0, 0}, 0}, h), Status::ok);
            const double v = static_cast<double>(world.state(crate).value.v_CM.x);
            EXPECT_LE(mass * (v - last), 50.0 / 60 * 1.01) << i;
            EXPECT_LE(v, 2.02);
            last = v;
        }
        EXPECT_GT(last, mass > 10 ? 0.05 : 1.8);
        const V r = exact(world.state(crate).value.r_CM), half = V::Constant(0.5);
        EXPECT_GT(gap_to(mover, Block{r - half, r + half}), -1e-3);
    }
}

/// Through a door that is 50 mm higher than the mover, over a sill, and up three steps below a lintel that leaves no room for a whole step.
TEST(MoverOnCourse, goes_through_a_low_door_over_its_sill) {
    for (const bool as_mesh : {false, true})
        for (const double speed : {1.0, 4.0}) {
            const double sill = 0.125;
            std::vector<Block> blocks = {{{-4, -3, -1}, {12, 3, 0}}, {{3, -3, 0}, {3.5, -0.5, 3}}, {{3, 0.5, 0}, {3.5, 3, 3}},
                                         {{3, -0.5, 0}, {3.5, 0.5, sill}}, {{3, -0.5, sill + 1.875}, {3.5, 0.5, 3}}};
            auto& world = empty_world<Street>();
            level_tool::MeshData mesh;
            if (as_mesh)
                add_as_mesh(world, blocks, mesh);
            else
                add_as_boxes(world, blocks);
            const Walked walked = walk(world, standing_at(world, 0, 0.05, 0), blocks, speed, 6, scalar(1) / 60);
            EXPECT_NEAR(walked.highest, sill, 2e-3) << speed;
            EXPECT_LT(walked.seconds, 6 / speed * 1.01 + 1.0 / 60) << speed;
            EXPECT_EQ(walked.in_air, 0);
            EXPECT_GT(walked.least_gap, 0);
        }
}

/// A ramp whose foot and top lie on floors: as fast as on the flat over both joints.
TEST(MoverOnCourse, does_not_slow_down_where_ramps_begin_and_end) {
    for (const double degrees : {10.0, 30.0, 45.0})
        for (const scalar rate : {scalar(30), scalar(240)}) {
            const double angle = degrees * pi / 180, high = 4 * std::tan(angle);
            auto& world = empty_world<Street>();
            (void)add_plane(world);
            const V along(std::cos(angle), 0, std::sin(angle)), n(-std::sin(angle), 0, std::cos(angle));
            const double half = 2 / std::cos(angle);
            (void)add_box(world, {half, 2, 1}, V(3, 0, 0) + along * half - n, pitched(-angle));
            (void)add_box(world, {2, 2, high / 2}, {9, 0, high / 2});
            const Walked walked = walk(world, standing_at(world, 0, 0, 0), {}, 4, 10, 1 / rate);
            EXPECT_NEAR(walked.highest, high, 2e-3) << degrees;
            EXPECT_LT(walked.seconds, 2.5 * 1.01 + 1 / static_cast<double>(rate)) << degrees << " " << rate;
            EXPECT_EQ(walked.in_air, 0) << degrees << " " << rate;
        }
}

/// A step is as high as it says, on a box and on a mesh.
TEST(MoverOnCourse, steps_on_what_is_no_higher_than_its_step) {
    for (const bool as_mesh : {false, true})
        for (const double height : {0.34, 0.37}) {
            const std::vector<Block> blocks = {{{-4, -3, -1}, {12, 3, 0}}, {{2, -3, 0}, {6, 3, on_lattice(height)}}};
            auto& world = empty_world<Street>();
            level_tool::MeshData mesh;
            if (as_mesh)
                add_as_mesh(world, blocks, mesh);
            else
                add_as_boxes(world, blocks);
            const Walked walked = walk(world, standing_at(world, 0, 0, 0), blocks, 2, 4, scalar(1) / 60);
            EXPECT_NEAR(walked.highest, height < 0.35 ? on_lattice(height) : 0, 2e-3) << height << (as_mesh ? " mesh" : " box");
        }
}

/// Hills, as a field of heights and as a mesh: as fast as on the flat, never off the ground, never in it.
TEST(MoverOnHills, is_as_fast_as_on_the_flat) {
    constexpr int n = 24, cell = 1024;
    for (const bool as_mesh : {false, true})
        for (int draw = 0; draw < (INGOT_TEST_BRIEF ? 2 : 40); ++draw) {
            level_test::Random random(static_cast<uint64_t>(draw));
            std::vector<uint16_t> heights((n + 1) * (n + 1));
            for (uint16_t& height : heights) height = static_cast<uint16_t>(random() % 700);  // m / 1024: up to 44 degrees
            const auto height_at = [&](int column, int row) { return heights[static_cast<size_t>(row * (n + 1) + column)]; };
            auto& world = empty_world<Street>();
            level_tool::MeshData mesh;
            const auto field = ingot::height_field_of<n + 1, n + 1, (n + 1) * (n + 1)>(
                *reinterpret_cast<const uint16_t(*)[(n + 1) * (n + 1)]>(heights.data()), 1, 1, scalar(1) / 1024);
            ASSERT_TRUE(field.ok());
            if (as_mesh) {
                mesh = level_test::built(level_test::terrain(random, n, cell, height_at));
                Street::levels[0] = mesh.view;
            } else {
                Street::levels[0] = field.value.view();
            }
            ASSERT_TRUE(world.add_level({}).ok());
            for (const double speed : {1.0, 6.0}) {
                Mover mover = standing_at(world, 12, 12, 0.7);
                const double angle = within(random, 0, 2 * pi);
                const MoverInput input = {{static_cast<scalar>(speed * std::cos(angle)), static_cast<scalar>(speed * std::sin(angle)), 0}, 0};
                const V from = exact(mover.r);
                const int steps = static_cast<int>(9 / speed * 60);
                double deepest = 1;
                for (int i = 0; i < steps; ++i) {
                    ASSERT_EQ(world.move(mover, input, scalar(1) / 60), Status::ok);
                    ASSERT_TRUE(stands(mover)) << draw << " " << i;
                    ingot::MoverPlane planes[ingot::movers::planes_max];
                    const int count = world.collide_mover(mover, planes).value;
                    for (int k = 0; k < count; ++k) deepest = std::min(deepest, static_cast<double>(planes[k].gap) + 0.01);
                }
                const V by = exact(mover.r) - from, wanted = exact(input.v) * (steps / 60.0);
                EXPECT_LT((by - wanted).head(2).norm(), 0.01 * wanted.norm()) << draw << " at " << speed << (as_mesh ? " mesh" : " field");
                EXPECT_GT(deepest, 0) << draw << " at " << speed << (as_mesh ? " mesh" : " field");
            }
        }
}

/// A gate that closes pushes it aside, against another it overlaps as little as there is to be, and leaves it when it opens.
TEST(MoverOnMovingGround, is_pushed_by_what_moves_and_survives_what_closes) {
    auto& world = empty_world<Street>();
    (void)add_plane(world);
    (void)add_box(world, {1, 3, 2}, {3, 0, 2});
    const BodyId gate = add_box(world, {1, 3, 2}, {-3, 0, 2}, ingot::identity_matrix<scalar>(), true);
    Mover mover = standing_at(world, 0, 0, 0);
    const scalar h = scalar(1) / 60;
    ASSERT_EQ(world.set_velocity(gate, {2, 0, 0}), Status::ok);
    for (int i = 0; i < 160; ++i) {
        if (i == 100) {
            ASSERT_EQ(world.set_velocity(gate, {-2, 0, 0}), Status::ok);
        }
        (void)ingot::step(world, h);
        ASSERT_EQ(world.move(mover, {}, h), Status::ok);
        const double to_gate = static_cast<double>(mover.r.x - world.state(gate).value.r_CM.x) - 1.3;
        const double to_wall = 2 - static_cast<double>(mover.r.x) - 0.3;
        if (to_gate + to_wall > 0.03) {
            EXPECT_GT(std::min(to_gate, to_wall), 0) << i;
        } else {
            EXPECT_NEAR(to_gate, to_wall, 2e-3) << i << ": as deep in one as in the other";
        }
        EXPECT_LT(std::abs(static_cast<double>(mover.r.y)), 1e-3);
        EXPECT_LT(std::abs(static_cast<double>(mover.r.z) - 0.91), 1e-3);
    }
}

/// Along a circle of this radius until it has turned by `end`, and back.
struct Circled {
    double highest = 0;
    int moves = 0, in_air = 0;
};
Circled circle(World<Street>& world, double radius, double end, double speed, scalar rate) {
    Mover mover = standing_at(world, radius, -0.3, 0);
    Circled done;
    double angle = std::atan2(-0.3, radius);
    for (const double way : {1.0, -1.0})
        for (int i = 0; i < 3000 && (way > 0 ? angle < end : angle > -0.2); ++i, ++done.moves) {
            const V r = exact(mover.r);
            const double far = std::hypot(r.x(), r.y());
            const V out = V(r.x(), r.y(), 0) / far, v = V(-out.y(), out.x(), 0) * (way * speed) + out * (radius - far) * 5;
            EXPECT_EQ(world.move(mover, {rounded(v), 0}, 1 / rate), Status::ok);
            const V now = exact(mover.r);
            angle += std::atan2(r.x() * now.y() - r.y() * now.x(), r.x() * now.x() + r.y() * now.y());
            done.highest = std::max(done.highest, now.z() - 0.91);
            done.in_air += stands(mover) ? 0 : 1;
        }
    return done;
}

/// Up a spiral of boxes about a column, 20 steps of 17 cm in a turn and a quarter, and down again.
TEST(MoverOnCourse, climbs_a_spiral) {
    constexpr int steps = 20;
    const double turn = 2 * pi / 16, radius = 1.1, rise = 0.17;
    for (const double speed : {1.0, 2.5, 5.0})
        for (const scalar rate : {scalar(30), scalar(120)}) {
            auto& world = empty_world<Street>();
            (void)add_plane(world);
            const Circled flat = circle(world, radius, steps * turn - 0.1, speed, rate);
            (void)add_box(world, {0.3, 0.3, 4}, {0, 0, 4});
            for (int i = 1; i <= steps; ++i) {
                const V out(std::cos(i * turn), std::sin(i * turn), 0), along(-out.y(), out.x(), 0);
                const Matrix A = ingot::nearest_rotation({rounded(out), rounded(along), {0, 0, 1}});
                (void)add_box(world, {0.75, 0.38, 0.05}, out * radius + V(0, 0, rise * i - 0.05), A);
            }
            const Circled walked = circle(world, radius, steps * turn - 0.1, speed, rate);
            EXPECT_NEAR(walked.highest, rise * steps, 2e-3) << speed << " m/s " << rate << " Hz";
            EXPECT_LE(walked.moves, flat.moves * 1.01 + 1) << speed << " m/s " << rate << " Hz";
            EXPECT_EQ(walked.in_air, 0) << speed << " m/s " << rate << " Hz";
        }
}

/// Whatever is up: a floor, a step, a wall.
TEST(MoverOnCourse, goes_alike_whatever_is_up) {
    const V ups[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, V(1, 2, -3).normalized()};
    for (const V& up : ups) {
        const V along = (std::abs(up.x()) < 0.9 ? V::UnitX() : V::UnitY()).cross(up).normalized(), across = up.cross(along);
        auto& world = empty_world<Street>();
        ASSERT_EQ(world.set_gravity(rounded(up * -9.81)), Status::ok);
        (void)add_plane(world, rounded(up));
        const Matrix A = ingot::nearest_rotation({rounded(along), rounded(across), rounded(up)});
        (void)add_box(world, {4, 4, 0.125}, along * 6 + up * 0.125, A);
        (void)add_box(world, {4, 0.5, 2}, along * 6 + across * 1.5 + up * 2, A);
        Mover mover;
        mover.up = rounded(up);
        mover.r = rounded(up * 0.95);
        const MoverInput input = {rounded(along * 3 + across * 1), 0};
        for (int i = 0; i < 30; ++i) ASSERT_EQ(world.move(mover, {}, scalar(1) / 60), Status::ok);
        const V from = exact(mover.r);
        for (int i = 0; i < 120; ++i) {
            ASSERT_EQ(world.move(mover, input, scalar(1) / 60), Status::ok);
            ASSERT_TRUE(stands(mover)) << up.transpose() << " at " << i;
        }
        const V by = exact(mover.r) - from;
        EXPECT_NEAR(by.dot(along), 6, 6e-3) << up.transpose();
        EXPECT_NEAR(by.dot(across), 1 - 0.3 - 0.01, 1e-3) << up.transpose();
        EXPECT_NEAR(by.dot(up), 0.25, 1e-3) << up.transpose();
    }
}

/// On a ridge it stands on the faces that meet there: on one of two roofs of 40 degrees, and on none of 60.
TEST(MoverOnSlope, of_a_ridge_is_that_of_its_faces) {
    for (const double degrees : {40.0, 60.0}) {
        const int high = static_cast<int>(std::lround(2048 * std::tan(degrees * pi / 180)));
        level_test::Soup soup;
        for (const int y : {0, 8192})
            for (const int x : {0, 2048, 4096}) soup.points.push_back(level_test::lattice_point(x, y, x == 2048 ? high : 0));
        soup.faces = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
        const level_tool::MeshData mesh = level_test::built(soup);
        auto& world = empty_world<Street>();
        (void)add_plane(world);
        Street::levels[0] = mesh.view;
        ASSERT_TRUE(world.add_level({}).ok());
        Mover mover;
        mover.r = rounded(V(2, 4, high / 1024.0 + 0.95));
        for (int i = 0; i < 60; ++i) ASSERT_EQ(world.move(mover, {}, scalar(1) / 60), Status::ok);
        EXPECT_EQ(stands(mover), degrees < 50) << degrees;
        if (degrees < 50) {
            EXPECT_NEAR(static_cast<double>(mover.ground.n.z), std::cos(degrees * pi / 180), 1e-3);
        }
    }
}

/// Bad input leaves mover and world as they were, to the byte.
TEST(MoverRefused, changes_nothing) {
    auto& world = empty_world<Street>();
    (void)add_plane(world);
    const Mover good = standing_at(world, 0, 0, 0);
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN(), h = scalar(1) / 60;
    static World<Street> before;
    const auto refused = [&](const Mover& bad, const MoverInput& input, scalar step) {
        Mover mover;
        std::memcpy(static_cast<void*>(&mover), &bad, sizeof mover);
        std::memcpy(static_cast<void*>(&before), &world, sizeof before);
        const Status status = world.move(mover, input, step);
        EXPECT_EQ(std::memcmp(&mover, &bad, sizeof mover), 0);
        EXPECT_EQ(std::memcmp(&before, &world, sizeof before), 0);
        return status;
    };
    const auto with = [&](auto change) {
        Mover mover;
        std::memcpy(static_cast<void*>(&mover), &good, sizeof mover);
        change(mover);
        ingot::MoverPlane planes[ingot::movers::planes_max];
        const Status status = refused(mover, {}, h);
        EXPECT_EQ(world.collide_mover(mover, planes).status, status);
        EXPECT_EQ(world.cast_mover(mover, {1, 0, 0}).status, status);
        return status;
    };
    EXPECT_EQ(with([&](Mover& m) { m.r.y = nan; }), Status::not_finite);
    EXPECT_EQ(with([&](Mover& m) { m.r.y = scalar(1e10); }), Status::out_of_range);
    EXPECT_EQ(with([&](Mover& m) { m.v.z = nan; }), Status::not_finite);
    for (scalar Vector::*axis : {&Vector::x, &Vector::y, &Vector::z}) {
        EXPECT_EQ(with([&](Mover& m) { m.v.*axis = scalar(1e7); }), Status::out_of_range);
        EXPECT_EQ(with([&](Mover& m) { m.v_drift.*axis = scalar(-1e7); }), Status::out_of_range);
    }
    EXPECT_EQ(with([&](Mover& m) { m.v_drift.x = nan; }), Status::not_finite);
    EXPECT_EQ(with([&](Mover& m) { m.up.x = nan; }), Status::not_finite);
    EXPECT_EQ(with([&](Mover& m) { m.up = {0, 1, 1}; }), Status::bad_direction);
    EXPECT_EQ(with([&](Mover& m) { m.capsule.radius = -1; }), Status::bad_shape);
    EXPECT_EQ(with([&](Mover& m) { m.capsule.half_length = nan; }), Status::not_finite);
    EXPECT_EQ(with([&](Mover& m) { m.skin = 0; }), Status::bad_shape);
    EXPECT_EQ(with([&](Mover& m) { m.skin = 1; }), Status::bad_shape);
    EXPECT_EQ(with([&](Mover& m) { m.skin = ingot::limits::size_min / 2; }), Status::bad_shape);
    EXPECT_EQ(with([&](Mover& m) { m.slope = 2; }), Status::out_of_range);
    EXPECT_EQ(with([&](Mover& m) { m.step = -1; }), Status::out_of_range);
    EXPECT_EQ(with([&](Mover& m) { m.stick = nan; }), Status::not_finite);
    EXPECT_EQ(with([&](Mover& m) { m.stick = -1; }), Status::out_of_range);
    EXPECT_EQ(with([&](Mover& m) { m.force_max = -1; }), Status::out_of_range);
    EXPECT_EQ(with([&](Mover& m) { m.ground.n.x = nan; }), Status::not_finite);
    EXPECT_EQ(with([&](Mover& m) { m.r_in_ground.x = nan; }), Status::not_finite);
    EXPECT_EQ(refused(good, {{nan, 0, 0}, 0}, h), Status::not_finite);
    EXPECT_EQ(refused(good, {{scalar(1e7), 0, 0}, 0}, h), Status::out_of_range);
    EXPECT_EQ(refused(good, {{0, 0, 0}, -1}, h), Status::out_of_range);
    EXPECT_EQ(refused(good, {{0, 0, 0}, nan}, h), Status::not_finite);
    EXPECT_EQ(refused(good, {}, nan), Status::not_finite);
    EXPECT_EQ(refused(good, {}, 0), Status::bad_step);
    EXPECT_EQ(refused(good, {}, 2), Status::bad_step);
    EXPECT_EQ(world.cast_mover(good, {}).status, Status::bad_direction);
}

}  // namespace
