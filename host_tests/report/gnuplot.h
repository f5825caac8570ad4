// SPDX-License-Identifier: MIT
// A sheet of lines, drawn by gnuplot as SVG that can stand in a page with others.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace report {

struct Line {
    std::string title, color;
    std::vector<std::pair<double, double>> points;
    enum class Look { plain, band, dashed } look = Look::plain;  ///< band: wide and pale, drawn below the others
};

struct Sheet {
    std::string name;                ///< of the file, without .svg
    std::string title, how_to_read;  ///< for the page, not drawn
    std::string x_label, y_label;
    std::vector<Line> lines;
    std::string more = "";  ///< further gnuplot commands

    /// The line of that title, begun where there is none.
    Line& line(const std::string& title, const std::string& color);
    /// Adds a point unless a logarithmic axis has no room for it.
    static void add_point(Line& line, double x, double y);
};

bool can_draw();
/// Writes DIR/NAME.svg and returns its <svg> element, with names of its own; empty if gnuplot is missing or fails.
std::string draw(const Sheet& sheet, const std::string& dir);

}  // namespace report
