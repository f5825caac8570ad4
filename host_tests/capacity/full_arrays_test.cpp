// SPDX-License-Identifier: MIT
// A full array keeps what matters most, says what it dropped, and writes nothing past its end.
#include "capacity/yard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace {

using namespace yard;

constexpr int ball_count = 20;

template <int contacts>
struct Pit : ingot::Scene {
    static constexpr int max_bodies = ball_count + 3;
    static constexpr bool translates = true;
    static constexpr int max_contacts = contacts;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
constexpr int plenty = 400;

/// Balls in the ground, far apart, the i-th of `order` by (i + 1)/64, and a box that stands askew in it.
template <class S>
void fill_pit(World<S>& world, const std::vector<int>& order) {
    (void)world.add(ground());
    for (const int ball_i : order) {
        const scalar depth = static_cast<scalar>(ball_i + 1) / 64;
        (void)world.add(plain_body({static_cast<scalar>(4 * ball_i), 0, 1 - depth}, ingot::Sphere{1}));
    }
    BodyDef box = plain_body({0, 50, scalar(0.25)}, ingot::Box{{1, 1, 1}});
    box.state.A = ingot::rotation_about({scalar(0.6), 0, scalar(0.8)}, scalar(0.3)).value;
    (void)world.add(box);
}

std::vector<int> forwards() {
    std::vector<int> order(ball_count);
    for (int ball_i = 0; ball_i < ball_count; ++ball_i) order[static_cast<size_t>(ball_i)] = ball_i;
    return order;
}
std::vector<int> backwards() {
    std::vector<int> order = forwards();
    std::reverse(order.begin(), order.end());
    return order;
}
std::vector<int> mixed() {
    std::vector<int> order = forwards();
    for (size_t ball_i = 0; ball_i < order.size(); ++ball_i) std::swap(order[ball_i], order[ball_i * 7 % order.size()]);
    return order;
}

template <class S>
std::vector<scalar> sorted_separations(const World<S>& world) {
    std::vector<scalar> depths;
    for (int contact_i = 0; contact_i < world.contact_count(); ++contact_i) depths.push_back(world.contact(contact_i).value.separation);
    std::sort(depths.begin(), depths.end());
    return depths;
}

template <int capacity>
void expect_deepest_kept(const std::vector<int>& order) {
    static World<Pit<plenty>> roomy;
    static World<Pit<capacity>> tight, twin;
    clear(roomy);
    clear(tight);
    fill_pit(roomy, order);
    fill_pit(tight, order);
    copy(twin, tight);

    const StepReport of_roomy = ingot::step(roomy, h);
    ASSERT_EQ(of_roomy.contacts_lost, 0);
    ASSERT_GE(of_roomy.contacts, ball_count + 4);
    const StepReport report = ingot::step(tight, h);
    EXPECT_EQ(report.contacts, capacity);
    EXPECT_EQ(tight.contact_count(), capacity);
    EXPECT_EQ(report.contacts_lost, of_roomy.contacts - capacity) << "what is dropped is counted";
    EXPECT_FALSE(report.clean());
    EXPECT_EQ(report.status, Status::ok) << "the step is taken all the same";

    std::vector<scalar> deepest = sorted_separations(roomy);
    deepest.resize(capacity);
    EXPECT_EQ(sorted_separations(tight), deepest);

    const StepReport of_twin = ingot::step(twin, h);
    EXPECT_EQ(of_twin.contacts_lost, report.contacts_lost);
    EXPECT_TRUE(same_bytes(twin, tight)) << "the same bodies lose the same contacts";
}

TEST(FullContacts, keep_the_deepest_whatever_their_order) {
    for (const std::vector<int>& order : {forwards(), backwards(), mixed()}) {
        expect_deepest_kept<1>(order);
        expect_deepest_kept<2>(order);
        expect_deepest_kept<7>(order);
        expect_deepest_kept<ball_count>(order);
    }
}

TEST(FullContacts, are_the_same_at_every_step) {
    static World<Pit<5>> world, twin;
    clear(world);
    fill_pit(world, mixed());
    (void)world.set_gravity({0, 0, -10});
    copy(twin, world);
    for (int step_i = 0; step_i < 200; ++step_i) {
        (void)ingot::step(world, h);
        (void)ingot::step(twin, h);
        ASSERT_TRUE(same_bytes(world, twin)) << step_i;
        ASSERT_LE(world.contact_count(), 5);
    }
}

TEST(FullContacts, a_contact_as_deep_as_the_last_kept_does_not_replace_it) {
    static World<Pit<2>> world;
    clear(world);
    (void)world.add(ground());
    for (int ball_i = 0; ball_i < 5; ++ball_i)
        (void)world.add(plain_body({static_cast<scalar>(4 * ball_i), 0, scalar(0.5)}, ingot::Sphere{1}));
    const StepReport report = ingot::step(world, h);
    EXPECT_EQ(report.contacts_lost, 3);
    ASSERT_EQ(world.contact_count(), 2);
    EXPECT_EQ(world.contact(0).value.A.slot, 1) << "first come, first served";
    EXPECT_EQ(world.contact(1).value.A.slot, 2);
}

/// A contact that is kept is a contact: squares of such distances vanish, or have no digits left.
TEST(FullContacts, have_unit_normals_however_near_the_centres_are) {
    static World<Pit<2>> world;
    for (scalar distance = 1; distance > std::numeric_limits<scalar>::min(); distance /= 7) {
        clear(world);
        (void)world.add(plain_body({}, ingot::Sphere{1}));
        (void)world.add(plain_body(Vector{3, -1, 2} * (distance / 4), ingot::Sphere{1}));
        (void)ingot::step(world, h);
        ASSERT_EQ(world.contact_count(), 1) << distance;
        EXPECT_NEAR(ingot::length_sq(world.contact(0).value.n), 1, 8 * ingot::epsilon) << distance;
    }
}

// 65536 lost contacts are not none.

constexpr int heap_count = 363;  // 363 * 362 / 2 = 65703 pairs
struct Heap : ingot::Scene {
    static constexpr int max_bodies = heap_count;
    static constexpr bool translates = true;
    static constexpr int max_contacts = heap_count * (heap_count - 1) / 2 - 65536;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box>;
};

TEST(FullContacts, counts_end_at_their_largest_value_and_do_not_begin_anew) {
    if (INGOT_INDEX_BITS != 16) GTEST_SKIP() << "no test comes to the end of 32 bits";
    static World<Heap> world;
    clear(world);
    for (int ball_i = 0; ball_i < heap_count; ++ball_i) ASSERT_TRUE(world.add(plain_body({}, ingot::Sphere{1})).ok());
    const StepReport report = ingot::step(world, h);
    EXPECT_EQ(report.contacts, Heap::max_contacts);
    EXPECT_EQ(report.contacts_lost, UINT16_MAX);
    EXPECT_FALSE(report.clean());
}

// Beyond the last byte.

template <class S>
struct Fenced {
    static constexpr size_t fence_size = 256;
    unsigned char before[fence_size];
    World<S> world;
    unsigned char after[fence_size];

    void paint() {
        memset(before, 0xa5, sizeof before);
        memset(after, 0x5a, sizeof after);
        clear(world);
    }
    bool intact() const {
        const auto is = [](unsigned char paint) { return [=](unsigned char byte) { return byte == paint; }; };
        return std::all_of(before, before + fence_size, is(0xa5)) && std::all_of(after, after + fence_size, is(0x5a));
    }
};

template <class S>
void fill_past_the_end(Fenced<S>& fenced) {
    World<S>& world = fenced.world;
    std::vector<BodyId> ids;
    (void)world.set_gravity({0, 0, -10});
    fill_pit(world, mixed());
    for (int again = 0; again < 40; ++again) {
        const Result<BodyId> more = world.add(plain_body({static_cast<scalar>(again), 1, 0}, ingot::Box{{2, 2, 2}}));
        if (more.ok()) ids.push_back(more.value);
        ASSERT_TRUE(fenced.intact());
        StepReport report = ingot::step(world, h);
        ASSERT_LE(report.contacts, S::max_contacts);
        ASSERT_TRUE(fenced.intact());
        if (again % 8 == 7 && !ids.empty()) {
            (void)world.remove(ids.back());
            ids.pop_back();
        }
        (void)world.contact(again);
        (void)world.body_at(again);
        (void)world.state({static_cast<ingot::Index>(again), 0, 1});
        ASSERT_TRUE(fenced.intact());
    }
    EXPECT_EQ(world.add(plain_body({})).ok(), world.body_count() <= S::max_bodies && fenced.intact());
}

TEST(FullArrays, the_bytes_beside_a_world_never_change) {
    static Fenced<Pit<1>> one;
    static Fenced<Pit<7>> seven;
    static Fenced<Pit<plenty>> roomy;
    one.paint();
    seven.paint();
    roomy.paint();
    fill_past_the_end(one);
    fill_past_the_end(seven);
    fill_past_the_end(roomy);
}

TEST(FullArrays, a_fence_shows_a_single_byte_written_past_a_world) {
    static Fenced<Pit<1>> fenced;
    fenced.paint();
    EXPECT_TRUE(fenced.intact());
    fenced.after[0] ^= 1;
    EXPECT_FALSE(fenced.intact());
    fenced.paint();
    fenced.before[Fenced<Pit<1>>::fence_size - 1] ^= 1;
    EXPECT_FALSE(fenced.intact());
}

// One body more than a tile holds, and all counts about it.

template <int bodies>
struct Few : ingot::Scene {
    static constexpr int max_bodies = bodies;
    static constexpr bool translates = true;
};

template <int bodies>
void expect_exactly(const char* what) {
    static Fenced<Few<bodies>> fenced;
    fenced.paint();
    World<Few<bodies>>& world = fenced.world;
    std::vector<BodyId> ids;
    for (int body_i = 0; body_i < bodies; ++body_i) {
        const Result<BodyId> id = world.add(plain_body({static_cast<scalar>(body_i), 0, 0}));
        ASSERT_TRUE(id.ok()) << what << body_i;
        EXPECT_EQ(id.value.slot, body_i) << "the lowest free slot";
        ids.push_back(id.value);
    }
    EXPECT_EQ(world.add(plain_body({})).status, Status::no_room);
    EXPECT_EQ(world.body_count(), bodies);
    (void)ingot::step(world, h);
    for (int body_i = 0; body_i < bodies; ++body_i)
        EXPECT_EQ(world.state(ids[static_cast<size_t>(body_i)]).value.r_CM.x, static_cast<scalar>(body_i));
    EXPECT_TRUE(fenced.intact());
}

TEST(FullArrays, a_scene_holds_as_many_bodies_as_it_names) {
    expect_exactly<1>("1");
    expect_exactly<ingot::lanes>("lanes");
    expect_exactly<ingot::lanes + 1>("lanes + 1");
    expect_exactly<3 * ingot::lanes>("3 lanes");
    expect_exactly<17>("17");
}

}  // namespace
