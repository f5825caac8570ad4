// SPDX-License-Identifier: MIT
// A sketch is looped for twenty seconds of its own.
#include <Arduino.h>
#include <stdio.h>

Printed Serial;
void Printed::print(const char* text) { fputs(text, stdout); }
void Printed::println(long number) { printf("%ld\n", number); }

void setup();
void loop();
int main() {
    setup();
    for (int turn = 0; turn < 1200; ++turn) loop();
}
