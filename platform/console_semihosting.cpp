// SPDX-License-Identifier: MIT
// Console of the debugger or emulator.
#include "console.h"

#include "semihosting.h"

namespace ingot::platform {
namespace {

constexpr uint32_t sys_write0 = 0x04;            // argument: the text itself
constexpr uint32_t sys_exit_extended = 0x20;     // argument: reason and status
constexpr uint32_t application_exit = 0x20026;   // ADP_Stopped_ApplicationExit

}  // namespace

void console_write(const char* text) { (void)semihosting(sys_write0, text); }

void console_exit(int code) {
    const uint32_t reason_and_status[2] = {application_exit, static_cast<uint32_t>(code)};
    // A debugger may let the program run on; it has nowhere to go.
    for (;;) (void)semihosting(sys_exit_extended, reason_and_status);
}

}  // namespace ingot::platform
