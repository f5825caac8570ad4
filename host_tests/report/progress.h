// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <cstdio>
#include <string>

namespace report {

/// One line on the terminal for the whole run; on anything but a terminal a line for each suite.
class Progress {
public:
    explicit Progress(int tasks) : tasks_(tasks), live_(isatty(STDERR_FILENO) != 0) {}

    void begin(const std::string& what) {
        if (live_) {
            const int filled = tasks_ > 0 ? 30 * done_ / tasks_ : 0;
            std::fprintf(stderr, "\r[%s%s] %3d %%  %-44.44s", std::string(static_cast<std::size_t>(filled), '#').c_str(),
                         std::string(static_cast<std::size_t>(30 - filled), '.').c_str(), tasks_ > 0 ? 100 * done_ / tasks_ : 0,
                         what.c_str());
        } else if (what.substr(0, what.find(' ')) != suite_) {
            suite_ = what.substr(0, what.find(' '));
            std::fprintf(stderr, "%s\n", suite_.c_str());
        }
        ++done_;
    }
    ~Progress() {
        if (live_) std::fprintf(stderr, "\r%88s\r", "");
    }

private:
    int tasks_, done_ = 0;
    bool live_;
    std::string suite_;
};

}  // namespace report
