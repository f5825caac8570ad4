// SPDX-License-Identifier: MIT
// As much of Arduino as the examples call.
#pragma once
#include <ingot/platform/console.h>

struct Printed {
    void begin(long) {}
    void print(const char* text) { ingot::platform::console_write(text); }
    void println(long number) {
        ingot::platform::console_write_i64(number);
        ingot::platform::console_write("\n");
    }
};
static Printed Serial;
inline void delay(unsigned long) {}
