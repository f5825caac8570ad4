// SPDX-License-Identifier: MIT
// The committed tables of what is counted on cores: flops.csv, methods.csv, and the budgets of the scenes.
#pragma once

#include <string>
#include <vector>

namespace report {

/// Operations on floating-point numbers of one whole public step, mean; see firmware/measure_methods.py.
struct FlopCount {
    std::string method, scalar;
    int rate;  ///< steps a second
    double adds, muls, divs, roots;
    double all() const { return adds + muls + divs + roots; }
};
std::vector<FlopCount> read_flops();

}  // namespace report
