// SPDX-License-Identifier: MIT
// Real time in, whole steps out: the accumulator that keeps a world stepping at a fixed h however unevenly it is called.
//
//   FixedStep pace(clock_frequency_hz(), {60, 1}, 5);      // 60 steps in 1 second, at most 5 at a time
//   pace.restart(clock_ticks());
//   for (;;) {
//       const StepsDue due = pace.advance(clock_ticks());
//       for (uint32_t i = 0; i < due.steps; ++i) step(world, pace.h());
//       draw(world, pace.fraction());
//   }
#pragma once

#include <stdint.h>

namespace ingot::platform {

/// So many steps in so many seconds: {60, 1} for a game, {60000, 1001} for NTSC video, {1, 10} for a slow orbit.
struct StepRate {
    uint32_t steps;    ///< above 0
    uint32_t seconds;  ///< above 0
};

/// What advance() asks for.
struct StepsDue {
    uint32_t steps;    ///< to take now, at most the catch-up limit
    uint64_t dropped;  ///< were due beyond the limit and will never be taken: the world is late by so many more steps
};

/// Fixed-step accumulator in whole ticks.
///
/// A step of 1/60 s is 416666.67 ticks of a 25 MHz clock, which is no whole number. So time is kept in units of
/// 1 / (ticks_per_second * rate.steps) s: a tick is rate.steps of them and a step ticks_per_second * rate.seconds, both
/// whole. Nothing is ever rounded, and days of irregular calls end at the same step as one call.
///
/// Law:     steps_taken() + steps_dropped() = floor((now - restart) * rate.steps / (ticks_per_second * rate.seconds)).
/// Errors:  see valid(). A clock that goes back counts as one that stood still and goes on from there.
/// Cost:    56 bytes; a call is 65 instructions on a Cortex-M4 and 150 on an M0 if no step is due, 15 to 25 more per step.
///          No division, except after a pause that drops steps.
class FixedStep {
public:
    /// steps_max: the catch-up limit of one advance(). A frame that took too long must not make the next one longer still,
    /// so choose it small enough that taking so many steps needs less time than they simulate.
    constexpr FixedStep(uint64_t ticks_per_second, StepRate rate, uint32_t steps_max)
        : rate_(rate), steps_max_(steps_max), units_per_step_(checked_units_per_step(ticks_per_second, rate)) {}

    /// False if the arguments make no sense, and then no step is ever due. Sense is: nothing is zero (steps_max may be), a
    /// step is at least one tick, and ticks_per_second * rate.steps * rate.seconds is at most 2^63, so that sums are exact.
    constexpr bool valid() const { return units_per_step_ != 0; }

    /// Counts from here, with nothing due. Also the call after a pause that the world should not notice.
    constexpr void restart(uint64_t now_ticks) {
        last_ticks_ = now_ticks;
        units_ = 0;
        steps_taken_ = 0;
        steps_dropped_ = 0;
    }

    /// Steps that have become due since the last call; the caller takes them all.
    [[nodiscard]] constexpr StepsDue advance(uint64_t now_ticks) {
        if (!valid()) return {0, 0};
        uint64_t elapsed_ticks = now_ticks > last_ticks_ ? now_ticks - last_ticks_ : 0;
        last_ticks_ = now_ticks;

        // A long pause: ticks_per_second * rate.seconds ticks are rate.steps steps. What remains fits when multiplied.
        uint64_t steps = 0;
        const uint64_t ticks_per_round = units_per_step_;
        if (elapsed_ticks >= ticks_per_round) {
            steps = elapsed_ticks / ticks_per_round * rate_.steps;
            elapsed_ticks %= ticks_per_round;
        }
        units_ += elapsed_ticks * rate_.steps;

        // By subtraction as long as steps are taken, since none or one is the rule; by division where they are dropped.
        for (; units_ >= units_per_step_ && steps < steps_max_; ++steps) units_ -= units_per_step_;
        if (units_ >= units_per_step_) {
            steps += units_ / units_per_step_;
            units_ %= units_per_step_;  // the begun step is kept: later steps stay on the grid of time
        }

        const StepsDue due = split(steps);
        steps_taken_ += due.steps;
        steps_dropped_ += due.dropped;
        return due;
    }

    /// How much of the next step has passed, for drawing between the last two states.
    ///
    /// Range:   [0, 1), never 1: the exact fraction rounded down to 24 bits, which a float holds.
    /// Cost:    24 rounds of shift, compare and subtract, no division: 260 instructions on a Cortex-M4, 600 on an M0.
    constexpr float fraction() const {
        if (!valid()) return 0.0f;
        uint64_t rest = units_;
        int32_t quotient = 0;
        for (int bit_i = 0; bit_i < 24; ++bit_i) {
            rest <<= 1;
            quotient <<= 1;
            if (rest < units_per_step_) continue;
            rest -= units_per_step_;
            quotient |= 1;
        }
        return static_cast<float>(quotient) * 0x1p-24f;
    }

    /// The step in seconds, argument of step(world, h); h<double>() for a world of doubles. Rounded once.
    /// Range:   infinite or NaN if the rate has zero steps, which the kernel refuses.
    template <class Real = float>
    constexpr Real h() const {
        return static_cast<Real>(rate_.seconds) / static_cast<Real>(rate_.steps);
    }

    /// Sums since restart().
    constexpr uint64_t steps_taken() const { return steps_taken_; }
    constexpr uint64_t steps_dropped() const { return steps_dropped_; }  ///< that were due and never taken

private:
    static constexpr uint64_t checked_units_per_step(uint64_t ticks_per_second, StepRate rate) {
        if (ticks_per_second == 0 || rate.steps == 0 || rate.seconds == 0) return 0;
        constexpr uint64_t units_max = 1ull << 63;
        if (ticks_per_second > units_max / rate.seconds / rate.steps) return 0;
        const uint64_t units_per_step = ticks_per_second * rate.seconds;
        return units_per_step >= rate.steps ? units_per_step : 0;
    }

    constexpr StepsDue split(uint64_t steps) const {
        if (steps <= steps_max_) return {static_cast<uint32_t>(steps), 0};
        return {steps_max_, steps - steps_max_};
    }

    StepRate rate_;
    uint32_t steps_max_;
    uint64_t units_per_step_;

    uint64_t last_ticks_ = 0;
    uint64_t units_ = 0;  // time not given out yet; less than one step between calls
    uint64_t steps_taken_ = 0;
    uint64_t steps_dropped_ = 0;
};

}  // namespace ingot::platform
