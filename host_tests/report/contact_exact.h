// SPDX-License-Identifier: MIT
// The first step of a contact scene, solved exactly by host_tests/reference/.
#pragma once

#include <string>

namespace report {

struct ExactStep {
    bool known = false;   ///< the scene is one of those whose exact solution is looked for, and it was found
    double distance = 0;  ///< m/s, of its velocities from rest
    double us = 0;        ///< CPU time of finding it
};

/// For scenes that stand still from the first step on.
ExactStep exact_first_step(const std::string& scene);

}  // namespace report
