// SPDX-License-Identifier: MIT
// Measures named stages of a program: how often, shortest, longest, mean and last, in ticks of the clock.
//
//   static StageTimer<4> timer;                            // .bss; no constructor runs
//   const StageId physics = timer.add_stage("physics");
//   {
//       const StageScope measure(timer, physics);
//       step(world, h);
//   }
//   console_write_u64(timer.stage(physics).max);
//
// The kernel's own step is not measured from inside: measuring code in it would take more lines than the physics.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "clock.h"

namespace ingot::platform {

/// A stage of a StageTimer. Zero is null: what add_stage() returns when the array is full, and what is ignored elsewhere.
struct StageId {
    int32_t value = 0;  ///< 1 .. size(); 0: null
    constexpr explicit operator bool() const { return value > 0; }  ///< it is not null
};

/// What was measured of one stage. All times in ticks, zero before the first measurement.
struct StageStats {
    const char* name;  ///< of add_stage
    uint32_t count;  ///< measurements
    uint64_t min, max, last;  ///< ticks
    uint64_t sum;  ///< ticks, of all

    /// Rounded down. Cost: one 64-bit division.
    constexpr uint64_t mean() const { return count == 0 ? 0 : sum / count; }
};

/// A fixed array of measured stages. A zeroed timer is a valid empty timer.
///
/// Stages may nest and overlap, but one stage is not inside itself: the later begin() counts. For one thread; the stages
/// of an interrupt belong into a timer of their own.
/// Cost:    56 bytes per stage on a 32-bit core; begin and end together 120 instructions on a Cortex-M4, two readings of
///          the clock among them. A stage that does nothing measures 40 of them (53 on a Cortex-M0).
template <int stages_max>
class StageTimer {
    static_assert(stages_max > 0, "a StageTimer needs room for a stage");

public:
    /// A new stage, or null if the array is full. The name is kept as a pointer and must outlive the timer.
    constexpr StageId add_stage(const char* name) {
        if (size_ == stages_max) return {};
        stages_[size_] = Stage{};
        stages_[size_].stats.name = name;
        return {++size_};
    }

    /// Starts to measure now.
    void begin(StageId id) { begin_at(id, clock_ticks()); }

    /// Ends what begin() started. Without a begin() nothing is recorded.
    void end(StageId id) { end_at(id, clock_ticks()); }

    /// The same with the time given, for a clock other than the platform's.
    constexpr void begin_at(StageId id, uint64_t now_ticks) {
        if (!knows(id)) return;
        stages_[id.value - 1].begun_at = now_ticks;
        stages_[id.value - 1].running = true;
    }
    /// The other end, at that time.
    constexpr void end_at(StageId id, uint64_t now_ticks) {
        if (!knows(id) || !stages_[id.value - 1].running) return;
        stages_[id.value - 1].running = false;
        record(id, now_ticks - stages_[id.value - 1].begun_at);
    }

    /// Adds a duration that was measured elsewhere.
    constexpr void record(StageId id, uint64_t ticks) {
        if (!knows(id)) return;
        StageStats& stats = stages_[id.value - 1].stats;
        stats.min = stats.count == 0 || ticks < stats.min ? ticks : stats.min;
        stats.max = ticks > stats.max ? ticks : stats.max;
        stats.last = ticks;
        stats.sum += ticks;
        ++stats.count;
    }

    /// Forgets all measurements, keeps the stages.
    constexpr void reset() {
        for (int32_t stage_i = 0; stage_i < size_; ++stage_i) {
            const char* name = stages_[stage_i].stats.name;
            stages_[stage_i] = Stage{};
            stages_[stage_i].stats.name = name;
        }
    }

    /// Measurements of a stage; for an id that is not of this timer, an empty one named "?".
    constexpr StageStats stage(StageId id) const {
        return knows(id) ? stages_[id.value - 1].stats : StageStats{"?", 0, 0, 0, 0, 0};
    }

    /// For listing: ids are 1 .. size() in the order of add_stage().
    constexpr int32_t size() const { return size_; }
    static constexpr int32_t capacity() { return stages_max; }  ///< stages that it has room for

private:
    struct Stage {
        StageStats stats{};
        uint64_t begun_at = 0;
        bool running = false;
    };

    constexpr bool knows(StageId id) const { return id.value > 0 && id.value <= size_; }

    Stage stages_[static_cast<size_t>(stages_max)];
    int32_t size_ = 0;
};

/// Measures a stage from here to the end of the block.
template <class Timer>
class StageScope {
public:
    /// Begins to measure.
    StageScope(Timer& timer, StageId id) : timer_(timer), id_(id) { timer_.begin(id_); }
    ~StageScope() { timer_.end(id_); }
    StageScope(const StageScope&) = delete;
    StageScope& operator=(const StageScope&) = delete;

private:
    Timer& timer_;
    StageId id_;
};

}  // namespace ingot::platform
