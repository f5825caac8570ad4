// SPDX-License-Identifier: MIT
#include "rows.h"

#include <algorithm>

namespace report {

double Rows::value(const std::string& suite, const std::string& case_name, const std::string& method, const std::string& scalar,
                   int lanes, double h, const std::string& metric, double missing) const {
    for (const Row& row : rows_)
        if (row.suite == suite && row.case_name == case_name && row.method == method && row.scalar == scalar &&
            (lanes == 0 || row.lanes == lanes) && (h == 0 || row.h == h) && row.metric == metric)
            return row.value;
    return missing;
}

std::vector<std::string> names_of(const Rows& rows, const std::string& suite, std::string Row::*column) {
    std::vector<std::string> names;
    for (const Row& row : rows.all())
        if (row.suite == suite && std::find(names.begin(), names.end(), row.*column) == names.end())
            names.push_back(row.*column);
    return names;
}

}  // namespace report
