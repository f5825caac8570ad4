// SPDX-License-Identifier: MIT
// Contact scenes at several efforts: see Scene::effort.
#pragma once

#include <string>

#include "contact_case.h"

namespace report {

struct EffortLevel {
    int substeps, sweeps;
    const char* name;  ///< as a scene writes it
};

/// From the least to the most.
inline constexpr EffortLevel effort_levels[] = {{2, 3, "low_effort"}, {4, 3, "{4, 3}, the default"}, {8, 3, "{8, 3}"}, {8, 6, "high_effort"}};

/// Its name in the rows of the report.
inline std::string method_of(const EffortLevel& level) { return std::to_string(level.substeps) + "x" + std::to_string(level.sweeps); }

struct EffortCase {
    ContactCase scene;
    bool in_quick_runs;
    std::vector<std::function<std::unique_ptr<ContactRun>()>> begins;  ///< one for each of effort_levels
};

std::vector<EffortCase> effort_cases();

}  // namespace report
