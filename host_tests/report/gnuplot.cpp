// SPDX-License-Identifier: MIT
#include "gnuplot.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace report {

Line& Sheet::line(const std::string& line_title, const std::string& color) {
    for (Line& known : lines)
        if (known.title == line_title) return known;
    lines.push_back({line_title, color, {}, Line::Look::plain});
    return lines.back();
}

void Sheet::add_point(Line& line, double x, double y) {
    if (x > 0 && y > 0 && std::isfinite(x) && std::isfinite(y)) line.points.emplace_back(x, y);
}

bool can_draw() { return !std::string(INGOT_GNUPLOT).empty() && std::system(INGOT_GNUPLOT " --version > /dev/null 2>&1") == 0; }

namespace {

std::string svg_of(const std::string& path) {
    std::ifstream file(path);
    std::stringstream all;
    all << file.rdbuf();
    const std::string text = all.str();
    const std::size_t begin = text.find("<svg");
    return begin == std::string::npos ? "" : text.substr(begin);
}

/// Names inside an SVG are global once it stands in a page with others: every id, and every reference to one, gets a prefix.
std::string with_own_names(const std::string& svg, const std::string& prefix) {
    std::string named;
    for (std::size_t i = 0; i < svg.size();) {
        bool marked = false;
        for (const char* mark : {" id=\"", " id='", "href='#", "href=\"#", "url(#"}) {
            const std::string text = mark;
            if (svg.compare(i, text.size(), text) != 0) continue;
            named += text + prefix + "_";
            i += text.size();
            marked = true;
            break;
        }
        if (!marked) named += svg[i++];
    }
    return named;
}

void write_script(const Sheet& sheet, const std::string& script, const std::string& svg) {
    std::ofstream file(script);
    file << "set terminal svg size 690,480 font 'DejaVu Sans,14' background 'white'\n"
         << "set output '" << svg << "'\n"
         << "set rmargin 26\n"
         << "set key at graph 1.03, graph 1.0 left top Left reverse noenhanced samplen 1.6 spacing 1.15 font ',12'\n"
         << "set grid lc rgb '#e3e8ef' lt 1 lw 1\nset border 3 lc rgb '#566273'\nset tics nomirror\n"
         << "set logscale xy\nset format x '10^{%L}'\nset format y '10^{%L}'\nset mxtics 1\nset mytics 1\n"
         << "set xlabel '" << sheet.x_label << "'\nset ylabel '" << sheet.y_label << "' offset 1,0\n"
         << sheet.more << "\n";
    for (std::size_t i = 0; i < sheet.lines.size(); ++i) {
        file << "$data" << i << " << EOD\n";
        for (const auto& point : sheet.lines[i].points) file << point.first << ' ' << point.second << '\n';
        file << "EOD\n";
    }
    for (std::size_t i = 0; i < sheet.lines.size(); ++i) {
        const Line& line = sheet.lines[i];
        const bool band = line.look == Line::Look::band;
        file << (i == 0 ? "plot " : ", ") << "$data" << i << " using 1:2 with linespoints lw " << (band ? 9 : 1.9)
             << " pt 7 ps " << (band ? 0.0 : 0.5) << (line.look == Line::Look::dashed ? " dt 2" : "") << " lc rgb '"
             << (band ? "#55" + line.color.substr(1) + "'" : line.color + "'") << " title '" << line.title << "'";
    }
    file << "\n";
}

}  // namespace

std::string draw(const Sheet& sheet, const std::string& dir) {
    const std::string script = dir + "/" + sheet.name + ".gp", svg = dir + "/" + sheet.name + ".svg";
    write_script(sheet, script, svg);
    const bool drawn = std::system((INGOT_GNUPLOT " '" + script + "'").c_str()) == 0;
    std::remove(script.c_str());
    return drawn ? with_own_names(svg_of(svg), sheet.name) : "";
}

}  // namespace report
