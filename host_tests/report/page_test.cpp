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
