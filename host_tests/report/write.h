// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "rows.h"
#include "settings.h"

namespace report {

struct Plot {
    std::string name;     ///< NAME.svg
    std::string title, how_to_read;
    std::string svg;      ///< empty: gnuplot is not there
};

/// report.csv: all rows. Values are printed so that they read back as the same number.
void write_csv(const Rows& rows, const std::string& dir);
/// report.md: the tables that answer the questions people ask first.
void write_md(const Rows& rows, const std::string& dir);
/// index.html: the same with the plots, in one file that needs nothing else.
void write_html(const Rows& rows, const std::vector<Plot>& plots, const std::string& dir);
/// Draws the plots with gnuplot.
std::vector<Plot> draw_plots(const Rows& rows, const std::string& dir);

/// A table of text; the first row names the columns.
struct Table {
    std::string title, note;
    std::vector<std::vector<std::string>> cells;
};
std::vector<Table> summary_tables(const Rows& rows);
std::string machine_line();

std::string csv_cell(const std::string& text);
std::string html_text(const std::string& text);

}  // namespace report
