// SPDX-License-Identifier: MIT
#include "stage.h"

using namespace events_stage;

namespace {

struct Filtered : Plain {
    static constexpr bool filters = true;
};

TEST(Filters, two_bodies_touch_when_each_is_of_a_category_that_the_other_meets) {
    for (uint32_t bits = 0; bits < 256; ++bits) {
        const BodyFilter A = {bits & 3, bits >> 2 & 3}, B = {bits >> 4 & 3, bits >> 6};
        World<Filtered> world;
        const BodyId a = world.add(filtered(ball(1, {0, 0, 0}), A.category, A.mask)).value;
        (void)world.add(filtered(ball(1, {scalar(1.5), 0, 0}), B.category, B.mask));
        const StepReport report = ingot::step(world, h);
        EXPECT_TRUE(report.clean());
        const bool wanted = (A.category & B.mask) != 0 && (B.category & A.mask) != 0;
        EXPECT_EQ(report.contacts, wanted ? 1 : 0) << bits;
        EXPECT_EQ(state_of(world, a).r_CM.x < 0, wanted) << "overlap pushes them apart: " << bits;
    }
}

TEST(Filters, who_says_nothing_meets_all) {
    World<Filtered> world;
    const BodyId a = world.add(ball(1, {0, 0, 0})).value;
    EXPECT_EQ(world.filter(a).value.category, 1u);
    EXPECT_EQ(world.filter(a).value.mask, 0xffffffffu);
    (void)world.add(ball(1, {scalar(1.5), 0, 0}));
    EXPECT_EQ(ingot::step(world, h).contacts, 1);
}

TEST(Filters, a_body_that_does_not_meet_the_ground_falls_as_if_there_were_none) {
    World<Filtered> with, without;
    for (World<Filtered>* world : {&with, &without}) (void)world->set_gravity({0, 0, -g});
    (void)with.add(filtered(ground(), 2, 2));
    const BodyDef def = filtered(body(ingot::Box{{1, scalar(0.5), 2}}, {0, 0, 3}, {1, 0, 0}), 1, 1);
    const BodyId in = with.add(def).value, out = without.add(def).value;
    for (int step_i = 0; step_i < 200; ++step_i) {
        EXPECT_TRUE(ingot::step(with, h).clean());
        (void)ingot::step(without, h);
        ASSERT_TRUE(same_motion(with, in, without, out)) << step_i;
    }
    EXPECT_LT(state_of(with, in).r_CM.z, -10);
}

TEST(Filters, a_change_takes_hold_in_the_next_step_and_can_be_taken_back) {
    World<Filtered> world;
    (void)world.set_gravity({0, 0, -g});
    const BodyId floor = world.add(ground()).value;
    const BodyId box = world.add(body(ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}}, {0, 0, scalar(0.5)})).value;
    for (int step_i = 0; step_i < 30; ++step_i) EXPECT_EQ(ingot::step(world, h).contacts, 1);
    ASSERT_GT(state_of(world, box).r_CM.z, scalar(0.499));

    EXPECT_EQ(world.set_filter(box, {2, ~1u}), Status::ok);
    const scalar z_0 = state_of(world, box).r_CM.z, v_0 = state_of(world, box).v_CM.z;
    for (int step_i = 0; step_i < 8; ++step_i) EXPECT_EQ(ingot::step(world, h).contacts, 0);
    const scalar t = 8 * h;  // a parabola, which the step follows but for its roundings
    EXPECT_NEAR(state_of(world, box).r_CM.z, z_0 + v_0 * t - g * t * t / 2, 8 * ingot::epsilon);

    EXPECT_EQ(world.set_filter(box, ingot::meets_all), Status::ok);
    EXPECT_EQ(ingot::step(world, h).contacts, 1);
    EXPECT_EQ(world.set_filter(floor, {4, 4}), Status::ok);
    EXPECT_EQ(ingot::step(world, h).contacts, 0);
}

TEST(Filters, refused_calls_change_nothing) {
    static World<Plain> plain, plain_before;
    copy(plain_before, plain);
    EXPECT_EQ(plain.add(filtered(ball(1, {}), 2, ~0u)).status, Status::not_in_scene);
    EXPECT_EQ(plain.add(filtered(ball(1, {}), 1, 1)).status, Status::not_in_scene);
    EXPECT_EQ(plain.add(sensor(ball(1, {}))).status, Status::not_in_scene);
    EXPECT_TRUE(same_bytes(plain, plain_before));

    static World<Filtered> world, before;
    const BodyId gone = world.add(ball(1, {})).value;
    (void)world.remove(gone);
    copy(before, world);
    EXPECT_EQ(world.set_filter(gone, {2, 2}), Status::stale_id);
    EXPECT_EQ(world.set_filter({}, {2, 2}), Status::stale_id);
    EXPECT_EQ(world.filter(gone).status, Status::stale_id);
    EXPECT_TRUE(same_bytes(world, before));
}

struct Named : Plain {
    static constexpr bool filters = false;
};

TEST(Filters, cost_two_words_a_body_where_they_are_named_and_nothing_elsewhere) {
    EXPECT_EQ(sizeof(World<Named>), sizeof(World<Plain>));
    const size_t more = sizeof(World<Filtered>) - sizeof(World<Plain>);
    EXPECT_GE(more, 8u * Plain::max_bodies - alignof(World<Plain>) + 4);
    EXPECT_LE(more, 8u * Plain::max_bodies + alignof(World<Plain>));
}

}  // namespace
