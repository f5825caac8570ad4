// SPDX-License-Identifier: MIT
// Movers that go anywhere: never into anything, the same way in any company, and over a floor of many parts as over one.
#include <gtest/gtest.h>

#include "course.h"

namespace {

using namespace mover_test;

/// Steps at random among blocks at random, walks, jumps and turns; the same draw gives the same way.
template <class S, class Look>
void wander_on(World<S>& world, Mover& mover, uint64_t draw, int steps, bool steps_world, const Look& look) {
    level_test::Random random(draw);
    const scalar unit = S::length_unit;
    Vector v{};
    for (int i = 0; i < steps; ++i) {
        if (random() % 20 == 0)
            v = {static_cast<scalar>(within(random, -4, 4)) * unit, static_cast<scalar>(within(random, -4, 4)) * unit, 0};
        const scalar jump = random() % 50 == 0 && stands(mover) ? 4 * unit : scalar(0);
        if (steps_world) (void)ingot::step(world, scalar(1) / 64);
        EXPECT_EQ(world.move(mover, {v, jump}, scalar(1) / 64), Status::ok);
        look();
    }
}
template <class S>
std::vector<Vector> wander(World<S>& world, uint64_t draw, int steps, bool steps_world) {
    Mover mover = standing_at(world, 0.2, 0.1, 0);
    std::vector<Vector> places;
    wander_on(world, mover, draw, steps, steps_world, [&] { places.push_back(mover.r * (1 / S::length_unit)); });
    return places;
}
std::vector<Block> blocks_about(uint64_t draw) {
    level_test::Random random(draw);
    std::vector<Block> blocks = {{{-12, -12, -1}, {12, 12, 0}}, {{-12, -12, 0}, {-9, 12, 8}}, {{9, -12, 0}, {12, 12, 8}},
                                 {{-9, -12, 0}, {9, -9, 8}},   {{-9, 9, 0}, {9, 12, 8}}};
    for (int i = 0; i < 40; ++i) {
        const V low{on_lattice(within(random, -8, 8)), on_lattice(within(random, -8, 8)), 0};
        const V size{on_lattice(within(random, 0.2, 3)), on_lattice(within(random, 0.2, 3)),
                     on_lattice(about(random, 0.1, 3))};
        if ((low.array() < 1).all() && ((low + size).array() > -1).head(2).all()) continue;  // not where it begins
        blocks.push_back({low, low + size});
    }
    return blocks;
}

TEST(MoverAnywhere, goes_the_same_way_at_twice_the_scale_in_company_and_by_a_tree) {
    for (uint64_t draw = 0; draw < 4; ++draw) {
        const std::vector<Block> blocks = blocks_about(draw);
        const int steps = INGOT_TEST_BRIEF ? 200 : 2000;
        const auto places_in = [&](auto& world, bool in_company) {
            if (in_company) {
                for (int i = 0; i < 5; ++i) (void)add_box(world, {1, 1, 1}, {100 + 3.0 * i, 50, 1});
                BodyDef ball;
                ball.mass = ingot::principal(ingot::solid_sphere(500, scalar(0.3))).value;
                ball.shape = ingot::Sphere{scalar(0.3)};
                ball.state = ingot::body_state(ball.mass, {{100, 50, 4}});
                EXPECT_TRUE(world.add(ball).ok());
            }
            add_as_boxes(world, blocks);
            return wander(world, draw, steps, true);
        };
        const std::vector<Vector> alone = places_in(empty_world<Street>(), false), in_company = places_in(empty_world<Street>(), true),
                                  twofold = places_in(empty_world<Twofold>(), false), by_tree = places_in(empty_world<Planted>(), false);
        for (size_t i = 0; i < alone.size(); ++i) {
            ASSERT_TRUE(same(alone[i], in_company[i])) << "in company " << draw << " " << i;
            ASSERT_TRUE(same(alone[i], by_tree[i])) << "by a tree " << draw << " " << i;
            ASSERT_TRUE(same(alone[i], twofold[i])) << "twice as large " << draw << " " << i;
        }
    }
}


Matrix turned_any_way(level_test::Random& random) {
    V axis{within(random, -1, 1), within(random, -1, 1), within(random, -1, 1)};
    if (axis.norm() < 0.1) axis = V::UnitX();
    const Eigen::Matrix3d A = Eigen::AngleAxisd(within(random, 0, 3), axis.normalized()).toRotationMatrix();
    return ingot::nearest_rotation({rounded(A.col(0)), rounded(A.col(1)), rounded(A.col(2))});
}

/// Blocks at random, some of them tilted any way.
std::vector<Block> village(uint64_t draw, bool tilted) {
    std::vector<Block> blocks = blocks_about(draw);
    level_test::Random random(draw + 1000);
    for (int i = 0; tilted && i < 30; ++i) {
        const Matrix A = turned_any_way(random);
        const V half{about(random, 0.1, 1.5), about(random, 0.1, 1.5), about(random, 0.05, 1)};
        const V r{within(random, -8, 8), within(random, -8, 8), within(random, 0, 2)};
        if (r.head(2).norm() < half.norm() + 1) continue;
        blocks.push_back({-half, half, A, exact(rounded(r))});
    }
    return blocks;
}

TEST(MoverAnywhere, is_never_in_anything) {
    const int draws = INGOT_TEST_BRIEF ? 4 : 500, steps = INGOT_TEST_BRIEF ? 500 : 2000;
    for (int draw = 0; draw < draws; ++draw)
        for (const int kind : {0, 1, 2}) {  // boxes, a mesh, tilted boxes
            const std::vector<Block> blocks = village(static_cast<uint64_t>(draw), kind == 2);
            auto& world = empty_world<Street>();
            level_tool::MeshData mesh;
            if (kind == 1)
                add_as_mesh(world, blocks, mesh);
            else
                add_as_boxes(world, blocks);
            Mover mover = standing_at(world, 0.2, 0.1, 0);
            double least = 1;
            int worst = 0, i = 0;
            wander_on(world, mover, static_cast<uint64_t>(draw), steps, false, [&] {
                const double gap = gap_to(mover, blocks);
                if (gap < least) worst = i;
                least = std::min(least, gap);
                ++i;
            });
            EXPECT_GT(least, -1e-4) << "draw " << draw << " kind " << kind << " step " << worst;
            EXPECT_GT(static_cast<double>(mover.r.z), 0.85);
        }
}

/// With its axis in a box or a ball, below a plane or below hills, whatever is up: it comes out, by no more than it was in.
TEST(MoverAnywhere, comes_out_of_what_it_is_put_into) {
    enum Kind { in_box, in_ball, below_plane, below_hills, kinds };
    for (int draw = 0; draw < (INGOT_TEST_BRIEF ? 120 : 4000); ++draw) {
        level_test::Random random(static_cast<uint64_t>(draw));
        const int kind = draw % kinds;
        auto& world = empty_world<Street>();
        ASSERT_EQ(world.set_gravity({0, 0, 0}), Status::ok);
        Mover mover;
        mover.capsule = {static_cast<scalar>(about(random, 0.1, 0.5)), static_cast<scalar>(about(random, 0.1, 1))};
        mover.up = kind == below_hills ? Vector{0, 0, 1} : turned_any_way(random).c2;
        const double reach = static_cast<double>(mover.capsule.radius + mover.capsule.half_length);
        const V middle{within(random, -5, 5), within(random, -5, 5), within(random, -5, 5)};
        double most = 2 * reach;
        std::vector<Block> blocks;
        std::vector<uint16_t> heights(25 * 25);
        for (uint16_t& height : heights) height = static_cast<uint16_t>(random() % 700);  // m / 1024
        const auto& samples = *reinterpret_cast<const uint16_t(*)[25 * 25]>(heights.data());
        const auto hills = ingot::height_field_of<25, 25, 25 * 25>(samples, 1, 1, scalar(1) / 1024);
        ASSERT_TRUE(hills.ok());
        mover.r = rounded(middle);
        if (kind == in_box) {
            const V half{about(random, 0.2, 3), about(random, 0.2, 3), about(random, 0.2, 3)};
            const V place{half.x() * within(random, -1, 1), half.y() * within(random, -1, 1), half.z() * within(random, -1, 1)};
            blocks.push_back({-half, half, turned_any_way(random), exact(rounded(middle))});
            add_as_boxes(world, blocks);
            mover.r = rounded(middle + exact(blocks[0].A * rounded(place)));
            most += half.minCoeff();
        } else if (kind == in_ball) {
            BodyDef def;
            def.immovable = true;
            def.shape = ingot::Sphere{static_cast<scalar>(about(random, 0.2, 3))};
            def.state.r_CM = rounded(middle + V(0, 0, draw % 8 < 4 ? 0 : 0.1));
            ASSERT_TRUE(world.add(def).ok());
            most += static_cast<double>(def.shape.size.x);
        } else if (kind == below_plane) {
            const Vector n = turned_any_way(random).c2;
            (void)add_plane(world, n, static_cast<scalar>(exact(n).dot(middle) + within(random, 0, 1)));
            most += 1;
        } else {
            Street::levels[0] = hills.value.view();
            ASSERT_TRUE(world.add_level({}).ok());
            mover.r = rounded(V(within(random, 8, 16), within(random, 8, 16), within(random, -1, 1)));
            most += 2;
        }
        const Vector from = mover.r;
        const auto least_gap = [&] {
            ingot::MoverPlane planes[ingot::movers::planes_max];
            const auto count = world.collide_mover(mover, planes);
            EXPECT_TRUE(count.ok());
            scalar least = 0;
            for (int k = 0; k < count.value; ++k) least = std::min(least, planes[k].gap);
            return least;
        };
        for (int i = 0; i < 60 && least_gap() < -mover.skin / 64; ++i) ASSERT_EQ(world.move(mover, {}, scalar(1) / 60), Status::ok);
        EXPECT_GT(least_gap(), -mover.skin / 64) << draw;
        if (kind == in_box) {
            EXPECT_GT(gap_to(mover, blocks), 0) << draw;
        }
        EXPECT_LT((exact(mover.r) - exact(from)).norm(), most) << draw;
    }
}

/// More than it can hold touches it, much of it equally near: balls about its axis, each with its mirror images, and tiles below an axis that lies.
TEST(MoverAnywhere, is_told_the_same_planes_whoever_came_first) {
    for (int draw = 0; draw < (INGOT_TEST_BRIEF ? 30 : 500); ++draw) {
        level_test::Random random(static_cast<uint64_t>(draw));
        Mover mover;
        mover.up = draw % 2 == 0 ? Vector{0, 0, 1} : Vector{0, 1, 0};
        std::vector<BodyDef> defs;
        const auto put = [&defs](const ingot::Shape& shape, const V& r) {
            BodyDef def;
            def.immovable = true;
            def.shape = shape;
            def.state.r_CM = rounded(r);
            defs.push_back(def);
        };
        for (int i = 0; i < 12; ++i) {
            const double angle = within(random, 0, pi / 2), far = 0.3 + 0.05 + within(random, -0.02, 0.01);
            const V r{far * std::cos(angle), far * std::sin(angle), within(random, 0, 0.6)};
            for (const int side : {0, 1, 2, 3, 4, 5, 6, 7})
                put(ingot::Sphere{scalar(0.05)}, V(side & 1 ? -r.x() : r.x(), side & 2 ? -r.y() : r.y(), side & 4 ? -r.z() : r.z()));
        }
        for (const double x : {-0.25, 0.25})
            for (const double y : {-0.25, 0.25}) put(ingot::Box{{scalar(0.25), scalar(0.25), scalar(0.125)}}, V(x, y, draw % 2 == 0 ? -1.02 : -0.42));
        ingot::MoverPlane first[ingot::movers::planes_max], planes[ingot::movers::planes_max];
        int count = -1;
        for (int order = 0; order < 4; ++order) {
            auto& world = empty_world<Street>();
            for (const BodyDef& def : defs) ASSERT_TRUE(world.add(def).ok());
            const auto told = world.collide_mover(mover, planes);
            ASSERT_TRUE(told.ok());
            if (count < 0) {
                count = told.value;
                std::copy(planes, planes + count, first);
                EXPECT_GE(count, 4) << draw;
            }
            ASSERT_EQ(told.value, count) << draw;
            for (int k = 0; k < count; ++k)
                EXPECT_TRUE(same(planes[k].n, first[k].n) && planes[k].gap == first[k].gap) << draw << " plane " << k << " of " << count;
            std::shuffle(defs.begin(), defs.end(), random);
        }
    }
}

/// A floor of flush tiles of any size, as boxes, as a mesh, and half and half: as on one slab, in any direction.
TEST(MoverOnTiles, goes_as_on_one_slab) {
    for (int draw = 0; draw < (INGOT_TEST_BRIEF ? 3 : 60); ++draw) {
        level_test::Random random(static_cast<uint64_t>(draw));
        std::vector<Block> as_boxes, as_mesh;
        for (double x = -4; x < 4;) {
            const double wide = on_lattice(within(random, 0.3, 2));
            for (double y = -4; y < 4;) {
                const double deep = on_lattice(within(random, 0.3, 2));
                const Block tile = {{x, y, -on_lattice(within(random, 0.1, 1))}, {x + wide, y + deep, 0}};
                (random() % 3 == static_cast<uint64_t>(draw % 3) ? as_mesh : as_boxes).push_back(tile);
                y += deep;
            }
            x += wide;
        }
        auto& world = empty_world<Street>();
        level_tool::MeshData mesh;
        if (!as_mesh.empty()) add_as_mesh(world, as_mesh, mesh);
        add_as_boxes(world, as_boxes);
        for (int way = 0; way < 8; ++way) {
            const V begin{within(random, -1, 1), within(random, -1, 1), 0};
            Mover mover = standing_at(world, begin.x(), begin.y(), 0);
            const double angle = within(random, 0, 2 * pi), speed = about(random, 0.5, 8);
            const MoverInput input = {{static_cast<scalar>(speed * std::cos(angle)), static_cast<scalar>(speed * std::sin(angle)), 0}, 0};
            const V from = exact(mover.r);
            const int steps = static_cast<int>(2.5 / speed * 120);
            for (int i = 0; i < steps; ++i) {
                ASSERT_EQ(world.move(mover, input, scalar(1) / 120), Status::ok);
                ASSERT_TRUE(stands(mover)) << draw;
                ASSERT_NEAR(static_cast<double>(mover.r.z), 0.91, 1e-4) << draw;
            }
            const V by = exact(mover.r) - from, wanted = exact(input.v) * (steps / 120.0);
            EXPECT_LT((by - wanted).head(2).norm(), 1e-4 * wanted.norm()) << draw << " way " << way;
        }
    }
}

}  // namespace
