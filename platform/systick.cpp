// SPDX-License-Identifier: MIT
// SysTick extended from 24 to 64 bits.
//
// The counter runs down, 2^24 ticks a round; -CVR modulo 2^24 is therefore an up counter, and the value 0 belongs to the
// round that begins. (Written as RELOAD - CVR, value 0 would be the last tick of the old round although the hardware has
// already announced the new one: for one tick the reading would be a whole round ahead. So it would be right after the
// start, when CVR is still 0.)
//
// Rounds are counted by COUNTFLAG, not by the interrupt. The usual way, a handler that increments, has a hole: once the
// core has entered the handler the interrupt is no longer pending, but the count is not yet incremented, and an interrupt
// of higher priority that reads the clock right there finds neither. COUNTFLAG is cleared by the read that finds it, and
// that read and the increment are made with interrupts held off, so whoever comes first counts the round, once. The handler
// only makes sure that somebody comes before the next round is over.
#include "systick.h"

#include "cortex_m.h"

namespace ingot::platform {
namespace {

using cortex_m::reg;

constexpr uint32_t syst_csr = 0xE000E010;  // control and status; reading clears COUNTFLAG
constexpr uint32_t syst_rvr = 0xE000E014;  // reload value
constexpr uint32_t syst_cvr = 0xE000E018;  // current value; writing clears it and COUNTFLAG
constexpr uint32_t icsr = 0xE000ED04;      // interrupt control and state

constexpr uint32_t csr_enable = 1u << 0;
constexpr uint32_t csr_interrupt = 1u << 1;
constexpr uint32_t csr_processor_clock = 1u << 2;
constexpr uint32_t csr_countflag = 1u << 16;
constexpr uint32_t icsr_clear_pending_systick = 1u << 25;

constexpr int bits = 24;
constexpr uint32_t value_max = (1u << bits) - 1;

uint64_t rounds;  // completed rounds of 2^24 ticks

}  // namespace

void systick_start() {
    const cortex_m::InterruptGuard guard;
    reg(syst_csr) = 0;
    reg(syst_rvr) = value_max;
    reg(syst_cvr) = 0;
    reg(icsr) = icsr_clear_pending_systick;  // of an earlier user
    rounds = 0;
    reg(syst_csr) = csr_enable | csr_interrupt | csr_processor_clock;
}

uint64_t systick_ticks() {
    const cortex_m::InterruptGuard guard;
    // Value first, flag second. No flag: no wrap before the value was read. Flag: the value may be from either side of
    // the wrap, but a second reading is surely from behind it.
    uint32_t value = reg(syst_cvr);
    if ((reg(syst_csr) & csr_countflag) != 0) {
        ++rounds;
        value = reg(syst_cvr);
    }
    return (rounds << bits) + ((0u - value) & value_max);
}

}  // namespace ingot::platform

/// Overrides the weak entry of the vector table. The name is CMSIS's, which other start-up codes use too.
extern "C" void SysTick_Handler();
extern "C" void SysTick_Handler() { (void)ingot::platform::systick_ticks(); }
