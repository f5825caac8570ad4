// SPDX-License-Identifier: MIT
// What a reader is told of a method besides its figures.
#pragma once

#include <string>
#include <vector>

namespace report {

struct MethodInfo {
    std::string name;      ///< as in report.csv
    std::string type;      ///< what a scene writes: using rotation = ingot::<type>
    std::string sentence;  ///< what it is
};

/// In the order of methods.def, then the schemes for force fields and the peers.
const std::vector<MethodInfo>& method_infos();

/// The same colour for a method on every plot; #rrggbb.
std::string color_of(const std::string& method);

}  // namespace report
