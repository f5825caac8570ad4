// SPDX-License-Identifier: MIT
// On the host: a line a scene, with the hash after 60, 120 and 600 steps of 1/60 s, and of each of the 600 the last digit.
#include <cstdio>

#include "viewer.h"

int main() {
    for (int scene_i = 0; scene_i < viewer_scene_count(); ++scene_i) {
        if (viewer_open(0, scene_i, viewer_kind_of(scene_i)) == 0) return 1;
        std::printf("%s", viewer_scene_text(scene_i, 0));
        char digits[601] = {};
        for (int step_i = 1; step_i <= 600; ++step_i) {
            if (viewer_step(0, 1.0f / 60) != 0) return 1;
            const unsigned long long hash = viewer_hash(0);
            digits[step_i - 1] = "0123456789abcdef"[hash & 15];
            if (step_i == 60 || step_i == 120 || step_i == 600) std::printf(" %016llx", hash);
        }
        std::printf(" %s\n", digits);
        std::fflush(stdout);
    }
    return 0;
}
