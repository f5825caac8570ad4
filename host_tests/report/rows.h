// SPDX-License-Identifier: MIT
// What the report measures: one number a row. No type of the kernel appears here: every build of it fills the same table.
#pragma once

#include <string>
#include <vector>

namespace report {

/// One line of report.csv.
struct Row {
    std::string suite, case_name, method, scalar;
    int lanes = 0;
    std::string target;  ///< where it was measured: host, cortex-m0, cortex-m4f, cortex-m7; any: counted, the same on all
    double h = 0;        ///< s; 0 where no step is meant
    std::string metric;
    double value = 0;
    std::string unit;
};

class Rows {
public:
    void add(Row row) { rows_.push_back(std::move(row)); }
    const std::vector<Row>& all() const { return rows_; }

    /// The value of the first row that agrees in everything given; `missing` if there is none. lanes 0 and h 0 agree with all.
    double value(const std::string& suite, const std::string& case_name, const std::string& method, const std::string& scalar,
                 int lanes, double h, const std::string& metric, double missing) const;

private:
    std::vector<Row> rows_;
};

/// What stands in a column of a suite, each once, in the order in which it came.
std::vector<std::string> names_of(const Rows& rows, const std::string& suite, std::string Row::*column);

}  // namespace report
