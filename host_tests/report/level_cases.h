// SPDX-License-Identifier: MIT
// Bodies over ground of triangles: what is asked of one build of the kernel. No type of it shows, so one program holds two.
#pragma once

#include <string>
#include <vector>

namespace report {

/// One body over one ground at one rate, beside the same over a half space; the worst of several speeds, sizes and cuts.
struct OverGround {
    std::string ground, body;
    double rate = 0;
    double way = 0;      ///< by how much its path is longer or shorter, a share of it
    double speed = 0;    ///< by how much its velocity is off at the end, a share of it
    double hop = 0;      ///< m, higher or lower than there
    double impulse = 0;  ///< by how much the sum of what contacts gave is off, a share of it
};

/// A number of one ground.
struct OfGround {
    std::string ground, metric;
    double value = 0;
    std::string unit;
};

struct LevelFigures {
    std::string scalar;
    int lanes = 0;
    std::vector<OverGround> over;
    std::vector<OfGround> of;
};

// Of the builds of float and double with four lanes. draws: of each ground, body and rate; repeats: of what is timed, of which the least counts.
LevelFigures level_figures_of_float(int draws, int repeats);
LevelFigures level_figures_of_double(int draws, int repeats);

/// Steps a second.
inline constexpr int level_rates[] = {30, 60, 240, 1000};

}  // namespace report
