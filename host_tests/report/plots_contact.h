// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "gnuplot.h"
#include "rows.h"

namespace report {

/// Error against time over rates, cost against bodies, and the way to the exact solution.
std::vector<Sheet> contact_sheets(const Rows& rows);

}  // namespace report
