// SPDX-License-Identifier: MIT
// What queries refuse, whom they leave out, and what they cost.
#include <string.h>

#include <limits>

#include "query/field.h"

using namespace query_field;

namespace {

constexpr scalar nan_value = std::numeric_limits<scalar>::quiet_NaN(), infinity = std::numeric_limits<scalar>::infinity();

PlacedShape ball_at(const Vector& r, scalar radius = 1) { return {ingot::Sphere{radius}, r, ingot::identity_matrix<scalar>(), nullptr}; }

TEST(QueryDoor, refuses_bad_input_and_changes_nothing) {
    static World<Field> world, before;
    const BodyId id = world.add(body_of(ball_at({5, 0, 0}))).value, gone = world.add(body_of(ball_at({9, 0, 0}))).value;
    (void)world.remove(gone);
    memcpy(static_cast<void*>(&before), static_cast<const void*>(&world), sizeof world);
    const scalar far = ingot::limits::position_max * scalar(1.5);

    const auto ray = [&](const Vector& from, const Vector& way) {
        const Result<QueryHit> hit = world.cast_ray(from, way);
        EXPECT_EQ(hit.value.body, BodyId{});
        return hit.status;
    };
    EXPECT_EQ(ray({nan_value, 0, 0}, {1, 0, 0}), Status::not_finite);
    EXPECT_EQ(ray({0, 0, 0}, {infinity, 0, 0}), Status::not_finite);
    EXPECT_EQ(ray({0, far, 0}, {1, 0, 0}), Status::out_of_range);
    EXPECT_EQ(ray({0, 0, 0}, {0, 0, far}), Status::out_of_range);
    EXPECT_EQ(ray({0, 0, 0}, {0, 0, 0}), Status::bad_direction);
    EXPECT_EQ(ray({0, 0, 0}, {ingot::limits::size_min / 2, 0, 0}), Status::bad_direction);

    PlacedShape none = ball_at({}), half_space = none, hull = none, thin = none, lost = none, skew = none, away = none, endless = none;
    none.shape = {};
    half_space.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    hull.shape = ingot::Hull{1};
    thin.shape = ingot::Sphere{0};
    lost.r.x = nan_value;
    skew.A.c0 = {2, 0, 0};
    away.r.z = far;
    endless.shape = ingot::Box{{1, infinity, 1}};
    const struct {
        const PlacedShape& shape;
        Status status;
    } shapes[] = {{none, Status::bad_shape}, {half_space, Status::bad_shape}, {hull, Status::bad_shape}, {thin, Status::bad_shape},
                  {lost, Status::not_finite}, {skew, Status::not_a_rotation}, {away, Status::out_of_range}, {endless, Status::not_finite}};
    BodyId found[2] = {};
    for (const auto& [shape, status] : shapes) {
        EXPECT_EQ(world.cast_shape(shape, {1, 0, 0}).status, status);
        EXPECT_EQ(world.find_overlaps(shape, found, 2).status, status);
    }
    EXPECT_EQ(world.cast_shape(ball_at({}), {0, 0, 0}).status, Status::bad_direction);
    EXPECT_EQ(world.cast_shape(ball_at({}), {nan_value, 0, 0}).status, Status::not_finite);
    EXPECT_EQ(world.find_overlaps(ball_at({}), found, -1).status, Status::out_of_range);
    EXPECT_EQ(world.find_nearest({nan_value, 0, 0}, 1).status, Status::not_finite);
    EXPECT_EQ(world.find_nearest({0, far, 0}, 1).status, Status::out_of_range);
    EXPECT_EQ(world.find_nearest({}, nan_value).status, Status::not_finite);
    EXPECT_EQ(world.find_nearest({}, -1).status, Status::out_of_range);
    EXPECT_EQ(world.find_nearest({}, far).status, Status::out_of_range);

    for (const BodyId stale : {gone, BodyId{7, 0, 1}}) {
        QueryFilter filter;
        filter.except = stale;
        EXPECT_EQ(world.cast_ray({}, {1, 0, 0}, filter).status, Status::stale_id);
        EXPECT_EQ(world.cast_shape(ball_at({}), {1, 0, 0}, filter).status, Status::stale_id);
        EXPECT_EQ(world.find_overlaps(ball_at({}), found, 2, filter).status, Status::stale_id);
        EXPECT_EQ(world.find_nearest({}, 1, filter).status, Status::stale_id);
    }
    QueryFilter foreign;
    foreign.except = {id.slot, 9, id.generation};
    EXPECT_EQ(world.cast_ray({}, {1, 0, 0}, foreign).status, Status::foreign_id);
    EXPECT_EQ(found[0], BodyId{});
    EXPECT_EQ(memcmp(static_cast<const void*>(&world), static_cast<const void*>(&before), sizeof world), 0);
}

/// Five things in a row, asked for by every query: which of them does it see?
struct Row {
    World<Field> world{};
    BodyId ids[5];
    Row() {
        for (int i = 0; i < 5; ++i) {
            BodyDef def = body_of(ball_at({static_cast<scalar>(4 * i), 0, 0}));
            def.filter = {1u << i, i == 3 ? 0x10u : 0xffffffffu};
            def.sensor = i == 1;
            ids[i] = world.add(def).value;
        }
    }
    unsigned seen(const QueryFilter& filter) const {
        unsigned rays = 0, casts = 0, nearest = 0, overlaps = 0;
        for (int i = 0; i < 5; ++i) {
            const Vector above = {static_cast<scalar>(4 * i), 0, 3}, beside = {static_cast<scalar>(4 * i), 0, scalar(1.25)};
            const unsigned bit = 1u << i;
            rays |= world.cast_ray(above, {0, 0, -6}, filter).value.body == ids[i] ? bit : 0;
            casts |= world.cast_shape(ball_at(above, scalar(0.5)), {0, 0, -6}, filter).value.body == ids[i] ? bit : 0;
            nearest |= world.find_nearest(beside, scalar(0.5), filter).value.body == ids[i] ? bit : 0;
        }
        BodyId found[5];
        const PlacedShape all = {ingot::Box{{20, 1, 1}}, {8, 0, 0}, ingot::identity_matrix<scalar>(), nullptr};
        const int count = world.find_overlaps(all, found, 5, filter).value;
        for (int i = 0; i < 5; ++i)
            for (int k = 0; k < count; ++k) overlaps |= found[k] == ids[i] ? 1u << i : 0;
        EXPECT_EQ(rays, casts);
        EXPECT_EQ(rays, nearest);
        EXPECT_EQ(rays, overlaps);
        return rays;
    }
};

TEST(QueryFilter, says_which_bodies_count) {
    const Row row;
    QueryFilter filter;
    EXPECT_EQ(row.seen(filter), 0x1du) << "all but the sensor";
    filter.sensors = true;
    EXPECT_EQ(row.seen(filter), 0x1fu);
    filter.except = row.ids[2];
    EXPECT_EQ(row.seen(filter), 0x1bu);
    filter.filter.mask = 0x7;
    EXPECT_EQ(row.seen(filter), 0x03u);
    filter = {};
    filter.filter.category = 0x1;
    EXPECT_EQ(row.seen(filter), 0x15u) << "body 3 meets only the fifth category";
    filter.filter = {0x10, 0x8};
    EXPECT_EQ(row.seen(filter), 0x08u);
    filter.filter = {0, ~0u};
    EXPECT_EQ(row.seen(filter), 0u);
}

/// Impacts without friction: a scene of another kind, with queries all the same.
struct Impacts : ingot::Scene {
    static constexpr int max_bodies = 5;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 8;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};

TEST(Queries, are_of_every_scene_that_has_shapes) {
    World<Impacts> world;
    const BodyId ground = world.add(body_of({ingot::HalfSpace{{0, 0, 1}, 0}, {}, ingot::identity_matrix<scalar>(), nullptr})).value;
    const BodyId box = world.add(body_of({ingot::Box{{1, 2, scalar(0.5)}}, {0, 0, 3}, ingot::identity_matrix<scalar>(), nullptr})).value;
    const QueryHit down = world.cast_ray({scalar(0.5), 1, 8}, {0, 0, -16}).value;
    EXPECT_EQ(down.body, box);
    EXPECT_EQ(down.fraction, scalar(4.5) / 16);
    EXPECT_EQ(down.P.z, scalar(3.5));
    EXPECT_EQ(down.n.z, 1);
    QueryFilter past_the_box;
    past_the_box.except = box;
    EXPECT_EQ(world.cast_ray({scalar(0.5), 1, 8}, {0, 0, -16}, past_the_box).value.body, ground);
    EXPECT_EQ(world.cast_ray({scalar(0.5), 1, 8}, {0, 0, -16}, past_the_box).value.fraction, scalar(0.5));
    EXPECT_EQ(world.find_nearest({0, 0, 1}, 10).value.body, ground);
    EXPECT_EQ(world.find_nearest({0, 0, 2}, 10).value.distance, scalar(0.5));
    EXPECT_EQ(world.find_nearest({0, 0, 2}, 10).value.body, box);

    // Bodies are where they are now, whether a step was taken or not.
    ingot::BodyState state = world.state(box).value;
    state.r_CM.x = 50;
    EXPECT_EQ(world.set_state(box, state), Status::ok);
    EXPECT_EQ(world.cast_ray({scalar(0.5), 1, 8}, {0, 0, -16}).value.body, ground);
    EXPECT_EQ(world.cast_ray({scalar(50.5), 1, 8}, {0, 0, -16}).value.body, box);
}

TEST(Queries, of_an_empty_world_find_nothing) {
    const World<Impacts> world;
    BodyId found[1];
    EXPECT_FALSE(world.cast_ray({}, {1, 2, 3}).value.found());
    EXPECT_EQ(world.cast_ray({}, {1, 2, 3}).value.P.z, 3);
    EXPECT_FALSE(world.cast_shape(ball_at({}), {1, 2, 3}).value.found());
    EXPECT_EQ(world.find_overlaps(ball_at({}), found, 1).value, 0);
    EXPECT_FALSE(world.find_nearest({}, 1).value.found());
    EXPECT_EQ(world.cast_ray({}, {1, 2, 3}).value.shape, 0) << "of nobody, the first";
    EXPECT_EQ(world.cast_ray({}, {1, 2, 3}).value.fraction, 1);
    EXPECT_EQ(world.cast_shape(ball_at({}), {1, 2, 3}).value.shape, 0);
    EXPECT_EQ(world.find_nearest({}, 1).value.shape, 0);
}

}  // namespace
