// SPDX-License-Identifier: MIT
#include <fstream>

#include "write.h"

namespace report {

std::string html_text(const std::string& text) {
    std::string html;
    bool code = false, bold = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '&')
            html += "&amp;";
        else if (c == '<')
            html += "&lt;";
        else if (c == '>')
            html += "&gt;";
        else if (c == '"')
            html += "&quot;";
        else if (c == '\'')
            html += "&#39;";
        else if (c == '`')
            html += (code = !code) ? "<code>" : "</code>";
        else if (!code && text.compare(i, 2, "**") == 0)
            html += (bold = !bold) ? "<b>" : "</b>", ++i;
        else
            html += c;
    }
    return html + (code ? "</code>" : "") + (bold ? "</b>" : "");
}

namespace {

const char* const style = R"(
:root { --ink: #1c2530; --soft: #566273; --line: #e3e8ef; --paper: #fff; --tint: #f6f8fb; --red: #e63946; }
* { box-sizing: border-box; }
body { font: 16px/1.55 system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; color: var(--ink); background: var(--paper);
       max-width: 76rem; margin: 0 auto; padding: 2.5rem 1.5rem 5rem; }
h1 { font-size: 2.3rem; line-height: 1.15; margin: 0 0 .4rem; letter-spacing: -.02em; }
h2 { font-size: 1.5rem; margin: 3.2rem 0 .6rem; padding-top: .8rem; border-top: 2px solid var(--ink); }
h3 { font-size: 1.05rem; margin: 2rem 0 .3rem; }
p { max-width: 52rem; margin: .5rem 0; } .lead { font-size: 1.15rem; } .soft, figcaption { color: var(--soft); }
.small { font-size: .87rem; }
code { font: .9em ui-monospace, "DejaVu Sans Mono", monospace; background: var(--tint); padding: .05em .3em; border-radius: 3px; }
nav { margin: 1.2rem 0 0; font-size: .95rem; display: flex; flex-wrap: wrap; gap: .2rem 1.1rem; } a { color: #17569b; }
.cards { display: grid; grid-template-columns: repeat(auto-fit, minmax(14rem, 1fr)); gap: 1rem; margin: 1.6rem 0; }
.card { border: 1px solid var(--line); border-left: 4px solid var(--red); border-radius: 6px; padding: .8rem 1rem; }
.card b { font-size: 1.75rem; letter-spacing: -.01em; }
.card span { color: var(--soft); } .card div { font-size: .9rem; color: var(--soft); line-height: 1.35; }
.scroll { overflow-x: auto; margin: .7rem 0; }
table { border-collapse: collapse; font-size: .84rem; font-variant-numeric: tabular-nums; }
th, td { padding: .28rem .55rem; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap; }
th { background: var(--tint); font-weight: 600; vertical-align: bottom; white-space: normal; line-height: 1.25; }
th:first-child, td:first-child { text-align: left; }
table.words th:nth-child(2), table.words td:nth-child(2), table.words th:nth-child(3), table.words td:nth-child(3) { text-align: left; }
table.choice th:nth-child(2), table.choice td:nth-child(2) { text-align: left; }
table.engines th:nth-child(2), table.engines td:nth-child(2) { text-align: left; } table.engines tr.group td { border-top: 2px solid #b8c2cf; }
table.engines tr.group td:first-child { font-weight: 600; } table.engines tr.own td { background: #fdecee; }
tr.default td { background: #fdecee; font-weight: 600; } td.met { color: #1a7f4b; font-weight: 600; } td.missed { color: #b3261e; font-weight: 600; }
.plots { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 34rem), 1fr)); gap: 1.4rem; margin: 1.2rem 0; }
figure { margin: 0; } figure h3 { margin-top: 0; }
figure svg { width: 100%; height: auto; display: block; border: 1px solid var(--line); border-radius: 6px; }
figcaption { font-size: .9rem; margin-top: .4rem; max-width: 52rem; }
details { margin: 1rem 0; } summary { cursor: pointer; font-weight: 600; }
@media print { details { display: block; } nav { display: none; } }
)";

/// What makes a line stand out: the default method, the first of a group, the kernel among its peers.
std::string row_class(const Table& table, std::size_t line) {
    const std::vector<std::string>& cells = table.cells[line];
    if (cells[0] == "default") return "default";
    if (table.look != "engines" || line == 0) return "";
    bool among_peers = false;
    for (std::size_t i = 1; i < table.cells.size(); ++i) among_peers = among_peers || table.cells[i][1].rfind("ingot", 0) != 0;
    const bool own = among_peers && cells[1].rfind("ingot", 0) == 0;
    return std::string(cells[0].empty() ? "" : "group ") + (own ? "own" : "");
}

void write_cells(std::ofstream& file, const Table& table, const char* table_class) {
    file << "<div class=scroll><table class=\"" << table_class << "\">\n";
    for (std::size_t line = 0; line < table.cells.size(); ++line) {
        const char* const tag = line == 0 ? "th" : "td";
        const std::string look = row_class(table, line);
        file << (look.empty() ? "<tr>" : "<tr class=\"" + look + "\">");
        for (const std::string& cell : table.cells[line]) {
            const bool verdict = cell == "met" || cell == "missed";
            file << '<' << tag << (verdict ? " class=" + cell : "") << '>' << html_text(cell) << "</" << tag << '>';
        }
        file << "</tr>\n";
    }
    file << "</table></div>\n";
}

void write_table(std::ofstream& file, const Table& table, const char* heading, const char* table_class = "") {
    if (!table.title.empty()) file << '<' << heading << '>' << html_text(table.title) << "</" << heading << ">\n";
    if (!table.note.empty()) file << "<p class=\"soft small\">" << html_text(table.note) << "</p>\n";
    write_cells(file, table, table_class);
}

void write_section(std::ofstream& file, const Section& section) {
    file << "<section id=" << section.id << "><h2>" << html_text(section.title) << "</h2>\n";
    for (const std::string& paragraph : section.paragraphs) file << "<p>" << html_text(paragraph) << "</p>\n";
    file << "<div class=plots>\n";
    for (const Plot& plot : section.plots)
        if (!plot.svg.empty())
            file << "<figure><h3>" << html_text(plot.title) << "</h3>\n"
                 << plot.svg << "\n<figcaption>" << html_text(plot.how_to_read) << "</figcaption></figure>\n";
    file << "</div>\n";
    for (const Table& table : section.tables) write_table(file, table, "h3", table.look.c_str());
    file << "</section>\n";
}

}  // namespace

void write_html(const Page& page, const std::string& dir) {
    std::ofstream file(dir + "/index.html");
    file << "<!doctype html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport "
            "content=\"width=device-width\"><title>ingot: speed against error</title>\n"
         << "<style>" << style << "</style></head><body>\n<h1>Speed against error</h1>\n"
         << "<p class=lead>ingot moves rigid bodies on consoles and microcontrollers. This page shows what each of its methods "
            "costs and how wrong it is, all measured by one program in one run.</p>\n"
         << "<div class=cards>\n";
    for (const Headline& headline : page.headlines)
        file << "<div class=card><b>" << html_text(headline.figure) << "</b> <span>" << html_text(headline.unit)
             << "</span><div>" << html_text(headline.meaning) << "</div></div>\n";
    file << "</div>\n<p class=\"soft small\">" << html_text(page.machine)
         << " All numbers are in <code>report.csv</code>.</p>\n<nav><a href=#choose>What to choose</a><a href=#claims>What it "
            "reaches</a>";
    for (const Section& section : page.sections) file << "<a href=#" << section.id << '>' << html_text(section.title) << "</a>";
    file << "</nav>\n<section id=choose>\n";
    write_table(file, page.choice, "h2", "choice");
    file << "<p>For force fields name the field and, if the default is not accurate enough, a scheme of order 4: "
            "<code>BlanesMoan4</code> where the field does not look at velocity, "
            "<code>CommutatorFree4</code> where it does. See <a href=#driven>Force fields</a>.</p>\n</section>\n";
    if (!page.drawn)
        file << "<p><b>gnuplot was not found when this page was written: there are tables, and no plots.</b></p>\n";
    const Table reached = claims_table(page.claims);
    if (reached.cells.size() > 1) {
        file << "<section id=claims>\n";
        write_table(file, reached, "h2");
        file << "</section>\n";
    }
    for (const Section& section : page.sections) write_section(file, section);
    file << "</body></html>\n";
}

}  // namespace report
