// SPDX-License-Identifier: MIT
// Works on the main stack between two symbols of the linker script.
//
// Two of the functions are naked: without a frame of their own the stack pointer they see is the caller's, and the paint
// reaches up to the first word that a function called next can touch. They name the assembler's syntax, because GCC hands
// inline assembly for Armv6-M over in the old one.
#include "stack_watermark.h"

#include "cortex_m.h"

/// No likely address, float or small number. A macro, because a naked function may hold only text for the assembler.
#define INGOT_STACK_PAINT 0xC5C5C5C5
#define INGOT_TEXT_(x) #x
#define INGOT_TEXT(x) INGOT_TEXT_(x)

extern "C" {
extern const uint32_t ingot_stack_low[];
extern const uint32_t ingot_stack_high[];

/// Stack pointer of who called stack_paint(). Above it lie words that were not painted, but may hold older paint: a slot that
/// its frame has never written.
uint32_t ingot_stack_painted_to;
}

namespace ingot::platform {

using cortex_m::address_of;

uint32_t stack_size_bytes() { return address_of(ingot_stack_high) - address_of(ingot_stack_low); }

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
        "ldr r0, =ingot_stack_low\n"
        "ldr r1, =" INGOT_TEXT(INGOT_STACK_PAINT) "\n"
        "mov r2, sp\n"
        "ldr r3, =ingot_stack_painted_to\n"
        "str r2, [r3]\n"
        "1: cmp r0, r2\n"
        "bhs 2f\n"
        "stmia r0!, {r1}\n"
        "b 1b\n"
        "2: bx lr\n"
        ".ltorg\n");
}

uint32_t stack_deepest_bytes() {
    uint32_t lowest = address_of(ingot_stack_low);
    while (lowest < ingot_stack_painted_to && cortex_m::reg(lowest) == INGOT_STACK_PAINT) lowest += 4;
    return address_of(ingot_stack_high) - lowest;
}

}  // namespace ingot::platform
