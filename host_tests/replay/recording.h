// SPDX-License-Identifier: MIT
// A recording of platform/recorder.h, read from a file.
#pragma once

#include <ingot/platform/recorder.h>

#include <cstdint>
#include <string>
#include <vector>

namespace replay {

struct RecordedStep {
    std::vector<uint8_t> input;
    uint64_t hash = 0;
};

struct RecordedState {
    uint32_t step = 0;
    std::vector<uint8_t> bytes;
};

/// With the readings of a Recorder, so that first_divergence takes it.
struct Recording {
    uint32_t begin = 0;
    std::vector<RecordedStep> steps;
    std::vector<RecordedState> states;

    int step_count() const { return static_cast<int>(steps.size()); }
    uint32_t first_step() const { return begin; }
    bool has(uint32_t step) const { return step - begin < steps.size(); }
    uint64_t hash(uint32_t step) const { return steps[step - begin].hash; }
    size_t input_size(uint32_t step) const { return steps[step - begin].input.size(); }
    const uint8_t* input(uint32_t step) const { return steps[step - begin].input.data(); }

    /// The state after a step; null if it was not kept.
    const RecordedState* state_of(uint32_t step) const {
        for (const RecordedState& state : states)
            if (state.step == step) return &state;
        return nullptr;
    }
};

/// Reads what Recorder::write wrote. Returns: why the bytes are no recording; empty if they are one.
std::string read_recording(const std::vector<uint8_t>& bytes, Recording& recording);

}  // namespace replay
