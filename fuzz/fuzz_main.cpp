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

int fuzz_fault = 0;

void broken_promise(const char* text) {
    fprintf(stderr, "broken promise: %s\n", text);
    abort();
}

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);
extern "C" int LLVMFuzzerInitialize(int*, char***) {
    const char* fault = getenv("INGOT_FUZZ_FAULT");
    if (fault != nullptr) fuzz_fault = atoi(fault);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const uint64_t answers[] = {
#if INGOT_FUZZ_1_LANES
        run_with_1_lane(data, size),
#endif
#if INGOT_FUZZ_4_LANES
        run_with_4_lanes(data, size),
#endif
#if INGOT_FUZZ_8_LANES
        run_with_8_lanes(data, size),
#endif
    };
    for (const uint64_t answer : answers)
        if (answer != answers[0]) broken_promise("every lane count gives the same answers");
    return 0;
}
