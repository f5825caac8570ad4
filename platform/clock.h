// SPDX-License-Identifier: MIT
// The clock: a 64-bit count of ticks that never wraps, and how many ticks a second has.
//
// One facade, one back-end chosen when the program is linked (CMake variable INGOT_CLOCK):
//
//   host      clock_host.cpp      monotonic clock of the operating system, nanoseconds as a rule
//   systick   clock_systick.cpp   Cortex-M SysTick, one tick per processor cycle
//   dwt       clock_dwt.cpp       Cortex-M DWT cycle counter; SysTick where the core has none
//   qemu      clock_qemu.cpp      counter of an emulated board; counts instructions exactly
//   minstret  clock_minstret.cpp  RISC-V counter of instructions; exact in QEMU
//   wasm      clock_wasm.cpp      what the host of the module gives, nanoseconds
//
// A program with a clock of its own defines all functions below itself; the library's back-end is then not linked.
// The kernel never reads a clock: time enters it as the argument h.
#pragma once

#include <stdint.h>

namespace ingot::platform {

/// Switches the counter on. Call once, before the first reading.
///
/// Cost:    a few register writes; nothing on a host.
/// Needs:   systick and dwt: nobody else uses that counter. Interrupts may be on or off.
void clock_start();

/// Ticks since a moment that is not specified: only differences mean something.
///
/// Units:   1 / clock_frequency_hz() seconds.
/// Range:   never decreases and never wraps in practice: 2^64 ticks are 584 years at 1 GHz.
/// Needs:   the hardware counter is narrower than 64 bits, so a reading must not come too late. systick: interrupts are
///          never off for longer than 2^24 ticks (0.1 s at 168 MHz). dwt and qemu: one reading at least every 2^32 ticks
///          (25 s at 168 MHz); a program that steps the world does so many times over.
/// Callers: main program and interrupts of every priority, except NMI and HardFault, which nothing can hold off.
/// Cost:    about 25 instructions on a Cortex-M4 or M7, 35 on an M0; 25 ns on a host.
uint64_t clock_ticks();

/// Ticks per second, constant while the program runs.
uint64_t clock_frequency_hz();

/// What is being read, for a report: "SysTick", "DWT CYCCNT", ...
const char* clock_name();

/// True when a tick stands for executed instructions instead of time, which makes readings equal from run to run.
bool clock_counts_instructions();

/// Instructions that a difference of two readings stands for, rounded to nearest; 0 where the clock counts time.
///
/// Errors:  one instruction either way, because both readings are whole ticks and a tick is 0.6 to 1 instruction.
uint64_t clock_ticks_to_instructions(uint64_t ticks);

}  // namespace ingot::platform
