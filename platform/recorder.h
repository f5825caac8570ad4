// SPDX-License-Identifier: MIT
// Keeps what went into the last steps and a hash of what came out, to find the first step at which two machines differ.
//
//   static Recorder<600, 16> recorder;                     // .bss; no constructor runs
//   recorder.record(world.step_count(), input, input_size, world.state_hash());       // after every step
//   if (recorder.compare(step_of_peer, hash_of_peer) == Agreement::different)
//       recorder.write([](uint8_t byte) { put_into_file(byte); });                    // on both machines
//
// host_tests/replay/ingot_replay reads two such files, and names the step; the body and the number too, if states were kept:
//
//   static Recorder<600, 16, 60, ingot::snapshot_size<Scene>()> recorder;             // the states of the last 60 steps
//   recorder.keep_state(bytes, save_snapshot(world, bytes, sizeof bytes).value);      // after record()
//
// To the recorder inputs, hashes and states are bytes: it knows nothing of the kernel.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace ingot::platform {

/// What a recording knows of a step of another machine.
enum class Agreement : uint8_t {
    unknown,    ///< the step is not in the recording: not taken yet, or overwritten
    same,
    different,
};

/// The first step at which two recordings differ.
struct Divergence {
    /// What differs.
    enum class Kind : uint8_t {
        none,   ///< every step that both have is the same
        input,  ///< the machines were told different things
        hash,   ///< they were told the same, and came to different states
    };
    Kind kind;  ///< what differs
    uint32_t step;  ///< the first that does
    bool is_first;  ///< the step before it is in both and the same; else it may have begun earlier than both recall
};

/// A ring of the last steps. A zeroed recorder is a valid empty one. For one thread.
///
/// steps_max        steps it recalls
/// input_bytes_max  of one step
/// states_max       states it recalls, 0 for none; the latest ones
/// state_bytes_max  of one state: ingot::snapshot_size<Scene>()
///
/// Cost:    RAM 16 bytes and the input a step, 8 bytes and the state a state; record() copies the input.
template <int steps_max, int input_bytes_max, int states_max = 0, size_t state_bytes_max = 0>
class Recorder {
    static_assert(steps_max > 0 && input_bytes_max > 0, "a Recorder needs room for a step and its input");
    static_assert(states_max == 0 || state_bytes_max > 0, "a Recorder of states needs their size: snapshot_size<Scene>()");

public:
    /// Adds a step: its number, what was told to the world before it, and the hash after it.
    ///
    /// Steps follow one another. One that was recorded already (a rollback) takes the place of the old one, and of all that
    /// followed it; one that leaves a gap begins the recording anew.
    /// Returns: false if the input does not fit; nothing is recorded then.
    bool record(uint32_t step, const uint8_t* input, size_t input_size, uint64_t hash) {
        if (input_size > static_cast<size_t>(input_bytes_max)) return false;
        go_back_to(step);
        if (count_ == steps_max) {
            begin_ = next(begin_, steps_max);
            --count_;
            ++first_step_;
        }
        Step& added = steps_[place(begin_, count_, steps_max)];
        added.hash = hash;
        added.input_size = static_cast<uint32_t>(input_size);
        if (input_size > 0) __builtin_memcpy(added.input, input, input_size);
        if (count_++ == 0) first_step_ = step;
        return true;
    }

    /// Keeps the state after the step that was recorded last. Returns: false if it does not fit, or no step was recorded.
    bool keep_state(const uint8_t* state, size_t size) {
        if (states_max == 0 || count_ == 0 || size > state_bytes_max) return false;
        if (state_count_ > 0 && state_at(state_count_ - 1).step == last_step()) --state_count_;
        if (state_count_ == states_max) {
            state_begin_ = next(state_begin_, states_max);
            --state_count_;
        }
        State& kept = states_[place(state_begin_, state_count_++, states_max)];
        kept.step = last_step();
        kept.size = static_cast<uint32_t>(size);
        if (size > 0) __builtin_memcpy(kept.bytes, state, size);
        return true;
    }

    int step_count() const { return count_; }  ///< that it recalls
    int state_count() const { return state_count_; }  ///< that it recalls
    /// Of a recording that is not empty.
    uint32_t first_step() const { return first_step_; }
    uint32_t last_step() const { return first_step_ + static_cast<uint32_t>(count_) - 1; }  ///< of a recording that is not empty
    bool has(uint32_t step) const { return step - first_step_ < static_cast<uint32_t>(count_); }  ///< it recalls that step

    /// Of a step that it has.
    uint64_t hash(uint32_t step) const { return at(step).hash; }
    size_t input_size(uint32_t step) const { return at(step).input_size; }  ///< bytes, of a step that it has
    const uint8_t* input(uint32_t step) const { return at(step).input; }  ///< of a step that it has

    /// Whether a hash that came from another machine is that of the same step here.
    Agreement compare(uint32_t step, uint64_t hash_of_other) const {
        if (!has(step)) return Agreement::unknown;
        return hash(step) == hash_of_other ? Agreement::same : Agreement::different;
    }

    /// Hands out the recording byte by byte, the same bytes on every machine: no buffer is needed, and any line will do.
    ///
    /// magic 8, format 4, steps 4, first step 4, states 4; of each step: size of input 4, input, hash 8; of each state: step 4,
    /// size 4, state; FNV-1a of all that 8. Numbers go from the lowest byte up.
    template <class Put>
    void write(Put&& put) const {
        Writer<Put> out{put};
        for (const char c : magic) out.byte(static_cast<uint8_t>(c));
        out.u32(format);
        out.u32(static_cast<uint32_t>(count_));
        out.u32(first_step_);
        out.u32(static_cast<uint32_t>(state_count_));
        for (int step_i = 0; step_i < count_; ++step_i) {
            const Step& step = steps_[place(begin_, step_i, steps_max)];
            out.u32(step.input_size);
            for (uint32_t byte_i = 0; byte_i < step.input_size; ++byte_i) out.byte(step.input[byte_i]);
            out.u64(step.hash);
        }
        for (int state_i = 0; state_i < state_count_; ++state_i) {
            const State& state = state_at(state_i);
            out.u32(state.step);
            out.u32(state.size);
            for (uint32_t byte_i = 0; byte_i < state.size; ++byte_i) out.byte(state.bytes[byte_i]);
        }
        out.u64(out.checksum);
    }

    static constexpr char magic[8] = {'\x89', 'i', 'n', 'g', 'r', 'e', 'c', '\n'};  ///< what a recording begins with
    static constexpr uint32_t format = 1;  ///< raised when the bytes of a recording change

private:
    struct Step {
        uint64_t hash;
        uint32_t input_size;
        uint8_t input[static_cast<unsigned>(input_bytes_max)];
    };
    struct State {
        uint32_t step, size;
        uint8_t bytes[state_bytes_max > 0 ? state_bytes_max : 1];
    };

    template <class Put>
    struct Writer {
        Put& put;
        uint64_t checksum = 0xcbf29ce484222325u;

        // Melted into its callers, whose loops are unrolled, the product takes 1500 bytes of stack on a Cortex-M0.
        __attribute__((noinline)) void byte(uint8_t b) {
            put(b);
            checksum = (checksum ^ b) * 0x100000001b3u;
        }
        void u32(uint32_t number) {
            for (unsigned byte_i = 0; byte_i < 4; ++byte_i) byte(static_cast<uint8_t>(number >> (8 * byte_i)));
        }
        void u64(uint64_t number) {
            u32(static_cast<uint32_t>(number));
            u32(static_cast<uint32_t>(number >> 32));
        }
    };

    static constexpr int next(int place, int size) { return place + 1 == size ? 0 : place + 1; }
    static constexpr int place(int begin, int index, int size) {
        return begin + index < size ? begin + index : begin + index - size;
    }

    const Step& at(uint32_t step) const { return steps_[place(begin_, static_cast<int>(step - first_step_), steps_max)]; }
    const State& state_at(int index) const { return states_[place(state_begin_, index, states_max)]; }

    /// Forgets `step` and what followed it; everything, if `step` is neither recorded nor the next one.
    void go_back_to(uint32_t step) {
        const bool follows = step - first_step_ == static_cast<uint32_t>(count_);
        if (follows) return;
        count_ = has(step) ? static_cast<int>(step - first_step_) : 0;
        while (state_count_ > 0 && !has(state_at(state_count_ - 1).step)) --state_count_;
    }

    Step steps_[static_cast<unsigned>(steps_max)] = {};
    State states_[states_max > 0 ? static_cast<unsigned>(states_max) : 1u] = {};
    uint32_t first_step_ = 0;
    int32_t begin_ = 0, count_ = 0;  // of steps_
    int32_t state_begin_ = 0, state_count_ = 0;
};

/// The first step at which two recordings, of whatever sizes, differ: in what was told, or in what came of it.
/// Cost: O(steps that both have).
template <class A, class B>
Divergence first_divergence(const A& a, const B& b) {
    bool same_before = false;
    for (int step_i = 0; step_i < a.step_count(); ++step_i) {
        const uint32_t step = a.first_step() + static_cast<uint32_t>(step_i);
        if (!b.has(step)) continue;
        const size_t size = a.input_size(step);
        bool same_input = size == b.input_size(step);
        for (size_t byte_i = 0; byte_i < size && same_input; ++byte_i)
            same_input = a.input(step)[byte_i] == b.input(step)[byte_i];
        if (!same_input) return {Divergence::Kind::input, step, same_before};
        if (a.hash(step) != b.hash(step)) return {Divergence::Kind::hash, step, same_before};
        same_before = true;
    }
    return {Divergence::Kind::none, 0, false};
}

}  // namespace ingot::platform
