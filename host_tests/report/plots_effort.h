// SPDX-License-Identifier: MIT
#pragma once

#include "gnuplot.h"
#include "rows.h"

namespace report {

/// Error against time by effort, a line a scene: of the same figures as effort_table, and in its file.
Sheet effort_sheet(const Rows& rows);

}  // namespace report
