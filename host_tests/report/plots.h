// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "rows.h"

namespace report {

struct Plot {
    std::string name;  ///< NAME.svg
    std::string title, how_to_read;
    std::string svg;  ///< empty: gnuplot is not there
};

/// False: gnuplot is missing, and plots stay empty.
bool can_draw_plots();
/// Draws what the rows hold with gnuplot, into dir and into memory.
std::vector<Plot> draw_plots(const Rows& rows, const std::string& dir);

}  // namespace report
