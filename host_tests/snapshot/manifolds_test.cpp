// SPDX-License-Identifier: MIT
// Snapshots of worlds with friction: what is kept of contacts goes along, and what no contact can have become is refused.
#include "snapshot/life.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

namespace {

using namespace life;
using Bytes = std::vector<uint8_t>;

struct Pile : ingot::Scene {
    static constexpr int max_bodies = 9;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 24;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
struct SearchedPile : Pile {
    static constexpr bool recycles_manifolds = false;
};
struct StillPile : Pile {
    static constexpr bool bounces = false;
};
struct WatchedPile : Pile {
    static constexpr bool filters = true;
    static constexpr int max_overlaps = 8;
    using broad_phase = ingot::SortedTree;
};

template <class S>
BodyDef crate(const Vector& r_CM) {
    BodyDef def = plain_body(r_CM, ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}});
    def.friction = scalar(0.6);
    if constexpr (S::filters) def.filter = {2, 3};
    return def;
}

/// A stack of three, a ball that leans on it, and, where the scene has them, a sensor round them all.
template <class S>
void fill_pile(World<S>& world) {
    clear(world);
    ASSERT_EQ(world.set_gravity({0, 0, -10}), Status::ok);
    BodyDef floor = ground();
    floor.friction = scalar(0.6);
    ASSERT_TRUE(world.add(floor).ok());
    for (int body_i = 0; body_i < 3; ++body_i) ASSERT_TRUE(world.add(crate<S>({scalar(0.1) * scalar(body_i), 0, scalar(body_i) + scalar(0.5)})).ok());
    BodyDef ball = plain_body({scalar(0.95), 0, scalar(0.5)}, ingot::Sphere{scalar(0.5)});
    ball.state.v_CM = {-1, 0, 0};
    ASSERT_TRUE(world.add(ball).ok());
    if constexpr (ingot::has_sensors<S>) {
        BodyDef sensor = plain_body({0, 0, 1}, ingot::Box{{2, 2, 2}});
        sensor.immovable = sensor.sensor = true;
        ASSERT_TRUE(world.add(sensor).ok());
    }
}

/// A step, and now and then something from outside. The same for every world that is in the same state.
template <class S>
StepReport live_on(World<S>& world, int step_i) {
    if (step_i % 11 == 3) (void)world.apply_impulse(world.body_at(2), {scalar(0.3), scalar(0.2), 0}, world.state(world.body_at(2)).value.r_CM);
    if (step_i % 23 == 7) (void)world.remove(world.body_at(3));
    if (step_i % 23 == 15) (void)world.add(crate<S>({0, 0, 4}));
    return ingot::step(world, step_i % 17 == 5 ? h / 2 : h);
}

template <class S>
class SavedPile : public ::testing::Test {};
using Piles = ::testing::Types<Pile, SearchedPile, WatchedPile>;
TYPED_TEST_SUITE(SavedPile, Piles);

TYPED_TEST(SavedPile, goes_on_from_every_moment_as_if_never_left) {
    using S = TypeParam;
    static World<S> world, restored;
    fill_pile(world);
    int touching = 0;
    for (int moment = 0; moment < 100; ++moment) {
        touching += live_on(world, moment).contacts;
        const Bytes bytes = saved(world);
        ASSERT_FALSE(bytes.empty());
        memset(static_cast<void*>(&restored), 0xa5, sizeof restored);
        ASSERT_EQ(ingot::load_snapshot(restored, bytes.data(), bytes.size()), Status::ok) << "moment " << moment;
        ASSERT_EQ(saved(restored), bytes) << "what was loaded saves as the same bytes";

        static World<S> gone_on;
        copy(gone_on, world);
        for (int step_i = moment + 1; step_i < moment + 40; ++step_i) {
            (void)live_on(gone_on, step_i);
            (void)live_on(restored, step_i);
            ASSERT_EQ(restored.state_hash(), gone_on.state_hash()) << "moment " << moment << " step " << step_i;
            ASSERT_EQ(saved(restored), saved(gone_on)) << "moment " << moment << " step " << step_i;
        }
    }
    EXPECT_GT(touching, 100);
}

/// How far apart a pair may be and still touch is told by what it does now, not by who was in the slot before: that a snapshot does not hold.
TEST(SavedSlot, of_ground_where_a_box_spun_goes_on_as_if_never_left) {
    static World<Pile> world, restored;
    clear(world);
    BodyDef spinning = crate<Pile>({0, 0, 20});
    spinning.state.L = {3, 0, 0};
    const auto before = world.add(spinning);
    ASSERT_TRUE(before.ok());
    (void)ingot::step(world, h);
    ASSERT_EQ(world.remove(before.value), Status::ok);
    const auto floor = world.add(ground());
    ASSERT_TRUE(floor.ok());
    ASSERT_EQ(floor.value.slot, before.value.slot);
    ASSERT_TRUE(world.add(crate<Pile>({0, 0, scalar(0.5)})).ok());

    const Bytes bytes = saved(world);
    ASSERT_EQ(ingot::load_snapshot(restored, bytes.data(), bytes.size()), Status::ok);
    for (int step_i = 0; step_i < 10; ++step_i) {
        EXPECT_EQ(ingot::step(world, h).contacts, 1);
        (void)ingot::step(restored, h);
        ASSERT_EQ(saved(restored), saved(world)) << "step " << step_i;
    }
}

/// Sizes in bytes, written down a second time.
constexpr size_t s = sizeof(scalar), checksum = 8;
constexpr size_t to_B = 2, to_count = 4, to_n = 6, to_points = to_n + 3 * s, point_size = 6 * s + 4;
constexpr size_t to_mu = to_points + 4 * point_size, to_e = to_mu + s, to_j_friction = to_e + s, to_j_reference = to_j_friction + 3 * s;
constexpr size_t to_j_twist = to_j_reference + 3 * s, to_substeps = to_j_twist + s, to_on_A = to_substeps + 2;
constexpr size_t to_separation = to_on_A + 24 * s, to_n_A = to_separation + 4 * s, to_n_B = to_n_A + 3 * s, to_margin = to_n_B + 3 * s;
constexpr size_t manifold_size = to_margin + s;

class DamagedPile : public ::testing::Test {
protected:
    DamagedPile() {
        fill_pile(world_);
        for (int step_i = 0; step_i < 30; ++step_i) (void)ingot::step(world_, h);
        sound_ = saved(world_);
    }

    /// Where the manifolds begin: at the end, each of one size.
    size_t first() const { return sound_.size() - checksum - static_cast<size_t>(pairs()) * manifold_size; }
    /// Pairs that touch: the length of a snapshot is that of one without contacts, and of these.
    int pairs() const {
        static World<Pile> alone;
        copy(alone, world_);
        BodyId ids[Pile::max_bodies];
        for (int slot = 0; slot < Pile::max_bodies; ++slot) ids[slot] = alone.body_at(slot);
        EXPECT_EQ(alone.set_gravity({}), Status::ok);
        for (int slot = 0; slot < 5; ++slot) {
            BodyState state = alone.state(ids[slot]).value;
            state.r_CM = {scalar(100 * slot), 0, slot == 0 ? 0 : scalar(50)};
            state.v_CM = state.L = {};
            EXPECT_EQ(slot == 0 ? Status::ok : alone.set_state(ids[slot], state), Status::ok);
        }
        EXPECT_EQ(ingot::step(alone, h).contacts, 0);
        const size_t without = saved(alone).size();
        EXPECT_EQ((sound_.size() - without) % manifold_size, 0u);
        return static_cast<int>((sound_.size() - without) / manifold_size);
    }

    template <class T>
    Bytes with(size_t offset, T number) const {
        return spoilt(sound_, offset, number);
    }
    template <class T>
    static Bytes spoilt(Bytes bytes, size_t offset, T number) {
        uint64_t bits = 0;
        if constexpr (std::is_floating_point_v<T>) {
            ingot::ScalarBits of_number;
            memcpy(&of_number, &number, sizeof number);
            bits = of_number;
        } else {
            bits = number;
        }
        for (size_t byte_i = 0; byte_i < sizeof number; ++byte_i) bytes[offset + byte_i] = static_cast<uint8_t>(bits >> (8 * byte_i));
        const uint64_t sum = ingot::snapshot_checksum(bytes.data(), bytes.size() - checksum);
        for (size_t byte_i = 0; byte_i < checksum; ++byte_i) bytes[bytes.size() - checksum + byte_i] = static_cast<uint8_t>(sum >> (8 * byte_i));
        return bytes;
    }

    void refuses(const Bytes& bytes, const std::string& what) const {
        static World<Pile> other, before;
        fill_pile(other);
        copy(before, other);
        EXPECT_EQ(ingot::load_snapshot(other, bytes.data(), bytes.size()), Status::bad_snapshot) << what;
        EXPECT_TRUE(same_bytes(other, before)) << what << " changed the world";
    }
    void accepts(const Bytes& bytes, const std::string& what) const {
        static World<Pile> other;
        clear(other);
        EXPECT_EQ(ingot::load_snapshot(other, bytes.data(), bytes.size()), Status::ok) << what;
        EXPECT_EQ(saved(other), bytes) << what;
    }

    static World<Pile> world_;
    Bytes sound_;
};
World<Pile> DamagedPile::world_;

TEST_F(DamagedPile, the_format_is_as_written_down) {
    ASSERT_EQ(pairs(), 5) << "the ground and two, a stack of three, the ball and one of them";
    accepts(sound_, "what was saved");
    const size_t at = first();
    EXPECT_EQ(sound_[at], 0) << "the ground comes first";
    EXPECT_EQ(sound_[at + to_B], 1);
    EXPECT_EQ(sound_[at + to_count], 4) << "a crate stands on four points";
    EXPECT_EQ(sound_[at - 2], 5) << "so many manifolds";
}

TEST_F(DamagedPile, of_numbers_that_are_not_finite) {
    const size_t at = first();
    std::vector<size_t> numbers = {to_n, to_n + s, to_n + 2 * s, to_mu, to_e, to_j_twist, to_margin};
    const auto add = [&numbers](size_t begin, size_t count) {
        for (size_t number_i = 0; number_i < count; ++number_i) numbers.push_back(begin + number_i * s);
    };
    for (size_t point_i = 0; point_i < 4; ++point_i) {
        add(to_points + point_i * point_size, 4);          // P, separation
        add(to_points + point_i * point_size + 4 * s + 4, 2);  // j, j_before
    }
    add(to_j_friction, 6);
    add(to_on_A, 24 + 4 + 6);
    for (size_t number : numbers)
        for (const scalar bad :
             {std::numeric_limits<scalar>::quiet_NaN(), std::numeric_limits<scalar>::infinity(), -std::numeric_limits<scalar>::infinity()})
            refuses(with(at + number, bad), "number at " + std::to_string(number));
}

TEST_F(DamagedPile, of_what_no_contact_can_be) {
    const size_t at = first();
    refuses(with(at + to_count, uint16_t{0}), "a contact without points");
    refuses(with(at + to_count, uint16_t{5}), "five points");
    refuses(with(at + to_n + 2 * s, scalar(1.5)), "a normal that is no unit vector");
    refuses(with(at + to_mu, scalar(-0.5)), "friction below nothing");
    refuses(with(at + to_mu, limits::friction_max * 2), "too much friction");
    refuses(with(at + to_e, scalar(-0.5)), "restitution below nothing");
    refuses(with(at + to_e, scalar(1.5)), "restitution above one");
    refuses(with(at + to_substeps, uint16_t{60000}), "older than is counted");
    refuses(with(at + to_margin, scalar(-1)), "a margin below nothing");
    accepts(with(at + to_mu, limits::friction_max), "the most friction");
    accepts(with(at + to_e, scalar(1)), "restitution of one");
    // Anchors that know nothing are taken, and written as zeros.
    const Bytes unknown = with(at + to_margin, scalar(0));
    static World<Pile> other;
    clear(other);
    EXPECT_EQ(ingot::load_snapshot(other, unknown.data(), unknown.size()), Status::ok);
    const Bytes again = saved(other);
    for (size_t byte_i = to_on_A; byte_i < to_margin + s; ++byte_i) EXPECT_EQ(again[at + byte_i], 0) << "byte " << byte_i;
}

TEST_F(DamagedPile, of_who_touches_whom) {
    const size_t at = first();
    refuses(with(at, uint16_t{1}), "a body that touches itself");
    const size_t last = at + 4 * manifold_size;
    refuses(with(last, static_cast<uint16_t>(sound_[last + to_B] | sound_[last + to_B + 1] << 8)), "a body that touches itself, last of all");
    refuses(with(at, uint16_t{2}), "the later body first");
    refuses(with(at + to_B, uint16_t{Pile::max_bodies}), "a slot that the scene has not");
    refuses(with(at + to_B, uint16_t{5}), "a slot that was never used");
    refuses(with(at + manifold_size + to_B, uint16_t{1}), "the same pair twice");
    refuses(with(at - 2, uint16_t{Pile::max_manifolds + 1}), "more than the scene holds");
    refuses(with(at - 2, uint16_t{4}), "bytes left over");
    refuses(with(at - 2, uint16_t{6}), "bytes that are missing");
}

TEST_F(DamagedPile, of_a_body_in_it) {
    const size_t first_slot = 44 + 4 * s, ground_to_A = 5;
    refuses(with(first_slot + ground_to_A, scalar(2)), "an attitude that is no rotation");
}

/// Of a scene in which bodies bounce, for one in which none does: what does not bounce is the same in both.
TEST_F(DamagedPile, of_what_does_not_bounce) {
    static World<StillPile> still, before;
    fill_pile(still);
    BodyDef ball = plain_body({3, 0, 3}, ingot::Sphere{scalar(0.5)});
    ball.restitution = scalar(0.5);
    copy(before, still);
    EXPECT_EQ(still.add(ball).status, Status::not_in_scene);
    EXPECT_TRUE(same_bytes(still, before));
    EXPECT_EQ(ingot::load_snapshot(still, sound_.data(), sound_.size()), Status::other_scene) << "of a scene that lets bodies bounce";

    ball.restitution = 0;
    ball.friction = scalar(0.123);
    ASSERT_TRUE(still.add(ball).ok());
    const Bytes plain = saved(still);
    uint8_t friction[sizeof(scalar)];
    memcpy(friction, &ball.friction, sizeof friction);
    const size_t at = static_cast<size_t>(std::search(plain.begin(), plain.end(), std::begin(friction), std::end(friction)) - plain.begin());
    ASSERT_LT(at, plain.size());
    copy(before, still);
    const Bytes bouncing = spoilt(plain, at - sizeof(scalar), scalar(0.5));
    EXPECT_EQ(ingot::load_snapshot(still, bouncing.data(), bouncing.size()), Status::bad_snapshot);
    EXPECT_TRUE(same_bytes(still, before));
}

TEST_F(DamagedPile, of_what_is_a_sensor) {
    static World<WatchedPile> world, other, before;
    fill_pile(world);
    (void)ingot::step(world, h);
    const Bytes sound = saved(world);
    // The last body is the sensor; a filter follows, manifolds, their number and so many, and in the same way who is in the sensor.
    const size_t overlaps = 2 + 13 * static_cast<size_t>(world.overlap_count()), manifolds = static_cast<size_t>(ingot::step(world, h).contacts);
    const size_t at = sound.size() - checksum - overlaps - manifolds * manifold_size - 11;
    ASSERT_EQ(sound[at], 1);
    ASSERT_EQ(sound[at + 9], manifolds);
    fill_pile(other);
    copy(before, other);
    const Bytes twice = spoilt(sound, at, uint8_t{2});
    EXPECT_EQ(ingot::load_snapshot(other, twice.data(), twice.size()), Status::bad_snapshot);
    EXPECT_TRUE(same_bytes(other, before));
    const Bytes none = spoilt(sound, at, uint8_t{0});
    EXPECT_EQ(ingot::load_snapshot(other, none.data(), none.size()), Status::ok);
    EXPECT_EQ(saved(other), none);
}

}  // namespace
