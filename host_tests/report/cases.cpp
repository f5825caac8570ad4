// SPDX-License-Identifier: MIT
#include "cases.h"

#include <algorithm>
#include <cmath>

namespace report {

using ingot_reference::CsvTable;
using ingot_reference::FreeBodyCase;

namespace {

std::vector<std::string> names_in(const std::string& params_file) {
    const CsvTable params(params_file);
    std::vector<std::string> names;
    for (std::size_t row = 0; row < params.row_count(); ++row) names.push_back(params.text(row, "case"));
    return names;
}

/// 15 Hz and its multiples; multiples of 16 Hz where samples lie between whole seconds.
std::vector<int> rates_for(const FreeBodyCase& body) {
    for (const FreeBodyCase::Sample& sample : body.samples)
        if (sample.t != std::floor(sample.t)) return {16, 32, 64, 128, 256, 1024};
    return {15, 30, 60, 120, 240, 960};
}

double spin_of(const FreeBodyCase& body) {
    double spin = 0;
    for (const FreeBodyCase::Sample& sample : body.samples) spin = std::max(spin, static_cast<double>(sample.w_body.norm()));
    return spin;
}

}  // namespace

std::vector<FreeCase> free_cases() {
    std::vector<FreeCase> cases;
    for (const bool symmetric : {false, true}) {
        const std::string table = symmetric ? "free_symmetric" : "free_asymmetric";
        for (const std::string& name : names_in(table + "_params.csv")) {
            const FreeBodyCase body(table, name);
            cases.push_back(
                {name, symmetric, rates_for(body), body, spin_of(body), static_cast<double>(body.samples.back().t)});
        }
    }
    return cases;
}

std::vector<std::string> top_names() { return names_in("top_params.csv"); }
std::vector<std::string> driven_names() { return names_in("driven_params.csv"); }

}  // namespace report
