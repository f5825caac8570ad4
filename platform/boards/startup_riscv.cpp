// SPDX-License-Identifier: MIT
// From reset to main() and out again, for RISC-V with machine mode only. No vendor code, no libc start-up, no constructors.
#include <stdint.h>

#include <ingot/platform/console.h>
#include <ingot/platform/fault.h>
#include <ingot/platform/riscv.h>
#include <ingot/platform/stack_watermark.h>

// The firmware's main(). By its assembler name, because C++ forbids calling main, and because a unit compiled
// -ffreestanding would look for a mangled one.
int firmware_main() __asm__("main");

extern "C" {

// Of boards/sections.ld.
extern const uint32_t ingot_stack_low[], ingot_stack_high[];
extern const uint32_t ingot_data_low[], ingot_data_high[], ingot_data_load[];
extern const uint32_t ingot_bss_low[], ingot_bss_high[];

void Reset_Handler();
void ingot_trap_entry();
void ingot_start();
void ingot_trap(uint32_t stack);

}  // extern "C"

namespace {

using namespace ingot::platform;
using riscv::address_of;
using riscv::word_at;

/// Not __FILE__, which would put the path of the checkout, and its length, into flash.
constexpr const char* this_file = "startup_riscv.cpp";

/// Must come before any function that may save a floating-point register.
inline void switch_fpu_on() {
#ifdef __riscv_flen
    INGOT_CSR_SET("mstatus", 0x2000u);  // FS: initial
    INGOT_CSR_WRITE("fcsr", 0u);        // round to nearest; denormals cannot be switched off
#endif
}

/// Forbids the memory below the stack to all access, so that an overflow faults at the first word beyond: the upper end of
/// FLASH lies there, and a store would not be noticed.
inline void switch_stack_guard_on() {
    constexpr uint32_t guard_bytes = 1u << 20;
    constexpr uint32_t locked_no_access_naturally_aligned = 0x98;  // locked, because only locked entries bind machine mode
    const uint32_t low = address_of(ingot_stack_low);
    if (low % guard_bytes != 0) return;
    INGOT_CSR_WRITE("pmpaddr0", (low - guard_bytes) >> 2 | ((guard_bytes >> 3) - 1));
    INGOT_CSR_WRITE("pmpcfg0", locked_no_access_naturally_aligned);
}

void write_register(const char* name, uint32_t value) {
    console_write(name);
    console_write_hex(value, 8);
}

}  // namespace

/// First in memory: the emulator starts there. Small data is addressed relative to gp, which nobody has set yet.
extern "C" __attribute__((naked, section(".vectors"), used)) void Reset_Handler() {
    __asm__(
        ".option push\n"
        ".option norelax\n"
        "la gp, __global_pointer$\n"
        ".option pop\n"
        "la sp, ingot_stack_high\n"
        "j ingot_start\n");
}

extern "C" __attribute__((used)) void ingot_start() {
    switch_fpu_on();
    INGOT_CSR_WRITE("mtvec", reinterpret_cast<uintptr_t>(&ingot_trap_entry));
    switch_stack_guard_on();

    uint32_t from = address_of(ingot_data_load);
    for (uint32_t to = address_of(ingot_data_low); to != address_of(ingot_data_high); to += 4, from += 4) word_at(to) = word_at(from);
    for (uint32_t to = address_of(ingot_bss_low); to != address_of(ingot_bss_high); to += 4) word_at(to) = 0;

    stack_paint();
    console_exit(firmware_main());
}

/// Takes the stack pointer of the trap, and moves to the other end of the stack if there is no room left for the report: an
/// overflow is a likely cause. Nobody returns to what is overwritten there.
extern "C" __attribute__((naked, aligned(4))) void ingot_trap_entry() {
    __asm__(
        "mv a0, sp\n"
        "la t0, ingot_stack_low + 512\n"
        "bgeu sp, t0, 1f\n"
        "la sp, ingot_stack_high\n"
        "1: j ingot_trap\n");
}

/// Reports a trap. No interrupt is on, so every trap is a fault.
extern "C" __attribute__((used)) void ingot_trap(uint32_t stack) {
    uint32_t cause, at, value;
    INGOT_CSR_READ("mcause", cause);
    INGOT_CSR_READ("mepc", at);
    INGOT_CSR_READ("mtval", value);
    if (stack < address_of(ingot_stack_low) || stack > address_of(ingot_stack_high)) {
        write_register("trap with the stack pointer out of the stack: ", stack);
        write_register(", at pc ", at);
    } else {
        write_register("trap at pc ", at);
    }
    write_register(", mcause ", cause);
    write_register(", mtval ", value);
    console_write("\n");
    ingot_fault("trap", this_file, __LINE__);
}
