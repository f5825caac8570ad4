// SPDX-License-Identifier: MIT
// The cases of the tables in host_tests/reference/, by their names, with the rates they are flown at.
#pragma once

#include <string>
#include <vector>

#include "reference/driven_body_table.h"

namespace report {

struct FreeCase {
    std::string name;
    bool symmetric;
    std::vector<int> rates;  ///< steps a second, ascending; six of them
    ingot_reference::FreeBodyCase body;
    double spin_max;  ///< rad/s, over the samples
    double duration;  ///< s
};

std::vector<FreeCase> free_cases();
std::vector<std::string> top_names();
std::vector<std::string> driven_names();

}  // namespace report
