// SPDX-License-Identifier: MIT
// Instruction counter: a free-running counter of the emulated board, under qemu-system-arm -icount shift=6,sleep=off.
//
// With shift=6 every instruction takes 2^6 = 64 ns of virtual time, neither more nor less, and virtual time is all that the
// board's counter sees. A difference of readings is thus a count of instructions. Ticks per instruction are 64 ns times the
// frequency of the counter:
//
//   mps2_an386, mps2_an500   FPGAIO COUNTER   25 MHz   1.6   ticks    instructions = ticks * 5 / 8
//   mps2_an505, mps3_an547   FPGAIO COUNTER   20 MHz   1.28  ticks    instructions = ticks * 25 / 32
//   microbit                 nRF51 TIMER0     16 MHz   1.024 ticks    instructions = ticks * 125 / 128
//
// With sleep=off the count is the same to the tick in every run on every machine, however busy. Without it virtual time may
// begin a little later than the program, and figures differ by a tick from run to run.
//
// Instructions are not cycles: this says whether code became longer, not how many microseconds silicon takes. Without
// -icount the counters follow the host's time, and the figures mean nothing. QEMU's TIMER0 gains up to 0.01 ticks whenever it is
// read: no matter for a measurement, but visible if it is read a thousand times within one.
#include "clock.h"

#include "boards/board.h"
#include "cortex_m.h"
#include "counter_extension.h"

namespace ingot::platform {
namespace {

constexpr uint32_t instructions_per_second = 1'000'000'000u >> 6;  // of virtual time

CounterExtension extension;

}  // namespace

void clock_start() {
    const cortex_m::InterruptGuard guard;
    board_counter_start();
    extension.restart(board_counter());
}

uint64_t clock_ticks() {
    const cortex_m::InterruptGuard guard;
    return extension.extend(board_counter());
}

uint64_t clock_frequency_hz() { return board_counter_hz(); }

const char* clock_name() { return "board counter (QEMU -icount shift=6)"; }

bool clock_counts_instructions() { return true; }

uint64_t clock_ticks_to_instructions(uint64_t ticks) {
    const uint32_t hz = board_counter_hz();
    // Whole seconds apart, so that the product does not overflow.
    const uint64_t seconds = ticks / hz;
    const uint64_t rest = ticks % hz;
    return seconds * instructions_per_second + (rest * instructions_per_second + hz / 2) / hz;
}

}  // namespace ingot::platform
