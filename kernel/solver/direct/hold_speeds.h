// SPDX-License-Identifier: MIT
#pragma once

#include "island_rows.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of a steep island that is left to the sweeps, and loaded. Where they leave a body faster than it would be without contacts, and than the heavy
/// ones, impulses were lost in the rounding of others: they are dropped, and the body is slowed down. See hold_diverged_islands, of which this is the
/// twin.
template <class View, class Direct>
void hold_speeds(const View& solver, const Direct& island);

} }  // namespace ingot
