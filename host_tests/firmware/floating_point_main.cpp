// SPDX-License-Identifier: MIT
// check_floating_point() on the unit as it is, and with its control register set to each mode that it has and that the kernel
// cannot work with. Units without modes (soft float, WebAssembly) answer ok, and that is all there is to see.
#include <ingot/ingot.h>
#include <ingot/platform/console.h>

#include <stdint.h>

namespace {

#if defined(__SSE2__)
#define INGOT_HAS_MODES 1
uint32_t mode() { return __builtin_ia32_stmxcsr(); }
void set_mode(uint32_t bits) { __builtin_ia32_ldmxcsr(bits); }
constexpr uint32_t rounding[] = {1u << 13, 2u << 13, 3u << 13}, flushing[] = {1u << 15, 1u << 6, 1u << 15 | 1u << 6};
#elif defined(__aarch64__)
#define INGOT_HAS_MODES 1
uint32_t mode() {
    uint64_t bits;
    __asm__ volatile("mrs %0, fpcr" : "=r"(bits));
    return static_cast<uint32_t>(bits);
}
void set_mode(uint32_t bits) { __asm__ volatile("msr fpcr, %0" : : "r"(uint64_t{bits}) : "memory"); }
constexpr uint32_t rounding[] = {1u << 22, 2u << 22, 3u << 22}, flushing[] = {1u << 24};
#elif defined(__ARM_FP)
#define INGOT_HAS_MODES 1
uint32_t mode() {
    uint32_t bits;
    __asm__ volatile("vmrs %0, fpscr" : "=r"(bits));
    return bits;
}
void set_mode(uint32_t bits) { __asm__ volatile("vmsr fpscr, %0" : : "r"(bits) : "memory"); }
constexpr uint32_t rounding[] = {1u << 22, 2u << 22, 3u << 22}, flushing[] = {1u << 24};
#elif defined(__mips_hard_float)
#define INGOT_HAS_MODES 1
uint32_t mode() {
    uint32_t bits;
    __asm__ volatile("cfc1 %0, $31" : "=r"(bits));
    return bits;
}
void set_mode(uint32_t bits) { __asm__ volatile("ctc1 %0, $31" : : "r"(bits) : "memory"); }
constexpr uint32_t rounding[] = {1, 2, 3}, flushing[] = {1u << 24};
#elif defined(__powerpc__) && !defined(_SOFT_FLOAT)
#define INGOT_HAS_MODES 1
uint32_t mode() {
    double bits;
    __asm__ volatile("mffs %0" : "=f"(bits));
    uint64_t word;
    __builtin_memcpy(&word, &bits, sizeof word);
    return static_cast<uint32_t>(word);
}
void set_mode(uint32_t bits) {
    const uint64_t word = bits;
    double value;
    __builtin_memcpy(&value, &word, sizeof value);
    __asm__ volatile("mtfsf 255, %0" : : "f"(value) : "memory");
}
constexpr uint32_t rounding[] = {1, 2, 3};  // the flushing bit, NI, is each maker's own business, and QEMU ignores it
#define INGOT_NEVER_FLUSHES 1
#elif defined(__riscv_flen)
#define INGOT_HAS_MODES 1
uint32_t mode() {
    uint32_t bits;
    __asm__ volatile("frcsr %0" : "=r"(bits));
    return bits;
}
void set_mode(uint32_t bits) { __asm__ volatile("fscsr %0" : : "r"(bits) : "memory"); }
constexpr uint32_t rounding[] = {1u << 5, 2u << 5, 3u << 5, 4u << 5};
#define INGOT_NEVER_FLUSHES 1
#endif

/// In a function of its own, so that nothing of it is computed in another mode.
__attribute__((noinline)) ingot::Status answer() { return ingot::check_floating_point(); }

int failures;

void expect(ingot::Status status, ingot::Status expected, const char* setting, uint64_t bits) {
    if (status == expected) return;
    ++failures;
    ingot::platform::console_write("FAILED ");
    ingot::platform::console_write(setting);
    ingot::platform::console_write_hex(bits, 8);
    ingot::platform::console_write(": status ");
    ingot::platform::console_write_u64(static_cast<uint64_t>(status));
    ingot::platform::console_write("\n");
}

}  // namespace

int main() {
    using ingot::Status;
    expect(answer(), Status::ok, "as it is ", 0);
#if defined(INGOT_HAS_MODES) && (!INGOT_DOUBLE || !defined(__riscv_flen) || __riscv_flen >= 64)
    const uint32_t good = mode();
    for (const uint32_t bits : rounding) {
        set_mode(good | bits);
        const Status status = answer();
        set_mode(good);
        expect(status, Status::wrong_rounding, "rounding ", bits);
    }
#ifndef INGOT_NEVER_FLUSHES
    for (const uint32_t bits : flushing) {
        set_mode(good | bits);
        const Status status = answer();
        set_mode(good);
        expect(status, Status::flushes_denormals, "flushing ", bits);
    }
#endif
    expect(answer(), Status::ok, "as it was ", good);
#endif
    ingot::platform::console_write(failures == 0 ? "all good\n" : "not good\n");
    return failures;
}
