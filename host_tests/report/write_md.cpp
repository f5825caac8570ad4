// SPDX-License-Identifier: MIT
#include <fstream>

#include "write.h"

namespace report {

std::string md_cell(const std::string& text) {
    std::string safe;
    for (const char c : text) safe += c == '|' ? std::string("\\|") : c == '\n' ? std::string(" ") : std::string(1, c);
    return safe;
}

namespace {

void write_table(std::ofstream& file, const Table& table, const char* heading) {
    if (!table.title.empty()) file << "\n" << heading << table.title << "\n";
    if (!table.note.empty()) file << "\n" << table.note << "\n";
    file << "\n";
    for (std::size_t line = 0; line < table.cells.size(); ++line) {
        for (const std::string& cell : table.cells[line]) file << "| " << md_cell(cell) << " ";
        file << "|\n";
        if (line > 0) continue;
        for (std::size_t column = 0; column < table.cells[0].size(); ++column) file << (column == 0 ? "|---" : "|---:");
        file << "|\n";
    }
}

}  // namespace

void write_md(const Page& page, const std::string& dir) {
    std::ofstream file(dir + "/report.md");
    file << "# ingot: speed against error\n\n" << page.machine << "\n";
    for (const Headline& headline : page.headlines)
        file << "\n* **" << headline.figure << " " << headline.unit << "** " << headline.meaning;
    file << "\n";
    write_table(file, page.choice, "## ");
    write_table(file, claims_table(page.claims), "## ");
    for (const Section& section : page.sections) {
        file << "\n## " << section.title << "\n";
        for (const std::string& paragraph : section.paragraphs) file << "\n" << paragraph << "\n";
        for (const Plot& plot : section.plots)
            if (!plot.svg.empty()) file << "\n![" << plot.title << "](" << plot.name << ".svg)\n\n" << plot.how_to_read << "\n";
        for (const Table& table : section.tables) write_table(file, table, "### ");
    }
}

}  // namespace report
