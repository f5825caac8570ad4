// SPDX-License-Identifier: MIT
// BBC micro:bit: nRF51822, Cortex-M0 at 16 MHz. The counter is TIMER0, of the three timers the only one with 32 bits.
#include <ingot/platform/boards/board.h>

#include <ingot/platform/cortex_m.h>

namespace ingot::platform {
namespace {

using cortex_m::reg;

// Nordic nRF51 Series Reference Manual, chapter "Timer/counter".
constexpr uint32_t timer0 = 0x40008000;
constexpr uint32_t task_start = timer0 + 0x000;
constexpr uint32_t task_stop = timer0 + 0x004;
constexpr uint32_t task_clear = timer0 + 0x00C;
constexpr uint32_t task_capture0 = timer0 + 0x040;
constexpr uint32_t mode = timer0 + 0x504;
constexpr uint32_t bitmode = timer0 + 0x508;
constexpr uint32_t prescaler = timer0 + 0x510;  // frequency = 16 MHz / 2^prescaler
constexpr uint32_t capture0 = timer0 + 0x540;

constexpr uint32_t mode_timer = 0;
constexpr uint32_t bitmode_32 = 3;

}  // namespace

uint32_t board_cpu_hz() { return 16'000'000; }

void board_counter_start() {
    reg(task_stop) = 1;
    reg(mode) = mode_timer;
    reg(bitmode) = bitmode_32;
    reg(prescaler) = 0;
    reg(task_clear) = 1;
    reg(task_start) = 1;
}

uint32_t board_counter() {
    reg(task_capture0) = 1;
    return reg(capture0);
}

uint32_t board_counter_hz() { return 16'000'000; }

}  // namespace ingot::platform
