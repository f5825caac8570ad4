// SPDX-License-Identifier: MIT
// A firmware that uses up its stack. Expected: the fault is reported, by a handler that has a stack again.
#include <ingot/platform/console.h>

namespace {

/// A frame of at least 256 bytes per call. volatile, and the result used after the call: no tail call, no frame left out.
unsigned dig(unsigned depth) {
    volatile unsigned char frame[256];
    frame[depth % 256] = static_cast<unsigned char>(depth);
    if (depth == 0) return 0;
    return dig(depth - 1) + frame[depth % 256];
}

}  // namespace

int main() {
    volatile unsigned depth = 1000;  // 250 KB, more than any stack here
    (void)dig(depth);
    ingot::platform::console_write("the stack has no end\n");
    return 1;
}
