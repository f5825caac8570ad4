// SPDX-License-Identifier: MIT
// The few RISC-V things that platform needs: memory by address, control registers. Not for users of ingot.
#pragma once

#include <stdint.h>

namespace ingot::platform::riscv {

/// A word of memory that the compiler should leave as it is written.
inline volatile uint32_t& word_at(uint32_t address) { return *reinterpret_cast<volatile uint32_t*>(address); }

/// The address that the linker script gave a symbol, as a number: two symbols are two objects to the compiler.
inline uint32_t address_of(const uint32_t* symbol) { return static_cast<uint32_t>(reinterpret_cast<uintptr_t>(symbol)); }

}  // namespace ingot::platform::riscv

// Control registers, in assembly. Named as an extension of their own there, because to name it on the command line (-march=..._zicsr)
// makes GCC 12 look for libraries of that name and take those of 64 bits when it finds none.
#define INGOT_WITH_CSR(text) ".option push\n\t.option arch, +zicsr\n\t" text "\n\t.option pop"
#define INGOT_CSR_READ(name, value) __asm__ volatile(INGOT_WITH_CSR("csrr %0, " name) : "=r"(value) : : "memory")
#define INGOT_CSR_WRITE(name, value) __asm__ volatile(INGOT_WITH_CSR("csrw " name ", %0") : : "r"(value) : "memory")
#define INGOT_CSR_SET(name, bits) __asm__ volatile(INGOT_WITH_CSR("csrs " name ", %0") : : "r"(bits) : "memory")
