// SPDX-License-Identifier: MIT
// Where a query reaches exactly as far as what it looks for: the tree has whoever a look at all bodies has, wherever they are and by whichever axis.
#include <cmath>
#include <limits>
#include <memory>

#include "query/field.h"
#include "reference/draws.h"

using namespace query_field;

namespace {

struct ByTree : Field {
    using broad_phase = ingot::QueryTree;
};

scalar next_to(scalar x, int steps) {
    for (; steps > 0; --steps) x = std::nextafter(x, std::numeric_limits<scalar>::max());
    for (; steps < 0; ++steps) x = std::nextafter(x, scalar(0));
    return x;
}

/// Along an axis, a diagonal, or anywhere; near or a kilometre away.
Eigen::Vector3d far_place(RandomInput& random) {
    const double away = std::exp(random.real(0, std::log(1000.0)));
    Eigen::Vector3d way = random.direction();
    if (random.integer(0, 1) == 0) way = Eigen::Vector3d::Unit(random.integer(0, 2)) * (random.integer(0, 1) == 0 ? 1 : -1);
    return way * away + random.vector(1);
}

TEST(ExactReach, is_the_same_by_the_tree_as_without) {
    RandomInput random(81);
    int at_reach = 0, met = 0;
    for (int world_i = 0; world_i < ingot_reference::draws(160); ++world_i) {
        const auto all = std::make_unique<World<Field>>();
        const auto tree = std::make_unique<World<ByTree>>();
        const Eigen::Vector3d middle = far_place(random);
        for (int i = random.integer(20, 80); i > 0; --i) {
            PlacedShape placed = any_placed(random, 5, world_i % 2 == 0 ? 1 : 4);
            placed.r = to_vector(ingot_reference::to_eigen(placed.r) + middle);
            BodyDef def = body_of(placed);
            def.immovable = true;
            ASSERT_TRUE(all->add(def).ok() && tree->add(def).ok());
        }
        ASSERT_TRUE(ingot::step(*all, scalar(1) / 60).clean() && ingot::step(*tree, scalar(1) / 60).clean());  // it plants the tree
        for (int query_i = 0; query_i < 40; ++query_i) {
            const Eigen::Vector3d near_by = middle + random.vector(10), anywhere = far_place(random);
            const Vector from = to_vector(query_i % 2 == 0 ? anywhere : near_by);
            const QueryNearest nearest = all->find_nearest(from, 5000).value;
            ASSERT_TRUE(nearest.found());
            for (int steps = -3; steps <= 3; ++steps) {
                if (!(nearest.distance > 0)) continue;
                const scalar within = next_to(nearest.distance, steps);
                const QueryNearest a = all->find_nearest(from, within).value, b = tree->find_nearest(from, within).value;
                ASSERT_EQ(a.found(), b.found()) << world_i << ", " << query_i << ", " << steps << " steps from " << nearest.distance;
                ASSERT_EQ(a.distance, b.distance);
                at_reach += a.found() ? 1 : 0;
            }
            // A way that ends where the first body is met, or a rounding before or behind it.
            const Vector way = to_vector(Eigen::Vector3d(middle + random.vector(5) - ingot_reference::to_eigen(from)));
            const QueryHit hit = all->cast_ray(from, way).value;
            if (!hit.found() || !(hit.fraction > scalar(0.01))) continue;
            for (int steps = -3; steps <= 3; ++steps) {
                const Vector end = way * next_to(hit.fraction, steps);
                const QueryHit a = all->cast_ray(from, end).value, b = tree->cast_ray(from, end).value;
                ASSERT_EQ(a.found(), b.found()) << world_i << ", " << query_i << ", " << steps;
                ASSERT_EQ(a.fraction, b.fraction);
                met += a.found() ? 1 : 0;
            }
        }
    }
    EXPECT_GT(at_reach, ingot_reference::draws(160) * 40);
    EXPECT_GT(met, ingot_reference::draws(160) * 10);
}

}  // namespace
