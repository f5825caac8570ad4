// SPDX-License-Identifier: MIT
#include "fault.h"

#include <stdio.h>
#include <stdlib.h>

extern "C" [[noreturn]] void ingot_fault(const char* expression, const char* file, int line) {
    fflush(stdout);  // what the program said last belongs before its fault
    fprintf(stderr, "%s:%d: ingot fault: %s\n", file != nullptr ? file : "?", line, expression != nullptr ? expression : "?");
    abort();
}
