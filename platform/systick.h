// SPDX-License-Identifier: MIT
// SysTick as a 64-bit up counter. Shared by the back-ends `systick` and `dwt`; users include clock.h.
#pragma once

#include <stdint.h>

namespace ingot::platform {

/// Starts SysTick on the processor clock, with its interrupt on, and counts from 0.
void systick_start();

/// Processor cycles since systick_start(). See clock_ticks() for the contract.
uint64_t systick_ticks();

}  // namespace ingot::platform
