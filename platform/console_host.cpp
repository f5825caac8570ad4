// SPDX-License-Identifier: MIT
// Console of a machine with a C library: standard output.
#include "console.h"

#include <stdio.h>
#include <stdlib.h>

namespace ingot::platform {

void console_write(const char* text) { fputs(text, stdout); }

void console_exit(int code) { exit(code); }

}  // namespace ingot::platform
