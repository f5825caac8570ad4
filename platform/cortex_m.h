// SPDX-License-Identifier: MIT
// The few Cortex-M things that platform needs: registers, holding interrupts off. Not for users of ingot.
#pragma once

#include <stdint.h>

namespace ingot::platform::cortex_m {

/// A memory-mapped register, or any word of memory that the compiler should leave as it is written.
inline volatile uint32_t& reg(uint32_t address) { return *reinterpret_cast<volatile uint32_t*>(address); }

/// The address that the linker script gave a symbol. As a number, because two symbols are two objects to the compiler: it may
/// take pointers to them for unequal without looking, and an empty .data would be copied without end.
inline uint32_t address_of(const uint32_t* symbol) { return static_cast<uint32_t>(reinterpret_cast<uintptr_t>(symbol)); }

/// Holds interrupts off while it lives, and leaves them as it found them, so that it nests.
///
/// PRIMASK stops all but NMI and HardFault. "memory" keeps the compiler from moving accesses out of the region.
class InterruptGuard {
public:
    InterruptGuard() { __asm__ volatile("mrs %0, primask\n\tcpsid i" : "=r"(primask_) : : "memory"); }
    ~InterruptGuard() { __asm__ volatile("msr primask, %0" : : "r"(primask_) : "memory"); }
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

private:
    uint32_t primask_;
};

}  // namespace ingot::platform::cortex_m
