// SPDX-License-Identifier: MIT
// IEEE 754 single precision in integers, for cores of Armv6-M, which have no floating-point unit.
//
// Smaller than libgcc's routines for them (900 bytes instead of 3400) and faster: addition and subtraction, and the rounding of
// all four operations, share their code. Results are those of IEEE 754 with rounding to nearest even, denormals included, so
// every result has the bits that hardware gives; NaN is 0x7fc00000 (host_tests/maths/soft_float_test.cpp). The library holds
// them there under the names that the compiler calls (run-time ABI of the Arm architecture, 4.1.2), as weak definitions: they
// serve all float arithmetic of the program that links it. -DINGOT_OWN_SOFT_FLOAT=OFF leaves them out. A Cortex-M3 keeps
// libgcc's, which are written in its assembly and take 23 % fewer instructions.
#pragma once

#include <stdint.h>

#include "../base/config.h"

namespace ingot { inline namespace INGOT_ABI { namespace soft_float {

// Floats travel in integer registers there, so each function is the compiler's, under its name.
#if defined(__ARM_EABI__) && defined(__SOFTFP__) && __ARM_ARCH_ISA_THUMB == 1 && !defined(__ARM_ARCH_ISA_ARM)
#define INGOT_COMPILER_CALLS(name) __asm__(name) __attribute__((weak))
#else
#define INGOT_COMPILER_CALLS(name)
#endif

/// The bits of a float.
using Bits = uint32_t;

Bits add(Bits a, Bits b) INGOT_COMPILER_CALLS("__aeabi_fadd");
Bits subtract(Bits a, Bits b) INGOT_COMPILER_CALLS("__aeabi_fsub");
Bits multiply(Bits a, Bits b) INGOT_COMPILER_CALLS("__aeabi_fmul");
Bits divide(Bits a, Bits b) INGOT_COMPILER_CALLS("__aeabi_fdiv");

/// What two numbers are to each other: one of these.
enum Order : int { less = 1, equal = 2, greater = 4, unordered = 8 };
Order order_of(Bits a, Bits b);
int is_equal(Bits a, Bits b) INGOT_COMPILER_CALLS("__aeabi_fcmpeq");
int is_less(Bits a, Bits b) INGOT_COMPILER_CALLS("__aeabi_fcmplt");
int is_less_or_equal(Bits a, Bits b) INGOT_COMPILER_CALLS("__aeabi_fcmple");
int is_greater_or_equal(Bits a, Bits b) INGOT_COMPILER_CALLS("__aeabi_fcmpge");
int is_greater(Bits a, Bits b) INGOT_COMPILER_CALLS("__aeabi_fcmpgt");
int is_unordered(Bits a, Bits b) INGOT_COMPILER_CALLS("__aeabi_fcmpun");

} } }  // namespace ingot::soft_float
