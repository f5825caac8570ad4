// SPDX-License-Identifier: MIT
// Works on the stack between two symbols of the linker script. Written in assembly, as naked functions: without a frame of their
// own the stack pointer they see is the caller's.
#include "stack_watermark.h"

#include "riscv.h"

/// No likely address, float or small number. A macro, because a naked function may hold only text for the assembler.
#define INGOT_STACK_PAINT "0xC5C5C5C5"

extern "C" {

extern const uint32_t ingot_stack_low[];
extern const uint32_t ingot_stack_high[];

/// Stack pointer of who called stack_paint(). Above it lie words that were not painted, but may hold older paint: a slot
/// that its frame has never written.
uint32_t ingot_stack_painted_to;

}  // extern "C"

namespace ingot::platform {

uint32_t stack_size_bytes() { return riscv::address_of(ingot_stack_high) - riscv::address_of(ingot_stack_low); }

__attribute__((naked)) uint32_t stack_depth_bytes() {
    __asm__(
        "la a0, ingot_stack_high\n"
        "sub a0, a0, sp\n"
        "ret\n");
}

__attribute__((naked)) void stack_paint() {
    __asm__(
        "la t0, ingot_stack_painted_to\n"
        "sw sp, 0(t0)\n"
        "la t0, ingot_stack_low\n"
        "li t1, " INGOT_STACK_PAINT "\n"
        "1: bgeu t0, sp, 2f\n"
        "sw t1, 0(t0)\n"
        "addi t0, t0, 4\n"
        "j 1b\n"
        "2: ret\n");
}

__attribute__((naked)) uint32_t stack_deepest_bytes() {
    __asm__(
        "lw t2, ingot_stack_painted_to\n"
        "la t0, ingot_stack_low\n"
        "li t1, " INGOT_STACK_PAINT "\n"
        "1: bgeu t0, t2, 2f\n"
        "lw t3, 0(t0)\n"
        "bne t3, t1, 2f\n"
        "addi t0, t0, 4\n"
        "j 1b\n"
        "2: la a0, ingot_stack_high\n"
        "sub a0, a0, t0\n"
        "ret\n");
}

}  // namespace ingot::platform
