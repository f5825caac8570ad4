// SPDX-License-Identifier: MIT
// Figures under control: what is asked of one build of the kernel. No type of it shows, so one program holds two.
#pragma once

#include <string>
#include <vector>

namespace report {

/// A number of one machine at one rate.
struct OfMachine {
    std::string machine;
    double rate = 0;
    std::string metric;
    double value = 0;
    std::string unit;
};

struct ControlFigures {
    std::string scalar;
    int lanes = 0;
    std::vector<OfMachine> of;
};

// Of the builds of float and double with four lanes. seconds: for which walkers walk; paths: that the arm follows.
ControlFigures control_figures_of_float(double seconds, int paths);
ControlFigures control_figures_of_double(double seconds, int paths);

}  // namespace report
