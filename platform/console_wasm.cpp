// SPDX-License-Identifier: MIT
// Console of a WebAssembly module: two functions that its host provides (boards/wasm/run.mjs under node). Beside them the
// functions that a compiler calls by itself, for programs without a C library; those of a library are linked first.
#include "console.h"

#include <stddef.h>
#include <stdint.h>

extern "C" {

__attribute__((import_module("ingot"), import_name("write"))) void ingot_host_write(const char* text, size_t bytes);
__attribute__((import_module("ingot"), import_name("exit"), noreturn)) void ingot_host_exit(int code);

// Without the attribute the compiler would see what these loops are, and call the function for them.
__attribute__((weak, no_builtin)) void* memcpy(void* to, const void* from, size_t bytes) {
    for (size_t i = 0; i < bytes; ++i) static_cast<char*>(to)[i] = static_cast<const char*>(from)[i];
    return to;
}
__attribute__((weak, no_builtin)) void* memset(void* to, int value, size_t bytes) {
    for (size_t i = 0; i < bytes; ++i) static_cast<char*>(to)[i] = static_cast<char>(value);
    return to;
}
__attribute__((weak, no_builtin)) void* memmove(void* to, const void* from, size_t bytes) {
    char* const bytes_to = static_cast<char*>(to);
    const char* const bytes_from = static_cast<const char*>(from);
    const bool ahead = reinterpret_cast<uintptr_t>(to) > reinterpret_cast<uintptr_t>(from);  // what is read last is then overwritten first
    for (size_t i = 0; i < bytes; ++i) {
        const size_t at = ahead ? bytes - 1 - i : i;
        bytes_to[at] = bytes_from[at];
    }
    return to;
}

}  // extern "C"

namespace ingot::platform {

void console_write(const char* text) {
    size_t bytes = 0;
    while (text[bytes] != 0) ++bytes;
    ingot_host_write(text, bytes);
}

void console_exit(int code) { ingot_host_exit(code); }

}  // namespace ingot::platform
