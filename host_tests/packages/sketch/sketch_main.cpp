// SPDX-License-Identifier: MIT
// What the IDE makes of a sketch: Arduino.h ahead of it, and a main that calls it, here for as long as it takes to see what it prints.
#include "Arduino.h"
void setup();
void loop();
#include INGOT_SKETCH

int main() {
    setup();
    for (int turn = 0; turn < 1200; ++turn) loop();
    return good ? 0 : 1;
}
