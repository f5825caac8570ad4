// SPDX-License-Identifier: MIT
// Text output and exit status for tests and measurements, the same on a host and on a board. No printf, no heap, no floats.
//
// Back-ends, chosen when the program is linked: console_host.cpp (standard output) and console_semihosting.cpp (debugger or
// emulator). To write to a UART, define console_write() and console_exit() in the program; the library's are then not
// linked. Semihosting without a debugger attached is a fault on real hardware.
#pragma once

#include <stdint.h>

#include "console_format.h"

namespace ingot::platform {

/// Writes a zero-terminated text as it is. Cost: one semihosting call, or one fputs.
void console_write(const char* text);

/// Ends the program with this status, 0 for success.
[[noreturn]] void console_exit(int code);

/// 18446744073709551615
inline void console_write_u64(uint64_t value) { console_write(format_u64(value).text); }

/// -42
inline void console_write_i64(int64_t value) { console_write(format_decimal(value, 0).text); }

/// 0x0000beef with digits = 8. Range: digits 1..16; more are written if the value needs them.
inline void console_write_hex(uint64_t value, int digits) { console_write(format_hex(value, digits).text); }

/// A number with a decimal point, given as a whole number of its last decimal: (-1234, 3) is -1.234.
///
/// Range:   decimals 0..18. For ratios and measurements without floating point, so that printing does not drag
///          soft-float code into the firmware that is being measured.
inline void console_write_decimal(int64_t scaled, int decimals) { console_write(format_decimal(scaled, decimals).text); }

}  // namespace ingot::platform
