// SPDX-License-Identifier: MIT
// A firmware that runs into an undefined instruction. Expected: the report names the address of that instruction.
//
// Also shows how a program puts its own functions in the place of the library's: console and fault hook are defined here,
// and the report of the fault handler comes to them. Exit status 0 if it is right.
#include <stdint.h>
#include <string.h>

#include <ingot/platform/console.h>
#include <ingot/platform/fault.h>
#include <ingot/platform/semihosting.h>

#ifdef __riscv
#define INGOT_UNDEFINED "unimp"
#define INGOT_FAULT_NAME "trap"
#else
#define INGOT_UNDEFINED "udf #1"
#define INGOT_FAULT_NAME "HardFault"
#endif

extern "C" const uint32_t undefined_instruction[];

namespace {

char said[200];

}  // namespace

namespace ingot::platform {

void console_write(const char* text) {
    const size_t length = strlen(said);
    if (length + strlen(text) < sizeof said) strcpy(said + length, text);
}

void console_exit(int code) {
    constexpr uint32_t sys_exit_extended = 0x20, application_exit = 0x20026;
    const uint32_t reason_and_status[2] = {application_exit, static_cast<uint32_t>(code)};
    for (;;) (void)semihosting(sys_exit_extended, reason_and_status);
}

}  // namespace ingot::platform

extern "C" [[noreturn]] void ingot_fault(const char* expression, const char*, int) {
    using namespace ingot::platform;
    char expected[64] = INGOT_FAULT_NAME " at pc ";
    strcat(expected, format_hex(reinterpret_cast<uintptr_t>(undefined_instruction), 8).text);
    const bool right = strcmp(expression, INGOT_FAULT_NAME) == 0 && strncmp(said, expected, strlen(expected)) == 0;
    console_exit(right ? 0 : 1);
}

int main() {
    __asm__ volatile(".global undefined_instruction\nundefined_instruction: " INGOT_UNDEFINED);
    return 2;
}
