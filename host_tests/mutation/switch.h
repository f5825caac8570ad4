// SPDX-License-Identifier: MIT
// Included before everything in the mutated tree: is this mutant switched on? What the compiler computes is never mutated.
#pragma once

extern "C" bool ingot_mutant_is_on(int number);

#define INGOT_MUTANT(number) (__builtin_is_constant_evaluated() ? false : ingot_mutant_is_on(number))
