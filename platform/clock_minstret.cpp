// SPDX-License-Identifier: MIT
// Instruction counter of RISC-V: 64 bits, present on every core with machine mode, no interrupt.
//
// In QEMU it counts exactly, and the same in every run, under -icount shift=0: every instruction is one nanosecond of virtual
// time there, and virtual time is what the register shows. Without -icount it shows the host's time.
#include "clock.h"

#include "riscv.h"

namespace ingot::platform {
namespace {

uint64_t first;

uint64_t instructions() {
    uint32_t low, high, high_again;
    do {  // at most twice: the upper half moves once in 2^32 instructions
        INGOT_CSR_READ("minstreth", high);
        INGOT_CSR_READ("minstret", low);
        INGOT_CSR_READ("minstreth", high_again);
    } while (high != high_again);
    return uint64_t{high} << 32 | low;
}

}  // namespace

void clock_start() { first = instructions(); }

uint64_t clock_ticks() { return instructions() - first; }

uint64_t clock_frequency_hz() { return 1'000'000'000; }

const char* clock_name() { return "minstret (QEMU -icount shift=0)"; }

bool clock_counts_instructions() { return true; }

uint64_t clock_ticks_to_instructions(uint64_t ticks) { return ticks; }

}  // namespace ingot::platform
