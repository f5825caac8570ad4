// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <cstdio>

namespace demo {

/// A line on the terminal that fills while a scene runs; on anything but a terminal it stays silent.
class Progress {
public:
    Progress(const char* title, int steps) : title_(title), steps_(steps), live_(isatty(STDERR_FILENO) != 0) {}

    void at(int step_i) {
        const int percent = static_cast<int>(100LL * step_i / steps_);
        if (!live_ || percent == percent_) return;
        percent_ = percent;
        char bar[31];
        for (int cell_i = 0; cell_i < 30; ++cell_i) bar[cell_i] = cell_i * 100 < percent * 30 ? '#' : '.';
        bar[30] = '\0';
        std::fprintf(stderr, "\r  %-34s [%s] %3d %%", title_, bar, percent);
    }

    ~Progress() {
        if (live_) std::fprintf(stderr, "\r%60s\r", "");
    }

private:
    const char* title_;
    int steps_;
    bool live_;
    int percent_ = -1;
};

}  // namespace demo
