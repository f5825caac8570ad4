// SPDX-License-Identifier: MIT
// What all C++ of the guide and of the README is compiled with: see guide.py.
#pragma once

#include <ingot/ingot.h>
#include <ingot/level/level_from_bytes.h>
#include <ingot/platform/clock.h>
#include <ingot/platform/console.h>
#include <ingot/platform/fixed_step.h>
#include <ingot/platform/host_threads.h>
#include <ingot/platform/recorder.h>
#include <ingot/platform/stack_watermark.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace {

int failures = 0;

inline void check(bool good, const char* what, const char* page, int line) {
    if (good) return;
    ++failures;
    std::printf("%s:%d: %s\n", page, line, what);
}

// A call whose answer a page leaves out, as a page may: it is ok.
inline void must(ingot::Status status, const char* call, const char* page, int line) {
    if (status == ingot::Status::ok) return;
    ++failures;
    std::printf("%s:%d: %s answers %s\n", page, line, call, ingot::name(status));
}
template <class T>
void must(const ingot::Result<T>& result, const char* call, const char* page, int line) {
    must(result.status, call, page, line);
}
inline void must(bool good, const char* call, const char* page, int line) { check(good, call, page, line); }

#define CHECK(...) check(static_cast<bool>(__VA_ARGS__), #__VA_ARGS__, __FILE__, __LINE__)
#define MUST(...) must(__VA_ARGS__, #__VA_ARGS__, __FILE__, __LINE__)

struct Page {
    const char* name;
    int line;
    void (*run)();
};

template <unsigned count>
int run(const Page (&pages)[count]) {
    for (const Page& page : pages) {
        const int before = failures;
        page.run();
        if (failures != before) std::printf("%s: what begins in line %d failed\n", page.name, page.line);
    }
    return failures == 0 ? 0 : 1;
}

}  // namespace
