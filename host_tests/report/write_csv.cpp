// SPDX-License-Identifier: MIT
#include <cstdio>
#include <fstream>

#include "write.h"

namespace report {

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

namespace {

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

}  // namespace

void write_csv(const Rows& rows, const std::string& dir) {
    std::ofstream file(dir + "/report.csv");
    file << "suite,case,method,scalar,lanes,target,h,metric,value,unit\n";
    for (const Row& row : rows.all())
        file << csv_cell(row.suite) << ',' << csv_cell(row.case_name) << ',' << csv_cell(row.method) << ',' << row.scalar << ','
             << row.lanes << ',' << row.target << ',' << number(row.h) << ',' << row.metric << ',' << number(row.value) << ','
             << row.unit << '\n';
}

}  // namespace report
