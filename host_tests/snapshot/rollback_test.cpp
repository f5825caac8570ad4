// SPDX-License-Identifier: MIT
// Rollback as games over a network do it: inputs of the others come eight frames late, and every frame goes back to where they were
// due, and from there to the present again.
#include "capacity/yard.h"
#include "scenes/drop.h"
#include "scenes/random.h"

#include <gtest/gtest.h>

namespace {

using scenes::Drop;
using namespace yard;

constexpr int delay = 8, frames = 10000;

/// What a player does in one frame.
struct Input {
    bool kicks, tags;
    int slot;
    Vector impulse;
};

class Match {
public:
    Match() {
        scenes::Random random(42);
        for (Input& input : inputs_) {
            input.kicks = random.symmetric() > scalar(0.8);
            input.tags = random.symmetric() > scalar(0.98);
            input.slot = 1 + static_cast<int>((1 + random.symmetric()) * scalar(0.5) * (Drop::max_bodies - 1));
            input.impulse = random.symmetric_vector() * scalar(40) + Vector{0, 0, 100};
        }
    }

    const Input& input(int frame) const { return inputs_[frame]; }

    /// One frame. A body that is tagged leaves the game and comes back where it began.
    static void play(World<Drop>& world, const Input& input) {
        const BodyId id = world.body_at(input.slot);
        if (input.kicks) (void)world.apply_central_impulse(id, input.impulse);
        if (input.tags) {
            (void)world.remove(id);
            BodyDef ball = plain_body({static_cast<scalar>(input.slot), 6, 2}, ingot::Sphere{scalar(0.25)});
            ball.restitution = scalar(0.5);
            (void)world.add(ball);
        }
        (void)ingot::step(world, Drop::h);
    }

private:
    Input inputs_[frames];
};

/// A world kept by memcpy.
struct Copied {
    World<Drop> kept;
    void keep(const World<Drop>& world) { copy(kept, world); }
    void restore(World<Drop>& world) const { copy(world, kept); }
};
/// A world kept in its portable form.
struct Portable {
    uint8_t bytes[ingot::snapshot_size<Drop>()];
    size_t size;
    void keep(const World<Drop>& world) {
        const Result<size_t> saved = ingot::save_snapshot(world, bytes, sizeof bytes);
        ASSERT_TRUE(saved.ok());
        size = saved.value;
    }
    void restore(World<Drop>& world) const { ASSERT_EQ(ingot::load_snapshot(world, bytes, size), Status::ok); }
};

template <class Kept>
class Rollback : public ::testing::Test {};
using Forms = ::testing::Types<Copied, Portable>;
TYPED_TEST_SUITE(Rollback, Forms);

TYPED_TEST(Rollback, of_eight_frames_in_every_frame_gives_the_world_of_those_who_never_went_back) {
    static Match match;
    static World<Drop> present, client;
    static TypeParam confirmed;
    static uint64_t truth[frames];
    clear(present);
    ASSERT_EQ(set_up(present), Status::ok);
    copy(client, present);
    confirmed.keep(client);

    int predicted_wrongly = 0;
    for (int frame = 0; frame < frames; ++frame) {
        Match::play(present, match.input(frame));
        truth[frame] = present.state_hash();
        if (frame < delay) continue;

        // The input of `known` has come. All later ones are taken for none, until they come.
        const int known = frame - delay;
        confirmed.restore(client);
        Match::play(client, match.input(known));
        ASSERT_EQ(client.state_hash(), truth[known]) << "frame " << known;
        confirmed.keep(client);
        for (int later = known + 1; later <= frame; ++later) Match::play(client, Input{});
        predicted_wrongly += client.state_hash() != truth[frame] ? 1 : 0;

        // And with the inputs that will have come by then, the same present to the bit.
        confirmed.restore(client);
        for (int later = known + 1; later <= frame; ++later) {
            Match::play(client, match.input(later));
            ASSERT_EQ(client.state_hash(), truth[later]) << "frame " << later << " from " << known;
        }
        ASSERT_EQ(client.step_count(), present.step_count());
    }
    EXPECT_GT(predicted_wrongly, frames / 10) << "inputs matter";
}

}  // namespace
