// SPDX-License-Identifier: MIT
// ingot_replay <recording> <recording>: the first step at which two machines part, and body and number where states were kept.
// Ends with 0 if they do not part, 1 if they do, 2 if a file is no recording.
#include <fstream>
#include <iostream>
#include <iterator>

#include "replay/report_divergence.h"

namespace {

bool read_file(const char* path, replay::Recording& recording) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        std::cerr << path << ": cannot be read\n";
        return false;
    }
    const std::vector<uint8_t> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::string error = replay::read_recording(bytes, recording);
    if (!error.empty()) std::cerr << path << ": " << error << '\n';
    return error.empty();
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "usage: ingot_replay <recording> <recording>\n";
        return 2;
    }
    replay::Recording a, b;
    if (!read_file(argv[1], a) || !read_file(argv[2], b)) return 2;
    return replay::report_divergence(a, b, std::cout) ? 1 : 0;
}
