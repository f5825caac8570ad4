// SPDX-License-Identifier: MIT
#include <fstream>

#include "write.h"

namespace report {

std::string html_text(const std::string& text) {
    std::string safe;
    for (char c : text) {
        if (c == '&') safe += "&amp;";
        else if (c == '<') safe += "&lt;";
        else if (c == '>') safe += "&gt;";
        else if (c == '"') safe += "&quot;";
        else safe += c;
    }
    return safe;
}

namespace {

const char* const style = R"(
body { font: 16px/1.5 system-ui, sans-serif; color: #1d2430; max-width: 68rem; margin: 2rem auto; padding: 0 1rem; background: #fff; }
h1 { font-size: 2rem; margin-bottom: .2rem; } h2 { font-size: 1.25rem; margin-top: 2.5rem; }
p.note, figcaption { color: #465063; max-width: 56rem; } p.machine { color: #6a7386; font-size: .9rem; }
table { border-collapse: collapse; font-size: .88rem; font-variant-numeric: tabular-nums; display: block; overflow-x: auto; }
th, td { padding: .28rem .7rem; text-align: right; border-bottom: 1px solid #e4e8ef; white-space: nowrap; }
th { background: #f3f5f9; } th:first-child, td:first-child { text-align: left; }
tr.default td { background: #fdf3dc; font-weight: 600; }
figure { margin: 1.5rem 0; } figure svg { width: 100%; height: auto; border: 1px solid #e4e8ef; border-radius: 6px; }
nav a { margin-right: 1rem; } ul.choose li { margin: .3rem 0; })";

void write_table(std::ofstream& file, const Table& table) {
    file << "<h2>" << html_text(table.title) << "</h2>\n<p class=note>" << html_text(table.note) << "</p>\n<table>\n";
    for (std::size_t line = 0; line < table.cells.size(); ++line) {
        const char* const tag = line == 0 ? "th" : "td";
        file << (table.cells[line][0] == "default" ? "<tr class=default>" : "<tr>");
        for (const std::string& cell : table.cells[line]) file << '<' << tag << '>' << html_text(cell) << "</" << tag << '>';
        file << "</tr>\n";
    }
    file << "</table>\n";
}

}  // namespace

void write_html(const Rows& rows, const std::vector<Plot>& plots, const std::string& dir) {
    std::ofstream file(dir + "/index.html");
    file << "<!doctype html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport content=\"width=device-width\"><title>ingot: speed against error</title>\n"
         << "<style>" << style << "</style></head><body>\n<h1>ingot: speed against error</h1>\n"
         << "<p>What each method of the kernel costs and how wrong it is, measured by one program in one run. All numbers are in <code>report.csv</code>.</p>\n"
         << "<p class=machine>" << html_text(machine_line()) << "</p>\n"
         << "<h2>What to choose</h2>\n<ul class=choose>\n"
         << "<li><b>Nothing.</b> The default, a preprocessed discrete Moser-Veselov method, is the most accurate free rotation here at about the cost of a "
            "second-order method; 15 Hz are enough for it.</li>\n"
         << "<li>A small microcontroller: <code>DiscreteMoserVeselov&lt;4, false, false, 1&gt;</code> leaves out what the default spends on the last two digits.</li>\n"
         << "<li>Balls, or bodies with two equal moments, and nothing else: <code>SymmetricTop</code>, the closed form.</li>\n"
         << "<li>Bodies in a force field: name the field. <code>KickDriftKick</code> is the default; <code>BlanesMoan4</code> is a million times more accurate for six "
            "times the cost where the field does not depend on velocity, <code>CommutatorFree4</code> where it does.</li>\n"
         << "<li><code>Listing1Euler</code> is the algorithm as the article printed it: the baseline.</li>\n</ul>\n";
    for (const Plot& plot : plots) {
        if (plot.svg.empty()) continue;
        file << "<figure><h2>" << html_text(plot.title) << "</h2>\n" << plot.svg << "\n<figcaption>" << html_text(plot.how_to_read) << "</figcaption></figure>\n";
    }
    if (plots.empty() || plots[0].svg.empty()) file << "<p class=note>gnuplot was not found when this page was written: there are tables only.</p>\n";
    for (const Table& table : summary_tables(rows)) write_table(file, table);
    file << "</body></html>\n";
}

}  // namespace report
