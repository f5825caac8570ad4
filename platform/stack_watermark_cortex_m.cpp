// SPDX-License-Identifier: MIT
// Works on the main stack between two symbols of the linker script.
//
// Written in assembly, as naked functions: without a frame of their own the stack pointer they see is the caller's, the paint
// reaches up to the first word that a function called next can touch, and looking at the paint does not scratch it. They
// name the assembler's syntax, because GCC hands inline assembly for Armv6-M over in the old one.
#include "stack_watermark.h"

#include "cortex_m.h"

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

uint32_t stack_size_bytes() { return cortex_m::address_of(ingot_stack_high) - cortex_m::address_of(ingot_stack_low); }

__attribute__((naked)) uint32_t stack_depth_bytes() {
    __asm__(
        ".syntax unified\n"
        "ldr r0, =ingot_stack_high\n"
        "mov r1, sp\n"
        "subs r0, r0, r1\n"
        "bx lr\n"
        ".ltorg\n");
}

__attribute__((naked)) void stack_paint() {
    __asm__(
        ".syntax unified\n"
        "mov r2, sp\n"
        "ldr r3, =ingot_stack_painted_to\n"
        "str r2, [r3]\n"
        "ldr r0, =ingot_stack_low\n"
        "ldr r1, =" INGOT_STACK_PAINT "\n"
        "1: cmp r0, r2\n"
        "bhs 2f\n"
        "stmia r0!, {r1}\n"
        "b 1b\n"
        "2: bx lr\n"
        ".ltorg\n");
}

__attribute__((naked)) uint32_t stack_deepest_bytes() {
    __asm__(
        ".syntax unified\n"
        "ldr r2, =ingot_stack_painted_to\n"
        "ldr r2, [r2]\n"
        "ldr r0, =ingot_stack_low\n"
        "ldr r1, =" INGOT_STACK_PAINT "\n"
        "1: cmp r0, r2\n"
        "bhs 2f\n"
        "ldr r3, [r0]\n"
        "cmp r3, r1\n"
        "bne 2f\n"
        "adds r0, r0, #4\n"
        "b 1b\n"
        "2: ldr r1, =ingot_stack_high\n"
        "subs r0, r1, r0\n"
        "bx lr\n"
        ".ltorg\n");
}

}  // namespace ingot::platform
