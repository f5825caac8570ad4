// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace report {

struct Settings {
    std::string out = ".";
    bool quick = false;               ///< fewer cases and steps, every page and plot all the same
    std::vector<std::string> suites;  ///< empty: all
    bool wants(const std::string& suite) const;
};

inline const std::vector<std::string>& known_suites() {
    static const std::vector<std::string> names = {"rotation", "driven", "drift", "throughput", "contact", "effort", "simbenchmark", "levels",
                                                   "control", "mcu", "peers"};
    return names;
}

/// Reads the command line. Returns false, and has said why on stderr, for one that makes no sense.
bool read_arguments(int count, char** arguments, Settings& settings);

}  // namespace report
