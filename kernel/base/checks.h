// SPDX-License-Identifier: MIT
// Assertions on the kernel itself. Input of the user is never asserted: it is answered with a Status in every build.
#pragma once

#include "config.h"

#ifndef INGOT_ASSERTS
#define INGOT_ASSERTS 0
#endif

#if INGOT_ASSERTS
/// Defined by platform/ (platform/fault.h) or by the user; the kernel does not return from it.
extern "C" [[noreturn]] void ingot_fault(const char* expression, const char* file, int line);
#define INGOT_ASSERT(expression) ((expression) ? static_cast<void>(0) : ingot_fault(#expression, __FILE__, __LINE__))
#else
#define INGOT_ASSERT(expression) static_cast<void>(0)
#endif
