// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "page.h"
#include "rows.h"

namespace report {

/// report.csv: all rows. Values are printed so that they read back as the same number.
void write_csv(const Rows& rows, const std::string& dir);
/// report.md: the page without its plots.
void write_md(const Page& page, const std::string& dir);
/// index.html: the page with its plots, in one file that needs nothing else.
void write_html(const Page& page, const std::string& dir);

/// A cell of a comma-separated table, quoted where it must be (RFC 4180).
std::string csv_cell(const std::string& text);
/// Text for HTML: what would be markup is escaped, `code` and **bold** become tags.
std::string html_text(const std::string& text);
/// Text for a cell of a Markdown table.
std::string md_cell(const std::string& text);

}  // namespace report
