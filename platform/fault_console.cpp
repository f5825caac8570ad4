// SPDX-License-Identifier: MIT
#include "console.h"
#include "fault.h"

extern "C" [[noreturn]] void ingot_fault(const char* expression, const char* file, int line) {
    using namespace ingot::platform;
    console_write(file != nullptr ? file : "?");
    console_write(":");
    console_write_i64(line);
    console_write(": ingot fault: ");
    console_write(expression != nullptr ? expression : "?");
    console_write("\n");
    console_exit(fault_exit_code);
}
