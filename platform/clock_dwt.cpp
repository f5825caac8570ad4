// SPDX-License-Identifier: MIT
// Clock on the cycle counter of the debug unit (DWT CYCCNT): no interrupt, one tick per processor cycle.
//
// Cores without one are told apart when the program runs: Armv8-M may leave it out, QEMU does not model it. SysTick takes
// over then. Cores of the Armv6-M family (M0, M0+) and Armv8-M Baseline (M23) never have it, and an access there is
// unpredictable, so they are told apart by the compiler.
#include "clock.h"

#include "boards/board.h"
#include "cortex_m.h"
#include "counter_extension.h"
#include "systick.h"

namespace ingot::platform {
namespace {

using cortex_m::reg;

constexpr uint32_t demcr = 0xE000EDFC;       // debug exception and monitor control
constexpr uint32_t dwt_ctrl = 0xE0001000;
constexpr uint32_t dwt_cyccnt = 0xE0001004;  // counts up, 32 bits
constexpr uint32_t dwt_lar = 0xE0001FB0;     // lock access; only some cores (M7) have it, others ignore the write

constexpr uint32_t demcr_trace_enable = 1u << 24;
constexpr uint32_t dwt_ctrl_cyccnt_enable = 1u << 0;
constexpr uint32_t dwt_ctrl_no_cyccnt = 1u << 25;
constexpr uint32_t dwt_lar_unlock = 0xC5ACCE55;

#if defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__)
constexpr bool core_may_have_cyccnt = false;
#else
constexpr bool core_may_have_cyccnt = true;
#endif

bool has_cyccnt;
CounterExtension extension;

/// Switches CYCCNT on and tells whether it counts.
bool start_cyccnt() {
    reg(demcr) = reg(demcr) | demcr_trace_enable;
    reg(dwt_lar) = dwt_lar_unlock;
    if ((reg(dwt_ctrl) & dwt_ctrl_no_cyccnt) != 0) return false;
    reg(dwt_ctrl) = reg(dwt_ctrl) | dwt_ctrl_cyccnt_enable;

    const uint32_t before = reg(dwt_cyccnt);
    __asm__ volatile("nop\n\tnop\n\tnop\n\tnop\n\tisb" : : : "memory");
    return reg(dwt_cyccnt) != before;
}

}  // namespace

void clock_start() {
    has_cyccnt = core_may_have_cyccnt && start_cyccnt();
    if (!has_cyccnt) return systick_start();

    const cortex_m::InterruptGuard guard;
    extension.restart(reg(dwt_cyccnt));
}

uint64_t clock_ticks() {
    if (!has_cyccnt) return systick_ticks();

    const cortex_m::InterruptGuard guard;
    return extension.extend(reg(dwt_cyccnt));
}

uint64_t clock_frequency_hz() { return board_cpu_hz(); }

const char* clock_name() { return has_cyccnt ? "DWT CYCCNT" : "SysTick (core without DWT CYCCNT)"; }

bool clock_counts_instructions() { return false; }

uint64_t clock_ticks_to_instructions(uint64_t) { return 0; }

}  // namespace ingot::platform
