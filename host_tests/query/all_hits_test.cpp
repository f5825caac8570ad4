// SPDX-License-Identifier: MIT
// Casts that tell all that is on their way, against casts at one body alone.
#include <algorithm>

#include "query/twins.h"
#include "reference/brief_types.h"
#include "reference/draws.h"

using namespace query_twins;

namespace {

template <class Search>
using Crowd = Yard<Search, 32, 3, false, false>;

template <class Search>
class AllHits : public ::testing::Test {};
using Searches = ::testing::Types<ingot::AllPairs, ingot::QueryTree>;
TYPED_TEST_SUITE(AllHits, Searches);

/// A query that sees the body of this number alone.
QueryFilter of_one(int i) {
    QueryFilter filter;
    filter.filter = {0xffffffffu, 1u << i};
    filter.sensors = true;
    return filter;
}

void expect_same(const QueryHit& a, const QueryHit& b) {
    EXPECT_EQ(a.body, b.body);
    EXPECT_EQ(a.shape, b.shape);
    EXPECT_EQ(a.fraction, b.fraction);
    EXPECT_EQ(std::memcmp(&a.P, &b.P, sizeof a.P), 0);
    EXPECT_EQ(std::memcmp(&a.n, &b.n, sizeof a.n), 0);
}

/// All of `hits` that there is room for, in order, and how many there are; what is behind the room is left alone.
template <class Ask>
void expect_all(std::vector<QueryHit> hits, int capacity, const Ask& ask) {
    std::stable_sort(hits.begin(), hits.end(), [](const QueryHit& a, const QueryHit& b) { return a.fraction < b.fraction; });
    std::vector<QueryHit> found(static_cast<std::size_t>(capacity) + 1);
    found.back().shape = 77;
    const Result<int> count = ask(found.data(), capacity);
    ASSERT_TRUE(count.ok());
    EXPECT_EQ(count.value, static_cast<int>(hits.size()));
    for (std::size_t i = 0; i < std::min(hits.size(), found.size() - 1); ++i) expect_same(found[i], hits[i]);
    EXPECT_EQ(found.back().shape, 77);
}

TYPED_TEST(AllHits, are_those_of_each_body_alone_in_order) {
    int some = 0;
    for (int draw = 0; draw < ingot_reference::draws(200); ++draw) {
        using S = Crowd<TypeParam>;
        Twins<S, S> drawn(static_cast<std::uint64_t>(4000 + draw), {10, 0.2, 4});
        World<S>& world = *drawn.all;
        for (int i = 0; i < 32; ++i) drawn.add();
        for (std::size_t i = 0; i < drawn.ids.size(); ++i) ASSERT_EQ(world.set_filter(drawn.ids[i], {1u << i, 0xffffffffu}), Status::ok);
        if (draw % 2 == 1) (void)ingot::step(world, scalar(1) / 60);
        QueryFilter all;
        all.sensors = true;
        for (int cast = 0; cast < 20; ++cast) {
            const Vector from = drawn.somewhere(), way = to_vector(drawn.random.vector(30));
            const PlacedShape moving = {drawn.shape(), from, drawn.turn(), nullptr};
            if (moving.shape.kind == ShapeKind::hull) continue;
            std::vector<QueryHit> rays, casts;
            for (std::size_t i = 0; i < drawn.ids.size(); ++i) {
                const QueryHit ray = world.cast_ray(from, way, of_one(static_cast<int>(i))).value;
                const QueryHit hit = world.cast_shape(moving, way, of_one(static_cast<int>(i))).value;
                if (ray.found()) rays.push_back(ray);
                if (hit.found()) casts.push_back(hit);
            }
            some += rays.size() > 1 ? 1 : 0;
            const auto lower = [](const QueryHit& a, const QueryHit& b) { return a.body.slot < b.body.slot; };
            std::sort(rays.begin(), rays.end(), lower);
            std::sort(casts.begin(), casts.end(), lower);
            const int capacity = drawn.random.integer(0, 32);
            expect_all(rays, capacity, [&](QueryHit* found, int room) { return world.cast_ray_all(from, way, found, room, all); });
            expect_all(casts, capacity, [&](QueryHit* found, int room) { return world.cast_shape_all(moving, way, found, room, all); });
            if (::testing::Test::HasFailure()) FAIL() << "draw " << draw << ", cast " << cast;
        }
    }
    EXPECT_GT(some, ingot_reference::draws(200));
}

TYPED_TEST(AllHits, refuse_bad_input) {
    const auto world = std::make_unique<World<Crowd<TypeParam>>>();
    QueryHit found{};
    const PlacedShape ball = {ingot::Sphere{1}, {}, ingot::identity_matrix<scalar>(), nullptr};
    const PlacedShape ground = {ingot::HalfSpace{{0, 0, 1}, 0}, {}, ingot::identity_matrix<scalar>(), nullptr};
    EXPECT_EQ(world->cast_ray_all({}, {1, 0, 0}, &found, -1).status, Status::out_of_range);
    EXPECT_EQ(world->cast_ray_all({}, {0, 0, 0}, &found, 1).status, Status::bad_direction);
    EXPECT_EQ(world->cast_shape_all(ball, {1, 0, 0}, &found, -1).status, Status::out_of_range);
    EXPECT_EQ(world->cast_shape_all(ground, {1, 0, 0}, &found, 1).status, Status::bad_shape);
    QueryFilter stale;
    stale.except = {7, 0, 1};
    EXPECT_EQ(world->cast_ray_all({}, {1, 0, 0}, &found, 1, stale).status, Status::stale_id);
    EXPECT_EQ(world->cast_shape_all(ball, {1, 0, 0}, &found, 1, stale).status, Status::stale_id);
    EXPECT_EQ(world->cast_ray_all({}, {1, 0, 0}, nullptr, 0).value, 0);
    EXPECT_FALSE(found.found());
}

}  // namespace
