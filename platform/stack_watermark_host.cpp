// SPDX-License-Identifier: MIT
// No stack of known place and size: see stack_watermark.h.
#include "stack_watermark.h"

namespace ingot::platform {

uint32_t stack_size_bytes() { return 0; }
uint32_t stack_depth_bytes() { return 0; }
void stack_paint() {}
uint32_t stack_deepest_bytes() { return 0; }

}  // namespace ingot::platform
