// SPDX-License-Identifier: MIT
// Worlds with events are saved, and go on telling what the others tell.
#include "crowd.h"

namespace {

using namespace events_stage;
using Bytes = std::vector<uint8_t>;

template <class S>
Bytes saved(const World<S>& world) {
    Bytes bytes(ingot::snapshot_size<S>());
    const ingot::Result<size_t> size = ingot::save_snapshot(world, bytes.data(), bytes.size());
    EXPECT_TRUE(size.ok());
    bytes.resize(size.value);
    return bytes;
}

bool same_events(const ingot::EventView& a, const ingot::EventView& b) {
    if (a.count != b.count) return false;
    for (int event_i = 0; event_i < a.count; ++event_i) {
        const ingot::Event &one = a[event_i], &other = b[event_i];
        if (one.kind != other.kind || one.A != other.A || one.B != other.B) return false;
        if (one.shape_A != other.shape_A || one.shape_B != other.shape_B) return false;
        for (scalar Vector::*axis : {&Vector::x, &Vector::y, &Vector::z})
            if (one.P.*axis != other.P.*axis || one.n.*axis != other.n.*axis) return false;
        if (one.speed != other.speed) return false;
    }
    return true;
}

TEST(SavedEvents, go_on_as_those_of_the_world_that_was_saved) {
    static World<Crowd> restored;
    int compared = 0;
    run_crowd([&](const World<Crowd>& world, const World<Crowd>& before) {
        const Bytes bytes = saved(before);
        memset(static_cast<void*>(&restored), 0xa5, sizeof restored);
        ASSERT_EQ(ingot::load_snapshot(restored, bytes.data(), bytes.size()), Status::ok);
        ASSERT_TRUE(same_events(restored.events(), before.events()));
        ASSERT_EQ(saved(restored), bytes);
        (void)ingot::step(restored, h);
        ASSERT_EQ(restored.state_hash(), world.state_hash());
        ASSERT_TRUE(same_events(restored.events(), world.events()));
        ASSERT_EQ(saved(restored), saved(world));
        compared += world.events().count;
    });
    EXPECT_GT(compared, 1000);
}

struct Guarded : Telling {
    static constexpr int max_overlaps = 8;
};

TEST(SavedEvents, a_sensor_that_was_saved_tells_who_leaves_it_and_no_one_twice) {
    static World<Guarded> world, restored;
    (void)world.add(sensor(fixed(ingot::Box{{1, 1, 1}})));
    (void)world.add(ball(scalar(0.5), {}, {8, 0, 0}));
    (void)ingot::step(world, h);
    ASSERT_EQ(world.overlap_count(), 1);
    const Bytes bytes = saved(world);
    ASSERT_EQ(ingot::load_snapshot(restored, bytes.data(), bytes.size()), Status::ok);
    EXPECT_EQ(restored.overlap_count(), 1);
    int left = 0;
    for (int step_i = 0; step_i < 20; ++step_i) {
        (void)ingot::step(world, h);
        (void)ingot::step(restored, h);
        ASSERT_TRUE(same_events(restored.events(), world.events()));
        for (const ingot::Event& event : restored.events()) left += event.kind == ingot::EventKind::leave ? 1 : 2;
    }
    EXPECT_EQ(left, 1);
}

// The checksum is set right again: only the numbers are wrong.
TEST(SavedEvents, a_list_that_no_world_has_is_refused) {
    static World<Guarded> world, other, kept;
    (void)world.add(sensor(fixed(ingot::Box{{1, 1, 1}})));
    (void)world.add(ball(scalar(0.5), {}, {8, 0, 0}));
    (void)ingot::step(world, h);
    ASSERT_EQ(world.events().count, 1);
    const Bytes sound = saved(world);
    copy(kept, other);
    const size_t size_of_event = 3 + 2 * 6 + 7 * sizeof(scalar), pair = 13, checksum = 8;
    const size_t event = sound.size() - checksum - size_of_event, touching = event - 4, overlap = touching - pair, overlaps = overlap - 2;
    int refused = 0;
    const auto refuses = [&](size_t at, uint8_t value) {
        Bytes bytes = sound;
        bytes[at] = value;
        const uint64_t sum = ingot::snapshot_checksum(bytes.data(), bytes.size() - checksum);
        for (size_t byte_i = 0; byte_i < checksum; ++byte_i) bytes[bytes.size() - checksum + byte_i] = static_cast<uint8_t>(sum >> (8 * byte_i));
        EXPECT_EQ(ingot::load_snapshot(other, bytes.data(), bytes.size()), Status::bad_snapshot) << "at " << at;
        EXPECT_EQ(memcmp(&other, &kept, sizeof other), 0);
        ++refused;
    };
    ASSERT_EQ(sound[overlaps], 1);
    ASSERT_EQ(sound[event - 2], 1);
    refuses(event, 5);                       // a kind that there is not
    refuses(event + 1, 1);                   // a second shape
    refuses(event + 3, 2);                   // a slot that is not in use
    refuses(event + 5, 2);                   // the generation of a body that never lived
    refuses(overlaps, 9);                    // more than there is room for
    refuses(overlap, 2);                     // a slot that is not in use
    refuses(overlap + 2, 0);                 // one body twice
    refuses(overlap + 4, 2);                 // a generation
    refuses(overlap + 12, 2);                // neither hit nor not
    EXPECT_EQ(refused, 9);
}

}  // namespace
