// SPDX-License-Identifier: MIT
// The fault hook: where a program ends that has found itself to be wrong.
//
// The kernel's assertions, where they are built in, and the HardFault handler of the boards end here. Bad input never does:
// it is answered with a Status.
#pragma once

/// Reports and stops. Host: one line to stderr, then abort(). Cortex-M: one line to the console, then exit status 99.
///
/// A program may define this function itself, to reset or to go to a safe state; the library's is then not linked.
///
/// expression: what should have been true, or the name of the fault. file, line: where. Null pointers are printed as "?".
extern "C" [[noreturn]] void ingot_fault(const char* expression, const char* file, int line);

namespace ingot::platform {

/// Exit status of a firmware that ended in ingot_fault(). Unlike any that a test program returns on purpose.
inline constexpr int fault_exit_code = 99;

}  // namespace ingot::platform
