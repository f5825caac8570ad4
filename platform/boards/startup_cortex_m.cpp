// SPDX-License-Identifier: MIT
// From reset to main() and out again, for every Cortex-M board here. No vendor code, no libc start-up, no constructors.
#include <stdint.h>

#include <ingot/platform/console.h>
#include <ingot/platform/cortex_m.h>
#include <ingot/platform/fault.h>
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
void ingot_hard_fault(uint32_t frame);
void ingot_unhandled_exception();

// The names are CMSIS's. A firmware that wants an exception defines its handler; the rest end in one place.
void NMI_Handler() __attribute__((weak, alias("ingot_unhandled_exception")));
void HardFault_Handler();
void MemManage_Handler() __attribute__((weak, alias("ingot_unhandled_exception")));
void BusFault_Handler() __attribute__((weak, alias("ingot_unhandled_exception")));
void UsageFault_Handler() __attribute__((weak, alias("ingot_unhandled_exception")));
void SVC_Handler() __attribute__((weak, alias("ingot_unhandled_exception")));
void DebugMon_Handler() __attribute__((weak, alias("ingot_unhandled_exception")));
void PendSV_Handler() __attribute__((weak, alias("ingot_unhandled_exception")));
void SysTick_Handler() __attribute__((weak, alias("ingot_unhandled_exception")));

}  // extern "C"

namespace {

using namespace ingot::platform;
using cortex_m::address_of;
using cortex_m::reg;

/// The first 16 words of memory: where the stack begins, and whom to call. Interrupts of devices are not used.
struct Vectors {
    const uint32_t* stack;
    void (*handlers[15])();
};

__attribute__((section(".vectors"), used)) const Vectors vectors = {
    ingot_stack_high,
    {
        Reset_Handler,
        NMI_Handler,
        HardFault_Handler,
        MemManage_Handler,  // these three exist from Armv7-M on, and only when switched on;
        BusFault_Handler,   // until then their faults become HardFaults
        UsageFault_Handler,
        nullptr, nullptr, nullptr, nullptr,
        SVC_Handler,
        DebugMon_Handler,
        nullptr,
        PendSV_Handler,
        SysTick_Handler,
    }};

/// Not __FILE__, which would put the path of the checkout, and its length, into flash.
constexpr const char* this_file = "startup_cortex_m.cpp";

/// Must come before any function that may save a floating-point register.
inline void switch_fpu_on() {
#ifdef __ARM_FP
    constexpr uint32_t cpacr = 0xE000ED88;  // coprocessor access control
    constexpr uint32_t full_access_cp10_cp11 = 0xF00000;
    reg(cpacr) = reg(cpacr) | full_access_cp10_cp11;
    // Round to nearest, denormals kept, NaNs propagated: the reset state, unless a boot loader left another.
#ifdef __ARM_FEATURE_MVE
    constexpr uint32_t fpscr_reset = 4u << 16;  // LTPSIZE: loops without a predicated tail, on which the plain ones insist
#else
    constexpr uint32_t fpscr_reset = 0;
#endif
    __asm__ volatile("dsb\n\tisb\n\tvmsr fpscr, %0" : : "r"(fpscr_reset) : "memory");
#endif
}

#if __ARM_ARCH == 8 && !defined(__ARM_ARCH_8M_BASE__)
/// Armv8-M with the main extension has a register for it.
inline void switch_stack_guard_on() { __asm__ volatile("msr msplim, %0" : : "r"(ingot_stack_low) : "memory"); }
#else
/// Forbids the memory below the stack to all access, so that an overflow faults at the first word beyond.
///
/// On silicon nothing answers there and the bus faults by itself. QEMU's MPS2 boards answer everywhere, with zeros, and a
/// function would return to address 0. Cortex-M0 has no protection unit, and its emulated board does fault.
inline void switch_stack_guard_on() {
#if __ARM_ARCH == 7
    constexpr uint32_t mpu_type = 0xE000ED90, mpu_ctrl = 0xE000ED94, mpu_rnr = 0xE000ED98;
    constexpr uint32_t mpu_rbar = 0xE000ED9C, mpu_rasr = 0xE000EDA0;
    constexpr uint32_t type_regions = 0xFFu << 8;
    constexpr uint32_t ctrl_enable_with_default_map = 1u << 0 | 1u << 2;
    constexpr uint32_t guard_bytes = 1u << 20;
    constexpr uint32_t rasr_no_access_1_mib = 1u << 28 | 19u << 1 | 1u;  // never execute, size 2^(19 + 1), enabled

    const uint32_t low = address_of(ingot_stack_low);
    const bool can_guard = (reg(mpu_type) & type_regions) != 0 && low % guard_bytes == 0;
    if (!can_guard) return;
    reg(mpu_rnr) = 0;
    reg(mpu_rbar) = low - guard_bytes;
    reg(mpu_rasr) = rasr_no_access_1_mib;
    reg(mpu_ctrl) = ctrl_enable_with_default_map;
    __asm__ volatile("dsb\n\tisb" : : : "memory");
#endif
}
#endif

void write_register(const char* name, uint32_t value) {
    console_write(name);
    console_write_hex(value, 8);
}

}  // namespace

extern "C" void Reset_Handler() {
    switch_fpu_on();
    switch_stack_guard_on();

    uint32_t from = address_of(ingot_data_load);
    for (uint32_t to = address_of(ingot_data_low); to != address_of(ingot_data_high); to += 4, from += 4) reg(to) = reg(from);
    for (uint32_t to = address_of(ingot_bss_low); to != address_of(ingot_bss_high); to += 4) reg(to) = 0;

    stack_paint();
    console_exit(firmware_main());
}

/// Takes the stack pointer of the fault, and moves to the other end of the stack if there is no room left for the report:
/// an overflow is a likely cause. Nobody returns to what is overwritten there.
extern "C" __attribute__((naked, weak)) void HardFault_Handler() {
    __asm__(
        ".syntax unified\n"
        "mrs r0, msp\n"
        "ldr r1, =ingot_stack_low + 512\n"
        "cmp r0, r1\n"
        "bhs 1f\n"
        "ldr r1, =ingot_stack_high\n"
        "msr msp, r1\n"
        "1: ldr r1, =ingot_hard_fault\n"
        "bx r1\n"
        ".ltorg\n");
}

/// Reports a HardFault. frame: address of what the core pushed, r0 r1 r2 r3 r12 lr pc xpsr, if it could.
extern "C" __attribute__((used)) void ingot_hard_fault(uint32_t frame) {
    constexpr uint32_t frame_lr = 5 * 4, frame_pc = 6 * 4, frame_bytes = 8 * 4;
#if __ARM_ARCH >= 7
    constexpr uint32_t cfsr = 0xE000ED28;  // configurable fault status: which of MemManage, BusFault, UsageFault, and why
    const bool past_limit = (reg(cfsr) & 1u << 20) != 0;  // STKOF: then nothing was pushed either
#else
    constexpr bool past_limit = false;
#endif
    if (!past_limit && frame >= address_of(ingot_stack_low) && frame + frame_bytes <= address_of(ingot_stack_high)) {
        write_register("HardFault at pc ", reg(frame + frame_pc));
        write_register(", lr ", reg(frame + frame_lr));
    } else {
        write_register("HardFault with the stack pointer out of the stack: ", frame);
    }
#if __ARM_ARCH >= 7
    write_register(", CFSR ", reg(cfsr));
#endif
    console_write("\n");
    ingot_fault("HardFault", this_file, __LINE__);
}

extern "C" void ingot_unhandled_exception() {
    uint32_t number;
    __asm__ volatile("mrs %0, ipsr" : "=r"(number));
    console_write("exception number ");
    console_write_u64(number);
    console_write("\n");
    ingot_fault("unhandled exception", this_file, __LINE__);
}
