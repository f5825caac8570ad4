// SPDX-License-Identifier: MIT
// As much of a core as the examples call.
#pragma once

struct Printed {
    void begin(long) {}
    void print(const char* text);
    void println(long number);
};
extern Printed Serial;
inline void delay(unsigned long) {}
