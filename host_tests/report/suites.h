// SPDX-License-Identifier: MIT
// What is measured, suite by suite; each adds its rows.
#pragma once

#include "progress.h"
#include "rows.h"
#include "settings.h"
#include "variant.h"

namespace report {

/// Free bodies of the tables, by every method, step and scalar; its cost; the order it shows; an hour of the book case.
void run_rotation(const Settings& settings, const std::vector<Variant>& variants, Rows& rows);
/// Heavy tops and swinging torques, by every flight.
void run_driven(const Settings& settings, const std::vector<Variant>& variants, Rows& rows);
/// Energy and orthogonality against time.
void run_drift(const Settings& settings, const std::vector<Variant>& variants, Rows& rows);
/// The whole public step of 1 to 65536 bodies.
void run_throughput(const Settings& settings, const std::vector<Variant>& variants, Rows& rows);
/// Instructions, flash and RAM on emulated cores, from the tables that the cross-compiled tests keep.
void run_mcu(Rows& rows);
#ifdef INGOT_PEERS
/// Bullet and ODE in the same run.
void run_peers(const Settings& settings, Rows& rows);
#endif

}  // namespace report
