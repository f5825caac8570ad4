// SPDX-License-Identifier: MIT
// How deep the stack went: the unused part is painted with a pattern, and later the paint is looked at from below.
//
// What a function needs, to compare with what the compiler's -fstack-usage says:
//
//   const uint32_t before = stack_depth_bytes();
//   stack_paint();
//   step(world, h);
//   const uint32_t needed = stack_deepest_bytes() - before;
//
// The result is a lower bound: a frame whose deepest words were reserved but never written leaves the paint there intact.
// Interrupts use the same stack; what they took while the paint lay is in the figure.
//
// On a host there is no stack of known place and size: all functions return 0 and paint nothing.
#pragma once

#include <stdint.h>

namespace ingot::platform {

/// Size of the stack, as given by the linker script. Units: bytes.
uint32_t stack_size_bytes();

/// How deep the caller is, its own frame included. Units: bytes.
uint32_t stack_depth_bytes();

/// Paints all of the stack below the caller's frame. Cost: 4 instructions per word of free stack.
void stack_paint();

/// The deepest that the stack has been since stack_paint(), or since the start-up code painted it. Units: bytes.
///
/// Range:   from the depth of who painted up to stack_size_bytes(), the stack used up; beyond that the boards fault, see
///          boards/sections.ld.
/// Cost:    7 instructions per word still painted.
uint32_t stack_deepest_bytes();

}  // namespace ingot::platform
