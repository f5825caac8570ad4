// SPDX-License-Identifier: MIT
// Arm MPS3 board with FPGA image AN547: Cortex-M55 at 32 MHz. The counter is the one of the FPGA's system registers.
#include <ingot/platform/boards/board.h>

#include <ingot/platform/cortex_m.h>

namespace ingot::platform {
namespace {

using cortex_m::reg;

// Arm Application Note AN547, "FPGA system control and I/O".
constexpr uint32_t fpgaio_counter = 0x59302018;   // up, one more whenever the prescaler has run out
constexpr uint32_t fpgaio_prescale = 0x5930201C;  // 0: every cycle

}  // namespace

uint32_t board_cpu_hz() { return 32'000'000; }

void board_counter_start() { reg(fpgaio_prescale) = 0; }

uint32_t board_counter() { return reg(fpgaio_counter); }

uint32_t board_counter_hz() { return 20'000'000; }

}  // namespace ingot::platform
