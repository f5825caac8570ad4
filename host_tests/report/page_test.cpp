// SPDX-License-Identifier: MIT
// What sets the report down: quoting, escaping, numbers, claims, and a page of few rows.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "report/gnuplot.h"
#include "report/write.h"

namespace {

using namespace report;

/// A reader of comma-separated lines, written from RFC 4180.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
            cells.back() += line[++i];
        else if (line[i] == '"')
            quoted = !quoted;
        else if (line[i] == ',' && !quoted)
            cells.emplace_back();
        else
            cells.back() += line[i];
    }
    return cells;
}

std::string text_of(const std::string& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

class Folder {
public:
    Folder() : path_(std::filesystem::temp_directory_path() / ("report_page_test_" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

TEST(CsvCell, is_quoted_only_where_it_must_be) {
    EXPECT_EQ(csv_cell("book"), "book");
    EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
    EXPECT_EQ(csv_cell("5\" pipe"), "\"5\"\" pipe\"");
    for (const char* text : {"book", "a,b", "5\" pipe", "\"", ",", ""}) EXPECT_EQ(cells_of(csv_cell(text))[0], text);
}

TEST(HtmlText, escapes_what_would_be_markup) {
    EXPECT_EQ(html_text("a < b & c > \"d\""), "a &lt; b &amp; c &gt; &quot;d&quot;");
    EXPECT_EQ(html_text("`Splitting<6>` is **fast**"), "<code>Splitting&lt;6&gt;</code> is <b>fast</b>");
    EXPECT_EQ(html_text("`a**b`"), "<code>a**b</code>");
    EXPECT_EQ(html_text("never `closed"), "never <code>closed</code>");
}

TEST(MdCell, cannot_end_its_cell) { EXPECT_EQ(md_cell("|A^T A - 1|"), "\\|A^T A - 1\\|"); }

TEST(ErrorText, is_short_and_tells_what_is_missing) {
    EXPECT_EQ(error_text(4.5e-6), "4.5e-6");
    EXPECT_EQ(error_text(1.25e12), "1.2e12");
    EXPECT_EQ(error_text(2.5), "2.5");
    EXPECT_EQ(error_text(0), "0");
    EXPECT_EQ(error_text(std::nan("")), "");
    EXPECT_EQ(error_text(std::numeric_limits<double>::infinity()), "lost");
}

TEST(ReportCsv, gives_back_every_row_to_the_last_digit) {
    Rows rows;
    rows.add({"rotation", "a, \"b\"", "default", "float", 4, "host", 1.0 / 60, "attitude_error", 0.1, "rad"});
    const Folder folder;
    write_csv(rows, folder.path());
    std::ifstream file(folder.path() + "/report.csv");
    std::string line;
    ASSERT_TRUE(std::getline(file, line));
    EXPECT_EQ(line, "suite,case,method,scalar,lanes,target,h,metric,value,unit");
    ASSERT_TRUE(std::getline(file, line));
    const std::vector<std::string> cells = cells_of(line);
    ASSERT_EQ(cells.size(), 10u);
    EXPECT_EQ(cells[1], "a, \"b\"");
    EXPECT_EQ(cells[4], "4");
    EXPECT_EQ(std::strtod(cells[6].c_str(), nullptr), 1.0 / 60);
    EXPECT_EQ(std::strtod(cells[8].c_str(), nullptr), 0.1);
    EXPECT_FALSE(std::getline(file, line));
}

TEST(Claims, are_silent_where_nothing_was_measured) {
    for (const Claim& claim : claims({})) EXPECT_FALSE(claim.is_measured()) << claim.what;
    EXPECT_EQ(claims_table(claims({})).cells.size(), 1u);
}

TEST(Claims, tell_what_was_missed) {
    Rows rows;
    for (const int rate : {15, 60})
        rows.add({"rotation", "book", "default", "double", 1, "host", 1.0 / rate, "attitude_error", rate == 15 ? 1e-13 : 1e-3,
                  "rad"});
    const Table table = claims_table(claims(rows));
    ASSERT_EQ(table.cells.size(), 2u);
    EXPECT_EQ(table.cells[1][1], "1.0e-3 rad");  // the worse of the two
    EXPECT_EQ(table.cells[1][3], "missed");
}

TEST(Page, of_no_rows_is_written_all_the_same) {
    const Folder folder;
    const Page page = page_of({}, {}, {});
    write_md(page, folder.path());
    write_html(page, folder.path());
    EXPECT_NE(text_of(folder.path() + "/report.md").find("# ingot"), std::string::npos);
    const std::string html = text_of(folder.path() + "/index.html");
    EXPECT_NE(html.find("</html>"), std::string::npos);
    EXPECT_EQ(html.find("nan"), std::string::npos);
}

TEST(Page, without_gnuplot_says_so) {
    Page page = page_of({}, {}, {});
    page.drawn = false;
    const Folder folder;
    write_html(page, folder.path());
    EXPECT_NE(text_of(folder.path() + "/index.html").find("gnuplot was not found"), std::string::npos);
}

/// What a contact scene leaves behind, of an engine.
void add_tower(Rows& rows, const char* suite, const char* method, int lanes, double stood, double us) {
    const auto add = [&](const char* metric, double value, const char* unit) {
        rows.add({suite, "tower_20", method, "float", lanes, "host", 1.0 / 60, metric, value, unit});
    };
    add("stood", stood, "s");
    add("sink", 0.03125, "mm");
    add("seconds", 60, "s");
    add("us_per_step", us, "us");
}

/// The cell of a line below a title.
std::string cell_of(const Table& table, std::size_t line, const std::string& title) {
    for (std::size_t column = 0; column < table.cells[0].size(); ++column)
        if (table.cells[0][column].rfind(title, 0) == 0) return table.cells[line][column];
    return "no column " + title;
}

TEST(ContactTables, have_a_line_for_each_engine_that_ran_the_scene) {
    Rows rows;
    add_tower(rows, "contact", "default", 1, 60, 20);
    rows.add({"contact", "tower_20", "default", "float", 4, "host", 1.0 / 60, "us_per_step", 30, "us"});
    add_tower(rows, "peers", "bullet", 1, 2.5, 40);
    const std::vector<Table> tables = contact_tables(rows);
    const Table& towers = tables[1];
    ASSERT_EQ(towers.cells.size(), 3u);
    EXPECT_EQ(cell_of(towers, 1, "scene"), "20 cubes");
    EXPECT_EQ(cell_of(towers, 1, "engine"), "ingot, float");
    EXPECT_EQ(cell_of(towers, 1, "top sinks"), "0.0312");
    EXPECT_EQ(cell_of(towers, 1, "µs per step"), "20.0 / 30.0");
    EXPECT_EQ(cell_of(towers, 2, "scene"), "");
    EXPECT_EQ(cell_of(towers, 2, "stood"), "2.5");
    EXPECT_EQ(cell_of(towers, 2, "top sinks"), "fell");               // where the top of a fallen tower lies tells nothing
    EXPECT_EQ(cell_of(towers, 1, "residual"), "no column residual");  // nothing to show
    EXPECT_FALSE(tables[0].has_figures());
}

TEST(ContactTables, take_times_from_the_race_with_the_peers) {
    Rows rows;
    add_tower(rows, "contact", "default", 4, 60, 20);
    rows.add({"peers", "tower_20", "default", "float", 4, "host", 1.0 / 60, "us_per_step", 25, "us"});
    EXPECT_EQ(cell_of(contact_tables(rows)[1], 1, "µs per step"), "25.0");
}

TEST(SharesTable, has_columns_for_the_engines_that_ran_and_lines_for_the_scenes_they_ran) {
    Rows rows;
    EXPECT_FALSE(shares_table(rows).has_figures());
    add_tower(rows, "peers", "default", 4, 60, 0.004);
    EXPECT_FALSE(shares_table(rows).has_figures()) << "nobody was beside";
    add_tower(rows, "peers", "box3d", 1, 60, 106);
    add_tower(rows, "peers", "bullet", 1, 2.5, 40);
    rows.add({"peers", "tower_20", "default", "float", 4, "host", 1.0 / 60, "time_ratio_to_box3d", 0.5, "1"});
    rows.add({"peers", "tower_20", "default", "float", 4, "host", 1.0 / 60, "time_ratio_to_bullet", 0.25, "1"});
    const Table table = shares_table(rows);
    ASSERT_EQ(table.cells.size(), 2u);
    EXPECT_EQ(table.cells[0], (std::vector<std::string>{"scene", "4 lanes by Box3D", "4 lanes by Bullet", "8 lanes by Box3D", "8 lanes by Bullet",
                                                        "what is wrong", "ingot", "Box3D", "Bullet"}));
    EXPECT_EQ(table.cells[1], (std::vector<std::string>{"tower of 20 cubes", "0.50", "fell", "", "", "stood, s / top sinks, mm", "60 / 0.0312",
                                                        "60 / 0.0312", "2.5 / fell"}));
}

TEST(ContactClaims, count_what_was_lost_and_what_differs_between_lanes) {
    Rows rows;
    for (const int lanes : {1, 4})
        for (const char* metric : {"lost", "frozen"})
            rows.add({"contact", "pit_125", "default", "float", lanes, "host", 1.0 / 60, metric, lanes == 4 ? 3.0 : 0.0, "1"});
    const Table table = claims_table(contact_claims(rows));
    ASSERT_EQ(table.cells.size(), 3u);
    EXPECT_EQ(table.cells[1][1], "6");
    EXPECT_EQ(table.cells[2][1], "2");
    EXPECT_EQ(table.cells[2][3], "missed");
}

TEST(Contact, scenes_with_frozen_bodies_have_failed_whatever_they_showed_until_then) {
    Rows rows;
    for (const auto& [metric, value] : {std::pair<const char*, double>{"frozen", 2}, {"energy_gain", 1e-9}, {"seconds", 1.3}})
        rows.add({"contact", "pit_125", "default", "float", 4, "host", 1.0 / 60, metric, value, "1"});
    EXPECT_EQ(cell_of(contact_tables(rows)[2], 1, "largest energy gain"), "froze");
    EXPECT_EQ(cell_of(contact_tables(rows)[2], 1, "frozen"), "2");
    for (const Claim& claim : contact_claims(rows)) {
        if (claim.what.find("energy gain of a step") == std::string::npos) continue;
        EXPECT_FALSE(claim.holds());
    }
}

TEST(Html, sets_the_kernel_apart_among_peers_only) {
    Page page = page_of({}, {}, {});
    Table table{"Towers", "", {{"scene", "engine", "sinks"}, {"20", "ingot, float", "0.03"}}, "engines"};
    page.sections.push_back({"contact", "Contact", {}, {}, {table}});
    const Folder folder;
    write_html(page, folder.path());
    EXPECT_EQ(text_of(folder.path() + "/index.html").find("<tr class=\"group own\">"), std::string::npos);
    table.cells.push_back({"", "Bullet, float", "89"});
    page.sections.back().tables[0] = table;
    write_html(page, folder.path());
    EXPECT_NE(text_of(folder.path() + "/index.html").find("<tr class=\"group own\">"), std::string::npos);
}

TEST(Drawing, has_names_of_its_own) {
    if (!can_draw()) GTEST_SKIP() << "gnuplot is not installed";
    Sheet sheet;
    sheet.name = "drawn";
    sheet.x_label = sheet.y_label = "1";
    for (const double x : {1.0, 10.0, 100.0}) Sheet::add_point(sheet.line("squares", "#e63946"), x, x * x);
    Sheet::add_point(sheet.line("squares", "#e63946"), 1000, 0);  // has no place on a logarithmic axis
    EXPECT_EQ(sheet.lines[0].points.size(), 3u);
    const Folder folder;
    const std::string svg = draw(sheet, folder.path());
    ASSERT_EQ(svg.rfind("<svg", 0), 0u);
    for (std::size_t at = 0; (at = svg.find(" id=", at)) != std::string::npos; ++at) EXPECT_EQ(svg.substr(at + 5, 6), "drawn_");
    for (std::size_t at = 0; (at = svg.find("href=", at)) != std::string::npos; ++at)
        EXPECT_EQ(svg.substr(at + 7, 6), "drawn_");
}

}  // namespace
