// SPDX-License-Identifier: MIT
#include "replay/recording.h"

#include <algorithm>

namespace replay {

namespace {

using Format = ingot::platform::Recorder<1, 1>;

/// Reads numbers from the lowest byte up; past the end zeros.
class Bytes {
public:
    Bytes(const uint8_t* from, size_t size) : next_(from), left_(size) {}

    uint64_t number(unsigned size) {
        uint64_t sum = 0;
        for (unsigned byte_i = 0; byte_i < size; ++byte_i) sum |= static_cast<uint64_t>(byte()) << (8 * byte_i);
        return sum;
    }
    uint32_t u32() { return static_cast<uint32_t>(number(4)); }
    uint64_t u64() { return number(8); }
    std::vector<uint8_t> take(size_t size) {
        overrun_ = overrun_ || size > left_;
        const size_t there = std::min(size, left_);
        std::vector<uint8_t> taken(next_, next_ + there);
        next_ += there;
        left_ -= there;
        return taken;
    }
    size_t left() const { return left_; }
    bool overrun() const { return overrun_; }

private:
    uint8_t byte() {
        const std::vector<uint8_t> one = take(1);
        return one.empty() ? uint8_t(0) : one.front();
    }

    const uint8_t* next_;
    size_t left_;
    bool overrun_ = false;
};

uint64_t checksum_of(const std::vector<uint8_t>& bytes, size_t size) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t byte_i = 0; byte_i < size; ++byte_i) hash = (hash ^ bytes[byte_i]) * 0x100000001b3u;
    return hash;
}

}  // namespace

std::string read_recording(const std::vector<uint8_t>& bytes, Recording& recording) {
    constexpr size_t header_size = 24, checksum_size = 8;
    if (bytes.size() < header_size + checksum_size) return "too short for a recording";
    const auto expected = [](char a, uint8_t b) { return static_cast<uint8_t>(a) == b; };
    if (!std::equal(std::begin(Format::magic), std::end(Format::magic), bytes.begin(), expected)) return "not a recording";
    const size_t checked = bytes.size() - checksum_size;
    if (Bytes(bytes.data() + checked, checksum_size).u64() != checksum_of(bytes, checked)) return "damaged: the checksum is wrong";

    Bytes in(bytes.data() + sizeof Format::magic, checked - sizeof Format::magic);
    if (in.u32() != Format::format) return "of another format";
    const uint32_t step_count = in.u32();
    recording = {};
    recording.begin = in.u32();
    const uint32_t state_count = in.u32();
    for (uint32_t step_i = 0; step_i < step_count && !in.overrun(); ++step_i) {
        RecordedStep step;
        step.input = in.take(in.u32());
        step.hash = in.u64();
        recording.steps.push_back(std::move(step));
    }
    for (uint32_t state_i = 0; state_i < state_count && !in.overrun(); ++state_i) {
        RecordedState state;
        state.step = in.u32();
        state.bytes = in.take(in.u32());
        recording.states.push_back(std::move(state));
    }
    return in.overrun() || in.left() != 0 ? "damaged: its counts do not fit its length" : "";
}

}  // namespace replay
