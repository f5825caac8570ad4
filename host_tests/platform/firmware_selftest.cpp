// SPDX-License-Identifier: MIT
// Checks on the emulated board what a host cannot: start-up, floating-point unit, clock back-end, stack paint.
//
// Built once per clock back-end. Returns 0, or the number of failed checks after printing them.
#include <stdint.h>
#include <string.h>

#include <ingot/platform/boards/board.h>
#include <ingot/platform/clock.h>
#include <ingot/platform/console.h>
#include <ingot/platform/stack_watermark.h>
#ifndef __riscv
#include <ingot/platform/cortex_m.h>
#endif

extern "C" void Reset_Handler();

namespace {

using namespace ingot::platform;

int failures;

/// Counts and prints a failed check, with the figure that it failed on.
void check(bool good, const char* law, int64_t figure) {
    if (good) return;
    ++failures;
    console_write("FAILED ");
    console_write(law);
    console_write(": ");
    console_write_i64(figure);
    console_write("\n");
}

// ---- start-up ----

constexpr uint32_t data_value = 0x1D8AF066;
constexpr uint32_t been_here = 0x5EC0D1A6;

uint32_t in_data = data_value;
uint32_t in_bss[17];
__attribute__((section(".noinit"))) uint32_t restarts;

/// RAM of an emulator is zero anyway, so the first pass shows nothing about .bss: spoil everything and start again.
void check_startup() {
    check(in_data == data_value, ".data has its values", in_data);
    for (const uint32_t word : in_bss) check(word == 0, ".bss is zero", word);
    if (restarts == been_here) return;

    restarts = been_here;
    in_data = 1;
    for (uint32_t& word : in_bss) word = 2;
    Reset_Handler();
}

// ---- floating point ----

template <class Bits, class Real>
Bits bits_of(Real value) {
    static_assert(sizeof(Bits) == sizeof(Real), "same size");
    Bits bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/// Read through volatile, so that the board computes and not the compiler.
void check_floating_point() {
    volatile float one = 1.0f, three = 3.0f, smallest_normal = 0x1p-126f;
    volatile double one_double = 1.0, three_double = 3.0;
    const uint32_t third = bits_of<uint32_t>(one / three);
    const uint64_t third_double = bits_of<uint64_t>(one_double / three_double);
    check(third == 0x3EAAAAABu, "1/3 in float", third);
    check(third_double == 0x3FD5555555555555u, "1/3 in double", static_cast<int64_t>(third_double));

    const float denormal = smallest_normal / three;
    check(bits_of<uint32_t>(denormal) == 0x002AAAABu, "denormals are kept", bits_of<uint32_t>(denormal));

    // Fused, this would be -2^-24; rounded twice it is 0.
    volatile float a = 1.0f + 0x1p-12f, c = -(1.0f + 0x1p-11f);
    const float contracted = a * a + c;
    check(contracted == 0.0f, "products are rounded before they are added", bits_of<uint32_t>(contracted));
}

// ---- clock ----

/// Exactly 2 * `rounds` instructions, and a few around them.
__attribute__((noinline)) void spend_instructions(uint32_t rounds) {
#ifdef __riscv
    __asm__ volatile(
        "1: addi %0, %0, -1\n"
        "bnez %0, 1b\n"
        : "+r"(rounds));
#else
    __asm__ volatile(
        ".syntax unified\n"
        "1: subs %0, %0, #1\n"
        "bne 1b\n"
        : "+l"(rounds)
        :
        : "cc");
#endif
}

void check_clock_is_monotone() {
    uint64_t last = clock_ticks();
    for (int i = 0; i < 20'000; ++i) {
        const uint64_t now = clock_ticks();
        check(now >= last, "clock never decreases", static_cast<int64_t>(now - last));
        last = now;
    }
}

#ifndef __riscv  // whose counter has 64 bits and no interrupt

/// Lets the clock run for a time and compares it with the board's counter, which has 32 bits and does not wrap meanwhile.
/// Returns how far the clock is ahead, in ticks.
int64_t clock_error_over(uint32_t rounds, int readings) {
    const uint32_t counter_before = board_counter();
    const uint64_t before = clock_ticks();
    for (int i = 0; i < readings; ++i) {
        spend_instructions(rounds);
        (void)clock_ticks();
    }
    const uint64_t ticks = clock_ticks() - before;
    const uint64_t counted = board_counter() - counter_before;
    return static_cast<int64_t>(ticks) - static_cast<int64_t>(counted * clock_frequency_hz() / board_counter_hz());
}

constexpr uint32_t instructions_per_second = 1'000'000'000 >> 6;  // of -icount shift=6

constexpr int64_t error_max = 1000;  // ticks; both counters are read one after the other, and -O0 takes its time

/// Readings placed so that a wrap of the narrowest counter, SysTick's 24 bits, falls between any two instructions of them.
/// A lost or doubled wrap would be a jump of 2^24 ticks.
void check_readings_around_wraps() {
    constexpr uint32_t round_ticks = 1u << 24;
    constexpr uint32_t lead = 400;       // instructions from the last spent one to the wrap, the first readings among them
    constexpr uint32_t walk = 80;        // more than the instructions from one reading to the next, when optimised
    constexpr uint32_t readings = 24;    // enough to be past the wrap
    constexpr uint64_t step_max = 2000;  // ticks from one reading to the next
    // Beforehand and in 1/1024, because a division on the way would take a Cortex-M0 past the wrap.
    const uint64_t instructions_per_1024_ticks = uint64_t{instructions_per_second} * 1024 / clock_frequency_hz();

    for (uint32_t offset = 0; offset < walk; offset += 2) {
        const uint32_t ticks_left = round_ticks - static_cast<uint32_t>(clock_ticks()) % round_ticks;
        const uint32_t instructions_left = static_cast<uint32_t>(ticks_left * instructions_per_1024_ticks >> 10);
        spend_instructions((instructions_left - lead + offset) / 2);

        uint64_t last = clock_ticks();
        check(last % round_ticks > round_ticks / 2, "the wrap is still ahead", static_cast<int64_t>(last % round_ticks));
        for (uint32_t i = 0; i < readings; ++i) {
            const uint64_t now = clock_ticks();
            check(now - last <= step_max, "no jump where the counter wraps", static_cast<int64_t>(now - last));
            last = now;
        }
        check(last % round_ticks < round_ticks / 2, "the wrap was met", static_cast<int64_t>(last % round_ticks));
    }
}

void check_wrap_extension() {
    board_counter_start();

    // 4 rounds of a 24-bit counter with interrupts on and the clock not read: the interrupt alone must see the wraps.
    const int64_t unread = clock_error_over(20'000'000, 1);
    check(unread >= -error_max && unread <= error_max, "wraps are counted while nobody reads", unread);

    // Interrupts off for most of a round at a time: reading alone must see them.
    int64_t masked;
    {
        const cortex_m::InterruptGuard guard;
        masked = clock_error_over(4'000'000, 5);
    }
    check(masked >= -error_max && masked <= error_max, "wraps are counted while interrupts are off", masked);

    // Two figures that are no multiple of each other and of the round, so that readings fall everywhere in it.
    const int64_t fine = clock_error_over(997, 10'000);
    check(fine >= -error_max && fine <= error_max, "wraps are counted by whoever comes first", fine);
}

#endif

/// A loop of known length must be found in the clock, and found the same twice.
void check_instruction_count() {
    if (!clock_counts_instructions()) return;
    constexpr uint32_t rounds = 10'000;
    constexpr int64_t overhead_max = 200;  // one clock reading and the call; 30 when optimised

    int64_t counts[2];
    for (int64_t& count : counts) {
        const uint64_t before = clock_ticks();
        spend_instructions(rounds);
        count = static_cast<int64_t>(clock_ticks_to_instructions(clock_ticks() - before)) - 2 * rounds;
    }
    check(counts[0] >= 0 && counts[0] <= overhead_max, "instructions of a known loop, beyond its own", counts[0]);
    // Both ends are rounded to ticks, so one instruction either way.
    check(counts[0] - counts[1] <= 1 && counts[1] - counts[0] <= 1, "the same loop counts the same", counts[0] - counts[1]);

    console_write("instructions of a clock reading: ");
    console_write_i64(counts[0]);
    console_write("\n");
}

// ---- stack ----

constexpr uint32_t buffer_bytes = 512;

/// Fills a buffer of known size on the stack.
__attribute__((noinline)) void use_stack() {
    volatile uint32_t buffer[buffer_bytes / 4];
    for (volatile uint32_t& word : buffer) word = 1;
}

void check_stack_watermark() {
    const uint32_t before = stack_depth_bytes();
    check(before > 0 && before < stack_size_bytes(), "depth lies within the stack", before);
    check(stack_deepest_bytes() >= before, "start-up has painted, and main is below it", stack_deepest_bytes());

    stack_paint();
    check(stack_deepest_bytes() == before, "paint reaches up to the caller's frame", stack_deepest_bytes() - before);

    use_stack();
    const uint32_t used = stack_deepest_bytes() - before;
    constexpr uint32_t frame_extra_max = 32;  // saved registers, alignment
    check(used >= buffer_bytes && used <= buffer_bytes + frame_extra_max, "a callee's frame is seen in full", used);

    stack_paint();
    check(stack_deepest_bytes() == before, "painting again forgets", stack_deepest_bytes() - before);
}

}  // namespace

int main() {
    check_startup();
    check_floating_point();

    clock_start();
    console_write("clock: ");
    console_write(clock_name());
    console_write("\n");
    check_clock_is_monotone();
    check_instruction_count();
#ifndef __riscv
    check_wrap_extension();
    if (!clock_counts_instructions()) check_readings_around_wraps();

    // On a stack that no interrupt of the clock touches.
    const cortex_m::InterruptGuard guard;
#endif
    check_stack_watermark();

    console_write(failures == 0 ? "all good\n" : "not good\n");
    return failures;
}
