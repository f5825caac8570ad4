// SPDX-License-Identifier: MIT
// The ring of platform/recorder.h, and the bytes it writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "replay/recording.h"

namespace {

using ingot::platform::Agreement;
using ingot::platform::Divergence;
using ingot::platform::first_divergence;
using ingot::platform::Recorder;
using replay::Recording;
using Small = Recorder<5, 4, 2, 3>;

/// A step whose input and hash can be told from its number.
template <class R>
bool record_step(R& recorder, uint32_t step, uint64_t salt = 0) {
    const uint8_t input[4] = {static_cast<uint8_t>(step), static_cast<uint8_t>(step >> 8), 7, 9};
    return recorder.record(step, input, step % 5, step * 0x9e3779b97f4a7c15u + salt);
}

template <class R>
std::vector<uint8_t> written(const R& recorder) {
    std::vector<uint8_t> bytes;
    recorder.write([&bytes](uint8_t byte) { bytes.push_back(byte); });
    return bytes;
}

TEST(Recorder, recalls_the_last_steps_and_no_more) {
    Small recorder;
    EXPECT_EQ(recorder.step_count(), 0);
    EXPECT_FALSE(recorder.has(0));
    EXPECT_EQ(recorder.compare(0, 0), Agreement::unknown);
    for (uint32_t step = 100; step < 120; ++step) {
        ASSERT_TRUE(record_step(recorder, step));
        ASSERT_EQ(recorder.last_step(), step);
        ASSERT_EQ(recorder.step_count(), step < 104 ? static_cast<int>(step) - 99 : 5);
        for (uint32_t at = 95; at < 125; ++at) {
            const bool recalled = at >= 100 && at <= step && at + 5 > step;
            ASSERT_EQ(recorder.has(at), recalled) << at << " after " << step;
            ASSERT_EQ(recorder.compare(at, at * 0x9e3779b97f4a7c15u), recalled ? Agreement::same : Agreement::unknown);
            ASSERT_EQ(recorder.compare(at, 1), recalled ? Agreement::different : Agreement::unknown);
            if (!recalled) continue;
            ASSERT_EQ(recorder.input_size(at), at % 5);
            if (at % 5 > 0) {
                ASSERT_EQ(recorder.input(at)[0], at);
            }
        }
    }
}

TEST(Recorder, refuses_an_input_that_does_not_fit) {
    Small recorder;
    ASSERT_TRUE(record_step(recorder, 1));
    const uint8_t input[5] = {};
    EXPECT_FALSE(recorder.record(2, input, 5, 0));
    EXPECT_EQ(recorder.last_step(), 1u);
    EXPECT_TRUE(recorder.record(2, input, 4, 0));
    EXPECT_TRUE(recorder.record(3, nullptr, 0, 0));
}

TEST(Recorder, goes_back_with_a_rollback_and_begins_anew_after_a_gap) {
    Small recorder;
    const uint8_t state[3] = {1, 2, 3};
    for (uint32_t step = 10; step < 17; ++step) {
        ASSERT_TRUE(record_step(recorder, step));
        ASSERT_TRUE(recorder.keep_state(state, 3));
    }
    ASSERT_TRUE(record_step(recorder, 14, 5));  // back by two
    EXPECT_EQ(recorder.first_step(), 12u);
    EXPECT_EQ(recorder.last_step(), 14u);
    EXPECT_EQ(recorder.state_count(), 0) << "those of 15 and 16 are no more";
    EXPECT_EQ(recorder.hash(14), 14 * 0x9e3779b97f4a7c15u + 5);
    EXPECT_EQ(recorder.hash(13), 13 * 0x9e3779b97f4a7c15u);
    ASSERT_TRUE(record_step(recorder, 15));
    EXPECT_EQ(recorder.step_count(), 4);

    ASSERT_TRUE(recorder.keep_state(state, 3));
    ASSERT_TRUE(record_step(recorder, 20));
    EXPECT_EQ(recorder.first_step(), 20u);
    EXPECT_EQ(recorder.step_count(), 1);
    EXPECT_EQ(recorder.state_count(), 0);
    ASSERT_TRUE(record_step(recorder, 3));
    EXPECT_EQ(recorder.first_step(), 3u);
    EXPECT_EQ(recorder.step_count(), 1);
}

TEST(Recorder, counts_on_when_the_number_of_steps_begins_anew) {
    Small recorder;
    for (uint32_t step = UINT32_MAX - 2; step != 5; ++step) ASSERT_TRUE(record_step(recorder, step));
    EXPECT_EQ(recorder.first_step(), 0u);
    EXPECT_EQ(recorder.step_count(), 5);
}

TEST(Recorder, keeps_the_last_states) {
    Small recorder;
    const uint8_t state[4] = {1, 2, 3, 4};
    EXPECT_FALSE(recorder.keep_state(state, 3)) << "of no step";
    for (uint32_t step = 0; step < 5; ++step) {
        ASSERT_TRUE(record_step(recorder, step));
        EXPECT_FALSE(recorder.keep_state(state, 4));
        if (step != 3) {
            ASSERT_TRUE(recorder.keep_state(state, 2));
            ASSERT_TRUE(recorder.keep_state(state + 1, step % 4)) << "the later one counts";
        }
    }
    EXPECT_EQ(recorder.state_count(), 2);
    Recording read;
    ASSERT_EQ(replay::read_recording(written(recorder), read), "");
    ASSERT_EQ(read.states.size(), 2u);
    EXPECT_EQ(read.states[0].step, 2u);
    EXPECT_EQ(read.states[0].bytes, (std::vector<uint8_t>{2, 3}));
    EXPECT_EQ(read.states[1].step, 4u);
    EXPECT_EQ(read.states[1].bytes, std::vector<uint8_t>());
    EXPECT_EQ(read.state_of(3), nullptr);

    Recorder<3, 1> without_states;
    ASSERT_TRUE(without_states.record(0, nullptr, 0, 0));
    EXPECT_FALSE(without_states.keep_state(state, 0));
}

TEST(Recorder, what_it_writes_is_read_and_damage_is_noticed) {
    Small recorder;
    const uint8_t state[3] = {1, 2, 3};
    for (uint32_t step = 40; step < 52; ++step) {
        ASSERT_TRUE(record_step(recorder, step));
        ASSERT_TRUE(recorder.keep_state(state, 3));
    }
    const std::vector<uint8_t> bytes = written(recorder);
    Recording read;
    ASSERT_EQ(replay::read_recording(bytes, read), "");
    ASSERT_EQ(read.step_count(), 5);
    EXPECT_EQ(read.first_step(), 47u);
    for (uint32_t step = 47; step < 52; ++step) {
        EXPECT_EQ(read.hash(step), recorder.hash(step));
        ASSERT_EQ(read.input_size(step), recorder.input_size(step));
        EXPECT_TRUE(std::equal(recorder.input(step), recorder.input(step) + recorder.input_size(step), read.steps[step - 47].input.begin()));
    }
    EXPECT_EQ(first_divergence(recorder, read).kind, Divergence::Kind::none);

    for (size_t byte_i = 0; byte_i < bytes.size(); ++byte_i) {
        for (int change = 1; change < 256; ++change) {
            std::vector<uint8_t> damaged = bytes;
            damaged[byte_i] = static_cast<uint8_t>(damaged[byte_i] ^ change);
            ASSERT_NE(replay::read_recording(damaged, read), "") << "byte " << byte_i;
        }
    }
    for (size_t size = 0; size < bytes.size(); ++size) {
        const std::vector<uint8_t> cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        ASSERT_NE(replay::read_recording(cut, read), "");
    }
}

TEST(Divergence, is_found_in_inputs_and_in_hashes_and_first_comes_first) {
    const auto a = std::make_unique<Recorder<100, 4>>();
    for (uint32_t other_at = 20; other_at < 60; ++other_at) {
        for (const bool in_input : {false, true}) {
            const auto b = std::make_unique<Recorder<70, 4>>();
            for (uint32_t step = 0; step < 80; ++step) {
                ASSERT_TRUE(record_step(*a, step));
                uint8_t input[4] = {static_cast<uint8_t>(step), 0, 7, 9};
                size_t size = step % 5;
                const bool other = step == other_at;
                if (other && in_input && size == 0) size = 1;
                else if (other && in_input) input[size - 1] ^= 1;
                const uint64_t salt = step > other_at || (other && !in_input) ? 1 : 0;
                ASSERT_TRUE(b->record(step, input, size, step * 0x9e3779b97f4a7c15u + salt));
            }
            const Divergence found = first_divergence(*a, *b), turned = first_divergence(*b, *a);
            EXPECT_EQ(found.kind, in_input ? Divergence::Kind::input : Divergence::Kind::hash);
            EXPECT_EQ(found.step, other_at);
            EXPECT_TRUE(found.is_first);
            EXPECT_EQ(turned.kind, found.kind);
            EXPECT_EQ(turned.step, found.step);
        }
    }
}

TEST(Divergence, that_began_before_all_that_is_recalled_says_so) {
    Small a, b;
    for (uint32_t step = 0; step < 30; ++step) {
        ASSERT_TRUE(record_step(a, step));
        ASSERT_TRUE(record_step(b, step, step >= 10 ? 1 : 0));
    }
    const Divergence found = first_divergence(a, b);
    EXPECT_EQ(found.kind, Divergence::Kind::hash);
    EXPECT_EQ(found.step, 25u);
    EXPECT_FALSE(found.is_first);
}

TEST(Divergence, of_recordings_without_a_common_step_is_none) {
    Small a, b, empty;
    for (uint32_t step = 0; step < 30; ++step) ASSERT_TRUE(record_step(a, step));
    for (uint32_t step = 100; step < 130; ++step) ASSERT_TRUE(record_step(b, step, 3));
    EXPECT_EQ(first_divergence(a, b).kind, Divergence::Kind::none);
    EXPECT_EQ(first_divergence(a, empty).kind, Divergence::Kind::none);
    EXPECT_EQ(first_divergence(empty, a).kind, Divergence::Kind::none);
}

}  // namespace
