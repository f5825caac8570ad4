// SPDX-License-Identifier: MIT
// What the report says, in the order in which it says it; write_html.cpp and write_md.cpp only set it down.
//
// Texts hold `code` between backquotes and **words** in bold, and nothing else of markup.
#pragma once

#include <string>
#include <vector>

#include "claims.h"
#include "plots.h"
#include "rows.h"
#include "settings.h"

namespace report {

/// A table of text; the first row names the columns.
struct Table {
    std::string title, note;
    std::vector<std::vector<std::string>> cells;
    std::string look = "";  ///< class of the HTML table: words (two columns of text), engines (grouped by the first column)
    bool has_figures() const;  ///< any cell but those of the first row and column is filled
};

/// One figure to be read from afar.
struct Headline {
    std::string figure, unit, meaning;
};

struct Section {
    std::string id, title;
    std::vector<std::string> paragraphs;
    std::vector<Plot> plots;
    std::vector<Table> tables;
};

struct Page {
    std::string machine;
    std::vector<Headline> headlines;
    Table choice;
    std::vector<Claim> claims;
    std::vector<Section> sections;
    bool drawn = true;  ///< false: there was no gnuplot
};

Page page_of(const Rows& rows, const std::vector<Plot>& plots, const Settings& settings);

/// "4.5e-6"; empty for NaN, "lost" for infinity.
std::string error_text(double value);
/// printf's format; empty for NaN.
std::string number_text(double value, const char* format);

Table claims_table(const std::vector<Claim>& claims);

// Tables of one suite each.
Table choice_table(const Rows& rows);
Table methods_table(const Rows& rows, const std::string& scalar);
Table cases_table(const Rows& rows);
Table hour_table(const Rows& rows);
Table driven_table(const Rows& rows, const std::string& scalar);
Table throughput_table(const Rows& rows);
Table cores_table(const Rows& rows);
Table simbenchmark_table(const Rows& rows);
Table seams_table(const Rows& rows);   ///< levels: bodies over ground that is cut up
Table ground_table(const Rows& rows);  ///< levels: bytes and times
Table walkers_table(const Rows& rows);
Table servos_table(const Rows& rows);  ///< control: what a servo does with a step of its target
Table arm_table(const Rows& rows);  ///< control: by computed torques, and by servos
std::vector<Table> contact_tables(const Rows& rows);  ///< one for each kind of scene
Table scenes_table(const Rows& rows);
Table peers_table(const Rows& rows);
Table effort_table(const Rows& rows);  ///< of contacts, by Scene::effort
Table shares_table(const Rows& rows);  ///< the kernel's times as shares of those of other engines, and errors beside them
Table names_table();

}  // namespace report
