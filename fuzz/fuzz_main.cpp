// SPDX-License-Identifier: MIT
// Entry of the fuzzer: one input, worlds of every lane count, one answer.
#include <stdio.h>
#include <stdlib.h>

#include "fuzz_world.h"

/// Where assertions of the kernel end (INGOT_ASSERTS). platform/ has one too, and is not instrumented.
extern "C" [[noreturn]] void ingot_fault(const char* expression, const char* file, int line);
extern "C" [[noreturn]] void ingot_fault(const char* expression, const char* file, int line) {
    fprintf(stderr, "%s:%d: assertion of the kernel: %s\n", file, line, expression);
    abort();
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (run_with_1_lane(data, size) != run_with_4_lanes(data, size)) {
        fprintf(stderr, "broken promise: every lane count gives the same answers\n");
        abort();
    }
    return 0;
}
