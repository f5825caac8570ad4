// SPDX-License-Identifier: MIT
// The call to the debugger or emulator, the same operations on both families of cores. Not for users of ingot.
#pragma once

#include <stdint.h>

namespace ingot::platform {

/// A request to the debugger or emulator. Without one attached the core faults.
///
/// Source:  Arm, "Semihosting for AArch32 and AArch64": BKPT 0xAB, operation in r0, argument in r1. RISC-V International,
///          "RISC-V Semihosting": three instructions that are not compressed and lie in one page, a0 and a1.
inline uint32_t semihosting(uint32_t operation, const void* argument) {
#ifdef __riscv
    register uint32_t a0 __asm__("a0") = operation;
    register const void* a1 __asm__("a1") = argument;
    __asm__ volatile(
        ".option push\n\t"
        ".option norvc\n\t"
        ".balign 16\n\t"
        "slli x0, x0, 0x1f\n\t"
        "ebreak\n\t"
        "srai x0, x0, 7\n\t"
        ".option pop"
        : "+r"(a0)
        : "r"(a1)
        : "memory");
    return a0;
#else
    register uint32_t r0 __asm__("r0") = operation;
    register const void* r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
#endif
}

}  // namespace ingot::platform
